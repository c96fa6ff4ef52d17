// rt_facet.v - triangles and planes, kinds of primitives: the exact test and the key of a hit
// SPDX-License-Identifier: Apache-2.0
//   test --> rt_facet_sums --> signs --+-- hit, to no light --> rt_facet_key --+--> result
//        +-> queue: tag, a, room, size +-- others -----------> queue ----------+
// A facet every INTERVAL clocks, after a plane at least `RT_FACET_PLANE. Nothing can be held back
// behind the start: at most HOLD facets are under way, so that no queue overflows. Results leave in
// any order, keys first.
//   triangle  hit if s*det > 0, s*num > 0 and all s*Ui >= 0, s the sign of det, U0 = det-U1-U2
//   plane     hit if s*det > 0, s*num > 0          to a light: a miss if s*num >= s*det
//                                  and unless s*(num*2^NG + N.lift) > |N_x| + |N_y| + |N_z|
// Ports, timing: docs/design/primitives.md. Model: sph_facet_test() in cmodel/prim/facet.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
`include "rt_fx.vh"
`include "rt_facet.vh"
module rt_facet #(
    parameter W   = 16,                          // coordinate, bits
    parameter WD  = 17,                          // direction component, bits
    parameter SLOTS = 32,                        // power of two
    parameter NG  = 2,                           // guard bits of a hit point
    parameter SHADOW = 1,                        // 1: some rays end at a light
    parameter INTERVAL = 2                       // clocks a facet, 1, 2 or 4
) (
    input  wire                       clk,
    input  wire                       rst,       // synchronous, active high
    // from and to rt_prim, as of each kind
    input  wire                       in_valid_i,
    output wire                       in_ready_o,
    input  wire [`RT_TEST_BITS-1:0]   test_i,
    //: {SLOT[SLOTW], RECORD[256], LIFT[3*(NG+2)], SKIP[24], A[2*WD], DIR[3*WD], ORG[3*W], ERROR,
    //: INSIDE, SHADOW}
    output wire [`RT_RESULT_BITS-1:0] result_o,
    //: {SLOT[SLOTW], KEY[W+WD+2], ID[24], FAR, HIT, VALID}
    input  wire                       result_ready_i,
    // event
    output wire                       divide_o   // a key begins
);
    localparam TAG  = $clog2(SLOTS) + `RT_ID_BITS;       // {slot, id}
    localparam DW   = (2*W > 24 ? 2*W : 24) + WD + 1;    // det' (docs/design/primitives.md)
    localparam MW   = 3*W + 1 > W + 25 ? 3*W + 1 : W + 25;  // num'
    localparam VW   = (DW > MW ? DW : MW) + 1;           // det, num, Ui, signed
    localparam LATENCY = `RT_FACET_SUMS_LATENCY(W, WD, INTERVAL);
    localparam CW   = `RT_FACET_WIDE(W, WD);             // a component of N
    localparam NORMAL = `RT_FACET_NORMAL(W, WD, INTERVAL);
    localparam HOLD = 16;
    wire [255:0] record = test_i[`RT_TEST_RECORD];
    wire         plane  = record[`RT_FACET_KIND_LSB +: `RT_FACET_KIND_BITS] == `RT_PLANE;
    wire [`RT_ID_BITS-1:0] id = record[`RT_FACET_ID_LSB +: `RT_FACET_ID_BITS];
    wire [3*W-1:0]  org = test_i[`RT_TEST_ORG];
    wire [3*WD-1:0] dir = test_i[`RT_TEST_DIR];
    wire            shadow = SHADOW != 0 && test_i[`RT_TEST_SHADOW];

    // ---- those under way: taken, and not yet given ----
    reg  [4:0] held_q;
    reg  [2:0] pause_q;                          // clocks until the next facet may come
    wire       given, take;
    assign in_ready_o = held_q < HOLD && pause_q == 3'd0;
    assign take = in_valid_i && in_ready_o;
    localparam [31:0] PAUSE = INTERVAL - 1;
    localparam [31:0] PLANE_PAUSE = `RT_FACET_PLANE(W, WD) > INTERVAL ? `RT_FACET_PLANE(W, WD) - 1
                                                                      : PAUSE;
    always @(posedge clk) begin
        held_q <= held_q + {4'd0, take} - {4'd0, given};
        pause_q <= take ? (plane ? PLANE_PAUSE[2:0] : PAUSE[2:0])
                   : pause_q == 3'd0 ? 3'd0 : pause_q - 3'd1;
        if (rst) {held_q, pause_q} <= 8'd0;
    end

    // ---- sums ----
    wire signed [VW-1:0] det, num, u2, v;        // v: -U1
    wire                 s0_valid;
    wire [3*CW-1:0]      n;                      // N, NORMAL clocks after its facet was taken
    rt_facet_sums #(.W(W), .WD(WD), .INTERVAL(INTERVAL), .VW(VW)) u_sums (
        .clk(clk), .take_i(take), .plane_i(plane), .v0_i(record[`RT_TRIANGLE_V0_X_LSB +: 72]),
        .v1_i(record[`RT_TRIANGLE_V1_X_LSB +: 72]), .v2_i(record[`RT_TRIANGLE_V2_X_LSB +: 72]),
        .org_i(org), .dir_i(dir), .n_o(n), .det_o(det), .num_o(num), .u2_o(u2), .v_o(v)
    );
    rt_delay_valid #(.CYCLES(LATENCY)) u_valid (
        .clk(clk), .rst(rst), .in_i(take), .out_o(s0_valid)
    );

    // ---- meanwhile: is it of the ray's own group? the longest axis of dir, size and room ----
    reg  [24:0]     t1_apart_q;                  // skip - id
    reg  [5:0]      t1_before_q, t1_after_q;
    reg  [3*W-1:0]  t1_org_q;
    reg  [3*WD-1:0] t1_dir_q;
    reg             t1_q, t2_q, t2_own_q, t3_q, t3_own_q, t3_z_q, t3_y_q;
    reg  [3*W-1:0]  t2_org_q, t3_org_q;
    reg  [3*WD-1:0] t2_size_q, t3_size_q;
    reg  [2:0]      t2_neg_q, t3_neg_q;
    wire [6:0]      reach = {1'b0, t1_apart_q[5:0]} + {1'b0, t1_before_q};
    wire            own   = t1_apart_q[24:6] == 19'd0 ? t1_apart_q[5:0] <= t1_after_q
                            : &t1_apart_q[24:6] && reach[6];
    function [WD-1:0] size_of(input [WD-1:0] d);
        size_of = (d ^ {WD{d[WD-1]}}) + {{(WD-1){1'b0}}, d[WD-1]};
    endfunction
    wire [WD-1:0] size_x = t2_size_q[0 +: WD];
    wire [WD-1:0] size_y = t2_size_q[WD +: WD];
    wire [WD-1:0] size_z = t2_size_q[2*WD +: WD];
    wire          y_wins = size_y > size_x;
    wire [W-1:0]  w_org  = t3_z_q ? t3_org_q[2*W +: W] : t3_y_q ? t3_org_q[W +: W]
                           : t3_org_q[0 +: W];
    wire          w_neg  = t3_z_q ? t3_neg_q[2] : t3_y_q ? t3_neg_q[1] : t3_neg_q[0];
    wire [WD-1:0] w_size = t3_z_q ? t3_size_q[2*WD +: WD] : t3_y_q ? t3_size_q[WD +: WD]
                           : t3_size_q[0 +: WD];
    wire [W:0]    w_room = {1'b0, {!w_org[W-1], w_org[W-2:0]} ^ {W{!w_neg}}} + {{W{1'b0}}, 1'b1};
    always @(posedge clk) begin
        t1_q        <= take;
        t1_apart_q  <= {1'b0, test_i[`RT_TEST_SKIP]} - {1'b0, id};
        t1_before_q <= record[`RT_FACET_BEFORE_LSB +: `RT_FACET_BEFORE_BITS];
        t1_after_q  <= record[`RT_FACET_AFTER_LSB +: `RT_FACET_AFTER_BITS];
        t1_org_q    <= org;
        t1_dir_q    <= dir;
        t2_q        <= t1_q;
        t2_own_q    <= own;
        t2_org_q    <= t1_org_q;
        t2_size_q   <= {size_of(t1_dir_q[2*WD +: WD]), size_of(t1_dir_q[WD +: WD]),
                        size_of(t1_dir_q[0 +: WD])};
        t2_neg_q    <= {t1_dir_q[3*WD-1], t1_dir_q[2*WD-1], t1_dir_q[WD-1]};
        t3_q        <= t2_q;
        t3_own_q    <= t2_own_q;
        t3_org_q    <= t2_org_q;
        t3_size_q   <= t2_size_q;
        t3_neg_q    <= t2_neg_q;
        t3_y_q      <= y_wins;
        t3_z_q      <= y_wins ? size_z > size_y : size_z > size_x;
        if (rst) {t1_q, t2_q, t3_q} <= 3'd0;
    end

    // ---- what waits for the sums ----
    localparam AB = TAG + 2 + 2*WD, BB = 1 + W + 1 + WD;
    wire [AB-1:0] a_all;
    wire [BB-1:0] b_all;
    wire          a_in, a_valid, b_in, b_valid, s2_q_valid;
    rt_fifo #(.WIDTH(AB), .DEPTH(HOLD)) u_tags (
        .clk(clk), .rst(rst), .in_valid_i(take), .in_ready_o(a_in),
        .in_data_i({test_i[`RT_TEST_SLOT], id, shadow, plane, test_i[`RT_TEST_A]}),
        .out_valid_o(a_valid), .out_ready_i(s2_q_valid), .out_data_o(a_all)
    );
    rt_fifo #(.WIDTH(BB), .DEPTH(HOLD)) u_ways (
        .clk(clk), .rst(rst), .in_valid_i(t3_q), .in_ready_o(b_in),
        .in_data_i({t3_own_q, w_room, w_size}),
        .out_valid_o(b_valid), .out_ready_i(s2_q_valid), .out_data_o(b_all)
    );
    wire            is_shadow = SHADOW != 0 && a_all[2*WD+1];
    wire            is_plane  = a_all[2*WD];
    wire            is_own    = b_all[BB-1];

    // ---- signs: stage 1 of the sums, det - num and U1 + U2; stage 2 of what they give ----
    reg                 s1_valid_q, s2_valid_q;
    reg  signed [VW-1:0] s1_det_q, s1_num_q, s1_u2_q, s1_v_q, s1_rest_q;   // rest: det - num
    reg  [VW-1:0]       s1_less_q;                                         // U1 + U2
    wire signed [VW-1:0] s1_u0 = s1_det_q - $signed(s1_less_q);
    reg  [DW-1:0]       s2_det_q;                // det'
    reg  [MW-1:0]       s2_num_q;                // num'
    reg                 s2_neg_q, s2_miss_q, s2_out_q, s2_late_q;
    wire                neg    = s1_det_q[VW-1];
    wire [VW-1:0]       size_d = (s1_det_q ^ {VW{neg}}) + {{(VW-1){1'b0}}, neg};
    wire [VW-1:0]       size_n = (s1_num_q ^ {VW{neg}}) + {{(VW-1){1'b0}}, neg};
    function outside(input [VW-1:0] u, input s);  // u has the other sign
        outside = u != {VW{1'b0}} && u[VW-1] != s;
    endfunction
    always @(posedge clk) begin
        s1_valid_q <= s0_valid;
        s1_det_q   <= det;
        s1_num_q   <= num;
        s1_u2_q    <= u2;
        s1_v_q     <= v;
        s1_rest_q  <= det - num;
        s1_less_q  <= u2 - v;
        s2_valid_q <= s1_valid_q;
        s2_det_q   <= size_d[DW-1:0];
        s2_num_q   <= size_n[MW-1:0];
        s2_neg_q   <= neg;
        s2_miss_q  <= s1_det_q == {VW{1'b0}} || s1_num_q == {VW{1'b0}} || s1_num_q[VW-1] != neg;
        s2_late_q  <= s1_rest_q == {VW{1'b0}} || s1_rest_q[VW-1] != neg;
        s2_out_q   <= outside(s1_u2_q, neg) || outside(s1_v_q, !neg) || outside(s1_u0, neg);
        if (rst) {s1_valid_q, s2_valid_q} <= 2'd0;
    end
    assign s2_q_valid = s2_valid_q;

    // ---- behind where the ray's origin was rounded from, or as good as: num'*2^NG <= K ----
    localparam KW = CW + NG + 3;                 // K = |N_x| + |N_y| + |N_z| - s*N.lift
    localparam CMP = MW > CW + 2 ? MW : CW + 2;
    wire s2_behind;
    generate
        if (SHADOW != 0) begin : g_ahead
            reg  [3*(NG+2)-1:0] t1_lift_q;
            wire [3*(NG+2)-1:0] lift;
            wire [CW+NG+1:0]    s1_along;
            wire                s1_carry;
            wire [CW:0]         s1_size;
            reg  [KW-1:0]       s2_k_q;
            rt_delay #(.WIDTH(3*(NG+2)), .CYCLES(NORMAL-1)) u_lift (
                .clk(clk), .in_i(t1_lift_q), .out_o(lift)
            );
            rt_facet_ahead #(.CW(CW), .NG(NG), .WAIT(LATENCY - NORMAL - 2)) u_ahead (
                .clk(clk), .n_i(n), .lift_i(lift), .along_o(s1_along), .carry_o(s1_carry),
                .size_o(s1_size)
            );
            wire [KW-1:0] turned = {s1_along[CW+NG+1], s1_along} ^ {KW{!neg}};
            wire [KW:0]   k = {{(NG+2){1'b0}}, s1_size, 1'b1} + {turned, s1_carry == neg};
            wire [CMP-1:0] least = {{(CMP-CW-2){1'b0}}, s2_k_q[KW-2:NG]};
            always @(posedge clk) begin
                if (take) t1_lift_q <= test_i[`RT_TEST_LIFT];
                s2_k_q <= k[KW:1];
            end
            assign s2_behind = !s2_k_q[KW-1] && {{(CMP-MW){1'b0}}, s2_num_q} <= least;
            wire unused = &{1'b0, k[0], s2_k_q};
        end else begin : g_any
            assign s2_behind = 1'b0;
            wire unused = &{1'b0, n};
        end
    endgenerate

    // ---- results with and without a division ----
    wire hit   = !is_own && !s2_miss_q && (is_plane || !s2_out_q) &&
                 !(is_shadow && (s2_late_q || s2_behind));
    wire key   = hit && !is_shadow;
    wire            d_in, d_valid, p_valid;
    wire [TAG+1:0]  d;
    wire [TAG:0]    p_tag;
    wire [W+WD+1:0] p_key;
    rt_facet_key #(.W(W), .WD(WD), .TAG(TAG+1), .DW(DW), .MW(MW), .HOLD(HOLD)) u_keys (
        .clk(clk), .rst(rst), .in_valid_i(s2_valid_q && key),
        .in_tag_i({!s2_neg_q, a_all[AB-1 -: TAG]}), .in_plane_i(is_plane),
        .in_det_i(s2_det_q), .in_num_i(s2_num_q), .in_a_i(a_all[2*WD-1:0]),
        .in_room_i(b_all[WD +: W+1]), .in_size_i(b_all[WD-1:0]),
        .out_valid_o(p_valid), .out_ready_i(result_ready_i), .out_tag_o(p_tag), .out_key_o(p_key),
        .divide_o(divide_o)
    );
    rt_fifo #(.WIDTH(TAG+2), .DEPTH(HOLD)) u_others (
        .clk(clk), .rst(rst), .in_valid_i(s2_valid_q && !key), .in_ready_o(d_in),
        .in_data_i({!s2_neg_q, a_all[AB-1 -: TAG], hit}),
        .out_valid_o(d_valid), .out_ready_i(result_ready_i && !p_valid), .out_data_o(d)
    );
    assign given = (p_valid || d_valid) && result_ready_i;
    assign result_o[`RT_RESULT_VALID] = p_valid || d_valid;
    assign {result_o[`RT_RESULT_FAR], result_o[`RT_RESULT_SLOT], result_o[`RT_RESULT_ID]} =
        p_valid ? p_tag : d[TAG+1:1];
    assign result_o[`RT_RESULT_HIT] = p_valid || d[0];
    assign result_o[`RT_RESULT_KEY] = p_valid ? p_key : {{(W+WD+1){1'b0}}, 1'b1};
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_exact_tests_of_facets /* verilator public_flat_rd */ =
        {in_valid_i && !in_ready_o, take, 5'd0, take || pause_q != 3'd0};
    wire unused = &{1'b0, a_in, a_valid, b_in, b_valid, d_in, size_d, size_n, reach[5:0],
                    test_i, record};
endmodule
`default_nettype wire
