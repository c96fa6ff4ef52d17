// rt_dual_ram.v - memory with a write port and a registered read port of different clocks
// SPDX-License-Identifier: Apache-2.0
// Latency 1 of rd_clk: rd_data_o is the word at rd_addr_i one edge after rd_en_i, and is held while
// rd_en_i is low. The owner never reads a word that is being written (rt_async_fifo: its pointers).
// Contents are not reset: write a word before its value matters.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_memory.vh"
module rt_dual_ram #(
    parameter WIDTH = 32,                 // bits of a word
    parameter SLOTS = 16,                 // words, at least 2
    parameter AB    = $clog2(SLOTS)       // address bits, derived: leave alone
) (
    // in wr_clk
    input  wire             wr_clk,
    input  wire             wr_en_i,      // write this cycle
    input  wire [AB-1:0]    wr_addr_i,
    input  wire [WIDTH-1:0] wr_data_i,
    // in rd_clk
    input  wire             rd_clk,
    input  wire             rd_en_i,      // read this cycle
    input  wire [AB-1:0]    rd_addr_i,
    output reg  [WIDTH-1:0] rd_data_o     // word read last
);
    `RT_BLOCK_RAM_FREE reg [WIDTH-1:0] mem [0:SLOTS-1];
    always @(posedge wr_clk) if (wr_en_i) mem[wr_addr_i] <= wr_data_i;
    always @(posedge rd_clk) if (rd_en_i) rd_data_o <= mem[rd_addr_i];
endmodule
`default_nettype wire
