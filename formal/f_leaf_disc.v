// f_leaf_disc.v - proof that rt_leaf_disc joins the products of its pieces to disc = k*a + b*b
// SPDX-License-Identifier: Apache-2.0
// A number of two pieces is 2^17 x1 + x0, one of three 2^34 x2 + 2^17 x1 + x0, with x0 and the x1
// of three in 0 .. 2^17 - 1. Products of pieces are a function of their factors; that their sum is
// disc shows products.smt2. b, k, a stand for four clocks.
`timescale 1ns / 1ps
`default_nettype none
module f_leaf_disc #(
    parameter W      = 16,
    parameter WD     = 17,
    parameter PIECES = 2,
    parameter T      = PIECES == 2 ? 8 : 9       // clocks until disc; the first is of ready
) (
    input wire              clk,
    input wire              ready,
    input wire [W+WD+1:0]   b,
    input wire [2*W+2:0]    k,
    input wire [2*WD-1:0]   a
);
    localparam DW = 2*W + 2*WD + 2, X = PIECES == 2 ? 76 : 110;
    wire [DW-1:0] disc;
    rt_leaf_disc #(.W(W), .WD(WD)) u_dut (
        .clk(clk), .ready_i(ready), .b_i(b), .k_i(k), .a_i(a), .disc_o(disc)
    );
    function signed [35:0] times(input signed [17:0] x, input signed [17:0] y); times = x * y;
    endfunction
    wire signed [51:0]  b_l = $signed(b), k_l = $signed(k), a_l = {{(52-2*WD){1'b0}}, a};
    wire signed [17:0]  b0 = {1'b0, b_l[16:0]}, k0 = {1'b0, k_l[16:0]}, a0 = {1'b0, a_l[16:0]};
    wire signed [X-1:0] all;
    wire                known;                   // a product of nothing is nothing
    generate
        if (PIECES == 2) begin : g_two
            wire signed [17:0] b1 = b_l[34:17], k1 = k_l[34:17], a1 = a_l[34:17];
            wire signed [35:0] bb0 = times(b0, b0), bb1 = times(b0, b1), bb2 = times(b1, b0),
                               bb3 = times(b1, b1), ka0 = times(k0, a0), ka1 = times(k0, a1),
                               ka2 = times(k1, a0), ka3 = times(k1, a1);
            wire signed [36:0] s0 = bb0 + ka0, s1 = bb1 + ka1, s2 = bb2 + ka2, s3 = bb3 + ka3;
            wire signed [X-1:0] w0 = s0, w1 = s1, w2 = s2, w3 = s3;
            assign all   = w0 + (w1 <<< 17) + (w2 <<< 17) + (w3 <<< 34);
            assign known = 1'b1;
        end else begin : g_three
            wire signed [17:0] b1 = {1'b0, b_l[33:17]}, k1 = {1'b0, k_l[33:17]};
            wire signed [17:0] a1 = {1'b0, a_l[33:17]};
            wire signed [17:0] b2 = b_l[51:34], k2 = k_l[51:34], a2 = a_l[51:34];
            wire signed [35:0] b00 = times(b0, b0), b01 = times(b0, b1), b02 = times(b0, b2),
                               b11 = times(b1, b1), b12 = times(b1, b2), b22 = times(b2, b2),
                               k00 = times(k0, a0), k01 = times(k0, a1), k02 = times(k0, a2),
                               k10 = times(k1, a0), k11 = times(k1, a1), k12 = times(k1, a2),
                               k20 = times(k2, a0), k21 = times(k2, a1), k22 = times(k2, a2);
            // in the order of the steps: what a solver has to see is where bits go
            wire signed [37:0] l0 = b00 + k00, l1 = b01 <<< 1, l2 = (b02 <<< 1) + b11,
                               l3 = b12 <<< 1, h0 = k01 + k10, h1 = k11 + k20 + k02,
                               h2 = k21 + k12, h3 = k22 + b22;
            wire signed [X-1:0] x0 = l0, x1 = l1, x2 = l2, x3 = l3, y0 = h0, y1 = h1, y2 = h2,
                                y3 = h3;
            assign all = (x0 + (y0 <<< 17)) + ((x1 + (y1 <<< 17)) <<< 17) +
                         ((x2 + (y2 <<< 17)) <<< 34) + ((x3 + (y3 <<< 17)) <<< 51);
            (* anyseq *) wire signed [17:0] none;
            wire signed [35:0] product = times(none, a0);
            assign known = none == 0 && product == 0;
        end
    endgenerate
    reg [3:0]          age_q = 4'd0;
    reg [W+WD+1:0]     b_q;
    reg [2*W+2:0]      k_q;
    reg [2*WD-1:0]     a_q;
    reg signed [X-1:0] disc_q;
    always @(posedge clk) begin
        if (age_q != 15) age_q <= age_q + 1'b1;
        {b_q, k_q, a_q} <= {b, k, a};
        if (age_q == 1) disc_q <= all;
    end
    always @* begin
        if (age_q < 5) assume (ready == (age_q == 0));
        if (age_q >= 2 && age_q < 5) assume ({b_q, k_q, a_q} == {b, k, a});
        assume (known);
        if (age_q == T) assert (disc == disc_q[DW-1:0]);
    end
endmodule
`default_nettype wire
