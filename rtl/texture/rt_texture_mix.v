// rt_texture_mix.v - texels in, filtered and multiplied colour of a surface out
// SPDX-License-Identifier: Apache-2.0
// Texels come in any order; when a surface has all of its own, they are filtered.
// Model: filtered() in cmodel/texture/lookup.c, sph_texture_albedo() in cmodel/texture/texel.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_texture_mix #(
    parameter SLOTS = 32  // power of two
) (
    input  wire              clk,
    input  wire              rst,
    input  wire              nearest_i,      // register: one texel a surface
    // colour of the surface itself
    input  wire              albedo_valid_i,
    input  wire [$clog2(SLOTS)-1:0] albedo_slot_i,
    input  wire [`RT_RGB_BITS-1:0] albedo_i,       // 0xBBGGRR
    // how to mix, with the first request of a surface and with its last
    input  wire              both_valid_i,
    input  wire [$clog2(SLOTS)-1:0] both_slot_i,
    input  wire              both_i,
    input  wire              mix_valid_i,
    input  wire [$clog2(SLOTS)-1:0] mix_slot_i,
    input  wire [39:0]       mix_i,          // {weight of the next level, t s t s} u0.8
    // a texel
    input  wire              texel_valid_i,
    input  wire [$clog2(SLOTS)-1:0] texel_slot_i,
    input  wire [2:0]        texel_index_i,
    input  wire [`RT_RGB_BITS-1:0] texel_i,        // 0xBBGGRR
    // the surface
    output wire              out_valid_o,    // one clock
    output wire [$clog2(SLOTS)-1:0] out_slot_o,
    output wire [`RT_RGB_BITS-1:0] out_colour_o
);
    localparam SLOTW = $clog2(SLOTS);
    // ---- texels that came, by slot; a count begins and ends at 0 ----
    reg  [SLOTW:0]   clear_q;                // after reset: counts still to clear
    wire             clearing = !clear_q[SLOTW];
    wire             both;
    wire [2:0]       seen;
    wire [2:0]       last = nearest_i ? 3'd0 : both ? 3'd7 : 3'd3;
    wire             all  = texel_valid_i && seen == last;
    rt_slot_file #(.WIDTH(1), .SLOTS(SLOTS)) u_both (
        .clk(clk), .wr_en_i(both_valid_i), .wr_addr_i(both_slot_i), .wr_data_i(both_i),
        .rd_addr_i(texel_slot_i), .rd_data_o(both)
    );
    rt_slot_file #(.WIDTH(3), .SLOTS(SLOTS)) u_seen (
        .clk(clk), .wr_en_i(texel_valid_i || clearing),
        .wr_addr_i(clearing ? clear_q[SLOTW-1:0] : texel_slot_i),
        .wr_data_i(clearing || all ? 3'd0 : seen + 3'd1),
        .rd_addr_i(texel_slot_i), .rd_data_o(seen)
    );
    always @(posedge clk) begin
        if (clearing) clear_q <= clear_q + 1'b1;
        if (rst) clear_q <= {(SLOTW+1){1'b0}};
    end

    // ---- complete surfaces, in turn: a texel a clock into a register ----
    wire             f_valid, f_in, f_take, f_ready;
    wire [SLOTW-1:0] f_slot;
    wire [`RT_RGB_BITS-1:0] f_albedo, f_texel;
    wire [39:0]      f_mix;
    reg              f_read_q;               // what belongs to the head is read
    reg              get_q, got_q, full_q;   // a texel is read; it is here; all are
    reg  [2:0]       index_q, got_index_q;
    reg  [8*`RT_RGB_BITS-1:0] texels_q;
    integer          i;
    wire             f_both = f_mix[39:32] != 8'd0;
    wire             get_last = index_q == (nearest_i ? 3'd0 : f_both ? 3'd7 : 3'd3);
    assign f_take = full_q && f_ready;
    wire             next_valid, next_ready; // behind the head, which reads memories
    wire [SLOTW-1:0] next_slot;
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_full (
        .clk(clk), .rst(rst), .in_valid_i(all), .in_ready_o(f_in), .in_data_i(texel_slot_i),
        .out_valid_o(next_valid), .out_ready_i(next_ready), .out_data_o(next_slot)
    );
    rt_reg_slice #(.WIDTH(SLOTW)) u_head (
        .clk(clk), .rst(rst),
        .in_valid_i(next_valid), .in_ready_o(next_ready), .in_data_i(next_slot),
        .out_valid_o(f_valid), .out_ready_i(f_take), .out_data_o(f_slot)
    );
    rt_slot_ram #(.WIDTH(40), .SLOTS(SLOTS), .OLD(0)) u_mix (
        .clk(clk), .wr_en_i(mix_valid_i), .wr_addr_i(mix_slot_i), .wr_data_i(mix_i),
        .rd_en_i(f_valid), .rd_addr_i(f_slot), .rd_data_o(f_mix)
    );
    rt_slot_ram #(.WIDTH(`RT_RGB_BITS), .SLOTS(SLOTS), .OLD(0)) u_albedo (
        .clk(clk), .wr_en_i(albedo_valid_i), .wr_addr_i(albedo_slot_i), .wr_data_i(albedo_i),
        .rd_en_i(f_valid), .rd_addr_i(f_slot), .rd_data_o(f_albedo)
    );
    rt_slot_ram #(.WIDTH(`RT_RGB_BITS), .SLOTS(8*SLOTS), .OLD(0)) u_texels (
        .clk(clk), .wr_en_i(texel_valid_i), .wr_addr_i({texel_slot_i, texel_index_i}),
        .wr_data_i(texel_i),
        .rd_en_i(get_q), .rd_addr_i({f_slot, index_q}), .rd_data_o(f_texel)
    );
    always @(posedge clk) begin
        f_read_q    <= f_valid && !f_take;
        get_q       <= f_valid && !f_read_q ? 1'b1 : get_q && !get_last;
        index_q     <= get_q ? index_q + 3'd1 : 3'd0;
        got_q       <= get_q;
        got_index_q <= index_q;
        // the first stands for those that do not come, so that each word is defined
        for (i = 0; i < 8; i = i + 1)
            if (got_q && (got_index_q == 3'd0 || got_index_q == i[2:0]))
                texels_q[`RT_RGB_BITS*i +: `RT_RGB_BITS] <= f_texel;
        full_q <= (got_q && !get_q) || (full_q && !f_take);
        if (rst) {f_read_q, get_q, got_q, full_q} <= 4'd0;
    end

    // ---- filter, then the colour of the surface ----
    wire             c_valid;
    wire [SLOTW-1:0] c_slot;
    wire [`RT_RGB_BITS-1:0] c_albedo, c_texel;
    reg              x_valid_q, out_valid_q;
    reg  [SLOTW-1:0] x_slot_q, out_slot_q;
    rt_texel_filter #(.TAG(SLOTW + `RT_RGB_BITS)) u_filter (
        .clk(clk), .rst(rst), .in_valid_i(full_q), .in_ready_o(f_ready),
        .in_tag_i({f_slot, f_albedo}),
        .in_near_i(texels_q[0 +: 4*`RT_RGB_BITS]),
        .in_far_i(texels_q[4*`RT_RGB_BITS +: 4*`RT_RGB_BITS]),
        .in_near_weight_i(f_mix[15:0]), .in_far_weight_i(f_mix[31:16]),
        .in_level_i(f_mix[39:32]),
        .out_valid_o(c_valid), .out_tag_o({c_slot, c_albedo}), .out_texel_o(c_texel)
    );
    always @(posedge clk) begin
        x_valid_q   <= c_valid;
        x_slot_q    <= c_slot;
        out_valid_q <= x_valid_q;
        out_slot_q  <= x_slot_q;
        if (rst) {x_valid_q, out_valid_q} <= 2'd0;
    end
    assign out_valid_o = out_valid_q;
    assign out_slot_o  = out_slot_q;
    genvar c;
    generate
        for (c = 0; c < 3; c = c + 1) begin : g_channel
            // floor(x / 255) = (x + 1 + (x >> 8)) >> 8 for x below 65535
            reg  [15:0] x_q;                 // albedo * texel
            reg  [7:0]  colour_q;
            wire [16:0] x     = {1'b0, x_q} + 17'd127;
            wire [16:0] by255 = x + 17'd1 + {8'd0, x[16:8]};
            always @(posedge clk) begin
                x_q      <= c_albedo[8*c +: 8] * c_texel[8*c +: 8];
                colour_q <= by255[15:8];
            end
            assign out_colour_o[8*c +: 8] = colour_q;
            wire unused = &{1'b0, by255[16], by255[7:0]};
        end
    endgenerate
    wire unused = f_in;
endmodule
`default_nettype wire
