// rt_axi_read_two.v - two AXI4 read masters on one
// SPDX-License-Identifier: Apache-2.0
//   a, b --> [AR: in turn, one a clock] --> bus --> [R: b has the ID TAG_B, a all others]
// Nothing waits in here: no clock is added. What is offered stays until it is taken, as both
// masters keep theirs. Data and response go to both.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_axi_read_two #(
    parameter ADDR  = 32,                    // bits of an address, 32 to 40
    parameter [`RT_TAG_BITS-1:0] TAG_B = {`RT_TAG_BITS{1'b1}} // the ID of b, and of no request of a
) (
    input  wire            clk,
    input  wire            rst,              // synchronous, active high
    // master a
    input  wire            a_arvalid,
    output wire            a_arready,
    input  wire [`RT_TAG_BITS-1:0] a_arid,
    input  wire [ADDR-1:0] a_araddr,
    output wire            a_rvalid,
    input  wire            a_rready,
    // master b
    input  wire            b_arvalid,
    output wire            b_arready,
    input  wire [ADDR-1:0] b_araddr,
    output wire            b_rvalid,
    input  wire            b_rready,
    // AXI4
    output wire            m_arvalid,
    input  wire            m_arready,
    output wire [`RT_TAG_BITS-1:0] m_arid,
    output wire [ADDR-1:0] m_araddr,
    input  wire            m_rvalid,
    output wire            m_rready,
    input  wire [`RT_TAG_BITS-1:0] m_rid
);
    reg  held_q, of_b_q;                     // what is offered waits; it is, or was last, of b
    wire pick_b = held_q ? of_b_q : b_arvalid && !(a_arvalid && of_b_q);
    assign m_arvalid = pick_b ? b_arvalid : a_arvalid;
    assign m_arid    = pick_b ? TAG_B : a_arid;
    assign m_araddr  = pick_b ? b_araddr : a_araddr;
    assign a_arready = m_arready && !pick_b;
    assign b_arready = m_arready && pick_b;
    wire to_b = m_rid == TAG_B;
    assign a_rvalid  = m_rvalid && !to_b;
    assign b_rvalid  = m_rvalid && to_b;
    assign m_rready  = to_b ? b_rready : a_rready;
    always @(posedge clk) begin
        held_q <= m_arvalid && !m_arready;
        if (m_arvalid) of_b_q <= pick_b;
        if (rst) {held_q, of_b_q} <= 2'd0;
    end
endmodule
`default_nettype wire
