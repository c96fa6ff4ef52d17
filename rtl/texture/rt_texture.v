// rt_texture.v - texture unit: path, level of detail, coordinates, texels, filter
// SPDX-License-Identifier: Apache-2.0
// Every surface passes; one with a texture goes through its mapping record, the header of its image
// and the texels around its coordinates before its lights begin (Park et al. 2011, Figure 1). One
// token a slot: whatever waits lies in a queue or in a memory of SLOTS words, and what the cache
// returns is always taken. Drawing and timing: docs/design/textures.md
// Model: sph_lookup() in cmodel/texture/lookup.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_texture #(
    parameter W     = 16,      // coordinate, bits
    parameter WD    = 17,      // direction component, bits
    parameter NG    = 2,       // guard bits of the hit point
    parameter BACK  = 0,       // 1: rays that waited come back (REFRACT)
    parameter SPREAD = 0,      // 1: spheres spread rays
    parameter SLOTS = 32,      // power of two
    parameter LINES = 128,     // texture cache, lines of memory
    parameter LINE_BITS = `RT_LINE_BITS, // bits of a line's number
    parameter WAYS  = 4,       // groups of a set
    parameter GROUP = 1,       // lines of memory fetched together: 1, 2 or 4
    parameter COORDS = 2,      // units for coordinates
    parameter COARSE = 0       // bits of the level's fraction that are rounded away, 0 to 8
) (
    input  wire                clk,
    input  wire                rst,
    input  wire                flush_i,        // forget the texture cache
    input  wire [`RT_REGS_BITS-1:0]     regs_i,
    //: {BOX[6*(W+2)], N_LOOSE[24], LEAF_BASE[26], N_PRIMS[24], VISIT_LIMIT[24], MEM_LINES[26],
    //: SMOOTH_BASE[26], PRIM_BASE[26], ROOT[26], EYE[3*W], AMBIENT[48], BACKGROUND[24],
    //: N_LIGHTS[4], LEAST[9], MAX_DEPTH[4], TEX_FILTER[2], EFFECTS[EFFECT_BITS]}
    // from rt_setup: rays, unit normals; from rt_slots: what they hit; from rt_surface: material,
    // then hit point
    input  wire [`RT_RAY_BITS-1:0]      ray_i,
    //: {SLOT[SLOTW], H[6], Y[17], UNIT[54], INSIDE, SKIP[24], A[2*WD], DIR[3*WD], ORG[3*W], SHADOW,
    //: PRIMARY, LIGHT, NORMAL, VALID}
    input  wire [`RT_HIT_BITS-1:0]      hit_i,
    //: {SLOT[SLOTW], KEY[W+WD+2], ID[24], FAR, PROBE, FIRST, LIT, SHADOW, MISS, HIT}
    input  wire [`RT_MATERIAL_BITS-1:0] material_i,
    //: {SLOT[SLOTW], SMOOTH[24], BEND[6], TEX[26], INDEX[12], POWER[12], KS[8], KD[9], KA[9], SUM,
    //: KT[9], KR[9], RGB[24], VALID}
    input  wire [`RT_SURFACE_BITS-1:0]  surface_i,
    //: {SLOT[SLOTW], FLAT, NORMAL[3*WD], LIFT[3*(NG+2)], GUARDED[3*(W+NG)], POINT[3*W], VALID}
    // token: a surface, with its unit normal in ray_i
    input  wire                         in_valid_i,
    input  wire [$clog2(SLOTS)-1:0]     in_slot_i,
    // to and from rt_leave: paths of surfaces; of rays that waited, not with path_valid_o
    output wire                         path_valid_o,
    output wire [$clog2(SLOTS)-1:0]     path_slot_o,
    output wire [W+17:0]                path_o,
    input  wire [`RT_BACK_BITS-1:0]     back_i,
    //: {SLOT[SLOTW], PATH[W+18], INSIDE, ID[24], POINT[3*W], VALID}
    // to rt_compose: the albedo as textured; to rt_lighting, a cycle later: the surface
    output wire [`RT_ALBEDO_BITS-1:0] albedo_o,
    //: {SLOT[SLOTW], KR[9], RGB[24], VALID}
    output wire                out_valid_o,
    output wire [$clog2(SLOTS)-1:0] out_slot_o,
    // to rt_slots: what a pixel has seen of textures, a cycle after its slot
    input  wire                word_read_i,
    input  wire [$clog2(SLOTS)-1:0] word_slot_i,
    output wire [31:0]         word_o,         // {lod u4.8, sum of texel addresses}
    // memory
    output wire                mem_req_valid_o,
    input  wire                mem_req_ready_i,
    output wire [`RT_LINE_BITS-1:0] mem_req_line_o,
    input  wire                mem_rsp_valid_i,
    output wire                mem_rsp_ready_o,
    input  wire [255:0]        mem_rsp_data_i,
    input  wire                mem_rsp_error_i,
    // counters and errors
    output wire                texel_o,        // a texel is asked for
    output wire                miss_o,         // a group is fetched: record, header, texel
    output wire                bad_node_o,
    output wire                bus_error_o
);
    localparam SLOTW = $clog2(SLOTS);
    localparam PW = W + 8;
    localparam [1:0] MAP = 2'd0, IMAGE = 2'd1, TEXEL = 2'd2;
    localparam TAG = SLOTW + 9;                // {slot, kind, index, word, void}

    wire [`RT_EFFECT_BITS-1:0] effects   = regs_i[`RT_REGS_EFFECTS];
    wire [1:0]       filter    = regs_i[`RT_REGS_TEX_FILTER];
    wire [`RT_LINE_BITS-1:0] mem_lines = regs_i[`RT_REGS_MEM_LINES];
    wire             record_valid = material_i[`RT_MATERIAL_VALID];
    wire [SLOTW-1:0] record_slot  = material_i[`RT_MATERIAL_SLOT];
    wire [`RT_RGB_BITS-1:0] record_rgb = material_i[`RT_MATERIAL_RGB];

    // ---- path; a surface without a texture is done ----
    wire             p_valid, p_primary, maps_in;
    wire [SLOTW-1:0] p_slot;
    wire [`RT_LINE_BITS-1:0] p_tex;
    wire [W+17:0]    p_path;                   // {bend, spread, path}
    wire             p_textured = effects[`RT_EFFECT_TEXTURE] && p_tex != {`RT_LINE_BITS{1'b0}};
    rt_texture_path #(.W(W), .WD(WD), .BACK(BACK), .SPREAD(SPREAD), .SLOTS(SLOTS)) u_path (
        .clk(clk), .rst(rst),
        .ray_valid_i(ray_i[`RT_RAY_VALID] && !ray_i[`RT_RAY_SHADOW]),
        .ray_slot_i(ray_i[`RT_RAY_SLOT]), .ray_primary_i(ray_i[`RT_RAY_PRIMARY]),
        .ray_y_i(ray_i[`RT_RAY_Y]), .ray_h_i(ray_i[`RT_RAY_H]),
        .hit_valid_i(hit_i[`RT_HIT_HIT]), .hit_slot_i(hit_i[`RT_HIT_SLOT]),
        .hit_key_i(hit_i[`RT_HIT_KEY]),
        .tex_valid_i(record_valid), .tex_slot_i(record_slot),
        .tex_i(material_i[`RT_MATERIAL_TEX]), .bend_i(material_i[`RT_MATERIAL_BEND]),
        .back_valid_i(back_i[`RT_BACK_VALID]), .back_slot_i(back_i[`RT_BACK_SLOT]),
        .back_path_i(back_i[`RT_BACK_PATH]),
        .in_valid_i(in_valid_i), .in_slot_i(in_slot_i),
        .out_valid_o(p_valid), .out_slot_o(p_slot), .out_tex_o(p_tex),
        .out_primary_o(p_primary), .out_path_o(p_path)
    );
    assign {path_valid_o, path_slot_o, path_o} = {p_valid, p_slot, p_path};
    wire             map_valid, map_ready;
    wire [SLOTW-1:0] map_slot;
    wire [`RT_LINE_BITS-1:0] map_line;
    rt_fifo #(.WIDTH(SLOTW + `RT_LINE_BITS), .DEPTH(SLOTS)) u_maps (
        .clk(clk), .rst(rst), .in_valid_i(p_valid && p_textured), .in_ready_o(maps_in),
        .in_data_i({p_slot, p_tex}),
        .out_valid_o(map_valid), .out_ready_i(map_ready), .out_data_o({map_slot, map_line})
    );

    // ---- requests: what is nearer to the end goes first; void ones read line 0 ----
    wire             texel_valid, texel_ready, image_valid, image_ready, ready;
    wire [SLOTW-1:0] texel_slot, image_slot, slot;
    wire [`RT_LINE_BITS-1:0] image_line;
    wire [`RT_LINE_BITS:0] texel_line;
    wire [2:0]       texel_index, texel_word, index, word;
    wire [`RT_LINE_BITS:0] line = texel_valid ? texel_line
                              : {1'b0, image_valid ? image_line : map_line};
    wire [TAG-2:0]   what   = texel_valid ? {texel_slot, TEXEL, texel_index, texel_word}
                              : image_valid ? {image_slot, IMAGE, 6'd0} : {map_slot, MAP, 6'd0};
    // The choice stands in a queue, whose room is a register; then its line is compared with the
    // end of memory, and what came out stands in a register.
    wire             chosen, next, ask, taken; // taken by the cache
    wire [TAG-2:0]   chosen_what;
    wire [TAG-1:0]   asked;
    wire [`RT_LINE_BITS:0] chosen_line;
    wire [`RT_LINE_BITS-1:0] ask_line;
    wire             beyond = chosen_line >= {1'b0, mem_lines};
    rt_fifo #(.WIDTH(TAG - 1 + `RT_LINE_BITS + 1), .DEPTH(2)) u_choice (
        .clk(clk), .rst(rst), .in_valid_i((texel_valid || image_valid || map_valid) && ready),
        .in_ready_o(ready), .in_data_i({what, line}),
        .out_valid_o(chosen), .out_ready_i(next), .out_data_o({chosen_what, chosen_line})
    );
    rt_reg_slice #(.WIDTH(TAG + `RT_LINE_BITS)) u_ask (
        .clk(clk), .rst(rst), .in_valid_i(chosen), .in_ready_o(next),
        .in_data_i({chosen_what, beyond,
                    beyond ? {`RT_LINE_BITS{1'b0}} : chosen_line[`RT_LINE_BITS-1:0]}),
        .out_valid_o(ask), .out_ready_i(taken), .out_data_o({asked, ask_line})
    );
    wire             come, lost, come_error;
    wire [1:0]       kind;
    wire [255:0]     data;
    assign texel_ready = ready;
    assign image_ready = ready && !texel_valid;
    assign map_ready   = ready && !texel_valid && !image_valid;
    rt_cache #(.TAG(TAG), .LINES(LINES), .WAYS(WAYS), .GROUP(GROUP), .PENDING(SLOTS),
               .LINE_BITS(LINE_BITS)) u_cache (
        .clk(clk), .rst(rst), .flush_i(flush_i), .mem_lines_i(mem_lines), .miss_o(miss_o),
        .req_valid_i(ask), .req_ready_o(taken), .req_line_i(ask_line),
        .req_tag_i(asked),
        .rsp_valid_o(come), .rsp_ready_i(1'b1), .rsp_data_o(data),
        .rsp_tag_o({slot, kind, index, word, lost}), .rsp_error_o(come_error),
        .mem_req_valid_o(mem_req_valid_o), .mem_req_ready_i(mem_req_ready_i),
        .mem_req_line_o(mem_req_line_o),
        .mem_rsp_valid_i(mem_rsp_valid_i), .mem_rsp_ready_o(mem_rsp_ready_o),
        .mem_rsp_data_i(mem_rsp_data_i), .mem_rsp_error_i(mem_rsp_error_i)
    );
    assign bus_error_o = come && come_error;
    assign texel_o     = texel_valid && texel_ready;
    // for benches: the cache's shape, and what it is asked
    wire [31:0] cache_shape /* verilator public_flat_rd */ = {LINES[15:0], WAYS[7:0], GROUP[7:0]};
    wire [31:0] cache_asked /* verilator public_flat_rd */ =
        {3'd0, ask, taken, asked[8:7] == TEXEL, ask_line};

    // ---- a line came ----
    reg              r_map_q, r_texel_q, r_lost_q;
    reg [SLOTW-1:0]  r_slot_q;
    reg [2:0]        r_index_q;
    reg [`RT_RGB_BITS-1:0] r_colour_q;
    wire             come_map   = come && kind == MAP;
    wire             come_image = come && kind == IMAGE;
    wire             no_texels;                // of the header that came a cycle ago
    always @(posedge clk) begin
        r_map_q    <= come_map;
        r_texel_q  <= come && kind == TEXEL;
        r_lost_q   <= lost;
        r_slot_q   <= slot;
        r_index_q  <= index;
        r_colour_q <= lost ? {`RT_RGB_BITS{1'b1}} : data[32*word +: `RT_RGB_BITS];
        if (rst) begin r_map_q <= 1'b0; r_texel_q <= 1'b0; end
    end
    assign bad_node_o = ((r_map_q || r_texel_q) && r_lost_q) || no_texels;

    // ---- record, header, texels ----
    wire [11:0]      lod;
    wire [`RT_LINE_BITS-1:0] header_line;
    wire             st_read, both_valid, both, mix_valid, mixed;
    wire [SLOTW-1:0] st_slot, mix_slot, mixed_slot;
    wire [81:0]      st;
    wire [39:0]      mix;
    wire [`RT_RGB_BITS-1:0] colour;
    rt_texture_map #(.W(W), .NG(NG), .SLOTS(SLOTS), .COORDS(COORDS)) u_map (
        .clk(clk), .rst(rst),
        .hit_valid_i(hit_i[`RT_HIT_HIT]), .hit_slot_i(hit_i[`RT_HIT_SLOT]),
        .hit_far_i(hit_i[`RT_HIT_FAR]),
        .point_valid_i(surface_i[`RT_SURFACE_VALID]), .point_slot_i(surface_i[`RT_SURFACE_SLOT]),
        .point_i(surface_i[`RT_SURFACE_GUARDED]),
        .unit_valid_i(in_valid_i), .unit_slot_i(in_slot_i), .unit_i(ray_i[`RT_RAY_UNIT]),
        .path_valid_i(p_valid), .path_slot_i(p_slot), .path_i(p_path[PW-1:0]),
        .map_valid_i(come_map), .map_slot_i(slot), .map_i(data), .void_i(r_lost_q),
        .image_valid_o(image_valid), .image_ready_i(image_ready), .image_slot_o(image_slot),
        .image_line_o(image_line),
        .level_read_i(come_image), .level_slot_i(slot), .level_lod_o(lod),
        .level_line_o(header_line),
        .st_read_i(st_read), .st_slot_i(st_slot), .st_o(st)
    );
    rt_texture_image #(.SLOTS(SLOTS), .COARSE(COARSE)) u_image (
        .clk(clk), .rst(rst), .filter_i(filter),
        .image_valid_i(come_image), .image_slot_i(slot), .image_i(data), .void_i(r_lost_q),
        .lod_i(lod), .line_i(header_line), .none_o(no_texels),
        .st_read_o(st_read), .st_slot_o(st_slot), .st_i(st),
        .texel_valid_o(texel_valid), .texel_ready_i(texel_ready), .texel_slot_o(texel_slot),
        .texel_index_o(texel_index), .texel_line_o(texel_line), .texel_word_o(texel_word),
        .both_valid_o(both_valid), .both_o(both),
        .mix_valid_o(mix_valid), .mix_slot_o(mix_slot), .mix_o(mix),
        .fresh_valid_i(p_valid && p_primary), .fresh_slot_i(p_slot),
        .word_read_i(word_read_i), .word_slot_i(word_slot_i), .word_o(word_o)
    );
    rt_texture_mix #(.SLOTS(SLOTS)) u_mix (
        .clk(clk), .rst(rst), .nearest_i(filter == 2'd0),
        .albedo_valid_i(record_valid), .albedo_slot_i(record_slot), .albedo_i(record_rgb),
        .both_valid_i(both_valid), .both_slot_i(texel_slot), .both_i(both),
        .mix_valid_i(mix_valid), .mix_slot_i(mix_slot), .mix_i(mix),
        .texel_valid_i(r_texel_q), .texel_slot_i(r_slot_q), .texel_index_i(r_index_q),
        .texel_i(r_colour_q),
        .out_valid_o(mixed), .out_slot_o(mixed_slot), .out_colour_o(colour)
    );

    // ---- the end ----
    rt_texture_end #(.SLOTS(SLOTS)) u_end (
        .clk(clk), .rst(rst), .material_i(material_i),
        .plain_valid_i(p_valid && !p_textured), .plain_slot_i(p_slot),
        .white_valid_i((r_map_q && r_lost_q) || no_texels), .white_slot_i(r_slot_q),
        .mixed_valid_i(mixed), .mixed_slot_i(mixed_slot), .mixed_i(colour),
        .albedo_o(albedo_o), .out_valid_o(out_valid_o), .out_slot_o(out_slot_o)
    );
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_texture_cache /* verilator public_flat_rd */ =
        {ask && !taken, ask && taken, 5'd0, ask && taken};
    wire unused = &{1'b0, regs_i, effects, ray_i, hit_i, material_i, surface_i, back_i, maps_in};
endmodule
`default_nettype wire
