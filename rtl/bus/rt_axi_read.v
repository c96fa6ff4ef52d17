// rt_axi_read.v - 256-bit lines of the core as bursts of an AXI4 read master
// SPDX-License-Identifier: Apache-2.0
//   line L --> [AR: base + 32 L, 256/DATA beats] --> bus --> [R] --> four beats of 64 bits --> core
// A line is one INCR burst, aligned to its length, so that none crosses 4 KiB. Up to PENDING bursts
// are on their way, with one ID and so in order. SLVERR and DECERR mark a beat of the core.
// cut_i: the core is in reset; what the bus owes is taken and thrown away. dead_i: the bus is given
// up; lines are answered with errors and no more are asked for. idle_o: the bus owes nothing.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
`include "rt_layout.vh"
module rt_axi_read #(
    parameter DATA    = 64,  // bits of a beat, 64 or 128
    parameter PENDING = 16   // lines on their way, 2..64
) (
    input  wire            clk,
    input  wire            rst,
    // from rt_run
    input  wire            begin_i,          // START; from now on
    input  wire [31:0]     base_i,           // line 0 has this address
    input  wire            cut_i,            // the core is in reset
    input  wire            dead_i,           // the bus is given up
    input  wire            forget_i,         // the bus was reset: it owes nothing
    // to rt_run
    output wire            idle_o,           // the bus owes nothing
    output wire            stall_o,          // it owes something and does nothing
    output wire            slverr_o,         // a beat came with this error
    output wire            decerr_o,
    // to rt_totals
    output wire            burst_o,          // a burst was asked for
    output wire            beat_o,           // a beat came
    // from the core
    input  wire            req_valid_i,
    output wire            req_ready_o,
    input  wire [`RT_LINE_BITS-1:0] req_line_i,
    // to the core: four beats a line
    output wire            rsp_valid_o,
    input  wire            rsp_ready_i,
    output wire [63:0]     rsp_data_o,
    output wire            rsp_error_o,
    // AXI4
    output reg             m_arvalid,
    input  wire            m_arready,
    output reg  [31:0]     m_araddr,
    output wire [7:0]      m_arlen,          // beats less one
    input  wire            m_rvalid,
    output wire            m_rready,
    input  wire [DATA-1:0] m_rdata,
    input  wire [1:0]      m_rresp,
    input  wire            m_rlast
);
    `RT_CHECK(DATA == 64 || DATA == 128, rt_axi_read_DATA_must_be_64_or_128)
    `RT_CHECK(PENDING >= 2 && PENDING <= 64, rt_axi_read_PENDING_must_be_2_to_64)
    localparam [31:0] LAST = 256 / DATA - 1;
    localparam CB = $clog2(PENDING + 1);
    localparam [31:0] FULL = PENDING;
    reg  [CB-1:0] owed_q;                    // lines that the core waits for
    reg  [1:0]    owed_beat_q;               // beats of the first of them that it has
    reg  [CB-1:0] bus_q;                     // lines that the bus owes, a waiting AR included
    reg  [1:0]    bus_beat_q;                // beats of the first of them that came
    wire          open = !cut_i && !dead_i;  // the bus answers the core

    // ---- requests ----
    reg  [31:0] base_q;
    always @(posedge clk) if (begin_i) base_q <= base_i;
    wire ar_free = !m_arvalid || m_arready;
    assign req_ready_o = !cut_i && owed_q != FULL[CB-1:0] &&
                         (dead_i || (ar_free && bus_q != FULL[CB-1:0]));
    wire take    = req_valid_i && req_ready_o;
    wire ask     = take && !dead_i;
    assign m_arlen = LAST[7:0];
    always @(posedge clk) begin
        if (ar_free) m_arvalid <= ask;
        if (ask) m_araddr <= base_q + {1'b0, req_line_i, 5'd0};
        if (rst || forget_i) m_arvalid <= 1'b0;
    end

    // ---- answers ----
    wire owing = bus_q != {CB{1'b0}};
    wire whole;                              // with it the core has all of the beat
    assign rsp_valid_o = dead_i ? owed_q != {CB{1'b0}} : open && owing && m_rvalid;
    assign rsp_error_o = dead_i || m_rresp[1];
    assign m_rready    = owing && (!open || (rsp_ready_i && whole));
    wire beat      = m_rvalid && m_rready;
    wire give      = rsp_valid_o && rsp_ready_i;
    wire given     = give && &owed_beat_q;
    wire bus_done  = beat && bus_beat_q == LAST[1:0];
    always @(posedge clk) begin
        owed_q <= owed_q + {{(CB-1){1'b0}}, take} - {{(CB-1){1'b0}}, given};
        bus_q  <= bus_q + {{(CB-1){1'b0}}, ask} - {{(CB-1){1'b0}}, bus_done};
        if (give) owed_beat_q <= owed_beat_q + 1'b1;
        if (beat) bus_beat_q  <= bus_done ? 2'd0 : bus_beat_q + 1'b1;
        if (rst || cut_i || forget_i) begin
            owed_q      <= {CB{1'b0}};
            owed_beat_q <= 2'd0;
        end
        if (rst || forget_i) begin
            bus_q      <= {CB{1'b0}};
            bus_beat_q <= 2'd0;
        end
    end

    generate
        if (DATA == 64) begin : g_whole
            assign rsp_data_o = m_rdata;
            assign whole      = 1'b1;
        end else begin : g_halves
            assign rsp_data_o = owed_beat_q[0] ? m_rdata[DATA-1 -: 64] : m_rdata[63:0];
            assign whole      = owed_beat_q[0];
        end
    endgenerate

    assign idle_o   = !owing;
    assign stall_o  = owing && !m_rvalid && !(m_arvalid && m_arready);
    assign slverr_o = beat && m_rresp == 2'b10;
    assign decerr_o = beat && m_rresp == 2'b11;
    assign burst_o  = ask;
    assign beat_o   = beat;
    wire unused = &{1'b0, m_rlast};          // beats are counted
endmodule
`default_nettype wire
