// f_axi_read.v - proof of rt_axi_read: rules of AXI4, every beat once, nothing that is not owed
// SPDX-License-Identifier: Apache-2.0
// The bus gives beats of bursts that it took, of any ID, in any clock. The core waits for PENDING
// lines at most. rt_run cuts the core off until the bus owes nothing, or forgets; resets may come
// at any time.
`include "axi_rules.vh"
`timescale 1ns / 1ps
`default_nettype none
module f_axi_read #(
    parameter DATA = 64,
    parameter PENDING = 4,
    parameter ADDR = 32
) (
    input wire        clk,
    input wire        rst,
    input wire        begins,
    input wire [ADDR-1:0] base,
    input wire        cut,
    input wire        forget,
    input wire        req_valid,
    input wire [25:0] req_line,
    input wire [4:0]  req_tag,
    input wire        rsp_ready,
    input wire        arready,
    input wire        rvalid,
    input wire [4:0]  rid,
    input wire [DATA-1:0] rdata,
    input wire [1:0]  rresp,
    input wire        rlast
);
    localparam BEATS = 256 / DATA;
    localparam CB = $clog2(PENDING * BEATS + 1);
    wire idle, req_ready, rsp_valid, rsp_error, arvalid, rready;
    wire [ADDR-1:0] araddr;
    wire [7:0]  arlen;
    wire [4:0]  arid, rsp_tag;
    wire [DATA-1:0] rsp_data;
    rt_axi_read #(.DATA(DATA), .PENDING(PENDING), .ADDR(ADDR)) u_dut (
        .clk(clk), .rst(rst), .begin_i(begins), .base_i(base), .cut_i(cut),
        .forget_i(forget), .idle_o(idle), .stall_o(), .slverr_o(), .decerr_o(), .burst_o(),
        .beat_o(), .req_valid_i(req_valid), .req_ready_o(req_ready), .req_line_i(req_line),
        .req_tag_i(req_tag), .rsp_valid_o(rsp_valid), .rsp_ready_i(rsp_ready),
        .rsp_tag_o(rsp_tag), .rsp_data_o(rsp_data), .rsp_error_o(rsp_error),
        .m_arvalid(arvalid), .m_arready(arready), .m_arid(arid), .m_araddr(araddr),
        .m_arlen(arlen), .m_rvalid(rvalid), .m_rready(rready), .m_rid(rid), .m_rdata(rdata),
        .m_rresp(rresp), .m_rlast(rlast)
    );
    axi_read_rules #(.DATA(DATA), .ADDR(ADDR)) u_rules (
        .clk(clk), .rst(rst), .anew(forget), .arvalid(arvalid), .arready(arready), .arid(arid),
        .araddr(araddr), .arlen(arlen)
    );
    (* hierconn *) wire [CB-1:0] \u_dut.owed_q ;
    (* hierconn *) wire [ADDR-1:0] \u_dut.base_q ;

    // ---- model: beats that the bus owes of what it took, and that the core waits for ----
    reg          old_q = 1'b0;
    reg [CB-1:0] bus_q, core_q;
    reg [ADDR-1:0] base_q;
    wire ar   = arvalid && arready;
    wire beat = rvalid && rready;
    wire take = req_valid && req_ready;
    wire give = rsp_valid && rsp_ready;
    always @(posedge clk) begin
        old_q  <= 1'b1;
        bus_q  <= bus_q + (ar ? BEATS : 0) - beat;
        core_q <= core_q + (take ? BEATS : 0) - give;
        if (begins) base_q <= base;
        if (rst || forget || cut) core_q <= 0;
        if (rst || forget) bus_q <= 0;
    end

    // ---- last clock, and what is assumed of the core, of rt_run and of the bus ----
    reg cut_q, idle_q, anew_q, forget_q, wait_q, take_q;
    reg begun_q = 1'b0;                  // there was a frame
    reg [ADDR+4:0] taken_q;
    always @(posedge clk) begin
        cut_q     <= cut;
        begun_q   <= begun_q || begins;
        idle_q    <= idle;
        anew_q    <= rst || forget;
        forget_q  <= forget && !rst;
        wait_q    <= arvalid && !arready && !rst && !forget;
        take_q    <= take && !rst && !forget;
        taken_q   <= {req_tag, base_q + {1'b0, req_line, 5'd0}};
    end
    always @* begin
        if (!old_q) assume (rst && !begun_q);
        if (old_q && !anew_q && cut_q && !idle_q) assume (cut);          // until it is idle
        assume (base[11:0] == 0);                                        // of rt_control
        if (rvalid) assume (bus_q != 0);                                 // a bus that keeps rules
        if (rst || forget_q) assume (cut);
        if (!begun_q || core_q > BEATS * (PENDING - 1)) assume (!req_valid);
    end

    always @* if (old_q) begin
        if (take_q) assert (arvalid && {arid, araddr} == taken_q);       // as the core asked
        assert (arlen == BEATS - 1);
        if (arvalid) assert (wait_q || take_q);                          // nothing else, nor twice
        if (rready) assert (bus_q != 0 || arvalid);                      // nothing unasked is taken
        if (rsp_valid) assert (core_q != 0);                             // nor given to the core
        assert (idle == (bus_q == 0 && !arvalid));
        if (cut && rvalid) assert (rready);                              // never stuck
        if (!cut && rvalid && rsp_ready) assert (give);
        if (cut) assert (!rsp_valid);
        if (!cut) assert (give == beat);                                 // nothing lost
        if (give) assert (rsp_error == rresp[1] && rsp_tag == rid && rsp_data == rdata);
        if (req_valid && !cut && (!arvalid || arready)) assert (take);
        // invariant
        assert (\u_dut.owed_q == bus_q + (arvalid ? BEATS : 0));
        assert (\u_dut.owed_q <= BEATS * PENDING);
        if (!cut) assert (core_q == \u_dut.owed_q );
        if (begun_q) assert (\u_dut.base_q == base_q && base_q[11:0] == 0);
        if (arvalid || bus_q != 0 || core_q != 0) assert (begun_q);
        if (arvalid) assert (araddr[4:0] == 0);
    end
endmodule
`default_nettype wire
