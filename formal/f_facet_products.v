// f_facet_products.v - stand for rt_multiply, rt_product in proofs of rt_facet_sums: one facet's
// SPDX-License-Identifier: Apache-2.0
// Factors of the facet that is taken in the first clock come in clocks 1 and 2; those of its dot
// products in clocks 4 and 5. Products of other clocks are anything. As late as those modules.
`timescale 1ns / 1ps
`default_nettype none
module rt_multiply #(
    parameter W = 17                     // up to 18
) (
    input  wire                  clk,
    input  wire signed [W-1:0]   a_i,
    input  wire signed [W-1:0]   b_i,
    output reg signed [2*W-1:0]  p_o
);
    reg  [3:0]            age_q = 4'd0;
    wire signed [2*W-1:0] p = a_i * b_i;
    (* anyseq *) wire [2*W-1:0] any;
    always @(posedge clk) begin
        if (age_q != 4'd15) age_q <= age_q + 4'd1;
        p_o <= age_q == 1 || age_q == 2 ? p : any;
    end
endmodule
module rt_product #(
    parameter AW = 34,                   // up to 35
    parameter BW = 17                    // up to 18
) (
    input  wire                    clk,
    input  wire signed [AW-1:0]    a_i,
    input  wire signed [BW-1:0]    b_i,
    output reg signed [AW+BW-1:0]  p_o
);
    reg  [3:0]              age_q = 4'd0;
    reg  [AW+BW-1:0]        p_q;
    wire signed [AW+BW-1:0] p = a_i * b_i;
    (* anyseq *) wire [AW+BW-1:0] any;
    always @(posedge clk) begin
        if (age_q != 4'd15) age_q <= age_q + 4'd1;
        p_q <= age_q == 4 || age_q == 5 ? p : any;
        p_o <= p_q;
    end
endmodule
`default_nettype wire
