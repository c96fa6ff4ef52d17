// f_dual_ram.v - stands for rt_dual_ram in proofs: one marked word, any other reads as anything
// SPDX-License-Identifier: Apache-2.0
// What holds with this holds with the memory, whose reads it allows all, as f_slot_file.v has it.
`timescale 1ns / 1ps
`default_nettype none
module rt_dual_ram #(
    parameter WIDTH = 32,
    parameter SLOTS = 16,
    parameter AB    = $clog2(SLOTS)
) (
    input  wire             wr_clk,
    input  wire             wr_en_i,
    input  wire [AB-1:0]    wr_addr_i,
    input  wire [WIDTH-1:0] wr_data_i,
    input  wire             rd_clk,
    input  wire             rd_en_i,
    input  wire [AB-1:0]    rd_addr_i,
    output reg  [WIDTH-1:0] rd_data_o
);
    (* anyconst *) wire [AB-1:0]    mark;
    (* anyseq *)   wire [WIDTH-1:0] other;
    reg [WIDTH-1:0] word_q;
    always @(posedge wr_clk) if (wr_en_i && wr_addr_i == mark) word_q <= wr_data_i;
    always @(posedge rd_clk) if (rd_en_i) rd_data_o <= rd_addr_i == mark ? word_q : other;
endmodule
`default_nettype wire
