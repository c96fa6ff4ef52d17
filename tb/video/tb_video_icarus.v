// tb_video_icarus.v - two frames of a small mode in Icarus, decoded from the symbols and compared
// SPDX-License-Identifier: Apache-2.0
// Memory is a formula of the address; its port answers a burst at a time. The raster is counted
// from the first pixel after vertical blanking. Prints `ok` or `not ok` and ends by itself.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_modes.vh"
module tb_video_icarus;
    localparam [12:0] WIDTH = 13'd21, HEIGHT = 13'd7;
    localparam STRIDE = 96;
    reg clk = 1'b0, pix_clk = 1'b0, rst = 1'b1, enable = 1'b0;
    always #3 clk = !clk;
    always #5 pix_clk = !pix_clk;

    wire [`RT_MODE_BITS-1:0] mode;
    assign mode[`RT_MODE_H_ACTIVE] = WIDTH;
    assign mode[`RT_MODE_H_FRONT]  = 13'd3;
    assign mode[`RT_MODE_H_SYNC]   = 13'd4;
    assign mode[`RT_MODE_H_BACK]   = 13'd5;
    assign mode[`RT_MODE_V_ACTIVE] = HEIGHT;
    assign mode[`RT_MODE_V_FRONT]  = 13'd1;
    assign mode[`RT_MODE_V_SYNC]   = 13'd2;
    assign mode[`RT_MODE_V_BACK]   = 13'd9;
    assign mode[`RT_MODE_H_POL]    = 1'b1;
    assign mode[`RT_MODE_V_POL]    = 1'b0;

    // ---- frames: a base for each take ----
    wire        take, arvalid, underrun, blank, error, rready;
    reg  [31:0] base = 32'h0000_1fc0;
    always @(posedge clk) if (take) base <= base + 32'h0010_0040;

    // ---- memory: one burst at a time, 32 bits of a formula at each address ----
    function [31:0] word(input [31:0] addr);
        word = (addr >> 2) * 32'h9e37_79b1;
    endfunction
    wire [31:0] araddr;
    wire [7:0]  arlen;
    wire [2:0]  arsize;
    wire [1:0]  arburst;
    reg         busy = 1'b0;
    reg  [31:0] at;
    reg  [8:0]  left;
    reg  [1:0]  stall = 2'd0;
    wire        rvalid = busy && stall == 2'd0;
    always @(posedge clk) begin
        stall <= stall == 2'd2 ? 2'd0 : stall + 2'd1;
        if (arvalid && !busy) begin
            busy  <= 1'b1;
            at    <= araddr;
            left  <= {1'b0, arlen} + 9'd1;
        end
        if (rvalid) begin
            at   <= at + 32'd8;
            left <= left - 9'd1;
            if (left == 9'd1) busy <= 1'b0;
        end
    end

    wire        tvalid, tuser, tlast, de, hsync, vsync;
    wire [23:0] tdata;
    wire [9:0]  blue, green, red;
    rt_video #(.DATA(64), .BURST(4), .DEPTH(16)) u_video (
        .clk(clk), .rst(rst), .enable_i(enable), .forget_i(1'b0), .mode_i(mode), .format_i(1'b0),
        .stride_i(16'd96), .double_i(1'b0), .take_o(take), .show_valid_i(1'b1),
        .show_base_i(base), .blank_o(blank), .underrun_o(underrun), .error_o(error),
        .m_scan_arvalid(arvalid), .m_scan_arready(!busy), .m_scan_araddr(araddr),
        .m_scan_arlen(arlen), .m_scan_arsize(arsize), .m_scan_arburst(arburst),
        .m_scan_rvalid(rvalid), .m_scan_rready(rready), .m_scan_rdata({word(at + 4), word(at)}),
        .m_scan_rresp(2'b00), .m_scan_rlast(left == 9'd1), .pix_clk(pix_clk), .pix_rst(rst),
        .m_video_tvalid(tvalid), .m_video_tready(1'b1), .m_video_tdata(tdata),
        .m_video_tuser(tuser), .m_video_tlast(tlast), .de_o(de), .hsync_o(hsync),
        .vsync_o(vsync), .tmds0_o(blue), .tmds1_o(green), .tmds2_o(red)
    );

    // ---- display ----
    `include "tmds_decode.vh"
    wire [8:0]  b = decode(blue), g = decode(green), r = decode(red);
    integer x = 0, y = 0, frames = 0, wrong = 0, blanks = 0;
    wire [31:0] expected = word(base + y * STRIDE + x * 4);
    always @(posedge pix_clk) if (enable) begin
        if (b[8] !== g[8] || b[8] !== r[8]) wrong = wrong + (frames > 0);
        if (b[8] === 1'b1) begin
            if ({r[7:0], g[7:0], b[7:0]} !== expected[23:0]) wrong = wrong + 1;
            // between rows there are 12 clocks, between frames 12 rows of 33 more
            if (x == 0 && blanks != (y > 0 ? 12 : 12 + 12 * 33) && frames > 0) wrong = wrong + 1;
            blanks = 0;
            x = x + 1;
            if (x == WIDTH) begin
                x = 0;
                y = y + 1;
                if (y == HEIGHT) begin
                    y = 0;
                    frames = frames + 1;
                end
            end
        end else begin
            if (x != 0) wrong = wrong + 1;
            blanks = blanks + 1;
        end
    end
    always @(posedge clk) if (underrun || error) wrong = wrong + 1;

    initial begin
        #200 rst = 1'b0;
        #100 enable = 1'b1;
        #40000;
        if (wrong == 0 && frames >= 4) $display("ok tb_video_icarus: %0d frames", frames);
        else $display("not ok tb_video_icarus: %0d frames, %0d wrong", frames, wrong);
        $finish;
    end
endmodule
`default_nettype wire
