// f_any_ray.v - stands for rt_bih_ray in proofs of what is done with rays that stand in memory
// SPDX-License-Identifier: Apache-2.0
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_bih_ray #(
    parameter W      = 16,
    parameter WD     = 17,
    parameter SLOTS  = 32,
    parameter SHADOW = 1
) (
    input  wire                     clk,
    input  wire                     rst,
    input  wire                     new_valid_i,
    input  wire [$clog2(SLOTS)-1:0] new_slot_i,
    input  wire [3*W-1:0]           new_org_i,
    input  wire [3*WD-1:0]          new_dir_i,
    input  wire [2*WD-1:0]          new_a_i,
    input  wire                     go_valid_i,
    input  wire [$clog2(SLOTS)-1:0] go_slot_i,
    input  wire                     go_pixel_i,
    input  wire                     shadow_go_i,
    input  wire [$clog2(SLOTS)-1:0] shadow_slot_i,
    output wire                     place_valid_o,
    output wire [$clog2(SLOTS)-1:0] place_slot_o,
    output wire [1:0]               place_axis_o,
    output wire [W+1:0]             place_o,
    output wire                     pace_valid_o,
    output wire [$clog2(SLOTS)-1:0] pace_slot_o,
    output wire [1:0]               pace_axis_o,
    output wire [`RT_BIH_G+6:0]     pace_o,
    output wire                     start_valid_o,
    input  wire                     start_ready_i,
    output wire [$clog2(SLOTS)-1:0] start_slot_o,
    output wire                     start_pixel_o
);
    assign {place_valid_o, place_slot_o, place_axis_o, place_o, pace_valid_o, pace_slot_o,
            pace_axis_o, pace_o, start_valid_o, start_slot_o, start_pixel_o} = 0;
endmodule
`default_nettype wire
