// rt_square.v - square of a small unsigned number without a multiplier
// SPDX-License-Identifier: Apache-2.0
//   r^2 = sum over i of r[i] * 4^i * (1 + 4 * (r >> (i+1))): each pair of bits is met once, so the
//   rows are half as long as those of a product. Added in pairs: 14 rows, 7, 4, 2, 1.
// Latency 4 cycles, one a cycle. Model: child->rad * child->rad in cmodel/trace/filter.c
`timescale 1ns / 1ps
`default_nettype none
module rt_square (
    input  wire        clk,
    input  wire [13:0] in_i,
    output reg  [27:0] out_q   // in_i^2
);
    // ---- rows: {r[13:i+1], 0, 1} * 4^i where r[i] is set ----
    wire [27:0] row [0:13];
    genvar i;
    generate
        for (i = 0; i < 14; i = i + 1) begin : g_row
            wire [14:0] above = {1'b0, in_i} >> (i + 1);
            assign row[i] = in_i[i] ? {11'd0, above, 2'b01} << (2*i) : 28'd0;
        end
    endgenerate

    // ---- stages 1 to 4: pairs ----
    reg [27:0] s1_0_q, s1_1_q, s1_2_q, s1_3_q, s1_4_q, s1_5_q, s1_6_q;
    reg [27:0] s2_0_q, s2_1_q, s2_2_q, s2_3_q, s3_0_q, s3_1_q;
    always @(posedge clk) begin
        s1_0_q <= row[0] + row[1];
        s1_1_q <= row[2] + row[3];
        s1_2_q <= row[4] + row[5];
        s1_3_q <= row[6] + row[7];
        s1_4_q <= row[8] + row[9];
        s1_5_q <= row[10] + row[11];
        s1_6_q <= row[12] + row[13];
        s2_0_q <= s1_0_q + s1_1_q;
        s2_1_q <= s1_2_q + s1_3_q;
        s2_2_q <= s1_4_q + s1_5_q;
        s2_3_q <= s1_6_q;
        s3_0_q <= s2_0_q + s2_1_q;
        s3_1_q <= s2_2_q + s2_3_q;
        out_q  <= s3_0_q + s3_1_q;
    end
endmodule
`default_nettype wire
