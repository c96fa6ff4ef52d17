// f_facet_products.v - stand for rt_multiply, rt_product in proofs of rt_facet_sums: one facet's
// SPDX-License-Identifier: Apache-2.0
// Factors of the facet that is taken in the first clock come in clocks 1 to 4 at most; those of its
// dot products from its normal on. Products of other clocks are anything. As late as those modules.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_fx.vh"
module rt_multiply #(
    parameter W = 17
) (
    input  wire                  clk,
    input  wire                  in_valid_i,
    input  wire signed [W-1:0]   a_i,
    input  wire signed [W-1:0]   b_i,
    output wire signed [2*W-1:0] p_o
);
    localparam L = `RT_MUL_LATENCY(W);
    reg  [3:0]            age_q = 4'd0;
    reg  [2*W*L-1:0]      p_q;
    wire signed [2*W-1:0] p = a_i * b_i;
    (* anyseq *) wire [2*W-1:0] any;
    wire [2*W*(L+1)-1:0]  p_d = {p_q, age_q >= 1 && age_q <= 4 ? p : any};
    always @(posedge clk) begin
        if (age_q != 4'd15) age_q <= age_q + 4'd1;
        p_q <= p_d[2*W*L-1:0];
    end
    assign p_o = p_q[2*W*L-1 -: 2*W];
endmodule
module rt_product #(
    parameter AW = 34,
    parameter BW = 17
) (
    input  wire                    clk,
    input  wire signed [AW-1:0]    a_i,
    input  wire signed [BW-1:0]    b_i,
    output wire signed [AW+BW-1:0] p_o
);
    localparam L = `RT_PRODUCT_LATENCY(AW), P = AW + BW;
    localparam [3:0] FIRST = `RT_MUL_LATENCY(BW) + 3;
    reg  [3:0]            age_q = 4'd0;
    reg  [P*L-1:0]        p_q;
    wire signed [P-1:0]   p = a_i * b_i;
    (* anyseq *) wire [P-1:0] any;
    wire [P*(L+1)-1:0]    p_d = {p_q, age_q >= FIRST && age_q <= FIRST + 4'd4 ? p : any};
    always @(posedge clk) begin
        if (age_q != 4'd15) age_q <= age_q + 4'd1;
        p_q <= p_d[P*L-1:0];
    end
    assign p_o = p_q[P*L-1 -: P];
endmodule
`default_nettype wire
