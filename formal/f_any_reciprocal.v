// f_any_reciprocal.v - stands for rt_reciprocal in proofs: any number
// SPDX-License-Identifier: Apache-2.0
`timescale 1ns / 1ps
`default_nettype none
module rt_reciprocal (
    input  wire        clk,
    input  wire [21:0] top_i,
    input  wire        more_i,
    output wire [21:0] y_o
);
    (* anyseq *) wire [21:0] any;
    assign y_o = any;
endmodule
`default_nettype wire
