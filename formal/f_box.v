// f_box.v - proof that rt_box joins the cuts of its axes as sph_box_meets() does
// SPDX-License-Identifier: Apache-2.0
// Its planes go to rt_bih_step (f_cut.v), an axis to each. From any state, what these say together
// is the result four clocks later, whatever boxes are before and behind it.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module f_box #(
    parameter W = 16
) (
    input wire                 clk,
    input wire [3*(W+2)-1:0]   places, lo, hi,
    input wire [3*(`RT_BIH_G+7)-1:0] paces,
    input wire [14:0]          limit
);
    localparam TW = `RT_BIH_T;
    wire pass;
    wire [14:0] near;
    rt_box #(.W(W)) u_dut (
        .clk(clk), .in_places_i(places), .in_paces_i(paces), .in_lo_i(lo), .in_hi_i(hi),
        .in_limit_i(limit), .out_pass_o(pass), .out_near_o(near)
    );
    (* hierconn *) wire [2:0]      \u_dut.near , \u_dut.far ;
    (* hierconn *) wire [3*TW-1:0] \u_dut.upper , \u_dut.lower ;

    // ---- the planes that are cut: the ray leaves by hi or lo, whichever way it runs ----
    (* hierconn *) wire [W-1:0] \u_dut.g_axis[0].u_step.in_org_i ,
        \u_dut.g_axis[1].u_step.in_org_i , \u_dut.g_axis[2].u_step.in_org_i ;
    (* hierconn *) wire \u_dut.g_axis[0].u_step.in_back_i ,
        \u_dut.g_axis[1].u_step.in_back_i , \u_dut.g_axis[2].u_step.in_back_i ;
    (* hierconn *) wire \u_dut.g_axis[0].u_step.in_flat_i ,
        \u_dut.g_axis[1].u_step.in_flat_i , \u_dut.g_axis[2].u_step.in_flat_i ;
    (* hierconn *) wire \u_dut.g_axis[0].u_step.in_open_i ,
        \u_dut.g_axis[1].u_step.in_open_i , \u_dut.g_axis[2].u_step.in_open_i ;
    (* hierconn *) wire [6-1:0] \u_dut.g_axis[0].u_step.in_shift_i ,
        \u_dut.g_axis[1].u_step.in_shift_i , \u_dut.g_axis[2].u_step.in_shift_i ;
    (* hierconn *) wire [`RT_BIH_G-1:0] \u_dut.g_axis[0].u_step.in_g_i ,
        \u_dut.g_axis[1].u_step.in_g_i , \u_dut.g_axis[2].u_step.in_g_i ;
    (* hierconn *) wire [W+2-1:0] \u_dut.g_axis[0].u_step.in_clip_l_i ,
        \u_dut.g_axis[1].u_step.in_clip_l_i , \u_dut.g_axis[2].u_step.in_clip_l_i ;
    (* hierconn *) wire [W+2-1:0] \u_dut.g_axis[0].u_step.in_clip_r_i ,
        \u_dut.g_axis[1].u_step.in_clip_r_i , \u_dut.g_axis[2].u_step.in_clip_r_i ;
    wire [3*(W+2)-1:0] cut_places = {\u_dut.g_axis[2].u_step.in_org_i ,
        \u_dut.g_axis[2].u_step.in_back_i ,
        \u_dut.g_axis[2].u_step.in_flat_i ,
        \u_dut.g_axis[1].u_step.in_org_i , \u_dut.g_axis[1].u_step.in_back_i ,
        \u_dut.g_axis[1].u_step.in_flat_i ,
        \u_dut.g_axis[0].u_step.in_org_i , \u_dut.g_axis[0].u_step.in_back_i ,
        \u_dut.g_axis[0].u_step.in_flat_i };
    wire [3*(`RT_BIH_G+7)-1:0] cut_paces = {\u_dut.g_axis[2].u_step.in_open_i ,
        \u_dut.g_axis[2].u_step.in_shift_i , \u_dut.g_axis[2].u_step.in_g_i ,
        \u_dut.g_axis[1].u_step.in_open_i ,
        \u_dut.g_axis[1].u_step.in_shift_i , \u_dut.g_axis[1].u_step.in_g_i ,
        \u_dut.g_axis[0].u_step.in_open_i ,
        \u_dut.g_axis[0].u_step.in_shift_i , \u_dut.g_axis[0].u_step.in_g_i };
    wire [3*(W+2)-1:0] cut_hi = {\u_dut.g_axis[2].u_step.in_clip_l_i ,
        \u_dut.g_axis[1].u_step.in_clip_l_i , \u_dut.g_axis[0].u_step.in_clip_l_i };
    wire [3*(W+2)-1:0] cut_lo = {\u_dut.g_axis[2].u_step.in_clip_r_i ,
        \u_dut.g_axis[1].u_step.in_clip_r_i , \u_dut.g_axis[0].u_step.in_clip_r_i };
    always @*
        assert (cut_places == places && cut_paces == paces && cut_hi == hi && cut_lo == lo);

    // ---- the cuts; limit comes 3 clocks behind them ----
    reg [2:0]      age_q = 3'd0;
    reg [2:0]      near_q, far_q;
    reg [3*TW-1:0] upper_q, lower_q;
    reg [14:0]     limit_q;
    always @(posedge clk) begin
        if (age_q != 7) age_q <= age_q + 1'b1;
        if (age_q == 0) begin
            {near_q, far_q} <= {\u_dut.near , \u_dut.far };
            {upper_q, lower_q} <= {\u_dut.upper , \u_dut.lower };
        end
        if (age_q == 3) limit_q <= limit;
    end
    wire [TW-1:0] lo_x = lower_q[0 +: TW], lo_y = lower_q[TW +: TW], lo_z = lower_q[2*TW +: TW];
    wire [TW-1:0] hi_x = upper_q[0 +: TW], hi_y = upper_q[TW +: TW], hi_z = upper_q[2*TW +: TW];
    wire [TW-1:0] lo_xy = lo_x > lo_y ? lo_x : lo_y, first = lo_xy > lo_z ? lo_xy : lo_z;
    wire [TW-1:0] hi_xy = hi_x < hi_y ? hi_x : hi_y, last  = hi_xy < hi_z ? hi_xy : hi_z;
    // sph_box_depth()
    reg [TW-1:0] cut;                                // places that are shifted
    integer n;
    always @* begin
        cut = 0;
        for (n = `RT_BOX_NEAR + 1; n < TW; n = n + 1) if (first[n]) cut = n - `RT_BOX_NEAR;
    end
    wire [TW-1:0] depth = (cut << `RT_BOX_NEAR) + (first >> cut);
    wire meets = &near_q && &far_q && first <= last && depth <= limit_q;
    always @* if (age_q == 4) begin
        assert (pass == meets);
        if (meets) assert (near == depth);
    end
endmodule
`default_nettype wire
