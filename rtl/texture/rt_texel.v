// rt_texel.v - the texels that surround a texture coordinate, and their addresses
// SPDX-License-Identifier: Apache-2.0
// One level after the other, four texels each (or the nearest one alone); tiles of 4 x 2 texels, a
// line each, row by row. One multiplier:
//   at * size, t and s | texels, weights | row of tiles, y0 and y1 | four requests
// The product of a coordinate takes two clocks, its lower and its upper factor apart; that of a row
// takes one.
// A level is made ready in 6 clocks while the requests of the one before are sent, so that a hit
// takes 6 clocks a level, and one.
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
    // a level is ready: a clock before its first request
    output wire           ready_o,
    output wire [TAG-1:0] ready_tag_o,
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
    localparam [2:0] READY = 3'd5;
    // ---- the hit that is made ready ----
    reg              busy_q, nearest_q, both_q, second_q;
    reg [TAG-1:0]    tag_q;
    reg [19:0]       s_q, t_q;            // fractions, limited if they are clamped
    reg [1:0]        clamp_q;
    reg [2:0]        step_q;              // stays at the last one until requests are free
    reg [12:0]       size_w_q, size_h_q;  // of the level
    reg [11:0]       w_q, h_q;            // the same, less one, a clock later
    reg [10:0]       tiles_q;             // of a row: (w + 3) / 4, a clock behind w_q
    reg [`RT_LINE_BITS:0] line_q, next_q;
    wire             take = in_valid_i && in_ready_o;
    wire             free;                // no request is left after this clock
    wire             ready = busy_q && step_q == READY && free;
    wire             more = both_q && !second_q;
    assign in_ready_o = !busy_q;
    // size >> level
    wire [12:0]      in_w = ({1'b0, in_w_i} + 13'd1) >> in_level_i;
    wire [12:0]      in_h = ({1'b0, in_h_i} + 13'd1) >> in_level_i;
    wire [12:0]      size_w = take ? in_w : size_w_q >> 1;
    wire [12:0]      size_h = take ? in_h : size_h_q >> 1;
    function [19:0] kept;                 // of a coordinate
        input        stays;
        input [39:0] at;
        kept = !stays ? at[19:0] : at[39] ? 20'd0 : |at[38:20] ? 20'hfffff : at[19:0];
    endfunction
    always @(posedge clk) begin
        if (take) begin
            {tag_q, clamp_q} <= {in_tag_i, in_clamp_i};
            s_q <= kept(in_clamp_i[0], in_s_i);
            t_q <= kept(in_clamp_i[1], in_t_i);
            {nearest_q, both_q} <= {in_nearest_i, in_both_i};
            next_q <= in_next_i;
        end
        if (take || (ready && more)) begin
            size_w_q <= size_w | {12'd0, ~|size_w};
            size_h_q <= size_h | {12'd0, ~|size_h};
            line_q   <= take ? in_line_i : next_q;
            second_q <= !take;
            step_q   <= 3'd0;
        end else if (step_q != READY) begin
            step_q   <= step_q + 3'd1;
        end
        w_q <= size_w_q[11:0] - 12'd1;
        h_q <= size_h_q[11:0] - 12'd1;
        tiles_q <= {1'b0, w_q[11:2]} + 11'd1;
        if (take) busy_q <= 1'b1;
        else if (ready && !more) busy_q <= 1'b0;
        if (rst) busy_q <= 1'b0;
    end

    // ---- the fraction of a coordinate times the size ----
    wire             t_turn  = step_q == 3'd0;           // the operands of t enter, then those of s
    // ---- and the row of tiles of a texel: y / 2 * tiles ----
    reg  [11:0]      y0_q, y1_q, x0_q, x1_q;
    wire             row_turn = step_q >= 3'd3;          // y1 until the level leaves
    wire [10:0]      pair    = step_q == 3'd3 ? y0_q[11:1] : y1_q[11:1];
    wire [19:0]      a       = row_turn ? {9'd0, pair} : t_turn ? t_q : s_q;
    wire [12:0]      b       = row_turn ? {2'd0, tiles_q} : t_turn ? size_h_q : size_w_q;
    reg  [29:0]      low_q;                              // one clock after its operands
    reg  [15:0]      up_q;
    reg  [32:0]      prod_q;                             // two clocks after them
    always @(posedge clk) begin
        low_q  <= a[16:0] * b;
        up_q   <= a[19:17] * b;
        prod_q <= {3'd0, low_q} + {up_q, 17'd0};
    end

    // ---- texels and weight of an axis ----
    wire             t_done  = step_q == 3'd2;           // the product of t is there
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
    reg  [21:0]      row0_q;                             // y / 2 * tiles; that of y1 is low_q
    always @(posedge clk) begin
        case (step_q)
            3'd3: begin
                x0_q <= nearest_q ? place[19:8] : first;
                x1_q <= second;
                if (second_q) weights_q[23:16] <= weight; else weights_q[7:0] <= weight;
            end
            3'd2: begin
                y0_q <= nearest_q ? place[19:8] : first;
                y1_q <= second;
                if (second_q) weights_q[31:24] <= weight; else weights_q[15:8] <= weight;
            end
            3'd4: row0_q <= low_q[21:0];
            default: ;
        endcase
        if (take) weights_q <= 32'd0;
    end

    // ---- requests: (x0, y0), (x1, y0), (x0, y1), (x1, y1) ----
    reg              r_valid_q, r_nearest_q, r_second_q, r_more_q;
    reg  [1:0]       corner_q;
    reg  [TAG-1:0]   r_tag_q;
    reg  [11:0]      r_x0_q, r_x1_q;
    reg              r_odd0_q, r_odd1_q;
    reg  [21:0]      r_row0_q, r_row1_q;
    reg  [`RT_LINE_BITS:0] r_line_q;
    reg  [31:0]      r_weights_q;
    wire             level_end = r_valid_q && req_ready_i && (r_nearest_q || &corner_q);
    wire [11:0]      x   = corner_q[0] ? r_x1_q : r_x0_q;
    wire             odd = corner_q[1] ? r_odd1_q : r_odd0_q;
    wire [21:0]      row = corner_q[1] ? r_row1_q : r_row0_q;
    assign free = !r_valid_q || level_end;
    always @(posedge clk) begin
        if (ready) begin
            {r_tag_q, r_nearest_q, r_second_q, r_more_q} <= {tag_q, nearest_q, second_q, more};
            {r_x0_q, r_x1_q, r_odd0_q, r_odd1_q} <= {x0_q, x1_q, y0_q[0], y1_q[0]};
            {r_row0_q, r_row1_q, r_line_q} <= {row0_q, low_q[21:0], line_q};
            r_weights_q <= weights_q;
            corner_q <= 2'd0;
        end else if (r_valid_q && req_ready_i) begin
            corner_q <= corner_q + 2'd1;
        end
        if (ready) r_valid_q <= 1'b1;
        else if (level_end) r_valid_q <= 1'b0;
        if (rst) r_valid_q <= 1'b0;
    end
    assign ready_o     = ready;
    assign ready_tag_o = tag_q;
    assign req_valid_o = r_valid_q;
    assign req_tag_o   = r_tag_q;
    assign req_index_o = {r_second_q, corner_q};
    assign req_line_o  = r_line_q + {{(`RT_LINE_BITS-21){1'b0}}, row} +
                         {{(`RT_LINE_BITS-9){1'b0}}, x[11:2]};
    assign req_word_o  = {odd, x[1:0]};
    assign last_o      = level_end && !r_more_q;
    assign weights_o   = r_weights_q;
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_levels_to_texels /* verilator public_flat_rd */ =
        {in_valid_i && !in_ready_o, take, 5'd0,
         take || (busy_q && !(step_q == READY && !free))};
    wire unused = &{1'b0, place[20], low[12], prod_q};
endmodule
`default_nettype wire
