// f_axi_write.v - proof of rt_axi_write: rules of AXI4, beats as AWLEN says, answers counted
// SPDX-License-Identifier: Apache-2.0
// The bus answers bursts whose address and data it took, in any clock. Groups come aligned to their
// length; what they hold is free.
`include "axi_rules.vh"
`timescale 1ns / 1ps
`default_nettype none
module f_axi_write #(
    parameter DATA = 64,
    parameter ADDR = 32
) (
    input wire         clk,
    input wire         rst,
    input wire         cut,
    input wire         forget,
    input wire         group_valid,
    input wire [ADDR-1:0] group_addr,
    input wire         group_half,
    input wire [31:0]  group_strobe,
    input wire [255:0] group_data,
    input wire         awready,
    input wire         wready,
    input wire         bvalid,
    input wire [1:0]   bresp
);
    wire idle, group_ready, awvalid, wvalid, wlast, bready;
    wire [ADDR-1:0] awaddr;
    wire [7:0]  awlen;
    wire [DATA-1:0] wdata;
    wire [DATA/8-1:0] wstrb;
    rt_axi_write #(.DATA(DATA), .ADDR(ADDR)) u_dut (
        .clk(clk), .rst(rst), .cut_i(cut), .forget_i(forget), .idle_o(idle), .stall_o(),
        .slverr_o(), .decerr_o(), .burst_o(), .beat_o(), .group_valid_i(group_valid),
        .group_ready_o(group_ready), .group_addr_i(group_addr), .group_half_i(group_half),
        .group_strobe_i(group_strobe), .group_data_i(group_data), .m_awvalid(awvalid),
        .m_awready(awready), .m_awaddr(awaddr), .m_awlen(awlen), .m_wvalid(wvalid),
        .m_wready(wready), .m_wdata(wdata), .m_wstrb(wstrb), .m_wlast(wlast), .m_bvalid(bvalid),
        .m_bready(bready), .m_bresp(bresp)
    );
    axi_write_rules #(.DATA(DATA), .ADDR(ADDR)) u_rules (
        .clk(clk), .rst(rst), .anew(forget), .awvalid(awvalid), .awready(awready),
        .awaddr(awaddr), .awlen(awlen), .wvalid(wvalid), .wready(wready), .wdata(wdata),
        .wstrb(wstrb), .wlast(wlast), .bvalid(bvalid), .bready(bready)
    );
    (* hierconn *) wire [7:0] \u_rules.beats_q ;
    (* hierconn *) wire [3:0] \u_dut.owed_q ;
    (* hierconn *) wire [1:0] \u_dut.left_q ;

    // ---- model: the burst that is sent, and those that wait for their answer ----
    reg           old_q = 1'b0;
    reg [3:0]     whole_q;               // bursts of which the bus has all
    reg [7:0]     beat_q;                // beats of the burst taken
    wire aw   = awvalid && awready;
    wire w    = wvalid && wready;
    wire ends = (awvalid || wvalid) && (aw || !awvalid) && (w && wlast || !wvalid);
    wire b    = bvalid && bready;
    always @(posedge clk) begin
        old_q     <= 1'b1;
        whole_q   <= whole_q + ends - b;
        beat_q    <= w ? (wlast ? 0 : beat_q + 1) : beat_q;
        if (rst || forget) begin whole_q <= 0; beat_q <= 0; end
    end
    always @* begin
        if (!old_q) assume (rst);
        if (bvalid) assume (whole_q != 0);                   // a bus that keeps rules
        if (group_valid) assume (group_addr[3:0] == 0 && (group_half || !group_addr[4]));
    end

    always @* if (old_q) begin
        assert (idle == (whole_q == 0 && !awvalid && !wvalid));
        if (cut) assert (group_ready);                       // what is thrown away never waits
        // invariant
        assert (\u_rules.beats_q == beat_q);
        assert (\u_dut.owed_q == whole_q + (awvalid || wvalid));
        if (wvalid) assert (beat_q <= awlen && \u_dut.left_q == awlen - beat_q);
        else assert (beat_q == 0);
        if (awvalid || wvalid) assert (awlen < 256 / DATA);
        if (awvalid) assert (awaddr[3:0] == 0 && (awlen < 128 / DATA || !awaddr[4]));
    end
endmodule
`default_nettype wire
