// f_axi_write_two.v - proof of rt_axi_write_two: bursts are whole, one behind the other; answers
// SPDX-License-Identifier: Apache-2.0
// Each master offers the address and the first beat of a burst in the same clock, keeps what it
// offers, and begins none before the last one is taken, as rt_axi_write does. Followed is one
// burst, any, to its answer.
`timescale 1ns / 1ps
`default_nettype none
module f_axi_write_two (
    input wire        clk,
    input wire        rst,
    input wire [1:0]  begins,            // of b, a: a burst begins, if none is under way
    input wire [3:0]  lengths,           // its beats less one
    input wire [1:0]  bready,
    input wire        m_awready,
    input wire        m_wready,
    input wire        m_bvalid
);
    // ---- two masters: address, number of the beat ----
    reg  [1:0]  aw_q, w_q;
    reg  [1:0]  left_q [0:1];
    reg  [1:0]  long_q [0:1];
    wire [1:0]  awready, wready, bvalid;
    wire        m_awvalid, m_wvalid, m_wlast, m_bready;
    wire [31:0] m_awaddr;
    wire [7:0]  m_awlen;
    wire [63:0] m_wdata;
    wire [7:0]  m_wstrb;
    rt_axi_write_two u_dut (
        .clk(clk), .rst(rst), .forget_i(1'b0), .a_awvalid(aw_q[0]), .a_awready(awready[0]),
        .a_awaddr(32'd0), .a_awlen({6'd0, long_q[0]}), .a_wvalid(w_q[0]), .a_wready(wready[0]),
        .a_wdata(64'd0), .a_wstrb(8'hff), .a_wlast(left_q[0] == 2'd0), .a_bvalid(bvalid[0]),
        .a_bready(bready[0]), .b_awvalid(aw_q[1]), .b_awready(awready[1]), .b_awaddr(32'd1),
        .b_awlen({6'd0, long_q[1]}), .b_wvalid(w_q[1]), .b_wready(wready[1]), .b_wdata(64'd1),
        .b_wstrb(8'hff), .b_wlast(left_q[1] == 2'd0), .b_bvalid(bvalid[1]), .b_bready(bready[1]),
        .m_awvalid(m_awvalid), .m_awready(m_awready), .m_awaddr(m_awaddr), .m_awlen(m_awlen),
        .m_wvalid(m_wvalid), .m_wready(m_wready), .m_wdata(m_wdata), .m_wstrb(m_wstrb),
        .m_wlast(m_wlast), .m_bvalid(m_bvalid), .m_bready(m_bready)
    );
    (* hierconn *) wire \u_dut.burst_q , \u_dut.of_b_q ;
    reg         old_q = 1'b0;
    genvar g;
    generate
        for (g = 0; g < 2; g = g + 1) begin : g_master
            wire free = (!aw_q[g] || awready[g]) && (!w_q[g] || (wready[g] && left_q[g] == 2'd0));
            always @(posedge clk) begin
                if (awready[g]) aw_q[g] <= 1'b0;
                if (w_q[g] && wready[g]) begin
                    left_q[g] <= left_q[g] - 1'b1;
                    if (left_q[g] == 2'd0) w_q[g] <= 1'b0;
                end
                if (free && begins[g]) begin
                    {aw_q[g], w_q[g]} <= 2'b11;
                    left_q[g] <= lengths[2*g +: 2];
                    long_q[g] <= lengths[2*g +: 2];
                end
                if (rst) {aw_q[g], w_q[g]} <= 2'b00;
            end
        end
    endgenerate

    // ---- the bus: a burst, its address and its beats, from the first to the last ----
    reg         aw_seen_q, owner_q, open_q;  // of the burst under way
    reg         wait_aw_q, wait_w_q, aw_of_q, w_of_q, last_q;
    reg  [7:0]  len_q;
    wire        aw_goes = m_awvalid && m_awready, w_goes = m_wvalid && m_wready;
    wire        w_ends  = w_goes && m_wlast;
    reg         w_seen_q;                    // its last beat was taken
    wire        ends = (aw_seen_q || aw_goes) && (w_seen_q || w_ends);
    wire        of = m_awvalid ? m_awaddr[0] : m_wdata[0];
    always @(posedge clk) begin
        old_q     <= 1'b1;
        wait_aw_q <= m_awvalid && !m_awready && !rst;
        wait_w_q  <= m_wvalid && !m_wready && !rst;
        {aw_of_q, len_q, w_of_q, last_q} <= {m_awaddr[0], m_awlen, m_wdata[0], m_wlast};
        aw_seen_q <= (aw_seen_q || aw_goes) && !ends;
        w_seen_q  <= (w_seen_q || w_ends) && !ends;
        open_q    <= (open_q || m_awvalid || m_wvalid) && !ends;
        if (!open_q) owner_q <= of;
        if (rst) {aw_seen_q, w_seen_q, open_q} <= 3'd0;
    end
    always @* if (!old_q) assume (rst);
    always @* if (old_q && !rst) begin
        if (wait_aw_q) assert (m_awvalid && {m_awaddr[0], m_awlen} == {aw_of_q, len_q});
        if (wait_w_q) assert (m_wvalid && {m_wdata[0], m_wlast} == {w_of_q, last_q});
        if (m_awvalid && m_wvalid) assert (m_awaddr[0] == m_wdata[0]);
        if (open_q && m_awvalid) assert (m_awaddr[0] == owner_q && !aw_seen_q);
        if (open_q && m_wvalid) assert (m_wdata[0] == owner_q && !w_seen_q);
        assert (m_awvalid || m_wvalid || aw_q == 2'd0);                  // somebody is served
        assert (bvalid != 2'b11);
        if (bvalid != 2'd0) assert (m_bvalid);
        if (m_bvalid && m_bready) assert ((bvalid & bready) == 2'b01 || (bvalid & bready) == 2'b10);
        // invariant
        assert (\u_dut.burst_q == open_q);
        if (open_q) assert (\u_dut.of_b_q == owner_q);
        if (open_q) assert (aw_seen_q == !aw_q[owner_q] && w_seen_q == !w_q[owner_q]);
        if (open_q) assert (aw_q[owner_q] || w_q[owner_q]);
        if (open_q) assert (aw_q[!owner_q] == w_q[!owner_q]);
        else assert (aw_q == w_q && !aw_seen_q && !w_seen_q);
    end
endmodule
`default_nettype wire
