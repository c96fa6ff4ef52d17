// rt_pixel_scans.v - pixels to trace and background pixels, from one walk of the window or two
// SPDX-License-Identifier: Apache-2.0
//   window --+-- left half  --> rt_pixel_scan --> 16 rays --+--> in turn --> pixel to trace
//            +-- right half --> rt_pixel_scan --> 16 rays --+
//   background pixels of both -----------------------------> in turn --> background pixel
// A walk that meets a surface waits for free slots, and then the other one may still cross the
// background. So several pipes have pixels of both kinds at a time. With one walk there is a queue
// here, and no choice.
// Model: that of rt_pixel_scan
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_pixel_scans #(
    parameter W     = 16,  // coordinate, bits
    parameter WD    = 17,  // direction component, bits
    parameter RECT  = 1,   // background separation by rectangle, 0 or 1
    parameter SPANS = 1,   // by spans in memory, 0 or 1
    parameter CONES = 1,   // exactly, by up to so many spheres, 0..16
    parameter TURNED = 0,  // 0 or 1: a grid in any axes
    parameter WALKS = 1    // 1 or 2
) (
    input  wire                 clk,
    input  wire                 rst,
    input  wire                 start_i,       // begin with the window
    output wire                 busy_o,        // pixels are left
    // registers
    input  wire [55:0]          window_i,      // {y1, x1, y0, x0}; ends are one past the last
    input  wire [3*WD-1:0]      dir_i,         // vec, of pixel 0, 0
    input  wire [WD-1:0]        pitch_i,       // direction units a pixel
    input  wire [95:0]          first_i,       // TURNED: as of rt_pixel_scan
    input  wire [95:0]          across_i,
    input  wire [95:0]          down_i,
    input  wire [1:0]           bg_mode_i,     // 0 all is traced, 1 rectangle, 2 spans, 3 cones
    input  wire [55:0]          rect_i,        // as the window
    input  wire [`RT_LINE_BITS-1:0] bg_base_i, // first line of the spans or cones
    input  wire [4:0]           bg_count_i,    // cones
    input  wire [`RT_LINE_BITS-1:0] mem_lines_i, // lines of memory
    // to the engines: pixels that are traced
    output wire                 ray_valid_o,
    input  wire                 ray_ready_i,
    output wire [`RT_START_BITS-1:0] ray_o,
    //: {DIR[3*WD], Y[14], X[14]}
    // to the pixel port: pixels that see the background
    output wire                 bg_valid_o,
    input  wire                 bg_ready_i,
    output wire [27:0]          bg_place_o,    // {y, x}
    // memory of each walk: tables of the background
    output wire [WALKS-1:0]     mem_req_valid_o,
    input  wire [WALKS-1:0]     mem_req_ready_i,
    output wire [`RT_LINE_BITS*WALKS-1:0] mem_req_line_o,
    input  wire [WALKS-1:0]     mem_rsp_valid_i,
    output wire [WALKS-1:0]     mem_rsp_ready_o,
    input  wire [255:0]         mem_rsp_data_i,
    input  wire                 mem_rsp_error_i,
    // errors
    output wire                 bad_table_o,   // the table does not lie in memory
    output wire                 bus_error_o
);
    localparam LB = `RT_LINE_BITS;
    localparam KEPT = TURNED != 0 ? 3*WD : 2*WD;   // of a direction; else z is that of all pixels
    localparam QW = 28 + KEPT;                     // a traced pixel
    `RT_CHECK(WALKS == 1 || WALKS == 2, rt_walks_WALKS_must_be_1_or_2)

    // ---- where the right half begins; of an empty window both are empty ----
    wire [13:0] x0 = window_i[13:0], x1 = window_i[41:28];
    wire [14:0] twice  = {1'b0, x0} + {1'b0, x1} + 15'd1;
    wire [13:0] middle = twice[14:1];

    wire [WALKS-1:0]    busy, q_valid, q_take, bg_valid, bg_take, bad, bus;
    wire [QW*WALKS-1:0] q_all;
    wire [28*WALKS-1:0] place;
    genvar i;
    generate
        for (i = 0; i < WALKS; i = i + 1) begin : g_walk
            wire [55:0]     window = {window_i[55:42], i == WALKS - 1 ? x1 : middle,
                                      window_i[27:14], i == 0 ? x0 : middle};
            wire [3*WD-1:0] dir;
            wire            valid, ready;
            rt_pixel_scan #(.W(W), .WD(WD), .RECT(RECT), .SPANS(SPANS), .CONES(CONES),
                      .TURNED(TURNED)) u_walk (
                .clk(clk), .rst(rst), .start_i(start_i), .busy_o(busy[i]), .window_i(window),
                .dir_x0_i($signed(dir_i[`RT_VEC_X])), .dir_y0_i($signed(dir_i[`RT_VEC_Y])),
                .dir_z_i($signed(dir_i[`RT_VEC_Z])), .pitch_i(pitch_i),
                .first_i(first_i), .across_i(across_i), .down_i(down_i),
                .bg_mode_i(bg_mode_i), .rect_i(rect_i), .bg_base_i(bg_base_i),
                .bg_count_i(bg_count_i), .mem_lines_i(mem_lines_i),
                .ray_valid_o(valid), .ray_ready_i(ready),
                .ray_dir_x_o(dir[`RT_VEC_X]), .ray_dir_y_o(dir[`RT_VEC_Y]),
                .ray_dir_z_o(dir[`RT_VEC_Z]),
                .bg_valid_o(bg_valid[i]), .bg_ready_i(bg_ready_i && bg_take[i]),
                .x_o(place[28*i +: 14]), .y_o(place[28*i + 14 +: 14]),
                .mem_req_valid_o(mem_req_valid_o[i]), .mem_req_ready_i(mem_req_ready_i[i]),
                .mem_req_line_o(mem_req_line_o[LB*i +: LB]),
                .mem_rsp_valid_i(mem_rsp_valid_i[i]), .mem_rsp_ready_o(mem_rsp_ready_o[i]),
                .mem_rsp_data_i(mem_rsp_data_i), .mem_rsp_error_i(mem_rsp_error_i),
                .bad_table_o(bad[i]), .bus_error_o(bus[i])
            );
            // Keeps the engines fed while the walk crosses background.
            rt_fifo #(.WIDTH(QW), .DEPTH(16)) u_traced (
                .clk(clk), .rst(rst), .in_valid_i(valid && ready), .in_ready_o(ready),
                .in_data_i({dir[KEPT-1:0], place[28*i +: 28]}),
                .out_valid_o(q_valid[i]), .out_ready_i(ray_ready_i && q_take[i]),
                .out_data_o(q_all[QW*i +: QW])
            );
            wire unused = &{1'b0, dir};
        end
        if (WALKS > 1) begin : g_turns
            wire q_one, bg_one;
            rt_rr_arbiter #(.N(WALKS)) u_ray (
                .clk(clk), .rst(rst), .asks_i(q_valid), .served_i(ray_valid_o && ray_ready_i),
                .turn_o(q_take), .index_o(q_one)
            );
            rt_rr_arbiter #(.N(WALKS)) u_background (
                .clk(clk), .rst(rst), .asks_i(bg_valid), .served_i(bg_valid_o && bg_ready_i),
                .turn_o(bg_take), .index_o(bg_one)
            );
            assign ray_o[28+KEPT-1:0] = q_all[QW*q_one +: QW];
            assign bg_place_o         = place[28*bg_one +: 28];
        end else begin : g_one
            assign {q_take, bg_take}  = 2'b11;
            assign ray_o[28+KEPT-1:0] = q_all;
            assign bg_place_o         = place;
            wire unused = &{1'b0, middle};
        end
        if (TURNED == 0) begin : g_same_z
            assign ray_o[28+3*WD-1 -: WD] = dir_i[`RT_VEC_Z];
        end
    endgenerate
    assign busy_o      = |busy || |q_valid;
    assign ray_valid_o = |q_valid;
    assign bg_valid_o  = |bg_valid;
    assign bad_table_o = |bad;
    assign bus_error_o = |bus;
    wire unused = &{1'b0, twice[0]};
endmodule
`default_nettype wire
