// f_any_write.v - stands for rt_axi_write: it takes groups and is idle in any clock
// SPDX-License-Identifier: Apache-2.0
`timescale 1ns / 1ps
`default_nettype none
module rt_axi_write #(
    parameter DATA = 64,
    parameter ADDR = 32
) (
    input  wire              clk,
    input  wire              rst,
    input  wire              cut_i,
    input  wire              forget_i,
    output wire              idle_o,
    output wire              stall_o,
    output wire              slverr_o,
    output wire              decerr_o,
    output wire              burst_o,
    output wire              beat_o,
    input  wire              group_valid_i,
    output wire              group_ready_o,
    input  wire [ADDR-1:0]   group_addr_i,
    input  wire              group_half_i,
    input  wire [31:0]       group_strobe_i,
    input  wire [255:0]      group_data_i,
    output wire              m_awvalid,
    input  wire              m_awready,
    output wire [ADDR-1:0]   m_awaddr,
    output wire [7:0]        m_awlen,
    output wire              m_wvalid,
    input  wire              m_wready,
    output wire [DATA-1:0]   m_wdata,
    output wire [DATA/8-1:0] m_wstrb,
    output wire              m_wlast,
    input  wire              m_bvalid,
    output wire              m_bready,
    input  wire [1:0]        m_bresp
);
    (* anyseq *) wire idle, ready;
    assign idle_o        = idle;
    assign group_ready_o = ready || cut_i;
    assign {stall_o, slverr_o, decerr_o, burst_o, beat_o} = 5'd0;
    assign {m_awvalid, m_awaddr, m_awlen, m_wvalid, m_wdata, m_wstrb, m_wlast, m_bready} = 0;
endmodule
`default_nettype wire
