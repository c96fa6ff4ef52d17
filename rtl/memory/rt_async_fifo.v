// rt_async_fifo.v - queue between two clocks, first word falls through
// SPDX-License-Identifier: Apache-2.0
//   wr --> [RAM] --> [output register] --> rd       wr_gray --> [2 flip-flops] --> rd
//                                        rd_gray --> [2 flip-flops] --> binary --> wr
// Pointers cross in Gray code: one bit changes at a time, so a sample is the old or the new one. A
// word is at the output 3 to 4 edges of rd_clk after its push; its room comes back 3 to 4 edges of
// wr_clk after it went to the output register. Then a push and a pop every clock.
// Both resets together (rt_reset_pair): a reset of one side alone makes words of nothing.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
module rt_async_fifo #(
    parameter WIDTH = 8,                  // bits of a word
    parameter DEPTH = 16                  // words in the RAM, a power of two, at least 4
) (
    // from the producer, in wr_clk
    input  wire             wr_clk,
    input  wire             wr_rst,       // synchronous to wr_clk, active high
    input  wire             wr_valid_i,
    output wire             wr_ready_o,   // there is room
    input  wire [WIDTH-1:0] wr_data_i,
    output wire [$clog2(DEPTH):0] wr_count_o, // words that may still be inside
    // to the consumer, in rd_clk
    input  wire             rd_clk,
    input  wire             rd_rst,       // synchronous to rd_clk, active high
    output reg              rd_valid_o,
    input  wire             rd_ready_i,
    output wire [WIDTH-1:0] rd_data_o
);
    localparam AB = $clog2(DEPTH);        // address bits
    `RT_CHECK(DEPTH >= 4 && DEPTH == (1 << AB), rt_async_fifo_DEPTH_must_be_a_power_of_two_above_3)

    // ---- write side: pointer of one bit more than the address, and its Gray code ----
    reg  [AB:0] wr_q;                     // words pushed, modulo 2 DEPTH
    reg  [AB:0] wr_gray_q;
    wire [AB:0] wr_d = wr_q + 1'b1;
    wire [AB:0] rd_gray_s;                // of the reader, as it was
    reg  [AB:0] rd_s, rd_s_q;             // the same in binary; later by a clock
    wire        push  = wr_valid_i && wr_ready_o;
    assign wr_count_o = wr_q - rd_s_q;
    assign wr_ready_o = wr_count_o != DEPTH[AB:0];
    always @(posedge wr_clk) begin
        rd_s_q <= rd_s;
        if (push) begin
            wr_q      <= wr_d;
            wr_gray_q <= wr_d ^ (wr_d >> 1);
        end
        if (wr_rst) begin
            wr_q      <= {(AB+1){1'b0}};
            wr_gray_q <= {(AB+1){1'b0}};
            rd_s_q    <= {(AB+1){1'b0}};
        end
    end

    // ---- crossings ----
    reg  [AB:0] rd_gray_q;
    wire [AB:0] wr_gray_s;
    rt_sync #(.WIDTH(AB+1)) u_to_wr (.clk(wr_clk), .d_i(rd_gray_q), .q_o(rd_gray_s));
    rt_sync #(.WIDTH(AB+1)) u_to_rd (.clk(rd_clk), .d_i(wr_gray_q), .q_o(wr_gray_s));
    integer i;
    always @* begin                       // bit i is the parity of the Gray bits from i up
        rd_s[AB] = rd_gray_s[AB];
        for (i = AB - 1; i >= 0; i = i - 1) rd_s[i] = rd_s[i+1] ^ rd_gray_s[i];
    end

    // ---- read side: a word goes to the output register as soon as that is free ----
    reg  [AB:0] rd_q;                     // words taken out of the RAM, modulo 2 DEPTH
    wire [AB:0] rd_d  = rd_q + 1'b1;
    wire        fetch = wr_gray_s != rd_gray_q && (rd_ready_i || !rd_valid_o);
    always @(posedge rd_clk) begin
        if (fetch) begin
            rd_q      <= rd_d;
            rd_gray_q <= rd_d ^ (rd_d >> 1);
        end
        if (rd_ready_i || !rd_valid_o) rd_valid_o <= fetch;
        if (rd_rst) begin
            rd_q       <= {(AB+1){1'b0}};
            rd_gray_q  <= {(AB+1){1'b0}};
            rd_valid_o <= 1'b0;
        end
    end

    // ---- words ----
    rt_dual_ram #(.WIDTH(WIDTH), .SLOTS(DEPTH)) u_words (
        .wr_clk(wr_clk), .wr_en_i(push), .wr_addr_i(wr_q[AB-1:0]), .wr_data_i(wr_data_i),
        .rd_clk(rd_clk), .rd_en_i(fetch), .rd_addr_i(rd_q[AB-1:0]), .rd_data_o(rd_data_o)
    );
endmodule
`default_nettype wire
