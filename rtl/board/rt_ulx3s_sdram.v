// rt_ulx3s_sdram.v - a ULX3S that draws and shows machines out of its SDRAM, loaded over its UART
// SPDX-License-Identifier: Apache-2.0
//   UART --> rt_uart_bus --> registers --> rt_lite_choice --> rt_top --> TMDS --> rt_serialise
//                      `---> memory --.         ^             |  ^  ^             --> GPDI
//   buttons --> rt_pick --------------+---------'       scene |  |  | display
//                                     `--> rt_sdram_bus <-----+--+--'
//                                             `--> rt_sdram_pins --> SDRAM
// 640x480, or 320x240 doubled; three frames. The core has the clock of the pixels.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_board.vh"
`include "rt_layout.vh"
module rt_ulx3s_sdram #(
    parameter DIV   = 25,                 // clocks a bit of the UART: 1 Mbit/s
    parameter STILL = 18,                 // log2 of the clocks between two looks at a button
    parameter POWER = 12500               // clocks of 16 ns before the SDRAM's first command
) (
    input  wire        clk_25mhz,
    input  wire [6:0]  btn_i,             // 1: anew; 6 (right): next machine; 5 (left): before
    input  wire        uart_rx_i,
    output wire        uart_tx_o,
    output wire [3:0]  gpdi_o,            // blue, green, red, clock
    output wire [7:0]  led_o,             // alive, of UART, shown, error; number of the machine
    output wire        sdram_clk_o,
    output wire        sdram_cke_o,
    output wire        sdram_cs_n_o,
    output wire        sdram_ras_n_o,
    output wire        sdram_cas_n_o,
    output wire        sdram_we_n_o,
    output wire [1:0]  sdram_ba_o,
    output wire [12:0] sdram_a_o,
    output wire [1:0]  sdram_dqm_o,
    inout  wire [15:0] sdram_dq_io
);
    wire clk, clk5, rst, mem_clk, mem_rst;
    rt_clocks u_clocks (
        .clk_25mhz(clk_25mhz), .restart_i(btn_i[1]), .clk(clk), .clk5(clk5), .mem_clk(mem_clk),
        .rst_o(rst), .mem_rst_o(mem_rst)
    );

    // ---- who writes registers: 0 UART, 1 buttons ----
    wire [1:0]  l_awvalid, l_awready, l_wvalid, l_wready, l_bvalid, l_arvalid, l_arready, l_rvalid;
    wire        awvalid, awready, wvalid, wready, bvalid, arvalid, arready, rvalid;
    wire [11:0] awaddr, araddr;
    wire [31:0] wdata, rdata;
    wire [1:0]  bresp, rresp;
    wire [31:0] uart_address, uart_data, pick_data;
    wire [11:0] pick_awaddr, pick_araddr;
    wire [5:0]  number;
    rt_lite_choice u_choice (
        .clk(clk), .rst(rst), .s_awvalid(l_awvalid), .s_awready(l_awready),
        .s_awaddr({pick_awaddr, uart_address[11:0]}), .s_wvalid(l_wvalid), .s_wready(l_wready),
        .s_wdata({pick_data, uart_data}), .s_bvalid(l_bvalid), .s_arvalid(l_arvalid),
        .s_arready(l_arready), .s_araddr({pick_araddr, uart_address[11:0]}), .s_rvalid(l_rvalid),
        .m_awvalid(awvalid), .m_awready(awready), .m_awaddr(awaddr), .m_wvalid(wvalid),
        .m_wready(wready), .m_wdata(wdata), .m_bvalid(bvalid), .m_arvalid(arvalid),
        .m_arready(arready), .m_araddr(araddr), .m_rvalid(rvalid)
    );

    // ---- ports of memory: readers 0 display, 1 scene, 2 buttons; writers 0 frame, 1 UART ----
    wire [2:0]   m_arvalid, m_arready, m_rvalid, m_rready, m_rlast;
    wire [31:0]  scan_araddr, scene_araddr, pick_m_araddr;
    wire [7:0]   scan_arlen, scene_arlen;
    wire [191:0] m_rdata;
    wire [1:0]   m_awvalid, m_awready, m_wvalid, m_wready, m_bvalid, m_bready;
    wire [31:0]  frame_awaddr;
    wire [63:0]  frame_wdata;
    wire [7:0]   frame_wstrb, uart_wstrb;
    wire         frame_wlast, dq_oe;
    wire [15:0]  dq_out, dq_in;
    rt_sdram_bus #(.READS(3), .WRITES(2), .POWER(POWER)) u_memory (
        .clk(clk), .rst(rst), .s_arvalid(m_arvalid), .s_arready(m_arready),
        .s_araddr({pick_m_araddr, scene_araddr, scan_araddr}),
        .s_arlen({8'd0, scene_arlen, scan_arlen}), .s_rvalid(m_rvalid), .s_rready(m_rready),
        .s_rdata(m_rdata), .s_rlast(m_rlast), .s_awvalid(m_awvalid), .s_awready(m_awready),
        .s_awaddr({uart_address, frame_awaddr}), .s_wvalid(m_wvalid), .s_wready(m_wready),
        .s_wdata({uart_data, uart_data, frame_wdata}), .s_wstrb({uart_wstrb, frame_wstrb}),
        .s_wlast({1'b1, frame_wlast}), .s_bvalid(m_bvalid), .s_bready(m_bready),
        .mem_clk(mem_clk), .mem_rst(mem_rst), .cke_o(sdram_cke_o),
        .command_o({sdram_cs_n_o, sdram_ras_n_o, sdram_cas_n_o, sdram_we_n_o}),
        .ba_o(sdram_ba_o), .a_o(sdram_a_o), .dqm_o(sdram_dqm_o), .dq_o(dq_out), .dq_oe_o(dq_oe),
        .dq_i(dq_in)
    );
    rt_sdram_pins u_pins (
        .clk(mem_clk), .clk_o(sdram_clk_o), .dq_io(sdram_dq_io), .dq_i(dq_out), .dq_oe_i(dq_oe),
        .dq_o(dq_in)
    );
    wire [`RT_TAG_BITS-1:0] scene_arid, scene_rid;
    wire        ids_room, ids_there;      // always, and with every answer
    rt_fifo #(.WIDTH(`RT_TAG_BITS), .DEPTH(`RT_BOARD_PENDING)) u_scene_ids (
        .clk(clk), .rst(rst), .in_valid_i(m_arvalid[1] && m_arready[1]), .in_ready_o(ids_room),
        .in_data_i(scene_arid), .out_valid_o(ids_there),
        .out_ready_i(m_rvalid[1] && m_rready[1] && m_rlast[1]), .out_data_o(scene_rid)
    );

    // ---- UART, buttons ----
    assign m_bready[1] = 1'b1;
    assign m_rready[2] = 1'b1;
    rt_uart_bus #(.DIV(DIV)) u_uart (
        .clk(clk), .rst(rst), .rx_i(uart_rx_i), .tx_o(uart_tx_o), .r_awvalid(l_awvalid[0]),
        .r_awready(l_awready[0]), .r_wvalid(l_wvalid[0]), .r_wready(l_wready[0]),
        .r_bvalid(l_bvalid[0]), .r_bresp(bresp), .r_arvalid(l_arvalid[0]),
        .r_arready(l_arready[0]), .r_rvalid(l_rvalid[0]), .r_rdata(rdata), .r_rresp(rresp),
        .m_awvalid(m_awvalid[1]), .m_awready(m_awready[1]), .m_wvalid(m_wvalid[1]),
        .m_wready(m_wready[1]), .m_wstrb(uart_wstrb), .m_bvalid(m_bvalid[1]), .m_bresp(2'd0),
        .address_o(uart_address), .data_o(uart_data)
    );
    rt_pick #(.STILL(STILL)) u_pick (
        .clk(clk), .rst(rst), .next_i(btn_i[6]), .before_i(btn_i[5]), .number_o(number),
        .m_arvalid(m_arvalid[2]), .m_arready(m_arready[2]), .m_araddr(pick_m_araddr),
        .m_rvalid(m_rvalid[2]), .m_rdata(m_rdata[191:128]), .r_awvalid(l_awvalid[1]),
        .r_awready(l_awready[1]), .r_awaddr(pick_awaddr), .r_wvalid(l_wvalid[1]),
        .r_wready(l_wready[1]), .r_wdata(pick_data), .r_bvalid(l_bvalid[1]),
        .r_arvalid(l_arvalid[1]), .r_arready(l_arready[1]), .r_araddr(pick_araddr),
        .r_rvalid(l_rvalid[1]), .r_rdata(rdata)
    );

    // ---- the block ----
    wire       shown, irq;
    wire [9:0] blue, green, red;
    // what nothing here looks at
    wire no_video_tvalid, no_video_tuser, no_video_tlast, no_de, no_hsync, no_vsync;
    wire [1:0] no_scene_arburst, no_frame_awburst, no_scan_arburst;
    wire [2:0] no_scene_arsize, no_frame_awsize, no_scan_arsize;
    wire [7:0] no_frame_awlen;
    wire [23:0] no_video_tdata;
    wire [31:0] no_show_base;
    wire [2:0] no_scene_arprot, no_frame_awprot, no_scan_arprot;
    wire [3:0] no_scene_arcache, no_scene_arqos, no_frame_awcache, no_frame_awqos,
               no_scan_arcache, no_scan_arqos;
    wire [4:0] no_frame_awid, no_scan_arid;
    wire no_active;
    rt_top #(`RT_BOARD_CORE) u_top (
        .m_scene_arcache(no_scene_arcache), .m_scene_arprot(no_scene_arprot),
        .m_scene_arqos(no_scene_arqos), .m_frame_awid(no_frame_awid),
        .m_frame_awcache(no_frame_awcache), .m_frame_awprot(no_frame_awprot),
        .m_frame_awqos(no_frame_awqos), .m_scan_arid(no_scan_arid),
        .m_scan_arcache(no_scan_arcache), .m_scan_arprot(no_scan_arprot),
        .m_scan_arqos(no_scan_arqos), .active_o(no_active),
        .clk(clk), .rst(rst), .irq_o(irq), .s_axil_awvalid(awvalid), .s_axil_awready(awready),
        .s_axil_awaddr(awaddr), .s_axil_wvalid(wvalid), .s_axil_wready(wready),
        .s_axil_wdata(wdata), .s_axil_wstrb(4'hf), .s_axil_bvalid(bvalid), .s_axil_bready(1'b1),
        .s_axil_bresp(bresp), .s_axil_arvalid(arvalid), .s_axil_arready(arready),
        .s_axil_araddr(araddr), .s_axil_rvalid(rvalid), .s_axil_rready(1'b1),
        .s_axil_rdata(rdata), .s_axil_rresp(rresp), .m_scene_arvalid(m_arvalid[1]),
        .m_scene_arready(m_arready[1]), .m_scene_arid(scene_arid), .m_scene_araddr(scene_araddr),
        .m_scene_arlen(scene_arlen), .m_scene_arsize(no_scene_arsize),
        .m_scene_arburst(no_scene_arburst), .m_scene_rvalid(m_rvalid[1]),
        .m_scene_rready(m_rready[1]), .m_scene_rid(scene_rid), .m_scene_rdata(m_rdata[127:64]),
        .m_scene_rresp(2'd0), .m_scene_rlast(m_rlast[1]), .m_frame_awvalid(m_awvalid[0]),
        .m_frame_awready(m_awready[0]), .m_frame_awaddr(frame_awaddr),
        .m_frame_awlen(no_frame_awlen), .m_frame_awsize(no_frame_awsize),
        .m_frame_awburst(no_frame_awburst), .m_frame_wvalid(m_wvalid[0]),
        .m_frame_wready(m_wready[0]), .m_frame_wdata(frame_wdata), .m_frame_wstrb(frame_wstrb),
        .m_frame_wlast(frame_wlast), .m_frame_bvalid(m_bvalid[0]), .m_frame_bready(m_bready[0]),
        .m_frame_bresp(2'd0), .take_i(1'b0), .show_valid_o(shown), .show_base_o(no_show_base),
        .m_scan_arvalid(m_arvalid[0]), .m_scan_arready(m_arready[0]), .m_scan_araddr(scan_araddr),
        .m_scan_arlen(scan_arlen), .m_scan_arsize(no_scan_arsize),
        .m_scan_arburst(no_scan_arburst), .m_scan_rvalid(m_rvalid[0]),
        .m_scan_rready(m_rready[0]), .m_scan_rdata(m_rdata[63:0]), .m_scan_rresp(2'd0),
        .m_scan_rlast(m_rlast[0]), .pix_clk(clk), .pix_rst(rst),
        .m_video_tvalid(no_video_tvalid), .m_video_tready(1'b1), .m_video_tdata(no_video_tdata),
        .m_video_tuser(no_video_tuser), .m_video_tlast(no_video_tlast), .de_o(no_de),
        .hsync_o(no_hsync), .vsync_o(no_vsync), .tmds0_o(blue), .tmds1_o(green), .tmds2_o(red)
    );
    rt_serialise u_serialise (
        .pix_clk(clk), .symbol_i({10'b0000011111, red, green, blue}), .clk5(clk5), .pin_o(gpdi_o)
    );

    // ---- lights ----
    reg  [24:0] beat_q;
    always @(posedge clk) beat_q <= rst ? 25'd0 : beat_q + 25'd1;
    assign led_o = {number[3:0], irq, shown, !uart_rx_i, beat_q[24]};
    wire unused = &{1'b0, no_scene_arcache, no_scene_arprot, no_scene_arqos, no_frame_awid,
                    no_frame_awcache, no_frame_awprot, no_frame_awqos, no_scan_arid,
                    no_scan_arcache, no_scan_arprot, no_scan_arqos, no_active,
                    btn_i, number, m_rlast[2], no_video_tvalid, no_video_tuser,
                    no_video_tlast, no_de, no_hsync, no_vsync, no_scene_arburst,
                    no_frame_awburst, no_scan_arburst, no_scene_arsize, no_frame_awsize,
                    no_scan_arsize, no_frame_awlen, no_video_tdata, no_show_base, ids_room,
                    ids_there};
endmodule
`default_nettype wire
