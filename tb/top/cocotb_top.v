// cocotb_top.v - rt_top with what cocotbext-axi asks for besides: IDs of the frame store, always 0
// SPDX-License-Identifier: Apache-2.0
// CORE_PARAMETERS, a macro that lab/top/cocotb_run.py gives, are the parameters of the core.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`ifndef CORE_PARAMETERS
`define CORE_PARAMETERS .W(`RT_PROFILE_STANDARD_W)
`endif
module cocotb_top #(
    parameter DATA = 64,
    parameter MEM_DATA = 64
) (
    input  wire              clk,
    input  wire              rst,
    output wire              irq,
    input  wire              s_axil_awvalid,
    output wire              s_axil_awready,
    input  wire [11:0]       s_axil_awaddr,
    input  wire              s_axil_wvalid,
    output wire              s_axil_wready,
    input  wire [31:0]       s_axil_wdata,
    input  wire [3:0]        s_axil_wstrb,
    output wire              s_axil_bvalid,
    input  wire              s_axil_bready,
    output wire [1:0]        s_axil_bresp,
    input  wire              s_axil_arvalid,
    output wire              s_axil_arready,
    input  wire [11:0]       s_axil_araddr,
    output wire              s_axil_rvalid,
    input  wire              s_axil_rready,
    output wire [31:0]       s_axil_rdata,
    output wire [1:0]        s_axil_rresp,
    output wire [4:0]        m_scene_arid,
    output wire              m_scene_arvalid,
    input  wire              m_scene_arready,
    output wire [31:0]       m_scene_araddr,
    output wire [7:0]        m_scene_arlen,
    output wire [2:0]        m_scene_arsize,
    output wire [1:0]        m_scene_arburst,
    input  wire [4:0]        m_scene_rid,
    input  wire              m_scene_rvalid,
    output wire              m_scene_rready,
    input  wire [MEM_DATA-1:0] m_scene_rdata,
    input  wire [1:0]        m_scene_rresp,
    input  wire              m_scene_rlast,
    output wire [0:0]        m_frame_awid,
    output wire              m_frame_awvalid,
    input  wire              m_frame_awready,
    output wire [31:0]       m_frame_awaddr,
    output wire [7:0]        m_frame_awlen,
    output wire [2:0]        m_frame_awsize,
    output wire [1:0]        m_frame_awburst,
    output wire              m_frame_wvalid,
    input  wire              m_frame_wready,
    output wire [DATA-1:0]   m_frame_wdata,
    output wire [DATA/8-1:0] m_frame_wstrb,
    output wire              m_frame_wlast,
    input  wire [0:0]        m_frame_bid,
    input  wire              m_frame_bvalid,
    output wire              m_frame_bready,
    input  wire [1:0]        m_frame_bresp
);
    assign m_frame_awid = 1'b0;
    wire unused = &{1'b0, m_frame_bid};
    rt_top #(.DATA(DATA), .MEM_DATA(MEM_DATA), `CORE_PARAMETERS) u_top (
        .clk(clk), .rst(rst), .irq_o(irq),
        .s_axil_awvalid(s_axil_awvalid), .s_axil_awready(s_axil_awready),
        .s_axil_awaddr(s_axil_awaddr), .s_axil_wvalid(s_axil_wvalid),
        .s_axil_wready(s_axil_wready), .s_axil_wdata(s_axil_wdata), .s_axil_wstrb(s_axil_wstrb),
        .s_axil_bvalid(s_axil_bvalid), .s_axil_bready(s_axil_bready), .s_axil_bresp(s_axil_bresp),
        .s_axil_arvalid(s_axil_arvalid), .s_axil_arready(s_axil_arready),
        .s_axil_araddr(s_axil_araddr), .s_axil_rvalid(s_axil_rvalid),
        .s_axil_rready(s_axil_rready), .s_axil_rdata(s_axil_rdata), .s_axil_rresp(s_axil_rresp),
        .m_scene_arvalid(m_scene_arvalid), .m_scene_arready(m_scene_arready),
        .m_scene_arid(m_scene_arid), .m_scene_araddr(m_scene_araddr),
        .m_scene_arlen(m_scene_arlen), .m_scene_arsize(m_scene_arsize),
        .m_scene_arburst(m_scene_arburst), .m_scene_rvalid(m_scene_rvalid),
        .m_scene_rready(m_scene_rready), .m_scene_rid(m_scene_rid), .m_scene_rdata(m_scene_rdata),
        .m_scene_rresp(m_scene_rresp), .m_scene_rlast(m_scene_rlast),
        .m_frame_awvalid(m_frame_awvalid),
        .m_frame_awready(m_frame_awready), .m_frame_awaddr(m_frame_awaddr),
        .m_frame_awlen(m_frame_awlen), .m_frame_awsize(m_frame_awsize),
        .m_frame_awburst(m_frame_awburst), .m_frame_wvalid(m_frame_wvalid),
        .m_frame_wready(m_frame_wready), .m_frame_wdata(m_frame_wdata),
        .m_frame_wstrb(m_frame_wstrb), .m_frame_wlast(m_frame_wlast),
        .m_frame_bvalid(m_frame_bvalid), .m_frame_bready(m_frame_bready),
        .m_frame_bresp(m_frame_bresp), .take_i(1'b0), .show_valid_o(), .show_base_o(),
        .m_scan_arvalid(), .m_scan_arready(1'b0), .m_scan_araddr(), .m_scan_arlen(),
        .m_scan_arsize(), .m_scan_arburst(), .m_scan_rvalid(1'b0), .m_scan_rready(),
        .m_scan_rdata({DATA{1'b0}}), .m_scan_rresp(2'd0), .m_scan_rlast(1'b0), .pix_clk(1'b0),
        .pix_rst(1'b0), .m_video_tvalid(), .m_video_tready(1'b0), .m_video_tdata(),
        .m_video_tuser(), .m_video_tlast(), .de_o(), .hsync_o(), .vsync_o(), .tmds0_o(),
        .tmds1_o(), .tmds2_o()
    );
endmodule
`default_nettype wire
