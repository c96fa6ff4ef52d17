// rt_top_rules.sv - the rules of formal/axi_rules.vh at every bus of rt_top
// SPDX-License-Identifier: Apache-2.0
/* verilator lint_off DECLFILENAME */ // a file of several
`include "axi_rules.vh"
/* verilator lint_on DECLFILENAME */
bind rt_axi_read axi_read_rules #(.DATA(DATA), .ADDR(ADDR), .ID($bits(m_arid))) u_rules (
    .clk(clk), .rst(rst), .anew(forget_i), .arvalid(m_arvalid), .arready(m_arready),
    .arid(m_arid), .araddr(m_araddr), .arlen(m_arlen));
bind rt_axi_write axi_write_rules #(.DATA(DATA), .ADDR(ADDR)) u_rules (
    .clk(clk), .rst(rst), .anew(forget_i), .awvalid(m_awvalid), .awready(m_awready),
    .awaddr(m_awaddr), .awlen(m_awlen), .wvalid(m_wvalid), .wready(m_wready), .wdata(m_wdata),
    .wstrb(m_wstrb), .wlast(m_wlast), .bvalid(m_bvalid), .bready(m_bready));
bind rt_control axi_lite_rules u_rules (
    .clk(clk), .rst(rst), .awvalid(s_awvalid), .awready(s_awready), .wvalid(s_wvalid),
    .wready(s_wready), .bvalid(s_bvalid), .bready(s_bready), .bresp(s_bresp),
    .arvalid(s_arvalid), .arready(s_arready), .rvalid(s_rvalid), .rready(s_rready),
    .rdata(s_rdata), .rresp(s_rresp));
`include "../video/rt_video_rules.sv"
