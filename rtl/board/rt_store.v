// rt_store.v - a frame in block RAM: 64-bit words, written in parts of 16 bits, read a clock later
// SPDX-License-Identifier: Apache-2.0
// One memory for each part, so that each has one enable; a word that is written and read in one
// clock reads as it was or as it is.
`timescale 1ns / 1ps
`default_nettype none
module rt_store #(
    parameter WORDS = 19200,              // words
    parameter AB    = $clog2(WORDS)       // address bits, derived: leave alone
) (
    input  wire          clk,
    input  wire [3:0]    we_i,            // which parts are written
    input  wire [AB-1:0] wr_addr_i,
    input  wire [63:0]   wr_data_i,
    input  wire          en_i,            // else data_o stays
    input  wire [AB-1:0] rd_addr_i,
    output wire [63:0]   data_o
);
    genvar i;
    generate for (i = 0; i < 4; i = i + 1) begin : g_part
        (* ram_style = "block", no_rw_check *) reg [15:0] words_q [0:WORDS-1];
        reg [15:0] data_q;
        always @(posedge clk) if (we_i[i]) words_q[wr_addr_i] <= wr_data_i[16*i +: 16];
        always @(posedge clk) if (en_i) data_q <= words_q[rd_addr_i];
        assign data_o[16*i +: 16] = data_q;
    end endgenerate
endmodule
`default_nettype wire
