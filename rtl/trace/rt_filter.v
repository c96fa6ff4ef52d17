// rt_filter.v - one lane of the node filter: may the child hold a hit?
// SPDX-License-Identifier: Apache-2.0
// pass = |oc x u|^2 <= rad^2 && depth + rad >= 0 && depth - rad <= depth_max, oc = ctr - org,
// depth = oc along the largest axis of u. Never rejects what the exact test hits
// (docs/blocks/filter.md).
//   1 oc | 2 products | 3 differences | 4 round to 2 fraction bits | 5 squares | 6 sums | 7 compare
// Latency 7 = `RT_FILTER_LATENCY, one child a clock. Model: sph_filter() in cmodel/trace/filter.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
`include "rt_fx.vh"
`include "rt_latency.vh"
module rt_filter #(
    parameter FW = 14                        // filter coordinate, bits: 2 to 14
) (
    input  wire                 clk,
    // from the ray
    input  wire signed [FW-1:0] in_org_x_i,  // sFW filter units
    input  wire signed [FW-1:0] in_org_y_i,
    input  wire signed [FW-1:0] in_org_z_i,
    input  wire signed [17:0]   in_u_x_i,    // s1.16, |u| <= 1 + 2^-15
    input  wire signed [17:0]   in_u_y_i,
    input  wire signed [17:0]   in_u_z_i,
    input  wire [1:0]           in_axis_i,   // 0 x, 1 y, 2 z: the largest of |u|
    input  wire                 in_negative_i,   // sign of that component
    input  wire [FW:0]          in_depth_max_i,  // u(FW+1), nothing deeper matters
    // from the node
    input  wire signed [13:0]   in_ctr_x_i,  // s14 filter units, of FW bits
    input  wire signed [13:0]   in_ctr_y_i,
    input  wire signed [13:0]   in_ctr_z_i,
    input  wire [13:0]          in_rad_i,    // u14
    // to rt_sort
    output wire                 out_pass_o,  // child may hold a hit
    output wire signed [15:0]   out_near_o   // s16, least depth the child reaches
);
    `RT_CHECK(FW >= 2 && FW <= 14, rt_filter_FW_must_be_2_to_14)

    // ---- stage 1: centre from origin ----
    reg signed [14:0] s1_oc_x_q, s1_oc_y_q, s1_oc_z_q;    // s15
    reg signed [17:0] s1_u_x_q, s1_u_y_q, s1_u_z_q;       // s1.16
    reg signed [14:0] s1_rad_q;                           // u14
    reg [1:0]         s1_axis_q;
    reg               s1_negative_q;
    reg [FW:0]        s1_depth_max_q;
    always @(posedge clk) begin
        s1_oc_x_q <= $signed({in_ctr_x_i[13], in_ctr_x_i})
                   - $signed({{(15-FW){in_org_x_i[FW-1]}}, in_org_x_i});
        s1_oc_y_q <= $signed({in_ctr_y_i[13], in_ctr_y_i})
                   - $signed({{(15-FW){in_org_y_i[FW-1]}}, in_org_y_i});
        s1_oc_z_q <= $signed({in_ctr_z_i[13], in_ctr_z_i})
                   - $signed({{(15-FW){in_org_z_i[FW-1]}}, in_org_z_i});
        s1_u_x_q       <= in_u_x_i;
        s1_u_y_q       <= in_u_y_i;
        s1_u_z_q       <= in_u_z_i;
        s1_rad_q       <= {1'b0, in_rad_i};
        s1_axis_q      <= in_axis_i;
        s1_negative_q  <= in_negative_i;
        s1_depth_max_q <= in_depth_max_i;
    end

    // ---- stage 2: six products of the cross product, oc along the axis ----
    reg signed [32:0] s2_yz_q, s2_zy_q, s2_zx_q, s2_xz_q, s2_xy_q, s2_yx_q;  // s16.16, named oc, u
    reg signed [14:0] s2_depth_q;                         // s15
    reg signed [14:0] s2_rad_q;                           // u14
    reg               s2_negative_q;
    reg [FW:0]        s2_depth_max_q;
    always @(posedge clk) begin
        s2_yz_q <= s1_oc_y_q * s1_u_z_q;
        s2_zy_q <= s1_oc_z_q * s1_u_y_q;
        s2_zx_q <= s1_oc_z_q * s1_u_x_q;
        s2_xz_q <= s1_oc_x_q * s1_u_z_q;
        s2_xy_q <= s1_oc_x_q * s1_u_y_q;
        s2_yx_q <= s1_oc_y_q * s1_u_x_q;
        s2_depth_q     <= s1_axis_q == 2'd0 ? s1_oc_x_q : s1_axis_q == 2'd1 ? s1_oc_y_q : s1_oc_z_q;
        s2_rad_q       <= s1_rad_q;
        s2_negative_q  <= s1_negative_q;
        s2_depth_max_q <= s1_depth_max_q;
    end

    // ---- stage 3: cross product, signed depth ----
    reg signed [33:0] s3_x_q, s3_y_q, s3_z_q;             // s17.16
    reg signed [15:0] s3_depth_q;                         // s16
    reg signed [14:0] s3_rad_q;                           // u14
    reg [FW:0]        s3_depth_max_q;
    wire signed [15:0] s3_depth = {s2_depth_q[14], s2_depth_q};
    always @(posedge clk) begin
        s3_x_q <= $signed({s2_yz_q[32], s2_yz_q}) - $signed({s2_zy_q[32], s2_zy_q});
        s3_y_q <= $signed({s2_zx_q[32], s2_zx_q}) - $signed({s2_xz_q[32], s2_xz_q});
        s3_z_q <= $signed({s2_xy_q[32], s2_xy_q}) - $signed({s2_yx_q[32], s2_yx_q});
        s3_depth_q     <= s2_negative_q ? -s3_depth : s3_depth;
        s3_rad_q       <= s2_rad_q;
        s3_depth_max_q <= s2_depth_max_q;
    end

    // ---- stage 4: cross product rounded, depths of the child's ends ----
    // |oc x u| * 4 <= sqrt(3) * (2^14-1) * (1 + 2^-15) * 4 < 2^17
    reg signed [17:0] s4_x_q, s4_y_q, s4_z_q;             // s15.2
    reg signed [15:0] s4_near_q;                          // s16
    reg               s4_behind_q;
    reg [FW:0]        s4_depth_max_q;
    wire signed [19:0] s4_x = `RT_ROUND(s3_x_q, 33, 14);
    wire signed [19:0] s4_y = `RT_ROUND(s3_y_q, 33, 14);
    wire signed [19:0] s4_z = `RT_ROUND(s3_z_q, 33, 14);
    wire signed [15:0] s4_rad = {1'b0, s3_rad_q};
    wire signed [15:0] s4_end = s3_depth_q + s4_rad;      // at most 2^14 + 2^14-1
    always @(posedge clk) begin
        s4_x_q         <= s4_x[17:0];
        s4_y_q         <= s4_y[17:0];
        s4_z_q         <= s4_z[17:0];
        s4_near_q      <= s3_depth_q - s4_rad;
        s4_behind_q    <= s4_end[15];
        s4_depth_max_q <= s3_depth_max_q;
    end

    // ---- stage 5: squares, depth decided ----
    reg signed [35:0] s5_xx_q, s5_yy_q, s5_zz_q;          // u30.4
    reg               s5_ok_q;
    reg signed [15:0] s5_near_q;
    wire [27:0]       s5_rad2_q;                          // u28
    rt_square u_square (.clk(clk), .in_i(s1_rad_q[13:0]), .out_q(s5_rad2_q));
    wire signed [16:0] s5_near = {s4_near_q[15], s4_near_q};
    wire signed [16:0] s5_max  = {{(16-FW){1'b0}}, s4_depth_max_q};
    always @(posedge clk) begin
        s5_xx_q   <= s4_x_q * s4_x_q;
        s5_yy_q   <= s4_y_q * s4_y_q;
        s5_zz_q   <= s4_z_q * s4_z_q;
        s5_ok_q   <= !s4_behind_q && s5_near <= s5_max;
        s5_near_q <= s4_near_q;
    end

    // ---- stage 6: xx + yy, rad^2 - zz ----
    reg [34:0]        s6_sum_q;                           // u31.4, |oc x u|^2 < 2^34
    reg signed [35:0] s6_left_q;                          // s31.4
    reg               s6_ok_q;
    reg signed [15:0] s6_near_q;
    always @(posedge clk) begin
        s6_sum_q  <= s5_xx_q[34:0] + s5_yy_q[34:0];
        s6_left_q <= $signed({4'd0, s5_rad2_q, 4'd0}) - s5_zz_q;
        s6_ok_q   <= s5_ok_q;
        s6_near_q <= s5_near_q;
    end

    // ---- stage 7: compare ----
    reg               s7_pass_q;
    reg signed [15:0] s7_near_q;
    always @(posedge clk) begin
        s7_pass_q <= s6_ok_q && $signed({1'b0, s6_sum_q}) <= s6_left_q;
        s7_near_q <= s6_near_q;
    end
    assign out_pass_o = s7_pass_q;
    assign out_near_o = s7_near_q;

    wire unused = &{1'b0, s3_x_q[12:0], s3_y_q[12:0], s3_z_q[12:0],
                    s4_x[19:18], s4_y[19:18], s4_z[19:18], s4_end[14:0], s5_xx_q[35], s5_yy_q[35]};
endmodule
`default_nettype wire
