// rt_leaf_unit.v - leaf children of a visit: fetched, tested exactly, given a key
// SPDX-License-Identifier: Apache-2.0
// Takes the leaf children that a visit left, reads their records through the leaf cache, tests them
// against the slot's ray, takes the root of a hit, and hands every result to rt_collect. The same
// cache serves the primitive records of rt_surface. At most HOLD spheres are under way behind the
// cache, so the queues in front of rt_collect cannot overflow; rt_facet can be held back.
// Model: sphere_visit(), line_visit() in cmodel/trace/leaf_unit.c
`default_nettype none
`include "rt_layout.vh"
module rt_leaf_unit #(
    parameter W     = 16,   // coordinate, bits
    parameter WD    = 17,   // direction component, bits
    parameter SLOTS = 32,   // power of two
    parameter SLOTW = 5,    // log2 of SLOTS
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
    input  wire              clk,
    input  wire              rst,
    input  wire              flush_i,       // forget the leaf cache
    input  wire              inside_on_i,   // run-time switches of INSIDE, FACETS
    input  wire              facets_on_i,
    // from rt_setup: the rays
    input  wire              ray_valid_i,
    input  wire [SLOTW-1:0]  ray_slot_i,
    input  wire              ray_shadow_i,
    input  wire [3*W-1:0]    ray_org_i,
    input  wire [3*WD-1:0]   ray_dir_i,
    input  wire [2*WD-1:0]   ray_a_i,
    input  wire [24:0]       ray_skip_i,    // {inside, id}
    // from rt_traverse: leaf children to test
    input  wire              in_valid_i,
    input  wire [SLOTW-1:0]  in_slot_i,
    input  wire [3:0]        in_leaf_i,     // bit j: leaf child j, not all 0
    input  wire [25:0]       in_line_i,     // line of leaf child 0
    // to rt_collect
    output wire              out_valid_o,
    output wire [SLOTW-1:0]  out_slot_o,
    output wire              out_hit_o,
    output wire              out_far_o,
    output wire [23:0]       out_id_o,
    output wire [W+WD+1:0]   out_key_o,
    // from and to rt_surface: primitive records
    input  wire              prim_valid_i,
    output wire              prim_ready_o,
    input  wire [SLOTW-1:0]  prim_slot_i,
    input  wire [25:0]       prim_line_i,
    output wire              prim_valid_o,
    input  wire              prim_ready_i,
    output wire [SLOTW-1:0]  prim_slot_o,
    output wire [255:0]      prim_data_o,
    // memory
    output wire              mem_req_valid_o,
    input  wire              mem_req_ready_i,
    output wire [25:0]       mem_req_line_o,
    input  wire              mem_rsp_valid_i,
    output wire              mem_rsp_ready_o,
    input  wire [255:0]      mem_rsp_data_i,
    input  wire              mem_rsp_error_i,
    // counters and errors
    output wire              test_o,        // a leaf test
    output wire              root_o,        // a square root
    output wire              facet_o,       // a facet test
    output wire              divide_o,      // a division for its key
    output wire              bad_node_o,    // a leaf line of no kind
    output wire              miss_o,
    output wire              bus_error_o
);
    localparam KW   = W + WD + 2;
    localparam XW   = 2*W + 2*WD;
    localparam HOLD = 16;
    localparam SB   = SHADOW != 0 ? 1 : 0;           // bits of a flag, if it is elaborated
    localparam IB   = INSIDE != 0 ? 1 : 0;
    localparam LB   = FACETS != 0 ? 256 : 128;       // bits of a leaf
    wire       whole = FACETS != 0 && facets_on_i;   // a line a leaf

    // ---- one candidate after the other: queue of slots, what to test in block RAM ----
    wire             q_valid, q_in_ready;
    wire [SLOTW-1:0] q_slot;
    reg              v_valid_q, open_q;              // a visit is at hand; todo_q is in use
    reg [SLOTW-1:0]  v_slot_q;
    reg [3:0]        todo_q;                         // left of the visit
    wire [29:0]      v;                              // {leaf children, line}
    wire [3:0]       todo = open_q ? todo_q : v[29:26];
    wire [1:0]       pick = todo[0] ? 2'd0 : todo[1] ? 2'd1 : todo[2] ? 2'd2 : 2'd3;
    wire [3:0]       rest = todo & (todo - 4'd1);
    wire             req_ready;
    wire             take = v_valid_q && req_ready && !prim_valid_i;
    wire             v_load = !v_valid_q || (take && rest == 4'd0);
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_queue (
        .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .in_ready_o(q_in_ready),
        .in_data_i(in_slot_i),
        .out_valid_o(q_valid), .out_ready_i(v_load), .out_data_o(q_slot)
    );
    rt_slot_ram #(.WIDTH(30), .SLOTS(SLOTS), .OLD(0)) u_visit (
        .clk(clk), .wr_en_i(in_valid_i), .wr_addr_i(in_slot_i),
        .wr_data_i({in_leaf_i, in_line_i}),
        .rd_en_i(v_load && q_valid), .rd_addr_i(q_slot), .rd_data_o(v)
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
    assign prim_ready_o = req_ready;
    rt_cache #(.TAG(TAG), .LINES(LINES), .PENDING(SLOTS)) u_cache (
        .clk(clk), .rst(rst), .flush_i(flush_i),
        .req_valid_i(prim_valid_i || v_valid_q), .req_ready_o(req_ready),
        .req_line_i(prim_valid_i ? prim_line_i
                    : v[25:0] + {24'd0, whole && pick[1], whole ? pick[0] : pick[1]}),
        .req_tag_i(prim_valid_i ? {prim_slot_i, 1'b0, 1'b1}
                                : {v_slot_q, pick[0] && !whole, 1'b0}),
        .rsp_valid_o(c_valid), .rsp_ready_i(c_ready), .rsp_data_o(c_data),
        .rsp_tag_o({c_slot, c_half, c_prim}), .rsp_error_o(c_error),
        .mem_req_valid_o(mem_req_valid_o), .mem_req_ready_i(mem_req_ready_i),
        .mem_req_line_o(mem_req_line_o),
        .mem_rsp_valid_i(mem_rsp_valid_i), .mem_rsp_ready_o(mem_rsp_ready_o),
        .mem_rsp_data_i(mem_rsp_data_i), .mem_rsp_error_i(mem_rsp_error_i),
        .miss_o(miss_o)
    );
    assign prim_valid_o = c_valid && c_prim;
    assign prim_slot_o  = c_slot;
    assign prim_data_o  = c_data;
    assign bus_error_o  = c_valid && c_ready && c_error;

    // ---- record and ray side by side ----
    reg              l_valid_q, l_error_q;
    reg [SLOTW-1:0]  l_slot_q;
    reg [LB-1:0]     l_leaf_q;
    wire             leaf_ready, credit, facet_ready;
    wire [1:0]       l_kind;                         // 0: for rt_leaf
    wire             l_bad   = l_kind == 2'd3;       // of no kind: a miss, as a bus error is
    wire             l_facet = l_kind == `RT_TRIANGLE || l_kind == `RT_PLANE;
    wire             l_taken = l_valid_q && (l_facet ? facet_ready : leaf_ready && credit);
    wire             l_load  = c_valid && !c_prim && (!l_valid_q || l_taken);
    assign c_ready = c_prim ? prim_ready_i : !l_valid_q || l_taken;
    localparam YW = 3*W + 5*WD + 24;                 // a ray; above it shadow, inside
    wire [YW+1:0]       y = {INSIDE != 0 ? {ray_shadow_i, ray_skip_i[24]} : {2{ray_shadow_i}},
                             ray_skip_i[23:0], ray_a_i, ray_dir_i, ray_org_i};
    wire [YW+SB+IB-1:0] l_ray;
    wire                l_shadow = SHADOW != 0 && l_ray[YW+SB+IB-1];
    wire                l_inside = INSIDE != 0 && l_ray[YW+IB-1];
    wire [23:0]         l_skip;
    wire [2*WD-1:0]     l_a;
    wire [3*WD-1:0]     l_dir;
    wire [3*W-1:0]      l_org;
    assign {l_skip, l_a, l_dir, l_org} = l_ray[YW-1:0];
    rt_slot_ram #(.WIDTH(YW+SB+IB), .SLOTS(SLOTS), .OLD(0)) u_ray (
        .clk(clk), .wr_en_i(ray_valid_i), .wr_addr_i(ray_slot_i), .wr_data_i(y[YW+SB+IB-1:0]),
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
    assign test_o     = l_taken && l_kind == 2'd0;
    assign facet_o    = l_taken && l_facet;
    assign bad_node_o = l_taken && l_bad;

    // ---- exact test ----
    wire             x_valid, x_hit, x_far, x_exit, x_shadow, x_error;
    wire [SLOTW-1:0] x_slot;
    wire [23:0]      x_id;
    wire [XW-1:0]    x_disc;
    wire signed [KW-1:0] x_b;
    wire [SLOTW+1:0] l_tag = {l_shadow, l_slot_q, l_error_q || l_bad};
    wire [SLOTW+SB:0] x_tag;
    assign {x_slot, x_error} = x_tag[SLOTW:0];
    assign x_shadow = SHADOW != 0 && x_tag[SLOTW+SB];
    rt_leaf #(.W(W), .WD(WD), .TAG(SLOTW+1+SB), .SHADOW(SHADOW), .INSIDE(INSIDE)) u_leaf (
        .clk(clk), .rst(rst), .inside_on_i(inside_on_i),
        .in_valid_i(l_valid_q && !l_facet && credit), .in_ready_o(leaf_ready),
        .in_tag_i(l_tag[SLOTW+SB:0]),
        .in_ctr_x_i($signed(l_leaf_q[`RT_LEAF_CTR_X_LSB +: W])),
        .in_ctr_y_i($signed(l_leaf_q[`RT_LEAF_CTR_Y_LSB +: W])),
        .in_ctr_z_i($signed(l_leaf_q[`RT_LEAF_CTR_Z_LSB +: W])),
        .in_rad_i(l_leaf_q[`RT_LEAF_RAD_LSB +: W]), .in_id_i(l_leaf_q[`RT_LEAF_ID_LSB +: 24]),
        .in_org_x_i($signed(l_org[0 +: W])), .in_org_y_i($signed(l_org[W +: W])),
        .in_org_z_i($signed(l_org[2*W +: W])),
        .in_dir_x_i($signed(l_dir[0 +: WD])), .in_dir_y_i($signed(l_dir[WD +: WD])),
        .in_dir_z_i($signed(l_dir[2*WD +: WD])), .in_a_i(l_a),
        .in_shadow_i(l_shadow), .in_skip_id_i(l_skip), .in_skip_inside_i(l_inside),
        .out_valid_o(x_valid), .out_tag_o(x_tag), .out_id_o(x_id),
        .out_hit_o(x_hit), .out_far_o(x_far), .out_exit_o(x_exit),
        .out_disc_o(x_disc), .out_b_o(x_b)
    );

    // ---- triangles and planes ----
    wire             f_valid, f_hit, f_far, f_taken;
    wire [SLOTW-1:0] f_slot;
    wire [23:0]      f_id;
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
                .divide_o(divide_o)
            );
        end else begin : g_spheres
            assign l_kind = 2'd0;
            assign {facet_ready, f_valid, f_hit, f_far, divide_o} = 5'd0;
            assign f_slot = {SLOTW{1'b0}};
            assign f_id   = 24'd0;
            assign f_key  = {KW{1'b0}};
            wire unused = &{1'b0, facets_on_i, l_facet, f_taken};
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
    assign root_o = r_valid && r_ready;
    reg [4:0] held_q;                                // candidates behind the credit
    wire      d_leaves = d_valid && d_taken;
    wire      left = (r_valid && r_ready) || d_leaves;
    wire      both = (r_valid && r_ready) && d_leaves;
    assign credit = held_q < HOLD - 1;
    always @(posedge clk) begin
        held_q <= held_q + {4'd0, l_taken && !l_facet} - {4'd0, left} - {4'd0, both};
        if (rst) held_q <= 5'd0;
    end
    // ---- to rt_collect: roots, which cannot wait long, then facets, then the others ----
    wire      d_far = INSIDE != 0 && (p_valid ? p_far : d[RW+IB]);
    assign f_taken = !p_valid;
    assign d_taken = !p_valid && !f_valid;
    assign out_valid_o = p_valid || f_valid || d_valid;
    assign {out_slot_o, out_id_o} = p_valid ? p_tag : f_valid ? {f_slot, f_id} : d[RW:1];
    assign out_far_o = f_valid && !p_valid ? f_far : d_far;
    assign out_hit_o = p_valid || (f_valid ? f_hit : d[0]);
    assign out_key_o = p_valid ? p_key : f_valid ? f_key : {{(KW-1){1'b0}}, 1'b1};
    wire unused = &{1'b0, q_in_ready, r_in, d_in, l_leaf_q, y, l_tag, r_all, d_all, ray_skip_i};
endmodule
`default_nettype wire
