// rt_leaf_units.v - leaf units: each serves some pipes and shading units
// SPDX-License-Identifier: Apache-2.0
//   visits of its pipes, records for its shading units --> rt_leaf_unit --> results, records
// The top bits of a slot name its leaf unit: rt_route. Of shading units that ask one leaf unit for
// records the lowest goes first: rt_first. With one of each there is nothing here but rt_leaf_unit.
// Model: that of rt_leaf_unit
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_leaf_units #(
    parameter W     = 16,   // coordinate, bits
    parameter WD    = 17,   // direction component, bits
    parameter NG    = 2,    // guard bits of a hit point
    parameter LEAF_UNITS = 1,   // leaf units, power of two
    parameter PIPES = 1,    // 1..4
    parameter SHADES = 1,   // shading units, power of two, at least LEAF_UNITS
    parameter SETUPS = 1,   // set-up units, power of two, at most LEAF_UNITS
    parameter SLOTS = 32,   // numbers of slots, power of two
    parameter LINES = 64,   // leaf cache of each, lines
    parameter LINE_BITS = `RT_LINE_BITS, // bits of a line's number
    parameter ROOTS = 3,    // roots of each at once
    parameter ROOT_STEP = 2, // root bits a clock
    parameter PR    = 0,    // significant bits of the root, 0: all
    parameter LEAF_INTERVAL = 2, // clocks an exact test of a sphere, 2 or 4
    parameter SHADOW = 1,   // 1: shadow rays
    parameter INSIDE = 1,   // 1: rays that start inside a sphere
    parameter FACETS = 0,   // 1: triangles and planes too, a line a leaf
    parameter CLEAR  = 0,   // 1: shadow rays pass what is marked as clear
    parameter FACET_INTERVAL = 2 // clocks an exact test of a facet: 1, 2 or 4
) (
    input  wire                       clk,
    input  wire                       rst,
    input  wire                       flush_i,    // forget the leaf caches
    input  wire [`RT_REGS_BITS-1:0]   regs_i,
    //: {BOX[6*(W+2)], N_LOOSE[24], LEAF_BASE[26], N_PRIMS[24], VISIT_LIMIT[24], MEM_LINES[26],
    //: SMOOTH_BASE[26], PRIM_BASE[26], ROOT[26], EYE[3*W], AMBIENT[48], BACKGROUND[24],
    //: N_LIGHTS[4], LEAST[9], MAX_DEPTH[4], TEX_FILTER[2], EFFECTS[EFFECT_BITS]}
    // from each rt_setup
    input  wire [SETUPS*(`RT_RAY_BITS-$clog2(SETUPS))-1:0] ray_i,
    //: {SLOT[SLOTW], H[6], Y[17], UNIT[54], INSIDE, SKIP[24], A[2*WD], DIR[3*WD], ORG[3*W], SHADOW,
    //: PRIMARY, LIGHT, NORMAL, VALID}
    input  wire [SETUPS*3*(NG+2)-1:0] lift_i,     // of a ray to a light, with FACETS
    // from rt_pipes: visits of each pipe; to it: results of each unit
    input  wire [PIPES*(`RT_VISIT_BITS-$clog2(PIPES))-1:0]    visit_i,
    //: {SLOT[SLOTW], LINE[26], LEAF[4], VALID}
    output wire [LEAF_UNITS*(`RT_RESULT_BITS-$clog2(LEAF_UNITS))-1:0] result_o,
    //: {SLOT[SLOTW], KEY[W+WD+2], ID[24], FAR, HIT, VALID}
    // from and to each rt_shade: primitive records
    input  wire [SHADES*(`RT_FETCH_BITS-$clog2(SHADES))-1:0]  fetch_i,
    //: {SLOT[SLOTW], LINE[26], VALID}
    output wire [SHADES-1:0]          fetch_ready_o,
    output wire [SHADES*(`RT_RECORD_BITS-$clog2(SHADES))-1:0] record_o,
    //: {SLOT[SLOTW], DATA[256], VALID}
    // memory, of each unit
    output wire [LEAF_UNITS-1:0]          mem_req_valid_o,
    input  wire [LEAF_UNITS-1:0]          mem_req_ready_i,
    output wire [`RT_LINE_BITS*LEAF_UNITS-1:0] mem_req_line_o,
    input  wire [LEAF_UNITS-1:0]          mem_rsp_valid_i,
    output wire [LEAF_UNITS-1:0]          mem_rsp_ready_o,
    input  wire [255:0]               mem_rsp_data_i,
    input  wire                       mem_rsp_error_i,
    // events of each unit and faults of this clock
    output wire [LEAF_UNITS*`RT_EXACT_EVENT_BITS-1:0] event_o,
    //: {MISS, PRIM[prim_event]}
    output reg  [3:0]                 fault_o     // by number of the error, machine.def
);
    localparam PB = $clog2(PIPES), XB = $clog2(LEAF_UNITS), SB = $clog2(SHADES);
    localparam UB = $clog2(SETUPS);
    localparam VB = `RT_VISIT_BITS - PB;              // a visit of a pipe
    localparam FB = `RT_FETCH_BITS - SB;              // of a shading unit
    localparam FX = `RT_FETCH_BITS - XB, CX = `RT_RECORD_BITS - XB;  // of a leaf unit
    localparam LIFT = 3*(NG+2);
    localparam YB = `RT_RAY_BITS - XB, RB = `RT_RESULT_BITS - XB, EB = `RT_EXACT_EVENT_BITS;
    localparam N  = 1 << (PB - XB), M = SHADES / LEAF_UNITS;  // pipes, shading units of a leaf unit
    localparam [(N*LEAF_UNITS-PIPES+1)*VB-1:0] NOBODY = 0;    // of numbers for four pipes three are
    wire [N*LEAF_UNITS*VB+VB-1:0] all = {NOBODY, visit_i};
    wire [LEAF_UNITS*YB-1:0] ray;
    wire [LEAF_UNITS*CX-1:0] record;
    wire [LEAF_UNITS*4-1:0]  fault;
    rt_route #(.WIDTH(`RT_RAY_BITS), .FROM(SETUPS), .TO(LEAF_UNITS)) u_rays (
        .in_i(ray_i), .out_o(ray)
    );
    rt_route #(.WIDTH(`RT_RECORD_BITS), .FROM(LEAF_UNITS), .TO(SHADES)) u_records (
        .in_i(record), .out_o(record_o)
    );
    genvar x;
    generate
        for (x = 0; x < LEAF_UNITS; x = x + 1) begin : g_exact
            localparam U = x >> (XB - UB);           // its set-up unit
            wire [FX-1:0] fetch;
            wire          fetch_ready;
            rt_leaf_unit #(.W(W), .WD(WD), .NG(NG), .SLOTS(SLOTS >> XB), .PIPES(N), .LINES(LINES),
                           .LINE_BITS(LINE_BITS),
                       .ROOTS(ROOTS), .ROOT_STEP(ROOT_STEP), .PR(PR),
                       .LEAF_INTERVAL(LEAF_INTERVAL), .SHADOW(SHADOW), .INSIDE(INSIDE),
                       .FACETS(FACETS), .CLEAR(CLEAR), .FACET_INTERVAL(FACET_INTERVAL)) u_exact (
                .clk(clk), .rst(rst), .flush_i(flush_i), .regs_i(regs_i),
                .ray_i(ray[YB*x +: YB]), .lift_i(lift_i[LIFT*U +: LIFT]),
                .visit_i(all[N*VB*x +: N*VB]), .result_o(result_o[RB*x +: RB]),
                .fetch_i(fetch), .fetch_ready_o(fetch_ready), .record_o(record[CX*x +: CX]),
                .mem_req_valid_o(mem_req_valid_o[x]), .mem_req_ready_i(mem_req_ready_i[x]),
                .mem_req_line_o(mem_req_line_o[`RT_LINE_BITS*x +: `RT_LINE_BITS]),
                .mem_rsp_valid_i(mem_rsp_valid_i[x]), .mem_rsp_ready_o(mem_rsp_ready_o[x]),
                .mem_rsp_data_i(mem_rsp_data_i), .mem_rsp_error_i(mem_rsp_error_i),
                .event_o(event_o[EB*x +: EB]), .fault_o(fault[4*x +: 4])
            );
            rt_first #(.WIDTH(FB), .N(M)) u_fetch (
                .in_i(fetch_i[FB*M*x +: FB*M]), .ready_o(fetch_ready_o[M*x +: M]),
                .out_o(fetch), .ready_i(fetch_ready)
            );
        end
    endgenerate
    integer f;
    always @* begin
        fault_o = 4'd0;
        for (f = 0; f < LEAF_UNITS; f = f + 1) fault_o = fault_o | fault[4*f +: 4];
    end
    wire unused = &{1'b0, all};
endmodule
`default_nettype wire
