// rt_leaf_unit.v - leaf children of a visit: fetched, and handed to the primitives with their ray
// SPDX-License-Identifier: Apache-2.0
//   visits --> rt_candidates of a pipe --+--> leaf cache --+--> record beside ray --> rt_prim --+
//                records of rt_surface --+                 +--> rt_surface          results <---+
// Reads the records of the leaf children that a visit left through the leaf cache, one after the
// other, has each tested against its slot's ray, and hands every result to rt_trace. The same cache
// serves the primitive records of rt_shade, which has a place for each that it asks for.
// Model: sph_leaf_visit() in cmodel/trace/leaf_unit.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_leaf_unit #(
    parameter W     = 16,   // coordinate, bits
    parameter WD    = 17,   // direction component, bits
    parameter NG    = 2,    // guard bits of a hit point
    parameter SLOTS = 32,   // power of two: {pipe, slot of its own}
    parameter PIPES = 1,    // from which visits come, power of two
    parameter LINES = 64,   // leaf cache, lines
    parameter LINE_BITS = `RT_LINE_BITS, // bits of a line's number
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
    input  wire                       flush_i,    // forget the leaf cache
    input  wire [`RT_REGS_BITS-1:0]   regs_i,
    //: {BOX[6*(W+2)], N_LOOSE[24], LEAF_BASE[26], N_PRIMS[24], VISIT_LIMIT[24], MEM_LINES[26],
    //: SMOOTH_BASE[26], PRIM_BASE[26], ROOT[26], EYE[3*W], AMBIENT[48], BACKGROUND[24],
    //: N_LIGHTS[4], LEAST[9], MAX_DEPTH[4], TEX_FILTER[2], EFFECTS[EFFECT_BITS]}
    input  wire [`RT_RAY_BITS-1:0]    ray_i,      // from rt_setup
    //: {SLOT[SLOTW], H[6], Y[17], UNIT[54], INSIDE, SKIP[24], A[2*WD], DIR[3*WD], ORG[3*W], SHADOW,
    //: PRIMARY, LIGHT, NORMAL, VALID}
    input  wire [3*(NG+2)-1:0]        lift_i,     // of a ray to a light, with FACETS
    // from each rt_trace: leaf children to test
    input  wire [PIPES*(`RT_VISIT_BITS-$clog2(PIPES))-1:0] visit_i,
    //: {SLOT[SLOTW], LINE[26], LEAF[4], VALID}
    output wire [`RT_RESULT_BITS-1:0] result_o,   // to rt_trace
    //: {SLOT[SLOTW], KEY[W+WD+2], ID[24], FAR, HIT, VALID}
    // from and to rt_shade: primitive records
    input  wire [`RT_FETCH_BITS-1:0]  fetch_i,
    //: {SLOT[SLOTW], LINE[26], VALID}
    output wire                       fetch_ready_o,
    output wire [`RT_RECORD_BITS-1:0] record_o,
    //: {SLOT[SLOTW], DATA[256], VALID}
    // memory
    output wire                       mem_req_valid_o,
    input  wire                       mem_req_ready_i,
    output wire [`RT_LINE_BITS-1:0]   mem_req_line_o,
    input  wire                       mem_rsp_valid_i,
    output wire                       mem_rsp_ready_o,
    input  wire [255:0]               mem_rsp_data_i,
    input  wire                       mem_rsp_error_i,
    // events and faults of this clock
    output wire [`RT_EXACT_EVENT_BITS-1:0] event_o,
    //: {MISS, PRIM[prim_event]}
    output wire [3:0]                 fault_o     // by number of the error, machine.def
);
    localparam SLOTW = $clog2(SLOTS);
    localparam SB   = SHADOW != 0 ? 1 : 0;           // bits of a flag, if it is elaborated
    localparam IB   = INSIDE != 0 ? 1 : 0;
    wire [`RT_EFFECT_BITS-1:0] effects = regs_i[`RT_REGS_EFFECTS];
    wire       whole = FACETS != 0 && effects[`RT_EFFECT_FACETS];  // a line a leaf
    wire       prim  = fetch_i[`RT_FETCH_VALID];     // a primitive record goes first

    // ---- one candidate after the other; pipes take turns ----
    localparam PB = $clog2(PIPES);
    localparam VB = `RT_VISIT_BITS - PB;             // a visit of a pipe
    localparam CB = SLOTW - PB + 2 + `RT_LINE_BITS;  // a candidate: {slot, child, line of child 0}
    wire [PIPES-1:0] o_valid, o_take;
    wire [PIPES*CB-1:0] o_all;
    wire             req_ready;
    wire             v_valid;                        // a candidate is at hand
    wire [SLOTW-1:0] v_slot;
    wire [1:0]       pick;
    wire [`RT_LINE_BITS-1:0] v_line;
    genvar p;
    generate
        for (p = 0; p < PIPES; p = p + 1) begin : g_pipe
            rt_candidates #(.SLOTS(SLOTS >> PB)) u_candidates (
                .clk(clk), .rst(rst), .visit_i(visit_i[VB*p +: VB]),
                .out_valid_o(o_valid[p]), .out_ready_i(o_take[p] && req_ready && !prim),
                .out_slot_o(o_all[CB*p + `RT_LINE_BITS + 2 +: SLOTW-PB]),
                .out_child_o(o_all[CB*p + `RT_LINE_BITS +: 2]),
                .out_line_o(o_all[CB*p +: `RT_LINE_BITS])
            );
        end
        if (PIPES > 1) begin : g_turns
            wire [PB-1:0] one;                       // the pipe in turn
            rt_rr_arbiter #(.N(PIPES)) u_turns (
                .clk(clk), .rst(rst), .asks_i(o_valid),
                .served_i(v_valid && req_ready && !prim), .turn_o(o_take), .index_o(one)
            );
            assign v_valid = |o_valid;
            assign v_slot[SLOTW-1 -: PB] = one;
            assign {v_slot[SLOTW-PB-1:0], pick, v_line} = o_all[CB*one +: CB];
        end else begin : g_one
            assign o_take  = 1'b1;
            assign v_valid = o_valid;
            assign {v_slot, pick, v_line} = o_all;
        end
    endgenerate

    // ---- leaf cache, shared with primitive records ----
    localparam TAG = SLOTW + 2;                      // {slot, half, is prim}
    wire             c_valid, c_ready, c_half, c_prim, c_error;
    wire [SLOTW-1:0] c_slot;
    wire [255:0]     c_data;
    assign fetch_ready_o = req_ready;
    // Lines come out of block RAM, and the keys of the cache lie in one: a register between them.
    wire                     r_valid, r_ready;
    wire [`RT_LINE_BITS-1:0] r_line;
    wire [TAG-1:0]           r_tag;
    rt_reg_slice #(.WIDTH(`RT_LINE_BITS + TAG)) u_request (
        .clk(clk), .rst(rst), .in_valid_i(prim || v_valid), .in_ready_o(req_ready),
        .in_data_i(prim ? {fetch_i[`RT_FETCH_LINE], fetch_i[`RT_FETCH_SLOT], 1'b0, 1'b1}
                   : {v_line + {24'd0, whole && pick[1], whole ? pick[0] : pick[1]},
                      v_slot, pick[0] && !whole, 1'b0}),
        .out_valid_o(r_valid), .out_ready_i(r_ready), .out_data_o({r_line, r_tag})
    );
    rt_cache #(.TAG(TAG), .LINES(LINES), .PENDING(SLOTS), .LINE_BITS(LINE_BITS)) u_cache (
        .clk(clk), .rst(rst), .flush_i(flush_i), .mem_lines_i(regs_i[`RT_REGS_MEM_LINES]),
        .req_valid_i(r_valid), .req_ready_o(r_ready), .req_line_i(r_line), .req_tag_i(r_tag),
        .rsp_valid_o(c_valid), .rsp_ready_i(c_ready), .rsp_data_o(c_data),
        .rsp_tag_o({c_slot, c_half, c_prim}), .rsp_error_o(c_error),
        .mem_req_valid_o(mem_req_valid_o), .mem_req_ready_i(mem_req_ready_i),
        .mem_req_line_o(mem_req_line_o),
        .mem_rsp_valid_i(mem_rsp_valid_i), .mem_rsp_ready_o(mem_rsp_ready_o),
        .mem_rsp_data_i(mem_rsp_data_i), .mem_rsp_error_i(mem_rsp_error_i),
        .miss_o(event_o[`RT_EXACT_EVENT_MISS])
    );
    // A record for rt_shade never waits.
    reg              record_valid_q;
    reg [SLOTW-1:0]  record_slot_q;
    reg [255:0]      record_data_q;
    assign record_o[`RT_RECORD_VALID] = record_valid_q;
    assign record_o[`RT_RECORD_SLOT]  = record_slot_q;
    assign record_o[`RT_RECORD_DATA]  = record_data_q;
    always @(posedge clk) begin
        record_valid_q <= c_valid && c_prim;
        if (c_valid && c_prim) {record_slot_q, record_data_q} <= {c_slot, c_data};
        if (rst) record_valid_q <= 1'b0;
    end
    assign fault_o[`RT_ERROR_BUS_ERROR] = c_valid && c_ready && c_error;
    assign fault_o[`RT_ERROR_STACK_OVERFLOW] = 1'b0;
    assign fault_o[`RT_ERROR_VISIT_LIMIT]    = 1'b0;

    // ---- record and ray side by side ----
    reg              l_valid_q, l_error_q;
    reg [SLOTW-1:0]  l_slot_q;
    reg [127:0]      l_low_q;
    wire [127:0]     l_high;                         // with FACETS
    wire             l_ready, l_bad;
    wire             l_taken = l_valid_q && l_ready;
    // A test takes two clocks at least: a record is loaded behind the one that left, not with it.
    wire             l_load  = c_valid && !c_prim && !l_valid_q;
    assign c_ready = c_prim || !l_valid_q;
    localparam YW = 3*W + 5*WD + 24;                 // a ray; above it shadow, inside
    wire                shadow = ray_i[`RT_RAY_SHADOW];
    wire [YW+1:0]       y = {INSIDE != 0 ? {shadow, ray_i[`RT_RAY_INSIDE]} : {2{shadow}},
                             ray_i[`RT_RAY_SKIP], ray_i[`RT_RAY_A], ray_i[`RT_RAY_DIR],
                             ray_i[`RT_RAY_ORG]};
    localparam RW = YW + SB + IB;
    localparam LIFT = 3*(NG+2);
    localparam LB = FACETS != 0 && SHADOW != 0 ? LIFT : 0;
    wire [RW+LIFT-1:0]  x = {lift_i, y[RW-1:0]};
    wire [RW+LB-1:0]    l_all;
    wire [RW-1:0]       l_ray = l_all[RW-1:0];
    wire [`RT_TEST_BITS-1:0] test;
    rt_slot_ram #(.WIDTH(RW+LB), .SLOTS(SLOTS), .OLD(0)) u_ray (
        .clk(clk), .wr_en_i(ray_i[`RT_RAY_VALID]), .wr_addr_i(ray_i[`RT_RAY_SLOT]),
        .wr_data_i(x[RW+LB-1:0]),
        .rd_en_i(l_load), .rd_addr_i(c_slot), .rd_data_o(l_all)
    );
    always @(posedge clk) begin
        if (l_load) begin
            l_slot_q  <= c_slot;
            l_low_q   <= c_half ? c_data[255:128] : c_data[127:0];
            l_error_q <= c_error;
        end
        if (l_load || l_taken) l_valid_q <= l_load;
        if (rst) l_valid_q <= 1'b0;
    end
    generate
        if (FACETS != 0) begin : g_line
            reg [127:0] high_q;
            always @(posedge clk) if (l_load) high_q <= c_data[255:128];
            assign l_high = high_q;
        end else begin : g_half
            assign l_high = 128'd0;
        end
    endgenerate
    assign test[`RT_TEST_SLOT]   = l_slot_q;
    assign test[`RT_TEST_SHADOW] = SHADOW != 0 && l_ray[RW-1];
    assign test[`RT_TEST_INSIDE] = INSIDE != 0 && l_ray[YW+IB-1];
    assign test[`RT_TEST_ERROR]  = l_error_q;
    assign {test[`RT_TEST_SKIP], test[`RT_TEST_A], test[`RT_TEST_DIR], test[`RT_TEST_ORG]} =
        l_ray[YW-1:0];
    assign test[`RT_TEST_RECORD] = {l_high, l_low_q};
    generate
        if (LB != 0) begin : g_lift
            assign test[`RT_TEST_LIFT] = l_all[RW +: LIFT];
        end else begin : g_no_lift
            assign test[`RT_TEST_LIFT] = {LIFT{1'b0}};
        end
    endgenerate

    // ---- exact tests; their results are registered, the choice among them takes its time ----
    wire [`RT_RESULT_BITS-1:0] result;
    reg [`RT_RESULT_BITS-1:0]  result_q;
    assign result_o = result_q;
    always @(posedge clk) begin
        if (result[`RT_RESULT_VALID]) result_q <= result;
        result_q[`RT_RESULT_VALID] <= result[`RT_RESULT_VALID];
        if (rst) result_q[`RT_RESULT_VALID] <= 1'b0;
    end
    rt_prim #(.W(W), .WD(WD), .NG(NG), .SLOTS(SLOTS), .ROOTS(ROOTS), .ROOT_STEP(ROOT_STEP),
              .PR(PR),
              .LEAF_INTERVAL(LEAF_INTERVAL), .SHADOW(SHADOW), .INSIDE(INSIDE), .FACETS(FACETS),
              .CLEAR(CLEAR), .FACET_INTERVAL(FACET_INTERVAL)) u_prim (
        .clk(clk), .rst(rst), .effects_i(effects),
        .in_valid_i(l_valid_q), .in_ready_o(l_ready), .test_i(test),
        .result_o(result), .event_o(event_o[`RT_EXACT_EVENT_PRIM]), .bad_o(l_bad)
    );
    assign fault_o[`RT_ERROR_BAD_NODE] = l_bad;
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_leaf_cache /* verilator public_flat_rd */ =
        {(prim || v_valid) && !req_ready, (prim || v_valid) && req_ready, 5'd0,
         (prim || v_valid) && req_ready};
    wire [7:0] work_records_to_tests /* verilator public_flat_rd */ =
        {c_valid && !c_prim && l_valid_q, l_load, 4'd0, l_load, 1'b0};
    wire unused = &{1'b0, x, y, ray_i, regs_i};
endmodule
`default_nettype wire
