// rt_sram.v - a model of compiled SRAM: replace it by the macro of a library, one size a generate
// SPDX-License-Identifier: Apache-2.0
// One write port, one registered read port, one clock; rd_data_o is held while rd_en_i is low. A
// read of the word that is being written gives x, here; the wrapper never asks for it. In test the
// read port is transparent; asleep it keeps its words and gives x; off it loses them.
`timescale 1ns / 1ps
`default_nettype none
module rt_sram #(
    parameter WIDTH = 32,                 // bits of a word
    parameter SLOTS = 16,                 // words
    parameter AB    = $clog2(SLOTS)       // address bits, derived: leave alone
) (
    input  wire             clk,
    input  wire             wr_en_i,
    input  wire [AB-1:0]    wr_addr_i,
    input  wire [WIDTH-1:0] wr_data_i,
    input  wire             rd_en_i,
    input  wire [AB-1:0]    rd_addr_i,
    output wire [WIDTH-1:0] rd_data_o,
    input  wire             test_i,       // scan: wr_data_i is at rd_data_o
    input  wire             sleep_i,      // words are kept, nothing is read or written
    input  wire             off_i         // words are lost
);
    reg [WIDTH-1:0] mem [0:SLOTS-1];
    reg [WIDTH-1:0] word_q;
    wire runs = !sleep_i && !off_i;
    integer i;
    always @(posedge clk) begin
        if (wr_en_i && runs) mem[wr_addr_i] <= wr_data_i;
        if (rd_en_i && runs) word_q <= mem[rd_addr_i];
        if (!runs || (rd_en_i && wr_en_i && rd_addr_i == wr_addr_i)) word_q <= {WIDTH{1'bx}};
        if (off_i) for (i = 0; i < SLOTS; i = i + 1) mem[i] <= {WIDTH{1'bx}};
    end
    assign rd_data_o = test_i ? wr_data_i : word_q;
endmodule
`default_nettype wire
