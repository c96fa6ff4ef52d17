// f_sync.v - stands for rt_sync in proofs: a bit that changes at the edge may be sampled early
// SPDX-License-Identifier: Apache-2.0
// Each bit is taken as it is or as it was a step before, whatever the others do. So a word of which
// two bits change at once is sampled as any mixture, which rt_sync does to it in hardware.
`timescale 1ns / 1ps
`default_nettype none
module rt_sync #(
    parameter WIDTH = 1
) (
    input  wire             clk,
    input  wire [WIDTH-1:0] d_i,
    output reg  [WIDTH-1:0] q_o
);
    (* anyseq *) wire [WIDTH-1:0] late;
    reg [WIDTH-1:0] before_q, meta_q;
    (* gclk *) reg step;                 // ticks with every step
    always @(posedge step) before_q <= d_i;
    always @(posedge clk) begin
        meta_q <= (d_i & ~late) | (before_q & late);
        q_o    <= meta_q;
    end
endmodule
`default_nettype wire
