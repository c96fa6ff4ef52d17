// rt_facet.v - triangles and planes, kinds of primitives: the exact test and the key of a hit
// SPDX-License-Identifier: Apache-2.0
//   A0 = v0-org, e1 = v1-v0, e2 = v2-v0, N = e1 x e2 (plane: given), det = N.dir, num = N.A0,
//   m = dir x A0: signs of det, num, U2 = m.e1, -U1 = m.e2, U0 = det-U1-U2; key = ceil(a*num/det)
// One facet after the other through three multipliers, an operation a clock; a*num' comes in
// clock 4 of the facet that follows. P = L + 4, L = `RT_PRODUCT_LATENCY(AW):
//   triangle  0,1 N | 2,3 m | P det, num, U2, U1                               every L + 8 clocks
//   plane     0 det, num | P det'*room, num'*size; beyond the grid t is room/size   every L + 10
// Ports, timing: docs/blocks/facet_unit.md. Model: sph_facet_test() in cmodel/prim/facet.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
`include "rt_check.vh"
`include "rt_facet.vh"
`include "rt_fx.vh"
module rt_facet #(
    parameter W   = 16,                          // coordinate, bits
    parameter WD  = 17,                          // direction component, bits
    parameter SLOTS = 32,                        // power of two
    parameter SHADOW = 1,                        // 1: some rays end at a light
    parameter STEP  = 2,                         // bits of a key a clock
    parameter UNITS = 1                          // dividers
) (
    input  wire                       clk,
    input  wire                       rst,       // synchronous, active high
    // from and to rt_prim, as of each kind
    input  wire                       in_valid_i,
    output wire                       in_ready_o,
    input  wire [`RT_TEST_BITS-1:0]   test_i,
    output wire [`RT_RESULT_BITS-1:0] result_o,
    input  wire                       result_ready_i,
    // event
    output wire                       divide_o   // a division begins
);
    localparam SLOTW = $clog2(SLOTS);
    localparam TAG  = SLOTW + `RT_ID_BITS;               // {slot, id}
    localparam NW   = W + 1 > WD ? W + 1 : WD;           // narrow operands
    localparam CUT  = 17*`RT_MUL_CHUNKS(NW);             // piece of a long operand
    localparam BW   = CUT + 1;
    localparam CW0  = W + WD > 2*W ? W + WD + 1 : 2*W + 1;
    localparam CW   = CW0 > 24 ? CW0 : 24;               // m, N
    localparam AW   = 2*WD + 1 > CW ? 2*WD + 1 : CW;     // wide operand: m, N, a
    localparam DW   = (2*W > 24 ? 2*W : 24) + WD + 1;    // det' (docs/model/facet.md)
    localparam MW   = 3*W + 1 > W + 25 ? 3*W + 1 : W + 25;  // num'
    localparam RW0  = 2*WD + MW + 1;                     // a*num', signed
    localparam RW   = RW0 > AW + BW ? RW0 : AW + BW;     // the longest sum
    localparam YW   = (DW + W > MW + WD ? DW + W : MW + WD) + 1;
    localparam VW   = (DW > MW ? DW : MW) + 1;           // det, num, Ui, signed
    localparam L    = `RT_PRODUCT_LATENCY(AW);
    localparam OB   = 6;                                 // {last, shadow, operation}
    localparam [31:0] FOUR = 4 + L, LAST_T = 7 + L, LAST_P = 9 + L;
    localparam [3:0] P = FOUR[3:0], END_T = LAST_T[3:0], END_P = LAST_P[3:0], COMMIT = 4;
    `RT_CHECK(3*CUT >= DW && 3*CUT >= MW, rt_facet_W_and_WD_must_fit_three_pieces)
    wire [255:0] record = test_i[`RT_TEST_RECORD];
    wire         plane  = record[`RT_FACET_KIND_LSB +: `RT_FACET_KIND_BITS] == `RT_PLANE;
    wire [`RT_ID_BITS-1:0] id = record[`RT_FACET_ID_LSB +: `RT_FACET_ID_BITS];

    // ---- rounds: the facet at hand, and the key of the one before ----
    reg        run_q, front_q, back_q;           // a round; with a facet; after another
    reg  [3:0] slot_q;
    reg        plane_q, shadow_q;
    wire       full;                             // a result waits, and goes on waiting
    wire       stay  = slot_q == 4'd0 && full;
    wire       step  = run_q && !stay;
    wire       ends  = run_q && slot_q == (!front_q ? COMMIT : plane_q ? END_P : END_T);
    wire       done  = ends && front_q;
    wire       take  = in_valid_i && in_ready_o;
    assign in_ready_o = !run_q || ends;
    always @(posedge clk) begin
        if (step) slot_q <= slot_q + 4'd1;
        if (step && slot_q == COMMIT) back_q <= 1'b0;
        if (done) back_q <= 1'b1;
        if (in_ready_o) begin
            slot_q  <= 4'd0;
            run_q   <= in_valid_i || (run_q && front_q);
            front_q <= in_valid_i;
        end
        if (rst) {run_q, front_q, back_q} <= 3'd0;
    end

    // ---- what travels along ----
    reg  [TAG-1:0]  tag_q, back_tag_q;
    reg             back_shadow_q, back_own_q;
    reg  [24:0]     apart_q;                     // skip - id
    reg  [6:0]      before_q, after_q;
    wire [7:0]      reach = {1'b0, apart_q[6:0]} + {1'b0, before_q};
    wire            own   = apart_q[24:7] == 18'd0 ? apart_q[6:0] <= after_q
                            : &apart_q[24:7] && reach[7];
    always @(posedge clk) begin
        if (take) begin
            tag_q    <= {test_i[`RT_TEST_SLOT], id};
            plane_q  <= plane;
            shadow_q <= SHADOW != 0 && test_i[`RT_TEST_SHADOW];
            apart_q  <= {1'b0, test_i[`RT_TEST_SKIP]} - {1'b0, id};
            before_q <= record[`RT_FACET_BEFORE_LSB +: `RT_FACET_BEFORE_BITS];
            after_q  <= record[`RT_FACET_AFTER_LSB +: `RT_FACET_AFTER_BITS];
        end
        if (done) begin
            back_tag_q    <= tag_q;
            back_shadow_q <= shadow_q;
            back_own_q    <= own;
        end
    end

    // ---- this clock's operation ----
    wire [3:0] since = slot_q - P;
    reg  [3:0] op;
    always @* begin
        op = `RT_FACET_IDLE;
        if (step && slot_q == COMMIT) begin
            if (back_q) op = `RT_FACET_KEY;
        end else if (step && front_q && plane_q) begin
            if (slot_q == P)              op = `RT_FACET_BDET;
            else if (slot_q == P + 4'd1)  op = `RT_FACET_BNUM;
            else if (slot_q == 4'd0)      op = `RT_FACET_DET;
            else if (slot_q == 4'd1)      op = `RT_FACET_NUM;
        end else if (step && front_q) begin
            if (slot_q < COMMIT)      op = slot_q[0] ? `RT_FACET_X1 : `RT_FACET_X0;
            else if (slot_q >= P)     op = `RT_FACET_DET + {2'd0, since[1:0]};
        end
    end
    reg  [OB*(L+5)-1:0] op_q;                    // stage s: s clocks after the operands' registers
    integer             s;
    always @(posedge clk) begin
        op_q <= {op_q[OB*(L+4)-1:0], done, shadow_q, op};
        if (rst)
            for (s = 0; s < L + 5; s = s + 1) op_q[OB*s +: OB] <= {OB{1'b0}};
    end
    wire [3:0] op_p = op_q[OB*L +: 4];           // with the products
    wire [3:0] op_r = op_q[OB*(L+2) +: 4];       // with their sum
    wire [3:0] op_f = op_q[OB*(L+3) +: 4];       // with the flags of the sum
    wire [OB-1:0] op_y = op_q[OB*(L+4) +: OB];   // with the flags of the sum of sums
    wire y_shadow = SHADOW != 0 && op_y[4];

    // ---- operands and lanes ----
    wire [3*AW-1:0]      a;
    wire [3*BW-1:0]      b;
    wire [3*CW-1:0]      c;
    wire signed [RW-1:0] r;
    wire [AW-1:0]        partner;                // of a long operand: room, then size
    reg  [DW-1:0]        det_q;                  // det'
    reg  [MW-1:0]        num_q;                  // num'
    rt_facet_feed #(.W(W), .WD(WD), .NW(NW), .CUT(CUT), .CW(CW), .AW(AW), .DW(DW), .MW(MW),
                    .P(P)) u_feed (
        .clk(clk), .take_i(take), .plane_i(plane), .v0_i(record[`RT_TRIANGLE_V0_X_LSB +: 72]),
        .v1_i(record[`RT_TRIANGLE_V1_X_LSB +: 72]), .v2_i(record[`RT_TRIANGLE_V2_X_LSB +: 72]),
        .org_i(test_i[`RT_TEST_ORG]), .dir_i(test_i[`RT_TEST_DIR]), .a_i(test_i[`RT_TEST_A]),
        .step_i(step), .slot_i(slot_q), .op_i(op),
        .vector_i(front_q && !plane_q && (slot_q == P - 4'd1 || slot_q == P + 4'd1)),
        .back_i(done), .key_i(slot_q == COMMIT - 4'd1),
        .c_i(c), .det_i(det_q), .num_i(num_q), .w_o(partner), .a_o(a), .b_o(b)
    );
    rt_facet_lanes #(.AW(AW), .BW(BW), .CW(CW), .RW(RW), .CUT(CUT)) u_lanes (
        .clk(clk), .a_i(a), .b_i(b),
        .cross_i(op_p == `RT_FACET_X0 || op_p == `RT_FACET_X1),
        .first_i(op_p == `RT_FACET_X0), .wide_i(op_p >= `RT_FACET_BDET),
        .c_o(c), .r_o(r)
    );

    // ---- det', num'; det - num, U0 = det - U2 - U1, det'*room - num'*size ----
    wire           neg = r[RW-1];
    wire [VW-1:0]  abs = (r[VW-1:0] ^ {VW{neg}}) + {{(VW-1){1'b0}}, neg};
    wire           y_load = op_r == `RT_FACET_DET || op_r == `RT_FACET_BDET;
    wire           y_sub  = op_r == `RT_FACET_NUM || op_r == `RT_FACET_U2 ||
                            op_r == `RT_FACET_BNUM;
    reg  [YW-1:0]  acc_q, y_q;
    wire [YW:0]    y = {y_load ? {YW{1'b0}} : acc_q, 1'b1} +
                       {r[YW-1:0] ^ {YW{y_sub}}, y_sub};
    reg            rn_q, rz_q, yn_q, yz_q;       // negative, zero
    reg  [W:0]     room_q;                       // of the facet whose flags come next
    reg  [WD-1:0]  size_q;
    wire           beyond = op_y[3:0] == `RT_FACET_BNUM && !y_shadow && yn_q;
    reg  [MW+WD-1:0] face_q;                     // of a plane beyond the grid: det'*room, and
    reg  [MW-1:0]  way_q;                        // its own num'
    always @(posedge clk) begin
        if (op_r == `RT_FACET_DET) det_q <= abs[DW-1:0];
        if (op_r == `RT_FACET_NUM) num_q <= abs[MW-1:0];
        if (op == `RT_FACET_BDET) room_q <= partner[W:0];
        if (op == `RT_FACET_BNUM) size_q <= partner[WD-1:0];
        if (beyond) begin                        // before the key reads them
            det_q <= {{(DW-WD){1'b0}}, size_q};
            num_q <= {{(MW-W-1){1'b0}}, room_q};
            face_q <= acc_q[MW+WD-1:0];
            way_q  <= num_q;
        end
        if (y_load || op_r == `RT_FACET_U2) acc_q <= y[YW:1];
        y_q  <= y[YW:1];
        rn_q <= neg;
        rz_q <= r[VW-1:0] == {VW{1'b0}};
        yn_q <= y_q[YW-1];
        yz_q <= y_q == {YW{1'b0}};
    end

    // ---- decide ----
    reg  neg_q, miss_q, end_miss_q, end_far_q;   // of det; of the facet at hand; of the one before
    reg  past_q, end_past_q;                     // beyond the grid
    wire y_miss   = op_y[3:0] == `RT_FACET_NUM ? y_shadow && (yz_q || yn_q != neg_q)
                    : op_y[3:0] == `RT_FACET_U1 && !yz_q && yn_q != neg_q;
    wire r_miss   = op_f == `RT_FACET_NUM ? rz_q || rn_q != neg_q
                    : op_f == `RT_FACET_U2 ? !rz_q && rn_q != neg_q
                    : op_f == `RT_FACET_U1 && !rz_q && rn_q == neg_q;
    always @(posedge clk) begin
        miss_q <= op_f == `RT_FACET_DET ? rz_q : miss_q || r_miss || y_miss;
        if (op_f == `RT_FACET_DET) neg_q <= rn_q;
        past_q <= op_f != `RT_FACET_DET && (past_q || beyond);
        if (op_y[5]) begin
            end_miss_q <= miss_q || y_miss;
            end_far_q  <= !neg_q;
            end_past_q <= past_q || beyond;
        end
    end

    // ---- the key of the one before ----
    rt_facet_key #(.W(W), .WD(WD), .SLOTS(SLOTS), .DW(DW), .MW(MW), .STEP(STEP),
                   .UNITS(UNITS)) u_key (
        .clk(clk), .rst(rst), .det_load_i(op == `RT_FACET_KEY), .det_i(det_q),
        .in_valid_i(op_r == `RT_FACET_KEY), .in_x_i(r[2*WD+MW-1:0]), .in_tag_i(back_tag_q),
        .in_hit_i(!end_miss_q && !back_own_q), .in_shadow_i(back_shadow_q),
        .in_far_i(end_far_q), .in_past_i(end_past_q), .in_face_i(face_q), .in_way_i(way_q),
        .full_o(full),
        .result_o(result_o), .result_ready_i(result_ready_i), .divide_o(divide_o)
    );
    wire unused = &{1'b0, y[0], r, abs, since[3:2], reach[6:0], op_y, test_i, record, partner};
endmodule
`default_nettype wire
