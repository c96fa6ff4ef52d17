// rt_pipes.v - traversal pipes: each has its own slots, queues, stack and node cache
// SPDX-License-Identifier: Apache-2.0
//   ray, shadow_go, result --> rt_trace of the slot --+--> visits, of each pipe
//                                                     +--> queue --> done, one a clock
// The number of a slot is {pipe, slot of its own}, so no ray ever changes its pipe, and what it
// visits depends on the ray alone. Pipes whose rays are done take turns.
// With one pipe there is nothing here but rt_trace.
// Model: that of rt_trace
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_pipes #(
    parameter W     = 16,   // coordinate, bits
    parameter WD    = 17,   // direction component, bits
    parameter FW    = 14,   // filter coordinate, bits
    parameter PIPES = 1,    // 1..4
    parameter LEAF_UNITS = 1,   // leaf units that serve them, power of two
    parameter SHADES = 1,   // shading units, power of two
    parameter SETUPS = 1,   // set-up units, power of two, at most LEAF_UNITS
    parameter SLOTS = 32,   // numbers of slots, power of two: {pipe, slot of its own}
    parameter STACK = 16,   // sibling groups waiting per ray, power of two
    parameter LINES = 256,  // node cache of each pipe, lines
    parameter LINE_BITS = `RT_LINE_BITS, // bits of a line's number
    parameter SHADOW = 1,   // 1: shadow rays
    parameter FIRST = 1,    // 1: primary rays may end with their first hit
    parameter FARS  = 1,    // 1: hits that are far
    parameter FACETS = 0,   // 1: a leaf child may have a whole line
    parameter SQUARES = 0,  // 1: squares of the node filter in LUTs
    parameter LUTS  = 0,    // LUT cells that a block RAM is worth, rt_slot_ram
    parameter ACCEL = 0     // 0: nodes of four spheres, 1: BIH, 2: nodes of four boxes
) (
    input  wire                       clk,
    input  wire                       rst,
    input  wire                       flush_i,        // forget the node caches
    input  wire [`RT_REGS_BITS-1:0]   regs_i,
    //: {BOX[6*(W+2)], N_LOOSE[24], LEAF_BASE[26], N_PRIMS[24], VISIT_LIMIT[24], MEM_LINES[26],
    //: SMOOTH_BASE[26], PRIM_BASE[26], ROOT[26], EYE[3*W], AMBIENT[48], BACKGROUND[24],
    //: N_LIGHTS[4], LEAST[9], MAX_DEPTH[4], TEX_FILTER[2], EFFECTS[EFFECT_BITS]}
    // from each rt_setup: a new ray of its slots, with its token unless it is a shadow ray
    input  wire [SETUPS*(`RT_RAY_BITS-$clog2(SETUPS))-1:0] ray_i,
    //: {SLOT[SLOTW], H[6], Y[17], UNIT[54], INSIDE, SKIP[24], A[2*WD], DIR[3*WD], ORG[3*W], SHADOW,
    //: PRIMARY, LIGHT, NORMAL, VALID}
    input  wire [SETUPS*`RT_FILTER_BITS-1:0] filter_i,
    //: {DEPTH[FW+1], SHIFT[6], SCALE[17], NEGATIVE, AXIS[2], ORG[3*FW]}
    input  wire [SETUPS*(`RT_ACROSS_BITS-$clog2(SETUPS))-1:0] across_i,  // behind its ray
    //: {SLOT[SLOTW], Q[54], P_B[18], P_A[18], LEAST[2], VALID}
    input  wire                       ray_again_i,    // the repeated primary ray of its pixel
    // from each rt_shade: a shadow ray of its slots starts
    input  wire [SHADES-1:0]          shadow_go_i,
    input  wire [SHADES*($clog2(SLOTS)-$clog2(SHADES))-1:0] shadow_slot_i,
    // to and from rt_leaf_unit: visits of each pipe, results of each unit, for slots of its own
    output wire [PIPES*(`RT_VISIT_BITS-$clog2(PIPES))-1:0]    visit_o,
    //: {SLOT[SLOTW], LINE[26], LEAF[4], VALID}
    input  wire [LEAF_UNITS*(`RT_RESULT_BITS-$clog2(LEAF_UNITS))-1:0] result_i,
    //: {SLOT[SLOTW], KEY[W+WD+2], ID[24], FAR, HIT, VALID}
    // to rt_slots: a ray is done, a clock later how
    output wire                       done_valid_o,
    output wire [$clog2(SLOTS)-1:0]   done_slot_o,
    output wire [`RT_DONE_BITS-1:0]   done_o,
    //: {KEY[W+WD+2], ID[24], FARS[2], FAR, FIRST, PRIMARY, SHADOW, FOUND}
    // to rt_slots: visits of a pixel, a clock after its slot
    input  wire                       visits_read_i,
    input  wire [$clog2(SLOTS)-1:0]   visits_slot_i,
    output wire [`RT_VISITS_BITS-1:0] visits_o,
    // memory, of each pipe
    output wire [PIPES-1:0]           mem_req_valid_o,
    input  wire [PIPES-1:0]           mem_req_ready_i,
    output wire [`RT_LINE_BITS*PIPES-1:0] mem_req_line_o,
    input  wire [PIPES-1:0]           mem_rsp_valid_i,
    output wire [PIPES-1:0]           mem_rsp_ready_o,
    input  wire [255:0]               mem_rsp_data_i,
    input  wire                       mem_rsp_error_i,
    // events of each pipe and faults of this clock
    output wire [PIPES*`RT_TRACE_EVENT_BITS-1:0] event_o,
    //: {BUBBLE, MISS, TESTS[3], VISIT, ISSUED}
    output reg  [3:0]                 fault_o         // by number of the error, machine.def
);
    localparam SLOTW = $clog2(SLOTS);
    localparam PB = $clog2(PIPES), OWNW = SLOTW - PB; // slot of a pipe's own
    localparam YB = `RT_RAY_BITS - PB, AB = `RT_ACROSS_BITS - PB;    // of a pipe
    localparam RB = `RT_RESULT_BITS - PB, VB = `RT_VISIT_BITS - PB;
    localparam FB = `RT_FILTER_BITS, DB = `RT_DONE_BITS, NB = `RT_VISITS_BITS;
    localparam EB = `RT_TRACE_EVENT_BITS;
    localparam SB = $clog2(SHADES), GB = SLOTW - SB;  // slot of a shading unit's own

    // ---- to each pipe what its slots are told ----
    wire [PIPES*YB-1:0]       ray;
    wire [PIPES*AB-1:0]       across;
    wire [PIPES*RB-1:0]       result;
    wire [SHADES*(GB+1)-1:0]  shadow;                 // {slot, it starts}
    wire [PIPES*(OWNW+1)-1:0] shadow_own, visits_own; // {slot, it starts or is asked for}
    rt_route #(.WIDTH(`RT_RAY_BITS), .FROM(SETUPS), .TO(PIPES)) u_rays (
        .in_i(ray_i), .out_o(ray)
    );
    rt_route #(.WIDTH(`RT_ACROSS_BITS), .FROM(SETUPS), .TO(PIPES)) u_axes (
        .in_i(across_i), .out_o(across)
    );
    rt_route #(.WIDTH(`RT_RESULT_BITS), .FROM(LEAF_UNITS), .TO(PIPES)) u_results (
        .in_i(result_i), .out_o(result)
    );
    rt_route #(.WIDTH(SLOTW + 1), .FROM(SHADES), .TO(PIPES)) u_shadows (
        .in_i(shadow), .out_o(shadow_own)
    );
    rt_route #(.WIDTH(SLOTW + 1), .TO(PIPES)) u_visits (
        .in_i({visits_slot_i, visits_read_i}), .out_o(visits_own)
    );
    genvar p;
    generate
        for (p = 0; p < SHADES; p = p + 1) begin : g_shadow
            assign shadow[(GB+1)*p +: GB+1] = {shadow_slot_i[GB*p +: GB], shadow_go_i[p]};
        end
    endgenerate

    wire [PIPES-1:0]      done_valid, done_take;
    wire [PIPES*OWNW-1:0] done_slot;
    wire [PIPES*DB-1:0]   done;
    wire [PIPES*NB-1:0]   visits;
    wire [PIPES*4-1:0]    fault;
    generate
        for (p = 0; p < PIPES; p = p + 1) begin : g_pipe
            localparam U = p >> (PB - $clog2(SETUPS));   // its set-up unit
            rt_trace #(.W(W), .WD(WD), .FW(FW), .SLOTS(SLOTS >> PB), .STACK(STACK), .LINES(LINES),
                       .LINE_BITS(LINE_BITS),
                       .SHADOW(SHADOW), .FIRST(FIRST), .FARS(FARS), .FACETS(FACETS),
                       .SQUARES(SQUARES), .LUTS(LUTS), .ACCEL(ACCEL),
                       .WAITS(PIPES > 1 ? 1 : 0)) u_trace (
                .clk(clk), .rst(rst), .flush_i(flush_i), .regs_i(regs_i),
                .ray_i(ray[YB*p +: YB]), .filter_i(filter_i[FB*U +: FB]),
                .across_i(across[AB*p +: AB]), .ray_again_i(ray_again_i),
                .shadow_go_i(shadow_own[(OWNW+1)*p]),
                .shadow_slot_i(shadow_own[(OWNW+1)*p + 1 +: OWNW]),
                .visit_o(visit_o[VB*p +: VB]), .result_i(result[RB*p +: RB]),
                .done_valid_o(done_valid[p]), .done_ready_i(done_take[p]),
                .done_slot_o(done_slot[OWNW*p +: OWNW]), .done_o(done[DB*p +: DB]),
                .visits_read_i(visits_own[(OWNW+1)*p]),
                .visits_slot_i(visits_own[(OWNW+1)*p + 1 +: OWNW]),
                .visits_o(visits[NB*p +: NB]),
                .mem_req_valid_o(mem_req_valid_o[p]), .mem_req_ready_i(mem_req_ready_i[p]),
                .mem_req_line_o(mem_req_line_o[`RT_LINE_BITS*p +: `RT_LINE_BITS]),
                .mem_rsp_valid_i(mem_rsp_valid_i[p]), .mem_rsp_ready_o(mem_rsp_ready_o[p]),
                .mem_rsp_data_i(mem_rsp_data_i), .mem_rsp_error_i(mem_rsp_error_i),
                .event_o(event_o[EB*p +: EB]), .fault_o(fault[4*p +: 4])
            );
        end
    endgenerate

    // ---- one answer: of pipes whose ray is done in turn, of the one whose visits are asked ----
    generate
        if (PIPES > 1) begin : g_join
            wire [PB-1:0] one;
            reg  [PB-1:0] done_q, visits_q;
            rt_rr_arbiter #(.N(PIPES)) u_turns (
                .clk(clk), .rst(rst), .asks_i(done_valid), .served_i(|done_valid),
                .turn_o(done_take), .index_o(one)
            );
            always @(posedge clk) begin
                done_q <= one;
                if (visits_read_i) visits_q <= visits_slot_i[SLOTW-1 -: PB];
            end
            assign done_valid_o = |done_valid;
            assign done_slot_o  = {one, done_slot[OWNW*one +: OWNW]};
            assign done_o       = done[DB*done_q +: DB];
            assign visits_o     = visits[NB*visits_q +: NB];
        end else begin : g_one
            assign done_take    = 1'b1;
            assign done_valid_o = done_valid;
            assign done_slot_o  = done_slot;
            assign done_o       = done;
            assign visits_o     = visits;
        end
    endgenerate
    integer f;
    always @* begin
        fault_o = 4'd0;
        for (f = 0; f < PIPES; f = f + 1) fault_o = fault_o | fault[4*f +: 4];
    end
endmodule
`default_nettype wire
