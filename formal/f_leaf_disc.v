// f_leaf_disc.v - proof that rt_leaf_disc joins the products of its pieces to disc = k*a + b*b
// SPDX-License-Identifier: Apache-2.0
// Widths of two pieces: a number is 2^17 x1 + x0, 0 <= x0 < 2^17. Products of pieces are a function
// of their factors; that their sum is disc shows products.smt2. b, k, a stand for four clocks.
`timescale 1ns / 1ps
`default_nettype none
module f_leaf_disc #(
    parameter W  = 16,
    parameter WD = 17
) (
    input wire              clk,
    input wire              ready,
    input wire [W+WD+1:0]   b,
    input wire [2*W+2:0]    k,
    input wire [2*WD-1:0]   a
);
    localparam DW = 2*W + 2*WD + 2, X = 76;
    wire [DW-1:0] disc;
    rt_leaf_disc #(.W(W), .WD(WD)) u_dut (
        .clk(clk), .ready_i(ready), .b_i(b), .k_i(k), .a_i(a), .disc_o(disc)
    );
    function signed [35:0] times(input signed [17:0] x, input signed [17:0] y); times = x * y;
    endfunction
    wire signed [51:0] b_l = $signed(b), k_l = $signed(k), a_l = {{(52-2*WD){1'b0}}, a};
    wire signed [17:0] b0 = {1'b0, b_l[16:0]}, k0 = {1'b0, k_l[16:0]}, a0 = {1'b0, a_l[16:0]};
    wire signed [17:0] b1 = b_l[34:17], k1 = k_l[34:17], a1 = a_l[34:17];
    wire signed [35:0] bb0 = times(b0, b0), bb1 = times(b0, b1), bb2 = times(b1, b0),
                       bb3 = times(b1, b1), ka0 = times(k0, a0), ka1 = times(k0, a1),
                       ka2 = times(k1, a0), ka3 = times(k1, a1);
    wire signed [36:0] s0 = bb0 + ka0, s1 = bb1 + ka1, s2 = bb2 + ka2, s3 = bb3 + ka3;
    reg [3:0]          age_q = 4'd0;
    reg [W+WD+1:0]     b_q;
    reg [2*W+2:0]      k_q;
    reg [2*WD-1:0]     a_q;
    reg signed [X-1:0] disc_q;
    wire signed [X-1:0] w0 = s0, w1 = s1, w2 = s2, w3 = s3;
    always @(posedge clk) begin
        if (age_q != 15) age_q <= age_q + 1'b1;
        {b_q, k_q, a_q} <= {b, k, a};
        if (age_q == 1) disc_q <= w0 + ((w1 + w2) <<< 17) + (w3 <<< 34);
    end
    always @* begin
        if (age_q < 5) assume (ready == (age_q == 0));
        if (age_q >= 2 && age_q < 5) assume ({b_q, k_q, a_q} == {b, k, a});
        if (age_q == 8) assert (disc == disc_q[DW-1:0]);
    end
endmodule
`default_nettype wire
