// rt_builder.v - rt_build in rt_top: its registers, a read and a write master of its own
// SPDX-License-Identifier: Apache-2.0
//   orders --> rt_trees --> rt_build <-- lines <-- rt_mem_arbiter <-- rt_axi_read  <-- AXI4
//                                    --> lines ------------------> rt_axi_write --> AXI4
// All lines are those behind SCENE_BASE. Settings and SCENE_BASE count from a BUILD on: they may be
// written while a tree is built.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_top.vh"
module rt_builder #(
    parameter W        = 16,             // coordinate, bits: 8 to 24
    parameter FW       = 14,             // filter coordinate, bits: 6 to 14, at most W
    parameter COUNT    = 4096,           // spheres at most, a power of two, 16 to 65536
    parameter MEM_DATA = 64,             // bits of a beat that is read: 64, 128, 256
    parameter DATA     = 64,             // that is written, 64 or 128
    parameter ADDR     = 32              // bits of an address, 32 to 40
) (
    input  wire            clk,
    input  wire            rst,
    // from rt_control
    input  wire [7:0]      order_i,      // bits of CONTROL that are written
    input  wire [32*`RT_TOP_SETTINGS-1:0] settings_i,
    input  wire [ADDR-1:0] base_i,       // of SCENE_BASE
    // to rt_control
    output wire [5:0]      errors_o,     // bits of ERRORS, from BUILD_MANY on, that are set now
    output wire            done_o,       // a build ended
    output wire            building_o,
    output wire            draining_o,
    output wire            valid_o,      // a tree is complete
    output wire            newest_o,     // the place of the newest one
    output wire [31:0]     clocks_o,     // of the last build
    output wire [31:0]     written_o,    // lines of it
    // rt_run
    input  wire            forget_i,     // the buses were reset: they owe nothing
    output wire            start_o,      // START
    output wire            held_o,       // a START waits for its tree
    input  wire            load_i,       // registers to the core
    input  wire            frame_i,      // a frame is drawn, or drained
    // the tree that the frame reads
    output wire            reads_o,      // there is one
    output wire [`RT_LINE_BITS-1:0] reads_line_o,
    // AXI4
    output wire            m_arvalid,
    input  wire            m_arready,
    output wire [ADDR-1:0] m_araddr,
    input  wire            m_rvalid,
    output wire            m_rready,
    input  wire [MEM_DATA-1:0] m_rdata,
    input  wire [1:0]      m_rresp,
    output wire            m_awvalid,
    input  wire            m_awready,
    output wire [ADDR-1:0] m_awaddr,
    output wire [7:0]      m_awlen,
    output wire            m_wvalid,
    input  wire            m_wready,
    output wire [DATA-1:0] m_wdata,
    output wire [DATA/8-1:0] m_wstrb,
    output wire            m_wlast,
    input  wire            m_bvalid,
    output wire            m_bready,
    input  wire [1:0]      m_bresp
);
    localparam LB = `RT_LINE_BITS;
    // ---- what is wanted ----
    wire          accept, go, built, cut, read_idle, write_idle, read_stall, write_stall;
    wire [4:0]    errors;
    wire [LB-1:0] root, written;
    rt_trees u_trees (
        .clk(clk), .rst(rst), .order_i(order_i), .limit_i(settings_i[`RT_TOP_SET_WATCHDOG]),
        .tree0_i(settings_i[`RT_TOP_SET_BUILD_TREE0_LINE]),
        .tree1_i(settings_i[`RT_TOP_SET_BUILD_TREE1_LINE]),
        .root_i(settings_i[`RT_TOP_SET_BUILD_MODE_ROOT]), .errors_o(errors_o), .done_o(done_o),
        .building_o(building_o), .draining_o(draining_o), .valid_o(valid_o),
        .newest_o(newest_o), .clocks_o(clocks_o), .start_o(start_o), .held_o(held_o),
        .load_i(load_i), .frame_i(frame_i), .reads_o(reads_o), .reads_line_o(reads_line_o),
        .accept_o(accept), .line_o(root), .go_o(go), .built_i(built), .errors_i(errors),
        .cut_o(cut), .idle_i(read_idle && write_idle), .stall_i(read_stall || write_stall)
    );
    reg  [1:0]      mode_q, rounds_q;
    reg  [`RT_ID_BITS-1:0] count_q;
    reg  [LB-1:0]   records_q, lines_q;
    reg  [ADDR-1:0] base_q;
    always @(posedge clk) if (accept) begin
        mode_q    <= settings_i[`RT_TOP_SET_BUILD_MODE_ORDER];
        rounds_q  <= settings_i[`RT_TOP_SET_BUILD_MODE_ROUNDS];
        count_q   <= settings_i[`RT_TOP_SET_BUILD_COUNT_SPHERES];
        records_q <= settings_i[`RT_TOP_SET_BUILD_RECORDS_LINE];
        lines_q   <= settings_i[`RT_TOP_SET_BUILD_LINES_LINES];
        base_q    <= base_i;
    end

    // ---- the builder ----
    wire          build_rst = rst || cut;
    wire          req_valid, req_ready, line_valid, line_error, wr_valid, wr_ready;
    wire [LB-1:0] req_line, wr_line;
    wire [255:0]  line, wr_data;
    wire          read_slverr, read_decerr, write_slverr, write_decerr, busy;
    rt_build #(.W(W), .FW(FW), .COUNT(COUNT)) u_build (
        .clk(clk), .rst(build_rst), .start_i(go), .mode_i(mode_q), .rounds_i(rounds_q),
        .count_i(count_q), .prim_base_i(records_q), .root_i(root), .lines_i(lines_q), .busy_o(busy),
        .done_o(built), .error_o(errors),
        .written_o(written), .req_valid_o(req_valid), .req_ready_i(req_ready),
        .req_line_o(req_line), .rsp_valid_i(line_valid), .rsp_data_i(line),
        .rsp_error_i(line_error), .wr_valid_o(wr_valid), .wr_ready_i(wr_ready),
        .wr_line_o(wr_line), .wr_data_o(wr_data), .wr_idle_i(write_idle),
        .wr_error_i(write_slverr || write_decerr)
    );
    assign written_o = {{(32-LB){1'b0}}, written};

    // ---- lines that are read ----
    wire          ask_valid, ask_ready, beat_valid, beat_ready, beat_error, lines_busy;
    wire [LB-1:0] ask_line;
    wire [`RT_TAG_BITS-1:0] ask_tag, beat_tag;
    wire [MEM_DATA-1:0] beat;
    rt_mem_arbiter #(.CLIENTS(1), .PENDING(32), .DATA(MEM_DATA)) u_lines (
        .clk(clk), .rst(build_rst), .req_valid_i(req_valid), .req_ready_o(req_ready),
        .req_line_i(req_line), .rsp_valid_o(line_valid), .rsp_ready_i(1'b1), .rsp_data_o(line),
        .rsp_error_o(line_error), .busy_o(lines_busy), .mem_req_valid_o(ask_valid),
        .mem_req_ready_i(ask_ready), .mem_req_line_o(ask_line), .mem_req_tag_o(ask_tag),
        .mem_rsp_valid_i(beat_valid), .mem_rsp_ready_o(beat_ready),
        .mem_rsp_tag_i({`RT_TAG_BITS{1'b0}}), .mem_rsp_data_i(beat), .mem_rsp_error_i(beat_error)
    );
    wire [`RT_TAG_BITS-1:0] m_arid;
    wire [7:0]    m_arlen;
    wire          read_burst, read_beat;
    rt_axi_read #(.DATA(MEM_DATA), .PENDING(32), .ADDR(ADDR)) u_read (
        .clk(clk), .rst(rst), .begin_i(go), .base_i(base_q), .cut_i(cut),
        .forget_i(forget_i), .idle_o(read_idle), .stall_o(read_stall), .slverr_o(read_slverr),
        .decerr_o(read_decerr), .burst_o(read_burst), .beat_o(read_beat),
        .req_valid_i(ask_valid), .req_ready_o(ask_ready), .req_line_i(ask_line),
        .req_tag_i(ask_tag), .rsp_valid_o(beat_valid), .rsp_ready_i(beat_ready),
        .rsp_tag_o(beat_tag), .rsp_data_o(beat), .rsp_error_o(beat_error),
        .m_arvalid(m_arvalid), .m_arready(m_arready), .m_arid(m_arid), .m_araddr(m_araddr),
        .m_arlen(m_arlen), .m_rvalid(m_rvalid), .m_rready(m_rready),
        .m_rid({`RT_TAG_BITS{1'b0}}), .m_rdata(m_rdata), .m_rresp(m_rresp), .m_rlast(1'b0)
    );

    // ---- lines that are written ----
    wire          write_burst, write_beat;
    rt_axi_write #(.DATA(DATA), .ADDR(ADDR)) u_write (
        .clk(clk), .rst(rst), .cut_i(cut), .forget_i(forget_i), .idle_o(write_idle),
        .stall_o(write_stall), .slverr_o(write_slverr), .decerr_o(write_decerr),
        .burst_o(write_burst), .beat_o(write_beat), .group_valid_i(wr_valid),
        .group_ready_o(wr_ready), .group_addr_i(base_q + {{(ADDR-LB-5){1'b0}}, wr_line, 5'd0}),
        .group_half_i(1'b0), .group_strobe_i(32'hffffffff), .group_data_i(wr_data),
        .m_awvalid(m_awvalid), .m_awready(m_awready), .m_awaddr(m_awaddr), .m_awlen(m_awlen),
        .m_wvalid(m_wvalid), .m_wready(m_wready), .m_wdata(m_wdata), .m_wstrb(m_wstrb),
        .m_wlast(m_wlast), .m_bvalid(m_bvalid), .m_bready(m_bready), .m_bresp(m_bresp)
    );
    wire unused = &{1'b0, settings_i, busy, lines_busy, ask_tag, beat_tag, m_arid, m_arlen,
                    read_slverr, read_decerr, read_burst, read_beat, write_burst, write_beat};
endmodule
`default_nettype wire
