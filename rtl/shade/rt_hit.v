// rt_hit.v - hit point and normal
// SPDX-License-Identifier: Apache-2.0
//   g = sat(org*2^NG + round(mant * dir / 2^(exp-NG)))    point, vector: rt_hit_point, from g
//   normal = normalise(vector), or normalise(-dir) where the vector is 0
// x, y, z follow one another through one multiplier and one shifter:
//   product | coarse shift | fine shift | add org | limit | point, vector | normalise
// INTERVAL 8: a product a cycle; latency 18 cycles, a hit every 8 cycles. 12: in four cycles, in
// pieces of 17 bits; in_ready_o comes 10 cycles behind the first sight of a hit, since each stage
// takes from the port what it needs when it needs it; latency 19 from there, a hit every 12 cycles.
// Both are longer if rt_hit_point answers later: the next hit is held back.
// Model: sph_surface_point(), sph_surface_turn() in cmodel/shade/surface.c, no quotient, no unit
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
`include "rt_layout.vh"
`include "rt_prim.vh"
module rt_hit #(
    parameter W   = 16,  // coordinate, bits
    parameter WD  = 17,  // direction component, bits, at least W+1
    parameter PQ  = 17,  // quotient, significant bits
    parameter NG  = 2,   // guard bits of the normal
    parameter INSIDE = 1, // 0: no hit comes from inside or behind
    parameter FACETS = 0, // 1: triangles and planes too
    parameter GUARDED = 0, // 1: the guarded point leaves too
    parameter INTERVAL = 8, // cycles a hit, 8 or 12
    parameter TAG = 8    // tag, bits
) (
    input  wire                 clk,
    input  wire                 rst,
    input  wire [`RT_EFFECT_BITS-1:0] effects_i, // register EFFECTS
    input  wire                 in_valid_i,
    output wire                 in_ready_o,     // all stays until then
    input  wire [TAG-1:0]       in_tag_i,
    input  wire [PQ-1:0]        in_mant_i,      // t = mant * 2^-exp
    input  wire signed [7:0]    in_exp_i,
    input  wire signed [W-1:0]  in_org_x_i,     // ray origin
    input  wire signed [W-1:0]  in_org_y_i,
    input  wire signed [W-1:0]  in_org_z_i,
    input  wire signed [WD-1:0] in_dir_x_i,     // ray direction
    input  wire signed [WD-1:0] in_dir_y_i,
    input  wire signed [WD-1:0] in_dir_z_i,
    input  wire [`RT_LEAF_STRIDE-1:0] in_shape_i, // low half of the primitive record
    input  wire                 in_far_i,       // hit from inside, from the normal's other side
    output wire                 out_valid_o,    // one cycle
    output reg  [TAG-1:0]       out_tag_o,
    output reg  signed [W-1:0]  out_point_x_o,
    output reg  signed [W-1:0]  out_point_y_o,
    output reg  signed [W-1:0]  out_point_z_o,
    output wire [3*(W+NG)-1:0]  out_guarded_o,  // {z, y, x} s(W+NG), g; 0 without GUARDED
    output wire [3*(NG+2)-1:0]  out_lift_o,     // {z, y, x} point * 2^NG - g; 0 without FACETS
    output wire signed [WD-1:0] out_normal_x_o, // towards the ray's side
    output wire signed [WD-1:0] out_normal_y_o,
    output wire signed [WD-1:0] out_normal_z_o,
    output reg                  out_flat_o,     // the point lies in front of a facet's plane
    output reg                  out_saturated_o // the point was limited to the grid
);
    localparam PW = PQ + WD;                    // mant * dir
    localparam SW = PW + 1;                     // and one bit to round
    localparam GW = W + NG;                     // guarded coordinate
    localparam PV = `RT_PRIM_VECTOR_BITS(W, NG, FACETS);
    localparam KB = GW + 9 < SW ? GW + 9 : SW;  // of t*dir, behind the coarse shift
    localparam VW = PV > WD + 1 ? PV : WD + 1;  // vector, or -dir
    localparam        [31:0] BITS  = NG;
    localparam signed [8:0]  GUARD = BITS[8:0];

    // ---- control: ph_q[n] n cycles after the hit was first seen; x has its turn first ----
    // x is in stage n in cycle X+n-1, y and z D and 2D cycles later
    localparam SLOW = INTERVAL == 12;
    localparam X = SLOW ? 6 : 1, D = SLOW ? 4 : 1, LAST = X + 2*D;
    localparam T_ORG = SLOW ? X : 0, T_TAKE = SLOW ? X + 4 : 0;   // org, shift; shape, tag
    `RT_CHECK(INTERVAL == 8 || INTERVAL == 12, rt_hit_INTERVAL_must_be_8_or_12)
    reg  [LAST+5:1]      ph_q;
    reg  [3:1]           feed_q;                // the vector leaves for normalisation
    reg  [1:0]           part_q;                // of point and vector: x, y, z
    reg                  late_q;                // they have not all come; SLOW: none of them has
    wire                 p_valid;
    wire                 first = p_valid && part_q == 2'd0;
    wire                 last  = p_valid && part_q == 2'd2;
    wire                 late  = SLOW ? late_q
                                 : `RT_PRIM_POINT_LATER && (ph_q[LAST+5] || late_q) && !last;
    wire                 start = in_valid_i && ~|ph_q[INTERVAL-1:1] && !late;
    wire [LAST+5:0]      ph = {ph_q, start};
    wire                 in_1  = ph[X] || ph[X+D] || ph[LAST];  // one of the three is in stage 1
    wire                 in_2  = ph[X+1] || ph[X+D+1] || ph[LAST+1];
    wire                 in_3  = ph[X+2] || ph[X+D+2] || ph[LAST+2];
    wire                 in_4  = ph[X+3] || ph[X+D+3] || ph[LAST+3];
    wire                 in_5  = ph[X+4] || ph[X+D+4] || ph[LAST+4];
    wire                 guarded = ph[X+5] || ph[X+D+5] || ph[LAST+5];  // g is in its register
    wire                 feed  = |feed_q;
    wire                 take  = ph[T_TAKE];
    assign in_ready_o = SLOW ? take : ~|ph_q[INTERVAL-1:1] && !late;
    always @(posedge clk) begin
        ph_q   <= ph[LAST+4:0];
        feed_q <= {feed_q[2:1], last};
        late_q <= SLOW ? take || (late_q && !first) : late;
        if (p_valid) part_q <= last ? 2'd0 : part_q + 2'd1;
        if (rst) begin
            ph_q <= {(LAST+5){1'b0}};
            {feed_q, late_q, part_q} <= 6'd0;
        end
    end

    // ---- input: components move to x when theirs is done ----
    reg  [TAG-1:0]       in_tag_q;
    reg  [PQ-1:0]        mant_q;
    reg  [5:0]           shift_q;               // exp - NG, 0..62
    reg                  short_q;               // exp < NG: t leaves any grid
    reg  signed [WD-1:0] dir_x_q, dir_y_q, dir_z_q;
    reg  signed [W-1:0]  org_x_q, org_y_q, org_z_q;
    wire signed [8:0]    shift = $signed({in_exp_i[7], in_exp_i}) - GUARD;
    wire                 next_dir;              // the product of a component is done
    always @(posedge clk) begin
        if (start) begin
            mant_q   <= in_mant_i;
            {dir_x_q, dir_y_q, dir_z_q} <= {in_dir_x_i, in_dir_y_i, in_dir_z_i};
        end else if (next_dir) begin
            {dir_x_q, dir_y_q} <= {dir_y_q, dir_z_q};
        end
        if (ph[T_ORG]) begin
            short_q  <= shift[8];
            shift_q  <= shift[8] ? 6'd0 : |shift[7:6] ? 6'd62 : shift[5:0];
            {org_x_q, org_y_q, org_z_q} <= {in_org_x_i, in_org_y_i, in_org_z_i};
        end else if (in_4) begin
            {org_x_q, org_y_q} <= {org_y_q, org_z_q};
        end
        if (take) in_tag_q <= in_tag_i;
    end

    // ---- stage 1: product; -dir is kept for a hit at the centre ----
    wire signed [PW-1:0] s1_prod;               // in the cycle behind stage 1
    reg  signed [WD:0]   back_x_q, back_y_q, back_z_q;
    generate
        if (INTERVAL == 12) begin : g_slow
            wire [34:0]        mant = {{(35-PQ){1'b0}}, mant_q};
            wire [34:0]        dir  = {{(35-WD){dir_x_q[WD-1]}}, dir_x_q};
            wire signed [17:0] m_l = {1'b0, mant[16:0]}, m_h = mant[34:17];
            wire signed [17:0] d_l = {1'b0, dir[16:0]},  d_h = dir[34:17];
            reg  [1:0]         step_q, s1_step_q, s2_step_q;     // ll, lh, hl, hh
            reg  signed [17:0] s1_m_q, s1_d_q;
            reg  signed [35:0] s2_p_q;
            reg  signed [39:0] acc_q;           // 17 bits leave when the weight grows
            reg  [33:0]        low_q;
            wire signed [39:0] old = s2_step_q == 2'd2 ? acc_q : acc_q >>> 17;
            wire signed [39:0] s2_p = {{4{s2_p_q[35]}}, s2_p_q};
            wire [73:0]        all = {acc_q, low_q};
            wire [WD:0] in_x = {in_dir_x_i[WD-1], in_dir_x_i};
            wire [WD:0] in_y = {in_dir_y_i[WD-1], in_dir_y_i};
            wire [WD:0] in_z = {in_dir_z_i[WD-1], in_dir_z_i};
            always @(posedge clk) begin
                step_q    <= start ? 2'd0 : step_q + 2'd1;
                s1_step_q <= step_q;
                s2_step_q <= s1_step_q;
                s1_m_q    <= step_q[1] ? m_h : m_l;
                s1_d_q    <= step_q[0] ? d_h : d_l;
                s2_p_q    <= s1_m_q * s1_d_q;
                acc_q     <= (s2_step_q == 2'd0 ? 40'sd0 : old) + s2_p;
                if (s2_step_q[0]) low_q <= {acc_q[16:0], low_q[33:17]};
                // loaded when the last hit's have left, then turned round
                if (take) {back_x_q, back_y_q, back_z_q} <= {in_x, in_y, in_z};
                else if (|ph[T_TAKE+3:T_TAKE+1] || feed) begin
                    back_z_q <= -back_x_q;
                    {back_x_q, back_y_q} <= {back_y_q, back_z_q};
                end
            end
            assign next_dir = step_q == 2'd3;
            assign s1_prod  = $signed(all[PW-1:0]);
            wire unused = &{1'b0, all, in_1};
        end else begin : g_fast
            reg signed [PW-1:0] s1_prod_q;
            always @(posedge clk) begin
                if (in_1) s1_prod_q <= $signed({1'b0, mant_q}) * dir_x_q;
                if (in_1 || feed) begin
                    back_z_q <= -$signed({dir_x_q[WD-1], dir_x_q});
                    {back_x_q, back_y_q} <= {back_y_q, back_z_q};
                end
            end
            assign next_dir = in_1;
            assign s1_prod  = s1_prod_q;
        end
    endgenerate

    // ---- stages 2 and 3: shift right, one bit kept to round. A product that KB bits do not hold
    //      when only 7 more may leave is limited, whatever org is ----
    reg  signed [KB-1:0] s2_prod_q, s3_prod_q;
    reg                  s2_far_q, s3_far_q, s4_far_q;  // it is limited, to the side of its sign
    reg                  s2_neg_q, s3_neg_q, s4_neg_q;
    wire signed [SW-1:0] s1_half = $signed({s1_prod, 1'b0});
    wire signed [SW-1:0] s1_part = s1_half >>> {shift_q[5:3], 3'd0};
    wire [7:0]           s1_far;
    genvar n;
    generate
        for (n = 0; n < 8; n = n + 1) begin : g_far
            if (KB - 1 + 8*n < SW - 1) begin : g_some
                assign s1_far[n] = s1_half[SW-1:KB-1+8*n] != {(SW-KB+1-8*n){s1_half[SW-1]}};
            end else begin : g_none
                assign s1_far[n] = 1'b0;
            end
        end
    endgenerate
    always @(posedge clk) begin
        if (in_2) s2_prod_q <= s1_part[KB-1:0];
        if (in_3) s3_prod_q <= s2_prod_q >>> shift_q[2:0];
        {s4_far_q, s3_far_q, s2_far_q} <= {s3_far_q, s2_far_q, s1_far[shift_q[5:3]]};
        {s4_neg_q, s3_neg_q, s2_neg_q} <= {s3_neg_q, s2_neg_q, s1_half[SW-1]};
    end

    // ---- stage 4: (2*org*2^NG + 1 + offset) / 2 rounds half up ----
    reg  signed [KB:0]   s4_sum_q;
    wire signed [KB:0]   s4_org = $signed({{(KB-W){org_x_q[W-1]}}, org_x_q, 1'b0}) <<< NG;
    always @(posedge clk) if (in_4)
        s4_sum_q <= $signed({s4_org[KB:1], 1'b1}) + $signed({s3_prod_q[KB-1], s3_prod_q});

    // ---- stage 5: limit to the guarded grid ----
    reg  signed [GW-1:0] s5_g_q;
    reg                  s5_over_q;
    wire                 s5_sign = s4_far_q ? s4_neg_q : s4_sum_q[KB];
    wire                 s5_over = s4_far_q || s4_sum_q[KB-1:GW] != {(KB-GW){s5_sign}};
    always @(posedge clk) begin
        s5_over_q <= s5_over;
        if (in_5)
            s5_g_q <= s5_over ? $signed({s5_sign, {(GW-1){!s5_sign}}}) : $signed(s4_sum_q[GW:1]);
    end

    // ---- stage 6: point and vector, as the primitive has them ----
    reg  [TAG-1:0]       s6_tag_q;
    reg                  s6_over_q, s6_any_q, s6_flat_q;
    reg  signed [W-1:0]  s6_px_q, s6_py_q, s6_pz_q;
    reg  signed [PV-1:0] s6_nx_q, s6_ny_q, s6_nz_q;
    wire signed [W-1:0]  p_point;
    wire signed [PV-1:0] p_vector;
    wire [NG+1:0]        p_lift;
    wire                 p_limited, p_flat;
    rt_hit_point #(.W(W), .NG(NG), .FARS(INSIDE), .FACETS(FACETS)) u_prim (
        .clk(clk), .effects_i(effects_i),
        .take_i(take), .shape_i(in_shape_i), .far_i(in_far_i),
        .in_valid_i(guarded), .in_guarded_i(s5_g_q),
        .out_valid_o(p_valid), .out_point_o(p_point), .out_lift_o(p_lift),
        .out_limited_o(p_limited), .out_flat_o(p_flat), .out_vector_o(p_vector)
    );
    always @(posedge clk) begin
        if (guarded || p_valid)
            s6_over_q <= (guarded && s5_over_q) || (p_valid && p_limited) ||
                         (ph[X+5] ? short_q : s6_over_q);
        if (p_valid) begin
            s6_pz_q <= p_point;
            {s6_px_q, s6_py_q} <= {s6_py_q, s6_pz_q};
            s6_any_q <= |p_vector || (s6_any_q && !first);
        end
        if (p_valid || feed) begin
            s6_nz_q <= p_vector;
            {s6_nx_q, s6_ny_q} <= {s6_ny_q, s6_nz_q};
        end
        if (last) {s6_flat_q, s6_tag_q} <= {p_flat, in_tag_q};
    end

    // ---- behind z: to normalisation, out 7 cycles later; the rest waits at the output ----
    wire [VW+WD:0]       back   = {{VW{back_x_q[WD]}}, back_x_q};
    wire signed [VW-1:0] vector = $signed({{(VW-PV+1){s6_nx_q[PV-1]}}, s6_nx_q[PV-2:0]});
    wire signed [VW-1:0] feed_v = s6_any_q ? vector : $signed(back[VW-1:0]);
    rt_normalise #(.VW(VW), .BITS(WD)) u_normalise (
        .clk(clk), .rst(rst),
        .in_valid_i(feed), .in_v_i(feed_v),
        .out_valid_o(out_valid_o),
        .out_x_o(out_normal_x_o), .out_y_o(out_normal_y_o), .out_z_o(out_normal_z_o)
    );
    always @(posedge clk)
        if (feed_q[3]) begin
            out_tag_o       <= s6_tag_q;
            out_flat_o      <= s6_flat_q;
            out_saturated_o <= s6_over_q;
            {out_point_x_o, out_point_y_o, out_point_z_o} <= {s6_px_q, s6_py_q, s6_pz_q};
        end
    generate
        if (GUARDED != 0) begin : g_guarded
            reg [3*GW-1:0] s6_g_q, guarded_q;
            always @(posedge clk) begin
                if (guarded) s6_g_q <= {s5_g_q, s6_g_q[3*GW-1:GW]};
                if (feed_q[3]) guarded_q <= s6_g_q;
            end
            assign out_guarded_o = guarded_q;
        end else begin : g_no_guarded
            assign out_guarded_o = {3*GW{1'b0}};
        end
    endgenerate
    generate
        if (FACETS != 0) begin : g_lift
            reg [3*(NG+2)-1:0] s6_lift_q, lift_q;
            always @(posedge clk) begin
                if (p_valid) s6_lift_q <= {p_lift, s6_lift_q[3*(NG+2)-1:NG+2]};
                if (feed_q[3]) lift_q <= s6_lift_q;
            end
            assign out_lift_o = lift_q;
        end else begin : g_no_lift
            assign out_lift_o = {3*(NG+2){1'b0}};
            wire unused = &{1'b0, p_lift};
        end
    endgenerate
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_points_and_normals /* verilator public_flat_rd */ =
        {in_valid_i && !start, start, 5'd0, start || |ph_q[INTERVAL-1:1] || late};
    wire unused = &{1'b0, s1_part, s4_sum_q[0], s4_org[0], back[VW+WD:VW]};
endmodule
`default_nettype wire
