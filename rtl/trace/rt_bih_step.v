// rt_bih_step.v - a ray and the two planes of a BIH node: where it leaves one and enters the other
// SPDX-License-Identifier: Apache-2.0
// A ray's near child ends at its near plane, its far child begins at its far plane; v is how far
// along the ray's axis they are. T-words, limited to all ones = no bound:
//   upper = (ceil(vn / 2^V) * (g + 2) >> shift) + 1       lower = floor(vf / 2^V) * g >> shift
//   stage 1 v | 2 products | 3 what rounding up adds | 4 shift by bytes | 5 by bits, limits
// Nothing waits here: a node a clock, latency 5 = `RT_BIH_STEP_LATENCY.
// Model: sph_bih_cut() in cmodel/trace/bih.c, called for both planes
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_bih_step #(
    parameter W = 16    // coordinate, bits
) (
    input  wire                 clk,
    // one axis of a ray, and the planes of a node across it
    input  wire signed [W-1:0]  in_org_i,
    input  wire                 in_back_i,     // the ray runs towards smaller coordinates
    input  wire                 in_flat_i,     // it does not move along the axis
    input  wire                 in_open_i,     // it moves so little that upper has no bound
    input  wire [5:0]           in_shift_i,
    input  wire [`RT_BIH_G-1:0] in_g_i,        // a / |dir|, times 2^shift
    input  wire signed [W+1:0]  in_clip_l_i,   // the left child ends here, grid units
    input  wire signed [W+1:0]  in_clip_r_i,   // the right child begins here
    // what it meets of the two children
    output wire                 out_back_o,    // the right child is the near one
    output wire                 out_near_o,    // the near child is not all behind the origin
    output wire                 out_far_o,     // the ray does not stay before the far child
    output reg  [`RT_BIH_T-1:0] out_upper_o,   // the near child ends
    output reg  [`RT_BIH_T-1:0] out_lower_o    // the far child begins
);
    localparam TW = `RT_BIH_T;
    localparam GW = `RT_BIH_G;
    localparam V  = W + 2 > `RT_BIH_V ? W + 2 - `RT_BIH_V : 0;  // low bits that distances lose
    localparam VW = W + 2 - V;
    localparam PW = VW + GW + 1;                     // product, rounding up included
    localparam BW = TW + 7;                          // kept behind the shift by bytes

    // ---- stage 1: distances along the ray ----
    reg signed [W+2:0] s1_near_q, s1_far_q;
    reg                s1_back_q, s1_flat_q, s1_open_q;
    reg [GW-1:0]       s1_g_q;
    reg [5:0]          s1_shift_q;
    wire [W+1:0]       near_clip = (in_back_i ? in_clip_r_i : in_clip_l_i) ^ {(W+2){in_back_i}};
    wire [W+1:0]       far_clip  = (in_back_i ? in_clip_l_i : in_clip_r_i) ^ {(W+2){in_back_i}};
    wire [W-1:0]       org       = in_org_i ^ {W{in_back_i}};
    wire signed [W+2:0] org_wide = {{3{org[W-1]}}, org};
    always @(posedge clk) begin
        s1_near_q  <= $signed({near_clip[W+1], near_clip}) - org_wide;
        s1_far_q   <= $signed({far_clip[W+1], far_clip}) - org_wide;
        s1_back_q  <= in_back_i;
        s1_flat_q  <= in_flat_i;
        s1_open_q  <= in_open_i;
        s1_g_q     <= in_g_i;
        s1_shift_q <= in_shift_i;
    end

    // ---- stage 2: products ----
    // (v + up) * (g + 2) = v*g + more with more = 2*v + up*(g + 2)
    reg [VW+GW-1:0]    s2_near_q, s2_far_q;
    reg [PW-1:0]       s2_more_q;
    reg [5:0]          s2_shift_q;
    wire [VW-1:0]      s1_near = s1_near_q[W+1:V];
    wire [VW-1:0]      s1_far  = s1_far_q[W+1:V];
    wire               s1_up;
    wire [PW-1:0]      s1_more = {{(PW-VW-1){1'b0}}, s1_near, s1_up} +
                                 {{(PW-GW){1'b0}}, s1_up ? s1_g_q : {GW{1'b0}}} +
                                 {{(PW-1){1'b0}}, s1_up};
    generate
        if (V != 0) begin : g_round
            assign s1_up = |s1_near_q[V-1:0];
        end else begin : g_exact
            assign s1_up = 1'b0;
        end
    endgenerate
    wire               s1_before = !s1_far_q[W+2] && s1_far_q != {(W+3){1'b0}};
    always @(posedge clk) begin
        s2_near_q  <= s1_near * s1_g_q;
        s2_far_q   <= s1_far * s1_g_q;
        s2_more_q  <= s1_more;
        s2_shift_q <= s1_shift_q;
    end

    // ---- stage 3: the near product complete ----
    reg [PW-1:0]       s3_near_q;
    reg [VW+GW-1:0]    s3_far_q;
    reg [5:0]          s3_shift_q;
    always @(posedge clk) begin
        s3_near_q  <= {1'b0, s2_near_q} + s2_more_q;
        s3_far_q   <= s2_far_q;
        s3_shift_q <= s2_shift_q;
    end

    // ---- stage 4: right by 8 * shift[5:3]; is anything left above? ----
    function [BW:0] bytes(input [PW-1:0] product, input [2:0] n);  // {above, kept}
        reg [BW+55:0] x;
        integer i;
        begin
            x = {{(BW+56-PW){1'b0}}, product};
            bytes = {(BW+1){1'b0}};
            for (i = 0; i < 8; i = i + 1)
                if (n == i[2:0]) bytes = {|(x >> (BW + 8*i)), x[8*i +: BW]};
        end
    endfunction
    reg [BW:0]         s4_near_q, s4_far_q;
    reg [2:0]          s4_shift_q;
    always @(posedge clk) begin
        s4_near_q  <= bytes(s3_near_q, s3_shift_q[5:3]);
        s4_far_q   <= bytes({1'b0, s3_far_q}, s3_shift_q[5:3]);
        s4_shift_q <= s3_shift_q[2:0];
    end

    // ---- stage 5: right by shift[2:0], limits ----
    wire [BW-1:0]      s5_near = s4_near_q[BW-1:0] >> s4_shift_q;
    wire [BW-1:0]      s5_far  = s4_far_q[BW-1:0] >> s4_shift_q;
    wire               s5_near_over = s4_near_q[BW] || |s5_near[BW-1:TW] || &s5_near[TW-1:0];
    wire               s5_far_over  = s4_far_q[BW] || |s5_far[BW-1:TW];
    wire [4:0]         s4_side;        // {back, near, far, upper has no bound, lower is 0}
    rt_delay #(.WIDTH(5), .CYCLES(3)) u_side (
        .clk(clk),
        .in_i({s1_back_q, !s1_near_q[W+2], !s1_before || !s1_flat_q, s1_flat_q || s1_open_q,
               !s1_before || s1_flat_q}),
        .out_o(s4_side)
    );
    reg [2:0]          s5_side_q;
    always @(posedge clk) begin
        out_upper_o <= s4_side[1] || s5_near_over ? {TW{1'b1}} : s5_near[TW-1:0] + 1'b1;
        out_lower_o <= s4_side[0] ? {TW{1'b0}} : s5_far_over ? {TW{1'b1}} : s5_far[TW-1:0];
        s5_side_q   <= s4_side[4:2];
    end
    assign {out_back_o, out_near_o, out_far_o} = s5_side_q;
    wire unused = &{1'b0, s1_near_q, s1_far_q};
endmodule
`default_nettype wire
