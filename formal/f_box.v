// f_box.v - proof that rt_box joins the axes of a frame as sph_box_meets() does
// SPDX-License-Identifier: Apache-2.0
// A box comes in the first clock, with any others before and behind it, where the frame begins in
// the next, its limit in the sixth, and the result behind that.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module f_box #(
    parameter XW = `RT_BOX_CROSS,
    parameter SW = XW + 9
) (
    input wire            clk,
    input wire [20:0]     near_code, far_code,
    input wire [3*XW-1:0] step,
    input wire [3*XW+2:0] more,
    input wire [3*SW-1:0] enter, leave,
    input wire [2:0]      fine, flat, open,
    input wire [14:0]     limit
);
    localparam TW = `RT_BIH_T;
    wire        pass;
    wire [14:0] near;
    rt_box u_dut (
        .clk(clk), .in_near_i(near_code), .in_far_i(far_code), .in_step_i(step), .in_more_i(more),
        .late_enter_i(enter), .late_leave_i(leave), .late_fine_i(fine),
        .late_flat_i(flat), .late_open_i(open),
        .in_limit_i(limit), .out_pass_o(pass), .out_near_o(near)
    );
    reg [2:0]      age_q = 3'd0;
    reg [20:0]     m_near, m_far;
    reg [3*XW-1:0] m_step;
    reg [3*XW+2:0] m_more;
    reg [3*SW-1:0] m_enter, m_leave;
    reg [2:0]      m_fine, m_flat, m_open;
    reg [14:0]     m_limit;
    always @(posedge clk) begin
        if (age_q != 7) age_q <= age_q + 1'b1;
        if (age_q == 0) {m_near, m_far, m_step, m_more} <= {near_code, far_code, step, more};
        if (age_q == 1) {m_enter, m_leave, m_fine, m_flat, m_open} <=
            {enter, leave, fine, flat, open};
        if (age_q == 5) m_limit <= limit;
    end

    // ---- sph_box_meets() ----
    localparam [SW-1:0] BEYOND = 1 << TW;
    function [XW+6:0] steps(input [6:0] a, input [XW-1:0] b); steps = a * b; endfunction
    function [XW+7:0] mores(input [6:0] a, input [XW:0] b); mores = a * b; endfunction
    function signed [SW-1:0] greater(input signed [SW-1:0] a, input signed [SW-1:0] b);
        greater = a > b ? a : b;
    endfunction
    wire [3*SW-1:0] first, last;
    genvar i;
    generate
        for (i = 0; i < 3; i = i + 1) begin : g_axis
            assign first[SW*i +: SW] = (m_enter[SW*i +: SW] +
                (steps(m_near[7*i +: 7], m_step[XW*i +: XW]) >>
                 (m_fine[i] ? `RT_BOX_FINE : 0))) | (m_flat[i] ? BEYOND : 0);
            assign last[SW*i +: SW] = (m_leave[SW*i +: SW] +
                (mores(m_far[7*i +: 7], m_more[(XW+1)*i +: XW+1]) >>
                 (m_fine[i] ? `RT_BOX_FINE : 0))) | (m_open[i] ? BEYOND : 0);
        end
    endgenerate
    wire signed [SW-1:0] in = greater(greater(0, first[0 +: SW]),
                                      greater(first[SW +: SW], first[2*SW +: SW]));
    wire signed [SW-1:0] out = ~greater(~last[0 +: SW],
                                        greater(~last[SW +: SW], ~last[2*SW +: SW]));
    // sph_box_depth()
    wire [TW-1:0] time_in = in[TW-1:0];
    reg [TW-1:0]  cut;                               // places that are shifted
    integer n;
    always @* begin
        cut = 0;
        for (n = `RT_BOX_NEAR + 1; n < TW; n = n + 1) if (time_in[n]) cut = n - `RT_BOX_NEAR;
    end
    wire [TW-1:0] depth = (cut << `RT_BOX_NEAR) + (time_in >> cut);
    wire meets = in <= out && in < $signed(BEYOND) && depth <= m_limit;
    always @* if (age_q == 6) begin
        assert (pass == meets);
        assert (near == depth);
    end
endmodule
`default_nettype wire
