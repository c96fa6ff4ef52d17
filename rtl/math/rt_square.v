// rt_square.v - square of a small unsigned number without a multiplier
// SPDX-License-Identifier: Apache-2.0
//   r^2 = sum over i of r[i] * 4^i * (1 + 4 * (r >> (i+1))): each pair of bits is met once, so the
//   rows are half as long as those of a product. Added in pairs: 16 rows, 8, 4, 2, 1.
// Latency 4 cycles, one a cycle. Model: products of equal factors in cmodel/trace/filter.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
module rt_square #(
    parameter BITS = 14               // of the number: 2 to 16
) (
    input  wire              clk,
    input  wire [BITS-1:0]   in_i,
    output reg  [2*BITS-1:0] out_q    // in_i^2
);
    `RT_CHECK(BITS >= 2 && BITS <= 16, rt_square_BITS_must_be_2_to_16)
    localparam W = 2*BITS;

    // ---- rows: {r[BITS-1:i+1], 0, 1} * 4^i where r[i] is set; then pairs in stages 1 to 3 ----
    wire [16*W-1:0] row;
    reg  [8*W-1:0]  s1_q;
    reg  [4*W-1:0]  s2_q;
    reg  [2*W-1:0]  s3_q;
    genvar i;
    generate
        for (i = 0; i < 16; i = i + 1) begin : g_row
            if (i < BITS) begin : g_bit
                wire [W+1:0] above = {{(W-BITS+2){1'b0}}, in_i} >> (i + 1);
                wire [W-1:0] line  = {above[W-3:0], 2'b01};
                assign row[W*i +: W] = in_i[i] ? line << (2*i) : {W{1'b0}};
                wire unused = &{1'b0, above};
            end else begin : g_none
                assign row[W*i +: W] = {W{1'b0}};
            end
        end
        for (i = 0; i < 8; i = i + 1) begin : g_1
            always @(posedge clk) s1_q[W*i +: W] <= row[2*W*i +: W] + row[2*W*i + W +: W];
        end
        for (i = 0; i < 4; i = i + 1) begin : g_2
            always @(posedge clk) s2_q[W*i +: W] <= s1_q[2*W*i +: W] + s1_q[2*W*i + W +: W];
        end
        for (i = 0; i < 2; i = i + 1) begin : g_3
            always @(posedge clk) s3_q[W*i +: W] <= s2_q[2*W*i +: W] + s2_q[2*W*i + W +: W];
        end
    endgenerate
    always @(posedge clk) out_q <= s3_q[W-1:0] + s3_q[2*W-1:W];
endmodule
`default_nettype wire
