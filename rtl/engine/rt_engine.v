// rt_engine.v - pixels under way: set-up, traversal, exact tests, shading, slots
// SPDX-License-Identifier: Apache-2.0
// It only wires five groups together, as drawn in docs/design/overview.md; each bundle that they
// exchange has one source. A slot is {pipe, slot of its own}; its top bits name the leaf unit and
// the shading unit that serve it.
// Model: sph_render_pixel() in cmodel/engine/render_pixel.c, SLOTS pixels at once
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_engine #(
    `include "rt_effects.vh"
    `include "rt_shade_parameters.vh"
    parameter PIPES      = 1,    // traversal pipes, 1..4
    parameter LEAF_UNITS = 1,    // leaf units, power of two, at most SHADES
    parameter SHADES     = 1,    // shading units, power of two
    parameter SETUPS     = 1,    // set-up units, power of two, at most LEAF_UNITS
    parameter SLOTS      = 64,   // numbers of slots, power of two: {pipe, slot of its own}
    parameter SQUARES    = 0,    // 1: squares of the node filter in LUTs
    parameter LUTS       = 0,    // LUT cells that a block RAM is worth, rt_slot_ram
    parameter STACK      = 16,   // sibling groups waiting per ray, power of two
    parameter ACCEL      = 0,    // 0: nodes of four spheres, 1: BIH, 2: nodes of four boxes
    parameter NODE_LINES = 256,  // node cache of a pipe
    parameter LEAF_LINES = 128,  // leaf and primitive cache of a leaf unit
    parameter ROOTS      = 3,    // roots of a leaf unit at once
    parameter ROOT_STEP  = 2,    // root bits a clock
    parameter LEAF_INTERVAL = 2, // clocks an exact test of a sphere
    parameter FACET_INTERVAL = 2, // clocks an exact test of a facet
    parameter UNITS      = 2,    // units for unit vectors
    parameter UNIT_INTERVAL = 2, // clocks a vector of each
    parameter READS = PIPES + LEAF_UNITS + (TEXTURE != 0 ? SHADES : 0) // not to be set: readers
) (
    input  wire                       clk,
    input  wire                       rst,
    input  wire                       flush_i,         // forget the caches
    output wire                       busy_o,
    input  wire [`RT_REGS_BITS-1:0]   regs_i,
    //: {BOX[6*(W+2)], N_LOOSE[24], LEAF_BASE[26], N_PRIMS[24], VISIT_LIMIT[24], MEM_LINES[26],
    //: SMOOTH_BASE[26], PRIM_BASE[26], ROOT[26], EYE[3*W], AMBIENT[48], BACKGROUND[24],
    //: N_LIGHTS[4], LEAST[9], MAX_DEPTH[4], TEX_FILTER[2], EFFECTS[EFFECT_BITS]}
    input  wire [`RT_LIGHT_BITS-1:0]  light_i,         // a light is written
    //: {DATA[32], PART[3], NUMBER[3], VALID}
    // from rt_pixel_scan
    input  wire                       in_valid_i,
    output wire                       in_ready_o,
    input  wire [`RT_START_BITS-1:0]  start_i,
    //: {DIR[3*WD], Y[14], X[14]}
    // finished pixels
    output wire                       pix_valid_o,
    input  wire                       pix_ready_i,
    output wire [`RT_PIXEL_BITS-1:0]  pix_o,
    //: {TEXTURE[32], KEY[W+WD+2], VISITS[24], ID[24], COLOUR[72], Y[14], X[14]}
    // memory: of each pipe from bit 0 up, of each leaf unit, with TEXTURE of each shading unit
    output wire [READS-1:0]           mem_req_valid_o,
    input  wire [READS-1:0]           mem_req_ready_i,
    output wire [`RT_LINE_BITS*READS-1:0] mem_req_line_o,
    input  wire [READS-1:0]           mem_rsp_valid_i,
    output wire [READS-1:0]           mem_rsp_ready_o,
    input  wire [255:0]               mem_rsp_data_i,
    input  wire                       mem_rsp_error_i,
    // events of this clock, for the counters, of each unit; faults by number of the error
    output wire [PIPES*`RT_TRACE_EVENT_BITS-1:0]  trace_event_o,
    //: {BUBBLE, MISS, TESTS[3], VISIT, ISSUED}
    output wire [LEAF_UNITS*`RT_EXACT_EVENT_BITS-1:0] exact_event_o,
    //: {MISS, PRIM[prim_event]}
    output wire [SHADES*`RT_SHADE_EVENT_BITS-1:0] shade_event_o,
    //: {MISS, TEXEL, POWER, SATURATED, QUOTIENT, REFRACTED, REFLECTED, SHADOW, PRIMARY}
    output wire [15:0]                fault_o          // {slots, shade, exact, trace}
);
    localparam SLOTW   = $clog2(SLOTS), LB = `RT_LINE_BITS;
    localparam PB = $clog2(PIPES), XB = $clog2(LEAF_UNITS), SB = $clog2(SHADES),
        UB = $clog2(SETUPS);
    localparam ACROSS = ACCEL != 0 ? 0 : 2*UNITS <= UNIT_INTERVAL ? 2 : 1;
    localparam SHADOWS = LIGHTS != 0 && SHADOW != 0 ? 1 : 0;           // shadow rays
    localparam BOUNCES = REFLECT != 0 || INTERPENETRATE != 0 || REFRACT != 0 ? 1 : 0; // mirrored
    localparam FARS    = INSIDE != 0 || FACETS != 0 ? 1 : 0;           // hits that are far
    // bits of what one set-up unit gives, and of what it takes from its SU shading units
    localparam VB = `RT_VECTOR_BITS-UB, RB = `RT_RAY_BITS-UB, LU = 3*(NG+2), SW = SLOTW-UB,
        FB = `RT_FILTER_BITS, CB = `RT_ACROSS_BITS-UB, SU = SHADES/SETUPS,
        VS = SU*(`RT_VECTOR_BITS-SB), OS = SU*(`RT_ORG_BITS-SB), KS = SU*(`RT_SKIP_BITS-SB);
    wire [SETUPS*VB-1:0] primary; wire [SETUPS*VS-1:0] normal, vec_light, bounce;
    wire [SETUPS*OS-1:0] org; wire [SETUPS*KS-1:0] skip; wire [SETUPS*RB-1:0] ray;
    wire [SETUPS*SW-1:0] next_slot; wire [SETUPS*FB-1:0] filter; wire [SETUPS*CB-1:0] across;
    wire [PIPES*(`RT_VISIT_BITS-PB)-1:0]   visit; wire [SETUPS*LU-1:0] lift;
    wire [LEAF_UNITS*(`RT_RESULT_BITS-XB)-1:0] result;
    wire [`RT_DONE_BITS-1:0] done; wire [`RT_HIT_BITS-1:0] hit; wire [3*`RT_RGB_BITS-1:0] colour;
    wire [SHADES*(`RT_FETCH_BITS-SB)-1:0]  fetch;
    wire [SHADES*(`RT_RECORD_BITS-SB)-1:0] record; wire [`RT_BLEND_BITS-SB-1:0] blend;
    wire ray_again, done_valid, end_valid, read; wire [LB*SHADES-1:0] tex_req_line;
    wire [SETUPS-1:0] primary_ready, next_light; wire [`RT_VISITS_BITS-1:0] visits;
    wire [SHADES*(SLOTW-SB)-1:0] shadow_slot; wire [SLOTW-1:0] done_slot, end_slot, read_slot;
    wire [SHADES-1:0] shadow_go, fetch_ready; wire [31:0] texture;
    wire [SHADES-1:0] tex_req_valid, tex_req_ready, tex_rsp_valid, tex_rsp_ready;
    genvar n; generate for (n = 0; n < SETUPS; n = n + 1) begin : g_setup
        rt_setup #(.W(W), .WD(WD), .FW(FW), .NG(NG), .SHADOW(SHADOW), .LIGHTS(LIGHTS),
                   .BOUNCES(BOUNCES), .FACETS(FACETS), .TEXTURE(TEXTURE), .UNITS(UNITS),
                   .UNIT_INTERVAL(UNIT_INTERVAL), .ACROSS(ACROSS), .SHADES(SU),
                   .LUTS(LUTS), .SLOTS(SLOTS/SETUPS)) u_setup (
            .clk(clk), .rst(rst), .eye_i(regs_i[`RT_REGS_EYE]), .normal_i(normal[n*VS +: VS]),
            .light_i(vec_light[n*VS +: VS]), .bounce_i(bounce[n*VS +: VS]),
            .primary_i(primary[n*VB +: VB]), .primary_ready_o(primary_ready[n]),
            .org_i(org[n*OS +: OS]), .skip_i(skip[n*KS +: KS]), .ray_o(ray[n*RB +: RB]),
            .filter_o(filter[n*FB +: FB]), .across_o(across[n*CB +: CB]), .lift_o(lift[n*LU +: LU]),
            .next_light_o(next_light[n]), .next_slot_o(next_slot[n*SW +: SW])
        );
    end endgenerate
    rt_pipes #(.W(W), .WD(WD), .FW(FW), .PIPES(PIPES), .LEAF_UNITS(LEAF_UNITS), .SHADES(SHADES),
              .SETUPS(SETUPS), .SLOTS(SLOTS), .STACK(STACK), .LINES(NODE_LINES),
              .LINE_BITS(LINE_BITS), .LUTS(LUTS), .SQUARES(SQUARES), .SHADOW(SHADOWS),
              .FIRST(FIRST), .FARS(FARS), .FACETS(FACETS), .ACCEL(ACCEL)) u_pipes (
        .clk(clk), .rst(rst), .flush_i(flush_i), .regs_i(regs_i), .ray_i(ray), .filter_i(filter),
        .across_i(across), .ray_again_i(ray_again), .shadow_go_i(shadow_go),
        .shadow_slot_i(shadow_slot), .visit_o(visit), .result_i(result), .done_slot_o(done_slot),
        .done_valid_o(done_valid), .done_o(done), .visits_read_i(read), .visits_slot_i(read_slot),
        .visits_o(visits), .mem_req_valid_o(mem_req_valid_o[PIPES-1:0]),
        .mem_req_ready_i(mem_req_ready_i[PIPES-1:0]),
        .mem_req_line_o(mem_req_line_o[LB*PIPES-1:0]), .mem_rsp_valid_i(mem_rsp_valid_i[PIPES-1:0]),
        .mem_rsp_ready_o(mem_rsp_ready_o[PIPES-1:0]), .mem_rsp_data_i(mem_rsp_data_i),
        .mem_rsp_error_i(mem_rsp_error_i), .event_o(trace_event_o), .fault_o(fault_o[3:0])
    );
    rt_leaf_units #(.W(W), .WD(WD), .NG(NG), .LEAF_UNITS(LEAF_UNITS), .PIPES(PIPES),
               .SHADES(SHADES), .SETUPS(SETUPS), .SLOTS(SLOTS), .LINES(LEAF_LINES),
               .LINE_BITS(LINE_BITS), .ROOTS(ROOTS), .ROOT_STEP(ROOT_STEP), .PR(PR),
               .LEAF_INTERVAL(LEAF_INTERVAL), .SHADOW(SHADOWS), .INSIDE(INSIDE), .FACETS(FACETS),
               .CLEAR(CLEAR), .FACET_INTERVAL(FACET_INTERVAL)) u_leaf_units (
        .clk(clk), .rst(rst), .flush_i(flush_i), .regs_i(regs_i), .ray_i(ray), .lift_i(lift),
        .visit_i(visit), .result_o(result), .fetch_i(fetch), .fetch_ready_o(fetch_ready),
        .record_o(record),
        .mem_req_valid_o(mem_req_valid_o[PIPES +: LEAF_UNITS]),
        .mem_req_ready_i(mem_req_ready_i[PIPES +: LEAF_UNITS]),
        .mem_req_line_o(mem_req_line_o[LB*PIPES +: LB*LEAF_UNITS]),
        .mem_rsp_valid_i(mem_rsp_valid_i[PIPES +: LEAF_UNITS]),
        .mem_rsp_ready_o(mem_rsp_ready_o[PIPES +: LEAF_UNITS]), .mem_rsp_data_i(mem_rsp_data_i),
        .mem_rsp_error_i(mem_rsp_error_i), .event_o(exact_event_o), .fault_o(fault_o[7:4])
    );
    rt_shades #(
        `include "rt_effects_pass.vh"
        `include "rt_shade_pass.vh"
        .SHADES(SHADES), .SETUPS(SETUPS), .SLOTS(SLOTS), .LUTS(LUTS)
    ) u_shades (
        .clk(clk), .rst(rst), .flush_i(flush_i), .regs_i(regs_i), .light_i(light_i), .ray_i(ray),
        .next_light_i(next_light), .next_slot_i(next_slot), .hit_i(hit), .blend_o(blend),
        .end_valid_o(end_valid), .end_slot_o(end_slot), .fetch_o(fetch),
        .fetch_ready_i(fetch_ready), .record_i(record), .normal_o(normal), .vec_light_o(vec_light),
        .bounce_o(bounce), .org_o(org), .skip_o(skip), .shadow_go_o(shadow_go),
        .shadow_slot_o(shadow_slot), .read_i(read), .read_slot_i(read_slot), .colour_o(colour),
        .texture_o(texture), .mem_req_valid_o(tex_req_valid), .mem_req_ready_i(tex_req_ready),
        .mem_req_line_o(tex_req_line), .mem_rsp_valid_i(tex_rsp_valid),
        .mem_rsp_ready_o(tex_rsp_ready), .mem_rsp_data_i(mem_rsp_data_i),
        .mem_rsp_error_i(mem_rsp_error_i), .event_o(shade_event_o), .fault_o(fault_o[11:8])
    );
    generate
        if (TEXTURE != 0) begin : g_texture
            assign mem_req_valid_o[READS-1 -: SHADES]     = tex_req_valid;
            assign mem_req_line_o[LB*READS-1 -: LB*SHADES] = tex_req_line;
            assign mem_rsp_ready_o[READS-1 -: SHADES]     = tex_rsp_ready;
            assign tex_req_ready = mem_req_ready_i[READS-1 -: SHADES];
            assign tex_rsp_valid = mem_rsp_valid_i[READS-1 -: SHADES];
        end else begin : g_plain
            assign {tex_req_ready, tex_rsp_valid} = {2*SHADES{1'b0}};
            wire unused = &{1'b0, tex_req_valid, tex_req_line, tex_rsp_ready};
        end
    endgenerate
    rt_slots #(.W(W), .WD(WD), .SHADOW(SHADOWS), .FARS(FARS), .TEXTURE(TEXTURE),
               .INTERPENETRATE(INTERPENETRATE), .PIPES(PIPES), .SETUPS(SETUPS),
               .SLOTS(SLOTS)) u_slots (
        .clk(clk), .rst(rst), .busy_o(busy_o), .regs_i(regs_i), .in_valid_i(in_valid_i),
        .in_ready_o(in_ready_o), .start_i(start_i), .primary_o(primary),
        .primary_ready_i(primary_ready), .ray_again_o(ray_again), .done_valid_i(done_valid),
        .ray_slot_i({{UB{1'b0}}, ray[`RT_RAY_BITS-UB-1 -: SLOTW-UB]}), .done_slot_i(done_slot),
        .done_i(done), .hit_o(hit), .blend_i({{SB{1'b0}}, blend}), .end_valid_i(end_valid),
        .end_slot_i(end_slot), .read_o(read), .read_slot_o(read_slot), .visits_i(visits),
        .colour_i(colour), .texture_i(texture), .pix_valid_o(pix_valid_o),
        .pix_ready_i(pix_ready_i), .pix_o(pix_o), .fault_o(fault_o[15:12])
    );
endmodule
`default_nettype wire
