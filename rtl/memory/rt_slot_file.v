// rt_slot_file.v - memory with one write port and one asynchronous read port (distributed RAM)
// SPDX-License-Identifier: Apache-2.0
// Latency 0: rd_data_o follows rd_addr_i in the same cycle. A word written in cycle n is read from
// cycle n+1 on; in cycle n itself its address still reads the old word.
// Contents are not reset: write a word before its value matters.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_memory.vh"
module rt_slot_file #(
    parameter WIDTH = 8,                  // bits of a word
    parameter SLOTS = 16,                 // words, at least 2
    parameter AB    = $clog2(SLOTS)       // address bits, derived: leave alone
) (
    input  wire             clk,
    input  wire             wr_en_i,      // write this cycle
    input  wire [AB-1:0]    wr_addr_i,
    input  wire [WIDTH-1:0] wr_data_i,
    input  wire [AB-1:0]    rd_addr_i,
    output wire [WIDTH-1:0] rd_data_o     // word at rd_addr_i now
);
    `RT_LUT_RAM reg [WIDTH-1:0] mem [0:SLOTS-1];
    assign rd_data_o = mem[rd_addr_i];
    always @(posedge clk) if (wr_en_i) mem[wr_addr_i] <= wr_data_i;
endmodule
`default_nettype wire
