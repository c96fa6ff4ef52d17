// f_totals.v - proof of rt_totals: a snapshot has every counter as it was in the clock of its turn
// SPDX-License-Identifier: Apache-2.0
// Followed are one word of the snapshot, which the solver chooses, and the counter behind it: one
// of the core, whose value comes a clock after its number, or one of the buses and the display,
// of which READ_BEATS, WRITE_PIXELS and UNDERRUNS are counted here too. Events come in any clock.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_top.vh"
module f_totals (
    input wire        clk,
    input wire        rst,
    input wire        snap,
    input wire [6:0]  read_addr,
    input wire [47:0] count_data,
    input wire        frame,
    input wire        clear,
    input wire [1:0]  read,
    input wire [1:0]  write,
    input wire [3:0]  pixels,
    input wire        swap,
    input wire        again,
    input wire        lost,
    input wire        underrun
);
    localparam OWN = `RT_TOP_COUNTS - 32;
    localparam [6:0] ALL = `RT_TOP_COUNTS;
    wire busy;
    wire [31:0] read_data;
    wire [4:0]  count_addr;
    rt_totals u_dut (
        .clk(clk), .rst(rst), .snap_i(snap), .busy_o(busy), .read_addr_i(read_addr),
        .read_data_o(read_data), .count_addr_o(count_addr), .count_data_i(count_data),
        .frame_i(frame), .clear_i(clear), .read_i(read), .write_i(write), .pixels_i(pixels),
        .swap_i(swap), .again_i(again), .lost_i(lost), .underrun_i(underrun)
    );
    (* hierconn *) wire [32*OWN-1:0] \u_dut.total_q ;
    (* hierconn *) wire [1:0]  \u_dut.read_q , \u_dut.write_q ;
    (* hierconn *) wire [3:0]  \u_dut.pixels_q ;
    (* hierconn *) wire        \u_dut.underrun_q , \u_dut.frame_q , \u_dut.clear_q ;
    (* hierconn *) wire [5:0]  \u_dut.at_q ;
    (* hierconn *) wire [5:0]  \u_dut.put_q ;
    (* hierconn *) wire        \u_dut.run_q ;
    (* hierconn *) wire        \u_dut.wait_q ;
    (* hierconn *) wire        \u_dut.put_valid_q ;
    (* hierconn *) wire [5:0]  \u_dut.u_shown.mark ;
    (* hierconn *) wire [47:0] \u_dut.u_shown.word_q ;

    // ---- model ----
    wire [5:0]  me   = \u_dut.u_shown.mark ;
    wire [5:0]  own  = me - 6'd32;
    reg         old_q = 1'b0, taken_q, run_q;
    reg  [6:0]  step_q;                   // clocks of a snapshot; 64 before it after rst; 0: none
    reg  [6:0]  wait_q;                   // clocks after rst, 64: no longer
    reg  [31:0] beats_q, pixels_q, underruns_q;
    reg         beat_q, written_q, underrun_q, frame_q, clear_q;   // a clock ago
    reg  [3:0]  group_q;
    reg  [47:0] value_q;                  // the word
    wire        turn = step_q == {1'b0, me} + 7'd2;    // the counter stands there, to be written
    wire [47:0] now  = me[5] ? {16'd0, \u_dut.total_q [32*own[3:0] +: 32]} : count_data;
    always @(posedge clk) begin
        old_q <= 1'b1;
        if (wait_q != 64) wait_q <= wait_q + 1;
        if (wait_q == 63) step_q <= 1;
        if (step_q != 0) step_q <= step_q == ALL + 1 ? 0 : step_q + 1;
        if (snap && !busy) step_q <= 1;
        if (turn) value_q <= now;
        taken_q <= taken_q || turn;
        {beat_q, written_q, underrun_q, frame_q, clear_q} <=
            {read[1], write[0], underrun, frame, clear};
        group_q     <= pixels;
        beats_q     <= frame_q ? 0 : beats_q + beat_q;
        pixels_q    <= frame_q ? 0 : pixels_q + (written_q ? group_q : 0);
        underruns_q <= clear_q ? 0 : underruns_q + underrun_q;
        if (rst) {beats_q, pixels_q, underruns_q, step_q, wait_q, taken_q} <= 0;
        if (rst) {beat_q, written_q, underrun_q} <= 0;
    end
    always @* begin
        if (!old_q) assume (rst);
        assume (me < ALL);
    end

    always @* if (old_q) begin
        assert (busy == (wait_q != 64 || step_q != 0));          // and ends
        if (step_q != 0 && step_q <= 32) assert (count_addr == step_q - 1);
        if (taken_q && read_addr == {me, 1'b0}) assert (read_data == value_q[31:0]);
        if (taken_q && read_addr == {me, 1'b1}) assert (read_data == {16'd0, value_q[47:32]});
        if (read_addr[6:1] >= ALL) assert (read_data == 0);
        if (wait_q == 64 && step_q == 0) assert (taken_q);       // rst brought the first one
        assert (\u_dut.total_q [32*(`RT_TOP_COUNT_READ_BEATS - 32) +: 32] == beats_q);
        assert (\u_dut.total_q [32*(`RT_TOP_COUNT_WRITE_PIXELS - 32) +: 32] == pixels_q);
        assert (\u_dut.total_q [32*(`RT_TOP_COUNT_UNDERRUNS - 32) +: 32] == underruns_q);
        // invariant
        assert (\u_dut.read_q [1] == beat_q && \u_dut.write_q [0] == written_q);
        assert (\u_dut.underrun_q == underrun_q && \u_dut.pixels_q == group_q);
        assert (\u_dut.frame_q == frame_q && \u_dut.clear_q == clear_q);
        assert (wait_q <= 64 && step_q <= ALL + 1 && (wait_q == 64 || step_q == 0));
        assert (\u_dut.wait_q == (wait_q != 64));
        assert (\u_dut.run_q == (step_q != 0 && step_q <= ALL));
        if (wait_q != 0) assert (\u_dut.put_valid_q == (step_q >= 2)); // rst may cut one off
        if (wait_q != 64) assert (\u_dut.at_q == wait_q);
        if (\u_dut.run_q ) assert (\u_dut.at_q == step_q - 1);
        if (step_q >= 2) assert (\u_dut.put_q == step_q - 2);
        if (!busy) assert (\u_dut.at_q == 0 || \u_dut.at_q == 1);
        if (taken_q) assert (\u_dut.u_shown.word_q == value_q && wait_q == 64);
        if (wait_q == 64 && (step_q == 0 || step_q > me + 2)) assert (taken_q);
    end
endmodule
`default_nettype wire
