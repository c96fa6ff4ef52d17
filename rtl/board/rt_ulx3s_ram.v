// rt_ulx3s_ram.v - a ULX3S that draws one machine out of block RAM and shows it, 320x240 doubled
// SPDX-License-Identifier: Apache-2.0
//   rt_rom registers --> rt_script --> AXI4-Lite -->  rt_top  --> TMDS --> rt_serialise --> GPDI
//   rt_rom scene --> rt_ram_reads --> AXI4 ------->          --> AXI4 --> rt_ram_writes --> RAM
//                                                           <-- AXI4 <-- rt_ram_reads <----'
// `sphaera load --rom` makes both files from a machine file; its writes are those of the driver.
// The three frames have one address: what is drawn is drawn once, and stands still.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_board.vh"
`include "rt_layout.vh"
module rt_ulx3s_ram #(
    parameter REGISTERS   = "",           // file of the writes to registers
    parameter SCENE       = "",           // file of the machine's memory
    parameter SCENE_WORDS = 1024          // of 64 bits, a power of two
) (
    input  wire       clk_25mhz,
    input  wire [6:0] btn_i,              // button 1: anew
    output wire [3:0] gpdi_o,             // blue, green, red, clock
    output wire [7:0] led_o               // alive, written, shown, error; button; others off
);
    localparam FRAME_WORDS = 320 * 240 / 4;
    localparam AB = $clog2(SCENE_WORDS);
    localparam FB = $clog2(FRAME_WORDS);
    wire clk, clk5, rst, unused_clk, unused_rst;
    rt_clocks u_clocks (
        .clk_25mhz(clk_25mhz), .restart_i(btn_i[1]), .clk(clk), .clk5(clk5), .mem_clk(unused_clk),
        .rst_o(rst), .mem_rst_o(unused_rst)
    );

    // ---- registers ----
    reg  [7:0]  next_q;                   // item that is read next
    reg  [1:0]  boot_q;                   // read the first, begin, done
    wire        take, written;
    wire [43:0] item;
    wire        awvalid, awready, wvalid, wready, bvalid, bready;
    wire [11:0] awaddr;
    wire [31:0] wdata;
    always @(posedge clk) begin
        if (take || boot_q == 2'd0) next_q <= next_q + 8'd1;
        if (boot_q != 2'd2) boot_q <= boot_q + 2'd1;
        if (rst) begin
            next_q <= 8'd0;
            boot_q <= 2'd0;
        end
    end
    rt_rom #(.WIDTH(44), .WORDS(256), .FILE(REGISTERS)) u_registers (
        .clk(clk), .en_i(take || boot_q == 2'd0), .addr_i(next_q), .data_o(item)
    );
    rt_script u_script (
        .clk(clk), .rst(rst), .start_i(boot_q == 2'd1), .done_o(written), .item_i(item),
        .item_take_o(take), .m_awvalid(awvalid), .m_awready(awready), .m_awaddr(awaddr),
        .m_wvalid(wvalid), .m_wready(wready), .m_wdata(wdata), .m_bvalid(bvalid), .m_bready(bready)
    );

    // ---- scene ----
    wire        sc_arvalid, sc_arready, sc_rvalid, sc_rready, sc_rlast, sc_en;
    wire [31:0] sc_araddr;
    wire [7:0]  sc_arlen;
    wire [`RT_TAG_BITS-1:0] sc_arid, sc_rid;
    wire [AB-1:0] sc_addr;
    wire [63:0] sc_data;
    rt_ram_reads #(.AB(AB)) u_scene_reads (
        .clk(clk), .rst(rst), .s_arvalid(sc_arvalid), .s_arready(sc_arready),
        .s_araddr(sc_araddr), .s_arlen(sc_arlen), .s_rvalid(sc_rvalid), .s_rready(sc_rready),
        .s_rlast(sc_rlast), .en_o(sc_en), .addr_o(sc_addr)
    );
    rt_rom #(.WORDS(SCENE_WORDS), .FILE(SCENE)) u_scene (
        .clk(clk), .en_i(sc_en), .addr_i(sc_addr), .data_o(sc_data)
    );
    wire        sc_ids_room, sc_ids_there; // always, and with every answer
    rt_fifo #(.WIDTH(`RT_TAG_BITS), .DEPTH(`RT_BOARD_PENDING)) u_scene_ids (
        .clk(clk), .rst(rst), .in_valid_i(sc_arvalid && sc_arready), .in_ready_o(sc_ids_room),
        .in_data_i(sc_arid), .out_valid_o(sc_ids_there),
        .out_ready_i(sc_rvalid && sc_rready && sc_rlast), .out_data_o(sc_rid)
    );

    // ---- frame store ----
    wire        fr_awvalid, fr_awready, fr_wvalid, fr_wready, fr_wlast, fr_bvalid, fr_bready;
    wire [31:0] fr_awaddr;
    wire [63:0] fr_wdata;
    wire [7:0]  fr_wstrb;
    wire [3:0]  fr_we;
    wire [FB-1:0] fr_addr, vi_addr;
    wire        vi_arvalid, vi_arready, vi_rvalid, vi_rready, vi_rlast, vi_en;
    wire [31:0] vi_araddr;
    wire [7:0]  vi_arlen;
    wire [63:0] vi_data;
    rt_ram_writes #(.AB(FB)) u_frame_writes (
        .clk(clk), .rst(rst), .s_awvalid(fr_awvalid), .s_awready(fr_awready),
        .s_awaddr(fr_awaddr), .s_wvalid(fr_wvalid), .s_wready(fr_wready), .s_wstrb(fr_wstrb),
        .s_wlast(fr_wlast), .s_bvalid(fr_bvalid), .s_bready(fr_bready), .we_o(fr_we),
        .addr_o(fr_addr)
    );
    rt_ram_reads #(.AB(FB)) u_scan_reads (
        .clk(clk), .rst(rst), .s_arvalid(vi_arvalid), .s_arready(vi_arready),
        .s_araddr(vi_araddr), .s_arlen(vi_arlen), .s_rvalid(vi_rvalid), .s_rready(vi_rready),
        .s_rlast(vi_rlast), .en_o(vi_en), .addr_o(vi_addr)
    );
    rt_store #(.WORDS(FRAME_WORDS)) u_store (
        .clk(clk), .we_i(fr_we), .wr_addr_i(fr_addr), .wr_data_i(fr_wdata),
        .en_i(vi_en), .rd_addr_i(vi_addr), .data_o(vi_data)
    );

    // ---- the block ----
    wire       shown, irq;
    wire [9:0] blue, green, red;
    // what nothing here looks at
    wire no_arready, no_rvalid, no_video_tvalid, no_video_tuser, no_video_tlast, no_de, no_hsync,
         no_vsync;
    wire [1:0] no_bresp, no_rresp, no_scene_arburst, no_frame_awburst, no_scan_arburst;
    wire [2:0] no_scene_arsize, no_frame_awsize, no_scan_arsize;
    wire [7:0] no_frame_awlen;
    wire [23:0] no_video_tdata;
    wire [31:0] no_rdata, no_show_base;
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
        .s_axil_wdata(wdata), .s_axil_wstrb(4'hf), .s_axil_bvalid(bvalid), .s_axil_bready(bready),
        .s_axil_bresp(no_bresp), .s_axil_arvalid(1'b0), .s_axil_arready(no_arready),
        .s_axil_araddr(12'd0), .s_axil_rvalid(no_rvalid), .s_axil_rready(1'b0),
        .s_axil_rdata(no_rdata), .s_axil_rresp(no_rresp), .m_scene_arvalid(sc_arvalid),
        .m_scene_arready(sc_arready), .m_scene_arid(sc_arid), .m_scene_araddr(sc_araddr),
        .m_scene_arlen(sc_arlen), .m_scene_arsize(no_scene_arsize),
        .m_scene_arburst(no_scene_arburst), .m_scene_rvalid(sc_rvalid),
        .m_scene_rready(sc_rready), .m_scene_rid(sc_rid), .m_scene_rdata(sc_data),
        .m_scene_rresp(2'd0), .m_scene_rlast(sc_rlast), .m_frame_awvalid(fr_awvalid),
        .m_frame_awready(fr_awready), .m_frame_awaddr(fr_awaddr), .m_frame_awlen(no_frame_awlen),
        .m_frame_awsize(no_frame_awsize), .m_frame_awburst(no_frame_awburst),
        .m_frame_wvalid(fr_wvalid), .m_frame_wready(fr_wready), .m_frame_wdata(fr_wdata),
        .m_frame_wstrb(fr_wstrb), .m_frame_wlast(fr_wlast), .m_frame_bvalid(fr_bvalid),
        .m_frame_bready(fr_bready), .m_frame_bresp(2'd0), .take_i(1'b0), .show_valid_o(shown),
        .show_base_o(no_show_base), .m_scan_arvalid(vi_arvalid), .m_scan_arready(vi_arready),
        .m_scan_araddr(vi_araddr), .m_scan_arlen(vi_arlen), .m_scan_arsize(no_scan_arsize),
        .m_scan_arburst(no_scan_arburst), .m_scan_rvalid(vi_rvalid), .m_scan_rready(vi_rready),
        .m_scan_rdata(vi_data), .m_scan_rresp(2'd0), .m_scan_rlast(vi_rlast), .pix_clk(clk),
        .pix_rst(rst), .m_video_tvalid(no_video_tvalid), .m_video_tready(1'b1),
        .m_video_tdata(no_video_tdata), .m_video_tuser(no_video_tuser),
        .m_video_tlast(no_video_tlast), .de_o(no_de), .hsync_o(no_hsync), .vsync_o(no_vsync),
        .tmds0_o(blue), .tmds1_o(green), .tmds2_o(red)
    );
    rt_serialise u_serialise (
        .pix_clk(clk), .symbol_i({10'b0000011111, red, green, blue}), .clk5(clk5), .pin_o(gpdi_o)
    );

    // ---- lights ----
    reg  [24:0] beat_q;
    always @(posedge clk) beat_q <= rst ? 25'd0 : beat_q + 25'd1;
    assign led_o = {3'd0, btn_i[1], irq, shown, written, beat_q[24]};
    wire unused = &{1'b0, no_scene_arcache, no_scene_arprot, no_scene_arqos, no_frame_awid,
                    no_frame_awcache, no_frame_awprot, no_frame_awqos, no_scan_arid,
                    no_scan_arcache, no_scan_arprot, no_scan_arqos, no_active,
                    btn_i, unused_clk, unused_rst, no_arready, no_rvalid, no_video_tvalid,
                    no_video_tuser, no_video_tlast, no_de, no_hsync, no_vsync, no_bresp, no_rresp,
                    no_scene_arburst, no_frame_awburst, no_scan_arburst, no_scene_arsize,
                    no_frame_awsize, no_scan_arsize, no_frame_awlen, no_video_tdata, no_rdata,
                    no_show_base, sc_ids_room, sc_ids_there};
endmodule
`default_nettype wire
