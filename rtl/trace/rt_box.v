// rt_box.v - does a ray meet the box of a child, and how deep does it enter?
// SPDX-License-Identifier: Apache-2.0
// Each plane is so many steps behind where the frame begins along the ray; the ray is in the box
// from the last plane that it enters by to the first that it leaves by.
//   1 products | 2 planes | 3 two axes | 4 the third | 5 is anything left; depth | 6 within limit
// Latency 6, a box a clock.
// Model: sph_box_meets() in cmodel/trace/bih.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_box #(
    parameter SW = `RT_BOX_CROSS + 9     // not to be set: T-words of a frame, signed, bits
) (
    input  wire                       clk,
    input  wire [20:0]                in_near_i,    // {z, y, x} plane that the ray enters by, u7
    input  wire [20:0]                in_far_i,     // that it leaves by
    input  wire [3*`RT_BOX_CROSS-1:0] in_step_i,    // {z, y, x} T-words of a step, rounded down
    input  wire [3*`RT_BOX_CROSS+2:0] in_more_i,    // rounded up
    // a clock later
    input  wire [3*SW-1:0]            late_enter_i, // {z, y, x} where the frame begins, of near
    input  wire [3*SW-1:0]            late_leave_i, // of far
    input  wire [2:0]                 late_fine_i,  // a step is 2^`RT_BOX_FINE T-words
    input  wire [2:0]                 late_flat_i,  // ahead of the ray: it is never reached
    input  wire [2:0]                 late_open_i,  // ahead of the ray: it is no bound
    input  wire [14:0]                in_limit_i,   // depth of the ray, 5 clocks later
    output reg                        out_pass_o,
    output reg  [14:0]                out_near_o
);
    localparam TW = `RT_BIH_T;
    localparam XW = `RT_BOX_CROSS;

    // ---- planes: what is ahead and never reached, or no bound, is above all T-words ----
    wire [3*SW-1:0] enter, leave;
    genvar k;
    generate
        for (k = 0; k < 3; k = k + 1) begin : g_axis
            reg [XW+6:0]        s1_near_q;
            reg [XW+7:0]        s1_far_q;
            wire [XW+6:0]       s1_near = late_fine_i[k] ? s1_near_q >> `RT_BOX_FINE : s1_near_q;
            wire [XW+7:0]       s1_far = late_fine_i[k] ? s1_far_q >> `RT_BOX_FINE : s1_far_q;
            reg signed [SW-1:0] s2_enter_q, s2_leave_q;
            reg                 s2_flat_q, s2_open_q;
            always @(posedge clk) begin
                s1_near_q  <= in_near_i[7*k +: 7] * in_step_i[XW*k +: XW];
                s1_far_q   <= in_far_i[7*k +: 7] * in_more_i[(XW+1)*k +: XW+1];
                s2_enter_q <= late_enter_i[SW*k +: SW] + {{(SW-XW-7){1'b0}}, s1_near};
                s2_leave_q <= late_leave_i[SW*k +: SW] + {{(SW-XW-8){1'b0}}, s1_far};
                s2_flat_q  <= late_flat_i[k];
                s2_open_q  <= late_open_i[k];
            end
            assign enter[SW*k +: SW] = s2_enter_q | {{(SW-TW-1){1'b0}}, s2_flat_q, {TW{1'b0}}};
            assign leave[SW*k +: SW] = s2_leave_q | {{(SW-TW-1){1'b0}}, s2_open_q, {TW{1'b0}}};
        end
    endgenerate

    // ---- the last plane to enter by, the first to leave by ----
    wire signed [SW-1:0] enter_x = $signed(enter[0 +: SW]), enter_y = $signed(enter[SW +: SW]),
                         enter_z = $signed(enter[2*SW +: SW]);
    wire signed [SW-1:0] leave_x = $signed(leave[0 +: SW]), leave_y = $signed(leave[SW +: SW]);
    reg signed [SW-1:0]  s3_first_q, s3_last_q, s3_leave_z_q, s4_first_q, s4_last_q;
    reg [SW-1:0]         s3_enter_z_q;               // not below 0
    reg                  s5_in_q;
    reg [14:0]           s5_near_q;
    wire [14:0]          s4_near;
    rt_box_depth u_depth (.time_i(s4_first_q[TW-1:0]), .depth_o(s4_near));
    always @(posedge clk) begin
        s3_first_q   <= enter_x > enter_y ? enter_x : enter_y;
        s3_enter_z_q <= enter_z[SW-1] ? {SW{1'b0}} : enter_z;
        s3_last_q    <= leave_x < leave_y ? leave_x : leave_y;
        s3_leave_z_q <= leave[2*SW +: SW];
        s4_first_q   <= s3_first_q > $signed(s3_enter_z_q) ? s3_first_q : $signed(s3_enter_z_q);
        s4_last_q    <= s3_last_q < s3_leave_z_q ? s3_last_q : s3_leave_z_q;
        s5_in_q      <= s4_first_q <= s4_last_q && s4_first_q[SW-1:TW] == {(SW-TW){1'b0}};
        s5_near_q    <= s4_near;
        out_pass_o   <= s5_in_q && s5_near_q <= in_limit_i;
        out_near_o   <= s5_near_q;
    end
endmodule
`default_nettype wire
