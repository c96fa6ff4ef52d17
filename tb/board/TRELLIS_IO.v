// TRELLIS_IO.v - what a pin of both directions of an ECP5 does, for simulation
// SPDX-License-Identifier: Apache-2.0
// Yosys, which only reads this, knows no pin that is not driven.
`timescale 1ns / 1ps
`default_nettype none
// verilator lint_off UNUSEDPARAM
module TRELLIS_IO #(
    parameter DIR = "BIDIR"
) (
    input  wire I,
    input  wire T,                        // high: it does not drive
    output wire O,
    inout  wire B
);
`ifdef YOSYS
    assign B = I && !T;
`else
    assign B = T ? 1'bz : I;
`endif
    assign O = B;
endmodule
`default_nettype wire
