// rt_video.v - shows frames of the frame store: AXI4 read to AXI4-Stream video and TMDS symbols
// SPDX-License-Identifier: Apache-2.0
//   clk:      rt_scan --> rt_async_fifo --.        frame, on, underrun, blanking: rt_sync
//   pix_clk:  rt_video_timing --> rt_unpack --> register --> stream --> 3 rt_tmds
// The timing runs by itself and rt_scan follows it: each frame begins with its blanking, when
// rt_frames says what is shown. While a stream's pixel waits, all of the display waits; who sends
// TMDS keeps m_video_tready high. TMDS symbols are two clocks behind the stream.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_modes.vh"
module rt_video #(
    parameter DATA  = 64,                 // bits of a beat, 64 or 128
    parameter BURST = 16,                 // most beats of a burst, a power of two up to 4 KiB
    parameter DEPTH = 512,                // words of the queue to the display, a power of two
    parameter ADDR  = 32                  // bits of an address, 32 to 40
) (
    input  wire        clk,
    input  wire        rst,               // synchronous, active high; of the bus, too
    input  wire        enable_i,
    input  wire        forget_i,          // one cycle: the bus was reset, it owes nothing
    input  wire [`RT_MODE_BITS-1:0] mode_i, // taken when it is switched on; rt_modes.vh
    input  wire        format_i,          // 0: XRGB8888, 1: RGB565
    input  wire [15:0] stride_i,          // bytes from a row to the next, a multiple of 16
    input  wire        double_i,          // a pixel is shown as two by two
    // to and from rt_frames
    output wire        take_o,            // vertical blanking begins: which frame is the next?
    input  wire        show_valid_i,      // from the clock after, until the next: there is one
    input  wire [ADDR-1:0] show_base_i,   // its address, a multiple of 64
    output wire        blank_o,           // vertical blanking, or off
    output wire        underrun_o,        // one clock for a frame that missed a pixel
    output wire        error_o,           // one clock for a beat with SLVERR or DECERR
    output wire        stall_o,           // the bus owes something and does nothing
    output wire        idle_o,            // off, and all is seen that clk hears of the display
    // AXI4 read
    output wire        m_scan_arvalid,
    input  wire        m_scan_arready,
    output wire [ADDR-1:0] m_scan_araddr,
    output wire [7:0]  m_scan_arlen,
    output wire [2:0]  m_scan_arsize,
    output wire [1:0]  m_scan_arburst,
    input  wire        m_scan_rvalid,
    output wire        m_scan_rready,
    input  wire [DATA-1:0] m_scan_rdata,
    input  wire [1:0]  m_scan_rresp,
    input  wire        m_scan_rlast,
    // the display, in pix_clk
    input  wire        pix_clk,
    input  wire        pix_rst,           // synchronous to pix_clk, active high
    output reg         m_video_tvalid,
    input  wire        m_video_tready,    // high if syncs or symbols are used
    output reg  [23:0] m_video_tdata,     // red in the high bits
    output reg         m_video_tuser,     // first pixel of a frame
    output reg         m_video_tlast,     // last pixel of a row
    output wire        de_o,              // beside the stream
    output reg         hsync_o,
    output reg         vsync_o,
    output wire [9:0]  tmds0_o,           // blue and syncs; bit 0 is sent first
    output wire [9:0]  tmds1_o,           // green
    output wire [9:0]  tmds2_o            // red
);
    localparam CB = $clog2(DEPTH) + 1;    // bits of a count of words
    wire clk_rst, pix_rst_s;
    rt_reset_pair u_resets (
        .a_clk(clk), .a_rst(rst), .a_rst_o(clk_rst),
        .b_clk(pix_clk), .b_rst(pix_rst), .b_rst_o(pix_rst_s)
    );

    // ---- on and off: each is seen by the other side before it changes again ----
    // So the display may be on while enable_i is low, or low and high again with another mode.
    reg  on_q;                            // in clk
    reg  leave_q;                         // enable_i was low since: off as soon as on was seen
    reg  [`RT_MODE_BITS-1:0] mode_q;      // changes while both sides are off
    reg  shows_q;                         // in pix_clk: a frame, or words of one
    wire shows_s, on_s;
    wire leave = leave_q || !enable_i;
    always @(posedge clk) begin
        on_q    <= on_q ? !(leave && shows_s) : enable_i && !shows_s;
        leave_q <= on_q && leave;
        if (!on_q && !shows_s) mode_q <= mode_i;
        if (clk_rst) on_q <= 1'b0;
    end
    wire scan_idle;
    assign idle_o = !clk_rst && !enable_i && !on_q && !leave_q && !shows_s && scan_idle;
    rt_sync u_on (.clk(pix_clk), .d_i(on_q), .q_o(on_s));

    // ---- timing ----
    wire advance = !m_video_tvalid || m_video_tready;
    wire run, start, frame, blank, de, first, last, hsync, vsync;
    rt_video_timing u_timing (
        .clk(pix_clk), .rst(pix_rst_s), .run_i(on_s), .advance_i(advance), .mode_i(mode_q),
        .run_o(run), .start_o(start), .frame_o(frame), .blank_o(blank), .de_o(de),
        .first_o(first), .last_o(last), .hsync_o(hsync), .vsync_o(vsync)
    );

    // ---- what clk hears of the display ----
    reg  blank_q;
    wire underrun, frame_s, underrun_s, word_valid;
    reg  underrun_q;                      // in clk: as it was
    always @(posedge pix_clk) begin
        blank_q <= blank;
        shows_q <= run || word_valid;
    end
    rt_sync #(.WIDTH(4)) u_heard (.clk(clk), .d_i({shows_q, frame, blank_q, underrun}),
        .q_o({shows_s, frame_s, blank_o, underrun_s}));
    assign underrun_o = underrun_s != underrun_q && !clk_rst;
    always @(posedge clk) underrun_q <= underrun_s;

    // ---- words: memory to queue to pixels ----
    wire            put_valid, put_ready, word_ready;   // put_ready is high: there is room
    wire [DATA+1:0] put, word;
    wire [CB-1:0]   count;
    wire [23:0]     rgb;
    rt_scan #(.DATA(DATA), .BURST(BURST), .DEPTH(DEPTH), .ADDR(ADDR)) u_scan (
        .clk(clk), .rst(rst), .enable_i(on_q && !leave), // rst: memory owes beats after pix_rst
        .forget_i(forget_i), .h_active_i(mode_q[`RT_MODE_H_ACTIVE]),
        .v_active_i(mode_q[`RT_MODE_V_ACTIVE]), .rgb565_i(format_i), .double_i(double_i),
        .stride_i(stride_i), .frame_i(frame_s), .take_o(take_o),
        .show_valid_i(show_valid_i), .show_base_i(show_base_i),
        .m_scan_arvalid(m_scan_arvalid), .m_scan_arready(m_scan_arready),
        .m_scan_araddr(m_scan_araddr), .m_scan_arlen(m_scan_arlen),
        .m_scan_arsize(m_scan_arsize), .m_scan_arburst(m_scan_arburst),
        .m_scan_rvalid(m_scan_rvalid), .m_scan_rready(m_scan_rready),
        .m_scan_rdata(m_scan_rdata), .m_scan_rresp(m_scan_rresp), .error_o(error_o),
        .stall_o(stall_o), .idle_o(scan_idle), .word_valid_o(put_valid), .word_data_o(put),
        .word_count_i(count)
    );
    rt_async_fifo #(.WIDTH(DATA + 2), .DEPTH(DEPTH)) u_words (
        .wr_clk(clk), .wr_rst(clk_rst), .wr_valid_i(put_valid), .wr_ready_o(put_ready),
        .wr_data_i(put), .wr_count_o(count), .rd_clk(pix_clk), .rd_rst(pix_rst_s),
        .rd_valid_o(word_valid), .rd_ready_i(word_ready), .rd_data_o(word)
    );
    rt_unpack #(.DATA(DATA)) u_unpack (
        .clk(pix_clk), .rst(pix_rst_s), .advance_i(advance), .run_i(run), .start_i(start),
        .frame_i(frame), .de_i(de), .last_i(last), .word_valid_i(word_valid),
        .word_ready_o(word_ready), .word_data_i(word), .rgb_o(rgb), .underrun_o(underrun)
    );

    // ---- output register ----
    always @(posedge pix_clk) begin
        if (advance) begin
            m_video_tvalid <= de;
            m_video_tdata  <= rgb;
            m_video_tuser  <= de && first;
            m_video_tlast  <= de && last;
            hsync_o        <= hsync;
            vsync_o        <= vsync;
        end
        if (pix_rst_s) m_video_tvalid <= 1'b0;
    end
    assign de_o = m_video_tvalid;

    // ---- symbols ----
    rt_tmds u_blue (.clk(pix_clk), .advance_i(advance), .de_i(m_video_tvalid),
        .data_i(m_video_tdata[7:0]), .control_i({vsync_o, hsync_o}), .symbol_o(tmds0_o));
    rt_tmds u_green (.clk(pix_clk), .advance_i(advance), .de_i(m_video_tvalid),
        .data_i(m_video_tdata[15:8]), .control_i(2'b00), .symbol_o(tmds1_o));
    rt_tmds u_red (.clk(pix_clk), .advance_i(advance), .de_i(m_video_tvalid),
        .data_i(m_video_tdata[23:16]), .control_i(2'b00), .symbol_o(tmds2_o));

    wire unused = &{1'b0, m_scan_rlast, put_ready};
endmodule
`default_nettype wire
