// rt_slot_file.v - memory with one write port and one asynchronous read port (distributed RAM)
// SPDX-License-Identifier: Apache-2.0
// Latency 0: rd_data_o follows rd_addr_i in the same cycle. A word written in cycle n is read from
// cycle n+1 on; in cycle n itself its address still reads the old word.
// Contents are not reset: write a word before its value matters.
// For a family whose memory has registered reads only, a file of FALLING bits and more is block RAM
// that is read at the falling edge: half a period behind what gives the address, and before what
// takes the word. So no address may follow from a word that another such file gives in that clock.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_memory.vh"
module rt_slot_file #(
    parameter WIDTH = 8,                  // bits of a word
    parameter SLOTS = 16,                 // words, at least 2
    parameter FALLING = `RT_FALLING_BITS, // 0: never; bits from which on it is read so
    parameter AB    = $clog2(SLOTS)       // address bits, derived: leave alone
) (
    input  wire             clk,
    input  wire             wr_en_i,      // write this cycle
    input  wire [AB-1:0]    wr_addr_i,
    input  wire [WIDTH-1:0] wr_data_i,
    input  wire [AB-1:0]    rd_addr_i,
    output wire [WIDTH-1:0] rd_data_o     // word at rd_addr_i now
);
    generate
        if (FALLING != 0 && WIDTH*SLOTS >= FALLING) begin : g_falling
            `RT_BLOCK_RAM_FREE reg [WIDTH-1:0] words [0:SLOTS-1];
            reg [WIDTH-1:0] word_q;
            always @(posedge clk) if (wr_en_i) words[wr_addr_i] <= wr_data_i;
            always @(negedge clk) word_q <= words[rd_addr_i];
            assign rd_data_o = word_q;
        end else begin : g_luts
            `RT_LUT_RAM reg [WIDTH-1:0] mem [0:SLOTS-1];
            assign rd_data_o = mem[rd_addr_i];
            always @(posedge clk) if (wr_en_i) mem[wr_addr_i] <= wr_data_i;
        end
    endgenerate
endmodule
`default_nettype wire
