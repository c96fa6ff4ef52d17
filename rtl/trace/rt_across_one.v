// rt_across_one.v - two axes across a ray, a ray a clock
// SPDX-License-Identifier: Apache-2.0
// The numbers of rt_across, with eight multipliers:
//   1 u_m | 2 u_m^2 | 3 and 4 table | 5 slope | 6 r | 7 u_b*r, u_a*r | 8 p | 9 u_m*p, u*p |
//   10 q_a, q_b, sum | 11 q_m
// A stage without a ray keeps what it has, so that nothing behind it switches.
// Latency 11, a ray a clock.
// Model: sph_across() in cmodel/trace/setup.c
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
    input  wire [53:0]      in_u_i,       // {u_m, u_b, u_a} s1.16
    input  wire [15:0]      in_mag_i,     // |u_m| u0.16, below 1/sqrt(3) + 2^-16
    input  wire [1:0]       in_least_i,   // m
    // its axes
    output wire             out_valid_o,
    output wire [TAG-1:0]   out_tag_o,
    output reg  [1:0]       out_least_o,  // m
    output reg signed [17:0] out_p_a_o,   // s0.17
    output reg signed [17:0] out_p_b_o,   // s0.17, negated
    output reg  [53:0]      out_q_o       // {z, y, x} s0.17
);
    // ---- stages 1 to 10 that hold a ray; tag ----
    reg  [10:1]             live_q;
    rt_stages #(.WIDTH(TAG), .CYCLES(11)) u_tag (
        .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .in_i(in_tag_i),
        .out_valid_o(out_valid_o), .out_o(out_tag_o)
    );
    always @(posedge clk) live_q <= {live_q[9:1], in_valid_i};

    // ---- stage 1: {least, u_m, u_b, u_a}, which goes along ----
    reg  [15:0] s1_mag_q;                 // u0.16
    reg  [55:0] s1_u_q, s2_u_q, s3_u_q, s4_u_q, s5_u_q, s6_u_q, s7_u_q, s8_u_q;
    reg  [1:0]  s9_least_q, s10_least_q;

    // ---- stages 2 to 6: u_m^2, straight line, r; a clock for the way of the table ----
    reg  [31:0] s2_square_q;              // u0.32
    wire [17:0] x = ~s2_square_q[31:14];  // u0.18, at least 2^17
    wire [27:0] s3_line_q;
    reg  [27:0] s4_line_q;
    reg  [9:0]  s3_frac_q, s4_frac_q;
    reg  [20:0] s5_slope_q;               // u11.10
    reg  [16:0] s5_start_q, s6_r_q;       // u1.16
    rt_rsqrt_rom u_rom (.clk(clk), .index_i({1'b1, x[16:10]}), .line_q(s3_line_q));
    always @(posedge clk) begin
        if (in_valid_i) begin
            s1_mag_q <= in_mag_i;
            s1_u_q   <= {in_least_i, in_u_i};
        end
        if (live_q[1]) begin
            s2_u_q      <= s1_u_q;
            s2_square_q <= s1_mag_q * s1_mag_q;
        end
        if (live_q[2]) begin
            s3_u_q      <= s2_u_q;
            s3_frac_q   <= x[9:0];
        end
        if (live_q[3]) begin
            s4_u_q      <= s3_u_q;
            s4_frac_q   <= s3_frac_q;
            s4_line_q   <= s3_line_q;
        end
        if (live_q[4]) begin
            s5_u_q      <= s4_u_q;
            s5_slope_q  <= {10'd0, s4_line_q[27:17]} * {11'd0, s4_frac_q};
            s5_start_q  <= s4_line_q[16:0] - 17'd`RT_ACROSS_SHORT;
        end
        if (live_q[5]) begin
            s6_u_q      <= s5_u_q;
            s6_r_q      <= s5_start_q - {6'd0, s5_slope_q[20:10]};
        end
        if (live_q[6]) s7_u_q <= s6_u_q;
        if (live_q[7]) s8_u_q <= s7_u_q;
    end

    // ---- stages 7 and 8: p ----
    wire signed [17:0] s6_r = {1'b0, s6_r_q}, s6_u_b = s6_u_q[35:18], s6_u_a = s6_u_q[17:0];
    reg  signed [35:0] s7_a_q, s7_b_q;    // s3.32
    wire signed [20:0] s7_p_a = `RT_ROUND(s7_a_q, 35, 15), s7_p_b = `RT_ROUND(s7_b_q, 35, 15);
    reg  signed [17:0] s8_p_a_q, s8_p_b_q, s9_p_a_q, s9_p_b_q, s10_p_a_q, s10_p_b_q;   // s0.17
    always @(posedge clk) begin
        if (live_q[6]) begin
            s7_a_q   <= s6_r * s6_u_b;
            s7_b_q   <= s6_r * s6_u_a;
        end
        if (live_q[7]) begin
            s8_p_a_q <= s7_p_a[17:0];         // |p| < 1
            s8_p_b_q <= s7_p_b[17:0];
        end
        if (live_q[8]) {s9_least_q, s9_p_b_q, s9_p_a_q} <= {s8_u_q[55:54], s8_p_b_q, s8_p_a_q};
        if (live_q[9]) {s10_least_q, s10_p_b_q, s10_p_a_q} <= {s9_least_q, s9_p_b_q, s9_p_a_q};
    end

    // ---- stages 9 to 11: q ----
    wire signed [17:0] s8_u_m = s8_u_q[53:36], s8_u_b = s8_u_q[35:18], s8_u_a = s8_u_q[17:0];
    reg  signed [35:0] s9_a_q, s9_b_q, s9_u_b_q, s9_u_a_q, s10_sum_q;                 // s2.33
    wire signed [19:0] s9_q_a = `RT_ROUND(s9_a_q, 35, 16), s9_q_b = `RT_ROUND(s9_b_q, 35, 16);
    wire signed [19:0] s10_q_m = `RT_ROUND(s10_sum_q, 35, 16);
    reg  [17:0]        s10_q_a_q, s10_q_b_q;
    always @(posedge clk) begin
        if (live_q[8]) begin
            s9_a_q   <= s8_u_m * s8_p_b_q;
            s9_b_q   <= s8_u_m * s8_p_a_q;
            s9_u_b_q <= s8_u_b * s8_p_a_q;
            s9_u_a_q <= s8_u_a * s8_p_b_q;
        end
        if (live_q[9]) begin
            s10_q_a_q <= s9_q_a[17:0];         // |q| < 1
            s10_q_b_q <= s9_q_b[17:0];
            s10_sum_q <= ~s9_u_b_q - s9_u_a_q; // -u_b*p_a - 1 - u_a*p_b
        end
        if (live_q[10]) begin
            out_least_o <= s10_least_q;
            out_p_a_o   <= s10_p_a_q;
            out_p_b_o   <= s10_p_b_q;
            out_q_o[17:0]  <= s10_least_q == 2'd0 ? s10_q_m[17:0] : s10_q_a_q;
            out_q_o[35:18] <= s10_least_q == 2'd1 ? s10_q_m[17:0]
                              : s10_least_q == 2'd0 ? s10_q_a_q : s10_q_b_q;
            out_q_o[53:36] <= s10_least_q == 2'd2 ? s10_q_m[17:0] : s10_q_b_q;
        end
    end

    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_axes_across_rays /* verilator public_flat_rd */ =
        {1'b0, in_valid_i, 5'd0, in_valid_i};
    wire unused = &{1'b0, x[17], s2_square_q[13:0], s5_slope_q[9:0], s7_p_a[20:18],
                    s7_p_b[20:18], s7_a_q[13:0], s7_b_q[13:0], s9_q_a[19:18], s9_q_b[19:18],
                    s9_a_q[14:0], s9_b_q[14:0], s10_q_m[19:18], s10_sum_q[14:0]};
endmodule
`default_nettype wire
