// rt_top.v - the core as an IP block: AXI4-Lite registers, AXI4 masters for scene and frame store
// SPDX-License-Identifier: Apache-2.0
//   AXI4-Lite -> rt_control -> rt_run, rt_machine -> rt_core -> lines  -> rt_axi_read    -> AXI4
//                rt_totals                                   -> pixels -> rt_frame_write -> AXI4
// With BUILD rt_builder reads records and writes trees over the same two masters.
// Registers, order of use, timing: docs/reference/rt_top.md. This module is wires alone.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
`include "rt_layout.vh"
`include "rt_modes.vh"
`include "rt_top.vh"
module rt_top #(
    parameter DATA       = 64,   // data bits of frame store and display, 64 or 128
    parameter BUFFERS    = 16,   // groups of pixels filled at once, a power of two, 4..64
    parameter VIDEO      = 0,    // 1: a video output
    parameter LAYERS     = 0,    // 1: frames have three layers, Rendering, L1 and L2
    parameter BUILD      = 0,    // spheres that trees are built of: 0, or a power of two 16..65536
    parameter ADDR       = 32,   // 32..40: bits of an address of the AXI4 masters
    parameter FRAME_ID   = 0,    // 0..31: ID of writes to the frame store
    parameter SCAN_ID    = 0,    // 0..31: ID of reads of the display
    parameter AXI_CACHE  = 3,    // 0..15: AxCACHE of all masters; 3: normal, not cached, bufferable
    parameter AXI_PROT   = 2,    // 0..7: AxPROT of all masters; 2: data, non-secure, unprivileged
    parameter AXI_QOS    = 0,    // 0..15: AxQOS of scene and frame store
    parameter SCAN_QOS   = 0,    // 0..15: ARQOS of the display
    `include "rt_core_parameters.vh"
) (
    input  wire              clk,
    input  wire              rst,
    output wire              irq_o,            // level, while an enabled interrupt is set
    output wire              active_o,         // 0: clk may stand still in this cycle
    // registers: AXI4-Lite
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
    // scene: AXI4 reads, MEM_DATA wide; INCR, all bytes of each beat; a reader is an ID
    output wire              m_scene_arvalid,
    input  wire              m_scene_arready,
    output wire [`RT_TAG_BITS-1:0] m_scene_arid,
    output wire [ADDR-1:0]   m_scene_araddr,
    output wire [7:0]        m_scene_arlen,
    output wire [2:0]        m_scene_arsize,
    output wire [1:0]        m_scene_arburst,
    output wire [3:0]        m_scene_arcache,
    output wire [2:0]        m_scene_arprot,
    output wire [3:0]        m_scene_arqos,
    input  wire              m_scene_rvalid,
    output wire              m_scene_rready,
    input  wire [`RT_TAG_BITS-1:0] m_scene_rid,
    input  wire [MEM_DATA-1:0] m_scene_rdata,
    input  wire [1:0]        m_scene_rresp,
    input  wire              m_scene_rlast,
    // frame store: AXI4 writes; INCR, one ID
    output wire              m_frame_awvalid,
    input  wire              m_frame_awready,
    output wire [`RT_TAG_BITS-1:0] m_frame_awid,
    output wire [ADDR-1:0]   m_frame_awaddr,
    output wire [7:0]        m_frame_awlen,
    output wire [2:0]        m_frame_awsize,
    output wire [1:0]        m_frame_awburst,
    output wire [3:0]        m_frame_awcache,
    output wire [2:0]        m_frame_awprot,
    output wire [3:0]        m_frame_awqos,
    output wire              m_frame_wvalid,
    input  wire              m_frame_wready,
    output wire [DATA-1:0]   m_frame_wdata,
    output wire [DATA/8-1:0] m_frame_wstrb,
    output wire              m_frame_wlast,
    input  wire              m_frame_bvalid,
    output wire              m_frame_bready,
    input  wire [1:0]        m_frame_bresp,
    // a reader of frames that stands outside, without VIDEO or while it is off
    input  wire              take_i,           // one cycle, before a frame is read
    output wire              show_valid_o,     // a frame is shown, at
    output wire [ADDR-1:0]   show_base_o,      // this address, from the cycle after take_i
    // display: AXI4 reads; INCR, one ID; without VIDEO all of its outputs are 0
    output wire              m_scan_arvalid,
    input  wire              m_scan_arready,
    output wire [`RT_TAG_BITS-1:0] m_scan_arid,
    output wire [ADDR-1:0]   m_scan_araddr,
    output wire [7:0]        m_scan_arlen,
    output wire [2:0]        m_scan_arsize,
    output wire [1:0]        m_scan_arburst,
    output wire [3:0]        m_scan_arcache,
    output wire [2:0]        m_scan_arprot,
    output wire [3:0]        m_scan_arqos,
    input  wire              m_scan_rvalid,
    output wire              m_scan_rready,
    input  wire [DATA-1:0]   m_scan_rdata,
    input  wire [1:0]        m_scan_rresp,
    input  wire              m_scan_rlast,
    // pixel clock: AXI4-Stream video, symbols of DVI
    input  wire              pix_clk,
    input  wire              pix_rst,          // synchronous to pix_clk, active high
    output wire              m_video_tvalid,
    input  wire              m_video_tready,   // high if syncs or symbols are used
    output wire [23:0]       m_video_tdata,
    output wire              m_video_tuser,    // first pixel of a frame
    output wire              m_video_tlast,    // last pixel of a row
    output wire              de_o,
    output wire              hsync_o,
    output wire              vsync_o,
    output wire [9:0]        tmds0_o,
    output wire [9:0]        tmds1_o,
    output wire [9:0]        tmds2_o
);
    `RT_CHECK(DATA == 64 || DATA == 128, rt_top_DATA_must_be_64_or_128)
    `RT_CHECK(VIDEO == 0 || VIDEO == 1, rt_top_VIDEO_must_be_0_or_1)
    `RT_CHECK(LAYERS == 0 || LAYERS == 1, rt_top_LAYERS_must_be_0_or_1)
    `RT_CHECK(BUILD == 0 || (BUILD >= 16 && BUILD <= 65536 && (BUILD & (BUILD - 1)) == 0),
        rt_top_BUILD_must_be_0_or_a_power_of_two_of_16_to_65536)
    `RT_CHECK(BUILD == 0 || (ACCEL == 0 && BOXES == 0), rt_top_BUILD_excludes_ACCEL_and_BOXES)
    `RT_CHECK(ADDR >= 32 && ADDR <= 40, rt_top_ADDR_must_be_32_to_40)
    `RT_CHECK(FRAME_ID >= 0 && FRAME_ID < 32 && SCAN_ID >= 0 && SCAN_ID < 32,
        rt_top_FRAME_ID_and_SCAN_ID_must_be_0_to_31)
    `RT_CHECK(AXI_CACHE >= 0 && AXI_CACHE < 16 && AXI_PROT >= 0 && AXI_PROT < 8,
        rt_top_AXI_CACHE_must_be_0_to_15_and_AXI_PROT_0_to_7)
    `RT_CHECK(AXI_QOS >= 0 && AXI_QOS < 16 && SCAN_QOS >= 0 && SCAN_QOS < 16,
        rt_top_AXI_QOS_and_SCAN_QOS_must_be_0_to_15)
    localparam [2:0] SIZE = DATA == 64 ? 3'd3 : 3'd4;     // bytes of a beat, their logarithm
    assign m_scene_arsize  = MEM_DATA == 64 ? 3'd3 : MEM_DATA == 128 ? 3'd4 : 3'd5;
    assign m_scene_arburst = 2'b01;
    assign m_frame_awsize  = SIZE;
    assign m_frame_awburst = 2'b01;
    localparam [31:0] A_FRAME_ID = FRAME_ID, A_SCAN_ID = SCAN_ID, A_CACHE = AXI_CACHE,
                      A_PROT = AXI_PROT, A_QOS = AXI_QOS, A_SCAN_QOS = SCAN_QOS;
    assign {m_scene_arcache, m_scene_arprot, m_scene_arqos} = {A_CACHE[3:0], A_PROT[2:0],
                                                               A_QOS[3:0]};
    assign {m_frame_awcache, m_frame_awprot, m_frame_awqos} = {A_CACHE[3:0], A_PROT[2:0],
                                                               A_QOS[3:0]};
    assign m_frame_awid = A_FRAME_ID[`RT_TAG_BITS-1:0];

    // ---- what the block was built with ----
    localparam [31:0] PROFILE = W << `RT_WIDTH_W_LSB | WD << `RT_WIDTH_WD_LSB |
                                PQ << `RT_WIDTH_PQ_LSB | NG << `RT_WIDTH_NG_LSB |
                                FW << `RT_WIDTH_FW_LSB | PR << `RT_WIDTH_PR_LSB;
    localparam [31:0] DEPTH = `RT_DEEPEST;
    localparam [31:0] A_ENGINES = ENGINES, A_LIGHTS = LIGHTS, A_CONES = CONES, A_COARSE = COARSE,
                      A_DATA = DATA, A_ADDR = ADDR, A_BUILD = BUILD != 0 ? $clog2(BUILD) : 0;
    wire [31:0] parts, bus, status;
    assign parts[31:25] = 7'd0;
    assign parts[`RT_TOP_CORE_PARTS_BOXES]   = BOXES != 0;
    assign parts[`RT_TOP_CORE_PARTS_COARSE]  = A_COARSE[3:0];
    assign parts[`RT_TOP_CORE_PARTS_ACCEL]   = ACCEL != 0;
    assign parts[`RT_TOP_CORE_PARTS_SPANS]   = SPANS != 0;
    assign parts[`RT_TOP_CORE_PARTS_RECT]    = RECT != 0;
    assign parts[`RT_TOP_CORE_PARTS_CONES]   = A_CONES[4:0];
    assign parts[`RT_TOP_CORE_PARTS_LIGHTS]  = A_LIGHTS[3:0];
    assign parts[`RT_TOP_CORE_PARTS_DEPTH]   = DEPTH[3:0];
    assign parts[`RT_TOP_CORE_PARTS_ENGINES] = A_ENGINES[3:0];
    assign bus[31:21] = 11'd0;
    assign bus[`RT_TOP_CORE_BUS_BUILD] = A_BUILD[4:0];
    assign bus[`RT_TOP_CORE_BUS_ADDR] = A_ADDR[5:0];
    assign bus[`RT_TOP_CORE_BUS_LAYERS] = LAYERS != 0;
    assign bus[`RT_TOP_CORE_BUS_VIDEO] = VIDEO != 0;
    assign bus[`RT_TOP_CORE_BUS_DATA]  = A_DATA[7:0];

    // ---- registers ----
    wire [7:0]  order;
    wire [6:0]  write_addr, read_addr;
    wire [32*`RT_TOP_SETTINGS-1:0] settings;
    wire [3:0]  machine_write;
    wire [31:0] write_data, machine_data, count_data;
    wire        machine_busy, count_busy, control_busy;
    wire [15:0] errors;
    wire [5:0]  build_errors;
    wire [63:0] build_words;
    wire        build_done;
    wire        done, swap, frame_end, good;
    wire        video_take, blank, underrun, scan_error, scan_stall, video_idle;
    wire [39:0] scene_base = {settings[`RT_TOP_SET_ADDRESS_HIGH_SCENE],
                              settings[`RT_TOP_SET_SCENE_BASE]};
    wire [39:0] frame0 = {settings[`RT_TOP_SET_ADDRESS_HIGH_FRAME0], settings[`RT_TOP_SET_FRAME0]};
    wire [39:0] frame1 = {settings[`RT_TOP_SET_ADDRESS_HIGH_FRAME1], settings[`RT_TOP_SET_FRAME1]};
    wire [39:0] frame2 = {settings[`RT_TOP_SET_ADDRESS_HIGH_FRAME2], settings[`RT_TOP_SET_FRAME2]};
    // bits that no register has, or no address
    wire        unused = &{1'b0, settings, scene_base, frame0, frame1, frame2};
    rt_control #(.LAYERS(LAYERS), .ADDR(ADDR), .BUILD(BUILD)) u_control (
        .clk(clk), .rst(rst), .s_awvalid(s_axil_awvalid), .s_awready(s_axil_awready),
        .s_awaddr(s_axil_awaddr), .s_wvalid(s_axil_wvalid), .s_wready(s_axil_wready),
        .s_wdata(s_axil_wdata), .s_wstrb(s_axil_wstrb), .s_bvalid(s_axil_bvalid),
        .s_bready(s_axil_bready), .s_bresp(s_axil_bresp), .s_arvalid(s_axil_arvalid),
        .s_arready(s_axil_arready), .s_araddr(s_axil_araddr), .s_rvalid(s_axil_rvalid),
        .s_rready(s_axil_rready), .s_rdata(s_axil_rdata), .s_rresp(s_axil_rresp), .irq_o(irq_o),
        .busy_o(control_busy), .built_i({bus, parts, `RT_EFFECTS_BUILT, PROFILE}),
        .status_i(status), .build_i(build_words),
        .errors_i({build_errors, errors}), .happened_i({build_done, underrun, swap, done}),
        .good_i(frame_end && good),
        .order_o(order), .settings_o(settings), .machine_write_o(machine_write),
        .write_addr_o(write_addr), .write_data_o(write_data), .read_addr_o(read_addr),
        .machine_data_i(machine_data), .machine_busy_i(machine_busy),
        .count_data_i(count_data), .count_busy_i(count_busy)
    );
    wire        load, loading, cfg_valid;
    wire [6:0]  cfg_addr;
    wire [31:0] cfg_data, core_data;         // as it was written; with the ROOT of the newest tree
    rt_machine u_machine (
        .clk(clk), .rst(rst), .busy_o(machine_busy), .write_i(machine_write),
        .write_addr_i(write_addr), .write_data_i(write_data), .read_addr_i(read_addr),
        .read_data_o(machine_data), .load_i(load), .loading_o(loading),
        .cfg_valid_o(cfg_valid), .cfg_addr_o(cfg_addr), .cfg_data_o(cfg_data)
    );

    // ---- a frame ----
    wire        core_rst, core_start, core_keep, core_busy;
    wire [`RT_ERRORS-1:0] core_errors;
    wire        room, clear, frame_begin, cut, forget, flush;
    wire        read_idle, read_stall, read_slverr, read_decerr, read_burst, read_beat;
    wire        write_dead, write_empty, write_idle, write_stall, write_slverr, write_decerr,
                write_burst, write_beat;
    wire [7:0]  run_order;
    wire        drawing, draining, held, cutting; // a frame; a START that waits; a builder's end
    assign status[`RT_TOP_STATUS_BUSY]     = drawing || held;
    assign status[`RT_TOP_STATUS_DRAINING] = draining || cutting;
    rt_run u_run (
        .clk(clk), .rst(rst), .order_i(run_order), .limit_i(settings[`RT_TOP_SET_WATCHDOG]),
        .errors_o(errors), .done_o(done), .busy_o(drawing),
        .draining_o(draining), .waiting_o(status[`RT_TOP_STATUS_WAITING]),
        .load_o(load), .loading_i(loading), .core_rst_o(core_rst), .core_start_o(core_start),
        .core_keep_o(core_keep), .core_busy_i(core_busy), .core_errors_i(core_errors),
        .room_i(room), .clear_o(clear), .begin_o(frame_begin), .end_o(frame_end), .good_o(good),
        .cut_o(cut), .forget_o(forget), .read_idle_i(read_idle),
        .read_stall_i(read_stall), .read_errors_i({read_decerr, read_slverr}),
        .write_dead_o(write_dead), .flush_o(flush), .write_empty_i(write_empty && !write_valid),
        .write_idle_i(write_idle), .write_stall_i(write_stall),
        .write_errors_i({write_decerr, write_slverr}), .scan_error_i(scan_error),
        .scan_stall_i(scan_stall)
    );
    wire        video = VIDEO != 0 && settings[`RT_TOP_SET_VIDEO_ENABLE];
    wire        take  = video ? video_take : take_i || order[`RT_TOP_CONTROL_TAKE];
    wire        again, lost;
    wire [ADDR-1:0] draw_base;
    assign status[31:14] = 18'd0;
    assign status[`RT_TOP_STATUS_BLANK] = blank;
    assign status[`RT_TOP_STATUS_VALID] = show_valid_o;
    rt_frames #(.LAYERS(LAYERS), .ADDR(ADDR)) u_frames (
        .clk(clk), .rst(rst), .bases_i({frame2[ADDR-1:0], frame1[ADDR-1:0], frame0[ADDR-1:0]}),
        .wait_i(settings[`RT_TOP_SET_FRAME_MODE_WAIT]),
        .layer_i(settings[`RT_TOP_SET_LAYER_BYTES]), .mux_i(settings[`RT_TOP_SET_MUX_FRAME]),
        .cfg_valid_i(cfg_valid), .cfg_addr_i(cfg_addr), .cfg_data_i(cfg_data), .clear_i(clear),
        .load_i(load),
        .begin_i(frame_begin), .end_i(frame_end), .good_i(good), .room_o(room),
        .draw_base_o(draw_base), .take_i(take),
        .show_valid_o(show_valid_o), .show_base_o(show_base_o), .swap_o(swap), .again_o(again),
        .lost_o(lost), .drawn_o(status[`RT_TOP_STATUS_DRAWN]),
        .newest_o(status[`RT_TOP_STATUS_NEWEST]), .shown_o(status[`RT_TOP_STATUS_SHOWN])
    );

    // ---- core ----
    wire        req_valid, req_ready, rsp_valid, rsp_ready, rsp_error;
    wire [`RT_LINE_BITS-1:0] req_line;
    wire [`RT_TAG_BITS-1:0] req_tag, rsp_tag;
    wire [MEM_DATA-1:0] rsp_data;
    wire        pix_valid, pix_ready, write_valid, write_ready;
    wire [13:0] pix_x, pix_y, write_x, write_y;
    wire [71:0] pix_colour, write_colour;
    wire [23:0] pix_frame, write_frame;
    wire [4:0]  count_addr;
    wire [47:0] count;
    wire [`RT_ID_BITS-1:0] pix_id;
    wire [W+WD+1:0] pix_key;
    wire [`RT_VISITS_BITS-1:0] pix_visits;
    wire [31:0] pix_texture;
    wire        core_active;
    wire        unused_core = &{1'b0, pix_id, pix_key, pix_visits, pix_texture};
    rt_core #(
        `include "rt_core_pass.vh"
    ) u_core (
        .clk(clk), .rst(core_rst), .cfg_valid_i(cfg_valid), .cfg_addr_i(cfg_addr),
        .cfg_data_i(core_data), .start_i(core_start), .keep_cache_i(core_keep),
        .busy_o(core_busy), .active_o(core_active),
        .mem_req_valid_o(req_valid), .mem_req_ready_i(req_ready),
        .mem_req_line_o(req_line), .mem_req_tag_o(req_tag), .mem_rsp_valid_i(rsp_valid),
        .mem_rsp_ready_o(rsp_ready), .mem_rsp_tag_i(rsp_tag), .mem_rsp_data_i(rsp_data),
        .mem_rsp_error_i(rsp_error), .pix_valid_o(pix_valid), .pix_ready_i(pix_ready),
        .pix_x_o(pix_x), .pix_y_o(pix_y), .pix_colour_o(pix_colour), .pix_frame_o(pix_frame),
        .pix_id_o(pix_id), .pix_key_o(pix_key), .pix_visits_o(pix_visits),
        .pix_texture_o(pix_texture),
        .count_addr_i(count_addr), .count_data_o(count), .errors_o(core_errors)
    );
    wire            arvalid, arready, rvalid, rready;
    wire [`RT_TAG_BITS-1:0] arid;
    wire [ADDR-1:0] araddr;
    rt_axi_read #(.DATA(MEM_DATA), .ADDR(ADDR)) u_read (
        .clk(clk), .rst(rst), .begin_i(load), .base_i(scene_base[ADDR-1:0]), .cut_i(core_rst),
        .forget_i(forget), .idle_o(read_idle), .stall_o(read_stall),
        .slverr_o(read_slverr), .decerr_o(read_decerr), .burst_o(read_burst), .beat_o(read_beat),
        .req_valid_i(req_valid), .req_ready_o(req_ready), .req_line_i(req_line),
        .req_tag_i(req_tag), .rsp_valid_o(rsp_valid), .rsp_ready_i(rsp_ready),
        .rsp_tag_o(rsp_tag), .rsp_data_o(rsp_data), .rsp_error_o(rsp_error),
        .m_arvalid(arvalid), .m_arready(arready), .m_arid(arid),
        .m_araddr(araddr), .m_arlen(m_scene_arlen), .m_rvalid(rvalid),
        .m_rready(rready), .m_rid(m_scene_rid), .m_rdata(m_scene_rdata),
        .m_rresp(m_scene_rresp), .m_rlast(m_scene_rlast)
    );
    // a frame's buffers and the engines do not wait for one another within a clock
    rt_fifo #(.WIDTH(14 + 14 + 72 + 24), .DEPTH(2)) u_pixels (
        .clk(clk), .rst(core_rst), .in_valid_i(pix_valid && pix_ready), .in_ready_o(pix_ready),
        .in_data_i({pix_frame, pix_colour, pix_y, pix_x}),
        .out_valid_o(write_valid), .out_ready_i(write_ready),
        .out_data_o({write_frame, write_colour, write_y, write_x})
    );
    wire [3:0] write_pixels;
    wire                awvalid, awready, wvalid, wready, wlast, bvalid, bready;
    wire [ADDR-1:0]     awaddr;
    wire [7:0]          awlen;
    wire [DATA-1:0]     wdata;
    wire [DATA/8-1:0]   wstrb;
    rt_frame_write #(.DATA(DATA), .BUFFERS(BUFFERS), .LAYERS(LAYERS), .ADDR(ADDR)) u_frame_write (
        .clk(clk), .rst(rst), .base_i(draw_base), .begin_i(load),
        .mux_i(settings[`RT_TOP_SET_MUX_FRAME]),
        .stride_i({settings[`RT_TOP_SET_STRIDE_UNITS], 5'd0}),
        .rgb565_i(settings[`RT_TOP_SET_FORMAT_RGB565]),
        .layer_i(settings[`RT_TOP_SET_LAYER_BYTES]),
        .cut_i(cut), .dead_i(write_dead), .forget_i(forget), .flush_i(flush),
        .empty_o(write_empty), .idle_o(write_idle), .stall_o(write_stall),
        .slverr_o(write_slverr), .decerr_o(write_decerr), .burst_o(write_burst),
        .beat_o(write_beat), .pixels_o(write_pixels), .pix_valid_i(write_valid),
        .pix_ready_o(write_ready), .pix_x_i(write_x), .pix_y_i(write_y),
        .pix_colour_i(write_colour), .pix_frame_i(write_frame),
        .m_awvalid(awvalid), .m_awready(awready),
        .m_awaddr(awaddr), .m_awlen(awlen), .m_wvalid(wvalid),
        .m_wready(wready), .m_wdata(wdata), .m_wstrb(wstrb),
        .m_wlast(wlast), .m_bvalid(bvalid), .m_bready(bready),
        .m_bresp(m_frame_bresp)
    );
    rt_totals u_totals (
        .clk(clk), .rst(rst), .snap_i(order[`RT_TOP_CONTROL_SNAPSHOT]), .busy_o(count_busy),
        .read_addr_i(read_addr), .read_data_o(count_data), .count_addr_o(count_addr),
        .count_data_i(count), .frame_i(frame_begin), .clear_i(clear),
        .read_i({read_beat, read_burst}), .write_i({write_beat, write_burst}),
        .pixels_i(write_pixels), .swap_i(swap), .again_i(again), .lost_i(lost),
        .underrun_i(underrun)
    );

    // ---- trees built here ----
    wire build_busy;
    generate
        if (BUILD != 0) begin : g_build
            wire        start, reads;
            wire [`RT_LINE_BITS-1:0] root;
            assign build_busy = status[`RT_TOP_STATUS_BUILDING] || cutting || held;
            wire [ADDR-1:0] b_araddr, b_awaddr;
            wire        b_arvalid, b_arready, b_rvalid, b_rready, b_awvalid, b_awready, b_wvalid,
                        b_wready, b_wlast, b_bvalid, b_bready;
            wire [7:0]  b_awlen;
            wire [DATA-1:0] b_wdata;
            wire [DATA/8-1:0] b_wstrb;
            rt_builder #(
                .W(W), .FW(FW), .COUNT(BUILD), .MEM_DATA(MEM_DATA), .DATA(DATA), .ADDR(ADDR)
            ) u_builder (
                .clk(clk), .rst(rst), .order_i(order), .settings_i(settings),
                .base_i(scene_base[ADDR-1:0]), .errors_o(build_errors), .done_o(build_done),
                .building_o(status[`RT_TOP_STATUS_BUILDING]), .draining_o(cutting),
                .valid_o(status[`RT_TOP_STATUS_TREE_VALID]),
                .newest_o(status[`RT_TOP_STATUS_TREE]), .clocks_o(build_words[0 +: 32]),
                .written_o(build_words[32 +: 32]), .forget_i(forget), .start_o(start),
                .held_o(held), .load_i(load), .frame_i(drawing || draining), .reads_o(reads),
                .reads_line_o(root), .m_arvalid(b_arvalid), .m_arready(b_arready),
                .m_araddr(b_araddr), .m_rvalid(b_rvalid), .m_rready(b_rready),
                .m_rdata(m_scene_rdata), .m_rresp(m_scene_rresp), .m_awvalid(b_awvalid),
                .m_awready(b_awready), .m_awaddr(b_awaddr), .m_awlen(b_awlen),
                .m_wvalid(b_wvalid), .m_wready(b_wready), .m_wdata(b_wdata), .m_wstrb(b_wstrb),
                .m_wlast(b_wlast), .m_bvalid(b_bvalid), .m_bready(b_bready),
                .m_bresp(m_frame_bresp)
            );
            rt_axi_read_two #(.ADDR(ADDR)) u_reads (
                .clk(clk), .rst(rst), .a_arvalid(arvalid), .a_arready(arready), .a_arid(arid),
                .a_araddr(araddr), .a_rvalid(rvalid), .a_rready(rready), .b_arvalid(b_arvalid),
                .b_arready(b_arready), .b_araddr(b_araddr), .b_rvalid(b_rvalid),
                .b_rready(b_rready), .m_arvalid(m_scene_arvalid), .m_arready(m_scene_arready),
                .m_arid(m_scene_arid), .m_araddr(m_scene_araddr), .m_rvalid(m_scene_rvalid),
                .m_rready(m_scene_rready), .m_rid(m_scene_rid)
            );
            rt_axi_write_two #(.DATA(DATA), .ADDR(ADDR)) u_writes (
                .clk(clk), .rst(rst), .forget_i(forget), .a_awvalid(awvalid),
                .a_awready(awready), .a_awaddr(awaddr), .a_awlen(awlen), .a_wvalid(wvalid),
                .a_wready(wready), .a_wdata(wdata), .a_wstrb(wstrb), .a_wlast(wlast),
                .a_bvalid(bvalid), .a_bready(bready), .b_awvalid(b_awvalid),
                .b_awready(b_awready), .b_awaddr(b_awaddr), .b_awlen(b_awlen),
                .b_wvalid(b_wvalid), .b_wready(b_wready), .b_wdata(b_wdata), .b_wstrb(b_wstrb),
                .b_wlast(b_wlast), .b_bvalid(b_bvalid), .b_bready(b_bready),
                .m_awvalid(m_frame_awvalid), .m_awready(m_frame_awready),
                .m_awaddr(m_frame_awaddr), .m_awlen(m_frame_awlen), .m_wvalid(m_frame_wvalid),
                .m_wready(m_frame_wready), .m_wdata(m_frame_wdata), .m_wstrb(m_frame_wstrb),
                .m_wlast(m_frame_wlast), .m_bvalid(m_frame_bvalid), .m_bready(m_frame_bready)
            );
            genvar n;
            for (n = 0; n < 8; n = n + 1) begin : g_order
                assign run_order[n] = n == `RT_TOP_CONTROL_START ? start
                    : order[n] && !(n == `RT_TOP_CONTROL_KEEP_CACHE && held);
            end
            assign core_data = reads && cfg_addr == `RT_REG_ROOT
                               ? {{(32-`RT_LINE_BITS){1'b0}}, root} : cfg_data;
        end else begin : g_no_build
            assign build_errors = 6'd0;
            assign build_words  = 64'd0;
            assign {build_done, held, cutting, build_busy} = 4'd0;
            assign {status[`RT_TOP_STATUS_BUILDING], status[`RT_TOP_STATUS_TREE_VALID],
                    status[`RT_TOP_STATUS_TREE]} = 3'd0;
            assign run_order = order;
            assign core_data = cfg_data;
            assign {m_scene_arvalid, m_scene_arid, m_scene_araddr, m_scene_rready} =
                   {arvalid, arid, araddr, rready};
            assign {arready, rvalid} = {m_scene_arready, m_scene_rvalid};
            assign {m_frame_awvalid, m_frame_awaddr, m_frame_awlen, m_frame_wvalid, m_frame_wdata,
                    m_frame_wstrb, m_frame_wlast, m_frame_bready} =
                   {awvalid, awaddr, awlen, wvalid, wdata, wstrb, wlast, bready};
            assign {awready, wready, bvalid} = {m_frame_awready, m_frame_wready, m_frame_bvalid};
        end
    endgenerate

    // ---- display ----
    generate
        if (VIDEO != 0) begin : g_video
            assign m_scan_arid = A_SCAN_ID[`RT_TAG_BITS-1:0];
            assign {m_scan_arcache, m_scan_arprot, m_scan_arqos} = {A_CACHE[3:0], A_PROT[2:0],
                                                                    A_SCAN_QOS[3:0]};
            wire [`RT_MODE_BITS-1:0] mode;
            assign mode[`RT_MODE_H_ACTIVE] = settings[`RT_TOP_SET_VIDEO_H_ACTIVE_ACTIVE];
            assign mode[`RT_MODE_H_FRONT]  = settings[`RT_TOP_SET_VIDEO_H_ACTIVE_FRONT];
            assign mode[`RT_MODE_H_SYNC]   = settings[`RT_TOP_SET_VIDEO_H_SYNC_SYNC];
            assign mode[`RT_MODE_H_BACK]   = settings[`RT_TOP_SET_VIDEO_H_SYNC_BACK];
            assign mode[`RT_MODE_V_ACTIVE] = settings[`RT_TOP_SET_VIDEO_V_ACTIVE_ACTIVE];
            assign mode[`RT_MODE_V_FRONT]  = settings[`RT_TOP_SET_VIDEO_V_ACTIVE_FRONT];
            assign mode[`RT_MODE_V_SYNC]   = settings[`RT_TOP_SET_VIDEO_V_SYNC_SYNC];
            assign mode[`RT_MODE_V_BACK]   = settings[`RT_TOP_SET_VIDEO_V_SYNC_BACK];
            assign mode[`RT_MODE_H_POL]    = settings[`RT_TOP_SET_VIDEO_H_POL];
            assign mode[`RT_MODE_V_POL]    = settings[`RT_TOP_SET_VIDEO_V_POL];
            rt_video #(.DATA(DATA), .ADDR(ADDR)) u_video (
                .clk(clk), .rst(rst), .enable_i(settings[`RT_TOP_SET_VIDEO_ENABLE]),
                .forget_i(forget), .mode_i(mode), .format_i(settings[`RT_TOP_SET_FORMAT_RGB565]),
                .stride_i({settings[`RT_TOP_SET_STRIDE_UNITS], 5'd0}),
                .double_i(settings[`RT_TOP_SET_VIDEO_DOUBLE]), .take_o(video_take),
                .show_valid_i(show_valid_o), .show_base_i(show_base_o), .blank_o(blank),
                .underrun_o(underrun), .error_o(scan_error), .stall_o(scan_stall),
                .idle_o(video_idle), .m_scan_arvalid(m_scan_arvalid),
                .m_scan_arready(m_scan_arready),
                .m_scan_araddr(m_scan_araddr), .m_scan_arlen(m_scan_arlen),
                .m_scan_arsize(m_scan_arsize), .m_scan_arburst(m_scan_arburst),
                .m_scan_rvalid(m_scan_rvalid),
                .m_scan_rready(m_scan_rready), .m_scan_rdata(m_scan_rdata),
                .m_scan_rresp(m_scan_rresp), .m_scan_rlast(m_scan_rlast), .pix_clk(pix_clk),
                .pix_rst(pix_rst), .m_video_tvalid(m_video_tvalid),
                .m_video_tready(m_video_tready), .m_video_tdata(m_video_tdata),
                .m_video_tuser(m_video_tuser), .m_video_tlast(m_video_tlast), .de_o(de_o),
                .hsync_o(hsync_o), .vsync_o(vsync_o), .tmds0_o(tmds0_o), .tmds1_o(tmds1_o),
                .tmds2_o(tmds2_o)
            );
        end else begin : g_no_video
            assign {video_take, blank, underrun, scan_error, scan_stall} = 5'd0;
            assign video_idle = 1'b1;
            assign {m_scan_arvalid, m_scan_arid, m_scan_arlen, m_scan_arsize, m_scan_arburst,
                    m_scan_arcache, m_scan_arprot, m_scan_arqos, m_scan_rready} = 31'd0;
            assign m_scan_araddr = {ADDR{1'b0}};
            assign {m_video_tvalid, m_video_tdata, m_video_tuser, m_video_tlast, de_o, hsync_o,
                    vsync_o, tmds0_o, tmds1_o, tmds2_o} = 60'd0;
            wire unused_video = &{1'b0, m_scan_arready, m_scan_rvalid, m_scan_rdata, m_scan_rresp,
                                  m_scan_rlast, pix_clk, pix_rst, m_video_tready, video_take};
        end
    endgenerate

    // ---- what an idle block still looks at ----
    reg  was_q;                          // so that what happened is seen in registers
    wire now = rst || core_active || s_axil_awvalid || s_axil_wvalid || s_axil_arvalid ||
               control_busy || machine_busy || count_busy || status[`RT_TOP_STATUS_BUSY] ||
               status[`RT_TOP_STATUS_DRAINING] || !read_idle || !write_idle || take_i ||
               !video_idle || build_busy;
    assign active_o = now || was_q;
    always @(posedge clk) was_q <= now;
endmodule
`default_nettype wire
