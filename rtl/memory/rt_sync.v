// rt_sync.v - bits of another clock, through two flip-flops
// SPDX-License-Identifier: Apache-2.0
// q_o is d_i two edges of clk later, or three if d_i changed with the edge. Bits that change
// together may arrive in different clocks: a word must be Gray code, or stand still.
// d_i must come from a flip-flop. No reset: q_o is what d_i was.
`timescale 1ns / 1ps
`default_nettype none
module rt_sync #(
    parameter WIDTH = 1                   // bits
) (
    input  wire             clk,
    input  wire [WIDTH-1:0] d_i,          // of another clock
    output reg  [WIDTH-1:0] q_o
);
    (* async_reg = "true" *) reg [WIDTH-1:0] meta_q;
    always @(posedge clk) begin
        meta_q <= d_i;
        q_o    <= meta_q;
    end
endmodule
`default_nettype wire
