// small.v - the cells of small.lib, for Icarus
// SPDX-License-Identifier: Apache-2.0
`timescale 1ns / 1ps
module INV (input A, output Y); not (Y, A); endmodule
module BUF (input A, output Y); buf (Y, A); endmodule
module NAND2 (input A, B, output Y); nand (Y, A, B); endmodule
module AND2 (input A, B, output Y); and (Y, A, B); endmodule
module NOR2 (input A, B, output Y); nor (Y, A, B); endmodule
module XOR2 (input A, B, output Y); xor (Y, A, B); endmodule
module DFF (input CK, D, output reg Q); always @(posedge CK) Q <= D; endmodule
module RT_CLOCK_GATE (input en, clk, output gclk);
    reg open;
    always @* if (!clk) open = en;
    assign gclk = clk & open;
endmodule
