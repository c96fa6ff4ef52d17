// rt_axi_read.v - 256-bit lines of the core as bursts of an AXI4 read master
// SPDX-License-Identifier: Apache-2.0
//   line L, tag --> [AR: base + 32 L, 256/DATA beats, ID: tag] --> bus --> [R] --> beats --> core
// A line is one INCR burst, aligned to its length, so that none crosses 4 KiB. The bus may answer
// bursts of several IDs in any order, and alternate their beats. The core bounds the lines on their
// way. SLVERR and DECERR mark a beat of the core.
// cut_i: the core is in reset; what the bus owes is taken and thrown away. idle_o: the bus owes
// nothing.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
`include "rt_layout.vh"
module rt_axi_read #(
    parameter DATA    = 64,  // bits of a beat: 64, 128, 256
    parameter PENDING = 256, // lines that the core may wait for
    parameter ADDR = 32      // bits of an address, 32 to 40
) (
    input  wire            clk,
    input  wire            rst,
    // from rt_run
    input  wire            begin_i,          // START; from now on
    input  wire [ADDR-1:0] base_i,           // line 0 has this address
    input  wire            cut_i,            // the core is in reset
    input  wire            forget_i,         // the bus was reset: it owes nothing
    // to rt_run
    output wire            idle_o,           // the bus owes nothing
    output wire            stall_o,          // it owes something and does nothing
    output reg             slverr_o,         // a beat came with this error, a clock before
    output reg             decerr_o,
    // to rt_totals
    output wire            burst_o,          // a burst was asked for
    output wire            beat_o,           // a beat came
    // from the core
    input  wire            req_valid_i,
    output wire            req_ready_o,
    input  wire [`RT_LINE_BITS-1:0] req_line_i,
    input  wire [`RT_TAG_BITS-1:0] req_tag_i,
    // to the core
    output wire            rsp_valid_o,
    input  wire            rsp_ready_i,
    output wire [`RT_TAG_BITS-1:0] rsp_tag_o,
    output wire [DATA-1:0] rsp_data_o,
    output wire            rsp_error_o,
    // AXI4
    output reg             m_arvalid,
    input  wire            m_arready,
    output reg  [`RT_TAG_BITS-1:0] m_arid,
    output reg  [ADDR-1:0] m_araddr,
    output wire [7:0]      m_arlen,          // beats less one
    input  wire            m_rvalid,
    output wire            m_rready,
    input  wire [`RT_TAG_BITS-1:0] m_rid,
    input  wire [DATA-1:0] m_rdata,
    input  wire [1:0]      m_rresp,
    input  wire            m_rlast
);
    `RT_CHECK(DATA == 64 || DATA == 128 || DATA == 256, rt_axi_read_DATA_must_be_64_128_or_256)
    localparam [31:0] BEATS = 256 / DATA;
    localparam CB = $clog2(PENDING * BEATS + 1);
    reg  [CB-1:0] owed_q;                    // beats that the bus owes, of a waiting AR too
    wire          owing = owed_q != {CB{1'b0}};

    // ---- requests ----
    reg  [ADDR-1:0] base_q;
    always @(posedge clk) if (begin_i) base_q <= base_i;
    wire ar_free       = !m_arvalid || m_arready;
    wire ask           = req_valid_i && req_ready_o;
    wire [31:0] last   = BEATS - 1;
    assign req_ready_o = ar_free && !cut_i;
    assign m_arlen     = last[7:0];
    always @(posedge clk) begin
        if (ar_free) m_arvalid <= ask;
        if (ask) begin
            m_araddr <= base_q + {{(ADDR-31){1'b0}}, req_line_i, 5'd0};
            m_arid   <= req_tag_i;
        end
        if (rst || forget_i) m_arvalid <= 1'b0;
    end

    // ---- answers ----
    wire beat          = m_rvalid && m_rready;
    assign m_rready    = owing && (cut_i || rsp_ready_i);
    assign rsp_valid_o = owing && !cut_i && m_rvalid;
    assign rsp_tag_o   = m_rid;
    assign rsp_data_o  = m_rdata;
    assign rsp_error_o = m_rresp[1];
    always @(posedge clk) begin
        owed_q <= owed_q + (ask ? BEATS[CB-1:0] : {CB{1'b0}}) - {{(CB-1){1'b0}}, beat};
        if (rst || forget_i) owed_q <= {CB{1'b0}};
    end

    assign idle_o   = !owing;
    assign stall_o  = owing && !m_rvalid && !(m_arvalid && m_arready);
    always @(posedge clk) begin
        slverr_o <= beat && m_rresp == 2'b10 && !rst;
        decerr_o <= beat && m_rresp == 2'b11 && !rst;
    end
    assign burst_o  = ask && !forget_i;
    assign beat_o   = beat;
    wire unused = &{1'b0, last, m_rlast};    // beats are counted
endmodule
`default_nettype wire
