// rt_shade.v - shading: from the hits of a slot's rays to the frames of its pixel
// SPDX-License-Identifier: Apache-2.0
//   hit --> rt_surface --+--> normal, to rt_setup and back --+--> rt_texture --> rt_lighting
//             record     +--> unlit: no point is wanted -----+                        | sum
//   next ray, to rt_setup <-- rt_leave <--- a blended surface --- rt_compose <--------+
// A block that no effect asks for is not built; its tokens go straight on.
// Model: path(), shade(), leaving_rays() in cmodel/engine/render_pixel.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_shade #(
    `include "rt_effects.vh"
    `include "rt_shade_parameters.vh"
    parameter SLOTS      = 64,   // rays in flight, power of two
    parameter LUTS       = 0     // LUT cells that a block RAM is worth, rt_slot_ram
) (
    input  wire                       clk,
    input  wire                       rst,
    input  wire                       flush_i,         // forget the texture cache
    input  wire [`RT_REGS_BITS-1:0]   regs_i,
    //: {BOX[6*(W+2)], N_LOOSE[24], LEAF_BASE[26], N_PRIMS[24], VISIT_LIMIT[24], MEM_LINES[26],
    //: SMOOTH_BASE[26], PRIM_BASE[26], ROOT[26], EYE[3*W], AMBIENT[48], BACKGROUND[24],
    //: N_LIGHTS[4], LEAST[9], MAX_DEPTH[4], TEX_FILTER[2], EFFECTS[EFFECT_BITS]}
    input  wire [`RT_LIGHT_BITS-1:0]  light_i,         // a light is written
    //: {DATA[32], PART[3], NUMBER[3], VALID}
    // from rt_setup
    input  wire [`RT_RAY_BITS-1:0]    ray_i,
    //: {SLOT[SLOTW], H[6], Y[17], UNIT[54], INSIDE, SKIP[24], A[2*WD], DIR[3*WD], ORG[3*W], SHADOW,
    //: PRIMARY, LIGHT, NORMAL, VALID}
    input  wire                       next_light_i,    // ray_i has LIGHT in the next clock
    input  wire [$clog2(SLOTS)-1:0]   next_slot_i,     // of this slot
    // from rt_slots: what rays hit; to it: a surface is blended, a pixel is complete
    input  wire [`RT_HIT_BITS-1:0]    hit_i,
    //: {SLOT[SLOTW], KEY[W+WD+2], ID[24], FAR, PROBE, FIRST, LIT, SHADOW, MISS, HIT}
    output wire [`RT_BLEND_BITS-1:0]  blend_o,
    //: {SLOT[SLOTW], W_TOTAL[17], W_REFRACT[17], W_MIRROR[17], DEPTH[4], REFRACT, MIRROR, PROBE,
    //: LAST, VALID}
    output wire                       end_valid_o,
    output wire [$clog2(SLOTS)-1:0]   end_slot_o,
    // to and from rt_leaf_unit: primitive records
    output wire [`RT_FETCH_BITS-1:0]  fetch_o,
    //: {SLOT[SLOTW], LINE[26], VALID}
    input  wire                       fetch_ready_i,
    input  wire [`RT_RECORD_BITS-1:0] record_i,
    //: {SLOT[SLOTW], DATA[256], VALID}
    // to rt_setup: vectors, and where and on what the next ray starts
    output wire [`RT_VECTOR_BITS-1:0] normal_o,
    output wire [`RT_VECTOR_BITS-1:0] vec_light_o,
    output wire [`RT_VECTOR_BITS-1:0] bounce_o,
    //: {SLOT[SLOTW], VEC[3*WD], VALID}
    output wire [`RT_ORG_BITS-1:0]    org_o,
    //: {SLOT[SLOTW], LIFT[3*(NG+2)], POINT[3*W], VALID}
    output wire [`RT_SKIP_BITS-1:0]   skip_o,
    //: {SLOT[SLOTW], INSIDE, ID[24], VALID}
    // to rt_trace: token, a shadow ray starts
    output wire                       shadow_go_o,
    output wire [$clog2(SLOTS)-1:0]   shadow_slot_o,
    // to rt_slots: of a pixel that leaves, a clock after its slot
    input  wire                       read_i,
    input  wire [$clog2(SLOTS)-1:0]   read_slot_i,
    output wire [3*`RT_RGB_BITS-1:0]  colour_o,
    output wire [31:0]                texture_o,
    // memory, with TEXTURE
    output wire                       mem_req_valid_o,
    input  wire                       mem_req_ready_i,
    output wire [`RT_LINE_BITS-1:0]   mem_req_line_o,
    input  wire                       mem_rsp_valid_i,
    output wire                       mem_rsp_ready_o,
    input  wire [255:0]               mem_rsp_data_i,
    input  wire                       mem_rsp_error_i,
    // events and faults of this clock
    output wire [`RT_SHADE_EVENT_BITS-1:0] event_o,
    //: {MISS, TEXEL, POWER, SATURATED, QUOTIENT, REFRACTED, REFLECTED, SHADOW, PRIMARY}
    output wire [3:0]                 fault_o          // by number of the error, machine.def
);
    localparam SLOTW = $clog2(SLOTS);
    localparam SHADOWS = LIGHTS != 0 && SHADOW != 0 ? 1 : 0;           // shadow rays
    localparam SHARES  = REFRACT != 0 || SUM != 0 ? 1 : 0;             // blends by shares
    localparam BOUNCES = REFLECT != 0 || INTERPENETRATE != 0 || REFRACT != 0 ? 1 : 0; // mirrored
    localparam POINTS  = LIGHTS != 0 || BOUNCES != 0 || TEXTURE != 0 ? 1 : 0; // points, normals
    localparam BENT    = SMOOTH != 0 && POINTS != 0 ? 1 : 0;           // interpolated normals
    localparam PATHS   = TEXTURE == 0 ? 0 : SPREAD != 0 ? W + 18 : W + 8; // kept of a ray's path
    wire [`RT_EFFECT_BITS-1:0] effects  = regs_i[`RT_REGS_EFFECTS];
    wire [3:0]       n_lights = regs_i[`RT_REGS_N_LIGHTS];
    wire             ray_go   = ray_i[`RT_RAY_VALID] && !ray_i[`RT_RAY_SHADOW];

    // ---- hit: record, point, normal ----
    wire             points_on = n_lights != 4'd0 ||                   // POINTS at run time
                     effects[`RT_EFFECT_REFLECT] || effects[`RT_EFFECT_INTERPENETRATE] ||
                     (REFRACT != 0 && effects[`RT_EFFECT_REFRACT]) ||
                     (TEXTURE != 0 && effects[`RT_EFFECT_TEXTURE]);
    wire [`RT_MATERIAL_BITS-1:0] material;
    wire [`RT_SURFACE_BITS-1:0]  surface;
    wire [`RT_FETCH_BITS-1:0]    prim_fetch;
    wire [`RT_RECORD_BITS-1:0]   prim_record;
    wire             prim_fetch_ready;
    wire             unlit_valid;              // a surface that needs no point
    wire [SLOTW-1:0] unlit_slot;
    rt_surface #(.W(W), .WD(WD), .PQ(PQ), .NG(NG), .POINTS(POINTS), .BOUNCES(BOUNCES),
                 .INSIDE(INSIDE), .FACETS(FACETS), .TEXTURE(TEXTURE), .SMOOTH(BENT),
                 .SPREAD(SPREAD), .MATERIALS(SHARES),
                 .SLOTS(SLOTS), .LUTS(LUTS), .QUOTIENTS(QUOTIENTS),
                 .QUOTIENT_STEP(QUOTIENT_STEP), .HIT_INTERVAL(HIT_INTERVAL)) u_surface (
        .clk(clk), .rst(rst), .regs_i(regs_i), .points_on_i(points_on),
        .ray_i(ray_i), .hit_i(hit_i),
        .fetch_o(prim_fetch), .fetch_ready_i(prim_fetch_ready),
        .record_i(prim_record),
        .material_o(material), .unlit_valid_o(unlit_valid), .unlit_slot_o(unlit_slot),
        .surface_o(surface),
        .quotient_o(event_o[`RT_SHADE_EVENT_QUOTIENT]),
        .saturated_o(event_o[`RT_SHADE_EVENT_SATURATED])
    );

    // ---- its normal, interpolated if the triangle has normals ----
    wire [`RT_SIDE_BITS-1:0] side;
    wire             smooth_bad, texture_bad;
    generate
        if (BENT != 0) begin : g_smooth
            rt_smooth #(.W(W), .WD(WD), .NG(NG), .SLOTS(SLOTS)) u_smooth (
                .clk(clk), .rst(rst), .regs_i(regs_i),
                .material_i(material), .hit_i(hit_i), .surface_i(surface),
                .fetch_i(prim_fetch), .fetch_ready_o(prim_fetch_ready),
                .record_o(prim_record),
                .fetch_o(fetch_o), .fetch_ready_i(fetch_ready_i),
                .record_i(record_i),
                .normal_o(normal_o), .side_o(side), .bad_node_o(smooth_bad)
            );
        end else begin : g_own
            assign fetch_o           = prim_fetch;
            assign prim_fetch_ready  = fetch_ready_i;
            assign prim_record       = record_i;
            assign normal_o[`RT_VECTOR_VALID] = surface[`RT_SURFACE_VALID];
            assign normal_o[`RT_VECTOR_SLOT]  = surface[`RT_SURFACE_SLOT];
            assign normal_o[`RT_VECTOR_VEC]   = surface[`RT_SURFACE_NORMAL];
            assign side       = {`RT_SIDE_BITS{1'b0}};
            assign smooth_bad = 1'b0;
        end
    endgenerate
    assign fault_o[`RT_ERROR_BAD_NODE] = texture_bad || smooth_bad;

    // ---- where the next ray starts: at the surface, or where a refracted ray has waited ----
    wire [`RT_BACK_BITS-1:0] back;
    wire             path_valid;
    wire             back_valid = REFRACT != 0 && back[`RT_BACK_VALID];
    wire             back_ready = !surface[`RT_SURFACE_VALID] && !hit_i[`RT_HIT_HIT] &&
                                  !path_valid;
    assign org_o[`RT_ORG_VALID]   = surface[`RT_SURFACE_VALID] || back_valid;
    assign org_o[`RT_ORG_SLOT]    = back_valid ? back[`RT_BACK_SLOT] : surface[`RT_SURFACE_SLOT];
    assign org_o[`RT_ORG_POINT]   = back_valid ? back[`RT_BACK_POINT] : surface[`RT_SURFACE_POINT];
    assign org_o[`RT_ORG_LIFT]    = surface[`RT_SURFACE_LIFT];
    assign skip_o[`RT_SKIP_VALID] = hit_i[`RT_HIT_HIT] || back_valid;
    assign skip_o[`RT_SKIP_SLOT]  = back_valid ? back[`RT_BACK_SLOT] : hit_i[`RT_HIT_SLOT];
    assign skip_o[`RT_SKIP_ID]    = back_valid ? back[`RT_BACK_ID] : hit_i[`RT_HIT_ID];
    assign skip_o[`RT_SKIP_INSIDE] = back_valid ? back[`RT_BACK_INSIDE] : hit_i[`RT_HIT_FAR];

    // ---- texture: between a surface, which may be without a normal, and its lights ----
    wire             lit_valid = ray_i[`RT_RAY_NORMAL] || unlit_valid;  // never both: see points_on
    wire [SLOTW-1:0] lit_slot  = unlit_valid ? unlit_slot : ray_i[`RT_RAY_SLOT];
    wire             start_valid;
    wire [SLOTW-1:0] start_slot, path_slot;
    wire [`RT_ALBEDO_BITS-1:0] albedo;
    wire [W+17:0]    path;
    generate
        if (TEXTURE != 0) begin : g_texture
            rt_texture #(.W(W), .WD(WD), .NG(NG), .BACK(REFRACT), .SPREAD(SPREAD), .SLOTS(SLOTS),
                         .LINES(TEXTURE_LINES), .WAYS(TEXTURE_WAYS), .GROUP(TEXTURE_GROUP),
                         .LINE_BITS(LINE_BITS),
                         .COORDS(TEXTURE_COORDS), .COARSE(COARSE)) u_texture (
                .clk(clk), .rst(rst), .flush_i(flush_i), .regs_i(regs_i),
                .ray_i(ray_i), .hit_i(hit_i), .material_i(material), .surface_i(surface),
                .in_valid_i(lit_valid), .in_slot_i(lit_slot),
                .path_valid_o(path_valid), .path_slot_o(path_slot), .path_o(path),
                .back_i(back),
                .albedo_o(albedo), .out_valid_o(start_valid), .out_slot_o(start_slot),
                .word_read_i(read_i), .word_slot_i(read_slot_i), .word_o(texture_o),
                .mem_req_valid_o(mem_req_valid_o), .mem_req_ready_i(mem_req_ready_i),
                .mem_req_line_o(mem_req_line_o),
                .mem_rsp_valid_i(mem_rsp_valid_i), .mem_rsp_ready_o(mem_rsp_ready_o),
                .mem_rsp_data_i(mem_rsp_data_i), .mem_rsp_error_i(mem_rsp_error_i),
                .texel_o(event_o[`RT_SHADE_EVENT_TEXEL]), .miss_o(event_o[`RT_SHADE_EVENT_MISS]),
                .bad_node_o(texture_bad),
                .bus_error_o(fault_o[`RT_ERROR_BUS_ERROR])
            );
        end else begin : g_plain
            assign {start_valid, start_slot}   = {lit_valid, lit_slot};
            assign albedo[`RT_ALBEDO_VALID] = material[`RT_MATERIAL_VALID];
            assign albedo[`RT_ALBEDO_SLOT]  = material[`RT_MATERIAL_SLOT];
            assign albedo[`RT_ALBEDO_RGB]   = material[`RT_MATERIAL_RGB];
            assign albedo[`RT_ALBEDO_KR]    = material[`RT_MATERIAL_KR];
            assign texture_o = {12'd`RT_LOD_NONE, 20'd0};
            assign {path_valid, path_slot, path} = {(SLOTW+W+19){1'b0}};
            assign {mem_req_valid_o, mem_rsp_ready_o} = 2'd0;
            assign mem_req_line_o = {`RT_LINE_BITS{1'b0}};
            assign event_o[`RT_SHADE_EVENT_TEXEL] = 1'b0;
            assign event_o[`RT_SHADE_EVENT_MISS]  = 1'b0;
            assign texture_bad = 1'b0;
            assign fault_o[`RT_ERROR_BUS_ERROR]   = 1'b0;
            wire unused = &{1'b0, flush_i, mem_req_ready_i, mem_rsp_valid_i, mem_rsp_data_i,
                            mem_rsp_error_i};
        end
    endgenerate
    assign fault_o[`RT_ERROR_STACK_OVERFLOW] = 1'b0;
    assign fault_o[`RT_ERROR_VISIT_LIMIT]    = 1'b0;

    // ---- lights ----
    wire             sum_valid;
    wire [SLOTW-1:0] sum_slot;
    wire [50:0]      sum, gloss;
    rt_lighting #(.W(W), .WD(WD), .NG(NG), .SLOTS(SLOTS), .LUTS(LUTS), .SHADOW(SHADOWS),
                  .LIGHTS(LIGHTS), .SPECULAR(SPECULAR), .SUM(SUM)) u_lighting (
        .clk(clk), .rst(rst), .regs_i(regs_i), .light_i(light_i),
        .ray_i(ray_i), .next_light_i(next_light_i), .next_slot_i(next_slot_i),
        .hit_i(hit_i), .material_i(material), .surface_i(surface),
        .start_valid_i(start_valid), .start_slot_i(start_slot), .vec_light_o(vec_light_o),
        .shadow_go_o(shadow_go_o), .shadow_slot_o(shadow_slot_o),
        .sum_valid_o(sum_valid), .sum_slot_o(sum_slot), .sum_o(sum), .gloss_o(gloss),
        .power_o(event_o[`RT_SHADE_EVENT_POWER])
    );

    // ---- frames of a pixel; the ray that goes on ----
    wire             next_valid;
    wire [SLOTW-1:0] next_slot;
    wire [16:0]      next_weight;
    wire [3:0]       next_depth;
    rt_compose #(.W(W), .WD(WD), .REFLECT(REFLECT), .LIGHTS(LIGHTS),
                 .INTERPENETRATE(INTERPENETRATE), .REFRACT(REFRACT), .SPECULAR(SPECULAR),
                 .SUM(SUM), .LUTS(LUTS), .SLOTS(SLOTS)) u_compose (
        .clk(clk), .rst(rst), .regs_i(regs_i), .hit_i(hit_i), .material_i(material),
        .albedo_i(albedo),
        .sum_valid_i(sum_valid), .sum_slot_i(sum_slot), .sum_i(sum), .gloss_i(gloss),
        .next_valid_i(next_valid), .next_slot_i(next_slot), .next_weight_i(next_weight),
        .next_depth_i(next_depth), .blend_o(blend_o),
        .read_i(read_i), .read_slot_i(read_slot_i), .colour_o(colour_o)
    );
    wire             reflected;
    rt_leave #(.W(W), .WD(WD), .PQ(PQ), .NG(NG), .PR(PR), .MIRRORS(BOUNCES),
               .REFRACT(REFRACT), .DEEPEST(`RT_DEEPEST), .PATHS(PATHS), .SMOOTH(BENT),
               .BOUNCE_INTERVAL(BOUNCE_INTERVAL), .SLOTS(SLOTS)) u_leave (
        .clk(clk), .rst(rst), .ray_i(ray_i), .hit_i(hit_i), .material_i(material),
        .surface_i(surface), .side_i(side), .path_valid_i(path_valid), .path_slot_i(path_slot),
        .path_i(path), .blend_i(blend_o), .next_valid_o(next_valid), .next_slot_o(next_slot),
        .next_weight_o(next_weight), .next_depth_o(next_depth),
        .end_valid_o(end_valid_o), .end_slot_o(end_slot_o), .bounce_o(bounce_o),
        .back_o(back), .back_ready_i(back_ready), .reflected_o(reflected),
        .refracted_o(event_o[`RT_SHADE_EVENT_REFRACTED])
    );
    assign event_o[`RT_SHADE_EVENT_PRIMARY]   = ray_go && ray_i[`RT_RAY_PRIMARY];
    assign event_o[`RT_SHADE_EVENT_SHADOW]    = shadow_go_o;
    assign event_o[`RT_SHADE_EVENT_REFLECTED] = SHARES != 0 ? reflected
                                                : ray_go && !ray_i[`RT_RAY_PRIMARY];
    wire unused = &{1'b0, effects, back, reflected, surface, FW != 0, `RT_EFFECTS_BUILT};
endmodule
`default_nettype wire
