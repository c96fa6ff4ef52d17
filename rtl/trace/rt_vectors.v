// rt_vectors.v - chooses the vector that rt_setup takes next
// SPDX-License-Identifier: Apache-2.0
// Surface normals go first, then lights, then mirrored directions, and new primary rays last: what
// is nearest to its end goes first. The first three always find room (token rule): queues hold
// their slots, block RAM the vectors. For a source that is not built there is neither.
// There is no model of it: the order of vectors changes no result.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_bundles.vh"
module rt_vectors #(
    parameter WD      = 17,  // direction component, bits
    parameter NORMALS = 1,   // 1: surface normals come
    parameter LIGHTS  = 1,   // 1: vectors to lights come
    parameter BOUNCES = 1,   // 1: mirrored directions come
    parameter SLOTS   = 32   // power of two
) (
    input  wire                       clk,
    input  wire                       rst,
    // sources of vectors
    input  wire [`RT_VECTOR_BITS-1:0] normal_i,
    input  wire [`RT_VECTOR_BITS-1:0] light_i,
    input  wire [`RT_VECTOR_BITS-1:0] bounce_i,
    input  wire [`RT_VECTOR_BITS-1:0] primary_i,
    output wire                       primary_ready_o,
    // the vector chosen
    output reg                        out_valid_o,
    input  wire                       out_ready_i,
    output wire                       out_normal_o,  // its kind; none of the three: primary
    output wire                       out_light_o,
    output wire                       out_bounce_o,
    output reg [$clog2(SLOTS)-1:0]    out_slot_o,
    output wire [3*WD-1:0]            out_vec_o
);
    localparam SLOTW = $clog2(SLOTS);
    localparam [2:0] BUILT = {BOUNCES != 0, LIGHTS != 0, NORMALS != 0};  // bit 0 goes first
    wire [2:0]         in_valid = {bounce_i[`RT_VECTOR_VALID], light_i[`RT_VECTOR_VALID],
                                   normal_i[`RT_VECTOR_VALID]};
    wire [3*SLOTW-1:0] in_slot  = {bounce_i[`RT_VECTOR_SLOT], light_i[`RT_VECTOR_SLOT],
                                   normal_i[`RT_VECTOR_SLOT]};
    wire [9*WD-1:0]    in_vec   = {bounce_i[`RT_VECTOR_VEC], light_i[`RT_VECTOR_VEC],
                                   normal_i[`RT_VECTOR_VEC]};

    // ---- choose ----
    wire               load = !out_valid_o || out_ready_i;
    wire [2:0]         valid, room;
    wire [2:0]         take = valid & (~valid + 3'd1) & {3{load}};
    wire [3*SLOTW-1:0] slot;
    wire [9*WD-1:0]    vec;
    assign primary_ready_o = load && valid == 3'd0;
    genvar s;
    generate
        for (s = 0; s < 3; s = s + 1) begin : g_source
            if (BUILT[s]) begin : g_on
                rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_queue (
                    .clk(clk), .rst(rst), .in_valid_i(in_valid[s]), .in_ready_o(room[s]),
                    .in_data_i(in_slot[SLOTW*s +: SLOTW]),
                    .out_valid_o(valid[s]), .out_ready_i(take[s]),
                    .out_data_o(slot[SLOTW*s +: SLOTW])
                );
                rt_slot_ram #(.WIDTH(3*WD), .SLOTS(SLOTS), .OLD(0)) u_vec (
                    .clk(clk), .wr_en_i(in_valid[s]), .wr_addr_i(in_slot[SLOTW*s +: SLOTW]),
                    .wr_data_i(in_vec[3*WD*s +: 3*WD]),
                    .rd_en_i(take[s]), .rd_addr_i(slot[SLOTW*s +: SLOTW]),
                    .rd_data_o(vec[3*WD*s +: 3*WD])
                );
            end else begin : g_off
                assign {valid[s], room[s]} = 2'b00;
                assign slot[SLOTW*s +: SLOTW] = {SLOTW{1'b0}};
                assign vec[3*WD*s +: 3*WD]    = {3*WD{1'b0}};
            end
        end
    endgenerate

    // ---- the vector, from where it was read ----
    reg [2:0]          from_q;              // one-hot; none: primary
    reg [3*WD-1:0]     primary_q;
    always @(posedge clk) begin
        if (load) begin
            out_valid_o <= valid != 3'd0 || primary_i[`RT_VECTOR_VALID];
            from_q      <= take;
            out_slot_o  <= take[0] ? slot[0 +: SLOTW] : take[1] ? slot[SLOTW +: SLOTW]
                           : take[2] ? slot[2*SLOTW +: SLOTW] : primary_i[`RT_VECTOR_SLOT];
            primary_q   <= primary_i[`RT_VECTOR_VEC];
        end
        if (rst) out_valid_o <= 1'b0;
    end
    assign {out_bounce_o, out_light_o, out_normal_o} = from_q;
    assign out_vec_o = from_q[0] ? vec[0 +: 3*WD] : from_q[1] ? vec[3*WD +: 3*WD]
                       : from_q[2] ? vec[6*WD +: 3*WD] : primary_q;
    wire unused = &{1'b0, room, in_valid, in_slot, in_vec};
endmodule
`default_nettype wire
