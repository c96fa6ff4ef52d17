// rt_trace.v - traversal: rays go through the tree, leaf children to their test, first hits out
// SPDX-License-Identifier: Apache-2.0
//   ray -> rt_traverse -+- leaves: rt_leaf_unit, rt_closest_hit -+-> rt_traversal_stack -> done
//            ^          +- none ---------------------------------+       |
//            +-------------------------- next node ----------------------+
// With ACCEL rt_bih takes the place of rt_traverse and rt_traversal_stack. One token a slot goes
// round, so queues of SLOTS words never fill. Visits that had leaves go first: they waited longest.
// Model: sph_traverse() in cmodel/trace/traverse.c, sph_bih_walk() in cmodel/trace/bih_walk.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_trace #(
    parameter W     = 16,   // coordinate, bits
    parameter WD    = 17,   // direction component, bits
    parameter FW    = 14,   // filter coordinate, bits
    parameter SLOTS = 32,   // rays in flight, power of two
    parameter STACK = 16,   // sibling groups waiting per ray, power of two
    parameter LINES = 256,  // node cache, lines
    parameter LINE_BITS = `RT_LINE_BITS, // bits of a line's number
    parameter SHADOW = 1,   // 1: shadow rays
    parameter FIRST = 1,    // 1: primary rays may end with their first hit
    parameter FARS  = 1,    // 1: hits that are far
    parameter FACETS = 0,   // 1: a leaf child may have a whole line
    parameter SQUARES = 0,  // 1: squares of the node filter in LUTs
    parameter LUTS  = 0,    // LUT cells that a block RAM is worth, rt_slot_ram
    parameter ACCEL = 0,    // 0: nodes of four spheres, 1: BIH, 2: nodes of four boxes
    parameter WAITS = 0     // 1: rays that are done wait for done_ready_i
) (
    input  wire                       clk,
    input  wire                       rst,
    input  wire                       flush_i,        // forget the node cache
    input  wire [`RT_REGS_BITS-1:0]   regs_i,
    //: {BOX[6*(W+2)], N_LOOSE[24], LEAF_BASE[26], N_PRIMS[24], VISIT_LIMIT[24], MEM_LINES[26],
    //: SMOOTH_BASE[26], PRIM_BASE[26], ROOT[26], EYE[3*W], AMBIENT[48], BACKGROUND[24],
    //: N_LIGHTS[4], LEAST[9], MAX_DEPTH[4], TEX_FILTER[2], EFFECTS[EFFECT_BITS]}
    // from rt_setup: a new ray, with its token unless it is a shadow ray
    input  wire [`RT_RAY_BITS-1:0]    ray_i,
    //: {SLOT[SLOTW], H[6], Y[17], UNIT[54], INSIDE, SKIP[24], A[2*WD], DIR[3*WD], ORG[3*W], SHADOW,
    //: PRIMARY, LIGHT, NORMAL, VALID}
    input  wire [`RT_FILTER_BITS-1:0] filter_i,
    //: {DEPTH[FW+1], SHIFT[6], SCALE[17], NEGATIVE, AXIS[2], ORG[3*FW]}
    input  wire [`RT_ACROSS_BITS-1:0] across_i,       // behind its ray; without ACCEL
    //: {SLOT[SLOTW], Q[54], P_B[18], P_A[18], LEAST[2], VALID}
    input  wire                       ray_again_i,    // the repeated primary ray of its pixel
    // from rt_shade: a shadow ray starts
    input  wire                       shadow_go_i,
    input  wire [$clog2(SLOTS)-1:0]   shadow_slot_i,
    // to and from rt_leaf_unit
    output wire [`RT_VISIT_BITS-1:0]  visit_o,
    //: {SLOT[SLOTW], LINE[26], LEAF[4], VALID}
    input  wire [`RT_RESULT_BITS-1:0] result_i,
    //: {SLOT[SLOTW], KEY[W+WD+2], ID[24], FAR, HIT, VALID}
    // to rt_slots: a ray is done, a clock later how
    output wire                       done_valid_o,
    input  wire                       done_ready_i,   // with WAITS
    output wire [$clog2(SLOTS)-1:0]   done_slot_o,
    output wire [`RT_DONE_BITS-1:0]   done_o,
    //: {KEY[W+WD+2], ID[24], FARS[2], FAR, FIRST, PRIMARY, SHADOW, FOUND}
    // to rt_slots: visits of a pixel, a clock after its slot
    input  wire                       visits_read_i,
    input  wire [$clog2(SLOTS)-1:0]   visits_slot_i,
    output wire [`RT_VISITS_BITS-1:0]  visits_o,
    // memory
    output wire                       mem_req_valid_o,
    input  wire                       mem_req_ready_i,
    output wire [`RT_LINE_BITS-1:0]   mem_req_line_o,
    input  wire                       mem_rsp_valid_i,
    output wire                       mem_rsp_ready_o,
    input  wire [255:0]               mem_rsp_data_i,
    input  wire                       mem_rsp_error_i,
    // events and faults of this clock
    output wire [`RT_TRACE_EVENT_BITS-1:0] event_o,
    //: {BUBBLE, MISS, TESTS[3], VISIT, ISSUED}
    output wire [3:0]                 fault_o         // by number of the error, machine.def
);
    localparam SLOTW = $clog2(SLOTS);
    localparam LW = ACCEL == 1 ? `RT_BIH_T - 1 : ACCEL == 2 ? 14 : FW;  // depth limit, bits - 1

    // ---- how a ray goes ----
    wire [`RT_EFFECT_BITS-1:0] effects = regs_i[`RT_REGS_EFFECTS];
    wire             pixel   = ray_i[`RT_RAY_PRIMARY] && !ray_again_i; // visits start at 0
    wire             first   = FIRST != 0 && effects[`RT_EFFECT_FIRST] && pixel;

    // ---- pipe ----
    wire             read_valid, next_read, next_hit, next_ends, tested_valid, ended_valid;
    wire [SLOTW-1:0] read_slot, next_slot, tested_slot, ended_slot;
    wire [2:0]       count;                                  // leaf children of a visit
    wire [LW:0]      limit, read_depth, next_depth;          // what lies deeper does not matter
    generate
        if (ACCEL != 1) begin : g_four
            wire [`RT_FOUND_BITS-1:0] found;
            wire             issue_valid;
            wire             found_valid = found[`RT_FOUND_VALID];
            wire [SLOTW-1:0] issue_slot;
            wire [`RT_LINE_BITS-1:0] issue_line;
            wire [3:0]       leaf = visit_o[`RT_VISIT_LEAF];
            wire [`RT_TRACE_EVENT_BITS-1:0] events;
            wire [3:0]       faults;
            wire             bubble, overflow;
            if (ACCEL == 2) begin : g_boxes
                // a shadow ray goes to the key of its light
                localparam TW = `RT_BIH_T;
                localparam T  = W + WD + 2 > TW ? W + WD + 2 - TW : 0;
                wire [2*WD+TW-1:0] light = {{TW{1'b0}}, ray_i[`RT_RAY_A]} >> T;
                wire             far = !ray_i[`RT_RAY_SHADOW] || |light[2*WD+TW-1:TW];
                rt_box_depth u_limit (
                    .time_i(far ? {TW{1'b1}} : light[TW-1:0]), .depth_o(limit)
                );
            end else begin : g_spheres
                assign limit = filter_i[`RT_FILTER_DEPTH];
            end
            assign count = {2'b0, leaf[0]} + {2'b0, leaf[1]} + {2'b0, leaf[2]} + {2'b0, leaf[3]};
            rt_traverse #(.W(W), .WD(WD), .FW(FW), .SLOTS(SLOTS), .LINES(LINES),
                          .LINE_BITS(LINE_BITS), .SHADOW(SHADOW), .FIRST(FIRST),
                          .FACETS(FACETS), .SQUARES(SQUARES), .LUTS(LUTS),
                          .BOXES(ACCEL == 2 ? 1 : 0)) u_traverse (
                .clk(clk), .rst(rst), .flush_i(flush_i), .regs_i(regs_i),
                .ray_i(ray_i), .filter_i(filter_i), .across_i(across_i),
                .first_i(first), .pixel_i(pixel),
                .shadow_go_i(shadow_go_i), .shadow_slot_i(shadow_slot_i),
                .next_valid_i(issue_valid), .next_slot_i(issue_slot), .next_line_i(issue_line),
                .depth_read_o(read_valid), .depth_slot_o(read_slot), .depth_i(read_depth),
                .found_o(found), .visit_o(visit_o),
                .visits_read_i(visits_read_i), .visits_slot_i(visits_slot_i),
                .visits_o(visits_o),
                .mem_req_valid_o(mem_req_valid_o), .mem_req_ready_i(mem_req_ready_i),
                .mem_req_line_o(mem_req_line_o),
                .mem_rsp_valid_i(mem_rsp_valid_i), .mem_rsp_ready_o(mem_rsp_ready_o),
                .mem_rsp_data_i(mem_rsp_data_i), .mem_rsp_error_i(mem_rsp_error_i),
                .event_o(events), .fault_o(faults)
            );

            // ---- queues of visits, those with leaves first ----
            wire             leafy_valid, plain_valid, leafy_in, plain_in, next_ready;
            wire [SLOTW-1:0] leafy_slot, plain_slot;
            rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_leafy (
                .clk(clk), .rst(rst), .in_valid_i(tested_valid), .in_ready_o(leafy_in),
                .in_data_i(tested_slot),
                .out_valid_o(leafy_valid), .out_ready_i(next_ready), .out_data_o(leafy_slot)
            );
            rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_plain (
                .clk(clk), .rst(rst), .in_valid_i(found_valid && !visit_o[`RT_VISIT_VALID]),
                .in_ready_o(plain_in), .in_data_i(found[`RT_FOUND_SLOT]),
                .out_valid_o(plain_valid), .out_ready_i(next_ready && !leafy_valid),
                .out_data_o(plain_slot)
            );

            // ---- the next node ----
            rt_traversal_stack #(.FW(LW), .SLOTS(SLOTS), .DEPTH(STACK), .LUTS(LUTS),
                      .ENDS(SHADOW != 0 || FIRST != 0 ? 1 : 0)) u_next (
                .clk(clk), .rst(rst),
                .found_valid_i(found_valid), .found_slot_i(found[`RT_FOUND_SLOT]),
                .found_base_i(found[`RT_FOUND_BASE]), .found_count_i(found[`RT_FOUND_COUNT]),
                .found_list_i(found[`RT_FOUND_LIST]), .found_fresh_i(found[`RT_FOUND_FRESH]),
                .found_kill_i(found[`RT_FOUND_KILL]),
                .in_valid_i(leafy_valid || plain_valid), .in_ready_o(next_ready),
                .in_slot_i(leafy_valid ? leafy_slot : plain_slot),
                .read_o(next_read), .slot_o(next_slot), .depth_i(next_depth), .hit_i(next_hit),
                .ends_i(next_ends),
                .issue_valid_o(issue_valid), .issue_slot_o(issue_slot), .issue_line_o(issue_line),
                .done_valid_o(ended_valid), .done_slot_o(ended_slot),
                .bubble_o(bubble), .overflow_o(overflow)
            );
            assign event_o[`RT_TRACE_EVENT_ISSUED] = events[`RT_TRACE_EVENT_ISSUED];
            assign event_o[`RT_TRACE_EVENT_VISIT]  = events[`RT_TRACE_EVENT_VISIT];
            assign event_o[`RT_TRACE_EVENT_TESTS]  = events[`RT_TRACE_EVENT_TESTS];
            assign event_o[`RT_TRACE_EVENT_MISS]   = events[`RT_TRACE_EVENT_MISS];
            assign event_o[`RT_TRACE_EVENT_BUBBLE] = bubble;
            assign fault_o[`RT_ERROR_BAD_NODE]     = faults[`RT_ERROR_BAD_NODE];
            assign fault_o[`RT_ERROR_STACK_OVERFLOW] = overflow;
            assign fault_o[`RT_ERROR_VISIT_LIMIT]  = faults[`RT_ERROR_VISIT_LIMIT];
            assign fault_o[`RT_ERROR_BUS_ERROR]    = faults[`RT_ERROR_BUS_ERROR];
            wire unused = &{1'b0, leafy_in, plain_in, events, faults};
        end else begin : g_bih
            assign {read_valid, read_slot} = {(SLOTW+1){1'b0}};
            rt_bih #(.W(W), .WD(WD), .SLOTS(SLOTS), .LINES(LINES),
                     .LINE_BITS(LINE_BITS), .SHADOW(SHADOW), .FACETS(FACETS)) u_bih (
                .clk(clk), .rst(rst), .flush_i(flush_i), .regs_i(regs_i),
                .ray_i(ray_i), .pixel_i(pixel), .ray_limit_o(limit),
                .shadow_go_i(shadow_go_i), .shadow_slot_i(shadow_slot_i),
                .visit_o(visit_o), .count_o(count),
                .tested_valid_i(tested_valid), .tested_slot_i(tested_slot),
                .limit_read_o(next_read), .limit_slot_o(next_slot), .limit_i(next_depth),
                .hit_i(next_hit), .ends_i(next_ends),
                .done_valid_o(ended_valid), .done_slot_o(ended_slot),
                .visits_read_i(visits_read_i), .visits_slot_i(visits_slot_i),
                .visits_o(visits_o),
                .mem_req_valid_o(mem_req_valid_o), .mem_req_ready_i(mem_req_ready_i),
                .mem_req_line_o(mem_req_line_o),
                .mem_rsp_valid_i(mem_rsp_valid_i), .mem_rsp_ready_o(mem_rsp_ready_o),
                .mem_rsp_data_i(mem_rsp_data_i), .mem_rsp_error_i(mem_rsp_error_i),
                .event_o(event_o), .fault_o(fault_o)
            );
            wire unused = &{1'b0, read_depth};
        end
    endgenerate

    // ---- rays that are done ----
    wire             done_taken = done_valid_o && (WAITS == 0 || done_ready_i);
    generate
        if (WAITS != 0) begin : g_waits
            wire             ended_in, head_valid, head_ready;
            wire [SLOTW-1:0] head_slot;
            rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_done (
                .clk(clk), .rst(rst), .in_valid_i(ended_valid), .in_ready_o(ended_in),
                .in_data_i(ended_slot),
                .out_valid_o(head_valid), .out_ready_i(head_ready), .out_data_o(head_slot)
            );
            rt_reg_slice #(.WIDTH(SLOTW)) u_head (        // a register, since pipes take turns
                .clk(clk), .rst(rst),
                .in_valid_i(head_valid), .in_ready_o(head_ready), .in_data_i(head_slot),
                .out_valid_o(done_valid_o), .out_ready_i(done_ready_i), .out_data_o(done_slot_o)
            );
            wire unused = ended_in;
        end else begin : g_leaves
            assign {done_valid_o, done_slot_o} = {ended_valid, ended_slot};
            wire unused = done_ready_i;
        end
    endgenerate

    // ---- results of leaf children; first hits ----
    rt_closest_hit #(.W(W), .WD(WD), .FW(LW), .KEYS(ACCEL), .SLOTS(SLOTS), .SHADOW(SHADOW),
                 .INSIDE(FARS), .FIRST(FIRST), .LUTS(LUTS)) u_collect (
        .clk(clk), .rst(rst),
        .want_valid_i(visit_o[`RT_VISIT_VALID]), .want_slot_i(visit_o[`RT_VISIT_SLOT]),
        .want_count_i(count),
        .new_valid_i(ray_i[`RT_RAY_VALID]), .new_slot_i(ray_i[`RT_RAY_SLOT]),
        .new_scale_i(filter_i[`RT_FILTER_SCALE]), .new_shift_i(filter_i[`RT_FILTER_SHIFT]),
        .new_shadow_i(ray_i[`RT_RAY_SHADOW]), .new_primary_i(ray_i[`RT_RAY_PRIMARY]),
        .new_first_i(first), .new_depth_i(limit),
        .in_valid_i(result_i[`RT_RESULT_VALID]), .in_slot_i(result_i[`RT_RESULT_SLOT]),
        .in_hit_i(result_i[`RT_RESULT_HIT]), .in_far_i(result_i[`RT_RESULT_FAR]),
        .in_id_i(result_i[`RT_RESULT_ID]), .in_key_i(result_i[`RT_RESULT_KEY]),
        .out_valid_o(tested_valid), .out_slot_o(tested_slot),
        .filter_valid_i(read_valid), .filter_slot_i(read_slot), .filter_depth_o(read_depth),
        .next_valid_i(next_read), .next_slot_i(next_slot), .next_depth_o(next_depth),
        .next_found_o(next_hit), .next_ends_o(next_ends),
        .done_valid_i(done_taken), .done_slot_i(done_slot_o),
        .done_found_o(done_o[`RT_DONE_FOUND]), .done_shadow_o(done_o[`RT_DONE_SHADOW]),
        .done_primary_o(done_o[`RT_DONE_PRIMARY]), .done_first_o(done_o[`RT_DONE_FIRST]),
        .done_far_o(done_o[`RT_DONE_FAR]), .done_fars_o(done_o[`RT_DONE_FARS]),
        .done_id_o(done_o[`RT_DONE_ID]),
        .done_key_o(done_o[`RT_DONE_KEY])
    );
    wire unused = &{1'b0, effects, filter_i, across_i};
endmodule
`default_nettype wire
