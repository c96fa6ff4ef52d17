// rt_counters.v - the work counters of the core
// SPDX-License-Identifier: Apache-2.0
// Events gather in a small sum per counter that starts again from 0 when it is full; one sum a
// cycle, in turn, becomes the low bits of its 48-bit total, whose high bits grow by one if the sum
// is less than it was: compared in one clock, added and, if it is another one, written in the
// next. A total is complete PLACES + 2 cycles after the last event; clear_i takes as long.
// Numbers: machine.def. data_o is the total addressed one cycle before.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_counters #(
    parameter PLACES = 16,        // counters from here on read as 0: 16 or 32
    parameter MOST   = 63,        // events of a counter in a cycle, 7 or 63
    parameter USED   = PLACES < `RT_COUNTERS ? PLACES : `RT_COUNTERS  // those that count
) (
    input  wire                clk,
    input  wire                rst,
    input  wire                clear_i,
    input  wire [8*PLACES-1:0] add_i,  // counter i: u8 at 8*i, at most MOST events of this cycle
    input  wire [4:0]          addr_i,
    output reg  [47:0]         data_o
);
    localparam AB = $clog2(PLACES);
    localparam MB = $clog2(MOST + 1);
    localparam SW = AB + MB;      // less than PLACES cycles of MOST + 1 events
    localparam [AB:0] ALL = {1'b1, {AB{1'b0}}};  // PLACES
    reg [AB-1:0] turn_q;
    reg [AB:0]   clear_q;         // totals that still start anew
    wire         clearing = clear_q != {(AB+1){1'b0}};

    // ---- sums ----
    wire [SW*USED-1:0] sums;
    genvar c;
    generate
        for (c = 0; c < USED; c = c + 1) begin : g_sum
            reg [SW-1:0] sum_q;
            wire         now = turn_q == c;
            always @(posedge clk) begin
                if (|add_i[8*c +: MB]) sum_q <= sum_q + {{AB{1'b0}}, add_i[8*c +: MB]};
                if (clear_i || rst) sum_q <= {SW{1'b0}};
            end
            assign sums[SW*c +: SW] = now ? sum_q : {SW{1'b0}};
        end
    endgenerate
    reg [SW-1:0] sum, sum_q;
    integer i;
    always @* begin
        sum = {SW{1'b0}};
        for (i = 0; i < USED; i = i + 1) sum = sum | sums[SW*i +: SW];
    end

    // ---- totals ----
    wire [47:0] total, shown;
    reg  [AB-1:0] total_q;          // the counter whose sum was taken a clock before
    reg  [AB-1:0] s2_at_q;          // the counter whose total is written
    reg         s2_carry_q, s2_write_q;
    reg  [47:SW]  s2_high_q;
    reg  [SW-1:0] s2_sum_q;
    wire [47:0] total_next = {s2_high_q + {{(47-SW){1'b0}}, s2_carry_q}, s2_sum_q};
    rt_slot_file #(.WIDTH(48), .SLOTS(PLACES)) u_total (
        .clk(clk), .wr_en_i(s2_write_q), .wr_addr_i(s2_at_q), .wr_data_i(total_next),
        .rd_addr_i(total_q), .rd_data_o(total)
    );
    rt_slot_file #(.WIDTH(48), .SLOTS(PLACES)) u_shown (
        .clk(clk), .wr_en_i(s2_write_q), .wr_addr_i(s2_at_q), .wr_data_i(total_next),
        .rd_addr_i(addr_i[AB-1:0]), .rd_data_o(shown)
    );
    always @(posedge clk) begin
        turn_q  <= turn_q + 1'b1;
        total_q <= turn_q;
        sum_q   <= clear_i || rst ? {SW{1'b0}} : sum;
        s2_at_q    <= total_q;
        s2_write_q <= clearing || sum_q != total[SW-1:0];
        s2_carry_q <= !clearing && sum_q < total[SW-1:0];
        s2_high_q  <= clearing ? {(48-SW){1'b0}} : total[47:SW];
        s2_sum_q   <= sum_q;
        if (clearing) clear_q <= clear_q - 1'b1;
        if (clear_i || rst) clear_q <= ALL;
        if (rst) turn_q  <= {AB{1'b0}};
        if (rst) total_q <= {AB{1'b1}};   // or the last total would not start anew
        data_o <= shown;
        if (PLACES < 32 && addr_i[4]) data_o <= 48'd0;
    end

`ifndef SYNTHESIS
    integer e;
    always @(posedge clk)
        for (e = 0; e < USED; e = e + 1)
            if (!rst && !clear_i && {24'd0, add_i[8*e +: 8]} > MOST) begin
                $display("%m: %0d events of counter %0d", add_i[8*e +: 8], e);
                $finish;
            end
`endif
    wire unused = &{1'b0, add_i};
endmodule
`default_nettype wire
