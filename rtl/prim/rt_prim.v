// rt_prim.v - primitives: gives a leaf record to the unit of its kind, takes the units' results
// SPDX-License-Identifier: Apache-2.0
//   test --+--> rt_sphere --+--> result
//          +--> rt_facet  --+
// No module outside this folder asks which kind a primitive is. Each kind has the same ports: a
// test, a result with the slot and the id of the test, valid and ready of both. It may take any
// number of clocks and answer in any order, and may put a result before one that waits. A record
// of no kind goes to the spheres, which count it as a miss, and so does what is clear to a ray
// towards a light. An urgent result of a sphere goes
// first, then facets, then other spheres; rt_trace takes one a clock.
// Model: sph_prim_of() in cmodel/prim/prim.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_prim #(
    parameter W     = 16,   // coordinate, bits
    parameter WD    = 17,   // direction component, bits
    parameter NG    = 2,    // guard bits of a hit point
    parameter SLOTS = 32,   // power of two
    parameter ROOTS = 3,    // roots at once
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
    input  wire [`RT_EFFECT_BITS-1:0] effects_i, // register EFFECTS
    // from rt_leaf_unit
    input  wire                       in_valid_i,
    output wire                       in_ready_o,
    input  wire [`RT_TEST_BITS-1:0]   test_i,
    //: {SLOT[SLOTW], RECORD[256], LIFT[3*(NG+2)], SKIP[24], A[2*WD], DIR[3*WD], ORG[3*W], ERROR,
    //: INSIDE, SHADOW}
    // to rt_trace
    output wire [`RT_RESULT_BITS-1:0] result_o,
    //: {SLOT[SLOTW], KEY[W+WD+2], ID[24], FAR, HIT, VALID}
    // events and faults of this clock
    output wire [`RT_PRIM_EVENT_BITS-1:0] event_o,
    //: {DIVIDE, ROOT, FACET, LEAF}
    output wire                       bad_o       // a record of no kind is taken
);
    // ---- units, and whose record it is: of half a line, or with an error, the spheres' ----
    localparam SPHERE = 0, FACET = 1, UNITS = FACETS != 0 ? 2 : 1;
    localparam [UNITS-1:0] SPHERES = 1;
    wire [255:0] record = test_i[`RT_TEST_RECORD];
    wire         error  = test_i[`RT_TEST_ERROR];
    wire         whole  = FACETS != 0 && effects_i[`RT_EFFECT_FACETS] && !error;
    wire [7:0]   head   = {record[`RT_FACET_KIND_LSB +: `RT_FACET_KIND_BITS],
                           record[`RT_FACET_MORE_LSB +: `RT_FACET_MORE_BITS]};
    function kind_is(input [7:0] of, input [7:0] kind);  // machine.def: kinds from 3 on are longer
        kind_is = kind < 8'd3 ? of[7:6] == kind[1:0] : of == 8'hc0 + kind - 8'd3;
    endfunction
    wire [UNITS-1:0] mine, to, ready;
    assign mine[SPHERE] = !whole || kind_is(head, `RT_SPHERE);
    wire   none = mine == {UNITS{1'b0}};
    wire   clear = CLEAR != 0 && effects_i[`RT_EFFECT_CLEAR] && test_i[`RT_TEST_SHADOW] &&
                   record[mine[SPHERE] ? `RT_LEAF_CLEAR_LSB : `RT_FACET_CLEAR_LSB];
    assign to   = none || clear ? SPHERES : mine;
    assign in_ready_o = |(to & ready);
    wire   taken = in_valid_i && in_ready_o;
    assign bad_o = taken && none;
    assign event_o[`RT_PRIM_EVENT_LEAF] = taken && mine[SPHERE];

    // ---- results: urgent ones first, then the last unit first ----
    localparam RB = `RT_RESULT_BITS;
    wire [UNITS*RB-1:0] results;
    wire [UNITS-1:0]    valid, urgent;
    reg  [UNITS-1:0]    give;                        // at most one
    reg  [RB-1:0]       result;
    integer             u;
    always @* begin
        give   = {UNITS{1'b0}};
        result = results[RB*SPHERE +: RB];           // whose VALID is low if nothing is there
        for (u = 0; u < UNITS; u = u + 1)
            if (urgent[u] || (valid[u] && urgent == {UNITS{1'b0}})) begin
                give    = {UNITS{1'b0}};
                give[u] = 1'b1;
                result  = results[RB*u +: RB];
            end
    end
    assign result_o = result;

    // ---- the units ----
    wire [RB-1:0] sphere_result;
    rt_sphere #(.W(W), .WD(WD), .NG(NG), .SLOTS(SLOTS), .ROOTS(ROOTS),
                .ROOT_STEP(ROOT_STEP), .PR(PR), .INTERVAL(LEAF_INTERVAL), .SHADOW(SHADOW),
                .INSIDE(INSIDE)) u_sphere (
        .clk(clk), .rst(rst), .inside_on_i(effects_i[`RT_EFFECT_INSIDE]),
        .in_valid_i(in_valid_i && to[SPHERE]), .in_ready_o(ready[SPHERE]), .test_i(test_i),
        .in_miss_i(error || none || clear),
        .result_o(sphere_result), .result_ready_i(give[SPHERE]), .urgent_o(urgent[SPHERE]),
        .root_o(event_o[`RT_PRIM_EVENT_ROOT])
    );
    assign valid[SPHERE] = sphere_result[`RT_RESULT_VALID];
    assign results[RB*SPHERE +: RB] = sphere_result;
    generate
        if (FACETS != 0) begin : g_facet
            wire [RB-1:0] facet_result;
            assign mine[FACET] = whole && (kind_is(head, `RT_TRIANGLE) || kind_is(head, `RT_PLANE));
            assign event_o[`RT_PRIM_EVENT_FACET] = taken && mine[FACET];
            rt_facet #(.W(W), .WD(WD), .NG(NG), .SLOTS(SLOTS), .SHADOW(SHADOW),
                       .INTERVAL(FACET_INTERVAL)) u_facet (
                .clk(clk), .rst(rst),
                .in_valid_i(in_valid_i && to[FACET]), .in_ready_o(ready[FACET]), .test_i(test_i),
                .result_o(facet_result), .result_ready_i(give[FACET]),
                .divide_o(event_o[`RT_PRIM_EVENT_DIVIDE])
            );
            assign urgent[FACET] = 1'b0;
            assign valid[FACET]  = facet_result[`RT_RESULT_VALID];
            assign results[RB*FACET +: RB] = facet_result;
        end else begin : g_no_facet
            assign event_o[`RT_PRIM_EVENT_FACET]  = 1'b0;
            assign event_o[`RT_PRIM_EVENT_DIVIDE] = 1'b0;
        end
    endgenerate
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_results_of_tests /* verilator public_flat_rd */ =
        {|(valid & ~give), |give, 5'd0, |give};
    wire unused = &{1'b0, record, effects_i, head};
endmodule
`default_nettype wire
