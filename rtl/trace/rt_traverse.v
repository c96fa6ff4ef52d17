// rt_traverse.v - one node of four children a cycle: issue, node cache, filters, sort
// SPDX-License-Identifier: Apache-2.0
// A token brings a slot and the line of a node. What the visit finds leaves as found_o and, if leaf
// children pass, as visit_o; where the token goes next is for rt_trace.
//   4 issue | node cache | 1 node beside its ray | rt_filter | rt_sort, 2
// A ray's first token waits START clocks, so that its axes across are there before a node is.
// With BOXES children are in boxes: rt_boxes, `RT_BOXES_LATENCY.
// Behind the cache nothing waits: a node a clock.
// Borodavka et al. IV. Model: sph_visit() in cmodel/trace/traverse.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_latency.vh"
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_traverse #(
    parameter W     = 16,   // coordinate, bits
    parameter WD    = 17,   // direction component, bits
    parameter FW    = 14,   // filter coordinate, bits
    parameter SLOTS = 32,   // power of two
    parameter LINES = 256,  // node cache, lines
    parameter LINE_BITS = `RT_LINE_BITS, // bits of a line's number
    parameter SHADOW = 1,   // 1: shadow rays
    parameter FIRST = 1,    // 1: rays that end with their first hit
    parameter FACETS = 0,   // 1: a leaf child may have a whole line
    parameter SQUARES = 0,  // 1: squares of the node filter in LUTs
    parameter LUTS  = 0,    // LUT cells that a block RAM is worth, rt_slot_ram
    parameter BOXES = 0,    // 1: children are in boxes, not in spheres
    parameter LW    = BOXES != 0 ? 14 : FW   // not to be set: depth, bits - 1
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
    input  wire [`RT_ACROSS_BITS-1:0] across_i,       // its axes, behind it; not with BOXES
    //: {SLOT[SLOTW], Q[54], P_B[18], P_A[18], LEAST[2], VALID}
    input  wire                       first_i,        // children as the node has them, none pruned
    input  wire                       pixel_i,        // the pixel's visits start at 0
    // from rt_shade: a shadow ray starts
    input  wire                       shadow_go_i,
    input  wire [$clog2(SLOTS)-1:0]   shadow_slot_i,
    // from rt_traversal_stack: the next node of a ray
    input  wire                       next_valid_i,
    input  wire [$clog2(SLOTS)-1:0]   next_slot_i,
    input  wire [`RT_LINE_BITS-1:0]   next_line_i,
    // from rt_closest_hit
    output wire                       depth_read_o,
    output wire [$clog2(SLOTS)-1:0]   depth_slot_o,
    input  wire [LW:0]                depth_i,        // a clock later: what lies deeper is pruned
    // result of a visit: to rt_traversal_stack; leaf children that pass, to rt_leaf_unit
    output wire [`RT_FOUND_BITS-1:0]  found_o,
    //: {SLOT[SLOTW], LIST[72], COUNT[3], BASE[26], KILL, FRESH, VALID}
    output wire [`RT_VISIT_BITS-1:0]  visit_o,
    //: {SLOT[SLOTW], LINE[26], LEAF[4], VALID}
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
    wire [`RT_EFFECT_BITS-1:0] effects   = regs_i[`RT_REGS_EFFECTS];
    wire [`RT_LINE_BITS-1:0] mem_lines = regs_i[`RT_REGS_MEM_LINES];
    localparam LAT = BOXES != 0 ? `RT_BOXES_LATENCY
                     : SQUARES != 0 ? `RT_FILTER_SQUARES_LATENCY : `RT_FILTER_LATENCY;

    // ---- queues of tokens: rays under way first, then new ones ----
    wire             q_next_valid, start_valid, start_pixel, next_in_ready;
    wire [SLOTW-1:0] q_next_slot, start_slot;
    reg  [3:0]       held_q;                         // tokens chosen that the cache has not taken
    wire             room = !held_q[3];
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_next_queue (
        .clk(clk), .rst(rst), .in_valid_i(next_valid_i), .in_ready_o(next_in_ready),
        .in_data_i(next_slot_i),
        .out_valid_o(q_next_valid), .out_ready_i(room), .out_data_o(q_next_slot)
    );

    // ---- what bounds children: rays set up for it, and the test ----
    wire             rsp_valid, rsp_fresh, rsp_kill, rsp_error;
    wire [SLOTW-1:0] rsp_slot;
    reg              t1_valid_q;
    reg [255:0]      t1_node_q;
    wire [2:0]       t1_n_inner = t1_node_q[`RT_NODE_N_INNER_LSB +: `RT_NODE_N_INNER_BITS];
    wire [2:0]       t1_n_leaf  = t1_node_q[`RT_NODE_N_LEAF_LSB +: `RT_NODE_N_LEAF_BITS];
    wire [3:0]       t1_count   = {1'b0, t1_n_inner} + {1'b0, t1_n_leaf};
    wire [3:0]       f_pass;
    wire [63:0]      f_near;
    wire             f_order;                                // children as the node has them
    genvar c;
    generate
        if (BOXES != 0) begin : g_boxes
            rt_boxes #(.W(W), .WD(WD), .SLOTS(SLOTS), .SHADOW(SHADOW)) u_boxes (
                .clk(clk), .rst(rst), .ray_i(ray_i), .pixel_i(pixel_i),
                .shadow_go_i(shadow_go_i), .shadow_slot_i(shadow_slot_i),
                .start_valid_o(start_valid), .start_ready_i(room && !q_next_valid),
                .start_slot_o(start_slot), .start_pixel_o(start_pixel),
                .read_i(rsp_valid), .slot_i(rsp_slot), .node_i(t1_node_q), .limit_i(depth_i),
                .pass_o(f_pass), .near_o(f_near), .order_o(f_order)
            );
            wire unused = &{1'b0, first_i, across_i};
        end else begin : g_spheres
            wire             q_new_valid, q_new_pixel, q_shadow_valid, new_in_ready;
            wire             shadow_in_ready;
            wire [SLOTW-1:0] q_new_slot, q_shadow;
            // from a push to the read of the ray: queue, 4 of issue, queue, 3 of the cache
            localparam START = `RT_ACROSS_BEHIND - 7;
            wire             new_valid;
            wire [SLOTW:0]   fresh;
            rt_stages #(.WIDTH(SLOTW+1), .CYCLES(START)) u_new (
                .clk(clk), .rst(rst), .in_valid_i(ray_i[`RT_RAY_VALID] && !ray_i[`RT_RAY_SHADOW]),
                .in_i({ray_i[`RT_RAY_SLOT], pixel_i}), .out_valid_o(new_valid), .out_o(fresh)
            );
            rt_fifo #(.WIDTH(SLOTW+1), .DEPTH(SLOTS)) u_new_queue (
                .clk(clk), .rst(rst), .in_valid_i(new_valid),
                .in_ready_o(new_in_ready), .in_data_i(fresh),
                .out_valid_o(q_new_valid),
                .out_ready_i(room && !q_next_valid && !q_shadow_valid),
                .out_data_o({q_new_slot, q_new_pixel})
            );
            if (SHADOW != 0) begin : g_shadow
                wire             go;
                wire [SLOTW-1:0] go_slot;
                rt_stages #(.WIDTH(SLOTW), .CYCLES(START)) u_go (
                    .clk(clk), .rst(rst), .in_valid_i(shadow_go_i), .in_i(shadow_slot_i),
                    .out_valid_o(go), .out_o(go_slot)
                );
                rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_shadow_queue (
                    .clk(clk), .rst(rst), .in_valid_i(go), .in_ready_o(shadow_in_ready),
                    .in_data_i(go_slot),
                    .out_valid_o(q_shadow_valid), .out_ready_i(room && !q_next_valid),
                    .out_data_o(q_shadow)
                );
            end else begin : g_no_shadow
                assign {shadow_in_ready, q_shadow_valid, q_shadow} = {(SLOTW+2){1'b0}};
                wire unused = &{1'b0, shadow_go_i, shadow_slot_i};
            end
            assign start_valid = q_shadow_valid || q_new_valid;
            assign start_slot  = q_shadow_valid ? q_shadow : q_new_slot;
            assign start_pixel = !q_shadow_valid && q_new_pixel;

            localparam YW = 3*FW + 3;
            localparam OB = FIRST != 0 || SHADOW != 0 ? 1 : 0;
            wire             in_order = (FIRST != 0 && first_i) ||    // any hit ends the ray
                                        (SHADOW != 0 && ray_i[`RT_RAY_SHADOW]);
            wire [YW:0]      y = {in_order, filter_i[`RT_FILTER_NEGATIVE],
                                  filter_i[`RT_FILTER_AXIS], filter_i[`RT_FILTER_ORG]};
            wire [YW+OB-1:0] t1_ray;
            wire             t1_order = OB != 0 && t1_ray[YW+OB-1];
            wire             t1_negative;
            wire [1:0]       t1_axis;
            wire [3*FW-1:0]  t1_org;
            localparam AW = `RT_ACROSS_BITS - SLOTW;
            wire [AW-1:0]    t1_across;
            rt_slot_ram #(.WIDTH(YW+OB), .SLOTS(SLOTS), .OLD(0), .LUTS(LUTS)) u_ray (
                .clk(clk), .wr_en_i(ray_i[`RT_RAY_VALID]), .wr_addr_i(ray_i[`RT_RAY_SLOT]),
                .wr_data_i(y[YW+OB-1:0]),
                .rd_en_i(rsp_valid), .rd_addr_i(rsp_slot), .rd_data_o(t1_ray)
            );
            assign {t1_negative, t1_axis, t1_org} = t1_ray[YW-1:0];
            rt_slot_ram #(.WIDTH(AW), .SLOTS(SLOTS), .OLD(0), .LUTS(LUTS)) u_across (
                .clk(clk), .wr_en_i(across_i[`RT_ACROSS_VALID]),
                .wr_addr_i(across_i[`RT_ACROSS_SLOT]), .wr_data_i(across_i[AW-1:0]),
                .rd_en_i(rsp_valid), .rd_addr_i(rsp_slot), .rd_data_o(t1_across)
            );
            reg  [AW-1:0]    t2_across_q;            // one for all lanes
            wire [53:0]      t2_q = t2_across_q[`RT_ACROSS_Q];
            always @(posedge clk) if (t1_valid_q) t2_across_q <= t1_across;
            for (c = 0; c < 4; c = c + 1) begin : g_lane
                wire [`RT_CHILD_STRIDE-1:0] child =
                    t1_node_q[`RT_CHILD_STRIDE*c +: `RT_CHILD_STRIDE];
                localparam [31:0] CHILD = c;
                rt_filter #(.FW(FW), .SQUARES(SQUARES)) u_filter (
                    .clk(clk), .in_valid_i(t1_valid_q && t1_count > CHILD[3:0]),
                    .in_org_x_i($signed(t1_org[0 +: FW])), .in_org_y_i($signed(t1_org[FW +: FW])),
                    .in_org_z_i($signed(t1_org[2*FW +: FW])),
                    .in_least_i(t1_across[`RT_ACROSS_LEAST]),
                    .s1_p_a_i($signed(t2_across_q[`RT_ACROSS_P_A])),
                    .s1_p_b_i($signed(t2_across_q[`RT_ACROSS_P_B])),
                    .s1_q_x_i($signed(t2_q[`RT_UNIT_X])), .s1_q_y_i($signed(t2_q[`RT_UNIT_Y])),
                    .s1_q_z_i($signed(t2_q[`RT_UNIT_Z])),
                    .in_axis_i(t1_axis), .in_negative_i(t1_negative), .in_depth_max_i(depth_i),
                    .in_ctr_x_i($signed(child[`RT_CHILD_CTR_X_LSB +: `RT_CHILD_CTR_X_BITS])),
                    .in_ctr_y_i($signed(child[`RT_CHILD_CTR_Y_LSB +: `RT_CHILD_CTR_Y_BITS])),
                    .in_ctr_z_i($signed(child[`RT_CHILD_CTR_Z_LSB +: `RT_CHILD_CTR_Z_BITS])),
                    .in_rad_i(child[`RT_CHILD_RAD_LSB +: `RT_CHILD_RAD_BITS]),
                    .out_pass_o(f_pass[c]), .out_near_o(f_near[16*c +: 16])
                );
            end
            if (OB != 0) begin : g_order
                rt_delay #(.WIDTH(1), .CYCLES(LAT)) u_order (
                    .clk(clk), .in_i(t1_order), .out_o(f_order)
                );
            end else begin : g_nearest
                assign f_order = 1'b0;
                wire unused = &{1'b0, t1_order, y[YW]};
            end
            wire unused = &{1'b0, new_in_ready, shadow_in_ready, t1_across, t2_across_q};
        end
    endgenerate

    // ---- issue: choose | read the visits | count the visit, refuse bad addresses | queue ----
    localparam VB = `RT_VISITS_BITS;
    wire             any_valid = q_next_valid || start_valid;
    wire [SLOTW-1:0] any_slot  = q_next_valid ? q_next_slot : start_slot;
    reg              i1_valid_q, i1_fresh_q, i1_pixel_q, i2_valid_q, i2_fresh_q;
    reg              i3_valid_q, i3_fresh_q, i3_bad_line_q, i3_bad_limit_q;
    reg [SLOTW-1:0]  i1_slot_q, i2_slot_q, i3_slot_q;
    reg [`RT_LINE_BITS-1:0] i2_line_q, i3_line_q;
    reg [VB-1:0]     i2_ray_q, i2_pixel_q, i3_ray_q, i3_pixel_q;   // visits before this one
    wire [`RT_LINE_BITS-1:0] next_line;
    wire [`RT_LINE_BITS-1:0] i1_line = i1_fresh_q ? regs_i[`RT_REGS_ROOT] : next_line;
    wire [VB-1:0]    ray_visits, pixel_visits;
    wire             taken;                          // the cache takes a request
    wire             i3_kill = i3_bad_line_q || i3_bad_limit_q;
    wire [VB-1:0]    one     = {{(VB-1){1'b0}}, !i3_kill};
    wire [VB-1:0]    i3_visits = i3_pixel_q + one;
    always @(posedge clk) begin
        i1_valid_q <= any_valid && room;
        i1_fresh_q <= !q_next_valid;
        i1_pixel_q <= !q_next_valid && start_pixel;
        i1_slot_q  <= any_slot;
        i2_valid_q <= i1_valid_q;
        if (i1_valid_q) begin
            i2_fresh_q <= i1_fresh_q;
            i2_slot_q  <= i1_slot_q;
            i2_line_q  <= i1_line;
            i2_ray_q   <= i1_fresh_q ? {VB{1'b0}} : ray_visits;
            i2_pixel_q <= i1_pixel_q ? {VB{1'b0}} : pixel_visits;
        end
        i3_valid_q <= i2_valid_q;
        if (i2_valid_q) begin
            i3_fresh_q <= i2_fresh_q;
            i3_slot_q  <= i2_slot_q;
            i3_line_q  <= i2_line_q;
            i3_ray_q   <= i2_ray_q;
            i3_pixel_q <= i2_pixel_q;
            i3_bad_line_q  <= i2_line_q >= mem_lines;
            i3_bad_limit_q <= i2_ray_q == regs_i[`RT_REGS_VISIT_LIMIT];
        end
        held_q     <= held_q + {3'd0, any_valid && room} - {3'd0, taken};
        if (rst) begin
            i1_valid_q <= 1'b0; i2_valid_q <= 1'b0; i3_valid_q <= 1'b0; held_q <= 4'd0;
        end
    end
    rt_slot_ram #(.WIDTH(`RT_LINE_BITS), .SLOTS(SLOTS), .OLD(0), .LUTS(LUTS)) u_lines (
        .clk(clk), .wr_en_i(next_valid_i), .wr_addr_i(next_slot_i), .wr_data_i(next_line_i),
        .rd_en_i(any_valid && room), .rd_addr_i(any_slot), .rd_data_o(next_line)
    );
    rt_slot_ram #(.WIDTH(2*VB), .SLOTS(SLOTS), .OLD(0), .LUTS(LUTS)) u_visits (
        .clk(clk), .wr_en_i(i3_valid_q), .wr_addr_i(i3_slot_q),
        .wr_data_i({i3_ray_q + one, i3_visits}),
        .rd_en_i(any_valid && room), .rd_addr_i(any_slot), .rd_data_o({ray_visits, pixel_visits})
    );
    rt_slot_ram #(.WIDTH(VB), .SLOTS(SLOTS), .OLD(0), .LUTS(LUTS)) u_visits_out (
        .clk(clk), .wr_en_i(i3_valid_q), .wr_addr_i(i3_slot_q), .wr_data_i(i3_visits),
        .rd_en_i(visits_read_i), .rd_addr_i(visits_slot_i), .rd_data_o(visits_o)
    );
    assign event_o[`RT_TRACE_EVENT_ISSUED] = i3_valid_q;
    // As many words as tokens may be held: it never fills.
    wire             req_valid, req_ready, req_fresh, req_kill, issue_in_ready;
    wire [SLOTW-1:0] req_slot;
    wire [`RT_LINE_BITS-1:0] req_line;
    assign           taken = req_valid && req_ready;
    rt_fifo #(.WIDTH(SLOTW+2+`RT_LINE_BITS), .DEPTH(8)) u_issue (
        .clk(clk), .rst(rst), .in_valid_i(i3_valid_q), .in_ready_o(issue_in_ready),
        .in_data_i({i3_slot_q, i3_fresh_q, i3_kill,
                    i3_kill ? {`RT_LINE_BITS{1'b0}} : i3_line_q}),
        .out_valid_o(req_valid), .out_ready_i(req_ready),
        .out_data_o({req_slot, req_fresh, req_kill, req_line})
    );

    // ---- node cache; a killed token fetches line 0 and is thrown away behind it ----
    localparam TAG = SLOTW + 2;
    wire [255:0]     rsp_data;
    rt_cache #(.TAG(TAG), .LINES(LINES), .PENDING(SLOTS), .LINE_BITS(LINE_BITS)) u_cache (
        .clk(clk), .rst(rst), .flush_i(flush_i), .mem_lines_i(mem_lines),
        .req_valid_i(req_valid), .req_ready_o(req_ready),
        .req_line_i(req_line),
        .req_tag_i({req_slot, req_fresh, req_kill}),
        .rsp_valid_o(rsp_valid), .rsp_ready_i(1'b1), .rsp_data_o(rsp_data),
        .rsp_tag_o({rsp_slot, rsp_fresh, rsp_kill}), .rsp_error_o(rsp_error),
        .mem_req_valid_o(mem_req_valid_o), .mem_req_ready_i(mem_req_ready_i),
        .mem_req_line_o(mem_req_line_o),
        .mem_rsp_valid_i(mem_rsp_valid_i), .mem_rsp_ready_o(mem_rsp_ready_o),
        .mem_rsp_data_i(mem_rsp_data_i), .mem_rsp_error_i(mem_rsp_error_i),
        .miss_o(event_o[`RT_TRACE_EVENT_MISS])
    );

    // ---- t1: node and ray side by side ----
    reg              t1_fresh_q, t1_kill_q;
    reg [SLOTW-1:0]  t1_slot_q;
    reg              visit_q, bad_node_q, visit_limit_q, bus_error_q;
    reg [2:0]        tests_q;
    assign depth_read_o = rsp_valid;
    assign depth_slot_o = rsp_slot;
    wire [`RT_LINE_BITS-1:0] t1_base    = t1_node_q[`RT_NODE_BASE_LSB +: `RT_NODE_BASE_BITS];
    wire        whole      = FACETS != 0 && effects[`RT_EFFECT_FACETS];  // a line a leaf child
    wire [2:0]  t1_lines   = whole ? t1_n_leaf : {1'b0, t1_n_leaf[2:1]};
    localparam LB = `RT_LINE_BITS;
    wire [LB:0] t1_end     = {1'b0, t1_base} + {{(LB-2){1'b0}}, t1_n_inner} +
                             {{(LB-2){1'b0}}, t1_lines} + {{LB{1'b0}}, !whole && t1_n_leaf[0]};
    // A node's end is compared a clock after it was summed up, beside the filters.
    reg  [LB:0]      t2_end_q;
    reg  [3:0]       t2_count_q;
    reg              t2_live_q;
    wire        t2_bad     = t2_count_q > 4'd4 || t2_end_q > {1'b0, mem_lines};
    always @(posedge clk) begin
        t1_valid_q <= rsp_valid;
        if (rsp_valid) begin                         // so that no filter switches for nothing
            t1_slot_q  <= rsp_slot;
            t1_fresh_q <= rsp_fresh;
            t1_kill_q  <= rsp_kill || rsp_error;
            t1_node_q  <= rsp_data;
        end
        visit_q       <= i3_valid_q && !i3_kill;
        if (t1_valid_q) begin
            t2_end_q   <= t1_end;
            t2_count_q <= t1_count;
        end
        t2_live_q     <= t1_valid_q && !t1_kill_q;
        tests_q       <= t2_live_q && !t2_bad ? t2_count_q[2:0] : 3'd0;
        bad_node_q    <= (i3_valid_q && i3_bad_line_q) || (t2_live_q && t2_bad);
        visit_limit_q <= i3_valid_q && i3_bad_limit_q && !i3_bad_line_q;
        bus_error_q   <= rsp_valid && rsp_error;
        if (rst) begin
            t1_valid_q <= 1'b0; t2_live_q <= 1'b0; visit_q <= 1'b0; tests_q <= 3'd0;
            bad_node_q <= 1'b0; visit_limit_q <= 1'b0; bus_error_q <= 1'b0;
        end
    end

    assign event_o[`RT_TRACE_EVENT_VISIT]  = visit_q;
    assign event_o[`RT_TRACE_EVENT_TESTS]  = tests_q;
    assign event_o[`RT_TRACE_EVENT_BUBBLE] = 1'b0;
    assign fault_o[`RT_ERROR_BAD_NODE]     = bad_node_q;
    assign fault_o[`RT_ERROR_STACK_OVERFLOW] = 1'b0;
    assign fault_o[`RT_ERROR_VISIT_LIMIT]  = visit_limit_q;
    assign fault_o[`RT_ERROR_BUS_ERROR]    = bus_error_q;

    // ---- what travels beside the filters and the sort ----
    localparam DW = SLOTW + 2 + LB + 6;
    wire [DW-1:0]    f_side;
    wire [SLOTW-1:0] f_slot, g_slot;
    wire             f_fresh, f_kill, g_fresh, g_kill, f_valid, g_valid;
    wire [`RT_LINE_BITS-1:0] f_base, g_base;
    wire [2:0]       f_n_inner, f_n_leaf, g_n_inner, g_n_leaf;
    rt_stages #(.WIDTH(DW), .CYCLES(LAT)) u_side (
        .clk(clk), .rst(rst), .in_valid_i(t1_valid_q),
        .in_i({t1_slot_q, t1_fresh_q, t1_kill_q, t1_base, t1_n_inner, t1_n_leaf}),
        .out_valid_o(f_valid), .out_o(f_side)
    );
    wire             f_killed, f_bad;
    rt_delay #(.WIDTH(1), .CYCLES(LAT-1)) u_bad (.clk(clk), .in_i(t2_bad), .out_o(f_bad));
    assign f_kill = f_killed || f_bad;
    assign {f_slot, f_fresh, f_killed, f_base, f_n_inner, f_n_leaf} = f_side;
    wire [3:0] f_inner   = ~(4'hf << f_n_inner);                   // children that are nodes
    wire [3:0] f_present = ~(4'hf << (f_n_inner + f_n_leaf));
    wire [3:0] f_hit     = f_kill ? 4'd0 : f_pass & f_present;
    // Equal depths are put in the order of the node; the smallest is below every limit: order.h.
    wire [63:0] f_depth = f_order ? {4{16'h8000}} : f_near;

    rt_sort u_sort (
        .clk(clk), .in_valid_i(f_valid), .hit_i(f_hit & f_inner), .near_i(f_depth),
        .count_o(found_o[`RT_FOUND_COUNT]), .list_o(found_o[`RT_FOUND_LIST])
    );
    rt_stages #(.WIDTH(DW), .CYCLES(1)) u_side_1 (
        .clk(clk), .rst(rst), .in_valid_i(f_valid),
        .in_i({f_slot, f_fresh, f_kill, f_base, f_n_inner, f_n_leaf}),
        .out_valid_o(g_valid), .out_o({g_slot, g_fresh, g_kill, g_base, g_n_inner, g_n_leaf})
    );
    reg [3:0]        f_leaf_q, leaf_q;
    reg              valid_q, fresh_q, kill_q;
    reg [SLOTW-1:0]  slot_q;
    reg [`RT_LINE_BITS-1:0] base_q, line_q;
    always @(posedge clk) begin
        f_leaf_q <= (f_hit & ~f_inner) >> f_n_inner;
        valid_q <= g_valid;
        if (g_valid) begin
            slot_q  <= g_slot;
            fresh_q <= g_fresh;
            kill_q  <= g_kill;
            base_q  <= g_base;
            leaf_q  <= f_leaf_q;
            line_q  <= g_base + {{(LB-3){1'b0}}, g_n_inner};
        end
        if (rst) valid_q <= 1'b0;
    end
    assign found_o[`RT_FOUND_VALID] = valid_q;
    assign found_o[`RT_FOUND_SLOT]  = slot_q;
    assign found_o[`RT_FOUND_FRESH] = fresh_q;
    assign found_o[`RT_FOUND_KILL]  = kill_q;
    assign found_o[`RT_FOUND_BASE]  = base_q;
    assign visit_o[`RT_VISIT_VALID] = valid_q && leaf_q != 4'd0;
    assign visit_o[`RT_VISIT_SLOT]  = slot_q;
    assign visit_o[`RT_VISIT_LEAF]  = leaf_q;
    assign visit_o[`RT_VISIT_LINE]  = line_q;
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_node_visits /* verilator public_flat_rd */ =
        {any_valid && !room, any_valid && room, 5'd0, any_valid && room};
    wire [7:0] work_node_cache /* verilator public_flat_rd */ =
        {req_valid && !req_ready, taken, 5'd0, taken};
    wire unused = &{1'b0, regs_i, effects, ray_i, filter_i, next_in_ready,
                    issue_in_ready, f_slot, f_fresh, f_base, g_n_leaf};
endmodule
`default_nettype wire
