// rt_lighting.v - the lights of a surface: cosine, shadow ray, highlight, sum
// SPDX-License-Identifier: Apache-2.0
//   start --> rt_lights --+--> sum of light, of highlights
//              ^          +--> vector to a light, to rt_setup and back --> rt_cosine --> shadow ray
//              |                                                             |            |
//              +-- decided: it shines or not -- rt_specular_lights, if built <-+------------+
// Without LIGHTS a surface has its ambient light alone, in the clock in which it starts.
// Model: sph_job_light() in cmodel/engine/render_light.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_lighting #(
    parameter W      = 16,   // coordinate, bits
    parameter WD     = 17,   // direction component, bits
    parameter NG     = 2,    // guard bits of the hit point
    parameter SLOTS  = 64,   // rays in flight, power of two
    parameter LUTS   = 0,    // LUT cells that a block RAM is worth, rt_slot_ram
    parameter SHADOW = 1,    // 1: shadow rays
    parameter LIGHTS = 8,    // 0: ambient light alone
    parameter SPECULAR = 0,  // 1: highlights
    parameter SUM    = 0     // 1: the material has a share of ambient light, added later
) (
    input  wire                       clk,
    input  wire                       rst,
    input  wire [`RT_REGS_BITS-1:0]   regs_i,
    //: {BOX[6*(W+2)], N_LOOSE[24], LEAF_BASE[26], N_PRIMS[24], VISIT_LIMIT[24], MEM_LINES[26],
    //: SMOOTH_BASE[26], PRIM_BASE[26], ROOT[26], EYE[3*W], AMBIENT[48], BACKGROUND[24],
    //: N_LIGHTS[4], LEAST[9], MAX_DEPTH[4], TEX_FILTER[2], EFFECTS[EFFECT_BITS]}
    input  wire [`RT_LIGHT_BITS-1:0]  light_i,         // a light is written
    //: {DATA[32], PART[3], NUMBER[3], VALID}
    // from rt_setup, rt_slots, rt_surface
    input  wire [`RT_RAY_BITS-1:0]    ray_i,
    //: {SLOT[SLOTW], H[6], Y[17], UNIT[54], INSIDE, SKIP[24], A[2*WD], DIR[3*WD], ORG[3*W], SHADOW,
    //: PRIMARY, LIGHT, NORMAL, VALID}
    input  wire                       next_light_i,    // ray_i has LIGHT in the next clock,
    input  wire [$clog2(SLOTS)-1:0]   next_slot_i,     // and this slot
    input  wire [`RT_HIT_BITS-1:0]    hit_i,
    //: {SLOT[SLOTW], KEY[W+WD+2], ID[24], FAR, PROBE, FIRST, LIT, SHADOW, MISS, HIT}
    input  wire [`RT_MATERIAL_BITS-1:0] material_i,
    //: {SLOT[SLOTW], SMOOTH[24], BEND[6], TEX[26], INDEX[12], POWER[12], KS[8], KD[9], KA[9], SUM,
    //: KT[9], KR[9], RGB[24], VALID}
    input  wire [`RT_SURFACE_BITS-1:0] surface_i,
    //: {SLOT[SLOTW], FLAT, NORMAL[3*WD], LIFT[3*(NG+2)], GUARDED[3*(W+NG)], POINT[3*W], VALID}
    // token: a surface that is ready for its lights
    input  wire                       start_valid_i,
    input  wire [$clog2(SLOTS)-1:0]   start_slot_i,
    // to rt_setup: vector to a light; to rt_trace: token, a shadow ray starts
    output wire [`RT_VECTOR_BITS-1:0] vec_light_o,
    //: {SLOT[SLOTW], VEC[3*WD], VALID}
    output wire                       shadow_go_o,
    output wire [$clog2(SLOTS)-1:0]   shadow_slot_o,
    // to rt_compose: token, all lights of a surface are summed
    output wire                       sum_valid_o,
    output wire [$clog2(SLOTS)-1:0]   sum_slot_o,
    output wire [50:0]                sum_o,           // 3 x u2.15, red low
    output wire [50:0]                gloss_o,         // the same of highlights
    output wire                       power_o          // counts highlights that are begun
);
    localparam SLOTW = $clog2(SLOTS);
    localparam GLOSS = LIGHTS != 0 && SPECULAR != 0 ? 1 : 0;
    wire [`RT_EFFECT_BITS-1:0] effects = regs_i[`RT_REGS_EFFECTS];
    wire [47:0]      ambient = regs_i[`RT_REGS_AMBIENT];
    generate
        if (LIGHTS != 0) begin : g_lights
            wire             cosine_valid, unshadowed_valid, unshadowed_lit, decided, decided_lit;
            wire [SLOTW-1:0] decided_slot;
            wire [15:0]      cosine, highlight;
            rt_cosine #(.W(W), .WD(WD), .SHADOW(SHADOW), .SLOTS(SLOTS)) u_cosine (
                .clk(clk), .rst(rst), .shadow_on_i(effects[`RT_EFFECT_SHADOW]),
                .ray_i(ray_i), .next_light_i(next_light_i), .next_slot_i(next_slot_i),
                .out_valid_o(cosine_valid), .out_slot_o(shadow_slot_o), .out_cosine_o(cosine),
                .shadow_go_o(shadow_go_o),
                .unshadowed_valid_o(unshadowed_valid), .unshadowed_lit_o(unshadowed_lit)
            );
            if (GLOSS != 0) begin : g_specular
                rt_specular_lights #(.W(W), .WD(WD), .SHADOW(SHADOW), .SLOTS(SLOTS)) u_specular (
                    .clk(clk), .rst(rst),
                    .on_i(effects[`RT_EFFECT_SUM] && effects[`RT_EFFECT_SPECULAR]),
                    .ray_i(ray_i), .material_i(material_i),
                    .unshadowed_valid_i(unshadowed_valid), .unshadowed_slot_i(shadow_slot_o),
                    .unshadowed_lit_i(unshadowed_lit),
                    .shadow_valid_i(hit_i[`RT_HIT_SHADOW]), .shadow_slot_i(hit_i[`RT_HIT_SLOT]),
                    .shadow_lit_i(hit_i[`RT_HIT_LIT]),
                    .out_valid_o(decided), .out_slot_o(decided_slot), .out_lit_o(decided_lit),
                    .out_highlight_o(highlight), .power_o(power_o)
                );
            end else begin : g_no_specular
                assign {decided, decided_slot, decided_lit} =
                    {unshadowed_valid, shadow_slot_o, unshadowed_lit};
                assign highlight = 16'd0;
                assign power_o   = 1'b0;
            end
            rt_lights #(.W(W), .WD(WD), .LIGHTS(LIGHTS), .SHADOW(GLOSS != 0 ? 0 : SHADOW),
                        .AMBIENT(SUM != 0 ? 0 : 1), .GLOSS(GLOSS), .LUTS(LUTS),
                        .SLOTS(SLOTS)) u_lights (
                .clk(clk), .rst(rst), .n_lights_i(regs_i[`RT_REGS_N_LIGHTS]),
                .ambient_i(ambient),
                .light_valid_i(light_i[`RT_LIGHT_VALID]),
                .light_number_i(light_i[`RT_LIGHT_NUMBER]),
                .light_part_i(light_i[`RT_LIGHT_PART]), .light_data_i(light_i[`RT_LIGHT_DATA]),
                .point_valid_i(surface_i[`RT_SURFACE_VALID]),
                .point_slot_i(surface_i[`RT_SURFACE_SLOT]),
                .point_i(surface_i[`RT_SURFACE_POINT]),
                .cosine_valid_i(cosine_valid), .cosine_slot_i(shadow_slot_o), .cosine_i(cosine),
                .start_valid_i(start_valid_i), .start_slot_i(start_slot_i),
                .decided_valid_i(decided), .decided_slot_i(decided_slot),
                .decided_lit_i(decided_lit), .decided_highlight_i(highlight),
                .shadow_valid_i(hit_i[`RT_HIT_SHADOW]), .shadow_slot_i(hit_i[`RT_HIT_SLOT]),
                .shadow_lit_i(hit_i[`RT_HIT_LIT]),
                .vec_valid_o(vec_light_o[`RT_VECTOR_VALID]),
                .vec_slot_o(vec_light_o[`RT_VECTOR_SLOT]),
                .vec_o(vec_light_o[`RT_VECTOR_VEC]),
                .sum_valid_o(sum_valid_o), .sum_slot_o(sum_slot_o), .sum_o(sum_o),
                .gloss_o(gloss_o)
            );
        end else begin : g_ambient
            assign vec_light_o   = {`RT_VECTOR_BITS{1'b0}};
            assign shadow_go_o   = 1'b0;
            assign shadow_slot_o = {SLOTW{1'b0}};
            assign sum_valid_o   = start_valid_i;
            assign sum_slot_o    = start_slot_i;
            assign gloss_o       = 51'd0;
            assign sum_o         = SUM != 0 ? 51'd0 : {1'b0, ambient[47:32], 1'b0,
                                                       ambient[31:16], 1'b0, ambient[15:0]};
            assign power_o       = 1'b0;
            wire unused = &{1'b0, clk, rst, light_i, next_light_i, next_slot_i};
        end
    endgenerate
    wire unused = &{1'b0, regs_i, effects, ambient, ray_i, hit_i, material_i, surface_i};
endmodule
`default_nettype wire
