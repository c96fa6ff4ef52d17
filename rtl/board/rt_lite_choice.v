// rt_lite_choice.v - two masters of one AXI4-Lite block, an access at a time
// SPDX-License-Identifier: Apache-2.0
//   the one that asks first has the block until it is answered; of two the first
// A master asks for a read or a write, not for both, and takes an answer at once.
`timescale 1ns / 1ps
`default_nettype none
module rt_lite_choice (
    input  wire        clk,
    input  wire        rst,
    // masters: 0 in the low field
    input  wire [1:0]  s_awvalid,
    output wire [1:0]  s_awready,
    input  wire [23:0] s_awaddr,
    input  wire [1:0]  s_wvalid,
    output wire [1:0]  s_wready,
    input  wire [63:0] s_wdata,
    output wire [1:0]  s_bvalid,
    input  wire [1:0]  s_arvalid,
    output wire [1:0]  s_arready,
    input  wire [23:0] s_araddr,
    output wire [1:0]  s_rvalid,
    // the block; data and kinds of answers are for both
    output wire        m_awvalid,
    input  wire        m_awready,
    output wire [11:0] m_awaddr,
    output wire        m_wvalid,
    input  wire        m_wready,
    output wire [31:0] m_wdata,
    input  wire        m_bvalid,
    output wire        m_arvalid,
    input  wire        m_arready,
    output wire [11:0] m_araddr,
    input  wire        m_rvalid
);
    reg        open_q, owner_q;           // a master has the block; which one
    wire [1:0] asks = s_awvalid | s_wvalid | s_arvalid;
    wire [1:0] mine = open_q ? {owner_q, !owner_q} : 2'b00;
    assign m_awvalid = |(s_awvalid & mine);
    assign m_wvalid  = |(s_wvalid & mine);
    assign m_arvalid = |(s_arvalid & mine);
    assign m_awaddr  = owner_q ? s_awaddr[23:12] : s_awaddr[11:0];
    assign m_araddr  = owner_q ? s_araddr[23:12] : s_araddr[11:0];
    assign m_wdata   = owner_q ? s_wdata[63:32] : s_wdata[31:0];
    assign s_awready = {2{m_awready}} & mine;
    assign s_wready  = {2{m_wready}} & mine;
    assign s_arready = {2{m_arready}} & mine;
    assign s_bvalid  = {2{m_bvalid}} & mine;
    assign s_rvalid  = {2{m_rvalid}} & mine;
    always @(posedge clk) begin
        if (!open_q) begin
            open_q  <= |asks;
            owner_q <= !asks[0];
        end else if (m_bvalid || m_rvalid) begin
            open_q <= 1'b0;
        end
        if (rst) open_q <= 1'b0;
    end
endmodule
`default_nettype wire
