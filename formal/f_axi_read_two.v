// f_axi_read_two.v - proof of rt_axi_read_two: requests stand and go once, in turn
// SPDX-License-Identifier: Apache-2.0
// Both masters keep what they offer until it is taken, as f_axi_read proves of theirs.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module f_axi_read_two (
    input wire        clk,
    input wire        rst,
    input wire        a_arvalid,
    input wire [`RT_TAG_BITS-1:0] a_arid,
    input wire [31:0] a_araddr,
    input wire        a_rready,
    input wire        b_arvalid,
    input wire [31:0] b_araddr,
    input wire        b_rready,
    input wire        m_arready,
    input wire        m_rvalid,
    input wire [`RT_TAG_BITS-1:0] m_rid
);
    localparam [`RT_TAG_BITS-1:0] TAG_B = {`RT_TAG_BITS{1'b1}};
    wire        a_arready, a_rvalid, b_arready, b_rvalid, m_arvalid, m_rready;
    wire [`RT_TAG_BITS-1:0] m_arid;
    wire [31:0] m_araddr;
    rt_axi_read_two u_dut (
        .clk(clk), .rst(rst), .a_arvalid(a_arvalid), .a_arready(a_arready), .a_arid(a_arid),
        .a_araddr(a_araddr), .a_rvalid(a_rvalid), .a_rready(a_rready), .b_arvalid(b_arvalid),
        .b_arready(b_arready), .b_araddr(b_araddr), .b_rvalid(b_rvalid), .b_rready(b_rready),
        .m_arvalid(m_arvalid), .m_arready(m_arready), .m_arid(m_arid), .m_araddr(m_araddr),
        .m_rvalid(m_rvalid), .m_rready(m_rready), .m_rid(m_rid)
    );
    reg  old_q = 1'b0, a_wait_q, b_wait_q, m_wait_q;
    reg  [`RT_TAG_BITS+31:0] a_q, m_q;
    reg  [31:0] b_q;
    reg  [1:0]  a_passed_q, b_passed_q;      // requests of the other taken while this one waits
    (* hierconn *) wire \u_dut.held_q , \u_dut.of_b_q ;
    wire a_goes = a_arvalid && a_arready, b_goes = b_arvalid && b_arready;
    always @(posedge clk) begin
        old_q    <= 1'b1;
        a_wait_q <= a_arvalid && !a_arready && !rst;
        b_wait_q <= b_arvalid && !b_arready && !rst;
        m_wait_q <= m_arvalid && !m_arready && !rst;
        a_q      <= {a_arid, a_araddr};
        b_q      <= b_araddr;
        m_q      <= {m_arid, m_araddr};
        a_passed_q <= rst || !a_arvalid || a_arready ? 2'd0 : a_passed_q + {1'b0, b_goes};
        b_passed_q <= rst || !b_arvalid || b_arready ? 2'd0 : b_passed_q + {1'b0, a_goes};
    end
    always @* begin
        if (!old_q) assume (rst);
        if (a_arvalid) assume (a_arid != TAG_B);
        if (a_wait_q) assume (a_arvalid && {a_arid, a_araddr} == a_q);
        if (b_wait_q) assume (b_arvalid && b_araddr == b_q);
    end
    always @* if (old_q && !rst) begin
        if (m_wait_q) assert (m_arvalid && {m_arid, m_araddr} == m_q);
        assert (m_arvalid == (a_arvalid || b_arvalid));
        assert ((m_arvalid && m_arready) == (a_goes || b_goes) && !(a_goes && b_goes));
        if (a_goes) assert (m_arid == a_arid && m_araddr == a_araddr);
        if (b_goes) assert (m_arid == TAG_B && m_araddr == b_araddr);
        assert (a_passed_q <= 2'd1 && b_passed_q <= 2'd1);
        assert (!(a_rvalid && b_rvalid) && (a_rvalid || b_rvalid) == m_rvalid);
        if (m_rvalid) assert (b_rvalid == (m_rid == TAG_B));
        assert (m_rready == (m_rid == TAG_B ? b_rready : a_rready));
        // invariant
        if (\u_dut.held_q ) assert (m_wait_q && (\u_dut.of_b_q ? b_wait_q : a_wait_q));
        if (m_wait_q) assert (\u_dut.held_q );
        if (a_passed_q == 2'd1) assert (\u_dut.of_b_q != \u_dut.held_q );
        if (b_passed_q == 2'd1) assert (\u_dut.of_b_q == \u_dut.held_q );
    end
endmodule
`default_nettype wire
