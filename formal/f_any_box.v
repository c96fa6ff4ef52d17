// f_any_box.v - stand for rt_box_axis and rt_box in proofs of what is around them: say anything
// SPDX-License-Identifier: Apache-2.0
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_box_axis #(
    parameter W  = 16,
    parameter SW = `RT_BOX_CROSS + 9
) (
    input  wire                 clk,
    input  wire [13:0]          in_org_i,
    input  wire [3:0]           in_step_i,
    input  wire [W+1:0]         in_place_i,
    input  wire [`RT_BIH_G+6:0] in_pace_i,
    output wire signed [SW-1:0] out_enter_o,
    output wire signed [SW-1:0] out_leave_o,
    output wire                 out_fine_o,
    output wire                 out_flat_o,
    output wire                 out_open_o,
    output wire [`RT_BOX_CROSS-1:0] step_o,
    output wire [`RT_BOX_CROSS:0] more_o,
    output wire                 back_o
);
    (* anyseq *) wire [2*SW+2*`RT_BOX_CROSS+4:0] any;
    assign {out_enter_o, out_leave_o, out_fine_o, out_flat_o, out_open_o, step_o, more_o,
            back_o} = any;
endmodule
module rt_box #(
    parameter SW = `RT_BOX_CROSS + 9
) (
    input  wire                       clk,
    input  wire [20:0]                in_near_i,
    input  wire [20:0]                in_far_i,
    input  wire [3*`RT_BOX_CROSS-1:0] in_step_i,
    input  wire [3*`RT_BOX_CROSS+2:0] in_more_i,
    input  wire [3*SW-1:0]            late_enter_i,
    input  wire [3*SW-1:0]            late_leave_i,
    input  wire [2:0]                 late_fine_i,
    input  wire [2:0]                 late_flat_i,
    input  wire [2:0]                 late_open_i,
    input  wire [14:0]                in_limit_i,
    output wire                       out_pass_o,
    output wire [14:0]                out_near_o
);
    (* anyseq *) wire [15:0] any;
    assign {out_pass_o, out_near_o} = any;
endmodule
`default_nettype wire
