// rt_video_rules.sv - the rules of formal/axi_rules.vh at the buses of rt_video
// SPDX-License-Identifier: Apache-2.0
`ifndef RULE
/* verilator lint_off DECLFILENAME */ // a file of several
`include "axi_rules.vh"
/* verilator lint_on DECLFILENAME */
`endif
bind rt_scan axi_read_rules #(.DATA(DATA), .ADDR(ADDR), .ID(1), .MOST(BURST)) u_rules (
    .clk(clk), .rst(rst), .anew(forget_i), .arvalid(m_scan_arvalid), .arready(m_scan_arready),
    .arid(1'b0), .araddr(m_scan_araddr), .arlen(m_scan_arlen));
bind rt_video axi_stream_rules u_rules (
    .clk(pix_clk), .rst(pix_rst_s), .tvalid(m_video_tvalid), .tready(m_video_tready),
    .tdata(m_video_tdata), .tuser(m_video_tuser), .tlast(m_video_tlast));
