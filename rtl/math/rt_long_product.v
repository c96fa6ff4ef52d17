// rt_long_product.v - product of two long unsigned numbers, 17 bits of one a clock
// SPDX-License-Identifier: Apache-2.0
// p = a * b: a row of 18x18 multipliers makes a times each piece of b, the lowest first.
//   1 operands | 2 products of pieces, those 34 bits apart side by side | 3 row | 4 sum of rows
// A product every ceil(BW/17) clocks; done_o comes that many + 3 after start_i.
// Model: the product itself.
`timescale 1ns / 1ps
`default_nettype none
module rt_long_product #(
    parameter AW = 50,                     // bits of a
    parameter BW = 34                      // bits of b
) (
    input  wire             clk,
    input  wire             rst,           // synchronous, active high
    input  wire             start_i,       // ceil(BW/17) clocks apart or more
    input  wire [AW-1:0]    a_i,           // uAW
    input  wire [BW-1:0]    b_i,           // uBW
    output wire             done_o,        // p_o stands for this clock
    output wire [AW+BW-1:0] p_o            // u(AW+BW)
);
    localparam A = (AW + 16) / 17, B = (BW + 16) / 17;  // pieces
    localparam PW = 17*A + 17;                          // a times a piece

    // ---- stage 1: operands; a piece of b a clock ----
    reg  [17*A-1:0] s1_a_q;
    reg  [17*B-1:0] s1_b_q;
    reg  [B+2:0]    step_q;                // bit k: k+1 clocks after a start
    assign done_o = step_q[B+2];
    always @(posedge clk) begin
        if (start_i) s1_a_q <= {{(17*A-AW){1'b0}}, a_i};
        s1_b_q <= start_i ? {{(17*B-BW){1'b0}}, b_i} : s1_b_q >> 17;
        step_q <= {step_q[B+1:0], start_i};
        if (rst) step_q <= {(B+3){1'b0}};
    end

    // ---- stages 2 and 3: a row, of products at even and at odd pieces ----
    wire [PW:0]  even, odd;                // a bit more, so that either may end it
    reg  [PW-1:0] s3_row_q;
    genvar i;
    generate
        for (i = 0; i < A; i = i + 1) begin : g_piece
            reg [33:0] s2_p_q;
            always @(posedge clk) s2_p_q <= s1_a_q[17*i +: 17] * s1_b_q[16:0];
            if (i % 2 == 0) assign even[17*i +: 34] = s2_p_q;
            else            assign odd[17*i +: 34]  = s2_p_q;
        end
        assign odd[16:0] = 17'd0;
        if (A % 2 == 0) assign even[PW:PW-17] = 18'd0;
        else            assign even[PW] = 1'b0;
        if (A == 1)          assign odd[PW:17] = {(PW-16){1'b0}};
        else if (A % 2 == 1) assign odd[PW:PW-17] = 18'd0;
        else                 assign odd[PW] = 1'b0;
    endgenerate
    always @(posedge clk) s3_row_q <= even[PW-1:0] + odd[PW-1:0];

    // ---- stage 4: rows, each 17 bits above the one before ----
    reg  [PW-1:0]    s4_sum_q;
    reg  [17*B-1:0]  s4_low_q;             // of p, the last piece 17 bits below the top
    wire             first = step_q[2];
    wire [17*B+16:0] low   = {s4_sum_q[16:0], s4_low_q};
    always @(posedge clk) begin
        s4_sum_q <= s3_row_q + (first ? {PW{1'b0}} : s4_sum_q >> 17);
        s4_low_q <= low[17*B+16:17];
    end
    wire [PW+17*B-1:0] all = {s4_sum_q, s4_low_q};
    wire [PW+17*B-18:0] p  = all[PW+17*B-1:17];
    assign p_o = p[AW+BW-1:0];
    wire unused = &{1'b0, all, p, even[PW], odd[PW], low[16:0]};
endmodule
`default_nettype wire
