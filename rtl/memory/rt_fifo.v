// rt_fifo.v - first-word fall-through queue in distributed RAM
// SPDX-License-Identifier: Apache-2.0
// The oldest word stands at the output without being asked for. Latency 1 cycle from a push into
// the empty queue to out_valid_o; one push and one pop every cycle. out_valid_o and in_ready_o are
// registers: what waits for them begins there, not at a comparison of pointers.
// In the engine no queue can overflow (token rule, docs/design/overview.md) and in_ready_o
// may stay open; a push while in_ready_o is low is lost and stops a simulation.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
module rt_fifo #(
    parameter WIDTH = 8,   // bits of a word
    parameter DEPTH = 16   // words, a power of two, at least 2
) (
    input  wire             clk,
    input  wire             rst,          // synchronous, active high
    // from the producer
    input  wire             in_valid_i,
    output wire             in_ready_o,   // there is room
    input  wire [WIDTH-1:0] in_data_i,
    // to the consumer
    output wire             out_valid_o,
    input  wire             out_ready_i,
    output wire [WIDTH-1:0] out_data_o
);
    localparam AB = $clog2(DEPTH);        // address bits
    `RT_CHECK(DEPTH >= 2 && DEPTH == (1 << AB), rt_fifo_DEPTH_must_be_a_power_of_two_above_1)

    // ---- pointers: one bit more than the address tells full from empty ----
    reg  [AB:0] wr_q;                     // words pushed, modulo 2 DEPTH
    reg  [AB:0] rd_q;                     // words popped
    reg         some_q, room_q;           // there are words; there is room
    wire        push = in_valid_i && room_q;
    wire        pop  = some_q && out_ready_i;
    wire [AB:0] wr_next = wr_q + 1'b1;
    wire [AB:0] rd_next = rd_q + 1'b1;
    wire        one  = wr_q == rd_next;                        // word is left
    wire        last = wr_next == {~rd_q[AB], rd_q[AB-1:0]};   // place is left
    assign in_ready_o  = room_q;
    assign out_valid_o = some_q;
    always @(posedge clk) begin
        if (push) wr_q <= wr_next;
        if (pop)  rd_q <= rd_next;
        some_q <= push || (some_q && !(pop && one));
        room_q <= pop || (room_q && !(push && last));
        if (rst) begin
            wr_q <= {(AB+1){1'b0}};
            rd_q <= {(AB+1){1'b0}};
            some_q <= 1'b0;
            room_q <= 1'b1;
        end
    end

    // ---- words ----
    rt_slot_file #(.WIDTH(WIDTH), .SLOTS(DEPTH)) u_words (
        .clk(clk),
        .wr_en_i(push), .wr_addr_i(wr_q[AB-1:0]), .wr_data_i(in_data_i),
        .rd_addr_i(rd_q[AB-1:0]), .rd_data_o(out_data_o)
    );

`ifdef FORMAL
    always @(posedge clk) if (!rst) assert (!in_valid_i || in_ready_o);
`else
`ifndef SYNTHESIS
    always @(posedge clk) if (!rst && in_valid_i && !in_ready_o) begin
        $display("%m: push into a full queue of %0d", DEPTH);
        $finish;
    end
`endif
`endif
endmodule
`default_nettype wire
