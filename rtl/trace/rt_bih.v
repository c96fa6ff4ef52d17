// rt_bih.v - rays through a bounding interval hierarchy: a node a clock, cut by two planes
// SPDX-License-Identifier: Apache-2.0
// Stands where rt_traverse and rt_traversal_stack do for nodes of four children (ACCEL of rt_core).
//   0 issue | 1, 2 node cache | 3 node: its half | 4 ray's word of the axis | 5..9 rt_bih_step |
//   9, 10 decision | 11 token: back to 0 a clock later
// A ray starts at 3, in a clock in which no node comes from the cache. What of it lies in the box
// around all rt_bih_box knows by then.
// Aroxa 2014, III.B. Model: sph_bih_walk() in cmodel/trace/bih_walk.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
`include "rt_latency.vh"
`include "rt_bih.vh"
module rt_bih #(
    parameter W     = 16,   // coordinate, bits
    parameter WD    = 17,   // direction component, bits
    parameter SLOTS = 32,   // power of two
    parameter LINES = 256,  // node cache, lines
    parameter LINE_BITS = `RT_LINE_BITS, // bits of a line's number
    parameter SHADOW = 1,   // 1: shadow rays
    parameter FACETS = 0,   // 1: a leaf record may have a whole line
    parameter TW    = `RT_BIH_T  // not to be set: bits of a bound
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
    input  wire                       pixel_i,        // the pixel's visits start at 0
    output wire [TW-1:0]              ray_limit_o,    // to rt_closest_hit: light of a shadow ray
    // from rt_shade: a shadow ray starts
    input  wire                       shadow_go_i,
    input  wire [$clog2(SLOTS)-1:0]   shadow_slot_i,
    // to rt_leaf_unit and rt_closest_hit: leaf records to test
    output wire [`RT_VISIT_BITS-1:0]  visit_o,
    //: {SLOT[SLOTW], LINE[26], LEAF[4], VALID}
    output wire [2:0]                 count_o,
    // from rt_closest_hit: they are tested; what the ray has found, a clock after the slot
    input  wire                       tested_valid_i,
    input  wire [$clog2(SLOTS)-1:0]   tested_slot_i,
    output wire                       limit_read_o,
    output wire [$clog2(SLOTS)-1:0]   limit_slot_o,
    input  wire [TW-1:0]              limit_i,        // what begins later does not matter
    input  wire                       hit_i,
    input  wire                       ends_i,         // a hit ends the ray
    // token: the ray is done
    output wire                       done_valid_o,
    output wire [$clog2(SLOTS)-1:0]   done_slot_o,
    // visits of a pixel
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
    localparam CW = W + 2;                           // coordinate of a plane
    localparam GW = `RT_BIH_G;

    localparam T  = W + WD + 2 > TW ? W + WD + 2 - TW : 0;  // low bits of a key that bounds drop

    wire [`RT_EFFECT_BITS-1:0] effects = regs_i[`RT_REGS_EFFECTS];
    wire [`RT_LINE_BITS-1:0] mem_lines = regs_i[`RT_REGS_MEM_LINES];
    wire [`RT_LINE_BITS-1:0] root      = regs_i[`RT_REGS_ROOT];
    wire [`RT_LINE_BITS-1:0] leaf_base = regs_i[`RT_REGS_LEAF_BASE];
    wire [`RT_ID_BITS-1:0] n_prims     = regs_i[`RT_REGS_N_PRIMS];
    wire [`RT_ID_BITS-1:0] n_loose     = regs_i[`RT_REGS_N_LOOSE];

    // ---- rays: their words, how far they go (RT_RAY_SHADOW: to the key of a light) ----
    wire [2*WD+TW-1:0] light = {{TW{1'b0}}, ray_i[`RT_RAY_A]} >> T;
    assign ray_limit_o = !ray_i[`RT_RAY_SHADOW] || |light[2*WD+TW-1:TW] ? {TW{1'b1}}
                                                                        : light[TW-1:0];
    wire             place_valid, pace_valid, start_valid, start_pixel, put_start;
    wire [SLOTW-1:0] place_slot, pace_slot, start_slot;
    wire [1:0]       place_axis, pace_axis;
    wire [W+1:0]     place;
    wire [GW+6:0]    pace;
    rt_bih_ray #(.W(W), .WD(WD), .SLOTS(SLOTS), .SHADOW(SHADOW)) u_rays (
        .clk(clk), .rst(rst),
        .new_valid_i(ray_i[`RT_RAY_VALID]), .new_slot_i(ray_i[`RT_RAY_SLOT]),
        .new_org_i(ray_i[`RT_RAY_ORG]), .new_dir_i(ray_i[`RT_RAY_DIR]),
        .new_a_i(ray_i[`RT_RAY_A]),
        .go_valid_i(ray_i[`RT_RAY_VALID] && !ray_i[`RT_RAY_SHADOW]),
        .go_slot_i(ray_i[`RT_RAY_SLOT]), .go_pixel_i(pixel_i),
        .shadow_go_i(shadow_go_i), .shadow_slot_i(shadow_slot_i),
        .place_valid_o(place_valid), .place_slot_o(place_slot), .place_axis_o(place_axis),
        .place_o(place),
        .pace_valid_o(pace_valid), .pace_slot_o(pace_slot), .pace_axis_o(pace_axis),
        .pace_o(pace),
        .start_valid_o(start_valid), .start_ready_i(put_start), .start_slot_o(start_slot),
        .start_pixel_o(start_pixel)
    );

    wire             span_valid;
    wire [SLOTW-1:0] span_slot;
    wire [2*TW-1:0]  span;
    rt_bih_box #(.W(W), .SLOTS(SLOTS)) u_box (
        .clk(clk), .rst(rst), .box_i(regs_i[`RT_REGS_BOX]), .place_i(place),
        .pace_valid_i(pace_valid), .pace_slot_i(pace_slot), .pace_axis_i(pace_axis),
        .pace_i(pace),
        .span_valid_o(span_valid), .span_slot_o(span_slot), .span_o(span)
    );

    // ---- tokens: nodes to visit ----
    wire             issue_valid, q_issue_in, q_issue_valid;
    wire [SLOTW-1:0] issue_slot, q_issue_slot;
    localparam LB = `RT_LINE_BITS;
    wire [LB:0]      issue_place, q_issue_place;     // {line, half}
    wire             head_valid, head_ready, req_ready, rsp_valid;
    wire [SLOTW+LB:0] head;
    rt_fifo #(.WIDTH(SLOTW+LB+1), .DEPTH(SLOTS)) u_issue_queue (
        .clk(clk), .rst(rst), .in_valid_i(issue_valid), .in_ready_o(q_issue_in),
        .in_data_i({issue_slot, issue_place}),
        .out_valid_o(head_valid), .out_ready_i(head_ready), .out_data_o(head)
    );
    rt_reg_slice #(.WIDTH(SLOTW+LB+1)) u_head (      // the visits and the cache begin with a RAM
        .clk(clk), .rst(rst),
        .in_valid_i(head_valid), .in_ready_o(head_ready), .in_data_i(head),
        .out_valid_o(q_issue_valid), .out_ready_i(req_ready),
        .out_data_o({q_issue_slot, q_issue_place})
    );
    // A start writes the visits too, so it waits while a node is issued.
    assign put_start = start_valid && !rsp_valid && !q_issue_valid;

    // ---- issue: count the visit ----
    wire             issue      = q_issue_valid && req_ready;
    wire [SLOTW-1:0] count_slot = q_issue_valid ? q_issue_slot : start_slot;
    localparam VB = `RT_VISITS_BITS;
    wire [VB-1:0]    ray_visits, pixel_visits;
    wire             at_limit;                       // ray_visits are as many as there may be
    wire [VB-1:0]    ray_before   = q_issue_valid ? ray_visits : {VB{1'b0}};
    wire [VB-1:0]    pixel_before = q_issue_valid || !start_pixel ? pixel_visits : {VB{1'b0}};
    wire             bad_limit  = q_issue_valid && at_limit;
    wire [VB-1:0]    one        = {{(VB-1){1'b0}}, q_issue_valid && !at_limit};
    // Written a clock later: a slot is read again only when its node is here.
    reg              count_q;
    reg [SLOTW-1:0]  count_slot_q;
    reg [VB-1:0]     ray_next_q, pixel_next_q;
    always @(posedge clk) begin
        count_q      <= issue || put_start;
        count_slot_q <= count_slot;
        ray_next_q   <= ray_before + one;
        pixel_next_q <= pixel_before + one;
        if (rst) count_q <= 1'b0;
    end
    rt_slot_file #(.WIDTH(2*VB+1), .SLOTS(SLOTS)) u_visits (
        .clk(clk), .wr_en_i(count_q), .wr_addr_i(count_slot_q),
        .wr_data_i({ray_next_q == regs_i[`RT_REGS_VISIT_LIMIT], ray_next_q, pixel_next_q}),
        .rd_addr_i(count_slot), .rd_data_o({at_limit, ray_visits, pixel_visits})
    );
    rt_slot_ram #(.WIDTH(VB), .SLOTS(SLOTS), .OLD(0)) u_visits_out (
        .clk(clk), .wr_en_i(count_q), .wr_addr_i(count_slot_q), .wr_data_i(pixel_next_q),
        .rd_en_i(visits_read_i), .rd_addr_i(visits_slot_i), .rd_data_o(visits_o)
    );
    assign event_o[`RT_TRACE_EVENT_ISSUED] = issue;

    // ---- node cache; a killed token fetches line 0 and is thrown away behind it ----
    localparam TAG = SLOTW + 2;
    wire             rsp_half, rsp_kill, rsp_error;
    wire [SLOTW-1:0] rsp_slot;
    wire [255:0]     rsp_data;
    rt_cache #(.TAG(TAG), .LINES(LINES), .PENDING(SLOTS), .LINE_BITS(LINE_BITS)) u_cache (
        .clk(clk), .rst(rst), .flush_i(flush_i), .mem_lines_i(mem_lines),
        .req_valid_i(q_issue_valid), .req_ready_o(req_ready),
        .req_line_i(bad_limit ? {LB{1'b0}} : q_issue_place[LB:1]),
        .req_tag_i({q_issue_slot, q_issue_place[0], bad_limit}),
        .rsp_valid_o(rsp_valid), .rsp_ready_i(1'b1), .rsp_data_o(rsp_data),
        .rsp_tag_o({rsp_slot, rsp_half, rsp_kill}), .rsp_error_o(rsp_error),
        .mem_req_valid_o(mem_req_valid_o), .mem_req_ready_i(mem_req_ready_i),
        .mem_req_line_o(mem_req_line_o),
        .mem_rsp_valid_i(mem_rsp_valid_i), .mem_rsp_ready_o(mem_rsp_ready_o),
        .mem_rsp_data_i(mem_rsp_data_i), .mem_rsp_error_i(mem_rsp_error_i),
        .miss_o(event_o[`RT_TRACE_EVENT_MISS])
    );

    // ---- t1: a node or a start ----
    reg              t1_valid_q, t1_node_q, t1_kill_q;
    reg [SLOTW-1:0]  t1_slot_q;
    reg [95:0]       t1_words_q;                     // of the node
    reg              sound_q;                        // the registers let a ray start
    wire [LB:0]      records = {1'b0, leaf_base} + {{(LB+1-`RT_ID_BITS){1'b0}}, n_prims};
    always @(posedge clk) begin
        t1_valid_q <= rsp_valid || put_start;
        t1_node_q  <= rsp_valid;
        t1_kill_q  <= rsp_valid ? rsp_kill || rsp_error : !sound_q;
        t1_slot_q  <= rsp_valid ? rsp_slot : start_slot;
        t1_words_q <= rsp_half ? rsp_data[128 +: 96] : rsp_data[95:0];
        sound_q    <= root < mem_lines && records <= {1'b0, mem_lines} && n_loose <= n_prims;
        if (rst) t1_valid_q <= 1'b0;
    end
    wire [28:0]      t1_child = t1_words_q[`RT_BIH_CHILD_LSB +: 29];
    wire             t1_fit   = t1_words_q[`RT_BIH_FIT_LSB];
    wire [1:0]       t1_axis  = t1_words_q[`RT_BIH_AXIS_LSB +: 2];
    wire             t1_leaf  = t1_axis == 2'd`RT_BIH_LEAF;
    wire [31:0]      t1_first = t1_words_q[`RT_BIH_FIRST_LSB +: 32];
    wire [31:0]      t1_count = t1_words_q[`RT_BIH_COUNT_LSB +: 32];
    wire [32:0]      t1_end   = {1'b0, t1_first} + {1'b0, t1_count};
    wire [29:0]      t1_line  = {4'd0, root} + {1'b0, t1_child};
    wire             t1_bad   = t1_leaf ? t1_end > {9'd0, n_prims}
                                        : t1_line >= {4'd0, mem_lines};
    wire [CW-1:0]    t1_l     = t1_words_q[`RT_BIH_CLIP_L_LSB +: CW];
    wire [CW-1:0]    t1_r     = t1_words_q[`RT_BIH_CLIP_R_LSB +: CW];
    wire [W+1:0]     t2_place;
    wire [GW+6:0]    t2_pace;
    rt_slot_ram #(.WIDTH(W+2), .SLOTS(4*SLOTS), .OLD(0)) u_places (
        .clk(clk), .wr_en_i(place_valid), .wr_addr_i({place_slot, place_axis}), .wr_data_i(place),
        .rd_en_i(t1_valid_q), .rd_addr_i({t1_slot_q, t1_axis}), .rd_data_o(t2_place)
    );
    rt_slot_ram #(.WIDTH(GW+7), .SLOTS(4*SLOTS), .OLD(0)) u_paces (
        .clk(clk), .wr_en_i(pace_valid), .wr_addr_i({pace_slot, pace_axis}), .wr_data_i(pace),
        .rd_en_i(t1_valid_q), .rd_addr_i({t1_slot_q, t1_axis}), .rd_data_o(t2_pace)
    );

    // ---- t2: planes and the ray's word side by side ----
    // Between two planes: the near one is that above, the far one that below.
    reg              t2_valid_q, t2_node_q;
    reg [SLOTW-1:0]  t2_slot_q;
    reg [2:0]        t2_kind_q;
    reg              visit_q, bad_node_q, visit_limit_q, bus_error_q;
    reg [2:0]        tests_q;
    localparam NB = 2*`RT_ID_BITS;                   // {count, first} of leaf records
    reg [NB-1:0]     t2_data_q;
    reg signed [CW-1:0] t2_l_q, t2_r_q;
    wire             t1_live = t1_valid_q && t1_node_q && !t1_kill_q;
    always @(posedge clk) begin
        t2_valid_q <= t1_valid_q;
        t2_node_q  <= t1_valid_q && t1_node_q;
        t2_slot_q  <= t1_slot_q;
        t2_kind_q  <= t1_kill_q || (t1_node_q && t1_bad) ? `RT_BIH_KILL
                      : !t1_node_q ? `RT_BIH_START
                      : t1_leaf ? `RT_BIH_LEAVE : t1_fit ? `RT_BIH_FIT : `RT_BIH_INNER;
        t2_data_q  <= t1_leaf ? {t1_count[`RT_ID_BITS-1:0], t1_first[`RT_ID_BITS-1:0]}
                              : {{(NB-LB){1'b0}}, t1_line[LB-1:0]};
        t2_l_q     <= t1_fit ? t1_r : t1_l;
        t2_r_q     <= t1_fit ? t1_l : t1_r;
        visit_q       <= issue && !bad_limit;
        tests_q       <= t1_live && !t1_bad && !t1_leaf ? 3'd2 : 3'd0;
        bad_node_q    <= (t1_live && t1_bad) || (put_start && !sound_q);
        visit_limit_q <= issue && bad_limit;
        bus_error_q   <= rsp_valid && rsp_error;
        if (rst) begin
            t2_valid_q <= 1'b0; t2_node_q <= 1'b0; visit_q <= 1'b0; tests_q <= 3'd0;
            bad_node_q <= 1'b0; visit_limit_q <= 1'b0; bus_error_q <= 1'b0;
        end
    end

    assign event_o[`RT_TRACE_EVENT_VISIT] = visit_q;
    assign event_o[`RT_TRACE_EVENT_TESTS] = tests_q;
    assign fault_o[`RT_ERROR_BAD_NODE]    = bad_node_q;
    assign fault_o[`RT_ERROR_VISIT_LIMIT] = visit_limit_q;
    assign fault_o[`RT_ERROR_BUS_ERROR]   = bus_error_q;

    // ---- the step, and beside it whose it is ----
    wire             s_back, s_near, s_far, pass_valid;
    wire [TW-1:0]    s_upper, s_lower;
    wire [SLOTW-1:0] pass_slot;
    wire [2:0]       pass_kind;
    rt_bih_step #(.W(W)) u_step (
        .clk(clk),
        .in_org_i($signed(t2_place[W+1:2])), .in_back_i(t2_place[1]), .in_flat_i(t2_place[0]),
        .in_open_i(t2_pace[GW+6]), .in_shift_i(t2_pace[GW +: 6]), .in_g_i(t2_pace[GW-1:0]),
        .in_clip_l_i(t2_l_q), .in_clip_r_i(t2_r_q),
        .out_back_o(s_back), .out_near_o(s_near), .out_far_o(s_far),
        .out_upper_o(s_upper), .out_lower_o(s_lower)
    );
    rt_delay #(.WIDTH(SLOTW+3), .CYCLES(`RT_BIH_STEP_LATENCY-2)) u_side (
        .clk(clk), .in_i({t2_slot_q, t2_kind_q}), .out_o({pass_slot, pass_kind})
    );
    rt_delay_valid #(.CYCLES(`RT_BIH_STEP_LATENCY-2)) u_valid (
        .clk(clk), .rst(rst), .in_i(t2_valid_q), .out_o(pass_valid)
    );

    // ---- decision ----
    rt_bih_stack #(.SLOTS(SLOTS), .ENDS(SHADOW), .FACETS(FACETS)) u_next (
        .clk(clk), .rst(rst), .facets_on_i(effects[`RT_EFFECT_FACETS]), .root_i(root),
        .leaf_base_i(leaf_base), .n_loose_i(n_loose),
        .box_valid_i(span_valid), .box_slot_i(span_slot), .box_span_i(span),
        .node_valid_i(t2_node_q), .node_slot_i(t2_slot_q), .node_i(t2_data_q),
        .pass_valid_i(pass_valid), .pass_slot_i(pass_slot), .pass_kind_i(pass_kind),
        .step_back_i(s_back), .step_near_i(s_near), .step_far_i(s_far),
        .step_upper_i(s_upper), .step_lower_i(s_lower),
        .tested_valid_i(tested_valid_i), .tested_slot_i(tested_slot_i),
        .read_o(limit_read_o), .slot_o(limit_slot_o), .limit_i(limit_i), .hit_i(hit_i),
        .ends_i(ends_i),
        .issue_valid_o(issue_valid), .issue_slot_o(issue_slot), .issue_place_o(issue_place),
        .leaf_valid_o(visit_o[`RT_VISIT_VALID]), .leaf_slot_o(visit_o[`RT_VISIT_SLOT]),
        .leaf_mask_o(visit_o[`RT_VISIT_LEAF]), .leaf_count_o(count_o),
        .leaf_line_o(visit_o[`RT_VISIT_LINE]),
        .done_valid_o(done_valid_o), .done_slot_o(done_slot_o),
        .bubble_o(event_o[`RT_TRACE_EVENT_BUBBLE]),
        .overflow_o(fault_o[`RT_ERROR_STACK_OVERFLOW])
    );
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_node_visits /* verilator public_flat_rd */ =
        {start_valid && !put_start, issue, 5'd0, rsp_valid || put_start};
    wire [7:0] work_node_cache /* verilator public_flat_rd */ =
        {q_issue_valid && !req_ready, issue, 5'd0, issue};
    wire unused = &{1'b0, q_issue_in, regs_i, effects, ray_i, rsp_data[255:224],
                    rsp_data[127:96], t1_words_q, t1_line[29:LB]};
endmodule
`default_nettype wire
