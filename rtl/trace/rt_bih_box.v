// rt_bih_box.v - what of a ray lies in the global box of a BIH
// SPDX-License-Identifier: Apache-2.0
// The planes of an axis are a node's: the near one is that above, the far one that below. Of three
// axes, one a clock as rt_bih_ray has them, the interval is from the greatest lower bound to the
// least upper one; it is empty (hi 0, lo all ones) if the box lies behind the ray or beside it.
//   place 9 clocks | 1..5 rt_bih_step | 6 interval
// Model: box() in cmodel/trace/bih_walk.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_latency.vh"
module rt_bih_box #(
    parameter W     = 16,  // coordinate, bits
    parameter SLOTS = 32,  // power of two
    parameter TW    = `RT_BIH_T  // not to be set: bits of a bound
) (
    input  wire             clk,
    input  wire             rst,
    input  wire [6*(W+2)-1:0] box_i,        // register BOX
    // from rt_bih_ray: {org sW, back, flat}, and 9 clocks later how fast, axis by axis
    input  wire [W+1:0]     place_i,
    input  wire             pace_valid_i,
    input  wire [$clog2(SLOTS)-1:0] pace_slot_i,
    input  wire [1:0]       pace_axis_i,    // 0 x, 1 y, 2 z
    input  wire [`RT_BIH_G+6:0] pace_i,     // {open, shift u6, g}
    // to rt_bih_stack
    output reg              span_valid_o,
    output reg [$clog2(SLOTS)-1:0] span_slot_o,
    output reg [2*TW-1:0]   span_o          // {hi, lo}
);
    localparam SLOTW = $clog2(SLOTS);
    localparam CW = W + 2, GW = `RT_BIH_G, STEP = `RT_BIH_STEP_LATENCY;
    wire [W+1:0]     place;
    wire signed [CW-1:0] above = pace_axis_i[1] ? box_i[5*CW +: CW]
                             : pace_axis_i[0] ? box_i[4*CW +: CW] : box_i[3*CW +: CW];
    wire signed [CW-1:0] below = pace_axis_i[1] ? box_i[2*CW +: CW]
                             : pace_axis_i[0] ? box_i[CW +: CW] : box_i[0 +: CW];
    wire             back, near, far;
    wire [TW-1:0]    upper, lower;
    rt_delay #(.WIDTH(W+2), .CYCLES(9)) u_place (.clk(clk), .in_i(place_i), .out_o(place));
    rt_bih_step #(.W(W)) u_step (
        .clk(clk),
        .in_org_i($signed(place[W+1:2])), .in_back_i(place[1]), .in_flat_i(place[0]),
        .in_open_i(pace_i[GW+6]), .in_shift_i(pace_i[GW +: 6]), .in_g_i(pace_i[GW-1:0]),
        .in_clip_l_i(above), .in_clip_r_i(below),
        .out_back_o(back), .out_near_o(near), .out_far_o(far),
        .out_upper_o(upper), .out_lower_o(lower)
    );
    wire             s5_valid;
    wire [SLOTW-1:0] s5_slot;
    wire [1:0]       s5_axis;
    rt_delay_valid #(.CYCLES(STEP)) u_valid (
        .clk(clk), .rst(rst), .in_i(pace_valid_i), .out_o(s5_valid)
    );
    rt_delay #(.WIDTH(SLOTW+2), .CYCLES(STEP)) u_side (
        .clk(clk), .in_i({pace_slot_i, pace_axis_i}), .out_o({s5_slot, s5_axis})
    );

    // ---- all axes so far ----
    wire [TW-1:0]    hi = s5_axis == 2'd0 ? {TW{1'b1}} : span_o[2*TW-1:TW];
    wire [TW-1:0]    lo = s5_axis == 2'd0 ? {TW{1'b0}} : span_o[TW-1:0];
    wire             met = near && far;
    always @(posedge clk) begin
        span_valid_o <= s5_valid && s5_axis[1];
        span_slot_o  <= s5_slot;
        span_o       <= {!met ? {TW{1'b0}} : upper < hi ? upper : hi,
                         !met ? {TW{1'b1}} : lower > lo ? lower : lo};
        if (rst) span_valid_o <= 1'b0;
    end
    wire unused = back;
endmodule
`default_nettype wire
