// rt_leaf.v - the exact ray/sphere test: hit or miss without root or division
// SPDX-License-Identifier: Apache-2.0
// oc = ctr - org, b = oc.dir, k = rad^2 - oc.oc, disc = k*a + b*b > 0 and what makes it total for
// origins on and inside the sphere:
//   arithmetic: b, k, later disc | signs | 1 rule | disc | 1 groups of disc | 1 decide
// A leaf every INTERVAL clocks, free-running; arithmetic by rt_leaf_two or rt_leaf_four.
// Latency up to W/WD 16/17 12 clocks for INTERVAL 2, 16 for 4; above that 15 and 20.
// Model: sph_leaf_test() in cmodel/prim/sphere.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_check.vh"
`include "rt_fx.vh"
module rt_leaf #(
    parameter W   = 16,                          // coordinate, bits
    parameter WD  = 17,                          // direction component, bits
    parameter TAG = 8,                           // what travels along, bits
    parameter SHADOW = 1,                        // 1: some rays end at a light
    parameter INSIDE = 1,                        // 1: rays may start inside a sphere
    parameter INTERVAL = 2                       // clocks a leaf, 2 or 4
) (
    input  wire                   clk,
    input  wire                   rst,           // synchronous, active high
    input  wire                   inside_on_i,   // switch of INSIDE, changes between leaves
    // from the leaf fetch
    input  wire                   in_valid_i,
    output wire                   in_ready_o,    // low in INTERVAL-1 clocks after a transfer
    input  wire [TAG-1:0]         in_tag_i,
    input  wire signed [W-1:0]    in_ctr_x_i,    // sW
    input  wire signed [W-1:0]    in_ctr_y_i,
    input  wire signed [W-1:0]    in_ctr_z_i,
    input  wire [W-1:0]           in_rad_i,      // uW
    input  wire [`RT_ID_BITS-1:0] in_id_i,       // of the sphere
    input  wire signed [W-1:0]    in_org_x_i,    // sW
    input  wire signed [W-1:0]    in_org_y_i,
    input  wire signed [W-1:0]    in_org_z_i,
    input  wire signed [WD-1:0]   in_dir_x_i,    // sWD
    input  wire signed [WD-1:0]   in_dir_y_i,
    input  wire signed [WD-1:0]   in_dir_z_i,
    input  wire [2*WD-1:0]        in_a_i,        // u(2WD), dir.dir
    input  wire                   in_shadow_i,   // a ray to a light: RT_RAY_SHADOW
    input  wire [`RT_ID_BITS-1:0] in_skip_id_i,  // sphere the ray starts on
    input  wire                   in_skip_inside_i,  // and whether inside it
    // to rt_sphere_key
    output wire                   out_valid_o,
    output wire [TAG-1:0]         out_tag_o,
    output wire [`RT_ID_BITS-1:0] out_id_o,
    output wire                   out_hit_o,
    output wire                   out_far_o,     // the far root counts
    output wire                   out_exit_o,    // leaves its own sphere at t = 0
    output wire [2*W+2*WD-1:0]    out_disc_o,    // u(2W+2WD), of a hit without exit
    output wire signed [W+WD+1:0] out_b_o        // s(W+WD+2)
);
    localparam BW  = W + WD + 2;                 // |b| <= 3 * (2^W-1) * 2^(WD-1)
    localparam DW  = 2*W + 2*WD + 2;             // -2^(DW-1) < disc < 2^(DW-2): sums wrap rightly
    localparam OW0 = W + 1 > WD ? W + 1 : WD;
    localparam L   = `RT_MUL_LATENCY((OW0 > 18 ? OW0 : 18));      // of rt_leaf_two's products
    localparam M   = `RT_MUL_LATENCY((2*W + 3 > 2*WD + 1 ? 2*W + 3 : 2*WD + 1));
    localparam ONE = `RT_LEAF_PIECES(W, WD) == 1;
    // The clock in which a value stands; the leaf is taken at the end of clock 0.
    localparam T_B    = INTERVAL == 2 ? L + 3 : ONE ? 7 : 10;     // b, and then k
    localparam T_LAST = INTERVAL == 2 ? T_B : T_B + 3;            // b for the last time
    localparam T_SIGN = T_B + 2;                                  // signs of b, k, ...
    localparam T_DISC = INTERVAL == 2 ? L + M + 6 : ONE ? 14 : 18;
    localparam T_OUT  = T_DISC + 2;                               // the result
    `RT_CHECK(INTERVAL == 2 || INTERVAL == 4, rt_leaf_INTERVAL_must_be_2_or_4)
    genvar j;

    // ---- valid bits: valid[t] in clock t of a leaf, with INTERVAL-1 zeros below it ----
    reg  [T_OUT-1:0] valid_q;
    wire [T_OUT:0]   valid = {valid_q, 1'b0};
    wire             take  = in_valid_i && in_ready_o;
    assign in_ready_o  = ~|valid[INTERVAL-1:1];
    assign out_valid_o = valid[T_OUT];
    always @(posedge clk) begin
        valid_q <= {valid_q[T_OUT-2:0], take};
        if (rst) valid_q <= {T_OUT{1'b0}};
    end

    // ---- what waits does so in registers that are loaded every INTERVAL clocks ----
    // tag and id: stage j in clocks INTERVAL*j+1 .. INTERVAL*(j+1)
    localparam TB    = TAG + `RT_ID_BITS;
    localparam N_TAG = (T_OUT + INTERVAL - 1)/INTERVAL;
    wire [N_TAG*TB-1:0] tag_wait;
    generate
        for (j = 0; j < N_TAG; j = j + 1) begin : g_tag
            reg [TB-1:0] tag_q;
            if (j == 0) begin : g_in
                always @(posedge clk) if (take) tag_q <= {in_tag_i, in_id_i};
            end else begin : g_next
                always @(posedge clk)
                    if (valid[INTERVAL*j]) tag_q <= tag_wait[(j-1)*TB +: TB];
            end
            assign tag_wait[j*TB +: TB] = tag_q;
        end
    endgenerate
    assign {out_tag_o, out_id_o} = tag_wait[(N_TAG-1)*TB +: TB];

    // kind of ray: the same; used in clock T_SIGN
    localparam N_KIND = (T_SIGN + INTERVAL - 1)/INTERVAL;
    wire [N_KIND*3-1:0] kind_wait;
    generate
        for (j = 0; j < N_KIND; j = j + 1) begin : g_kind
            reg [2:0] kind_q;
            if (j == 0) begin : g_in
                always @(posedge clk)
                    if (take)
                        kind_q <= {in_id_i == in_skip_id_i, INSIDE != 0 && in_skip_inside_i,
                                   SHADOW != 0 && in_shadow_i};
            end else begin : g_next
                always @(posedge clk) if (valid[INTERVAL*j]) kind_q <= kind_wait[(j-1)*3 +: 3];
            end
            assign kind_wait[j*3 +: 3] = kind_q;
        end
    endgenerate
    wire own, inner, shadow;                     // in clock T_SIGN
    assign {own, inner, shadow} = kind_wait[(N_KIND-1)*3 +: 3];

    // a: stage 0 from clock 1 on, the last stage in clocks T_B .. T_B+INTERVAL-1
    localparam N_A = (T_B - 2)/INTERVAL + 2;
    wire [N_A*2*WD-1:0] a_wait;
    generate
        for (j = 0; j < N_A; j = j + 1) begin : g_a
            reg [2*WD-1:0] a_q;
            if (j == 0) begin : g_in
                always @(posedge clk) if (take) a_q <= in_a_i;
            end else begin : g_next
                always @(posedge clk)
                    if (valid[T_B - 1 - INTERVAL*(N_A-1-j)]) a_q <= a_wait[(j-1)*2*WD +: 2*WD];
            end
            assign a_wait[j*2*WD +: 2*WD] = a_q;
        end
    endgenerate
    wire [2*WD-1:0] a = a_wait[(N_A-1)*2*WD +: 2*WD];

    // b: stage j in clocks T_LAST+INTERVAL*j+1 .. T_LAST+INTERVAL*(j+1)
    localparam N_B = (T_OUT - T_LAST + INTERVAL - 1)/INTERVAL;
    wire [BW-1:0]     b;                         // in clock T_LAST
    wire [N_B*BW-1:0] b_wait;
    generate
        for (j = 0; j < N_B; j = j + 1) begin : g_b
            reg [BW-1:0] b_q;
            if (j == 0) begin : g_in
                always @(posedge clk) if (valid[T_LAST]) b_q <= b;
            end else begin : g_next
                always @(posedge clk)
                    if (valid[T_LAST+INTERVAL*j]) b_q <= b_wait[(j-1)*BW +: BW];
            end
            assign b_wait[j*BW +: BW] = b_q;
        end
    endgenerate
    assign out_b_o = $signed(b_wait[(N_B-1)*BW +: BW]);

    // ---- arithmetic: b; signs in clock T_SIGN; disc in clock T_DISC ----
    wire signed [W:0] oc_x = $signed({in_ctr_x_i[W-1], in_ctr_x_i})
                           - $signed({in_org_x_i[W-1], in_org_x_i});
    wire signed [W:0] oc_y = $signed({in_ctr_y_i[W-1], in_ctr_y_i})
                           - $signed({in_org_y_i[W-1], in_org_y_i});
    wire signed [W:0] oc_z = $signed({in_ctr_z_i[W-1], in_ctr_z_i})
                           - $signed({in_org_z_i[W-1], in_org_z_i});
    wire [3*W+2:0]    oc   = {oc_z, oc_y, oc_x};
    wire [3*WD-1:0]   dir  = {in_dir_z_i, in_dir_y_i, in_dir_x_i};
    wire              b_pos, b_short, k_pos, k_neg;   // b > 0, b < a, k > 0, k < 0
    wire              light_out, light_in;            // k + 2b - a < 0, > 0: the light is outside
    wire [DW-1:0]     disc;
    generate
        if (INTERVAL == 2) begin : g_two
            rt_leaf_two #(.W(W), .WD(WD), .T_DISC(T_DISC)) u_two (
                .clk(clk), .take_i(take), .valid_i(valid[T_DISC-1:0]),
                .oc_i(oc), .rad_i(in_rad_i), .dir_i(dir), .a_i(a),
                .b_o(b), .b_pos_o(b_pos), .b_short_o(b_short), .k_pos_o(k_pos), .k_neg_o(k_neg),
                .light_out_o(light_out), .light_in_o(light_in), .disc_o(disc)
            );
        end else begin : g_four
            rt_leaf_four #(.W(W), .WD(WD)) u_four (
                .clk(clk), .take_i(take), .ready_i(valid[T_B-1]),
                .oc_i(oc), .rad_i(in_rad_i), .dir_i(dir), .a_i(a),
                .b_o(b), .b_pos_o(b_pos), .b_short_o(b_short), .k_pos_o(k_pos), .k_neg_o(k_neg),
                .light_out_o(light_out), .light_in_o(light_in), .disc_o(disc)
            );
        end
    endgenerate

    // ---- what disc > 0 and disc <= 0 would mean, in clock T_SIGN+1 ----
    wire on        = INSIDE != 0 && inside_on_i;
    wire leaves    = on && own && inner;         // starts on the inner side of its own sphere
    wire skip      = own ? !leaves               // never hits the sphere it leaves
                         : !on && !k_neg;        // starts inside no sphere
    wire ahead     = b_pos || (INSIDE != 0 && k_pos);  // if disc > 0, a root with t > 0
    reg  hit_1_q, hit_0_q, exit_1_q, exit_0_q, far_q;
    always @(posedge clk) begin
        far_q    <= on && !skip && (!k_neg || own);
        exit_1_q <= leaves && !shadow && !ahead;
        exit_0_q <= leaves && !shadow;
        if (skip) begin
            hit_1_q <= 1'b0;
            hit_0_q <= 1'b0;
        end else if (!shadow) begin
            hit_1_q <= ahead || leaves;
            hit_0_q <= leaves;
        end else if (leaves) begin
            hit_1_q <= light_out;
            hit_0_q <= light_out;
        end else if (INSIDE == 0 || k_neg) begin
            hit_1_q <= b_pos && (b_short || light_in);
            hit_0_q <= 1'b0;
        end else begin
            hit_1_q <= ahead && light_out;
            hit_0_q <= ahead && light_out;
        end
    end
    wire hit_1, hit_0, exit_1, exit_0, far;      // in clock T_DISC+1
    generate
        if (INSIDE != 0) begin : g_inside
            rt_delay #(.WIDTH(5), .CYCLES(T_DISC - T_SIGN)) u_wait (
                .clk(clk), .in_i({hit_1_q, hit_0_q, exit_1_q, exit_0_q, far_q}),
                .out_o({hit_1, hit_0, exit_1, exit_0, far}));
        end else begin : g_outside               // a hit has two roots ahead, the near one counts
            rt_delay #(.WIDTH(1), .CYCLES(T_DISC - T_SIGN)) u_wait (
                .clk(clk), .in_i(hit_1_q), .out_o(hit_1));
            assign {hit_0, exit_1, exit_0, far} = 4'd0;
            wire unused = &{1'b0, hit_0_q, exit_1_q, exit_0_q, far_q};
        end
    endgenerate

    // ---- groups of disc that hold a one, in clock T_DISC+1; disc stays for INTERVAL clocks ----
    localparam GROUPS = (DW + 14)/16;            // without the sign
    wire [16*GROUPS-1:0] disc_bits = {{(16*GROUPS-DW+1){1'b0}}, disc[DW-2:0]};
    wire [GROUPS-1:0]    any;
    reg  [GROUPS-1:0]    any_q;
    reg                  disc_neg_q;
    reg  [DW-3:0]        disc_out_q;
    generate
        for (j = 0; j < GROUPS; j = j + 1) begin : g_any
            assign any[j] = |disc_bits[16*j +: 16];
        end
    endgenerate
    always @(posedge clk) begin
        any_q      <= any;
        disc_neg_q <= disc[DW-1];
        if (valid[T_DISC]) disc_out_q <= disc[DW-3:0];
    end
    assign out_disc_o = disc_out_q;

    // ---- decide ----
    wire disc_pos = !disc_neg_q && |any_q;
    reg  out_hit_q, out_exit_q, out_far_q;
    always @(posedge clk) begin
        out_hit_q  <= disc_pos ? hit_1 : hit_0;
        out_exit_q <= disc_pos ? exit_1 : exit_0;
        out_far_q  <= far;
    end
    assign out_hit_o  = out_hit_q;
    assign out_exit_o = out_exit_q;
    assign out_far_o  = out_far_q;

    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_exact_tests_of_spheres /* verilator public_flat_rd */ =
        {in_valid_i && !in_ready_o, take, 5'd0, take || !in_ready_o};
    wire unused = &{1'b0, valid[0], disc[DW-2]};
endmodule
`default_nettype wire
