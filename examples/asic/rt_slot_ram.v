// rt_slot_ram.v - in the place of rtl/memory/rt_slot_ram.v: compiled SRAM with pins for test, power
// SPDX-License-Identifier: Apache-2.0
// Ports and promises are those of the file that it replaces. Of the macro behind it (rt_sram.v) it
// asks for less: a read of the word that is being written never happens. With OLD a write goes to
// the macro a clock later, and a read meanwhile takes the word that waits.
//   write --> [at_q, data_q] --> macro --> rd_data_o      read of at_q --> [word_q] --> rd_data_o
// Test and power pins stand in RT_SRAM_PINS: constants here, until a tool for test or UPF drives
// them. While a macro sleeps, active_o of the core has to be low.
`timescale 1ns / 1ps
`default_nettype none
`ifndef RT_SRAM_PINS
`define RT_SRAM_PINS .test_i(1'b0), .sleep_i(1'b0), .off_i(1'b0)
`endif
module rt_slot_ram #(
    parameter WIDTH = 32,                 // bits of a word
    parameter SLOTS = 16,                 // words, at least 2
    parameter OLD   = 1,                  // 1: collision reads the old word, 0: never collides
    parameter LUTS  = 0,                  // of FPGAs: not used here
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
    generate
        if (OLD == 0) begin : g_free
            rt_sram #(.WIDTH(WIDTH), .SLOTS(SLOTS)) u_sram (
                .clk(clk), .wr_en_i(wr_en_i), .wr_addr_i(wr_addr_i), .wr_data_i(wr_data_i),
                .rd_en_i(rd_en_i), .rd_addr_i(rd_addr_i), .rd_data_o(rd_data_o), `RT_SRAM_PINS
            );
        end else begin : g_old
            reg              waits_q, took_q;
            reg  [AB-1:0]    at_q;
            reg  [WIDTH-1:0] data_q, word_q;
            wire [WIDTH-1:0] word;
            wire             meets = waits_q && at_q == rd_addr_i;
            always @(posedge clk) begin
                waits_q <= wr_en_i;
                if (wr_en_i) {at_q, data_q} <= {wr_addr_i, wr_data_i};
                if (rd_en_i) took_q <= meets;
                if (rd_en_i && meets) word_q <= data_q;
            end
            rt_sram #(.WIDTH(WIDTH), .SLOTS(SLOTS)) u_sram (
                .clk(clk), .wr_en_i(waits_q), .wr_addr_i(at_q), .wr_data_i(data_q),
                .rd_en_i(rd_en_i && !meets), .rd_addr_i(rd_addr_i), .rd_data_o(word), `RT_SRAM_PINS
            );
            assign rd_data_o = took_q ? word_q : word;
        end
    endgenerate
    wire unused = &{1'b0, LUTS[0]};
endmodule
`default_nettype wire
