// rt_leaf.v - the exact ray/sphere test: hit or miss without root or division
// SPDX-License-Identifier: Apache-2.0
// oc = ctr - org, b = oc.dir, k = rad^2 - oc.oc, disc = k*a + b*b > 0 and what makes it total for
// origins on and inside the sphere. Each multiplier serves two clocks of a leaf:
//   1,2 operands (oc,dir) (oc,oc) | L products | 2 sums: b, k | 1 operands (b,b) (k,a) | M products
//   1 sum: disc | 1 groups of disc | 1 decide       L, M = `RT_MUL_LATENCY of the operands' widths
// A leaf every second clock, free-running, latency L + M + 8: 12 up to W/WD 16/17, 15 up to 24/25.
// Model: sph_leaf_test() in cmodel/prim/leaf.c
`default_nettype none
`include "rt_layout.vh"
`include "rt_check.vh"
`include "rt_fx.vh"
module rt_leaf #(
    parameter W   = 16,                          // coordinate, bits
    parameter WD  = 17,                          // direction component, bits
    parameter TAG = 8,                           // what travels along, bits
    parameter SHADOW = 1,                        // 1: some rays end at a light
    parameter INSIDE = 1                         // 1: rays may start inside a sphere
) (
    input  wire                   clk,
    input  wire                   rst,           // synchronous, active high
    input  wire                   inside_on_i,   // switch of INSIDE, changes between leaves
    // from the leaf fetch
    input  wire                   in_valid_i,
    output wire                   in_ready_o,    // low in the clock after a transfer
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
    input  wire                   in_shadow_i,   // the ray ends at the light, t = 1
    input  wire [`RT_ID_BITS-1:0] in_skip_id_i,  // sphere the ray starts on
    input  wire                   in_skip_inside_i,  // and whether inside it
    // to rt_root_pool
    output wire                   out_valid_o,
    output wire [TAG-1:0]         out_tag_o,
    output wire [`RT_ID_BITS-1:0] out_id_o,
    output wire                   out_hit_o,
    output wire                   out_far_o,     // the far root counts
    output wire                   out_exit_o,    // leaves its own sphere at t = 0
    output wire [2*W+2*WD-1:0]    out_disc_o,    // u(2W+2WD), of a hit without exit
    output wire signed [W+WD+1:0] out_b_o        // s(W+WD+2)
);
    localparam OW0 = W + 1 > WD ? W + 1 : WD;
    localparam OW  = OW0 > 18 ? OW0 : 18;        // operands of the narrow multipliers
    localparam BW  = W + WD + 2;                 // |b| <= 3 * (2^W-1) * 2^(WD-1)
    localparam KW  = 2*W + 3;                    // -3 * (2^W-1)^2 <= k <= (2^W-1)^2
    localparam VW  = KW > BW ? KW : BW;          // k or b
    localparam NW  = VW > 2*WD + 1 ? VW : 2*WD + 1;  // operands of the wide multiplier
    localparam DW  = 2*W + 2*WD + 2;             // -2^(DW-1) < disc < 2^(DW-2): sums wrap rightly
    localparam MW  = (W > WD - 1 ? W : WD - 1) + 1;  // |oc - dir| < 2^MW a component
    localparam LW  = 2*MW + 3;                   // rad^2 - |oc - dir|^2
    localparam AW  = (BW > 2*WD ? BW : 2*WD) + 2;    // b - a
    localparam L   = `RT_MUL_LATENCY(OW);
    localparam M   = `RT_MUL_LATENCY(NW);
    // The clock in which a value stands in its register; the leaf is taken at the end of clock 0.
    localparam T_B    = L + 3;                   // b; k one clock later
    localparam T_DISC = L + M + 6;               // disc
    localparam T_OUT  = L + M + 8;               // the result
    `RT_CHECK(OW <= 35, rt_leaf_W_and_WD_must_be_below_36)
    genvar j;

    // ---- valid bits: valid[t] in the clock t of a leaf, and never in t+1 of another ----
    reg  [T_OUT-1:0] valid_q;
    wire [T_OUT:0]   valid = {valid_q, 1'b0};
    wire             take  = in_valid_i && in_ready_o;
    assign in_ready_o  = !valid[1];
    assign out_valid_o = valid[T_OUT];
    always @(posedge clk) begin
        valid_q <= {valid_q[T_OUT-2:0], take};
        if (rst) valid_q <= {T_OUT{1'b0}};
    end

    // ---- what waits does so in registers that are loaded every second clock ----
    // tag and id: stage j in clocks 2j+1, 2j+2
    localparam N_TAG = (T_OUT + 1)/2;
    wire [N_TAG*(TAG+24)-1:0] tag_wait;
    generate
        for (j = 0; j < N_TAG; j = j + 1) begin : g_tag
            reg [TAG+23:0] tag_q;
            if (j == 0) begin : g_in
                always @(posedge clk) if (take) tag_q <= {in_tag_i, in_id_i};
            end else begin : g_next
                always @(posedge clk)
                    if (valid[2*j]) tag_q <= tag_wait[(j-1)*(TAG+24) +: TAG+24];
            end
            assign tag_wait[j*(TAG+24) +: TAG+24] = tag_q;
        end
    endgenerate
    assign {out_tag_o, out_id_o} = tag_wait[(N_TAG-1)*(TAG+24) +: TAG+24];

    // kind of ray: stage j in clocks 2j+1, 2j+2; used in clock T_B+2
    localparam N_KIND = (T_B + 3)/2;
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
                always @(posedge clk) if (valid[2*j]) kind_q <= kind_wait[(j-1)*3 +: 3];
            end
            assign kind_wait[j*3 +: 3] = kind_q;
        end
    endgenerate
    wire own, inner, shadow;                     // in clock T_B+2
    assign {own, inner, shadow} = kind_wait[(N_KIND-1)*3 +: 3];

    // a: stage 0 in clock 1, stage j in clocks 2j, 2j+1; used in clocks T_B, T_B+1 (T_B is even)
    localparam N_A = T_B/2 + 1;
    wire [N_A*2*WD-1:0] a_wait;
    generate
        for (j = 0; j < N_A; j = j + 1) begin : g_a
            reg [2*WD-1:0] a_q;
            if (j == 0) begin : g_in
                always @(posedge clk) if (take) a_q <= in_a_i;
            end else begin : g_next
                always @(posedge clk) if (valid[2*j-1]) a_q <= a_wait[(j-1)*2*WD +: 2*WD];
            end
            assign a_wait[j*2*WD +: 2*WD] = a_q;
        end
    endgenerate
    wire [2*WD-1:0] a = a_wait[(N_A-1)*2*WD +: 2*WD];

    // ---- operands: (oc, dir) in clock 1, (oc, oc) in clock 2 ----
    reg signed [W:0]    oc_x_q, oc_y_q, oc_z_q;  // s(W+1)
    reg signed [OW-1:0] op_x_q, op_y_q, op_z_q;  // dir, then oc
    reg [W-1:0]         rad_q;                   // uW
    wire signed [OW-1:0] oc_x = {{(OW-W-1){oc_x_q[W]}}, oc_x_q};
    wire signed [OW-1:0] oc_y = {{(OW-W-1){oc_y_q[W]}}, oc_y_q};
    wire signed [OW-1:0] oc_z = {{(OW-W-1){oc_z_q[W]}}, oc_z_q};
    wire signed [OW-1:0] rad  = {{(OW-W){1'b0}}, rad_q};
    always @(posedge clk) begin
        op_x_q <= oc_x;
        op_y_q <= oc_y;
        op_z_q <= oc_z;
        if (take) begin
            oc_x_q <= $signed({in_ctr_x_i[W-1], in_ctr_x_i})
                    - $signed({in_org_x_i[W-1], in_org_x_i});
            oc_y_q <= $signed({in_ctr_y_i[W-1], in_ctr_y_i})
                    - $signed({in_org_y_i[W-1], in_org_y_i});
            oc_z_q <= $signed({in_ctr_z_i[W-1], in_ctr_z_i})
                    - $signed({in_org_z_i[W-1], in_org_z_i});
            op_x_q <= {{(OW-WD){in_dir_x_i[WD-1]}}, in_dir_x_i};
            op_y_q <= {{(OW-WD){in_dir_y_i[WD-1]}}, in_dir_y_i};
            op_z_q <= {{(OW-WD){in_dir_z_i[WD-1]}}, in_dir_z_i};
            rad_q  <= in_rad_i;
        end
    end

    // ---- products in clocks L+1, L+2; rad^2 in both ----
    wire signed [2*OW-1:0] p_x, p_y, p_z, p_rad;
    rt_multiply #(.W(OW)) u_mul_x   (.clk(clk), .a_i(oc_x), .b_i(op_x_q), .p_o(p_x));
    rt_multiply #(.W(OW)) u_mul_y   (.clk(clk), .a_i(oc_y), .b_i(op_y_q), .p_o(p_y));
    rt_multiply #(.W(OW)) u_mul_z   (.clk(clk), .a_i(oc_z), .b_i(op_z_q), .p_o(p_z));
    rt_multiply #(.W(OW)) u_mul_rad (.clk(clk), .a_i(rad),  .b_i(rad),    .p_o(p_rad));

    // ---- sums: b = (x + y) + z in clock T_B, k = (rad^2 - z) - (x + y) in the next ----
    // -v = ~v + 1; the 1 is the carry into an extra bit at the bottom.
    localparam PW = 2*OW;
    localparam EW = VW > PW ? VW : PW;           // products as they are, sums need VW bits of them
    wire [EW-1:0] e_x   = {{(EW-PW+1){p_x[PW-1]}},   p_x[PW-2:0]};
    wire [EW-1:0] e_y   = {{(EW-PW+1){p_y[PW-1]}},   p_y[PW-2:0]};
    wire [EW-1:0] e_z   = {{(EW-PW+1){p_z[PW-1]}},   p_z[PW-2:0]};
    wire [EW-1:0] e_rad = {{(EW-PW+1){p_rad[PW-1]}}, p_rad[PW-2:0]};
    wire          z_sub  = valid[L+2];
    wire          xy_sub = valid[L+3];
    reg  [VW-1:0] xy_q, z_q;
    reg  [VW-1:0] val_q;                         // b in clock T_B, k in T_B+1
    wire [VW:0]   z_sum  = {z_sub ? e_rad[VW-1:0] : {VW{1'b0}}, 1'b1}
                         + {e_z[VW-1:0] ^ {VW{z_sub}}, z_sub};
    wire [VW:0]   xy_sum = {z_q, 1'b1} + {xy_q ^ {VW{xy_sub}}, xy_sub};
    always @(posedge clk) begin
        xy_q  <= e_x[VW-1:0] + e_y[VW-1:0];
        z_q   <= z_sum[VW:1];
        val_q <= xy_sum[VW:1];
    end

    // b: stage j in clocks T_B+2j+1, T_B+2j+2
    localparam N_B = (T_OUT - T_B + 1)/2;
    wire [N_B*BW-1:0] b_wait;
    generate
        for (j = 0; j < N_B; j = j + 1) begin : g_b
            reg [BW-1:0] b_q;
            if (j == 0) begin : g_in
                always @(posedge clk) if (valid[T_B]) b_q <= val_q[BW-1:0];
            end else begin : g_next
                always @(posedge clk) if (valid[T_B+2*j]) b_q <= b_wait[(j-1)*BW +: BW];
            end
            assign b_wait[j*BW +: BW] = b_q;
        end
    endgenerate
    assign out_b_o = $signed(b_wait[(N_B-1)*BW +: BW]);

    // ---- wide operands: (b, b) in clock T_B+1, (k, a) in clock T_B+2 ----
    reg  signed [NW-1:0]   wide_a_q, wide_b_q;
    wire signed [2*NW-1:0] p_wide;
    wire signed [NW-1:0]   val = {{(NW-VW+1){val_q[VW-1]}}, val_q[VW-2:0]};
    always @(posedge clk) begin
        wide_a_q <= val;
        wide_b_q <= valid[T_B+1] ? $signed({{(NW-2*WD){1'b0}}, a}) : val;
    end
    rt_multiply #(.W(NW)) u_mul_wide (.clk(clk), .a_i(wide_a_q), .b_i(wide_b_q), .p_o(p_wide));

    // ---- signs of b, k, b - a, k_light = k + 2b - a = rad^2 - |light - ctr|^2 ----
    reg                  b_pos_q, b_short_q;     // b > 0, b < a, in clock T_B+1
    reg                  bb_pos_q, bb_short_q;   // the same in clock T_B+2
    reg                  k_pos_q, k_neg_q;       // in clock T_B+2
    reg  signed [LW-1:0] part_q, light_q;        // 2b - a in T_B+1, k_light in T_B+2
    wire signed [LW-1:0] val_l = {{(LW-VW){val_q[VW-1]}}, val_q};
    wire signed [LW-1:0] a_l   = {{(LW-2*WD){1'b0}}, a};
    wire signed [AW-1:0] b_a   = $signed({{(AW-BW){val_q[BW-1]}}, val_q[BW-1:0]})
                               - $signed({{(AW-2*WD){1'b0}}, a});
    wire                 val_pos = !val_q[VW-1] && val_q != {VW{1'b0}};
    always @(posedge clk) begin
        b_pos_q    <= val_pos;
        b_short_q  <= b_a[AW-1];
        part_q     <= (val_l <<< 1) - a_l;
        bb_pos_q   <= b_pos_q;
        bb_short_q <= b_short_q;
        k_pos_q    <= val_pos;
        k_neg_q    <= val_q[VW-1];
        light_q    <= val_l + part_q;
    end

    // ---- what disc > 0 and disc <= 0 would mean, in clock T_B+3 ----
    wire light_out = light_q[LW-1];              // the light is outside
    wire light_in  = !light_out && light_q != {LW{1'b0}};
    wire on        = INSIDE != 0 && inside_on_i;
    wire leaves    = on && own && inner;         // starts on the inner side of its own sphere
    wire skip      = own ? !leaves               // never hits the sphere it leaves
                         : !on && !k_neg_q;      // starts inside no sphere
    wire ahead     = bb_pos_q || (INSIDE != 0 && k_pos_q);  // if disc > 0, a root with t > 0
    reg  hit_1_q, hit_0_q, exit_1_q, exit_0_q, far_q;
    always @(posedge clk) begin
        far_q    <= on && !skip && (!k_neg_q || own);
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
        end else if (INSIDE == 0 || k_neg_q) begin
            hit_1_q <= bb_pos_q && (bb_short_q || light_in);
            hit_0_q <= 1'b0;
        end else begin
            hit_1_q <= ahead && light_out;
            hit_0_q <= ahead && light_out;
        end
    end
    wire hit_1, hit_0, exit_1, exit_0, far;      // in clock T_DISC+1
    generate
        if (INSIDE != 0) begin : g_inside
            rt_delay #(.WIDTH(5), .CYCLES(T_DISC - T_B - 2)) u_wait (
                .clk(clk), .in_i({hit_1_q, hit_0_q, exit_1_q, exit_0_q, far_q}),
                .out_o({hit_1, hit_0, exit_1, exit_0, far}));
        end else begin : g_outside               // a hit has two roots ahead, the near one counts
            rt_delay #(.WIDTH(1), .CYCLES(T_DISC - T_B - 2)) u_wait (
                .clk(clk), .in_i(hit_1_q), .out_o(hit_1));
            assign {hit_0, exit_1, exit_0, far} = 4'd0;
            wire unused = &{1'b0, hit_0_q, exit_1_q, exit_0_q, far_q};
        end
    endgenerate

    // ---- disc: b*b, then k*a added, in clock T_DISC ----
    reg [DW-1:0] disc_q;
    always @(posedge clk) disc_q <= p_wide[DW-1:0] + (valid[T_DISC-1] ? disc_q : {DW{1'b0}});

    // ---- groups of disc that hold a one, in clock T_DISC+1; disc stays for two clocks ----
    localparam GROUPS = (DW + 14)/16;            // without the sign
    wire [16*GROUPS-1:0] disc_bits = {{(16*GROUPS-DW+1){1'b0}}, disc_q[DW-2:0]};
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
        disc_neg_q <= disc_q[DW-1];
        if (valid[T_DISC]) disc_out_q <= disc_q[DW-3:0];
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

    wire unused = &{1'b0, e_x, e_y, e_z, e_rad, z_sum[0], xy_sum[0], p_wide, b_a[AW-2:0], valid[0]};
endmodule
`default_nettype wire
