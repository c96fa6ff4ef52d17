// f_axi_read.v - proof of rt_axi_read: rules of AXI4, four beats a line, nothing that is not owed
// SPDX-License-Identifier: Apache-2.0
// The bus gives beats of bursts that it took, in any clock. rt_run gives the bus up, cuts the core
// off until the bus owes nothing, or forgets; resets may come at any time.
`timescale 1ns / 1ps
`default_nettype none
module f_axi_read #(
    parameter DATA = 64,
    parameter PENDING = 4
) (
    input wire        clk,
    input wire        rst,
    input wire        begins,
    input wire [31:0] base,
    input wire        cut,
    input wire        dead,
    input wire        forget,
    input wire        req_valid,
    input wire [25:0] req_line,
    input wire        rsp_ready,
    input wire        arready,
    input wire        rvalid,
    input wire [DATA-1:0] rdata,
    input wire [1:0]  rresp,
    input wire        rlast
);
    localparam BEATS = 256 / DATA;
    localparam CB = $clog2(PENDING + 1);
    wire idle, req_ready, rsp_valid, rsp_error, arvalid, rready;
    wire [31:0] araddr;
    wire [7:0]  arlen;
    wire [63:0] rsp_data;
    rt_axi_read #(.DATA(DATA), .PENDING(PENDING)) u_dut (
        .clk(clk), .rst(rst), .begin_i(begins), .base_i(base), .cut_i(cut), .dead_i(dead),
        .forget_i(forget), .idle_o(idle), .stall_o(), .slverr_o(), .decerr_o(), .burst_o(),
        .beat_o(), .req_valid_i(req_valid), .req_ready_o(req_ready), .req_line_i(req_line),
        .rsp_valid_o(rsp_valid), .rsp_ready_i(rsp_ready), .rsp_data_o(rsp_data),
        .rsp_error_o(rsp_error), .m_arvalid(arvalid), .m_arready(arready), .m_araddr(araddr),
        .m_arlen(arlen), .m_rvalid(rvalid), .m_rready(rready), .m_rdata(rdata), .m_rresp(rresp),
        .m_rlast(rlast)
    );
    (* hierconn *) wire [CB-1:0] \u_dut.owed_q ;
    (* hierconn *) wire [CB-1:0] \u_dut.bus_q ;
    (* hierconn *) wire [1:0]    \u_dut.owed_beat_q ;
    (* hierconn *) wire [1:0]    \u_dut.bus_beat_q ;
    (* hierconn *) wire [31:0]   \u_dut.base_q ;

    // ---- model: bursts that the bus took, lines that the core asked for ----
    reg          old_q = 1'b0;
    reg [CB-1:0] taken_q;                // bursts taken, not all of their beats given
    reg [2:0]    beats_q;                // of the first of them
    reg [CB-1:0] lines_q;                // lines asked for, not all of their beats given
    reg [1:0]    quarter_q;              // of the first of them
    wire ar   = arvalid && arready;
    wire beat = rvalid && rready;
    wire last = beat && beats_q == BEATS - 1;
    wire give = rsp_valid && rsp_ready;
    always @(posedge clk) begin
        old_q     <= 1'b1;
        taken_q   <= taken_q + ar - last;
        beats_q   <= last ? 0 : beats_q + beat;
        lines_q   <= lines_q + (req_valid && req_ready) - (give && quarter_q == 3);
        quarter_q <= quarter_q + give;
        if (rst || forget || cut) begin lines_q <= 0; quarter_q <= 0; end
        if (rst || forget) begin taken_q <= 0; beats_q <= 0; end
    end

    // ---- last clock, and what is assumed of rt_run and of the bus ----
    reg cut_q, dead_q, idle_q, anew_q, wait_q;
    reg begun_q = 1'b0;                  // there was a frame
    reg [31:0] addr_q;
    always @(posedge clk) begin
        cut_q  <= cut;
        begun_q <= begun_q || begins;
        dead_q <= dead;
        idle_q <= idle;
        anew_q <= rst || forget;
        wait_q <= arvalid && !arready && !rst && !forget;
        addr_q <= araddr;
    end
    always @* begin
        if (!old_q) assume (rst && !begun_q);
        if (old_q && !anew_q && cut_q && !idle_q) assume (cut);          // until it is idle
        if (old_q && !anew_q && dead_q && !cut_q) assume (dead || cut);
        if (old_q && !anew_q && dead_q && cut_q && !idle_q) assume (dead);
        assume (base[11:0] == 0);                                        // of rt_control
        if (rvalid) assume (taken_q != 0);                               // a bus that keeps rules
        if (rst) assume (!cut && !dead);
        if (!begun_q) assume (!req_valid);
    end

    always @* if (old_q) begin
        if (wait_q) assert (arvalid && araddr == addr_q);                // stable until ready
        assert (arlen == BEATS - 1);
        if (arvalid) assert (araddr[4:0] == 0 && {1'b0, araddr[11:0]} + 32 <= 4096);
        if (rready) assert (taken_q != 0 || arvalid);                    // nothing unasked is taken
        if (rsp_valid) assert (lines_q != 0);                            // nor given to the core
        assert (idle == (taken_q == 0 && !arvalid));
        if ((cut || dead) && rvalid) assert (rready);                    // never stuck
        if (dead && !cut && lines_q != 0) assert (rsp_valid && rsp_error);
        if (!cut && !dead && rvalid && rsp_ready) assert (give);
        if (give && !dead) assert (rsp_error == rresp[1]);
        // invariant
        assert (\u_dut.bus_q == taken_q + arvalid && \u_dut.bus_q <= PENDING);
        assert (\u_dut.bus_beat_q == beats_q && beats_q < BEATS);
        assert (\u_dut.owed_q == lines_q && \u_dut.owed_beat_q == quarter_q);
        assert (lines_q <= PENDING);
        if (beats_q != 0) assert (taken_q != 0);
        if (quarter_q != 0) assert (lines_q != 0);
        if (!cut && !dead)
            assert (lines_q == taken_q + arvalid &&
                    beats_q == (DATA == 64 ? quarter_q : quarter_q / 2));
        if (begun_q) assert (\u_dut.base_q [11:0] == 0);
        if (arvalid || taken_q != 0 || lines_q != 0) assert (begun_q);
        if (arvalid) assert (araddr[4:0] == 0);
    end
endmodule
`default_nettype wire
