// f_leaf_multiply.v - stands for rt_multiply in proofs of rt_leaf: one leaf's products, as late
// SPDX-License-Identifier: Apache-2.0
// Factors of the leaf that is taken in the first clock come in clocks 1 and 2, those of the wide
// multiplier two clocks behind the sums. Products of other clocks are anything.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_fx.vh"
module rt_multiply #(
    parameter W = 35
) (
    input  wire                  clk,
    input  wire                  in_valid_i,
    input  wire signed [W-1:0]   a_i,
    input  wire signed [W-1:0]   b_i,
    output wire signed [2*W-1:0] p_o
);
    localparam L = `RT_MUL_LATENCY(W);
    localparam [3:0] FIRST = W < 27 ? 1 : W < 37 ? 5 : 7;
    reg  [3:0]            age_q = 4'd0;
    reg  [2*W*L-1:0]      p_q;
    wire signed [2*W-1:0] p = a_i * b_i;
    (* anyseq *) wire [2*W-1:0] any;
    wire                  own = age_q == FIRST || age_q == FIRST + 4'd1;
    wire [2*W*(L+1)-1:0]  p_d = {p_q, own ? p : any};
    always @(posedge clk) begin
        if (age_q != 4'd15) age_q <= age_q + 4'd1;
        p_q <= p_d[2*W*L-1:0];
    end
    assign p_o = p_q[2*W*L-1 -: 2*W];
endmodule
`default_nettype wire
