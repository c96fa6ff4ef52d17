// IDDRX1F.v - what the input register of an ECP5 does, for simulation: both edges, out at the first
// SPDX-License-Identifier: Apache-2.0
// Q0 is D at the rising edge before, Q1 D at the falling edge between. Yosys, which only reads
// this, knows the falling edge as another clock's.
`timescale 1ns / 1ps
`default_nettype none
module IDDRX1F (
    input  wire D,
    input  wire SCLK,
    input  wire RST,
    output reg  Q0,                       // a clock late
    output reg  Q1                        // half a clock late
);
    reg rise_q, fall_q;
    always @(negedge SCLK) fall_q <= D && !RST;
    always @(posedge SCLK) begin
        rise_q <= D && !RST;
        Q0     <= rise_q;
        Q1     <= fall_q;
    end
endmodule
`default_nettype wire
