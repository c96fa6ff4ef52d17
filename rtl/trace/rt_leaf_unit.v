// rt_leaf_unit.v - leaf children of a visit: fetched, tested exactly, given a key
// SPDX-License-Identifier: Apache-2.0
// Takes the leaf children that a visit left, reads their records through the leaf cache, tests them
// against the slot's ray, takes the root of a hit, and hands every result to rt_trace. The same
// cache serves the primitive records of rt_shade. At most HOLD spheres are under way behind the
// cache, so the queues in front of the results cannot overflow; rt_facet can be held back.
// Model: sph_leaf_visit() in cmodel/trace/leaf_unit.c
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_leaf_unit #(
    parameter W     = 16,   // coordinate, bits
    parameter WD    = 17,   // direction component, bits
    parameter SLOTS = 32,   // power of two
    parameter LINES = 64,   // leaf cache, lines
    parameter ROOTS = 3,    // square root units
    parameter ROOT_STEP = 2, // root bits a clock
    parameter PR    = 0,    // significant bits of the root, 0: all
    parameter SHADOW = 1,   // 1: shadow rays
    parameter INSIDE = 1,   // 1: rays that start inside a sphere
    parameter FACETS = 0,   // 1: triangles and planes too, a line a leaf
    parameter DIVISIONS = 1, // dividers for their keys
    parameter DIVISION_STEP = 2 // bits of a key a clock
) (
    input  wire                       clk,
    input  wire                       rst,
    input  wire                       flush_i,    // forget the leaf cache
    input  wire [`RT_REGS_BITS-1:0]   regs_i,
    input  wire [`RT_RAY_BITS-1:0]    ray_i,      // from rt_setup
    input  wire [`RT_VISIT_BITS-1:0]  visit_i,    // from rt_trace: leaf children to test
    output wire [`RT_RESULT_BITS-1:0] result_o,   // to rt_trace
    // from and to rt_shade: primitive records
    input  wire [`RT_FETCH_BITS-1:0]  fetch_i,
    output wire                       fetch_ready_o,
    output wire [`RT_RECORD_BITS-1:0] record_o,
    input  wire                       record_ready_i,
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
    output wire [3:0]                 fault_o     // by number of the error, machine.def
);
    localparam SLOTW = $clog2(SLOTS);
    localparam KW   = W + WD + 2;
    localparam XW   = 2*W + 2*WD;
    localparam HOLD = 16;
    localparam SB   = SHADOW != 0 ? 1 : 0;           // bits of a flag, if it is elaborated
    localparam IB   = INSIDE != 0 ? 1 : 0;
    localparam LB   = FACETS != 0 ? 256 : 128;       // bits of a leaf
    wire [`RT_EFFECT_BITS-1:0] effects = regs_i[`RT_REGS_EFFECTS];
    wire       whole = FACETS != 0 && effects[`RT_EFFECT_FACETS];  // a line a leaf
    wire       prim  = fetch_i[`RT_FETCH_VALID];     // a primitive record goes first

    // ---- one candidate after the other: queue of slots, what to test in block RAM ----
    wire             q_valid, q_in_ready;
    wire [SLOTW-1:0] q_slot;
    reg              v_valid_q, open_q;              // a visit is at hand; todo_q is in use
    reg [SLOTW-1:0]  v_slot_q;
    reg [3:0]        todo_q;                         // left of the visit
    wire [3:0]       v_leaf;
    wire [`RT_LINE_BITS-1:0] v_line;
    wire [3:0]       todo = open_q ? todo_q : v_leaf;
    wire [1:0]       pick = todo[0] ? 2'd0 : todo[1] ? 2'd1 : todo[2] ? 2'd2 : 2'd3;
    wire [3:0]       rest = todo & (todo - 4'd1);
    wire             req_ready;
    wire             take = v_valid_q && req_ready && !prim;
    wire             v_load = !v_valid_q || (take && rest == 4'd0);
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_queue (
        .clk(clk), .rst(rst), .in_valid_i(visit_i[`RT_VISIT_VALID]), .in_ready_o(q_in_ready),
        .in_data_i(visit_i[`RT_VISIT_SLOT]),
        .out_valid_o(q_valid), .out_ready_i(v_load), .out_data_o(q_slot)
    );
    rt_slot_ram #(.WIDTH(30), .SLOTS(SLOTS), .OLD(0)) u_visit (
        .clk(clk), .wr_en_i(visit_i[`RT_VISIT_VALID]), .wr_addr_i(visit_i[`RT_VISIT_SLOT]),
        .wr_data_i({visit_i[`RT_VISIT_LEAF], visit_i[`RT_VISIT_LINE]}),
        .rd_en_i(v_load && q_valid), .rd_addr_i(q_slot), .rd_data_o({v_leaf, v_line})
    );
    always @(posedge clk) begin
        if (v_load) begin
            v_valid_q <= q_valid;
            v_slot_q  <= q_slot;
        end
        if (take) begin
            todo_q <= rest;
            open_q <= rest != 4'd0;
        end
        if (rst) begin v_valid_q <= 1'b0; open_q <= 1'b0; end
    end

    // ---- leaf cache, shared with primitive records ----
    localparam TAG = SLOTW + 2;                      // {slot, half, is prim}
    wire             c_valid, c_ready, c_half, c_prim, c_error;
    wire [SLOTW-1:0] c_slot;
    wire [255:0]     c_data;
    assign fetch_ready_o = req_ready;
    rt_cache #(.TAG(TAG), .LINES(LINES), .PENDING(SLOTS)) u_cache (
        .clk(clk), .rst(rst), .flush_i(flush_i),
        .req_valid_i(prim || v_valid_q), .req_ready_o(req_ready),
        .req_line_i(prim ? fetch_i[`RT_FETCH_LINE]
                    : v_line + {24'd0, whole && pick[1], whole ? pick[0] : pick[1]}),
        .req_tag_i(prim ? {fetch_i[`RT_FETCH_SLOT], 1'b0, 1'b1}
                        : {v_slot_q, pick[0] && !whole, 1'b0}),
        .rsp_valid_o(c_valid), .rsp_ready_i(c_ready), .rsp_data_o(c_data),
        .rsp_tag_o({c_slot, c_half, c_prim}), .rsp_error_o(c_error),
        .mem_req_valid_o(mem_req_valid_o), .mem_req_ready_i(mem_req_ready_i),
        .mem_req_line_o(mem_req_line_o),
        .mem_rsp_valid_i(mem_rsp_valid_i), .mem_rsp_ready_o(mem_rsp_ready_o),
        .mem_rsp_data_i(mem_rsp_data_i), .mem_rsp_error_i(mem_rsp_error_i),
        .miss_o(event_o[`RT_EXACT_EVENT_MISS])
    );
    assign record_o[`RT_RECORD_VALID] = c_valid && c_prim;
    assign record_o[`RT_RECORD_SLOT]  = c_slot;
    assign record_o[`RT_RECORD_DATA]  = c_data;
    assign fault_o[`RT_ERROR_BUS_ERROR] = c_valid && c_ready && c_error;
    assign fault_o[`RT_ERROR_STACK_OVERFLOW] = 1'b0;
    assign fault_o[`RT_ERROR_VISIT_LIMIT]    = 1'b0;

    // ---- record and ray side by side ----
    reg              l_valid_q, l_error_q;
    reg [SLOTW-1:0]  l_slot_q;
    reg [LB-1:0]     l_leaf_q;
    wire             leaf_ready, credit, facet_ready;
    wire [1:0]       l_kind;                         // 0: for rt_leaf
    wire             l_bad   = l_kind == 2'd3;       // no kind: counts as a miss, as a bus error
    wire             l_facet = l_kind == `RT_TRIANGLE || l_kind == `RT_PLANE;
    wire             l_taken = l_valid_q && (l_facet ? facet_ready : leaf_ready && credit);
    wire             l_load  = c_valid && !c_prim && (!l_valid_q || l_taken);
    assign c_ready = c_prim ? record_ready_i : !l_valid_q || l_taken;
    localparam YW = 3*W + 5*WD + 24;                 // a ray; above it shadow, inside
    wire                shadow = ray_i[`RT_RAY_SHADOW];
    wire [YW+1:0]       y = {INSIDE != 0 ? {shadow, ray_i[`RT_RAY_INSIDE]} : {2{shadow}},
                             ray_i[`RT_RAY_SKIP], ray_i[`RT_RAY_A], ray_i[`RT_RAY_DIR],
                             ray_i[`RT_RAY_ORG]};
    wire [YW+SB+IB-1:0] l_ray;
    wire                l_shadow = SHADOW != 0 && l_ray[YW+SB+IB-1];
    wire                l_inside = INSIDE != 0 && l_ray[YW+IB-1];
    wire [23:0]         l_skip;
    wire [2*WD-1:0]     l_a;
    wire [3*WD-1:0]     l_dir;
    wire [3*W-1:0]      l_org;
    assign {l_skip, l_a, l_dir, l_org} = l_ray[YW-1:0];
    rt_slot_ram #(.WIDTH(YW+SB+IB), .SLOTS(SLOTS), .OLD(0)) u_ray (
        .clk(clk), .wr_en_i(ray_i[`RT_RAY_VALID]), .wr_addr_i(ray_i[`RT_RAY_SLOT]),
        .wr_data_i(y[YW+SB+IB-1:0]),
        .rd_en_i(l_load), .rd_addr_i(c_slot), .rd_data_o(l_ray)
    );
    always @(posedge clk) begin
        if (l_load) begin
            l_slot_q  <= c_slot;
            l_leaf_q[127:0] <= c_half ? c_data[255:128] : c_data[127:0];
            l_error_q <= c_error;
        end
        if (l_load || l_taken) l_valid_q <= l_load;
        if (rst) l_valid_q <= 1'b0;
    end
    assign event_o[`RT_EXACT_EVENT_LEAF]  = l_taken && l_kind == 2'd0;
    assign event_o[`RT_EXACT_EVENT_FACET] = l_taken && l_facet;
    assign fault_o[`RT_ERROR_BAD_NODE]    = l_taken && l_bad;

    // ---- exact test ----
    wire             x_valid, x_hit, x_far, x_exit, x_shadow, x_error;
    wire [SLOTW-1:0] x_slot;
    wire [`RT_ID_BITS-1:0] x_id;
    wire [XW-1:0]    x_disc;
    wire signed [KW-1:0] x_b;
    wire [SLOTW+1:0] l_tag = {l_shadow, l_slot_q, l_error_q || l_bad};
    wire [SLOTW+SB:0] x_tag;
    assign {x_slot, x_error} = x_tag[SLOTW:0];
    assign x_shadow = SHADOW != 0 && x_tag[SLOTW+SB];
    rt_leaf #(.W(W), .WD(WD), .TAG(SLOTW+1+SB), .SHADOW(SHADOW), .INSIDE(INSIDE)) u_leaf (
        .clk(clk), .rst(rst), .inside_on_i(effects[`RT_EFFECT_INSIDE]),
        .in_valid_i(l_valid_q && !l_facet && credit), .in_ready_o(leaf_ready),
        .in_tag_i(l_tag[SLOTW+SB:0]),
        .in_ctr_x_i($signed(l_leaf_q[`RT_LEAF_CTR_X_LSB +: W])),
        .in_ctr_y_i($signed(l_leaf_q[`RT_LEAF_CTR_Y_LSB +: W])),
        .in_ctr_z_i($signed(l_leaf_q[`RT_LEAF_CTR_Z_LSB +: W])),
        .in_rad_i(l_leaf_q[`RT_LEAF_RAD_LSB +: W]),
        .in_id_i(l_leaf_q[`RT_LEAF_ID_LSB +: `RT_LEAF_ID_BITS]),
        .in_org_x_i($signed(l_org[`RT_POINT_X])), .in_org_y_i($signed(l_org[`RT_POINT_Y])),
        .in_org_z_i($signed(l_org[`RT_POINT_Z])),
        .in_dir_x_i($signed(l_dir[`RT_VEC_X])), .in_dir_y_i($signed(l_dir[`RT_VEC_Y])),
        .in_dir_z_i($signed(l_dir[`RT_VEC_Z])), .in_a_i(l_a),
        .in_shadow_i(l_shadow), .in_skip_id_i(l_skip), .in_skip_inside_i(l_inside),
        .out_valid_o(x_valid), .out_tag_o(x_tag), .out_id_o(x_id),
        .out_hit_o(x_hit), .out_far_o(x_far), .out_exit_o(x_exit),
        .out_disc_o(x_disc), .out_b_o(x_b)
    );

    // ---- triangles and planes ----
    wire             f_valid, f_hit, f_far, f_taken;
    wire [SLOTW-1:0] f_slot;
    wire [`RT_ID_BITS-1:0] f_id;
    wire [KW-1:0]    f_key;
    generate
        if (FACETS != 0) begin : g_facets
            always @(posedge clk) if (l_load) l_leaf_q[LB-1:128] <= c_data[255:128];
            assign l_kind = whole && !l_error_q ? l_leaf_q[`RT_FACET_KIND_LSB +: 2] : 2'd0;
            rt_facet #(.W(W), .WD(WD), .TAG(SLOTW), .SHADOW(SHADOW), .STEP(DIVISION_STEP),
                       .UNITS(DIVISIONS)) u_facet (
                .clk(clk), .rst(rst),
                .in_valid_i(l_valid_q && l_facet), .in_ready_o(facet_ready),
                .in_tag_i(l_slot_q), .in_plane_i(l_kind == `RT_PLANE),
                .in_v0_i(l_leaf_q[`RT_TRIANGLE_V0_X_LSB +: 72]),
                .in_v1_i(l_leaf_q[`RT_TRIANGLE_V1_X_LSB +: 72]),
                .in_v2_i(l_leaf_q[`RT_TRIANGLE_V2_X_LSB +: 72]),
                .in_id_i(l_leaf_q[`RT_FACET_ID_LSB +: 24]),
                .in_before_i(l_leaf_q[`RT_FACET_BEFORE_LSB +: 7]),
                .in_after_i(l_leaf_q[`RT_FACET_AFTER_LSB +: 7]),
                .in_org_i(l_org), .in_dir_i(l_dir), .in_a_i(l_a),
                .in_shadow_i(l_shadow), .in_skip_id_i(l_skip),
                .out_valid_o(f_valid), .out_ready_i(f_taken), .out_tag_o(f_slot),
                .out_id_o(f_id), .out_hit_o(f_hit), .out_far_o(f_far), .out_key_o(f_key),
                .divide_o(event_o[`RT_EXACT_EVENT_DIVIDE])
            );
        end else begin : g_spheres
            assign l_kind = 2'd0;
            assign {facet_ready, f_valid, f_hit, f_far} = 4'd0;
            assign event_o[`RT_EXACT_EVENT_DIVIDE] = 1'b0;
            assign f_slot = {SLOTW{1'b0}};
            assign f_id   = 24'd0;
            assign f_key  = {KW{1'b0}};
            wire unused = &{1'b0, l_facet, f_taken};
        end
    endgenerate

    // ---- results with and without a root ----
    wire hit  = x_hit && !x_error;
    wire root = hit && !x_shadow && !x_exit;
    localparam RW = SLOTW + 24;                      // {slot, id}; far stands on top
    wire               r_valid, r_ready, d_valid, d_taken, r_in, d_in, p_valid, p_far;
    wire [RW+XW+KW:0]  r_all = {x_far, x_slot, x_id, x_disc, x_b};
    wire [RW+1:0]      d_all = {x_far, x_slot, x_id, hit};
    wire [RW+XW+KW+IB-1:0] r;
    wire [RW+IB:0]     d;
    wire [RW-1:0]      p_tag;
    wire [KW-1:0]      p_key;
    rt_fifo #(.WIDTH(RW+XW+KW+IB), .DEPTH(HOLD)) u_roots (
        .clk(clk), .rst(rst), .in_valid_i(x_valid && root), .in_ready_o(r_in),
        .in_data_i(r_all[RW+XW+KW+IB-1:0]),
        .out_valid_o(r_valid), .out_ready_i(r_ready), .out_data_o(r)
    );
    rt_fifo #(.WIDTH(RW+IB+1), .DEPTH(HOLD)) u_direct (
        .clk(clk), .rst(rst), .in_valid_i(x_valid && !root), .in_ready_o(d_in),
        .in_data_i(d_all[RW+IB:0]),
        .out_valid_o(d_valid), .out_ready_i(d_taken), .out_data_o(d)
    );
    rt_root_pool #(.W(W), .WD(WD), .PR(PR), .UNITS(ROOTS), .STEP(ROOT_STEP), .TAG(RW),
                   .INSIDE(INSIDE)) u_pool (
        .clk(clk), .rst(rst),
        .in_valid_i(r_valid), .in_ready_o(r_ready), .in_tag_i(r[XW+KW +: RW]),
        .in_far_i(INSIDE != 0 && r[RW+XW+KW+IB-1]),
        .in_disc_i(r[KW +: XW]), .in_b_i($signed(r[KW-1:0])),
        .out_valid_o(p_valid), .out_ready_i(1'b1), .out_tag_o(p_tag), .out_far_o(p_far),
        .out_key_o(p_key)
    );
    assign event_o[`RT_EXACT_EVENT_ROOT] = r_valid && r_ready;
    reg [4:0] held_q;                                // candidates behind the credit
    wire      d_leaves = d_valid && d_taken;
    wire      left = (r_valid && r_ready) || d_leaves;
    wire      both = (r_valid && r_ready) && d_leaves;
    assign credit = held_q < HOLD - 1;
    always @(posedge clk) begin
        held_q <= held_q + {4'd0, l_taken && !l_facet} - {4'd0, left} - {4'd0, both};
        if (rst) held_q <= 5'd0;
    end

    // ---- to rt_trace: roots, which cannot wait long, then facets, then the others ----
    wire      d_far = INSIDE != 0 && (p_valid ? p_far : d[RW+IB]);
    assign f_taken = !p_valid;
    assign d_taken = !p_valid && !f_valid;
    assign result_o[`RT_RESULT_VALID] = p_valid || f_valid || d_valid;
    assign {result_o[`RT_RESULT_SLOT], result_o[`RT_RESULT_ID]} =
        p_valid ? p_tag : f_valid ? {f_slot, f_id} : d[RW:1];
    assign result_o[`RT_RESULT_FAR] = f_valid && !p_valid ? f_far : d_far;
    assign result_o[`RT_RESULT_HIT] = p_valid || (f_valid ? f_hit : d[0]);
    assign result_o[`RT_RESULT_KEY] = p_valid ? p_key : f_valid ? f_key : {{(KW-1){1'b0}}, 1'b1};
    wire unused = &{1'b0, q_in_ready, r_in, d_in, l_leaf_q, y, l_tag, r_all, d_all, ray_i, regs_i,
                    effects};
endmodule
`default_nettype wire
