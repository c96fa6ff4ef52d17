// ODDRX1F.v - what the output register of an ECP5 does, for simulation: D0 while SCLK is high
// SPDX-License-Identifier: Apache-2.0
// Both bits are taken at the rising edge; D0 leaves with it, D1 with the falling edge.
// The part is some clocks later; all its pins are alike.
`timescale 1ns / 1ps
`default_nettype none
module ODDRX1F (
    input  wire SCLK,
    input  wire RST,
    input  wire D0,                       // first
    input  wire D1,
    output wire Q
);
    reg d0_q, d1_q;
    always @(posedge SCLK) begin
        d0_q <= D0 && !RST;
        d1_q <= D1 && !RST;
    end
    assign Q = SCLK ? d0_q : d1_q;
endmodule
`default_nettype wire
