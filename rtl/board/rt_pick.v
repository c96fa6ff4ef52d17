// rt_pick.v - buttons choose among the machines that were loaded: the next one, the one before
// SPDX-License-Identifier: Apache-2.0
//   press --> header --> STATUS until no frame is drawn --> list: item {offset, value} --> block
// Lists stand in memory, where `sphaera load` writes them. The header, a word of 64 bits at LISTS:
// MAGIC above the number of machines, 1..64. List k is at LISTS + (k + 1) * 2^11: items with the
// offset in bits 43..32 and the value below; an offset of all ones ends it, and so does item 255. A
// press without header, or while one is followed, does nothing; of both at once the next counts.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_board.vh"
`include "rt_top.vh"
module rt_pick #(
    parameter STILL = 18                  // log2 of the clocks between two looks at a button
) (
    input  wire        clk,
    input  wire        rst,
    input  wire        next_i,            // buttons, of no clock
    input  wire        before_i,
    output reg  [5:0]  number_o,          // of the machine that was chosen last
    // AXI4 reads of one beat
    output reg         m_arvalid,
    input  wire        m_arready,
    output wire [31:0] m_araddr,
    input  wire        m_rvalid,
    input  wire [63:0] m_rdata,
    // registers: AXI4-Lite; answers are taken at once
    output reg         r_awvalid,
    input  wire        r_awready,
    output wire [11:0] r_awaddr,
    output reg         r_wvalid,
    input  wire        r_wready,
    output wire [31:0] r_wdata,
    input  wire        r_bvalid,
    output reg         r_arvalid,
    input  wire        r_arready,
    output wire [11:0] r_araddr,
    input  wire        r_rvalid,
    input  wire [31:0] r_rdata
);
    // ---- buttons: looked at rarely, so that a bounce is seen once ----
    wire [1:0]       level;
    reg  [1:0]       was_q;
    reg  [STILL-1:0] still_q;
    wire             look  = &still_q;
    wire [1:0]       press = level & ~was_q & {2{look}};
    rt_sync #(.WIDTH(2)) u_buttons (.clk(clk), .d_i({before_i, next_i}), .q_o(level));
    always @(posedge clk) begin
        still_q <= still_q + 1'b1;
        if (look) was_q <= level;
        if (rst) begin
            still_q <= {STILL{1'b0}};
            was_q   <= 2'b11;
        end
    end

    // ---- steps ----
    localparam [2:0] IDLE = 3'd0, HEADER = 3'd1, BUSY = 3'd2, ITEM = 3'd3, WRITE = 3'd4;
    reg  [2:0]  state_q;
    reg         back_q;                   // the one before, not the next
    reg  [7:0]  item_q;                   // of the list
    reg  [43:0] write_q;
    wire [5:0]  count = m_rdata[5:0] - 6'd1; // the last machine
    wire        known = m_rdata[63:32] == `RT_BOARD_MAGIC && m_rdata[31:0] != 32'd0 &&
                        m_rdata[31:0] <= 32'd64;
    wire        drawn = !r_rdata[`RT_TOP_STATUS_BUSY] && !r_rdata[`RT_TOP_STATUS_DRAINING];
    wire        ends  = &m_rdata[43:32] || &item_q;
    wire [6:0]  list  = state_q == HEADER ? 7'd0 : {1'b0, number_o} + 7'd1;
    assign m_araddr = `RT_BOARD_LISTS + {14'd0, list, item_q, 3'd0};
    assign r_araddr = `RT_TOP_STATUS;
    assign {r_awaddr, r_wdata} = write_q;
    wire unused = &{1'b0, m_rdata, r_rdata};
    always @(posedge clk) begin
        if (m_arready) m_arvalid <= 1'b0;
        if (r_awready) r_awvalid <= 1'b0;
        if (r_wready)  r_wvalid  <= 1'b0;
        if (r_arready) r_arvalid <= 1'b0;
        case (state_q)
            IDLE: if (press != 2'b00) begin
                back_q    <= !press[0];
                m_arvalid <= 1'b1;
                state_q   <= HEADER;
            end
            HEADER: if (m_rvalid) begin
                number_o  <= back_q ? (number_o == 6'd0 || number_o > count ? count
                                       : number_o - 6'd1)
                             : number_o >= count ? 6'd0 : number_o + 6'd1;
                r_arvalid <= known;
                state_q   <= known ? BUSY : IDLE;
                if (!known) number_o <= 6'd0;
            end
            BUSY: if (r_rvalid) begin
                r_arvalid <= !drawn;
                m_arvalid <= drawn;
                if (drawn) state_q <= ITEM;
            end
            ITEM: if (m_rvalid) begin
                write_q   <= m_rdata[43:0];
                r_awvalid <= !ends;
                r_wvalid  <= !ends;
                state_q   <= ends ? IDLE : WRITE;
                item_q    <= ends ? 8'd0 : item_q + 8'd1;
            end
            default: if (r_bvalid) begin  // WRITE
                m_arvalid <= 1'b1;
                state_q   <= ITEM;
            end
        endcase
        if (rst) begin
            state_q   <= IDLE;
            number_o  <= 6'd0;
            item_q    <= 8'd0;
            m_arvalid <= 1'b0;
            r_awvalid <= 1'b0;
            r_wvalid  <= 1'b0;
            r_arvalid <= 1'b0;
        end
    end
endmodule
`default_nettype wire
