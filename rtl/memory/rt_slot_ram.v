// rt_slot_ram.v - memory with one write port and one registered read port (block RAM)
// SPDX-License-Identifier: Apache-2.0
// Latency 1: rd_data_o is the word at rd_addr_i one cycle after rd_en_i, and is held while rd_en_i
// is low. Reading the address that is written in the same cycle gives the old word if OLD is 1
// (block RAM of some families needs a bypass for it: WIDTH flip-flops and LUTs); with OLD 0 the
// owner promises that it never happens, and a simulation stops if it does.
// Contents are not reset: write a word before its value matters.
`timescale 1ns / 1ps
`default_nettype none
module rt_slot_ram #(
    parameter WIDTH = 32,                 // bits of a word
    parameter SLOTS = 16,                 // words, at least 2
    parameter OLD   = 1,                  // 1: collision reads the old word, 0: never collides
    parameter AB    = $clog2(SLOTS)       // address bits, derived: leave alone
) (
    input  wire             clk,
    input  wire             wr_en_i,      // write this cycle
    input  wire [AB-1:0]    wr_addr_i,
    input  wire [WIDTH-1:0] wr_data_i,
    input  wire             rd_en_i,      // read this cycle
    input  wire [AB-1:0]    rd_addr_i,
    output reg  [WIDTH-1:0] rd_data_o     // word read last
);
    (* ram_style = "block" *) reg [WIDTH-1:0] mem [0:SLOTS-1];
    wire collision = wr_en_i && rd_en_i && wr_addr_i == rd_addr_i;
    always @(posedge clk) begin
        if (wr_en_i) mem[wr_addr_i] <= wr_data_i;
        if (rd_en_i) begin
            rd_data_o <= mem[rd_addr_i];
            // never happens; lets synthesis drop the bypass
            if (OLD == 0 && collision) rd_data_o <= {WIDTH{1'bx}};
        end
    end

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
