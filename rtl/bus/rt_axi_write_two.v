// rt_axi_write_two.v - two AXI4 write masters on one, a burst at a time
// SPDX-License-Identifier: Apache-2.0
//   a, b --> [in turn: a burst, until its address and its last beat are taken] --> bus
//   B: answers come in the order of the bursts, those of one ID; [whose each is]
// A master offers address and first beat of a burst in the same clock, as rt_axi_write does; so a
// burst takes the clocks that it takes alone. At most 15 answers are owed to each.
`timescale 1ns / 1ps
`default_nettype none
module rt_axi_write_two #(
    parameter DATA = 64,             // bits of a beat, 64 or 128
    parameter ADDR = 32              // bits of an address, 32 to 40
) (
    input  wire              clk,
    input  wire              rst,            // synchronous, active high
    input  wire              forget_i,       // the bus was reset: it owes nothing
    // master a
    input  wire              a_awvalid,
    output wire              a_awready,
    input  wire [ADDR-1:0]   a_awaddr,
    input  wire [7:0]        a_awlen,
    input  wire              a_wvalid,
    output wire              a_wready,
    input  wire [DATA-1:0]   a_wdata,
    input  wire [DATA/8-1:0] a_wstrb,
    input  wire              a_wlast,
    output wire              a_bvalid,
    input  wire              a_bready,
    // master b
    input  wire              b_awvalid,
    output wire              b_awready,
    input  wire [ADDR-1:0]   b_awaddr,
    input  wire [7:0]        b_awlen,
    input  wire              b_wvalid,
    output wire              b_wready,
    input  wire [DATA-1:0]   b_wdata,
    input  wire [DATA/8-1:0] b_wstrb,
    input  wire              b_wlast,
    output wire              b_bvalid,
    input  wire              b_bready,
    // AXI4
    output wire              m_awvalid,
    input  wire              m_awready,
    output wire [ADDR-1:0]   m_awaddr,
    output wire [7:0]        m_awlen,
    output wire              m_wvalid,
    input  wire              m_wready,
    output wire [DATA-1:0]   m_wdata,
    output wire [DATA/8-1:0] m_wstrb,
    output wire              m_wlast,
    input  wire              m_bvalid,
    output wire              m_bready
);
    // ---- whose burst: of_b_q is, or was last, b's ----
    reg  burst_q, of_b_q;                    // a burst began and did not end
    wire a_asks = a_awvalid || a_wvalid;
    wire b_asks = b_awvalid || b_wvalid;
    wire pick_b = burst_q ? of_b_q : b_asks && !(a_asks && of_b_q);
    assign m_awvalid = pick_b ? b_awvalid : a_awvalid;
    assign m_awaddr  = pick_b ? b_awaddr : a_awaddr;
    assign m_awlen   = pick_b ? b_awlen : a_awlen;
    assign m_wvalid  = pick_b ? b_wvalid : a_wvalid;
    assign m_wdata   = pick_b ? b_wdata : a_wdata;
    assign m_wstrb   = pick_b ? b_wstrb : a_wstrb;
    assign m_wlast   = pick_b ? b_wlast : a_wlast;
    assign a_awready = m_awready && !pick_b;
    assign b_awready = m_awready && pick_b;
    assign a_wready  = m_wready && !pick_b;
    assign b_wready  = m_wready && pick_b;
    // what is left of the burst is taken in this clock
    wire asks = pick_b ? b_asks : a_asks;
    wire ends = asks && (!m_awvalid || m_awready) && (!m_wvalid || (m_wready && m_wlast));
    always @(posedge clk) begin
        burst_q <= asks && !ends;
        if (asks) of_b_q <= pick_b;
        if (rst || forget_i) {burst_q, of_b_q} <= 2'd0;
    end

    // ---- whose answer ----
    wire owed, owed_b, room;
    rt_fifo #(.WIDTH(1), .DEPTH(32)) u_owed (
        .clk(clk), .rst(rst || forget_i),
        .in_valid_i(ends), .in_ready_o(room), .in_data_i(pick_b),
        .out_valid_o(owed), .out_ready_i(m_bvalid && m_bready), .out_data_o(owed_b)
    );
    assign a_bvalid = owed && !owed_b && m_bvalid;
    assign b_bvalid = owed && owed_b && m_bvalid;
    assign m_bready = owed && (owed_b ? b_bready : a_bready);
    wire unused = &{1'b0, room};             // always: 15 and 15
endmodule
`default_nettype wire
