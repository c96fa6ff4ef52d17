// rt_texel.v - the texels that surround a texture coordinate, and their addresses
// SPDX-License-Identifier: Apache-2.0
// One level after the other, four texels each (or the nearest one alone); tiles of 4 x 2 texels, a
// line each, row by row. One multiplier:
//   at * size, s and t | texels, weights | row of tiles, y0 and y1 | four requests
// One hit at a time: 8 clocks a level and one for each request that waits, and one.
// Model: sph_axis_at() in cmodel/texture/texel.c, sph_texel_word() in
// cmodel/texture/texel.h
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_texel #(
    parameter TAG = 6                     // what travels along, bits
) (
    input  wire           clk,
    input  wire           rst,            // synchronous, active high
    input  wire           in_valid_i,
    output wire           in_ready_o,
    input  wire [TAG-1:0] in_tag_i,
    input  wire [39:0]    in_s_i,         // s19.20
    input  wire [39:0]    in_t_i,
    input  wire [1:0]     in_clamp_i,     // {t, s}: 0 repeats, 1 stays at the edge
    input  wire           in_nearest_i,   // one texel
    input  wire           in_both_i,      // the next level too
    input  wire [11:0]    in_w_i,         // texels of level 0 across, less one
    input  wire [11:0]    in_h_i,
    input  wire [3:0]     in_level_i,
    input  wire [`RT_LINE_BITS:0] in_line_i,      // first line of the level
    input  wire [`RT_LINE_BITS:0] in_next_i,      // of the next one
    // requests
    output wire           req_valid_o,
    input  wire           req_ready_i,
    output wire [TAG-1:0] req_tag_o,
    output wire [2:0]     req_index_o,    // texel of the hit: 0..3, of the next level 4..7
    output wire [`RT_LINE_BITS:0] req_line_o,
    output wire [2:0]     req_word_o,     // of the line
    // with the last request
    output wire           last_o,
    output wire [31:0]    weights_o       // {t, s of the next level, t, s of the level} u0.8
);
    // ---- the hit at hand ----
    reg              busy_q, nearest_q, both_q, second_q;
    reg [TAG-1:0]    tag_q;
    reg [39:0]       s_q, t_q;
    reg [1:0]        clamp_q;
    reg [3:0]        step_q;
    reg [11:0]       w_q, h_q;            // size of the level, less one
    reg [`RT_LINE_BITS:0] line_q, next_q;
    wire             take = in_valid_i && in_ready_o;
    wire             send = req_valid_o && req_ready_i;
    wire             level_end = send && (nearest_q || step_q == 4'd8);
    wire             more = both_q && !second_q;
    assign in_ready_o = !busy_q;
    // (size >> level, at least 1) - 1
    wire [12:0]      in_w = ({1'b0, in_w_i} + 13'd1) >> in_level_i;
    wire [12:0]      in_h = ({1'b0, in_h_i} + 13'd1) >> in_level_i;
    wire [12:0]      half_w = ({1'b0, w_q} + 13'd1) >> 1;
    wire [12:0]      half_h = ({1'b0, h_q} + 13'd1) >> 1;
    wire [12:0]      size_w = take ? in_w : half_w;
    wire [12:0]      size_h = take ? in_h : half_h;
    wire [12:0]      last_w = size_w - {12'd0, |size_w};
    wire [12:0]      last_h = size_h - {12'd0, |size_h};
    always @(posedge clk) begin
        if (take) begin
            {tag_q, s_q, t_q, clamp_q} <= {in_tag_i, in_s_i, in_t_i, in_clamp_i};
            {nearest_q, both_q} <= {in_nearest_i, in_both_i};
            next_q <= in_next_i;
        end
        if (take || (level_end && more)) begin
            w_q      <= last_w[11:0];
            h_q      <= last_h[11:0];
            line_q   <= take ? in_line_i : next_q;
            second_q <= !take;
            step_q   <= 4'd0;
        end else if (busy_q && (!req_valid_o || req_ready_i)) begin
            step_q   <= step_q + 4'd1;
        end
        if (take) busy_q <= 1'b1;
        else if (level_end && !more) busy_q <= 1'b0;
        if (rst) busy_q <= 1'b0;
    end

    // ---- a coordinate: limited if it is clamped, its fraction times the size ----
    wire             t_turn  = step_q == 4'd1;           // the operands of t enter
    wire [39:0]      at      = t_turn ? t_q : s_q;
    wire             clamp   = clamp_q[t_turn];
    wire [19:0]      bounded = !clamp ? at[19:0] : at[39] ? 20'd0 : |at[38:20] ? 20'hfffff
                               : at[19:0];
    // ---- and the row of tiles of a texel: y / 2 * tiles ----
    wire [10:0]      tiles   = {1'b0, w_q[11:2]} + 11'd1;         // (w + 3) / 4
    reg  [11:0]      y0_q, y1_q, x0_q, x1_q;
    wire             row_turn = step_q >= 4'd3;          // y1 as long as the first request waits
    wire [10:0]      pair    = step_q == 4'd3 ? y0_q[11:1] : y1_q[11:1];
    wire [19:0]      a       = row_turn ? {9'd0, pair} : bounded;
    wire [12:0]      b       = row_turn ? {2'd0, tiles} : {1'b0, t_turn ? h_q : w_q} + 13'd1;
    reg  [32:0]      prod_q;                             // one clock after its operands
    always @(posedge clk) prod_q <= a * b;

    // ---- texels and weight of an axis ----
    wire             t_done  = step_q == 4'd2;           // the product of t is there
    wire [20:0]      place   = prod_q[32:12];            // u13.8
    wire [20:0]      middle  = place + 21'd128;
    wire [12:0]      high    = middle[20:8];             // the second texel, not yet wrapped
    wire [11:0]      last    = t_done ? h_q : w_q;
    wire             stay   = clamp_q[t_done];
    wire [12:0]      low     = high - 13'd1;
    wire [11:0]      first   = |high ? low[11:0] : stay ? 12'd0 : last;
    wire [11:0]      second  = high <= {1'b0, last} ? high[11:0] : stay ? last : 12'd0;
    reg  [31:0]      weights_q;
    wire [7:0]       weight  = nearest_q ? 8'd0 : middle[7:0];
    reg  [21:0]      row0_q, row1_q;                     // y / 2 * tiles
    always @(posedge clk) begin
        case (step_q)
            4'd1: begin
                x0_q <= nearest_q ? place[19:8] : first;
                x1_q <= second;
                if (second_q) weights_q[23:16] <= weight; else weights_q[7:0] <= weight;
            end
            4'd2: begin
                y0_q <= nearest_q ? place[19:8] : first;
                y1_q <= second;
                if (second_q) weights_q[31:24] <= weight; else weights_q[15:8] <= weight;
            end
            4'd4: row0_q <= prod_q[21:0];
            4'd5: row1_q <= prod_q[21:0];                // the first request is sent or waits
            default: ;
        endcase
        if (take) weights_q <= 32'd0;
    end

    // ---- requests: (x0, y0), (x1, y0), (x0, y1), (x1, y1) ----
    wire [1:0]       corner = step_q[1:0] - 2'd1;        // steps 5 to 8
    wire [11:0]      x      = corner[0] ? x1_q : x0_q;
    wire             odd    = corner[1] ? y1_q[0] : y0_q[0];
    wire [21:0]      row    = corner[1] ? row1_q : row0_q;
    assign req_valid_o = busy_q && step_q >= 4'd5;
    assign req_tag_o   = tag_q;
    assign req_index_o = {second_q, corner};
    assign req_line_o  = line_q + {{(`RT_LINE_BITS-21){1'b0}}, row} +
                         {{(`RT_LINE_BITS-9){1'b0}}, x[11:2]};
    assign req_word_o  = {odd, x[1:0]};
    assign last_o      = level_end && !more;
    assign weights_o   = weights_q;
    wire unused = &{1'b0, last_w[12], last_h[12], place[20], low[12], prod_q};
endmodule
`default_nettype wire
