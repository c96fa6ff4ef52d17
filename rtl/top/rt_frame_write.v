// rt_frame_write.v - finished pixels into a frame of the frame store
// SPDX-License-Identifier: Apache-2.0
//   pixels -> mux -> [groups of 8] -> row -> address, format -> [AXI4 writes]
// address = frame + y*stride + x*4 (XRGB8888) or x*2 (RGB565); blue is in the low bits. RGB565
// takes the high bits of each colour. A group is a burst of 32 or 16 bytes; one in three cycles.
// With LAYERS there is no mux: a group is three bursts, of Rendering, L1 and L2, whose frames lie
// layer_i bytes apart.
// dead_i: the bus is given up, pixels are thrown away; cut_i: the core is in reset besides.
`timescale 1ns / 1ps
`default_nettype none
module rt_frame_write #(
    parameter DATA    = 64,              // bits of a beat, 64 or 128
    parameter BUFFERS = 16,              // groups filled at once, a power of two, 4..64
    parameter LAYERS  = 0,               // 1: all three colours of a pixel are stored
    parameter ADDR    = 32               // bits of an address, 32 to 40
) (
    input  wire              clk,
    input  wire              rst,
    input  wire [ADDR-1:0]   base_i,     // of the frame, a multiple of 64
    input  wire              begin_i,    // START; from now on
    input  wire [1:0]        mux_i,      // register MUX says which colours are stored,
    input  wire [15:0]       stride_i,   // rows are apart by this, a multiple of 32
    input  wire              rgb565_i,   // pixels have this format,
    input  wire [31:0]       layer_i,    // and layers are apart by this, a multiple of 64
    // from rt_run
    input  wire              cut_i,
    input  wire              dead_i,
    input  wire              forget_i,   // the bus was reset: it owes nothing
    input  wire              flush_i,    // no pixel follows
    // to rt_run
    output wire              empty_o,    // all pixels are written, and answered
    output wire              idle_o,     // the bus owes nothing
    output wire              stall_o,    // it owes something and does nothing
    output wire              slverr_o,
    output wire              decerr_o,
    // to rt_totals
    output wire              burst_o,
    output wire              beat_o,
    output wire [3:0]        pixels_o,   // of the burst
    // from the core
    input  wire              pix_valid_i,
    output wire              pix_ready_o,
    input  wire [13:0]       pix_x_i,
    input  wire [13:0]       pix_y_i,
    input  wire [71:0]       pix_colour_i, // {L2, L1, Rendering}, each 0xBBGGRR
    input  wire [23:0]       pix_frame_i,  // the one that register FRAME of the core selects
    // AXI4
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
    // ---- of the frame ----
    reg  [15:0]  stride_q;
    reg          rgb565_q;
    always @(posedge clk) if (begin_i) {rgb565_q, stride_q} <= {rgb565_i, stride_i};

    // ---- mux, groups ----
    localparam COLOURS = LAYERS != 0 ? 3 : 1;
    wire [24*COLOURS-1:0]  rgb;          // of the pixel that comes
    wire         drop = cut_i || dead_i;
    wire         empty, pix_ready, g_valid, g_ready;
    wire [10:0]  g_column;
    wire [13:0]  g_y;
    wire [7:0]   g_mask;
    wire [192*COLOURS-1:0] g_rgb;
    rt_frame_groups #(.BUFFERS(BUFFERS), .COLOURS(COLOURS)) u_groups (
        .clk(clk), .rst(rst || drop), .flush_i(flush_i), .empty_o(empty),
        .pix_valid_i(pix_valid_i), .pix_ready_o(pix_ready), .pix_x_i(pix_x_i), .pix_y_i(pix_y_i),
        .pix_rgb_i(rgb), .group_valid_o(g_valid), .group_ready_i(g_ready),
        .group_column_o(g_column), .group_y_o(g_y), .group_mask_o(g_mask), .group_rgb_o(g_rgb)
    );
    assign pix_ready_o = drop || pix_ready;

    // ---- stage 0: the row of the group that waits ----
    reg          row_valid_q;
    reg  [29:0]  row_q;                  // bytes before it
    wire         g_go = g_valid && row_valid_q;
    always @(posedge clk) begin
        row_q       <= {16'd0, g_y} * {14'd0, stride_q};
        row_valid_q <= g_valid && !g_ready && !rst && !drop;
    end

    // ---- stage 1: address ----
    reg          s1_valid_q;
    reg  [ADDR-1:0] s1_addr_q;
    reg  [7:0]   s1_mask_q;
    reg  [191:0] s1_rgb_q;
    wire         s1_ready;
    wire         s1_free = s1_ready || !s1_valid_q;
    wire [ADDR-1:0] base;                // of the layer that is next of the group
    wire [191:0] layer_rgb;
    always @(posedge clk) begin
        if (s1_free) begin
            s1_valid_q <= g_go;
            s1_addr_q  <= base + {{(ADDR-30){1'b0}}, row_q} + {{(ADDR-32){1'b0}},
                          rgb565_q ? {17'd0, g_column, 4'd0} : {16'd0, g_column, 5'd0}};
            s1_mask_q  <= g_mask;
            s1_rgb_q   <= layer_rgb;
        end
        if (rst || drop) s1_valid_q <= 1'b0;
    end
    genvar p;
    generate
        if (LAYERS == 0) begin : g_mux
            reg [1:0] mux_q;
            always @(posedge clk) if (begin_i) mux_q <= mux_i;
            assign rgb = mux_q == 2'd0 ? pix_frame_i : mux_q == 2'd1 ? pix_colour_i[0 +: 24]
                         : mux_q == 2'd2 ? pix_colour_i[24 +: 24] : pix_colour_i[48 +: 24];
            assign base      = base_i;
            assign layer_rgb = g_rgb;
            assign g_ready   = s1_free && g_go;
            wire unused_layer = &{1'b0, layer_i};
        end else begin : g_layers
            reg  [31:0] layer_bytes_q;
            reg  [ADDR-1:0] base_q;
            reg  [1:0]  layer_q;         // of the group, 0 to 2
            wire        last = layer_q == 2'd2;
            assign rgb     = pix_colour_i;
            assign base    = layer_q == 2'd0 ? base_i : base_q;
            assign g_ready = s1_free && g_go && last;
            for (p = 0; p < 8; p = p + 1) begin : g_pixel
                wire [71:0] colours = g_rgb[72*p +: 72];
                assign layer_rgb[24*p +: 24] = layer_q == 2'd0 ? colours[0 +: 24]
                    : layer_q == 2'd1 ? colours[24 +: 24] : colours[48 +: 24];
            end
            always @(posedge clk) begin
                if (begin_i) layer_bytes_q <= layer_i;
                if (s1_free && g_go) begin
                    layer_q <= last ? 2'd0 : layer_q + 2'd1;
                    base_q  <= base + {{(ADDR-32){1'b0}}, layer_bytes_q};
                end
                if (rst || drop) layer_q <= 2'd0;
            end
            wire unused_mux = &{1'b0, mux_i, pix_frame_i};
        end
    endgenerate

    // ---- stage 2: format ----
    wire [255:0] xrgb;
    wire [127:0] rgb565;
    wire [31:0]  xrgb_strobe;
    wire [15:0]  rgb565_strobe;
    generate
        for (p = 0; p < 8; p = p + 1) begin : g_pixel
            wire [23:0] rgb_p = s1_mask_q[p] ? s1_rgb_q[24*p +: 24] : 24'd0;
            wire [7:0]  red = rgb_p[7:0], green = rgb_p[15:8], blue = rgb_p[23:16];
            assign xrgb[32*p +: 32]         = {8'd0, red, green, blue};
            assign rgb565[16*p +: 16]       = {red[7:3], green[7:2], blue[7:3]};
            assign xrgb_strobe[4*p +: 4]    = {4{s1_mask_q[p]}};
            assign rgb565_strobe[2*p +: 2]  = {2{s1_mask_q[p]}};
        end
    endgenerate
    rt_axi_write #(.DATA(DATA), .ADDR(ADDR)) u_write (
        .clk(clk), .rst(rst), .cut_i(drop), .forget_i(forget_i), .idle_o(idle_o),
        .stall_o(stall_o), .slverr_o(slverr_o), .decerr_o(decerr_o), .burst_o(burst_o),
        .beat_o(beat_o), .group_valid_i(s1_valid_q), .group_ready_o(s1_ready),
        .group_addr_i(s1_addr_q), .group_half_i(rgb565_q),
        .group_strobe_i(rgb565_q ? {16'd0, rgb565_strobe} : xrgb_strobe),
        .group_data_i(rgb565_q ? {128'd0, rgb565} : xrgb),
        .m_awvalid(m_awvalid), .m_awready(m_awready), .m_awaddr(m_awaddr), .m_awlen(m_awlen),
        .m_wvalid(m_wvalid), .m_wready(m_wready), .m_wdata(m_wdata), .m_wstrb(m_wstrb),
        .m_wlast(m_wlast), .m_bvalid(m_bvalid), .m_bready(m_bready), .m_bresp(m_bresp)
    );
    reg [3:0] pixels;
    integer   i;
    always @* begin
        pixels = 4'd0;
        for (i = 0; i < 8; i = i + 1) pixels = pixels + {3'd0, s1_mask_q[i]};
    end
    assign pixels_o = pixels;
    assign empty_o  = empty && !s1_valid_q && idle_o;
endmodule
`default_nettype wire
