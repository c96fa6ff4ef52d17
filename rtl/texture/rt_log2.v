// rt_log2.v - logarithm to base 2 by leading zeros and a table
// SPDX-License-Identifier: Apache-2.0
// x is rounded half up to nine significant bits, 2^e * 1.f; log2 = e + table[f], of x > 0.
//   1 shift by 16 and 8 | 2 by 4, 2 and 1, round | 3 table
// Free-running, latency 3. Model: sph_log2() in cmodel/texture/lod.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
module rt_log2 #(
    parameter XB = 24                 // argument, bits: 10 to 32
) (
    input  wire          clk,
    input  wire [XB-1:0] in_x_i,
    output wire [13:0]   out_log2_o   // u6.8; of 0 anything
);
    `RT_CHECK(XB >= 10 && XB <= 32, rt_log2_XB_must_be_10_to_32)
    localparam TOP = XB - 1;          // e of the largest argument

    // ---- stage 1: the first one among the top 8 bits; what comes behind 17 cannot matter ----
    wire [39:0] n_0  = {in_x_i, {(40-XB){1'b0}}};
    wire        h_16 = n_0[39:24] == 16'd0;
    wire [39:0] n_16 = h_16 ? n_0 << 16 : n_0;
    wire        h_8  = n_16[39:32] == 8'd0;
    reg  [16:0] s1_n_q;
    reg         s1_h_16_q, s1_h_8_q;
    always @(posedge clk) begin
        s1_n_q    <= h_8 ? n_16[31:15] : n_16[39:23];
        s1_h_16_q <= h_16;
        s1_h_8_q  <= h_8;
    end

    // ---- stage 2: the first one on top, nine bits and a carry ----
    wire        h_4 = s1_n_q[16:13] == 4'd0;
    wire [16:0] n_4 = h_4 ? s1_n_q << 4 : s1_n_q;
    wire        h_2 = n_4[16:15] == 2'd0;
    wire [16:0] n_2 = h_2 ? n_4 << 2 : n_4;
    wire        h_1 = !n_2[16];
    wire [16:0] n_1 = h_1 ? n_2 << 1 : n_2;
    wire [9:0]  nine = {1'b0, n_1[16:8]} + {9'd0, n_1[7]};
    reg  [7:0]  s2_f_q;
    reg  [5:0]  s2_e_q;
    always @(posedge clk) begin
        s2_f_q <= nine[7:0];
        s2_e_q <= TOP[5:0] - {1'b0, s1_h_16_q, s1_h_8_q, h_4, h_2, h_1} + {5'd0, nine[9]};
    end

    // ---- stage 3: table ----
    wire [7:0]  fraction;
    reg  [5:0]  s3_e_q;
    rt_log2_rom u_rom (.clk(clk), .index_i(s2_f_q), .log2_q(fraction));
    always @(posedge clk) s3_e_q <= s2_e_q;
    assign out_log2_o = {s3_e_q, fraction};

    wire unused = &{1'b0, n_16[22:0], n_1[6:0], nine[8]};
endmodule
`default_nettype wire
