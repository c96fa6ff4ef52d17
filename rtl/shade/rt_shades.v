// rt_shades.v - shading units: each shades the hits of some pipes
// SPDX-License-Identifier: Apache-2.0
//   ray, hit --> rt_shade of the slot --+--> vectors, records wanted, shadow rays: of each unit
//                                       +--> queue --> end, one a clock
// The top bits of a slot name its unit: rt_route. Of pixels that are complete in one clock that of
// the lowest unit goes first: rt_first. With one unit there is nothing here but rt_shade.
// Model: that of rt_shade
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_shades #(
    `include "rt_effects.vh"
    `include "rt_shade_parameters.vh"
    parameter SHADES     = 1,    // shading units, power of two
    parameter SETUPS     = 1,    // set-up units, power of two, at most SHADES
    parameter SLOTS      = 64,   // numbers of slots, power of two
    parameter LUTS       = 0     // LUT cells that a block RAM is worth, rt_slot_ram
) (
    input  wire                       clk,
    input  wire                       rst,
    input  wire                       flush_i,         // forget the texture caches
    input  wire [`RT_REGS_BITS-1:0]   regs_i,
    //: {BOX[6*(W+2)], N_LOOSE[24], LEAF_BASE[26], N_PRIMS[24], VISIT_LIMIT[24], MEM_LINES[26],
    //: SMOOTH_BASE[26], PRIM_BASE[26], ROOT[26], EYE[3*W], AMBIENT[48], BACKGROUND[24],
    //: N_LIGHTS[4], LEAST[9], MAX_DEPTH[4], TEX_FILTER[2], EFFECTS[EFFECT_BITS]}
    input  wire [`RT_LIGHT_BITS-1:0]  light_i,         // a light is written
    //: {DATA[32], PART[3], NUMBER[3], VALID}
    // from each rt_setup
    input  wire [SETUPS*(`RT_RAY_BITS-$clog2(SETUPS))-1:0] ray_i,
    //: {SLOT[SLOTW], H[6], Y[17], UNIT[54], INSIDE, SKIP[24], A[2*WD], DIR[3*WD], ORG[3*W], SHADOW,
    //: PRIMARY, LIGHT, NORMAL, VALID}
    input  wire [SETUPS-1:0]          next_light_i,    // ray_i has LIGHT in the next clock
    input  wire [SETUPS*($clog2(SLOTS)-$clog2(SETUPS))-1:0] next_slot_i, // of this slot
    // from rt_slots: what rays hit; to it: a surface is blended (of the first unit), a pixel is
    // complete
    input  wire [`RT_HIT_BITS-1:0]    hit_i,
    //: {SLOT[SLOTW], KEY[W+WD+2], ID[24], FAR, PROBE, FIRST, LIT, SHADOW, MISS, HIT}
    output wire [`RT_BLEND_BITS-$clog2(SHADES)-1:0] blend_o,
    //: {SLOT[SLOTW], W_TOTAL[17], W_REFRACT[17], W_MIRROR[17], DEPTH[4], REFRACT, MIRROR, PROBE,
    //: LAST, VALID}
    output wire                       end_valid_o,
    output wire [$clog2(SLOTS)-1:0]   end_slot_o,
    // to and from rt_leaf_unit: primitive records
    output wire [SHADES*(`RT_FETCH_BITS-$clog2(SHADES))-1:0]  fetch_o,
    //: {SLOT[SLOTW], LINE[26], VALID}
    input  wire [SHADES-1:0]          fetch_ready_i,
    input  wire [SHADES*(`RT_RECORD_BITS-$clog2(SHADES))-1:0] record_i,
    //: {SLOT[SLOTW], DATA[256], VALID}
    // to rt_setup: vectors, and where and on what the next ray starts
    output wire [SHADES*(`RT_VECTOR_BITS-$clog2(SHADES))-1:0] normal_o,
    output wire [SHADES*(`RT_VECTOR_BITS-$clog2(SHADES))-1:0] vec_light_o,
    output wire [SHADES*(`RT_VECTOR_BITS-$clog2(SHADES))-1:0] bounce_o,
    //: {SLOT[SLOTW], VEC[3*WD], VALID}
    output wire [SHADES*(`RT_ORG_BITS-$clog2(SHADES))-1:0]    org_o,
    //: {SLOT[SLOTW], LIFT[3*(NG+2)], POINT[3*W], VALID}
    output wire [SHADES*(`RT_SKIP_BITS-$clog2(SHADES))-1:0]   skip_o,
    //: {SLOT[SLOTW], INSIDE, ID[24], VALID}
    // to rt_pipes: token, a shadow ray starts
    output wire [SHADES-1:0]          shadow_go_o,
    output wire [SHADES*($clog2(SLOTS)-$clog2(SHADES))-1:0]   shadow_slot_o,
    // to rt_slots: of a pixel that leaves, a clock after its slot
    input  wire                       read_i,
    input  wire [$clog2(SLOTS)-1:0]   read_slot_i,
    output wire [3*`RT_RGB_BITS-1:0]  colour_o,
    output wire [31:0]                texture_o,
    // memory of each unit, with TEXTURE
    output wire [SHADES-1:0]          mem_req_valid_o,
    input  wire [SHADES-1:0]          mem_req_ready_i,
    output wire [`RT_LINE_BITS*SHADES-1:0] mem_req_line_o,
    input  wire [SHADES-1:0]          mem_rsp_valid_i,
    output wire [SHADES-1:0]          mem_rsp_ready_o,
    input  wire [255:0]               mem_rsp_data_i,
    input  wire                       mem_rsp_error_i,
    // events of each unit and faults of this clock
    output wire [SHADES*`RT_SHADE_EVENT_BITS-1:0] event_o,
    //: {MISS, TEXEL, POWER, SATURATED, QUOTIENT, REFRACTED, REFLECTED, SHADOW, PRIMARY}
    output reg  [3:0]                 fault_o          // by number of the error, machine.def
);
    localparam SLOTW = $clog2(SLOTS);
    localparam SB   = $clog2(SHADES), NB = SLOTW - $clog2(SETUPS);
    localparam OWNW = SLOTW - SB;                      // slot of a unit's own
    localparam YB = `RT_RAY_BITS - SB, HB = `RT_HIT_BITS - SB, BB = `RT_BLEND_BITS - SB;
    localparam FB = `RT_FETCH_BITS - SB, CB = `RT_RECORD_BITS - SB, VB = `RT_VECTOR_BITS - SB;
    localparam OB = `RT_ORG_BITS - SB, KB = `RT_SKIP_BITS - SB, EB = `RT_SHADE_EVENT_BITS;
    localparam RB = 3*`RT_RGB_BITS + 32;               // what a pixel leaves with

    // ---- to each unit what its slots are told; three bits of a ray and a hit say what comes ----
    wire [SHADES*YB-1:0]       ray;
    wire [SHADES*HB-1:0]       hit;
    wire [SETUPS*(NB+1)-1:0]   next;                   // {slot, LIGHT comes}
    wire [SHADES*(OWNW+1)-1:0] next_own, read_own;     // {slot, it comes or is asked for}
    rt_route #(.WIDTH(`RT_RAY_BITS), .LOW(3), .FROM(SETUPS), .TO(SHADES)) u_rays (
        .in_i(ray_i), .out_o(ray)
    );
    rt_route #(.WIDTH(`RT_HIT_BITS), .LOW(3), .TO(SHADES)) u_hits (.in_i(hit_i), .out_o(hit));
    rt_route #(.WIDTH(SLOTW + 1), .FROM(SETUPS), .TO(SHADES)) u_nexts (
        .in_i(next), .out_o(next_own)
    );
    rt_route #(.WIDTH(SLOTW + 1), .TO(SHADES)) u_reads (
        .in_i({read_slot_i, read_i}), .out_o(read_own)
    );
    genvar s;
    generate
        for (s = 0; s < SETUPS; s = s + 1) begin : g_next
            assign next[(NB+1)*s +: NB+1] = {next_slot_i[NB*s +: NB], next_light_i[s]};
        end
    endgenerate

    wire [SHADES-1:0]      end_valid;
    wire [SHADES*OWNW-1:0] end_slot;
    wire [SHADES*BB-1:0]   blend;
    wire [SHADES*RB-1:0]   pixel;
    wire [SHADES*4-1:0]    fault;
    generate
        for (s = 0; s < SHADES; s = s + 1) begin : g_shade
            rt_shade #(
                `include "rt_effects_pass.vh"
                `include "rt_shade_pass.vh"
                .SLOTS(SLOTS >> SB), .LUTS(LUTS)
            ) u_shade (
                .clk(clk), .rst(rst), .flush_i(flush_i), .regs_i(regs_i), .light_i(light_i),
                .ray_i(ray[YB*s +: YB]), .next_light_i(next_own[(OWNW+1)*s]),
                .next_slot_i(next_own[(OWNW+1)*s + 1 +: OWNW]),
                .hit_i(hit[HB*s +: HB]), .blend_o(blend[BB*s +: BB]),
                .end_valid_o(end_valid[s]), .end_slot_o(end_slot[OWNW*s +: OWNW]),
                .fetch_o(fetch_o[FB*s +: FB]), .fetch_ready_i(fetch_ready_i[s]),
                .record_i(record_i[CB*s +: CB]),
                .normal_o(normal_o[VB*s +: VB]), .vec_light_o(vec_light_o[VB*s +: VB]),
                .bounce_o(bounce_o[VB*s +: VB]), .org_o(org_o[OB*s +: OB]),
                .skip_o(skip_o[KB*s +: KB]), .shadow_go_o(shadow_go_o[s]),
                .shadow_slot_o(shadow_slot_o[OWNW*s +: OWNW]),
                .read_i(read_own[(OWNW+1)*s]),
                .read_slot_i(read_own[(OWNW+1)*s + 1 +: OWNW]),
                .colour_o(pixel[RB*s +: 3*`RT_RGB_BITS]),
                .texture_o(pixel[RB*s + 3*`RT_RGB_BITS +: 32]),
                .mem_req_valid_o(mem_req_valid_o[s]), .mem_req_ready_i(mem_req_ready_i[s]),
                .mem_req_line_o(mem_req_line_o[`RT_LINE_BITS*s +: `RT_LINE_BITS]),
                .mem_rsp_valid_i(mem_rsp_valid_i[s]), .mem_rsp_ready_o(mem_rsp_ready_o[s]),
                .mem_rsp_data_i(mem_rsp_data_i), .mem_rsp_error_i(mem_rsp_error_i),
                .event_o(event_o[EB*s +: EB]), .fault_o(fault[4*s +: 4])
            );
        end
    endgenerate
    assign blend_o = blend[BB-1:0];

    // ---- one answer: complete pixels wait in queues; the unit whose pixel was asked for ----
    generate
        if (SHADES > 1) begin : g_join
            wire [SHADES-1:0]          room, take;
            wire [SHADES*(OWNW+1)-1:0] ends;           // {slot, it waits}
            reg  [SB-1:0]              read_q;
            for (s = 0; s < SHADES; s = s + 1) begin : g_end
                rt_fifo #(.WIDTH(OWNW), .DEPTH(SLOTS >> SB)) u_end (
                    .clk(clk), .rst(rst), .in_valid_i(end_valid[s]), .in_ready_o(room[s]),
                    .in_data_i(end_slot[OWNW*s +: OWNW]),
                    .out_valid_o(ends[(OWNW+1)*s]), .out_ready_i(take[s]),
                    .out_data_o(ends[(OWNW+1)*s + 1 +: OWNW])
                );
            end
            rt_first #(.WIDTH(OWNW + 1), .N(SHADES)) u_first (
                .in_i(ends), .ready_o(take), .out_o({end_slot_o, end_valid_o}), .ready_i(1'b1)
            );
            always @(posedge clk) if (read_i) read_q <= read_slot_i[SLOTW-1 -: SB];
            assign {texture_o, colour_o} = pixel[RB*read_q +: RB];
            wire unused = &{1'b0, room, blend};
        end else begin : g_one
            assign end_valid_o = end_valid;
            assign end_slot_o  = end_slot;
            assign {texture_o, colour_o} = pixel;
        end
    endgenerate
    integer f;
    always @* begin
        fault_o = 4'd0;
        for (f = 0; f < SHADES; f = f + 1) fault_o = fault_o | fault[4*f +: 4];
    end
endmodule
`default_nettype wire
