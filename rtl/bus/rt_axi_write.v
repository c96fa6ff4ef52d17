// rt_axi_write.v - groups of up to 32 bytes as bursts of an AXI4 write master
// SPDX-License-Identifier: Apache-2.0
//   group --> [AW, W: beats with a strobe for each byte] --> bus;  B: counted, errors told
// A group is aligned to its length, so that no burst crosses 4 KiB. AW and W go at the same time,
// neither waits for the other. At most 15 answers are owed. cut_i: groups are thrown away, a burst
// that began goes on to its end. idle_o: nothing is on its way.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
module rt_axi_write #(
    parameter DATA = 64,             // bits of a beat, 64 or 128
    parameter ADDR = 32              // bits of an address, 32 to 40
) (
    input  wire              clk,
    input  wire              rst,
    // from rt_run
    input  wire              cut_i,          // throw groups away
    input  wire              forget_i,       // the bus was reset: it owes nothing
    // to rt_run
    output wire              idle_o,         // nothing is on its way
    output wire              stall_o,        // something is, and the bus does nothing
    output reg               slverr_o,       // an answer came with this error, a clock before
    output reg               decerr_o,
    // to rt_totals
    output wire              burst_o,        // a burst begins
    output wire              beat_o,         // a beat was taken
    // from rt_frame_write
    input  wire              group_valid_i,
    output wire              group_ready_o,
    input  wire [ADDR-1:0]   group_addr_i,   // aligned to its length
    input  wire              group_half_i,   // 16 bytes, not 32
    input  wire [31:0]       group_strobe_i, // a bit for each byte
    input  wire [255:0]      group_data_i,
    // AXI4
    output reg               m_awvalid,
    input  wire              m_awready,
    output reg  [ADDR-1:0]   m_awaddr,
    output reg  [7:0]        m_awlen,        // beats less one
    output reg               m_wvalid,
    input  wire              m_wready,
    output wire [DATA-1:0]   m_wdata,
    output wire [DATA/8-1:0] m_wstrb,
    output wire              m_wlast,
    input  wire              m_bvalid,
    output wire              m_bready,
    input  wire [1:0]        m_bresp
);
    `RT_CHECK(DATA == 64 || DATA == 128, rt_axi_write_DATA_must_be_64_or_128)
    localparam [31:0] LAST = 256 / DATA - 1, LAST_HALF = 128 / DATA - 1;
    wire [1:0]   last = group_half_i ? LAST_HALF[1:0] : LAST[1:0];
    reg  [255:0] data_q;
    reg  [31:0]  strobe_q;
    reg  [1:0]   left_q;                     // beats behind the one that is offered
    reg  [3:0]   owed_q;                     // answers
    wire         aw_free = !m_awvalid || m_awready;
    wire         w_take  = m_wvalid && m_wready;
    wire         w_free  = !m_wvalid || (m_wready && m_wlast);
    wire         room    = !(&owed_q) && aw_free && w_free;
    assign group_ready_o = cut_i || room;
    wire         begins  = group_valid_i && room && !cut_i;
    assign m_wdata  = data_q[DATA-1:0];
    assign m_wstrb  = strobe_q[DATA/8-1:0];
    assign m_wlast  = left_q == 2'd0;
    assign m_bready = owed_q != 4'd0;
    wire         answer = m_bvalid && m_bready;
    always @(posedge clk) begin
        if (aw_free) m_awvalid <= begins;
        if (w_free)  m_wvalid  <= begins;
        if (begins) begin
            m_awaddr <= group_addr_i;
            m_awlen  <= {6'd0, last};
            left_q   <= last;
            data_q   <= group_data_i;
            strobe_q <= group_strobe_i;
        end else if (w_take) begin
            left_q   <= left_q - 1'b1;
            data_q   <= data_q >> DATA;
            strobe_q <= strobe_q >> DATA / 8;
        end
        owed_q <= owed_q + {3'd0, begins} - {3'd0, answer};
        if (rst || forget_i) begin
            m_awvalid <= 1'b0;
            m_wvalid  <= 1'b0;
            owed_q    <= 4'd0;
        end
    end
    assign idle_o   = owed_q == 4'd0;        // its answer comes behind a burst's last beat
    assign stall_o  = !idle_o && !m_bvalid && !w_take && !(m_awvalid && m_awready);
    always @(posedge clk) begin
        slverr_o <= answer && m_bresp == 2'b10 && !rst;
        decerr_o <= answer && m_bresp == 2'b11 && !rst;
    end
    assign burst_o  = begins && !forget_i;
    assign beat_o   = w_take;
endmodule
`default_nettype wire
