// rt_product.v - signed product of two widths from 18x18 multipliers, one a clock
// SPDX-License-Identifier: Apache-2.0
// p = a * b. Operands are cut into chunks of 17 bits, the top one of 18, signed: 2 or 3 of a, 1 or
// 2 of b. Of products 34 bits apart one whose chunks are both unsigned is joined below another:
//   stage 1 products | stages 2.. words added in pairs
// Free-running, latency `RT_PRODUCT_LATENCY(AW): 2 (2 chunks of a), 3 (3). Model: the product.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
`include "rt_fx.vh"
module rt_product #(
    parameter AW = 35,                        // bits of a, 19..52
    parameter BW = 18                         // bits of b, up to 35; above 18 with AW above 35
) (
    input  wire                    clk,
    input  wire signed [AW-1:0]    a_i,       // sAW
    input  wire signed [BW-1:0]    b_i,       // sBW
    output wire signed [AW+BW-1:0] p_o        // s(AW+BW)
);
    localparam CA = `RT_MUL_CHUNKS(AW);
    localparam CB = `RT_MUL_CHUNKS(BW);
    localparam PW = 17*(CA + CB) + 2;         // product of whole chunks
    `RT_CHECK(CA >= 2 && CA <= 3, rt_product_AW_must_be_19_to_52)
    `RT_CHECK(CB == 1 || (CB == 2 && CA == 3),
              rt_product_BW_must_be_at_most_18_or_35_with_AW_above_35)

    // ---- stage 1: products ----
    wire signed [17*CA:0] a = {{(17*CA+1-AW){a_i[AW-1]}}, a_i};
    wire signed [17*CB:0] b = {{(17*CB+1-BW){b_i[BW-1]}}, b_i};
    wire [36*CA*CB-1:0]   s1_p;
    genvar i, j;
    generate
        for (j = 0; j < CB; j = j + 1) begin : g_row
            for (i = 0; i < CA; i = i + 1) begin : g_col
                wire signed [17:0] ca = {i == CA-1 ? a[17*CA] : 1'b0, a[17*i +: 17]};
                wire signed [17:0] cb = {j == CB-1 ? b[17*CB] : 1'b0, b[17*j +: 17]};
                reg signed [35:0] s1_p_q;
                always @(posedge clk) s1_p_q <= ca * cb;
                assign s1_p[36*(CA*j + i) +: 36] = s1_p_q;
            end
        end

        // ---- words, added in pairs ----
        if (CA == 2) begin : g_two
            reg signed [PW-1:0] s2_sum_q;
            always @(posedge clk)
                s2_sum_q <= $signed({{(PW-36){s1_p[35]}}, s1_p[35:0]})
                          + $signed({{(PW-53){s1_p[71]}}, s1_p[71:36], 17'd0});
            assign p_o = s2_sum_q[AW+BW-1:0];
            wire unused = &{1'b0, s2_sum_q};
        end else begin : g_three
            wire signed [PW-1:0] w0, w1, w2, w3;
            if (CB == 1) begin : g_one
                assign w0 = {{(PW-36){s1_p[35]}}, s1_p[35:0]};
                assign w1 = {{(PW-53){s1_p[71]}}, s1_p[71:36], 17'd0};
                assign w2 = {s1_p[36*2 +: 36], 34'd0};
                assign w3 = {PW{1'b0}};
            end else begin : g_both           // a2b0 on a0b0, a2b1 on a1b0, a1b1, a0b1
                assign w0 = {{(PW-70){s1_p[36*2+35]}}, s1_p[36*2 +: 36], s1_p[33:0]};
                assign w1 = {s1_p[36*5 +: 36], s1_p[36 +: 34], 17'd0};
                assign w2 = {{(PW-70){s1_p[36*4+35]}}, s1_p[36*4 +: 36], 34'd0};
                assign w3 = {{(PW-53){s1_p[36*3+35]}}, s1_p[36*3 +: 36], 17'd0};
                wire unused = &{1'b0, s1_p};
            end
            reg signed [PW-1:0] s2_low_q, s2_high_q, s3_sum_q;
            always @(posedge clk) begin
                s2_low_q  <= w0 + w1;
                s2_high_q <= w2 + w3;
                s3_sum_q  <= s2_low_q + s2_high_q;
            end
            assign p_o = s3_sum_q[AW+BW-1:0];
            wire unused = &{1'b0, s3_sum_q};
        end
    endgenerate
endmodule
`default_nettype wire
