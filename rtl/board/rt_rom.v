// rt_rom.v - words of a file in block RAM, read a clock later
// SPDX-License-Identifier: Apache-2.0
`timescale 1ns / 1ps
`default_nettype none
module rt_rom #(
    parameter WIDTH = 64,                 // bits of a word
    parameter WORDS = 1024,               // words
    parameter FILE  = "",                 // their values in hexadecimal; none: zeros
    parameter AB    = $clog2(WORDS)       // address bits, derived: leave alone
) (
    input  wire             clk,
    input  wire             en_i,         // else data_o stays
    input  wire [AB-1:0]    addr_i,
    output reg  [WIDTH-1:0] data_o
);
    (* ram_style = "block" *) reg [WIDTH-1:0] words_q [0:WORDS-1];
    generate if (FILE != "") begin : g_file
        initial $readmemh(FILE, words_q);
    end else begin : g_zero
        integer i;
        initial for (i = 0; i < WORDS; i = i + 1) words_q[i] = {WIDTH{1'b0}};
    end endgenerate
    always @(posedge clk) if (en_i) data_o <= words_q[addr_i];
endmodule
`default_nettype wire
