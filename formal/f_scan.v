// f_scan.v - proof of rt_scan: the rules of an AXI4 reader, whole rows, no word without room
// SPDX-License-Identifier: Apache-2.0
// The display, the bus and the queue stall at any time and frames begin at any time, but the bus
// answers only what was asked, and size, stride, format and enable_i change between frames only.
// An address waits unchanged; a burst stays within 4 KiB; the bursts of a row follow each other and
// end with its last byte; every beat finds room; a header is written when no beat is on its way.
`include "axi_rules.vh"
`timescale 1ns / 1ps
`default_nettype none
module f_scan #(
    parameter DATA  = 64,
    parameter BURST = 4,
    parameter DEPTH = 16,
    parameter ADDR  = 32,
    parameter CB    = $clog2(DEPTH) + 1
) (
    input wire        clk,
    input wire        rst,
    input wire        enable,
    input wire        forget,        // the bus was reset
    input wire        frame,
    input wire        show_valid,
    input wire [ADDR-1:0] show_base,
    input wire        arready,
    input wire        rvalid,
    input wire [DATA-1:0] rdata,
    input wire [1:0]  rresp,
    input wire        leaves         // a word leaves the queue
);
    localparam BYTES = DATA / 8;
    (* anyconst *) wire [12:0] h_active;
    (* anyconst *) wire [12:0] v_active;
    (* anyconst *) wire        rgb565;
    (* anyconst *) wire        twice;
    (* anyconst *) wire [15:0] stride;
    wire arvalid, rready, take, word_valid, error, stall;
    wire [ADDR-1:0] araddr;
    wire [7:0]  arlen;
    wire [2:0]  arsize;
    wire [1:0]  arburst;
    wire [DATA+1:0] word;
    reg  [CB-1:0] count_q;           // words of the queue
    rt_scan #(.DATA(DATA), .BURST(BURST), .DEPTH(DEPTH), .ADDR(ADDR)) u_dut (
        .clk(clk), .rst(rst), .enable_i(enable), .forget_i(forget), .h_active_i(h_active),
        .v_active_i(v_active),
        .rgb565_i(rgb565), .double_i(twice), .stride_i(stride), .frame_i(frame), .take_o(take),
        .show_valid_i(show_valid), .show_base_i(show_base), .m_scan_arvalid(arvalid),
        .m_scan_arready(arready), .m_scan_araddr(araddr), .m_scan_arlen(arlen),
        .m_scan_arsize(arsize), .m_scan_arburst(arburst), .m_scan_rvalid(rvalid),
        .m_scan_rready(rready), .m_scan_rdata(rdata), .m_scan_rresp(rresp), .error_o(error),
        .stall_o(stall), .idle_o(), .word_valid_o(word_valid), .word_data_o(word),
        .word_count_i(count_q)
    );
    axi_read_rules #(.DATA(DATA), .ADDR(ADDR), .ID(1), .MOST(BURST)) u_rules (
        .clk(clk), .rst(rst), .anew(forget), .arvalid(arvalid), .arready(arready), .arid(1'b0),
        .araddr(araddr), .arlen(arlen)
    );
    (* hierconn *) wire [CB-1:0] \u_dut.owed_q ;
    (* hierconn *) wire          \u_dut.read_q ;
    (* hierconn *) wire          \u_dut.stale_q ;
    (* hierconn *) wire [ADDR-1:0] \u_dut.row_q ;
    (* hierconn *) wire [ADDR-1:0] \u_dut.addr_q ;
    (* hierconn *) wire [12:0]   \u_dut.left_q ;
    (* hierconn *) wire [12:0]   \u_dut.rows_q ;
    (* hierconn *) wire          \u_dut.begin_q ;
    (* hierconn *) wire          \u_dut.room_q ;
    (* hierconn *) wire          \u_dut.short ;
    (* hierconn *) wire          \u_dut.short_q ;
    (* hierconn *) wire [$clog2(BURST):0] \u_dut.length ;
    (* hierconn *) wire [$clog2(BURST):0] \u_dut.length_q ;

    // ---- model: beats that the bus owes, words of the queue ----
    reg          old_q = 1'b0;
    reg [CB+8:0] owed_q;             // asked for and not yet come
    wire         ask  = arvalid && arready;
    wire         beat = rvalid && rready;
    wire [CB+8:0] length = {{(CB+1){1'b0}}, arlen} + 1'b1;
    always @(posedge clk) begin
        old_q       <= 1'b1;
        owed_q      <= owed_q + (ask ? length : 1'b0) - beat;
        count_q     <= count_q + word_valid - (leaves && count_q != 0);
        if (rst || forget) owed_q <= 0;
        if (rst) count_q <= 0;
    end
    wire [15:0] row_bytes = ((h_active + {12'd0, twice}) >> twice) << (rgb565 ? 1 : 2);
    wire [15:0] beats     = (row_bytes + (BYTES - 1)) / BYTES;
    always @* begin
        if (!old_q) assume (rst);
        assume (h_active != 0 && v_active != 0 && stride[3:0] == 0 && show_base[5:0] == 0);
        if (rvalid) assume (owed_q != 0);
    end

    always @* if (old_q) begin
        if (arvalid) assert (araddr % BYTES == 0 && arlen < BURST);
        assert (arburst == 2'b01 && (1 << arsize) == BYTES);
        assert (rready);                                              // a beat never waits
        if (word_valid) assert (count_q < DEPTH);                     // there is room
        if (word_valid && word[DATA+1]) assert (owed_q == 0 && !arvalid);
        if (word_valid && !word[DATA+1]) assert (beat && word[DATA-1:0] == rdata);
        assert (stall == ((owed_q != 0 || arvalid) && !rvalid && !ask));
        if (error) assert (beat && rresp[1]);
        if (beat && rresp[1]) assert (error);
        // invariant
        assert (owed_q <= DEPTH);
        assert (\u_dut.owed_q == owed_q + (arvalid ? length : 1'b0));
        assert ({1'b0, count_q} + {1'b0, \u_dut.owed_q } <= DEPTH);
        if (\u_dut.begin_q ) assert (\u_dut.stale_q );
        if (\u_dut.room_q && !arvalid)
            assert ({1'b0, count_q} + {1'b0, \u_dut.owed_q } <= DEPTH - BURST);
        if (\u_dut.room_q && !arvalid && \u_dut.read_q )
            assert (\u_dut.length_q == \u_dut.length && \u_dut.short_q == \u_dut.short );
        if (\u_dut.read_q && !\u_dut.stale_q ) begin
            assert (\u_dut.left_q >= 1 && \u_dut.left_q <= beats && \u_dut.rows_q != 0);
            assert (\u_dut.addr_q + \u_dut.left_q * BYTES == \u_dut.row_q + beats * BYTES);
            assert (\u_dut.row_q % 16 == 0);
        end
    end
endmodule
`default_nettype wire
