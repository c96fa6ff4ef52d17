// rt_slot_ram.v - memory with one write port and one registered read port (block RAM)
// SPDX-License-Identifier: Apache-2.0
// Latency 1: rd_data_o is the word at rd_addr_i one cycle after rd_en_i, and is held while rd_en_i
// is low. Reading the address that is written in the same cycle gives the old word if OLD is 1
// (block RAM of some families needs a bypass for it: WIDTH flip-flops and LUTs); with OLD 0 the
// owner promises that it never happens, and a simulation stops if it does.
// The bits that blocks of 36 leave over lie in a rt_slot_file if LUTS cells hold them.
// Contents are not reset: write a word before its value matters.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_memory.vh"
module rt_slot_ram #(
    parameter WIDTH = 32,                 // bits of a word
    parameter SLOTS = 16,                 // words, at least 2
    parameter OLD   = 1,                  // 1: collision reads the old word, 0: never collides
    parameter LUTS  = 0,                  // cells of 16 x 4 bits that a block is worth
    parameter AB    = $clog2(SLOTS)       // address bits, derived: leave alone
) (
    input  wire             clk,
    input  wire             wr_en_i,      // write this cycle
    input  wire [AB-1:0]    wr_addr_i,
    input  wire [WIDTH-1:0] wr_data_i,
    input  wire             rd_en_i,      // read this cycle
    input  wire [AB-1:0]    rd_addr_i,
    output wire [WIDTH-1:0] rd_data_o     // word read last
);
    localparam LEFT  = WIDTH % 36;
    localparam CELLS = ((SLOTS + 15) / 16) * ((LEFT + 3) / 4);
    localparam LOW   = CELLS <= LUTS ? LEFT : 0;  // bits in LUTs, the low ones
    wire collision = wr_en_i && rd_en_i && wr_addr_i == rd_addr_i;
    generate
        if (LOW < WIDTH && OLD != 0) begin : g_old
            `RT_BLOCK_RAM reg [WIDTH-1:LOW] mem [0:SLOTS-1];
            reg [WIDTH-1:LOW] word_q;
            always @(posedge clk) begin
                if (wr_en_i) mem[wr_addr_i] <= wr_data_i[WIDTH-1:LOW];
                if (rd_en_i) word_q <= mem[rd_addr_i];
            end
            assign rd_data_o[WIDTH-1:LOW] = word_q;
        end else if (LOW < WIDTH) begin : g_free
            `RT_BLOCK_RAM_FREE reg [WIDTH-1:LOW] mem [0:SLOTS-1];
            reg [WIDTH-1:LOW] word_q;
            always @(posedge clk) begin
                if (wr_en_i) mem[wr_addr_i] <= wr_data_i[WIDTH-1:LOW];
                if (rd_en_i) word_q <= mem[rd_addr_i];
            end
            assign rd_data_o[WIDTH-1:LOW] = word_q;
        end
        if (LOW != 0) begin : g_luts
            wire [LOW-1:0] word;
            reg  [LOW-1:0] word_q;
            rt_slot_file #(.WIDTH(LOW), .SLOTS(SLOTS)) u_low (
                .clk(clk), .wr_en_i(wr_en_i), .wr_addr_i(wr_addr_i),
                .wr_data_i(wr_data_i[LOW-1:0]), .rd_addr_i(rd_addr_i), .rd_data_o(word)
            );
            always @(posedge clk) if (rd_en_i) word_q <= word;
            assign rd_data_o[LOW-1:0] = word_q;
        end
    endgenerate

`ifdef FORMAL
    always @(posedge clk) if (OLD == 0) assert (!collision);
`else
`ifndef SYNTHESIS
    always @(posedge clk) if (OLD == 0 && collision) begin
        $display("%m: word %0d read while it is written", rd_addr_i);
        $finish;
    end
`endif
`endif
endmodule
`default_nettype wire
