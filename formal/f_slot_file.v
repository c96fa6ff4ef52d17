// f_slot_file.v - stands for rt_slot_file in proofs: one marked word, any other reads as anything
// SPDX-License-Identifier: Apache-2.0
// What holds with this holds with the memory, whose reads it allows all: see f_memory.v. A proof
// about a memory of any size then needs to know of one word only.
`timescale 1ns / 1ps
`default_nettype none
module rt_slot_file #(
    parameter WIDTH = 8,
    parameter SLOTS = 16,
    parameter AB    = $clog2(SLOTS)
) (
    input  wire             clk,
    input  wire             wr_en_i,
    input  wire [AB-1:0]    wr_addr_i,
    input  wire [WIDTH-1:0] wr_data_i,
    input  wire [AB-1:0]    rd_addr_i,
    output wire [WIDTH-1:0] rd_data_o
);
    (* anyconst *) wire [AB-1:0]    mark;
    (* anyseq *)   wire [WIDTH-1:0] other;
    reg [WIDTH-1:0] word_q;
    assign rd_data_o = rd_addr_i == mark ? word_q : other;
    always @(posedge clk) if (wr_en_i && wr_addr_i == mark) word_q <= wr_data_i;
endmodule
`default_nettype wire
