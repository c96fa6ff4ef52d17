// rt_texel_filter.v - one texel from four of each of two levels
// SPDX-License-Identifier: Apache-2.0
//   level = round(bilinear(texel 0..3; wx, wy) * 2^8), u8.8; texel = round(near + (far - near)*wl)
// Nearest: texel 0 and weights of 0. One level: wl = 0, the far texels do not matter.
// A channel of a level a clock, near before far, red first, through four multipliers:
//   0 differences in x | 1 products | 2 rows | 3 product in y | 4 level, rounded |
//   5 product of levels | 6 rounded
// Latency 13 cycles, a new one every 7. Model: cmodel/texture/texel.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_fx.vh"
module rt_texel_filter #(
    parameter TAG = 8                       // what travels along, bits
) (
    input  wire           clk,
    input  wire           rst,              // synchronous, active high
    input  wire           in_valid_i,
    output wire           in_ready_o,
    input  wire [TAG-1:0] in_tag_i,
    input  wire [95:0]    in_near_i,        // texels 3..0, each blue, green, red: red low
    input  wire [95:0]    in_far_i,
    input  wire [15:0]    in_near_weight_i, // {wy, wx}, u0.8
    input  wire [15:0]    in_far_weight_i,
    input  wire [7:0]     in_level_i,       // wl, u0.8
    output wire           out_valid_o,      // one cycle
    output reg  [TAG-1:0] out_tag_o,
    output reg  [23:0]    out_texel_o       // red low
);
    // ---- control: ph_q[n] n cycles after the input was taken ----
    reg  [13:1] ph_q;
    wire        take = in_valid_i && in_ready_o;
    wire        far  = ph_q[2] || ph_q[4] || ph_q[6];
    assign in_ready_o  = ~|ph_q[6:1];
    assign out_valid_o = ph_q[13];
    always @(posedge clk) begin
        ph_q <= {ph_q[12:1], take};
        if (rst) ph_q <= 13'd0;
    end

    // ---- input: channels move down after the far level ----
    reg  [TAG-1:0] tag_q;
    reg  [95:0]    near_q, far_q;
    reg  [15:0]    near_weight_q, far_weight_q;
    reg  [7:0]     level_q;
    always @(posedge clk)
        if (take) begin
            tag_q         <= in_tag_i;
            near_q        <= in_near_i;
            far_q         <= in_far_i;
            near_weight_q <= in_near_weight_i;
            far_weight_q  <= in_far_weight_i;
            level_q       <= in_level_i;
        end else if (far) begin
            near_q <= near_q >> 8;
            far_q  <= far_q >> 8;
        end
    wire [95:0] texels = far ? far_q : near_q;
    wire [7:0]  a = texels[7:0], b = texels[31:24], c = texels[55:48], d = texels[79:72];
    wire [15:0] weight = far ? far_weight_q : near_weight_q;

    // ---- stage 0: differences in x ----
    reg  signed [8:0]  s0_wx_q, s0_b_a_q, s0_d_c_q;
    reg  [7:0]         s0_a_q, s0_c_q, s0_wy_q, s0_wl_q;
    always @(posedge clk) begin
        s0_wx_q  <= $signed({1'b0, weight[7:0]});
        s0_b_a_q <= $signed({1'b0, b}) - $signed({1'b0, a});
        s0_d_c_q <= $signed({1'b0, d}) - $signed({1'b0, c});
        s0_a_q   <= a;
        s0_c_q   <= c;
        s0_wy_q  <= weight[15:8];
        s0_wl_q  <= level_q;
    end

    // ---- stage 1: products in x ----
    reg  signed [17:0] s1_upper_q, s1_lower_q;
    reg  [7:0]         s1_a_q, s1_c_q, s1_wy_q, s1_wl_q;
    always @(posedge clk) begin
        s1_upper_q <= s0_b_a_q * s0_wx_q;
        s1_lower_q <= s0_d_c_q * s0_wx_q;
        s1_a_q     <= s0_a_q;
        s1_c_q     <= s0_c_q;
        s1_wy_q    <= s0_wy_q;
        s1_wl_q    <= s0_wl_q;
    end

    // ---- stage 2: two rows, exact; between the texels, so 16 bits hold them ----
    reg  [15:0]        s2_upper_q, s2_lower_q;      // u8.8
    reg  [7:0]         s2_wy_q, s2_wl_q;
    always @(posedge clk) begin
        s2_upper_q <= {s1_a_q, 8'd0} + s1_upper_q[15:0];
        s2_lower_q <= {s1_c_q, 8'd0} + s1_lower_q[15:0];
        s2_wy_q    <= s1_wy_q;
        s2_wl_q    <= s1_wl_q;
    end

    // ---- stage 3: product in y ----
    wire signed [16:0] s2_diff = $signed({1'b0, s2_lower_q}) - $signed({1'b0, s2_upper_q});
    wire signed [16:0] s2_wy   = $signed({9'd0, s2_wy_q});
    reg  signed [33:0] s3_prod_q;
    reg  [15:0]        s3_upper_q;
    reg  [7:0]         s3_wl_q;
    always @(posedge clk) begin
        s3_prod_q  <= s2_diff * s2_wy;
        s3_upper_q <= s2_upper_q;
        s3_wl_q    <= s2_wl_q;
    end

    // ---- stage 4: the level; the near one waits for the far one ----
    wire signed [25:0] s3_sum = $signed({2'd0, s3_upper_q, 8'd0}) + s3_prod_q[25:0];  // u8.16
    wire signed [17:0] s3_level = `RT_ROUND(s3_sum, 25, 8);
    reg  [15:0]        s4_level_q, s4_near_q;       // u8.8
    reg  [7:0]         s4_wl_q;
    always @(posedge clk) begin
        s4_level_q <= s3_level[15:0];
        s4_near_q  <= s4_level_q;
        s4_wl_q    <= s3_wl_q;
    end

    // ---- stage 5: product of levels ----
    wire signed [16:0] s4_diff = $signed({1'b0, s4_level_q}) - $signed({1'b0, s4_near_q});
    wire signed [16:0] s4_wl   = $signed({9'd0, s4_wl_q});
    reg  signed [33:0] s5_prod_q;
    reg  [15:0]        s5_near_q;
    always @(posedge clk) begin
        s5_prod_q <= s4_diff * s4_wl;
        s5_near_q <= s4_near_q;
    end

    // ---- stage 6: the channel ----
    wire signed [25:0] s5_sum = $signed({2'd0, s5_near_q, 8'd0}) + s5_prod_q[25:0];   // u8.16
    wire signed [9:0]  s5_channel = `RT_ROUND(s5_sum, 25, 16);
    always @(posedge clk) begin
        if (ph_q[8] || ph_q[10] || ph_q[12]) out_texel_o <= {s5_channel[7:0], out_texel_o[23:8]};
        if (ph_q[7]) out_tag_o <= tag_q;
    end
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_texels_filtered /* verilator public_flat_rd */ =
        {in_valid_i && !in_ready_o, take, 5'd0, take || !in_ready_o};
    wire unused = &{1'b0, s1_upper_q[17:16], s1_lower_q[17:16], s3_prod_q[33:26], s3_level[17:16],
                    s5_prod_q[33:26], s5_channel[9:8], s3_sum[6:0], s5_sum[14:0], texels};
endmodule
`default_nettype wire
