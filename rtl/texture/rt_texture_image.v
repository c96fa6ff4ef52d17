// rt_texture_image.v - image header in, requests for texels out
// SPDX-License-Identifier: Apache-2.0
//   header, level | limited to the chain | first lines of the two levels | queue | rt_texel
// Keeps the word of each pixel: level of its first texture, sum of the addresses of its texels.
// Model: the second half of sph_lookup() in cmodel/texture/lookup.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_texture_image #(
    parameter SLOTS = 32,      // power of two
    parameter COARSE = 0       // bits of the level's fraction that are rounded away, 0 to 8
) (
    input  wire              clk,
    input  wire              rst,
    input  wire [1:0]        filter_i,       // TEX_FILTER
    // a header; void_i, lod_i and line_i a cycle later
    input  wire              image_valid_i,
    input  wire [$clog2(SLOTS)-1:0] image_slot_i,
    input  wire [255:0]      image_i,
    input  wire              void_i,         // it does not lie in memory
    input  wire [11:0]       lod_i,          // u4.8, of the longest chain
    input  wire [`RT_LINE_BITS-1:0] line_i,         // of the header
    output wire              none_o,         // a cycle later too: no texels; the surface is done
    // coordinates, one cycle after the slot
    output wire              st_read_o,
    output wire [$clog2(SLOTS)-1:0] st_slot_o,
    input  wire [81:0]       st_i,           // {clamp t s, t, s}
    // requests
    output wire              texel_valid_o,
    input  wire              texel_ready_i,
    output wire [$clog2(SLOTS)-1:0] texel_slot_o,
    output wire [2:0]        texel_index_o,
    output wire [`RT_LINE_BITS:0] texel_line_o,
    output wire [2:0]        texel_word_o,   // of the line
    // how to mix them: whether both levels, at the first request; weights at the last
    output wire              both_valid_o,
    output wire              both_o,
    output wire              mix_valid_o,
    output wire [$clog2(SLOTS)-1:0] mix_slot_o,
    output wire [39:0]       mix_o,          // {weight of the next level, t s t s} u0.8
    // the word of a pixel: forgotten when it begins, read a cycle after its slot
    input  wire              fresh_valid_i,
    input  wire [$clog2(SLOTS)-1:0] fresh_slot_i,
    input  wire              word_read_i,
    input  wire [$clog2(SLOTS)-1:0] word_slot_i,
    output wire [31:0]       word_o          // {lod u4.8, sum modulo 2^20}
);
    localparam SLOTW = $clog2(SLOTS);
    localparam [1:0] NEAREST = 2'd0, LEVEL = 2'd2, BETWEEN = 2'd3;

    // ---- header, with the level that was asked for ----
    reg              r_valid_q;
    reg [SLOTW-1:0]  r_slot_q;
    reg [247:0]      r_image_q;
    wire [3:0]       levels = r_image_q[`RT_IMAGE_LEVELS_LSB +: 4];
    wire             r_none = void_i || levels == 4'd0 || levels > `RT_TEXTURE_LEVELS;
    wire [11:0]      most   = {levels - 4'd1, 8'd0};
    wire             coarsest = lod_i > most;
    wire [11:0]      half   = 12'd1 << COARSE >> 1;
    wire [11:0]      fine   = (lod_i + half) >> COARSE << COARSE;  // at most most, if lod_i is
    wire [11:0]      lod    = coarsest ? most : fine;
    wire [3:0]       near   = coarsest ? most[11:8] : fine[11:8] + {3'd0, fine[7]};
    assign none_o = r_valid_q && r_none;
    always @(posedge clk) begin
        r_valid_q <= image_valid_i;
        r_slot_q  <= image_slot_i;
        r_image_q <= image_i[247:0];
        if (rst) r_valid_q <= 1'b0;
    end

    // ---- first lines of the level and of the next one ----
    reg              l_valid_q;
    reg [SLOTW-1:0]  l_slot_q;
    reg [247:0]      l_image_q;
    reg [11:0]       l_lod_q;
    reg [3:0]        l_level_q;
    reg [7:0]        l_far_q;                // weight of the next level
    reg [`RT_LINE_BITS:0] l_line_q;          // of level 0
    reg [19:0]       at, at_next;
    integer i;
    always @* begin
        at      = 20'd0;
        at_next = 20'd0;
        for (i = 1; i < `RT_TEXTURE_LEVELS; i = i + 1) begin
            if (l_level_q == i[3:0])            at      = l_image_q[8 + 20*i +: 20];
            if (l_level_q + 4'd1 == i[3:0])     at_next = l_image_q[8 + 20*i +: 20];
        end
    end
    always @(posedge clk) begin
        l_valid_q <= r_valid_q && !r_none;
        l_slot_q  <= r_slot_q;
        l_image_q <= r_image_q;
        l_lod_q   <= lod;
        l_level_q <= filter_i == LEVEL ? near : filter_i == BETWEEN ? lod[11:8] : 4'd0;
        l_far_q   <= filter_i == BETWEEN ? lod[7:0] : 8'd0;
        l_line_q  <= {1'b0, line_i} + 1'b1;
        if (rst) l_valid_q <= 1'b0;
    end
    localparam JW = 2*12 + 4 + 8 + 12 + 2*(`RT_LINE_BITS + 1);
    wire             j_valid, j_in, j_take, t_ready;
    wire [SLOTW-1:0] j_slot;
    wire [11:0]      j_w, j_h, j_lod;
    wire [3:0]       j_level;
    wire [7:0]       j_far;
    wire [`RT_LINE_BITS:0] j_line, j_next;
    reg              j_read_q;               // what belongs to the head is read
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_jobs (
        .clk(clk), .rst(rst), .in_valid_i(l_valid_q), .in_ready_o(j_in), .in_data_i(l_slot_q),
        .out_valid_o(j_valid), .out_ready_i(j_take), .out_data_o(j_slot)
    );
    rt_slot_ram #(.WIDTH(JW), .SLOTS(SLOTS), .OLD(0)) u_job (
        .clk(clk), .wr_en_i(l_valid_q), .wr_addr_i(l_slot_q),
        .wr_data_i({l_image_q[`RT_IMAGE_W_LSB +: 12], l_image_q[`RT_IMAGE_H_LSB +: 12],
                    l_level_q, l_far_q, l_lod_q, l_line_q + {7'd0, at},
                    l_line_q + {7'd0, at_next}}),
        .rd_en_i(j_valid), .rd_addr_i(j_slot),
        .rd_data_o({j_w, j_h, j_level, j_far, j_lod, j_line, j_next})
    );
    assign st_read_o = j_valid;
    assign st_slot_o = j_slot;
    assign j_take    = j_read_q && t_ready;
    always @(posedge clk) begin
        j_read_q <= j_valid && !j_take;
        if (rst) j_read_q <= 1'b0;
    end

    // ---- texels ----
    wire [7:0]       t_far;
    wire [11:0]      t_lod;
    wire             t_last, t_begins;
    wire [SLOTW+19:0] t_tag;
    wire [31:0]      t_weights;
    rt_texel #(.TAG(SLOTW + 20)) u_texel (
        .clk(clk), .rst(rst), .in_valid_i(j_read_q), .in_ready_o(t_ready),
        .in_tag_i({j_slot, j_far, j_lod}), .in_s_i(st_i[39:0]), .in_t_i(st_i[79:40]),
        .in_clamp_i(st_i[81:80]), .in_nearest_i(filter_i == NEAREST),
        .in_both_i(j_far != 8'd0), .in_w_i(j_w), .in_h_i(j_h), .in_level_i(j_level),
        .in_line_i(j_line), .in_next_i(j_next),
        .ready_o(t_begins), .ready_tag_o(t_tag),
        .req_valid_o(texel_valid_o), .req_ready_i(texel_ready_i),
        .req_tag_o({texel_slot_o, t_far, t_lod}), .req_index_o(texel_index_o),
        .req_line_o(texel_line_o), .req_word_o(texel_word_o),
        .last_o(t_last), .weights_o(t_weights)
    );
    assign both_valid_o = texel_valid_o && texel_index_o == 3'd0;
    assign both_o       = t_far != 8'd0;

    // ---- the word: read before the first request of a level ----
    reg [SLOTS-1:0]  known_q;                // the pixel has one
    reg              fresh_q;
    reg [SLOTW-1:0]  fresh_slot_q;
    reg [19:0]       sum_q;                  // of the job so far
    reg [11:0]       lod_q;
    reg              old_known_q, word_known_q;
    wire [31:0]      old, word;
    wire             send = texel_valid_o && texel_ready_i;
    // ---- and written, as the weights are, a clock behind the last one ----
    reg              last_q;
    reg [SLOTW-1:0]  last_slot_q;
    reg [39:0]       mix_q;
    assign mix_valid_o  = last_q;
    assign mix_slot_o   = last_slot_q;
    assign mix_o        = mix_q;
    rt_slot_ram #(.WIDTH(32), .SLOTS(SLOTS), .OLD(0)) u_old (
        .clk(clk), .wr_en_i(last_q), .wr_addr_i(last_slot_q), .wr_data_i({lod_q, sum_q}),
        .rd_en_i(t_begins), .rd_addr_i(t_tag[SLOTW+19:20]), .rd_data_o(old)
    );
    rt_slot_ram #(.WIDTH(32), .SLOTS(SLOTS), .OLD(0)) u_word (
        .clk(clk), .wr_en_i(last_q), .wr_addr_i(last_slot_q), .wr_data_i({lod_q, sum_q}),
        .rd_en_i(word_read_i), .rd_addr_i(word_slot_i), .rd_data_o(word)
    );
    always @(posedge clk) begin
        if (t_begins) old_known_q <= known_q[t_tag[SLOTW+19:20]];
        if (send) begin
            sum_q <= (texel_index_o != 3'd0 ? sum_q : old_known_q ? old[19:0] : 20'd0) +
                     {texel_line_o[16:0], texel_word_o};
            lod_q <= old_known_q ? old[31:20] : t_lod;
        end
        last_q      <= t_last;
        last_slot_q <= texel_slot_o;
        mix_q       <= {t_far, t_weights};
        fresh_q      <= fresh_valid_i;
        fresh_slot_q <= fresh_slot_i;
        if (fresh_q) known_q[fresh_slot_q] <= 1'b0;
        if (last_q) known_q[last_slot_q] <= 1'b1;
        if (word_read_i) word_known_q <= known_q[word_slot_i];
        if (rst) {last_q, fresh_q} <= 2'd0;
    end
    assign word_o = word_known_q ? word : {12'd`RT_LOD_NONE, 20'd0};
    wire unused = &{1'b0, j_in, image_i[255:248], l_image_q, r_image_q,
                    t_tag[19:0]};
endmodule
`default_nettype wire
