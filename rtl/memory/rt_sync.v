// rt_sync.v - bits of another clock, through two flip-flops
// SPDX-License-Identifier: Apache-2.0
// q_o is d_i two edges of clk later, or three if d_i changed with the edge. Bits that change
// together may arrive in different clocks: a word must be Gray code, or stand still.
// d_i must come from a flip-flop. No reset: q_o is what d_i was.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_memory.vh"
module rt_sync #(
    parameter WIDTH = 1                   // bits
) (
    input  wire             clk,
    input  wire [WIDTH-1:0] d_i,          // of another clock
    output wire [WIDTH-1:0] q_o
);
    `RT_SYNC_FLOPS reg [WIDTH-1:0] meta_q;
    `RT_SYNC_FLOPS reg [WIDTH-1:0] settled_q;
    always @(posedge clk) begin
        meta_q    <= d_i;
        settled_q <= meta_q;
    end
    assign q_o = settled_q;
endmodule
`default_nettype wire
