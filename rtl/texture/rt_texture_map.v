// rt_texture_map.v - mapping record in, level of detail and texture coordinates out
// SPDX-License-Identifier: Apache-2.0
// The level is computed as the record comes, coordinates of COORDS spheres at once, and hits
// may overtake each other; then the image's header is asked for.
// Model: the first half of sph_lookup() in cmodel/texture/lookup.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_texture_map #(
    parameter W     = 16,      // coordinate, bits
    parameter NG    = 2,       // guard bits of the hit point
    parameter SLOTS = 32,      // power of two
    parameter COORDS = 2       // units for spheres' coordinates
) (
    input  wire                clk,
    input  wire                rst,
    // what is known of the surface
    input  wire                hit_valid_i,
    input  wire [$clog2(SLOTS)-1:0] hit_slot_i,
    input  wire                hit_far_i,
    input  wire                point_valid_i,
    input  wire [$clog2(SLOTS)-1:0] point_slot_i,
    input  wire [3*(W+NG)-1:0] point_i,      // {z, y, x} s(W+NG)
    input  wire                unit_valid_i,
    input  wire [$clog2(SLOTS)-1:0] unit_slot_i,
    input  wire [53:0]         unit_i,       // {z, y, x} s1.16, of the normal
    input  wire                path_valid_i,
    input  wire [$clog2(SLOTS)-1:0] path_slot_i,
    input  wire [W+7:0]        path_i,       // u(W+4).4
    // the record; void_i a cycle later: it does not lie in memory
    input  wire                map_valid_i,
    input  wire [$clog2(SLOTS)-1:0] map_slot_i,
    input  wire [255:0]        map_i,
    input  wire                void_i,
    // the image's header is wanted
    output wire                image_valid_o,
    input  wire                image_ready_i,
    output wire [$clog2(SLOTS)-1:0] image_slot_o,
    output wire [`RT_LINE_BITS-1:0] image_line_o,
    // by slot, one cycle after its number: when the header comes, and when texels are chosen
    input  wire                level_read_i,
    input  wire [$clog2(SLOTS)-1:0] level_slot_i,
    output wire [11:0]         level_lod_o,  // u4.8, of the longest chain
    output wire [`RT_LINE_BITS-1:0] level_line_o, // of the header
    input  wire                st_read_i,
    input  wire [$clog2(SLOTS)-1:0] st_slot_i,
    output wire [81:0]         st_o          // {clamp t s, t, s}
);
    localparam SLOTW = $clog2(SLOTS);
    localparam GW = W + NG;
    localparam PW = W + 8;
    reg              r_valid_q;              // the record came one cycle ago
    reg [SLOTW-1:0]  r_slot_q;
    reg signed [15:0] r_base_q;
    wire             r_sound = r_valid_q && !void_i;
    always @(posedge clk) begin
        r_valid_q <= map_valid_i;
        r_slot_q  <= map_slot_i;
        r_base_q  <= map_i[`RT_MAP_BASE_LSB +: 16];
        if (rst) r_valid_q <= 1'b0;
    end

    // ---- level of detail ----
    wire [PW-1:0]    r_path;
    wire             lod_valid;
    wire [SLOTW-1:0] lod_slot;
    wire [11:0]      lod;
    rt_slot_ram #(.WIDTH(PW), .SLOTS(SLOTS), .OLD(0)) u_path (
        .clk(clk), .wr_en_i(path_valid_i), .wr_addr_i(path_slot_i), .wr_data_i(path_i),
        .rd_en_i(map_valid_i), .rd_addr_i(map_slot_i), .rd_data_o(r_path)
    );
    rt_lod #(.PB(PW), .TAG(SLOTW)) u_lod (
        .clk(clk), .rst(rst), .in_valid_i(r_sound), .in_tag_i(r_slot_q), .in_path_i(r_path),
        .in_base_i(r_base_q), .in_levels_i(4'd`RT_TEXTURE_LEVELS),
        .out_valid_o(lod_valid), .out_tag_o(lod_slot), .out_lod_o(lod)
    );
    rt_slot_ram #(.WIDTH(12), .SLOTS(SLOTS), .OLD(0)) u_lods (
        .clk(clk), .wr_en_i(lod_valid), .wr_addr_i(lod_slot), .wr_data_i(lod),
        .rd_en_i(level_read_i), .rd_addr_i(level_slot_i), .rd_data_o(level_lod_o)
    );

    // ---- coordinates ----
    wire             c_valid, c_in, c_take, c_ready, c_far;
    wire [SLOTW-1:0] c_slot;
    wire [255:0]     c_map;
    wire [3*GW-1:0]  c_point;
    wire [53:0]      c_unit;
    reg              c_read_q;               // what belongs to the head is read
    wire             next_valid, next_ready; // behind the head, which reads memories
    wire [SLOTW-1:0] next_slot;
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_records (
        .clk(clk), .rst(rst), .in_valid_i(r_sound), .in_ready_o(c_in), .in_data_i(r_slot_q),
        .out_valid_o(next_valid), .out_ready_i(next_ready), .out_data_o(next_slot)
    );
    rt_reg_slice #(.WIDTH(SLOTW)) u_head (
        .clk(clk), .rst(rst),
        .in_valid_i(next_valid), .in_ready_o(next_ready), .in_data_i(next_slot),
        .out_valid_o(c_valid), .out_ready_i(c_take), .out_data_o(c_slot)
    );
    rt_slot_ram #(.WIDTH(256), .SLOTS(SLOTS), .OLD(0)) u_map (
        .clk(clk), .wr_en_i(map_valid_i), .wr_addr_i(map_slot_i), .wr_data_i(map_i),
        .rd_en_i(c_valid), .rd_addr_i(c_slot), .rd_data_o(c_map)
    );
    rt_slot_ram #(.WIDTH(3*GW), .SLOTS(SLOTS), .OLD(0)) u_point (
        .clk(clk), .wr_en_i(point_valid_i), .wr_addr_i(point_slot_i), .wr_data_i(point_i),
        .rd_en_i(c_valid), .rd_addr_i(c_slot), .rd_data_o(c_point)
    );
    rt_slot_ram #(.WIDTH(54), .SLOTS(SLOTS), .OLD(0)) u_unit (
        .clk(clk), .wr_en_i(unit_valid_i), .wr_addr_i(unit_slot_i), .wr_data_i(unit_i),
        .rd_en_i(c_valid), .rd_addr_i(c_slot), .rd_data_o(c_unit)
    );
    rt_slot_ram #(.WIDTH(1), .SLOTS(SLOTS), .OLD(0)) u_far (
        .clk(clk), .wr_en_i(hit_valid_i), .wr_addr_i(hit_slot_i), .wr_data_i(hit_far_i),
        .rd_en_i(c_valid), .rd_addr_i(c_slot), .rd_data_o(c_far)
    );
    assign c_take = c_read_q && c_ready;
    always @(posedge clk) begin
        c_read_q <= c_valid && !c_take;
        if (rst) c_read_q <= 1'b0;
    end
    wire             t_valid;
    wire [SLOTW-1:0] t_slot;
    wire [`RT_LINE_BITS-1:0] t_line;
    wire [1:0]       t_clamp;
    wire [39:0]      t_s, t_t;
    rt_coords #(.W(W), .NG(NG), .TAG(SLOTW + 2 + `RT_LINE_BITS), .UNITS(COORDS)) u_coords (
        .clk(clk), .rst(rst), .in_valid_i(c_read_q), .in_ready_o(c_ready),
        .in_tag_i({c_slot, c_map[`RT_MAP_CLAMP_S_LSB +: 2],
                   c_map[`RT_MAP_IMAGE_LSB +: `RT_MAP_IMAGE_BITS]}),
        .in_map_i(c_map), .in_point_i(c_point), .in_unit_i(c_unit), .in_far_i(c_far),
        .out_valid_o(t_valid), .out_tag_o({t_slot, t_clamp, t_line}), .out_s_o(t_s), .out_t_o(t_t)
    );
    rt_slot_ram #(.WIDTH(82), .SLOTS(SLOTS), .OLD(0)) u_st (
        .clk(clk), .wr_en_i(t_valid), .wr_addr_i(t_slot), .wr_data_i({t_clamp, t_t, t_s}),
        .rd_en_i(st_read_i), .rd_addr_i(st_slot_i), .rd_data_o(st_o)
    );

    // ---- then the header ----
    wire             image_in;
    rt_fifo #(.WIDTH(SLOTW + `RT_LINE_BITS), .DEPTH(SLOTS)) u_images (
        .clk(clk), .rst(rst), .in_valid_i(t_valid), .in_ready_o(image_in),
        .in_data_i({t_slot, t_line}),
        .out_valid_o(image_valid_o), .out_ready_i(image_ready_i),
        .out_data_o({image_slot_o, image_line_o})
    );
    rt_slot_ram #(.WIDTH(`RT_LINE_BITS), .SLOTS(SLOTS), .OLD(0)) u_lines (
        .clk(clk), .wr_en_i(t_valid), .wr_addr_i(t_slot), .wr_data_i(t_line),
        .rd_en_i(level_read_i), .rd_addr_i(level_slot_i), .rd_data_o(level_line_o)
    );
    wire unused = &{1'b0, c_in, image_in, c_map};
endmodule
`default_nettype wire
