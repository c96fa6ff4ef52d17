// rt_across_one.v - two axes across a ray, a ray a clock
// SPDX-License-Identifier: Apache-2.0
// The numbers of rt_across, with eight multipliers:
//   1 choose m | 2 u_m^2 | 3 table | 4 slope | 5 r | 6 u_b*r, u_a*r | 7 p | 8 u_m*p, u*p |
//   9 q_a, q_b, sum | 10 q_m
// Latency 10, a ray a clock. Model: sph_across() in cmodel/trace/across.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_fx.vh"
module rt_across_one #(
    parameter TAG = 8                     // what travels along, bits
) (
    input  wire             clk,
    input  wire             rst,
    // a unit vector
    input  wire             in_valid_i,
    input  wire [TAG-1:0]   in_tag_i,
    input  wire [53:0]      in_u_i,       // {z, y, x} s1.16
    input  wire [50:0]      in_mag_i,     // {z, y, x} u1.16, |u|
    // its axes
    output wire             out_valid_o,
    output wire [TAG-1:0]   out_tag_o,
    output reg  [1:0]       out_least_o,  // m
    output reg signed [17:0] out_p_a_o,   // s0.17
    output reg signed [17:0] out_p_b_o,   // s0.17, negated
    output reg  [53:0]      out_q_o       // {z, y, x} s0.17
);
    rt_delay_valid #(.CYCLES(10)) u_valid (
        .clk(clk), .rst(rst), .in_i(in_valid_i), .out_o(out_valid_o)
    );
    rt_delay #(.WIDTH(TAG), .CYCLES(10)) u_tag (
        .clk(clk), .in_i(in_tag_i), .out_o(out_tag_o)
    );

    // ---- stage 1: choose m; {least, u_m, u_b, u_a} goes along ----
    wire [16:0] mag_x = in_mag_i[16:0], mag_y = in_mag_i[33:17], mag_z = in_mag_i[50:34];
    wire [17:0] u_x = in_u_i[17:0], u_y = in_u_i[35:18], u_z = in_u_i[53:36];
    wire [1:0]  least = mag_x <= mag_y && mag_x <= mag_z ? 2'd0 : mag_y <= mag_z ? 2'd1 : 2'd2;
    wire [53:0] chosen = {least == 2'd0 ? u_x : least == 2'd1 ? u_y : u_z,
                          least == 2'd2 ? u_y : u_z, least == 2'd0 ? u_y : u_x};
    wire [16:0] mag = least == 2'd0 ? mag_x : least == 2'd1 ? mag_y : mag_z;
    reg  [15:0] s1_mag_q;                 // u0.16, below 1/sqrt(3) + 2^-16
    reg  [55:0] s1_u_q, s2_u_q, s3_u_q, s4_u_q, s5_u_q, s6_u_q, s7_u_q;
    reg  [1:0]  s8_least_q, s9_least_q;

    // ---- stages 2 to 5: u_m^2, straight line, r ----
    reg  [31:0] s2_square_q;              // u0.32
    wire [17:0] x = ~s2_square_q[31:14];  // u0.18, at least 2^17
    wire [27:0] s3_line_q;
    reg  [9:0]  s3_frac_q;
    reg  [20:0] s4_slope_q;               // u11.10
    reg  [16:0] s4_start_q, s5_r_q;       // u1.16
    rt_rsqrt_rom u_rom (.clk(clk), .index_i({1'b1, x[16:10]}), .line_q(s3_line_q));
    always @(posedge clk) begin
        s1_mag_q <= mag[15:0];
        s1_u_q   <= {least, chosen};
        {s7_u_q, s6_u_q, s5_u_q, s4_u_q, s3_u_q, s2_u_q} <=
            {s6_u_q, s5_u_q, s4_u_q, s3_u_q, s2_u_q, s1_u_q};
        {s9_least_q, s8_least_q} <= {s8_least_q, s7_u_q[55:54]};
        s2_square_q <= s1_mag_q * s1_mag_q;
        s3_frac_q   <= x[9:0];
        s4_slope_q  <= {10'd0, s3_line_q[27:17]} * {11'd0, s3_frac_q};
        s4_start_q  <= s3_line_q[16:0] - 17'd`RT_ACROSS_SHORT;
        s5_r_q      <= s4_start_q - {6'd0, s4_slope_q[20:10]};
    end

    // ---- stages 6 and 7: p ----
    wire signed [17:0] s5_r = {1'b0, s5_r_q}, s5_u_b = s5_u_q[35:18], s5_u_a = s5_u_q[17:0];
    reg  signed [35:0] s6_a_q, s6_b_q;    // s3.32
    wire signed [20:0] s6_p_a = `RT_ROUND(s6_a_q, 35, 15), s6_p_b = `RT_ROUND(s6_b_q, 35, 15);
    reg  signed [17:0] s7_p_a_q, s7_p_b_q, s8_p_a_q, s8_p_b_q, s9_p_a_q, s9_p_b_q;   // s0.17
    always @(posedge clk) begin
        s6_a_q   <= s5_r * s5_u_b;
        s6_b_q   <= s5_r * s5_u_a;
        s7_p_a_q <= s6_p_a[17:0];         // |p| < 1
        s7_p_b_q <= s6_p_b[17:0];
        {s9_p_a_q, s8_p_a_q} <= {s8_p_a_q, s7_p_a_q};
        {s9_p_b_q, s8_p_b_q} <= {s8_p_b_q, s7_p_b_q};
    end

    // ---- stages 8 to 10: q ----
    wire signed [17:0] s7_u_m = s7_u_q[53:36], s7_u_b = s7_u_q[35:18], s7_u_a = s7_u_q[17:0];
    reg  signed [35:0] s8_a_q, s8_b_q, s8_u_b_q, s8_u_a_q, s9_sum_q;                 // s2.33
    wire signed [19:0] s8_q_a = `RT_ROUND(s8_a_q, 35, 16), s8_q_b = `RT_ROUND(s8_b_q, 35, 16);
    wire signed [19:0] s9_q_m = `RT_ROUND(s9_sum_q, 35, 16);
    reg  [17:0]        s9_q_a_q, s9_q_b_q;
    always @(posedge clk) begin
        s8_a_q   <= s7_u_m * s7_p_b_q;
        s8_b_q   <= s7_u_m * s7_p_a_q;
        s8_u_b_q <= s7_u_b * s7_p_a_q;
        s8_u_a_q <= s7_u_a * s7_p_b_q;
        s9_q_a_q <= s8_q_a[17:0];         // |q| < 1
        s9_q_b_q <= s8_q_b[17:0];
        s9_sum_q <= ~s8_u_b_q - s8_u_a_q; // -u_b*p_a - 1 - u_a*p_b
        out_least_o <= s9_least_q;
        out_p_a_o   <= s9_p_a_q;
        out_p_b_o   <= s9_p_b_q;
        out_q_o[17:0]  <= s9_least_q == 2'd0 ? s9_q_m[17:0] : s9_q_a_q;
        out_q_o[35:18] <= s9_least_q == 2'd1 ? s9_q_m[17:0] : s9_least_q == 2'd0 ? s9_q_a_q
                          : s9_q_b_q;
        out_q_o[53:36] <= s9_least_q == 2'd2 ? s9_q_m[17:0] : s9_q_b_q;
    end

    wire unused = &{1'b0, mag[16], x[17], s2_square_q[13:0], s4_slope_q[9:0], s6_p_a[20:18],
                    s6_p_b[20:18], s6_a_q[13:0], s6_b_q[13:0], s8_q_a[19:18], s8_q_b[19:18],
                    s8_a_q[14:0], s8_b_q[14:0], s9_q_m[19:18], s9_sum_q[14:0]};
endmodule
`default_nettype wire
