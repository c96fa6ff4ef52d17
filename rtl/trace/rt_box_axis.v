// rt_box_axis.v - one axis of a node's frame along a ray: where it begins, and what a step takes
// SPDX-License-Identifier: Apache-2.0
// Plane n of a child is passed at the T-word enter + (n*step >> fine) or later, plane n+1 at
// leave + (n*(step+2) >> fine) or earlier; n counts from where the ray comes from.
//   at = v * g >> shift, limited     enter = at + min(at >> 15, 0)     step = g >> (shift-s-fine)
//   fine = 4 if that fits, else 0    leave = at + max(at >> 15, 0) + (step >> fine) + 5
//   1 origin | 2 distance v, shifts | 3 product, step by bytes | 4 its sign, step by bits
//   5 at by bytes | 6 by bits | 7 limits | 8 enter, leave; the step comes a clock before them
// Nothing waits here: a node a clock, latency 8.
// Model: sph_box_axes() in cmodel/trace/bih.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_box_axis #(
    parameter W  = 16,                   // coordinate, bits
    parameter SW = `RT_BOX_CROSS + 9     // not to be set: T-words of a frame, signed, bits
) (
    input  wire                 clk,
    input  wire [13:0]          in_org_i,      // of the frame, s14
    input  wire [3:0]           in_step_i,
    input  wire [W+1:0]         in_place_i,    // of the ray {org sW, back, flat}
    input  wire [`RT_BIH_G+6:0] in_pace_i,     // {open, shift u6, g}
    output reg  signed [SW-1:0] out_enter_o,   // of a ray that is flat 1 less
    output reg  signed [SW-1:0] out_leave_o,
    output wire                 out_fine_o,    // fine is not 0
    output wire                 out_flat_o,    // the ray does not move along the axis
    output wire                 out_open_o,    // planes that are not behind it are no bound
    output reg  [`RT_BOX_CROSS-1:0] step_o,    // 7 clocks behind the node
    output reg  [`RT_BOX_CROSS:0] more_o,      // step + 2
    output wire                 back_o         // the ray runs back: 6 clocks behind the node
);
    localparam GW = `RT_BIH_G;
    localparam CW = W + 2;                           // coordinate of a plane
    localparam V  = CW > `RT_BIH_V ? CW - `RT_BIH_V : 0;    // what shifts of a BIH leave out
    localparam UP = W > 14 ? W - 14 : 0;
    localparam MOST = (1 << `RT_FRAME_STEP_X_BITS) - 1 + `RT_BOX_LO_X_BITS;
    localparam STEPS = W > MOST ? W - MOST : 0;      // added to every step
    localparam [6:0] FINE = `RT_BOX_FINE;
    localparam PW = CW + GW;                         // product
    localparam KW = SW - 1 + 7;                      // kept behind the shift by bytes
    localparam XW = PW > KW ? PW + 1 : KW + 1;       // the product on its way through bytes

    // ---- stage 1: where the ray comes into the frame ----
    wire [6:0]         step_wide = {3'd0, in_step_i} + STEPS[6:0];
    wire [6:0]         shift_wide = {1'b0, in_pace_i[GW +: 6]} + V[6:0];
    wire [CW+13:0]     org_wide = {{CW{in_org_i[13]}}, in_org_i} << UP;
    wire [CW+31:0]     reach = {{(CW+24){1'b0}}, 8'd128} << step_wide;
    reg [CW-1:0]       s1_org_q;
    reg [W+1:0]        s1_place_q;
    reg [6:0]          s1_step_q, s1_shift_q;
    reg                s1_open_q, s1_steep_q;
    reg [GW-1:0]       s1_g_q;
    always @(posedge clk) begin
        s1_org_q   <= org_wide[CW-1:0] + (in_place_i[1] ? reach[CW-1:0] : {CW{1'b0}});
        s1_place_q <= in_place_i;
        s1_step_q  <= step_wide;
        s1_shift_q <= shift_wide;
        s1_steep_q <= shift_wide <= step_wide;       // a step would lose no bit
        s1_open_q  <= in_pace_i[GW+6];
        s1_g_q     <= in_pace_i[GW-1:0];
    end

    // ---- stage 2: distance along the ray; shifts ----
    wire               s1_back = s1_place_q[1];
    wire [CW-1:0]      s1_ray = {{2{s1_place_q[W+1]}}, s1_place_q[W+1:2]};
    reg [CW-1:0]       s2_v_q;
    reg [GW-1:0]       s2_g_q;
    reg [6:0]          s2_shift_q, s2_less_q;        // of the product; of a step
    reg                s2_fine_q;
    wire [6:0]         s1_less = s1_shift_q - s1_step_q;
    wire               s1_fine = !s1_steep_q && s1_less > FINE;
    always @(posedge clk) begin
        s2_v_q     <= (s1_back ? s1_ray : s1_org_q) - (s1_back ? s1_org_q : s1_ray);
        s2_g_q     <= s1_g_q;
        s2_shift_q <= s1_steep_q ? s1_step_q + 7'd1 : s1_shift_q;
        s2_less_q  <= s1_steep_q ? 7'd1 : s1_fine ? s1_less - FINE : s1_less;
        s2_fine_q  <= s1_fine;
    end
    rt_delay #(.WIDTH(1), .CYCLES(5)) u_back (.clk(clk), .in_i(s1_back), .out_o(back_o));
    rt_delay #(.WIDTH(2), .CYCLES(7)) u_side (
        .clk(clk), .in_i({s1_place_q[0], s1_place_q[0] || s1_open_q || s1_steep_q}),
        .out_o({out_flat_o, out_open_o})
    );

    // ---- stages 3 and 4: the product, at first of v without its sign; the step ----
    reg [PW-1:0]       s3_product_q, s4_product_q;
    reg                s3_behind_q;
    reg [GW-1:0]       s3_g_q, s3_step_q;
    reg [`RT_BOX_CROSS-1:0] s4_step_q;
    reg [6:0]          s3_shift_q, s4_shift_q;
    reg [2:0]          s3_less_q;
    wire [GW-1:0]      s3_step = s3_step_q >> s3_less_q;
    always @(posedge clk) begin
        s3_product_q <= s2_v_q * s2_g_q;
        s3_behind_q  <= s2_v_q[CW-1];
        s3_g_q       <= s2_g_q;
        s3_shift_q   <= s2_shift_q;
        s3_step_q    <= s2_less_q[6:3] > 4'd2 ? {GW{1'b0}} : s2_g_q >> {s2_less_q[4:3], 3'd0};
        s3_less_q    <= s2_less_q[2:0];
        s4_product_q <= s3_product_q - {s3_behind_q ? s3_g_q : {GW{1'b0}}, {CW{1'b0}}};
        s4_shift_q   <= s3_shift_q;
        s4_step_q    <= s3_step[`RT_BOX_CROSS-1:0];  // at least one bit is lost
    end

    // ---- stages 5 and 6: right by bytes, limited, then by bits ----
    wire               s4_behind = s4_product_q[PW-1];
    wire signed [XW-1:0] s4_wide = $signed({{(XW-PW){s4_behind}}, s4_product_q});
    wire signed [XW-1:0] s4_bytes = s4_wide >>> {s4_shift_q[5:3], 3'd0};
    wire               s4_fits = s4_bytes[XW-1:KW-1] == {(XW-KW+1){s4_behind}};
    reg signed [KW-1:0] s5_at_q, s6_at_q;
    reg [2:0]          s5_shift_q;
    always @(posedge clk) begin
        s5_at_q    <= s4_fits ? $signed(s4_bytes[KW-1:0])
                              : $signed({s4_behind, {(KW-1){!s4_behind}}});
        s5_shift_q <= s4_shift_q[2:0];
        s6_at_q    <= s5_at_q >>> s5_shift_q;
    end

    // ---- stage 7: no further than it matters ----
    localparam TW = `RT_BIH_T;
    wire               s6_behind = s6_at_q[KW-1];
    wire               s6_above = !s6_behind && |s6_at_q[KW-2:TW];
    wire               s6_below = s6_behind && !(&s6_at_q[KW-2:SW-2]);
    reg signed [SW-1:0] s7_at_q;
    always @(posedge clk)
        s7_at_q <= s6_above ? {{(SW-TW-1){1'b0}}, 1'b1, {TW{1'b0}}}
                   : s6_below ? {2'b11, {(SW-2){1'b0}}} : s6_at_q[SW-1:0];

    // ---- stage 8: rounded outwards ----
    wire               s7_behind = s7_at_q[SW-1];
    wire signed [SW-1:0] s7_more = s7_at_q >>> (GW - 3);
    wire               s6_fine, s7_flat;
    reg [`RT_BOX_CROSS-1:0] s7_whole_q;              // of a step
    rt_delay #(.WIDTH(1), .CYCLES(4)) u_fine (.clk(clk), .in_i(s2_fine_q), .out_o(s6_fine));
    rt_delay #(.WIDTH(1), .CYCLES(2)) u_fine_out (
        .clk(clk), .in_i(s6_fine), .out_o(out_fine_o)
    );
    rt_delay #(.WIDTH(1), .CYCLES(6)) u_flat (
        .clk(clk), .in_i(s1_place_q[0]), .out_o(s7_flat)
    );
    wire [`RT_BOX_CROSS-1:0] s6_step;
    rt_delay #(.WIDTH(`RT_BOX_CROSS), .CYCLES(2)) u_step (
        .clk(clk), .in_i(s4_step_q), .out_o(s6_step)
    );
    always @(posedge clk) begin
        step_o <= s6_step;
        s7_whole_q <= s6_fine ? s6_step >> FINE : s6_step;
        more_o <= {1'b0, s6_step} + {{(`RT_BOX_CROSS-1){1'b0}}, 2'd2};
        out_enter_o <= s7_at_q + (s7_behind ? s7_more : {SW{1'b0}}) - {{(SW-1){1'b0}}, s7_flat};
        out_leave_o <= s7_at_q + (s7_behind ? {SW{1'b0}} : s7_more) +
                       {{(SW-`RT_BOX_CROSS){1'b0}}, s7_whole_q} + {{(SW-3){1'b0}}, 3'd5};
    end
    wire unused = &{1'b0, org_wide, reach, s4_shift_q[6], s3_step, s4_bytes};
endmodule
`default_nettype wire
