// f_any_box.v - stands for rt_box in proofs of what is around it: says anything
// SPDX-License-Identifier: Apache-2.0
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_box #(
    parameter W  = 16,
    parameter TW = `RT_BIH_T
) (
    input  wire                 clk,
    input  wire [3*(W+2)-1:0]   in_places_i,
    input  wire [3*(`RT_BIH_G+7)-1:0] in_paces_i,
    input  wire [3*(W+2)-1:0]   in_lo_i,
    input  wire [3*(W+2)-1:0]   in_hi_i,
    input  wire [14:0]          in_limit_i,
    output wire                 out_pass_o,
    output wire [14:0]          out_near_o
);
    (* anyseq *) wire [15:0] any;
    assign {out_pass_o, out_near_o} = any;
endmodule
`default_nettype wire
