// rt_box.v - does a ray meet the box of a child, and how deep does it enter?
// SPDX-License-Identifier: Apache-2.0
// Each axis is a pass of rt_bih_step between the two planes of the box; the ray is in the box from
// the last plane that it enters by to the first that it leaves by.
//   5 rt_bih_step | 6 two axes | 7 the third | 8 is anything left; depth | 9 against the limit
// Latency 9, a box a clock.
// Model: sph_box_meets() in cmodel/trace/bih.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_box #(
    parameter W  = 16,            // coordinate, bits
    parameter TW = `RT_BIH_T      // not to be set: bits of a bound
) (
    input  wire                 clk,
    input  wire [3*(W+2)-1:0]   in_places_i,   // {z, y, x} {org sW, back, flat}
    input  wire [3*(`RT_BIH_G+7)-1:0] in_paces_i,  // {z, y, x} {open, shift u6, g}
    input  wire [3*(W+2)-1:0]   in_lo_i,       // {z, y, x} the box begins, s(W+2) grid units
    input  wire [3*(W+2)-1:0]   in_hi_i,       // the box ends
    input  wire [14:0]          in_limit_i,    // depth of the ray, 8 clocks later
    output reg                  out_pass_o,
    output reg  [14:0]          out_near_o
);
    localparam GW = `RT_BIH_G;
    localparam CW = W + 2;
    wire [2:0]      near, far;
    wire [3*TW-1:0] upper, lower;
    genvar k;
    generate
        for (k = 0; k < 3; k = k + 1) begin : g_axis
            wire [W+1:0]  place = in_places_i[CW*k +: CW];
            wire [GW+6:0] pace  = in_paces_i[(GW+7)*k +: GW+7];
            wire          back;
            rt_bih_step #(.W(W)) u_step (
                .clk(clk),
                .in_org_i($signed(place[W+1:2])), .in_back_i(place[1]), .in_flat_i(place[0]),
                .in_open_i(pace[GW+6]), .in_shift_i(pace[GW +: 6]), .in_g_i(pace[GW-1:0]),
                .in_clip_l_i($signed(in_hi_i[CW*k +: CW])),
                .in_clip_r_i($signed(in_lo_i[CW*k +: CW])),
                .out_back_o(back), .out_near_o(near[k]), .out_far_o(far[k]),
                .out_upper_o(upper[TW*k +: TW]), .out_lower_o(lower[TW*k +: TW])
            );
            wire unused = &{1'b0, back};
        end
    endgenerate

    // ---- the last plane to enter by, the first to leave by ----
    wire [TW-1:0] lo_x = lower[0 +: TW], lo_y = lower[TW +: TW], lo_z = lower[2*TW +: TW];
    wire [TW-1:0] hi_x = upper[0 +: TW], hi_y = upper[TW +: TW], hi_z = upper[2*TW +: TW];
    reg           s6_in_q, s7_in_q, s8_in_q;
    reg [TW-1:0]  s6_lo_q, s6_lo_z_q, s7_lo_q, s6_hi_q, s6_hi_z_q, s7_hi_q;
    reg [14:0]    s8_near_q;
    wire [14:0]   s7_near;
    rt_box_depth u_depth (.time_i(s7_lo_q), .depth_o(s7_near));
    always @(posedge clk) begin
        s6_in_q    <= &near && &far;
        s6_lo_q    <= lo_x > lo_y ? lo_x : lo_y;
        s6_hi_q    <= hi_x < hi_y ? hi_x : hi_y;
        s6_lo_z_q  <= lo_z;
        s6_hi_z_q  <= hi_z;
        s7_in_q    <= s6_in_q;
        s7_lo_q    <= s6_lo_q > s6_lo_z_q ? s6_lo_q : s6_lo_z_q;
        s7_hi_q    <= s6_hi_q < s6_hi_z_q ? s6_hi_q : s6_hi_z_q;
        s8_in_q    <= s7_in_q && s7_lo_q <= s7_hi_q;
        s8_near_q  <= s7_near;
        out_pass_o <= s8_in_q && s8_near_q <= in_limit_i;
        out_near_o <= s8_near_q;
    end
endmodule
`default_nettype wire
