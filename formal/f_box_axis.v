// f_box_axis.v - proof that rt_box_axis is sph_box_axes() of one axis, at its real width
// SPDX-License-Identifier: Apache-2.0
// A frame and a ray are taken in the first clock, with any others before and behind them; 8 clocks
// later the result is the model's: as far as the product, from there as far as where the frame
// begins, and from there on. Its product with a sign stands here as one without, by
// products.smt2. boxes.smt2 tells of what the model makes that it bounds what it stands for.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module f_box_axis #(
    parameter W = 16
) (
    input wire                 clk,
    input wire [13:0]          org,
    input wire [3:0]           step,
    input wire [W+1:0]         place,
    input wire [`RT_BIH_G+6:0] pace
);
    localparam GW = `RT_BIH_G, CW = W + 2, XW = `RT_BOX_CROSS, SW = XW + 9;
    localparam PW = CW + GW;
    localparam V  = CW > `RT_BIH_V ? CW - `RT_BIH_V : 0;     // v_shift
    localparam ORG_SHIFT  = W > 14 ? W - 14 : 0;     // sph_frame_org_shift()
    localparam STEP_SHIFT = W > 22 ? W - 22 : 0;     // sph_frame_step_shift()
    localparam X  = PW + 2;                          // bits of the model's words
    localparam signed [X-1:0] BEYOND = 1 << `RT_BIH_T, FRAME_T = 1 << (XW + 7);
    wire signed [SW-1:0] enter, leave;
    wire                 fine, flat, open, back;
    wire [XW-1:0]        across;
    wire [XW:0]          more;
    rt_box_axis #(.W(W)) u_dut (
        .clk(clk), .in_org_i(org), .in_step_i(step), .in_place_i(place), .in_pace_i(pace),
        .out_enter_o(enter), .out_leave_o(leave), .out_fine_o(fine),
        .out_flat_o(flat), .out_open_o(open),
        .step_o(across), .more_o(more), .back_o(back)
    );
    (* hierconn *) wire [PW-1:0]        \u_dut.s4_product_q ;
    (* hierconn *) wire [6:0]           \u_dut.s4_shift_q ;
    (* hierconn *) wire signed [SW-1:0] \u_dut.s7_at_q ;
    reg [3:0]            age_q = 4'd0;
    reg signed [PW-1:0]  product_4;
    reg [6:0]            shift_4;
    reg signed [SW-1:0]  at_7;
    reg [13:0]           m_org;
    reg [3:0]            m_step;
    reg [W+1:0]          m_place;
    reg [GW+6:0]         m_pace;
    always @(posedge clk) begin
        if (age_q != 15) age_q <= age_q + 1'b1;
        if (age_q == 0) {m_org, m_step, m_place, m_pace} <= {org, step, place, pace};
        if (age_q == 4) {product_4, shift_4} <= {\u_dut.s4_product_q , \u_dut.s4_shift_q };
        if (age_q == 7) at_7 <= \u_dut.s7_at_q ;
    end
    // rt_bih_ray: a shift below 0 is 0 and open, none is above 52
    always @* if (age_q == 0) assume (pace[GW +: 6] <= 52 && !(pace[GW+6] && pace[GW +: 6] != 0));

    // ---- sph_box_axes() ----
    function [PW-1:0] times(input [CW-1:0] a, input [GW-1:0] b); times = a * b; endfunction
    wire                m_back = m_place[1], m_flat = m_place[0];
    wire [GW-1:0]       g = m_pace[GW-1:0];
    wire [6:0]          s = m_step + STEP_SHIFT, ray_shift = m_pace[GW +: 6] + V;
    wire                steep = ray_shift <= s;
    wire [6:0]          shift = steep ? s + 1 : ray_shift;
    wire signed [X-1:0] ray = $signed(m_place[W+1:2]);
    wire signed [X-1:0] from = $signed(m_org) <<< ORG_SHIFT;
    wire signed [X-1:0] reach = 128 << s;
    wire signed [X-1:0] v_all = m_back ? ray - from - reach : from - ray;
    wire [CW-1:0]       v = v_all[CW-1:0];
    wire [PW-1:0]       product = times(v, g) - (v[CW-1] ? g << CW : 0);
    wire signed [X-1:0] product_all = product_4;
    wire signed [X-1:0] at_all = product_all >>> shift_4;
    wire signed [X-1:0] at = at_all < -FRAME_T ? -FRAME_T : at_all > BEYOND ? BEYOND : at_all;
    wire signed [X-1:0] dut_at = \u_dut.s7_at_q ;
    wire signed [X-1:0] begins = at_7;
    wire signed [X-1:0] rest = begins >>> (GW - 3);
    wire                m_fine = shift - s > `RT_BOX_FINE;
    wire [GW-1:0]       m_cross = g >> (shift - s - (m_fine ? `RT_BOX_FINE : 0));
    wire [GW-1:0]       m_whole = m_fine ? m_cross >> `RT_BOX_FINE : m_cross;
    wire signed [X-1:0] m_enter = begins + (begins < 0 ? rest : 0) - m_flat;
    wire signed [X-1:0] m_leave = begins + 5 + (begins < 0 ? 0 : rest) + m_whole;
    wire signed [X-1:0] enter_all = enter, leave_all = leave;
    reg product_is_q, back_is_q, step_is_q, at_is_q;     // only the last clock asserts
    always @(posedge clk) begin
        if (age_q == 4)
            product_is_q <= \u_dut.s4_product_q == product && \u_dut.s4_shift_q == shift;
        if (age_q == 6) back_is_q <= back == m_back;
        if (age_q == 7) step_is_q <= across == m_cross && more == m_cross + 2;
        if (age_q == 7) at_is_q   <= dut_at == at;
    end
    always @* begin
        if (age_q == 8) begin
            assert (product_is_q && back_is_q && step_is_q && at_is_q);
            assert (enter_all == m_enter && leave_all == m_leave);
            assert (fine == m_fine && flat == m_flat && open == (m_flat || m_pace[GW+6] || steep));
        end
    end
endmodule
`default_nettype wire
