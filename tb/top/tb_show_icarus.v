// tb_show_icarus.v - rt_top in Icarus: registers and memory in, symbols out, each picture compared
// SPDX-License-Identifier: Apache-2.0
// CORE_PARAMETERS, WIDTH, HEIGHT, LAYERS, BUILD are macros; +machine, +memory, +frame are files
// that lab/top/golden.py writes: registers, words of 64 bits, the golden model's pixels. A picture
// is black as long as no frame is complete; three that follow must be the frame. With LAYERS MUX
// then changes within a picture, and the next ones show its layer. With BUILD the machine is one of
// tree `hw`, which loses its tree: rt_top builds it. Prints `ok` or `not ok` and ends by itself.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_top.vh"
`ifndef CORE_PARAMETERS
`define CORE_PARAMETERS .W(`RT_PROFILE_STANDARD_W)
`define WIDTH 8
`define HEIGHT 6
`endif
`ifndef LAYERS
`define LAYERS 0
`endif
`ifndef BUILD
`define BUILD 0
`endif
module tb_show_icarus;
    localparam AB = 12;                   // address bits of the memory: 32 KiB
    localparam H_FRONT = 3, H_SYNC = 4, H_BACK = 5, V_FRONT = 1, V_SYNC = 2, V_BACK = 9;
    reg clk = 1'b0, pix_clk = 1'b0, rst = 1'b1;
    always #3 clk = !clk;
    always #5 pix_clk = !pix_clk;

    // ---- memory: a read port of scene and display each, a write port ----
    reg  [63:0] memory [0:(1<<AB)-1];
    wire        fr_awvalid, fr_awready, fr_wvalid, fr_wready, fr_wlast, fr_bvalid, fr_bready;
    wire [31:0] fr_awaddr;
    wire [63:0] fr_wdata;
    wire [7:0]  fr_wstrb;
    wire [3:0]  fr_we;
    wire [AB-1:0] fr_addr;
    rt_ram_writes #(.AB(AB)) u_writes (
        .clk(clk), .rst(rst), .s_awvalid(fr_awvalid), .s_awready(fr_awready),
        .s_awaddr(fr_awaddr), .s_wvalid(fr_wvalid), .s_wready(fr_wready), .s_wstrb(fr_wstrb),
        .s_wlast(fr_wlast), .s_bvalid(fr_bvalid), .s_bready(fr_bready), .we_o(fr_we),
        .addr_o(fr_addr)
    );
    genvar i;
    generate for (i = 0; i < 4; i = i + 1) begin : g_part
        always @(posedge clk) if (fr_we[i]) memory[fr_addr][16*i +: 16] <= fr_wdata[16*i +: 16];
    end endgenerate
    wire [1:0]    arvalid, arready, rvalid, rready, rlast, en;   // scene, display
    wire [4:0]    arid, rid;              // of the scene, which is answered in order
    wire [31:0]   araddr [0:1];
    wire [7:0]    arlen [0:1];
    wire [AB-1:0] raddr [0:1];
    reg  [63:0]   rdata [0:1];
    generate for (i = 0; i < 2; i = i + 1) begin : g_reads
        rt_ram_reads #(.AB(AB)) u_reads (
            .clk(clk), .rst(rst), .s_arvalid(arvalid[i]), .s_arready(arready[i]),
            .s_araddr(araddr[i]), .s_arlen(arlen[i]), .s_rvalid(rvalid[i]),
            .s_rready(rready[i]), .s_rlast(rlast[i]), .en_o(en[i]), .addr_o(raddr[i])
        );
        always @(posedge clk) if (en[i]) rdata[i] <= memory[raddr[i]];
    end endgenerate

    rt_fifo #(.WIDTH(5), .DEPTH(64)) u_ids (
        .clk(clk), .rst(rst), .in_valid_i(arvalid[0] && arready[0]), .in_ready_o(),
        .in_data_i(arid), .out_valid_o(), .out_ready_i(rvalid[0] && rready[0] && rlast[0]),
        .out_data_o(rid)
    );

    // ---- the block ----
    reg         awvalid = 1'b0, wvalid = 1'b0;
    reg  [11:0] awaddr;
    reg  [31:0] wdata;
    wire        awready, wready, bvalid, irq;
    wire [9:0]  blue, green, red;
    rt_top #(.DATA(64), .VIDEO(1), .LAYERS(`LAYERS), .BUILD(`BUILD), `CORE_PARAMETERS) u_top (
        .m_scene_arcache(), .m_scene_arprot(), .m_scene_arqos(), .m_frame_awid(),
        .m_frame_awcache(), .m_frame_awprot(), .m_frame_awqos(), .m_scan_arid(),
        .m_scan_arcache(), .m_scan_arprot(), .m_scan_arqos(), .active_o(),
        .clk(clk), .rst(rst), .irq_o(irq), .s_axil_awvalid(awvalid), .s_axil_awready(awready),
        .s_axil_awaddr(awaddr), .s_axil_wvalid(wvalid), .s_axil_wready(wready),
        .s_axil_wdata(wdata), .s_axil_wstrb(4'hf), .s_axil_bvalid(bvalid), .s_axil_bready(1'b1),
        .s_axil_bresp(), .s_axil_arvalid(1'b0), .s_axil_arready(), .s_axil_araddr(12'd0),
        .s_axil_rvalid(), .s_axil_rready(1'b0), .s_axil_rdata(), .s_axil_rresp(),
        .m_scene_arvalid(arvalid[0]), .m_scene_arready(arready[0]), .m_scene_arid(arid),
        .m_scene_araddr(araddr[0]), .m_scene_arlen(arlen[0]), .m_scene_arsize(),
        .m_scene_arburst(), .m_scene_rvalid(rvalid[0]), .m_scene_rready(rready[0]),
        .m_scene_rid(rid), .m_scene_rdata(rdata[0]), .m_scene_rresp(2'd0),
        .m_scene_rlast(rlast[0]), .m_frame_awvalid(fr_awvalid), .m_frame_awready(fr_awready),
        .m_frame_awaddr(fr_awaddr), .m_frame_awlen(),
        .m_frame_awsize(), .m_frame_awburst(), .m_frame_wvalid(fr_wvalid),
        .m_frame_wready(fr_wready), .m_frame_wdata(fr_wdata), .m_frame_wstrb(fr_wstrb),
        .m_frame_wlast(fr_wlast), .m_frame_bvalid(fr_bvalid), .m_frame_bready(fr_bready),
        .m_frame_bresp(2'd0), .take_i(1'b0), .show_valid_o(), .show_base_o(),
        .m_scan_arvalid(arvalid[1]), .m_scan_arready(arready[1]), .m_scan_araddr(araddr[1]),
        .m_scan_arlen(arlen[1]), .m_scan_arsize(), .m_scan_arburst(), .m_scan_rvalid(rvalid[1]),
        .m_scan_rready(rready[1]), .m_scan_rdata(rdata[1]), .m_scan_rresp(2'd0),
        .m_scan_rlast(rlast[1]), .pix_clk(pix_clk), .pix_rst(rst), .m_video_tvalid(),
        .m_video_tready(1'b1), .m_video_tdata(), .m_video_tuser(), .m_video_tlast(), .de_o(),
        .hsync_o(), .vsync_o(), .tmds0_o(blue), .tmds1_o(green), .tmds2_o(red)
    );

    task put(input [11:0] offset, input [31:0] value);
        begin
            @(negedge clk);
            {awvalid, awaddr, wvalid, wdata} = {1'b1, offset, 1'b1, value};
            while (awvalid || wvalid) begin
                @(posedge clk);
                if (awready) awvalid <= 1'b0;
                if (wready) wvalid <= 1'b0;
                @(negedge clk);
            end
            while (!bvalid) @(negedge clk);
        end
    endtask

    // ---- display ----
    `include "tmds_decode.vh"
    wire [8:0]  b = decode(blue), g = decode(green), r = decode(red);
    wire [23:0] pixel = {r[7:0], g[7:0], b[7:0]};
    localparam N = `WIDTH * `HEIGHT;
    reg  [23:0] golden [0:4*N-1];         // as each value of MUX has it
    reg  on = 1'b0;
    integer mux = 0, earlier = 0;         // in register MUX, and until now
    integer at = 0, bad = 0, stale = 0, lit = 0, black = 0, whole = 0, late = 0, wrong = 0;
    always @(posedge pix_clk) if (on && b[8] === 1'b1) begin
        if (g[8] !== 1'b1 || r[8] !== 1'b1 || ^pixel === 1'bx) wrong = wrong + 1;
        if (pixel !== golden[N*mux + at]) bad = bad + 1;
        if (pixel !== golden[N*earlier + at]) stale = stale + 1;
        if (pixel !== 24'd0) lit = lit + 1;
        at = at + 1;
        if (at == N) begin
            if (bad == 0) whole = whole + 1;
            else if (stale == 0 && mux != earlier && whole == 0 && late == 0) late = 1;
            else if (lit == 0 && whole == 0 && mux == 0) black = black + 1;
            else wrong = wrong + 1;
            {at, bad, stale, lit} = 0;
        end
    end

    reg [31:0]  machine [0:`RT_N_REGS-1];
    reg [8*256-1:0] file;
    integer n;
    initial begin
        if ($value$plusargs("machine=%s", file)) $readmemh(file, machine);
        if ($value$plusargs("frame=%s", file)) $readmemh(file, golden);
        for (n = 0; n < 1 << AB; n = n + 1) memory[n] = 64'd0;
        if ($value$plusargs("memory=%s", file)) $readmemh(file, memory);
        #200 rst = 1'b0;
        for (n = 0; n < `RT_N_REGS; n = n + 1) put(12'h200 + 4 * n, machine[n]);
        put(`RT_TOP_SCENE_BASE, 32'd0);
        put(`RT_TOP_FRAME0, 32'h4000);
        put(`RT_TOP_FRAME1, 32'h5000);
        put(`RT_TOP_FRAME2, 32'h6000);
        put(`RT_TOP_STRIDE, 32'd128);
        if (`LAYERS != 0) put(`RT_TOP_LAYER_BYTES, 32'h400);
        put(`RT_TOP_VIDEO_H_ACTIVE, {H_FRONT[15:0], 16'd`WIDTH});
        put(`RT_TOP_VIDEO_H_SYNC, {H_BACK[15:0], H_SYNC[15:0]});
        put(`RT_TOP_VIDEO_V_ACTIVE, {V_FRONT[15:0], 16'd`HEIGHT});
        put(`RT_TOP_VIDEO_V_SYNC, {V_BACK[15:0], V_SYNC[15:0]});
        put(`RT_TOP_VIDEO, 32'd1);
        on = 1'b1;
        if (`BUILD != 0) begin
            for (n = 0; n < 4 * machine[`RT_REG_PRIM_BASE]; n = n + 1) memory[n] = 64'd0;
            put(`RT_TOP_BUILD_COUNT, machine[`RT_REG_N_PRIMS]);
            put(`RT_TOP_BUILD_RECORDS, machine[`RT_REG_PRIM_BASE]);
            put(`RT_TOP_BUILD_LINES, machine[`RT_REG_PRIM_BASE]);
            put(`RT_TOP_BUILD_MODE, 32'd1 << `RT_TOP_BUILD_MODE_ROOT);
        end
        put(`RT_TOP_CONTROL, 32'd1 << `RT_TOP_CONTROL_START |
                             (`BUILD != 0 ? 32'd1 << `RT_TOP_CONTROL_BUILD : 32'd0));
        for (n = 0; n < 200000 && whole < 3 && wrong == 0; n = n + 1) @(posedge clk);
        while (`LAYERS != 0 && mux < 3 && whole >= 3 && wrong == 0) begin
            for (n = 0; n < 20000 && at < N / 3; n = n + 1) @(posedge clk); // within a picture
            put(`RT_TOP_MUX, mux + 1);
            earlier = mux;
            mux     = mux + 1;
            stale   = bad;                      // it began as the one before, and ends so
            bad     = 1;
            whole   = 0;
            late    = 0;
            for (n = 0; n < 20000 && whole < 3 && wrong == 0; n = n + 1) @(posedge clk);
        end
        if (`LAYERS != 0 && mux < 3) wrong = wrong + 1;
        if (wrong == 0 && whole >= 3)
            $display("ok tb_show_icarus: %0d black pictures, then the frame, MUX up to %0d", black,
                     mux);
        else $display("not ok tb_show_icarus: %0d right, %0d wrong pictures", whole, wrong);
        $finish;
    end
endmodule
`default_nettype wire
