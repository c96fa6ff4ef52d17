// rt_filter.v - one lane of the node filter: may the child hold a hit?
// SPDX-License-Identifier: Apache-2.0
// pass = (oc.p)^2 + (oc.q)^2 <= rad^2 && depth + rad >= 0 && depth - rad <= depth_max,
// oc = ctr - org, p and q across the ray (rt_across), depth = oc along the largest axis of its unit
// vector. Never rejects what the exact test hits (docs/design/traversal.md).
//   1 oc | 2 its parts along p | 3 products | 4 pairs | 5 sums | 6 cut to 1 fraction bit | rad - q,
//   rad + q | (oc.p)^2 and their product | compare; with SQUARES 7 to 10 squares | 11 rad^2 - qq
// What has no child keeps its operands, and what depth or q alone decides has no products.
// Latency 9 = `RT_FILTER_LATENCY, with SQUARES 12 = `RT_FILTER_SQUARES_LATENCY; a child a clock.
// Model: sph_filter() in cmodel/trace/filter.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
`include "rt_layout.vh"
module rt_filter #(
    parameter FW   = 14,                     // filter coordinate, bits: 2 to 14
    parameter SQUARES = 0                    // 1: squares in LUTs, not in multipliers
) (
    input  wire                 clk,
    input  wire                 in_valid_i,      // a child
    // from the ray
    input  wire signed [FW-1:0] in_org_x_i,  // sFW filter units
    input  wire signed [FW-1:0] in_org_y_i,
    input  wire signed [FW-1:0] in_org_z_i,
    input  wire [1:0]           in_least_i,  // 0 x, 1 y, 2 z: the axis that p lies across
    input  wire [1:0]           in_axis_i,   // 0 x, 1 y, 2 z: the largest of |u|
    input  wire                 in_negative_i,   // sign of that component
    input  wire [FW:0]          in_depth_max_i,  // u(FW+1), nothing deeper matters
    // from the ray, a clock later
    input  wire signed [17:0]   s1_p_a_i,    // s0.17, along the lower of the other two
    input  wire signed [17:0]   s1_p_b_i,    // s0.17, along the higher one, negated
    input  wire signed [17:0]   s1_q_x_i,    // s0.17
    input  wire signed [17:0]   s1_q_y_i,
    input  wire signed [17:0]   s1_q_z_i,
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
    localparam F  = `RT_FILTER_FRACTION;     // fraction bits of oc.p
    localparam MW = 15 + F;                  // |oc.p| <= |oc| <= sqrt(3) * (2^14-1) < 2^15

    localparam LAST = SQUARES != 0 ? 11 : 8; // stage before the comparison
    reg  [LAST-1:1] live_q;                  // stages that hold a child
    always @(posedge clk) live_q <= {live_q[LAST-2:1], in_valid_i};

    // ---- stage 1: centre from origin ----
    reg signed [14:0] s1_oc_x_q, s1_oc_y_q, s1_oc_z_q;    // s15
    reg [1:0]         s1_least_q, s1_axis_q;
    reg               s1_negative_q;
    reg [13:0]        s1_rad_q;
    reg [FW:0]        s1_depth_max_q;
    always @(posedge clk) if (in_valid_i) begin
        s1_oc_x_q <= $signed({in_ctr_x_i[13], in_ctr_x_i})
                   - $signed({{(15-FW){in_org_x_i[FW-1]}}, in_org_x_i});
        s1_oc_y_q <= $signed({in_ctr_y_i[13], in_ctr_y_i})
                   - $signed({{(15-FW){in_org_y_i[FW-1]}}, in_org_y_i});
        s1_oc_z_q <= $signed({in_ctr_z_i[13], in_ctr_z_i})
                   - $signed({{(15-FW){in_org_z_i[FW-1]}}, in_org_z_i});
        s1_least_q     <= in_least_i;
        s1_axis_q      <= in_axis_i;
        s1_negative_q  <= in_negative_i;
        s1_rad_q       <= in_rad_i;
        s1_depth_max_q <= in_depth_max_i;
    end

    // ---- stage 2: oc along p's two axes, along the largest ----
    reg signed [14:0] s2_oc_a_q, s2_oc_b_q, s2_oc_x_q, s2_oc_y_q, s2_oc_z_q, s2_depth_q;   // s15
    reg signed [17:0] s2_p_a_q, s2_p_b_q, s2_q_x_q, s2_q_y_q, s2_q_z_q;   // s0.17
    reg               s2_negative_q;
    reg [13:0]        s2_rad_q;
    reg [FW:0]        s2_depth_max_q;
    always @(posedge clk) if (live_q[1]) begin
        s2_oc_a_q <= s1_least_q == 2'd0 ? s1_oc_y_q : s1_oc_x_q;
        s2_oc_b_q <= s1_least_q == 2'd2 ? s1_oc_y_q : s1_oc_z_q;
        s2_oc_x_q <= s1_oc_x_q;
        s2_oc_y_q <= s1_oc_y_q;
        s2_oc_z_q <= s1_oc_z_q;
        s2_p_a_q  <= s1_p_a_i;
        s2_p_b_q  <= s1_p_b_i;
        s2_q_x_q  <= s1_q_x_i;
        s2_q_y_q  <= s1_q_y_i;
        s2_q_z_q  <= s1_q_z_i;
        s2_depth_q <= s1_axis_q == 2'd0 ? s1_oc_x_q : s1_axis_q == 2'd1 ? s1_oc_y_q : s1_oc_z_q;
        s2_negative_q  <= s1_negative_q;
        s2_rad_q       <= s1_rad_q;
        s2_depth_max_q <= s1_depth_max_q;
    end

    // ---- stage 3: products, signed depth ----
    reg signed [32:0] s3_pa_q, s3_pb_q, s3_qx_q, s3_qy_q, s3_qz_q;        // s15.17
    reg signed [15:0] s3_depth_q;                         // s16
    reg [13:0]        s3_rad_q;
    reg [FW:0]        s3_depth_max_q;
    wire signed [15:0] s3_depth = {s2_depth_q[14], s2_depth_q};
    always @(posedge clk) if (live_q[2]) begin
        s3_pa_q <= s2_oc_a_q * s2_p_a_q;
        s3_pb_q <= s2_oc_b_q * s2_p_b_q;
        s3_qx_q <= s2_oc_x_q * s2_q_x_q;
        s3_qy_q <= s2_oc_y_q * s2_q_y_q;
        s3_qz_q <= s2_oc_z_q * s2_q_z_q;
        s3_depth_q     <= s2_negative_q ? -s3_depth : s3_depth;
        s3_rad_q       <= s2_rad_q;
        s3_depth_max_q <= s2_depth_max_q;
    end

    // ---- stage 4: pairs, depths of the child's ends ----
    reg signed [33:0] s4_p_q, s4_q_q;                     // s16.17
    reg signed [32:0] s4_qz_q;
    reg signed [15:0] s4_near_q;                          // s16
    reg               s4_behind_q;
    reg [13:0]        s4_rad_q, s5_rad_q;
    reg [FW:0]        s4_depth_max_q;
    wire signed [15:0] s4_rad = {2'b0, s3_rad_q};
    wire signed [15:0] s4_end = s3_depth_q + s4_rad;      // at most 2^14 + 2^14-1
    always @(posedge clk) if (live_q[3]) begin
        s4_p_q         <= $signed({s3_pa_q[32], s3_pa_q}) - $signed({s3_pb_q[32], s3_pb_q});
        s4_q_q         <= $signed({s3_qx_q[32], s3_qx_q}) + $signed({s3_qy_q[32], s3_qy_q});
        s4_qz_q        <= s3_qz_q;
        s4_near_q      <= s3_depth_q - s4_rad;
        s4_behind_q    <= s4_end[15];
        s4_rad_q       <= s3_rad_q;
        s4_depth_max_q <= s3_depth_max_q;
    end

    // ---- stage 5: oc.p and oc.q, depth decided ----
    reg signed [33:0] s5_p_q, s5_q_q;                     // s16.17, within s15.17
    reg               s5_ok_q;
    reg signed [15:0] s5_near_q;
    wire signed [16:0] s5_near = {s4_near_q[15], s4_near_q};
    wire signed [16:0] s5_max  = {{(16-FW){1'b0}}, s4_depth_max_q};
    always @(posedge clk) if (live_q[4]) begin
        s5_p_q    <= s4_p_q;
        s5_q_q    <= s4_q_q + $signed({s4_qz_q[32], s4_qz_q});
        s5_ok_q   <= !s4_behind_q && s5_near <= s5_max;
        s5_near_q <= s4_near_q;
        s5_rad_q  <= s4_rad_q;
    end

    // ---- stage 6: magnitudes, cut: one's complement is never more than two's ----
    reg [MW-1:0]      s6_p_q, s6_q_q;                     // u15.F
    reg               s6_ok_q;
    reg signed [15:0] s6_near_q;
    reg [13:0]        s6_rad_q;
    always @(posedge clk) if (live_q[5]) begin
        s6_p_q <= s5_p_q[17-F +: MW] ^ {MW{s5_p_q[33]}};
        s6_q_q <= s5_q_q[17-F +: MW] ^ {MW{s5_q_q[33]}};
        s6_ok_q   <= s5_ok_q;
        s6_near_q <= s5_near_q;
        s6_rad_q  <= s5_rad_q;
    end

    // ---- squares; rad^2 - qq in multipliers as (rad - q)*(rad + q), a stage earlier ----
    reg [2*MW-1:0]        left_pp_q;                      // u30.2F
    reg signed [2*MW:0]   left_q;                         // s31.2F, rad^2 - qq
    reg                   left_ok_q, pass_q;
    reg signed [15:0]     left_near_q, near_q;
    wire signed [15:0]    near;
    generate
        if (SQUARES != 0) begin : g_luts
            wire                ok;
            wire [2*MW-1:0]     pp, qq;                   // u30.2F
            wire [27:0]         rad2;                     // u28
            wire signed [2*MW:0] left_rad2 = {{(2*MW-27-2*F){1'b0}}, rad2, {(2*F){1'b0}}};
            rt_square #(.BITS(MW)) u_p (.clk(clk), .in_i(s6_p_q), .out_q(pp));
            rt_square #(.BITS(MW)) u_q (.clk(clk), .in_i(s6_q_q), .out_q(qq));
            rt_square u_square (.clk(clk), .in_i(s6_rad_q), .out_q(rad2));
            rt_delay #(.WIDTH(17), .CYCLES(4)) u_depth (
                .clk(clk), .in_i({s6_ok_q, s6_near_q}), .out_o({ok, near})
            );
            always @(posedge clk) begin
                left_ok_q <= ok;
                if (live_q[10]) begin
                    left_pp_q <= pp;
                    left_q    <= left_rad2 - $signed({1'b0, qq});
                end
            end
        end else begin : g_multipliers
            reg                 s7_ok_q;
            reg signed [15:0]   s7_near_q;
            reg [MW-1:0]        s7_p_q;                   // u15.F
            reg signed [MW:0]   s7_less_q;                // s16.F, rad - q
            reg [MW:0]          s7_more_q;                // u16.F, rad + q
            wire signed [MW:0]  s6_rad = {{(MW-13-F){1'b0}}, s6_rad_q, {F{1'b0}}};
            wire signed [MW:0]  s6_less = s6_rad - $signed({1'b0, s6_q_q});
            wire signed [MW+1:0] s7_more = {1'b0, s7_more_q};
            wire                open = live_q[6] && s6_ok_q && !s6_less[MW];
            assign near = s7_near_q;
            always @(posedge clk) begin
                s7_ok_q   <= open;
                left_ok_q <= s7_ok_q;
                if (live_q[6]) s7_near_q <= s6_near_q;
                if (open) begin
                    s7_p_q    <= s6_p_q;
                    s7_less_q <= s6_less;
                    s7_more_q <= s6_rad + $signed({1'b0, s6_q_q});
                end
                if (s7_ok_q) begin
                    left_pp_q <= s7_p_q * s7_p_q;
                    left_q    <= s7_less_q * s7_more;     // 0 .. rad^2
                end
            end
        end
    endgenerate

    // ---- compare ----
    always @(posedge clk) begin
        if (live_q[LAST-1]) left_near_q <= near;
        pass_q <= left_ok_q && $signed({1'b0, left_pp_q}) <= left_q;
        near_q <= left_near_q;
    end
    assign out_pass_o = pass_q;
    assign out_near_o = near_q;

    wire unused = &{1'b0, s4_end[14:0], s5_p_q, s5_q_q};
endmodule
`default_nettype wire
