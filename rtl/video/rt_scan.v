// rt_scan.v - reads the shown frame out of memory, row by row, into the queue to the display
// SPDX-License-Identifier: Apache-2.0
//   frame_i changes --> take_o --> header --> bursts of each row --> beats, as they come
// A word of the queue is {first, frame, data}: the first of a frame says how the others are to be
// read. A burst is asked for when the queue has room for all that was asked for, so a beat never
// waits and m_scan_rready is always high. No burst crosses a multiple of BURST beats, and so none
// of 4 KiB. When the display begins another frame, what is still on its way is thrown away.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
module rt_scan #(
    parameter DATA  = 64,                 // bits of a beat, 64 or 128
    parameter BURST = 16,                 // most beats of a burst, a power of two up to 4 KiB
    parameter DEPTH = 512,                // words of the queue, a power of two, over 2 BURST
    parameter ADDR  = 32,                 // bits of an address, 32 to 40
    parameter CB    = $clog2(DEPTH) + 1   // bits of a count of words, derived: leave alone
) (
    input  wire        clk,
    input  wire        rst,               // synchronous, active high
    input  wire        enable_i,
    input  wire        forget_i,          // the bus was reset: it owes nothing
    input  wire [12:0] h_active_i,        // pixels of a row and rows that are shown; stable while
    input  wire [12:0] v_active_i,        // enable_i is high
    input  wire        rgb565_i,          // RGB565, else XRGB8888; from the next frame on
    input  wire        double_i,          // a pixel is shown as two by two
    input  wire [15:0] stride_i,          // bytes from a row to the next, a multiple of 16
    // from the display
    input  wire        frame_i,           // changes where a frame begins, with its blanking
    // to and from rt_frames
    output wire        take_o,            // which frame is the next?
    input  wire        show_valid_i,      // from the clock after: there is one
    input  wire [ADDR-1:0] show_base_i,   // its address, a multiple of 64
    // AXI4 read
    output reg         m_scan_arvalid,
    input  wire        m_scan_arready,
    output reg  [ADDR-1:0] m_scan_araddr,
    output reg  [7:0]  m_scan_arlen,
    output wire [2:0]  m_scan_arsize,
    output wire [1:0]  m_scan_arburst,
    input  wire        m_scan_rvalid,
    output wire        m_scan_rready,
    input  wire [DATA-1:0] m_scan_rdata,
    input  wire [1:0]  m_scan_rresp,
    output wire        error_o,           // a beat came with SLVERR or DECERR
    output wire        stall_o,           // the bus owes something and does nothing
    output wire        idle_o,            // it owes nothing
    // to the queue
    output wire        word_valid_o,
    output wire [DATA+1:0] word_data_o,
    input  wire [CB-1:0] word_count_i     // words that may still be inside
);
    localparam BB = $clog2(DATA / 8);     // log2 of a beat's bytes
    localparam LB = $clog2(BURST);        // log2 of a burst's beats
    `RT_CHECK(DATA == 64 || DATA == 128, rt_scan_DATA_must_be_64_or_128)
    `RT_CHECK(BURST == (1 << LB) && BURST >= 2 && BURST * DATA / 8 <= 4096 && BURST <= 256,
        rt_scan_BURST_must_be_a_power_of_two_within_4_KiB)
    `RT_CHECK(DEPTH >= 4 * BURST, rt_scan_DEPTH_must_be_four_times_BURST)

    // ---- rows of the frame store: pixels and beats; they stand still while enable_i is high ----
    wire [13:0] columns = {1'b0, h_active_i} + {13'd0, double_i};
    wire [12:0] width   = double_i ? columns[13:1] : columns[12:0];
    wire [14:0] bytes   = rgb565_i ? {1'b0, width, 1'b0} : {width, 2'b00};
    wire [15:0] filled  = {1'b0, bytes} + {{(16-BB){1'b0}}, {BB{1'b1}}};
    wire [15:0] beats_w = filled >> BB;
    wire [12:0] beats   = beats_w[12:0];

    // ---- another frame: taken at once, begun when all beats on their way have come ----
    reg             frame_q;              // that is read
    reg             begin_q;              // its header is still to be written
    reg             stale_q;              // beats on their way are of an earlier one
    reg  [CB-1:0]   owed_q;               // beats on their way
    assign take_o = enable_i && frame_i != frame_q;
    wire idle     = owed_q == {CB{1'b0}} && !m_scan_arvalid;
    assign idle_o = idle;
    reg  room_q;                          // for a burst, in the clock before, and no header since
    wire header   = begin_q && idle && room_q && !take_o && !forget_i && enable_i;
    always @(posedge clk) begin
        frame_q <= frame_i;
        if (header) begin begin_q <= 1'b0; stale_q <= 1'b0; end
        if (take_o) begin begin_q <= 1'b1; stale_q <= 1'b1; end
        if (forget_i) stale_q <= 1'b1;    // the rest of this frame is not asked for
        if (!enable_i) begin begin_q <= 1'b0; stale_q <= 1'b1; end
        if (rst) begin
            frame_q <= 1'b0;
            begin_q <= 1'b0;
            stale_q <= 1'b1;
        end
    end

    // ---- bursts: one is put together while none waits, so that each has two clocks: in the one
    // its length and the room for it are found, in the other it is asked for ----
    reg  [ADDR-1:0] row_q;                // address of this row
    reg  [ADDR-1:0] addr_q;               // of the next beat
    reg  [12:0] left_q;                   // beats of this row to be asked for
    reg  [12:0] rows_q;                   // rows of the display to come, with this one
    reg         again_q;                  // double_i: this row was read once
    reg         read_q;                   // there is more to be asked for
    wire [CB:0] full   = {1'b0, word_count_i} + {1'b0, owed_q};
    wire        room   = full <= DEPTH[CB:0] - BURST[CB:0];
    wire        go     = read_q && !stale_q && !take_o && room_q && !m_scan_arvalid && !forget_i;
    wire [LB:0] to_end = BURST[LB:0] - {1'b0, addr_q[BB +: LB]};
    wire        short  = left_q <= {{(12-LB){1'b0}}, to_end};
    wire [LB:0] length = short ? left_q[LB:0] : to_end;
    reg  [LB:0] length_q;
    reg         short_q;                  // the burst is the last of its row
    wire [ADDR-1:0] below = row_q + {{(ADDR-16){1'b0}}, stride_i};
    wire        repeats = double_i && !again_q;
    assign m_scan_arsize  = BB[2:0];
    assign m_scan_arburst = 2'b01;        // INCR
    always @(posedge clk) begin
        room_q   <= room && !header;
        length_q <= length;
        short_q  <= short;
        if (m_scan_arready) m_scan_arvalid <= 1'b0;
        if (go) begin
            m_scan_arvalid <= 1'b1;
            m_scan_araddr  <= addr_q;
            m_scan_arlen   <= {{(7-LB){1'b0}}, length_q} - 8'd1;
            addr_q         <= addr_q + ({{(ADDR-1-LB){1'b0}}, length_q} << BB);
            left_q         <= left_q - {{(12-LB){1'b0}}, length_q};
            if (short_q) begin
                addr_q  <= repeats ? row_q : below;
                row_q   <= repeats ? row_q : below;
                left_q  <= beats;
                rows_q  <= rows_q - 13'd1;
                again_q <= repeats;
                if (rows_q == 13'd1) read_q <= 1'b0;
            end
        end
        if (header) begin
            row_q   <= show_base_i;
            addr_q  <= show_base_i;
            left_q  <= beats;
            rows_q  <= v_active_i;
            again_q <= 1'b0;
            read_q  <= show_valid_i;
        end
        if (rst || forget_i) m_scan_arvalid <= 1'b0;
        if (rst) read_q <= 1'b0;
    end

    // ---- beats ----
    wire beat = m_scan_rvalid && owed_q != {CB{1'b0}};
    assign m_scan_rready = 1'b1;
    assign error_o       = beat && m_scan_rresp[1];
    assign stall_o       = owed_q != {CB{1'b0}} && !m_scan_rvalid &&
                           !(m_scan_arvalid && m_scan_arready);
    always @(posedge clk) begin
        owed_q <= owed_q + (go ? {{(CB-LB-1){1'b0}}, length_q} : {CB{1'b0}}) -
                  {{(CB-1){1'b0}}, beat};
        if (rst || forget_i) owed_q <= {CB{1'b0}};
    end
    assign word_valid_o = header || (beat && !stale_q && enable_i);
    assign word_data_o  = {header, frame_q, m_scan_rdata[DATA-1:3],
        header ? {double_i, rgb565_i, show_valid_i} : m_scan_rdata[2:0]};
    wire unused = &{1'b0, m_scan_rresp[0], beats_w[15:13], filled};
endmodule
`default_nettype wire
