// rt_totals.v - counters of the buses and of the display; the snapshot of all counters
// SPDX-License-Identifier: Apache-2.0
// snap_i copies the core's 32 counters and those of RT_TOP_COUNT_*, one a cycle, to a memory that
// is read at leisure; busy_o is high meanwhile, for RT_TOP_COUNTS + 1 cycles. After rst it comes
// by itself, 2^6 cycles later: the core has then cleared its own.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_top.vh"
module rt_totals (
    input  wire        clk,
    input  wire        rst,
    // from rt_control
    input  wire        snap_i,
    output wire        busy_o,
    input  wire [6:0]  read_addr_i,     // {counter, high word}
    output wire [31:0] read_data_o,     // in the same cycle
    // the core
    output wire [4:0]  count_addr_o,
    input  wire [47:0] count_data_i,    // a cycle later
    // events
    input  wire        frame_i,         // counters of the buses start anew
    input  wire        clear_i,         // and those of the display
    input  wire [1:0]  read_i,          // {beat, burst} of reads
    input  wire [1:0]  write_i,         // of writes
    input  wire [3:0]  pixels_i,        // of the burst of writes
    input  wire        swap_i,
    input  wire        again_i,
    input  wire        lost_i,
    input  wire        underrun_i
);
    localparam OWN = `RT_TOP_COUNTS - 32;
    localparam [5:0] ALL = `RT_TOP_COUNTS;
    // what happens reaches far: it is counted a clock later
    reg  [1:0] read_q, write_q;
    reg  [3:0] pixels_q;
    reg        frame_q, clear_q, swap_q, again_q, lost_q, underrun_q;
    always @(posedge clk) begin
        {read_q, write_q, pixels_q} <= {read_i, write_i, pixels_i};
        {frame_q, clear_q, swap_q, again_q, lost_q, underrun_q} <=
            {frame_i, clear_i, swap_i, again_i, lost_i, underrun_i};
        if (rst) {read_q, write_q, swap_q, again_q, lost_q, underrun_q} <= 8'd0;
    end
    wire [4*OWN-1:0] add;               // to each counter
    assign add[4*(`RT_TOP_COUNT_READ_BURSTS - 32) +: 4]  = {3'd0, read_q[0]};
    assign add[4*(`RT_TOP_COUNT_READ_BEATS - 32) +: 4]   = {3'd0, read_q[1]};
    assign add[4*(`RT_TOP_COUNT_WRITE_BURSTS - 32) +: 4] = {3'd0, write_q[0]};
    assign add[4*(`RT_TOP_COUNT_WRITE_BEATS - 32) +: 4]  = {3'd0, write_q[1]};
    assign add[4*(`RT_TOP_COUNT_WRITE_PIXELS - 32) +: 4] = write_q[0] ? pixels_q : 4'd0;
    assign add[4*(`RT_TOP_COUNT_FRAMES_SHOWN - 32) +: 4] = {3'd0, swap_q};
    assign add[4*(`RT_TOP_COUNT_FRAMES_AGAIN - 32) +: 4] = {3'd0, again_q};
    assign add[4*(`RT_TOP_COUNT_FRAMES_LOST - 32) +: 4]  = {3'd0, lost_q};
    assign add[4*(`RT_TOP_COUNT_UNDERRUNS - 32) +: 4]    = {3'd0, underrun_q};
    reg  [32*OWN-1:0] total_q;
    integer i;
    always @(posedge clk)
        for (i = 0; i < OWN; i = i + 1) begin
            total_q[32*i +: 32] <= total_q[32*i +: 32] + {28'd0, add[4*i +: 4]};
            if (rst || (i + 32 < `RT_TOP_COUNT_FRAMES_SHOWN ? frame_q : clear_q))
                total_q[32*i +: 32] <= 32'd0;
        end

    // ---- snapshot: counter at_q is asked for, the one before it is written ----
    reg  [5:0]  at_q, put_q;
    reg         run_q, wait_q, put_valid_q;
    wire [5:0]  own = put_q - 6'd32;
    wire [47:0] read;
    wire [47:0] value = put_q[5] ? {16'd0, total_q[32*own[3:0] +: 32]} : count_data_i;
    assign busy_o       = run_q || wait_q || put_valid_q;
    assign count_addr_o = at_q[4:0];
    always @(posedge clk) begin
        put_valid_q <= run_q;
        put_q       <= at_q;
        at_q        <= run_q || wait_q ? at_q + 1'b1 : 6'd0;
        if (run_q && at_q == ALL - 6'd1) {run_q, at_q} <= 7'd0;
        if (wait_q && &at_q) {run_q, wait_q} <= 2'b10;
        if (snap_i && !busy_o) run_q <= 1'b1;
        if (rst) begin
            {run_q, wait_q} <= 2'b01;
            at_q <= 6'd0;
        end
    end
    rt_slot_file #(.WIDTH(48), .SLOTS(64)) u_shown (
        .clk(clk), .wr_en_i(put_valid_q), .wr_addr_i(put_q), .wr_data_i(value),
        .rd_addr_i(read_addr_i[6:1]), .rd_data_o(read)
    );
    assign read_data_o = read_addr_i[6:1] >= ALL ? 32'd0
                         : read_addr_i[0] ? {16'd0, read[47:32]} : read[31:0];
    wire unused = &{1'b0, own};
endmodule
`default_nettype wire
