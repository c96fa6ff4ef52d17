// f_slot_ram.v - stands for rt_slot_ram in proofs: one marked word, any other reads as anything
// SPDX-License-Identifier: Apache-2.0
// As f_slot_file.v. What OLD = 0 promises, no read of a word that is written, is to be proved.
`timescale 1ns / 1ps
`default_nettype none
module rt_slot_ram #(
    parameter WIDTH = 32,
    parameter SLOTS = 16,
    parameter OLD   = 1,
    parameter LUTS  = 0,
    parameter AB    = $clog2(SLOTS)
) (
    input  wire             clk,
    input  wire             wr_en_i,
    input  wire [AB-1:0]    wr_addr_i,
    input  wire [WIDTH-1:0] wr_data_i,
    input  wire             rd_en_i,
    input  wire [AB-1:0]    rd_addr_i,
    output reg  [WIDTH-1:0] rd_data_o
);
    (* anyconst *) wire [AB-1:0]    mark;
    (* anyseq *)   wire [WIDTH-1:0] other;
    reg [WIDTH-1:0] word_q;
    reg             old_q = 1'b0;        // a clock has passed, that of the reset
    wire writes = wr_en_i && wr_addr_i == mark;
    always @(posedge clk) begin
        old_q <= 1'b1;
        if (writes)  word_q <= wr_data_i;
        if (rd_en_i) rd_data_o <= rd_addr_i == mark ? word_q : other;
    end
    always @* if (OLD == 0 && old_q) assert (!(writes && rd_en_i && rd_addr_i == mark));
endmodule
`default_nettype wire
