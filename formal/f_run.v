// f_run.v - proof of rt_run: each START is refused or ends once; no frame with an error counts
// SPDX-License-Identifier: Apache-2.0
// Orders, the core, the frame store and the buses do what they like in any clock.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_top.vh"
module f_run (
    input wire        clk,
    input wire        rst,
    input wire [7:0]  order,
    input wire [31:0] limit,
    input wire        loading,
    input wire        core_busy,
    input wire [`RT_ERRORS-1:0] core_errors,
    input wire        room,
    input wire        read_idle,
    input wire        read_stall,
    input wire [1:0]  read_errors,
    input wire        write_empty,
    input wire        write_idle,
    input wire        write_stall,
    input wire [1:0]  write_errors,
    input wire        scan_error,
    input wire        scan_stall
);
    wire [15:0] errors;
    wire done, busy, draining, waiting, load, core_rst, core_start, core_keep, clear, begins, ends,
         good, cut, forget, write_dead, flush;
    rt_run u_dut (
        .clk(clk), .rst(rst), .order_i(order), .limit_i(limit), .errors_o(errors), .done_o(done),
        .busy_o(busy), .draining_o(draining), .waiting_o(waiting), .load_o(load),
        .loading_i(loading), .core_rst_o(core_rst), .core_start_o(core_start),
        .core_keep_o(core_keep), .core_busy_i(core_busy), .core_errors_i(core_errors),
        .room_i(room), .clear_o(clear), .begin_o(begins), .end_o(ends), .good_o(good),
        .cut_o(cut), .forget_o(forget), .read_idle_i(read_idle),
        .read_stall_i(read_stall), .read_errors_i(read_errors), .write_dead_o(write_dead),
        .flush_o(flush), .write_empty_i(write_empty), .write_idle_i(write_idle),
        .write_stall_i(write_stall), .write_errors_i(write_errors), .scan_error_i(scan_error),
        .scan_stall_i(scan_stall)
    );
    (* hierconn *) wire [2:0] \u_dut.state_q ;
    (* hierconn *) wire       \u_dut.bad_q ;
    (* hierconn *) wire       \u_dut.halt_q ;
    (* hierconn *) wire [1:0] \u_dut.dead_q ;
    (* hierconn *) wire       \u_dut.keep_q ;
    (* hierconn *) wire       \u_dut.silent_q ;
    (* hierconn *) wire [31:0] \u_dut.read_q ;
    (* hierconn *) wire [31:0] \u_dut.write_q ;
    (* hierconn *) wire [31:0] \u_dut.scan_q ;
    wire read_dead = \u_dut.dead_q [0];
    wire start  = order[`RT_TOP_CONTROL_START];
    wire anew   = order[`RT_TOP_CONTROL_SOFT_RESET];
    wire stop   = anew || (order[`RT_TOP_CONTROL_STOP] && (busy || draining));
    wire late   = errors[`RT_TOP_ERRORS_WATCHDOG];
    wire told   = errors[`RT_TOP_ERRORS_SCAN_WATCHDOG];

    // ---- model: a frame, its errors, its caches; a silence of the display's bus ----
    reg old_q = 1'b0, frame_q, begun_q, drain_q, bad_q, keep_q, told_q, quiet_q, dead_q, ended_q,
        calm_q;
    always @(posedge clk) begin
        old_q   <= 1'b1;
        frame_q <= (frame_q || load) && !done;
        begun_q <= begins;
        if (begins) bad_q <= 1'b0;
        else if (|read_errors || |write_errors || late) bad_q <= 1'b1;
        if (load) keep_q <= order[`RT_TOP_CONTROL_KEEP_CACHE];
        told_q  <= scan_stall && !forget && (told_q || told);
        drain_q <= draining;
        calm_q  <= !busy && !draining && !load && !anew;
        quiet_q <= read_idle && write_idle;
        dead_q  <= read_dead || write_dead;
        ended_q <= rst || forget || (draining && read_idle && write_idle);
        if (rst) {frame_q, begun_q, drain_q, told_q, dead_q, calm_q} <= 6'd0;
    end
    always @* if (!old_q) assume (rst);

    // ---- model: clocks in which a bus did not move, as many as 32 bits count ----
    function [31:0] silence(input stalls, input [31:0] so_far);
        silence = !stalls || rst || forget ? 32'd0 : so_far == 32'hffffffff ? so_far : so_far + 1;
    endfunction
    reg [31:0] reads_q, writes_q, scans_q;
    always @(posedge clk) begin
        reads_q  <= silence(read_stall, reads_q);
        writes_q <= silence(write_stall, writes_q);
        scans_q  <= silence(scan_stall, scans_q);
    end
    wire read_late  = limit != 0 && reads_q >= limit && busy && !read_dead;
    wire write_late = limit != 0 && writes_q >= limit && busy && !write_dead;

    always @* if (old_q && !rst) begin
        assert (busy == frame_q && !(busy && draining));         // of a START until its end
        if (done) assert (frame_q);                              // which comes once
        if (start) assert (load != errors[`RT_TOP_ERRORS_REFUSED]);
        if (load) assert (start && !stop && !frame_q && !draining && !read_dead && !write_dead);
        if (core_start) assert (begun_q && core_keep == keep_q);
        if (begins) assert (frame_q && room && !stop);
        if (ends && good) assert (!bad_q && core_errors == 0);   // a frame without any error
        if (stop && frame_q) assert (done && !ends);
        assert (core_rst == (draining || read_dead) && cut == draining);
        if (drain_q && !draining) assert (quiet_q);              // the buses owe nothing
        if (calm_q) assert (!busy && !draining);                 // a STOP is of a frame alone
        if (dead_q && !ended_q) assert (read_dead || write_dead); // given up until they do
        if (told_q) assert (!told);                              // a silence is told once
        assert (late == (read_late || write_late));              // and at its limit
        assert (told == (limit != 0 && scans_q >= limit && !told_q));
        // invariant
        assert (\u_dut.bad_q == bad_q || !(frame_q && \u_dut.state_q >= 3));
        assert (\u_dut.keep_q == keep_q || !frame_q);
        assert (\u_dut.silent_q == told_q);
        assert (\u_dut.read_q == reads_q && \u_dut.write_q == writes_q);
        assert (\u_dut.scan_q == scans_q);
        assert (\u_dut.halt_q == (draining || read_dead));
        assert (begun_q == (\u_dut.state_q == 3) || drain_q || draining);
    end
endmodule
`default_nettype wire
