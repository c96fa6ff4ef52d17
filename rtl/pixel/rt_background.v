// rt_background.v - whether the pixel of the walk is traced, by a table in memory
// SPDX-License-Identifier: Apache-2.0
//   rt_table --> memory --+--> rt_spans: span of the row ------ BG_MODE --> traced
//    spans once a column  '--> rt_cone x CONES, move along -------'
//    cones once
// Nothing moves before the cones are loaded; a pixel waits for the span of its row. A table that
// does not lie in memory: BAD_NODE, and every pixel is traced.
// Model: sph_is_background() in cmodel/pixel/background.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_background #(
    parameter W     = 16,  // coordinate, bits
    parameter WD    = 17,  // direction component, bits
    parameter SPANS = 1,   // by spans, 0 or 1
    parameter CONES = 1    // exactly, by up to so many spheres, 0..16
) (
    input  wire         clk,
    input  wire         rst,
    input  wire         start_i,       // a new window
    // registers
    input  wire [55:0]  window_i,      // {y1, x1, y0, x0}
    input  wire [1:0]   mode_i,        // 2 spans, 3 cones
    input  wire [`RT_LINE_BITS-1:0] base_i,        // first line of the table
    input  wire [4:0]   count_i,       // cones, 0..CONES
    input  wire [`RT_LINE_BITS-1:0] mem_lines_i,   // lines of memory
    // from the walk
    input  wire [13:0]  x_i,           // pixel
    input  wire         row_next_i,    // the row is done, within its column
    input  wire         fetch_i,       // moves of the cones
    input  wire         enter_i,
    input  wire         right_i,
    input  wire         save_i,
    // to the walk
    output wire         ready_o,       // moves may begin
    output wire         valid_o,       // what decides on the pixel is there
    output wire         traced_o,      // it is traced
    // memory
    output wire         req_valid_o,
    input  wire         req_ready_i,
    output wire [`RT_LINE_BITS-1:0] req_line_o,
    input  wire         rsp_valid_i,
    output wire         rsp_ready_o,
    input  wire [255:0] rsp_data_i,
    input  wire         rsp_error_i,
    // errors
    output wire         bad_table_o,
    output wire         bus_error_o
);
    wire [13:0] x0 = window_i[13:0],  y0 = window_i[27:14];
    wire [13:0] x1 = window_i[41:28], y1 = window_i[55:42];
    wire by_spans = SPANS != 0 && mode_i == 2'd2;
    wire by_cones = CONES != 0 && mode_i == 2'd3;

    // ---- does the table lie in memory ----
    wire [14:0] y_up  = {1'b0, y1} + 15'd7;
    wire [11:0] lines = by_spans ? y_up[14:3] : {5'd0, count_i, 2'd0};
    localparam LB = `RT_LINE_BITS;
    wire [LB:0] past  = {1'b0, base_i} + {{(LB-11){1'b0}}, lines};
    reg         bad_q, start_q;                    // start_q: one cycle after start_i
    always @(posedge clk) begin
        if (start_i) bad_q <= (by_spans || by_cones) && past > {1'b0, mem_lines_i};
        start_q <= start_i;
        if (rst) start_q <= 1'b0;
    end
    wire spans_on      = by_spans && !bad_q;
    wire cones_on      = by_cones && !bad_q;
    assign bad_table_o = start_q && bad_q;
    assign bus_error_o = rsp_valid_i && rsp_ready_o && rsp_error_i;

    // ---- lines: of the window's rows once a column of 8 pixels, or of the cones once ----
    wire [14:0] x_up = {1'b0, x1} + 15'd7 - {1'b0, x0};
    wire        some = x0 < x1 && y0 < y1;         // else the walk takes no span
    wire        room, asked;
    rt_table u_table (
        .clk(clk), .rst(rst), .start_i(start_q && (cones_on || (spans_on && some))),
        .first_i(base_i + (by_spans ? {{(LB-11){1'b0}}, y0[13:3]} : {LB{1'b0}})),
        .lines_i(lines - (by_spans ? {1'b0, y0[13:3]} : 12'd0)),
        .passes_i(by_spans ? x_up[14:3] : 12'd1), .room_i(room || !by_spans), .asked_o(asked),
        .req_valid_o(req_valid_o), .req_ready_i(req_ready_i), .req_line_o(req_line_o)
    );

    // ---- spans ----
    wire span_valid, span_ready, in_span;
    generate
        if (SPANS != 0) begin : g_spans
            wire [15:0] span_x0, span_x1;
            rt_spans u_spans (
                .clk(clk), .rst(rst), .start_i(start_q), .win_y0_i(y0), .win_y1_i(y1),
                .room_o(room), .asked_i(asked && by_spans),
                .rsp_valid_i(rsp_valid_i && by_spans), .rsp_ready_o(span_ready),
                .rsp_data_i(rsp_data_i),
                .span_valid_o(span_valid), .span_next_i(row_next_i && spans_on),
                .span_x0_o(span_x0), .span_x1_o(span_x1)
            );
            assign in_span = {2'd0, x_i} >= span_x0 && {2'd0, x_i} < span_x1;
        end else begin : g_no_spans
            assign {room, span_valid, span_ready, in_span} = 4'd0;
            wire unused = &{1'b0, asked, row_next_i, x_i};
        end
    endgenerate

    // ---- cones ----
    wire loaded, hit;
    generate
        if (CONES != 0) begin : g_cones
            reg  [6:0]       line_q;               // of the records; the next one to come
            wire [CONES-1:0] hits;
            assign loaded = line_q == {count_i, 2'd0};
            assign hit    = |hits;
            always @(posedge clk)
                if (start_i) line_q <= 7'd0;
                else if (rsp_valid_i && by_cones) line_q <= line_q + 7'd1;
            genvar c;
            for (c = 0; c < CONES; c = c + 1) begin : g_cone
                wire       load = rsp_valid_i && by_cones && line_q[6:2] == c;
                wire       one;
                rt_cone #(.W(W), .WD(WD)) u_cone (
                    .clk(clk), .load_i({3'd0, load} << line_q[1:0]), .line_i(rsp_data_i),
                    .fetch_i(fetch_i), .enter_i(enter_i), .right_i(right_i), .save_i(save_i),
                    .hit_o(one)
                );
                assign hits[c] = one && c < count_i;
            end
        end else begin : g_no_cones
            assign {loaded, hit} = 2'd0;
            wire unused = &{1'b0, count_i, fetch_i, enter_i, right_i, save_i};
        end
    endgenerate

    assign rsp_ready_o = !by_spans || span_ready;
    assign ready_o     = !cones_on || loaded;
    assign valid_o     = !spans_on || span_valid;
    assign traced_o    = spans_on ? in_span : !cones_on || hit;
    wire unused = &{1'b0, x_up[2:0], y_up[2:0]};
endmodule
`default_nettype wire
