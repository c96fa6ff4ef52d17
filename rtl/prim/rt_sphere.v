// rt_sphere.v - spheres, a kind of primitive: the test, the root of a hit, its key
// SPDX-License-Identifier: Apache-2.0
//   test --> rt_leaf --+-- a root is needed --> queue --> rt_sphere_key -+--> result
//                      +-- none is ----------> queue --------------------+
// No root is needed for a miss, for a ray to a light and for a ray that leaves its own sphere at
// once. rt_leaf cannot be held back: at most HOLD spheres are under way, so that the queues cannot
// overflow. Results leave in any order; one with a root is urgent, since it is there for one clock.
// Model: test() in cmodel/prim/sphere.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_sphere #(
    parameter W     = 16,   // coordinate, bits
    parameter WD    = 17,   // direction component, bits
    parameter NG    = 2,    // guard bits of a hit point
    parameter SLOTS = 32,   // power of two
    parameter ROOTS = 3,    // square roots under way at once
    parameter ROOT_STEP = 2, // root bits a clock
    parameter PR    = 0,    // significant bits of the root, 0: all
    parameter INTERVAL = 2, // clocks an exact test, 2 or 4
    parameter SHADOW = 1,   // 1: shadow rays
    parameter INSIDE = 1    // 1: rays that start inside a sphere
) (
    input  wire                       clk,
    input  wire                       rst,
    input  wire                       inside_on_i,    // switch of INSIDE, changes between tests
    // from and to rt_prim, as of each kind
    input  wire                       in_valid_i,
    output wire                       in_ready_o,
    input  wire [`RT_TEST_BITS-1:0]   test_i,
    //: {SLOT[SLOTW], RECORD[256], LIFT[3*(NG+2)], SKIP[24], A[2*WD], DIR[3*WD], ORG[3*W], ERROR,
    //: INSIDE, SHADOW}
    input  wire                       in_miss_i,      // a miss, whatever the record says
    output wire [`RT_RESULT_BITS-1:0] result_o,
    //: {SLOT[SLOTW], KEY[W+WD+2], ID[24], FAR, HIT, VALID}
    input  wire                       result_ready_i,
    output wire                       urgent_o,       // the result is taken in this clock
    // event
    output wire                       root_o          // a square root is begun
);
    localparam SLOTW = $clog2(SLOTS);
    localparam KW   = W + WD + 2;
    localparam XW   = 2*W + 2*WD;
    localparam HOLD = 16;
    localparam SB   = SHADOW != 0 ? 1 : 0;           // bits of a flag, if it is elaborated
    localparam IB   = INSIDE != 0 ? 1 : 0;
    wire [255:0]     record = test_i[`RT_TEST_RECORD];
    wire [3*W-1:0]   org    = test_i[`RT_TEST_ORG];
    wire [3*WD-1:0]  dir    = test_i[`RT_TEST_DIR];
    wire             shadow = SHADOW != 0 && test_i[`RT_TEST_SHADOW];
    wire             leaf_ready;
    reg              credit_q;                       // there is room for one more
    assign in_ready_o = leaf_ready && credit_q;

    // ---- exact test ----
    wire             x_valid, x_hit, x_far, x_exit, x_shadow, x_miss;
    wire [SLOTW-1:0] x_slot;
    wire [`RT_ID_BITS-1:0] x_id;
    wire [XW-1:0]    x_disc;
    wire signed [KW-1:0] x_b;
    wire [SLOTW+1:0] tag = {shadow, test_i[`RT_TEST_SLOT], in_miss_i};
    wire [SLOTW+SB:0] x_tag;
    assign {x_slot, x_miss} = x_tag[SLOTW:0];
    assign x_shadow = SHADOW != 0 && x_tag[SLOTW+SB];
    rt_leaf #(.W(W), .WD(WD), .TAG(SLOTW+1+SB), .SHADOW(SHADOW), .INSIDE(INSIDE),
              .INTERVAL(INTERVAL)) u_leaf (
        .clk(clk), .rst(rst), .inside_on_i(inside_on_i),
        .in_valid_i(in_valid_i && credit_q), .in_ready_o(leaf_ready),
        .in_tag_i(tag[SLOTW+SB:0]),
        .in_ctr_x_i($signed(record[`RT_LEAF_CTR_X_LSB +: W])),
        .in_ctr_y_i($signed(record[`RT_LEAF_CTR_Y_LSB +: W])),
        .in_ctr_z_i($signed(record[`RT_LEAF_CTR_Z_LSB +: W])),
        .in_rad_i(record[`RT_LEAF_RAD_LSB +: W]),
        .in_id_i(record[`RT_LEAF_ID_LSB +: `RT_LEAF_ID_BITS]),
        .in_org_x_i($signed(org[`RT_POINT_X])), .in_org_y_i($signed(org[`RT_POINT_Y])),
        .in_org_z_i($signed(org[`RT_POINT_Z])),
        .in_dir_x_i($signed(dir[`RT_VEC_X])), .in_dir_y_i($signed(dir[`RT_VEC_Y])),
        .in_dir_z_i($signed(dir[`RT_VEC_Z])), .in_a_i(test_i[`RT_TEST_A]),
        .in_shadow_i(shadow), .in_skip_id_i(test_i[`RT_TEST_SKIP]),
        .in_skip_inside_i(INSIDE != 0 && test_i[`RT_TEST_INSIDE]),
        .out_valid_o(x_valid), .out_tag_o(x_tag), .out_id_o(x_id),
        .out_hit_o(x_hit), .out_far_o(x_far), .out_exit_o(x_exit),
        .out_disc_o(x_disc), .out_b_o(x_b)
    );

    // ---- results with and without a root ----
    wire hit  = x_hit && !x_miss;
    wire root = hit && !x_shadow && !x_exit;
    localparam RW = SLOTW + `RT_ID_BITS;             // {slot, id}; far stands on top
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
    rt_sphere_key #(.W(W), .WD(WD), .PR(PR), .STAGES(ROOTS), .STEP(ROOT_STEP), .TAG(RW),
                    .INSIDE(INSIDE)) u_key (
        .clk(clk), .rst(rst),
        .in_valid_i(r_valid), .in_ready_o(r_ready), .in_tag_i(r[XW+KW +: RW]),
        .in_far_i(INSIDE != 0 && r[RW+XW+KW+IB-1]),
        .in_disc_i(r[KW +: XW]), .in_b_i($signed(r[KW-1:0])),
        .out_valid_o(p_valid), .out_tag_o(p_tag), .out_far_o(p_far), .out_key_o(p_key)
    );
    assign root_o = r_valid && r_ready;

    // ---- those under way: taken, and whose root is not begun, not given ----
    reg [4:0] held_q;                                // a clock late where some left
    reg [1:0] left_q;                                // so many left in the last clock
    wire      d_leaves = d_valid && d_taken;
    always @(posedge clk) begin
        left_q   <= {root_o && d_leaves, root_o != d_leaves};
        credit_q <= held_q < HOLD - 1;               // in clocks that follow none are taken
        held_q   <= held_q + {4'd0, in_valid_i && in_ready_o} - {3'd0, left_q};
        if (rst) begin held_q <= 5'd0; credit_q <= 1'b0; left_q <= 2'd0; end
    end

    // ---- results: those with a root first ----
    assign urgent_o = p_valid;
    assign d_taken  = result_ready_i && !p_valid;
    assign result_o[`RT_RESULT_VALID] = p_valid || d_valid;
    assign {result_o[`RT_RESULT_SLOT], result_o[`RT_RESULT_ID]} = p_valid ? p_tag : d[RW:1];
    assign result_o[`RT_RESULT_FAR] = INSIDE != 0 && (p_valid ? p_far : d[RW+IB]);
    assign result_o[`RT_RESULT_HIT] = p_valid || d[0];
    assign result_o[`RT_RESULT_KEY] = p_valid ? p_key : {{(KW-1){1'b0}}, 1'b1};
    wire unused = &{1'b0, r_in, d_in, record, tag, r_all, d_all, test_i};
endmodule
`default_nettype wire
