// rt_candidates.v - leaf children of a pipe's visits, one after the other
// SPDX-License-Identifier: Apache-2.0
// A queue has the slots of visits, a block RAM what is to be tested of each; of the visit at hand
// the lowest child that is left stands at the output. A candidate a clock; latency 2 clocks.
// There is no model of it: the order of tests changes no result.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_candidates #(
    parameter SLOTS = 32    // power of two
) (
    input  wire                       clk,
    input  wire                       rst,
    input  wire [`RT_VISIT_BITS-1:0]  visit_i,    // from rt_trace
    //: {SLOT[SLOTW], LINE[26], LEAF[4], VALID}
    // a leaf child to test
    output wire                       out_valid_o,
    input  wire                       out_ready_i,
    output wire [$clog2(SLOTS)-1:0]   out_slot_o,
    output wire [1:0]                 out_child_o, // number among the leaf children
    output wire [`RT_LINE_BITS-1:0]   out_line_o  // of leaf child 0
);
    localparam SLOTW = $clog2(SLOTS);
    wire             q_valid, q_in_ready;
    wire [SLOTW-1:0] q_slot;
    reg              v_valid_q, open_q;              // a visit is at hand; todo_q is in use
    reg [SLOTW-1:0]  v_slot_q;
    reg [3:0]        todo_q;                         // left of the visit
    wire [3:0]       v_leaf;
    wire [3:0]       todo = open_q ? todo_q : v_leaf;
    wire [3:0]       rest = todo & (todo - 4'd1);
    wire             take = v_valid_q && out_ready_i;
    wire             v_load = !v_valid_q || (take && rest == 4'd0);
    assign out_valid_o = v_valid_q;
    assign out_slot_o  = v_slot_q;
    assign out_child_o = todo[0] ? 2'd0 : todo[1] ? 2'd1 : todo[2] ? 2'd2 : 2'd3;
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_queue (
        .clk(clk), .rst(rst), .in_valid_i(visit_i[`RT_VISIT_VALID]), .in_ready_o(q_in_ready),
        .in_data_i(visit_i[`RT_VISIT_SLOT]),
        .out_valid_o(q_valid), .out_ready_i(v_load), .out_data_o(q_slot)
    );
    rt_slot_ram #(.WIDTH(4+`RT_LINE_BITS), .SLOTS(SLOTS), .OLD(0)) u_visit (
        .clk(clk), .wr_en_i(visit_i[`RT_VISIT_VALID]), .wr_addr_i(visit_i[`RT_VISIT_SLOT]),
        .wr_data_i({visit_i[`RT_VISIT_LEAF], visit_i[`RT_VISIT_LINE]}),
        .rd_en_i(v_load && q_valid), .rd_addr_i(q_slot), .rd_data_o({v_leaf, out_line_o})
    );
    always @(posedge clk) begin
        if (v_load) begin
            v_valid_q <= q_valid;
            v_slot_q  <= q_slot;
        end
        if (take) begin
            todo_q <= rest;
            open_q <= rest != 4'd0;
        end
        if (rst) begin v_valid_q <= 1'b0; open_q <= 1'b0; end
    end
    wire unused = q_in_ready;
endmodule
`default_nettype wire
