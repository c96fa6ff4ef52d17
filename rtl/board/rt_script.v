// rt_script.v - writes a list of registers over AXI4-Lite: what a driver would write, in its order
// SPDX-License-Identifier: Apache-2.0
//   item {offset, value} --> AW and W --> B --> the next; an offset of all ones ends the list
// A clock after item_take_o the next item must stand at item_i.
`timescale 1ns / 1ps
`default_nettype none
module rt_script (
    input  wire        clk,
    input  wire        rst,
    input  wire        start_i,           // while done_o is high; the first item stands there
    output reg         done_o,            // nothing is written
    // items
    input  wire [43:0] item_i,            // offset 43..32, value 31..0
    output wire        item_take_o,
    // AXI4-Lite
    output reg         m_awvalid,
    input  wire        m_awready,
    output wire [11:0] m_awaddr,
    output reg         m_wvalid,
    input  wire        m_wready,
    output wire [31:0] m_wdata,
    input  wire        m_bvalid,
    output wire        m_bready
);
    reg  wait_q;                          // an answer is owed
    wire last = &item_i[43:32];
    assign m_awaddr    = item_i[43:32];
    assign m_wdata     = item_i[31:0];
    assign m_bready    = wait_q;
    assign item_take_o = wait_q && m_bvalid;
    reg  look_q;                          // an item is there, and not begun
    always @(posedge clk) begin
        look_q <= item_take_o || (start_i && done_o);
        if (m_awready) m_awvalid <= 1'b0;
        if (m_wready)  m_wvalid  <= 1'b0;
        if (item_take_o) wait_q  <= 1'b0;
        if (start_i) done_o <= 1'b0;
        if (look_q && last) done_o <= 1'b1;
        if (look_q && !last) begin
            m_awvalid <= 1'b1;
            m_wvalid  <= 1'b1;
            wait_q    <= 1'b1;
        end
        if (rst) begin
            done_o    <= 1'b1;
            look_q    <= 1'b0;
            wait_q    <= 1'b0;
            m_awvalid <= 1'b0;
            m_wvalid  <= 1'b0;
        end
    end
endmodule
`default_nettype wire
