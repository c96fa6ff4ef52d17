// f_cut.v - proof that rt_bih_step is sph_bih_cut() of its two planes, at its real width
// SPDX-License-Identifier: Apache-2.0
// A node is taken in the first clock, with any others before and behind it; 5 clocks later the
// result is the model's. Its up (g + 2) stands here as v g + 2 up + (up - v) g, v rounded down:
// the same by products.smt2.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module f_cut #(
    parameter W = 16
) (
    input wire                 clk,
    input wire signed [W-1:0]  org,
    input wire                 back, flat, open,
    input wire [5:0]           shift,
    input wire [`RT_BIH_G-1:0] g,
    input wire signed [W+1:0]  clip_l, clip_r
);
    localparam TW = `RT_BIH_T;
    localparam GW = `RT_BIH_G;
    localparam V  = W + 2 > `RT_BIH_V ? W + 2 - `RT_BIH_V : 0;
    localparam VW = W + 2 - V;
    localparam X  = VW + GW + 3;                     // bits of the model's words
    localparam [TW-1:0] NO_BOUND = {TW{1'b1}};
    wire out_back, out_near, out_far;
    wire [TW-1:0] upper, lower;
    rt_bih_step #(.W(W)) u_dut (
        .clk(clk), .in_org_i(org), .in_back_i(back), .in_flat_i(flat), .in_open_i(open),
        .in_shift_i(shift), .in_g_i(g), .in_clip_l_i(clip_l), .in_clip_r_i(clip_r),
        .out_back_o(out_back), .out_near_o(out_near), .out_far_o(out_far),
        .out_upper_o(upper), .out_lower_o(lower)
    );
    reg [2:0]          age_q = 3'd0;
    reg signed [W-1:0] m_org;
    reg signed [W+1:0] m_l, m_r;
    reg                m_back, m_flat, m_open;
    reg [5:0]          m_shift;
    reg [GW-1:0]       m_g;
    always @(posedge clk) begin
        if (age_q != 7) age_q <= age_q + 1'b1;
        if (age_q == 0) begin
            {m_org, m_l, m_r} <= {org, clip_l, clip_r};
            {m_back, m_flat, m_open, m_shift, m_g} <= {back, flat, open, shift, g};
        end
    end
    // rt_bih_ray: a direction of 0 is not negative, a shift below 0 is 0 and open
    always @* if (age_q == 0) assume (!(flat && back) && !(open && shift != 0));

    // ---- sph_bih_cut(): the plane that the ray leaves by, the one that it enters by ----
    function [VW+GW-1:0] times(input [VW-1:0] a, input [GW-1:0] b); times = a * b; endfunction
    wire signed [X-1:0] v_l = m_l - m_org, v_r = m_r - m_org;
    wire signed [X-1:0] leave = m_back ? -v_r : v_l, enter = m_back ? -v_l : v_r;
    wire signed [X-1:0] down = leave >>> V;
    wire signed [X-1:0] up = (leave + ((1 << V) - 1)) >>> V;
    wire [X-1:0] p_enter = times(enter[W+1:V], m_g);
    wire [X-1:0] p_leave = times(leave[W+1:V], m_g) + (up << 1) + (up == down ? 0 : m_g);
    wire [X-1:0] entering = p_enter >> m_shift;
    wire [X-1:0] leaving  = (p_leave >> m_shift) + 1;
    always @* if (age_q == 5) begin
        assert (out_back == m_back);
        assert (out_near == (leave >= 0));                       // not 0 of the one
        assert (out_far == !(m_flat && enter > 0));              // nor of the other
        if (leave >= 0)
            assert (upper == (m_flat || m_open || leaving > NO_BOUND ? NO_BOUND
                                                                     : leaving[TW-1:0]));
        assert (lower == (m_flat || enter <= 0 ? 0 : entering > NO_BOUND ? NO_BOUND
                                                                         : entering[TW-1:0]));
    end
endmodule
`default_nettype wire
