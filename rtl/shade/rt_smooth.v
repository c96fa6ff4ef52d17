// rt_smooth.v - interpolated normals of triangles
// SPDX-License-Identifier: Apache-2.0
//   v = sat(n + round(m sat(guarded - b*2^NG) * 2^-e))   a row of m each; turned, normalised
// Between rt_surface and rt_setup: the normal of a triangle with a record of normals waits for it,
// any other goes by in the same clock. The facet's own normal and its square leave beside.
//   surface --> queue --> fetch, with that of rt_surface --> queue --> one multiplier --> normalise
//   operands | difference | product | sum of three | shift | shift | add | turn | normalise
// A normal every 21 clocks, 29 clocks behind its record. One that is zero stays the facet's own.
// Model: sph_smooth_normal() in cmodel/shade/surface.c, sph_surface_bend() in surface.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_smooth #(
    parameter W     = 16,   // coordinate, bits
    parameter WD    = 17,   // direction component, bits
    parameter NG    = 2,    // guard bits of the hit point
    parameter SLOTS = 32    // power of two
) (
    input  wire                          clk,
    input  wire                          rst,
    input  wire [`RT_REGS_BITS-1:0]      regs_i,
    //: {BOX[6*(W+2)], N_LOOSE[24], LEAF_BASE[26], N_PRIMS[24], VISIT_LIMIT[24], MEM_LINES[26],
    //: SMOOTH_BASE[26], PRIM_BASE[26], ROOT[26], EYE[3*W], AMBIENT[48], BACKGROUND[24],
    //: N_LIGHTS[4], LEAST[9], MAX_DEPTH[4], TEX_FILTER[2], EFFECTS[EFFECT_BITS]}
    // from rt_surface, rt_slots
    input  wire [`RT_MATERIAL_BITS-1:0]  material_i,
    //: {SLOT[SLOTW], SMOOTH[24], BEND[6], TEX[26], INDEX[12], POWER[12], KS[8], KD[9], KA[9], SUM,
    //: KT[9], KR[9], RGB[24], VALID}
    input  wire [`RT_HIT_BITS-1:0]       hit_i,
    //: {SLOT[SLOTW], KEY[W+WD+2], ID[24], FAR, PROBE, FIRST, LIT, SHADOW, MISS, HIT}
    input  wire [`RT_SURFACE_BITS-1:0]   surface_i,
    //: {SLOT[SLOTW], FLAT, NORMAL[3*WD], LIFT[3*(NG+2)], GUARDED[3*(W+NG)], POINT[3*W], VALID}
    // rt_surface's side and rt_leaf_unit's side of the records
    input  wire [`RT_FETCH_BITS-1:0]     fetch_i,
    //: {SLOT[SLOTW], LINE[26], VALID}
    output wire                          fetch_ready_o,
    output wire [`RT_RECORD_BITS-1:0]    record_o,
    //: {SLOT[SLOTW], DATA[256], VALID}
    output wire [`RT_FETCH_BITS-1:0]     fetch_o,
    input  wire                          fetch_ready_i,
    input  wire [`RT_RECORD_BITS-1:0]    record_i,
    // to rt_setup, and the facet beside it
    output wire [`RT_VECTOR_BITS-1:0]    normal_o,
    //: {SLOT[SLOTW], VEC[3*WD], VALID}
    output wire [`RT_SIDE_BITS-1:0]      side_o,
    //: {SLOT[SLOTW], NN[2*WD], VEC[3*WD], BENT, VALID}
    output wire                          bad_node_o   // a record behind the end of memory
);
    localparam SLOTW = $clog2(SLOTS);
    localparam LB = `RT_LINE_BITS;
    localparam GW = W + NG;                   // guarded coordinate
    localparam MB = `RT_SMOOTH_M_XX_BITS;
    localparam NB = `RT_SMOOTH_N_X_BITS;
    localparam VB = 20;                       // s4.15, of a normal
    localparam AW = WD > MB ? WD : MB;        // operands
    localparam BW = GW > WD ? GW : WD;
    localparam SW = AW + BW + 2;              // sum of three products
    localparam FW = VB + 1 > WD ? VB + 1 : WD; // to be normalised
    genvar c;

    // ---- where the record of a slot's normals stands, as its material arrives ----
    wire [23:0]      m_number = material_i[`RT_MATERIAL_SMOOTH];
    wire [LB:0]      m_line = {1'b0, regs_i[`RT_REGS_SMOOTH_BASE]} + {3'd0, m_number} - 1'b1;
    wire             m_outside = m_line >= {1'b0, regs_i[`RT_REGS_MEM_LINES]};
    wire [SLOTW-1:0] in_slot = surface_i[`RT_SURFACE_SLOT];
    wire             in_numbered, in_outside;
    rt_slot_file #(.WIDTH(2), .SLOTS(SLOTS)) u_any (
        .clk(clk), .wr_en_i(material_i[`RT_MATERIAL_VALID]),
        .wr_addr_i(material_i[`RT_MATERIAL_SLOT]), .wr_data_i({m_outside, m_number != 24'd0}),
        .rd_addr_i(in_slot), .rd_data_o({in_outside, in_numbered})
    );
    wire             in_valid = surface_i[`RT_SURFACE_VALID];
    wire             in_any   = in_numbered && surface_i[`RT_SURFACE_FLAT];  // it means something
    wire             in_bent  = in_any && !in_outside;
    assign bad_node_o = in_valid && in_any && in_outside;

    // ---- its fetch goes before those of rt_surface ----
    wire             f_in, f_valid;
    wire [SLOTW-1:0] f_slot;
    reg              f_read_q;                // the line belongs to the head
    wire             credit;                  // there is a place for its record
    wire             f_go    = f_read_q && credit;
    wire             f_taken = f_go && fetch_ready_i;
    wire [LB-1:0]    f_line;
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_fetches (
        .clk(clk), .rst(rst), .in_valid_i(in_valid && in_bent), .in_ready_o(f_in),
        .in_data_i(in_slot), .out_valid_o(f_valid), .out_ready_i(f_taken), .out_data_o(f_slot)
    );
    rt_slot_ram #(.WIDTH(LB), .SLOTS(SLOTS), .OLD(0)) u_line (
        .clk(clk), .wr_en_i(material_i[`RT_MATERIAL_VALID]),
        .wr_addr_i(material_i[`RT_MATERIAL_SLOT]), .wr_data_i(m_line[LB-1:0]),
        .rd_en_i(f_valid), .rd_addr_i(f_slot), .rd_data_o(f_line)
    );
    assign fetch_o[`RT_FETCH_VALID] = f_go || fetch_i[`RT_FETCH_VALID];
    assign fetch_o[`RT_FETCH_SLOT]  = f_go ? f_slot : fetch_i[`RT_FETCH_SLOT];
    assign fetch_o[`RT_FETCH_LINE]  = f_go ? f_line : fetch_i[`RT_FETCH_LINE];
    assign fetch_ready_o = fetch_ready_i && !f_go;

    // ---- a slot has one record under way: mine_q tells whose ----
    reg  [SLOTS-1:0] mine_q;
    wire [SLOTW-1:0] rec_slot = record_i[`RT_RECORD_SLOT];
    wire             mine = mine_q[rec_slot];
    wire             r_valid, r_take;
    wire             r_load = record_i[`RT_RECORD_VALID] && mine;
    wire [255:0]     r;
    wire [SLOTW-1:0] r_slot;
    assign record_o[`RT_RECORD_VALID] = record_i[`RT_RECORD_VALID] && !mine;
    assign record_o[`RT_RECORD_SLOT]  = rec_slot;
    assign record_o[`RT_RECORD_DATA]  = record_i[`RT_RECORD_DATA];
    always @(posedge clk) begin
        f_read_q <= f_valid && !f_taken;
        if (f_taken) mine_q[f_slot]   <= 1'b1;
        if (r_load)  mine_q[rec_slot] <= 1'b0;
        if (rst) begin f_read_q <= 1'b0; mine_q <= {SLOTS{1'b0}}; end
    end
    rt_credit_fifo #(.WIDTH(256+SLOTW), .DEPTH(16)) u_records (
        .clk(clk), .rst(rst), .credit_o(credit), .ask_i(f_taken), .in_valid_i(r_load),
        .in_data_i({rec_slot, record_i[`RT_RECORD_DATA]}),
        .out_valid_o(r_valid), .out_ready_i(r_take), .out_data_o({r_slot, r})
    );

    // ---- the hit beside it ----
    reg              r_read_q;
    wire [3*GW-1:0]  r_point;
    wire [3*WD-1:0]  r_side;
    wire             r_far;
    rt_slot_ram #(.WIDTH(3*GW+3*WD), .SLOTS(SLOTS), .OLD(0)) u_hit (
        .clk(clk), .wr_en_i(in_valid), .wr_addr_i(in_slot),
        .wr_data_i({surface_i[`RT_SURFACE_NORMAL], surface_i[`RT_SURFACE_GUARDED]}),
        .rd_en_i(r_valid), .rd_addr_i(r_slot), .rd_data_o({r_side, r_point})
    );
    rt_slot_ram #(.WIDTH(1), .SLOTS(SLOTS), .OLD(0)) u_far (
        .clk(clk), .wr_en_i(hit_i[`RT_HIT_HIT]), .wr_addr_i(hit_i[`RT_HIT_SLOT]),
        .wr_data_i(hit_i[`RT_HIT_FAR]),
        .rd_en_i(r_valid), .rd_addr_i(r_slot), .rd_data_o(r_far)
    );

    // ---- steps 0 to 8: products of the rows x, y, z; 9 to 11: squares of the facet's normal ----
    reg              busy_q, go_q, far_q;
    reg  [3:0]       step_q;
    reg  [1:0]       part_q, row_q;           // of step_q: x, y, z
    reg  [SLOTW-1:0] slot_q;
    reg  [9*MB-1:0]  m_q;                     // the one in turn at the bottom, as of the others
    reg  [3*W-1:0]   base_q;
    reg  [3*GW-1:0]  point_q;
    reg  [`RT_SMOOTH_E_BITS-1:0] e_q;
    reg  [3*WD-1:0]  side_q;
    wire             done;                    // all of it is on its way to the normaliser
    wire             square = row_q == 2'd3;
    assign r_take = r_read_q && !busy_q;
    always @(posedge clk) begin
        r_read_q <= r_valid && !r_take;
        if (r_take) begin
            {slot_q, point_q, side_q, far_q} <= {r_slot, r_point, r_side, r_far};
            m_q    <= r[`RT_SMOOTH_M_XX_LSB +: 9*MB];
            e_q    <= r[`RT_SMOOTH_E_LSB +: `RT_SMOOTH_E_BITS];
            base_q <= {r[`RT_SMOOTH_B_Z_LSB +: W], r[`RT_SMOOTH_B_Y_LSB +: W],
                       r[`RT_SMOOTH_B_X_LSB +: W]};
            step_q <= 4'd0;
            part_q <= 2'd0;
            row_q  <= 2'd0;
        end else if (go_q) begin
            step_q <= step_q + 4'd1;
            part_q <= part_q == 2'd2 ? 2'd0 : part_q + 2'd1;
            row_q  <= part_q == 2'd2 ? row_q + 2'd1 : row_q;
            m_q     <= m_q >> MB;
            base_q  <= {base_q[W-1:0], base_q[3*W-1:W]};
            point_q <= {point_q[GW-1:0], point_q[3*GW-1:GW]};
            if (square) side_q <= {side_q[WD-1:0], side_q[3*WD-1:WD]};
        end
        if (r_take)               busy_q <= 1'b1;
        else if (done)            busy_q <= 1'b0;
        if (r_take)               go_q <= 1'b1;
        else if (step_q == 4'd11) go_q <= 1'b0;
        if (rst) {r_read_q, busy_q, go_q} <= 3'd0;
    end

    // ---- stage 0: operands; stage 1: difference, limited ----
    wire signed [MB-1:0] factor = m_q[MB-1:0];
    wire signed [WD-1:0] side   = side_q[WD-1:0];
    reg                  s0_last_q, s1_last_q, s2_last_q, s3_last_q;  // third of its row
    reg                  s0_first_q, s1_first_q, s2_first_q;
    reg                  s0_square_q, s1_square_q, s2_square_q, s3_square_q;
    reg  signed [AW-1:0] s0_a_q, s1_a_q;
    reg  signed [GW-1:0] s0_point_q;
    reg  signed [W-1:0]  s0_base_q;
    reg  signed [BW-1:0] s1_b_q;
    wire signed [GW:0]   s0_base = $signed({s0_base_q[W-1], s0_base_q, {NG{1'b0}}});
    wire signed [GW:0]   s0_diff = $signed({s0_point_q[GW-1], s0_point_q}) - s0_base;
    wire                 s0_over = s0_diff[GW] != s0_diff[GW-1];
    wire signed [GW-1:0] s0_d = s0_over ? $signed({s0_diff[GW], {(GW-1){!s0_diff[GW]}}})
                                        : $signed(s0_diff[GW-1:0]);
    reg  signed [SW-3:0] s2_prod_q;
    reg  signed [SW-1:0] s3_sum_q;
    always @(posedge clk) begin
        s0_last_q   <= go_q && part_q == 2'd2;
        s0_first_q  <= part_q == 2'd0;
        s0_square_q <= square;
        s0_a_q      <= square ? {{(AW-WD){side[WD-1]}}, side} : {{(AW-MB){factor[MB-1]}}, factor};
        s0_point_q  <= point_q[GW-1:0];
        s0_base_q   <= base_q[W-1:0];
        s1_last_q   <= s0_last_q;
        s1_first_q  <= s0_first_q;
        s1_square_q <= s0_square_q;
        s1_a_q      <= s0_a_q;
        s1_b_q      <= s0_square_q ? {{(BW-WD){s0_a_q[WD-1]}}, s0_a_q[WD-1:0]}
                                   : {{(BW-GW){s0_d[GW-1]}}, s0_d};
        s2_last_q   <= s1_last_q;
        s2_first_q  <= s1_first_q;
        s2_square_q <= s1_square_q;
        s2_prod_q   <= s1_a_q * s1_b_q;
        s3_last_q   <= s2_last_q;
        s3_square_q <= s2_square_q;
        s3_sum_q    <= (s2_first_q ? {SW{1'b0}} : s3_sum_q) + {{2{s2_prod_q[SW-3]}}, s2_prod_q};
        if (rst) {s0_last_q, s1_last_q, s2_last_q, s3_last_q} <= 4'd0;
    end

    // ---- stages 4 and 5: shift, a bit kept to round; stage 6: add; stage 7: limit, turn ----
    wire [5:0]           e = e_q;
    reg                  s4_last_q, s5_last_q, s6_last_q;
    reg  signed [SW:0]   s4_q, s5_q, s6_q;
    reg  [3*NB-1:0]      n_q;                 // of the row that is next in stage 6
    wire        [SW:0]   s5_n = {{(SW+1-NB){n_q[NB-1]}}, n_q[NB-1:0]};
    wire        [SW+1:0] s5_sum = {s5_q[SW], s5_q[SW:1], 1'b1} + {s5_n, s5_q[0]};  // half up
    wire                 s6_over = s6_q[SW:VB-1] != {(SW-VB+2){s6_q[SW]}};
    wire signed [VB:0]   s6_v = s6_over ? $signed({{2{s6_q[SW]}}, {(VB-1){!s6_q[SW]}}})
                                        : $signed(s6_q[VB:0]);
    reg  [3*(VB+1)-1:0]  v_q;                 // {z, y, x}
    reg  [1:0]           rows_q;
    reg                  all_q;               // z is in
    always @(posedge clk) begin
        s4_last_q <= s3_last_q && !s3_square_q;
        s4_q      <= $signed({s3_sum_q, 1'b0}) >>> {e[5:3], 3'd0};
        s5_last_q <= s4_last_q;
        s5_q      <= s4_q >>> e[2:0];
        if (r_take)         n_q <= r[`RT_SMOOTH_N_X_LSB +: 3*NB];
        else if (s5_last_q) n_q <= n_q >> NB;
        s6_last_q <= s5_last_q;
        s6_q      <= s5_sum[SW+1:1];
        if (s6_last_q) v_q <= {far_q ? -s6_v : s6_v, v_q[3*(VB+1)-1:VB+1]};
        if (r_take)         rows_q <= 2'd0;
        else if (s6_last_q) rows_q <= rows_q + 2'd1;
        all_q <= s6_last_q && rows_q == 2'd2;
        if (rst) {s4_last_q, s5_last_q, s6_last_q, all_q} <= 4'd0;
    end

    // ---- to normalisation in three clocks, out 7 clocks behind the third ----
    wire                 any = |v_q;
    reg  [2:0]           feed_q;
    reg  signed [FW-1:0] x_q, y_q, z_q;
    wire [3*FW-1:0]      feed_v;
    generate
        for (c = 0; c < 3; c = c + 1) begin : g_feed
            wire signed [VB:0]   bent = v_q[(VB+1)*c +: VB+1];
            wire signed [WD-1:0] own  = side_q[WD*c +: WD];
            assign feed_v[FW*c +: FW] = any ? {{(FW-VB-1){bent[VB]}}, bent}
                                            : {{(FW-WD){own[WD-1]}}, own};
        end
    endgenerate
    reg  [SLOTW-1:0]     o_slot_q;
    reg                  o_any_q, o_wait_q;
    reg  [3*WD-1:0]      o_side_q, o_normal_q;
    reg  [2*WD-1:0]      o_nn_q;
    wire                 n_valid;
    wire [3*WD-1:0]      n_normal;
    wire                 in_direct = in_valid && !in_bent;
    wire                 o_go = o_wait_q && !in_direct;
    assign done = all_q;
    always @(posedge clk) begin
        feed_q <= {feed_q[1:0], all_q};
        if (all_q) {z_q, y_q, x_q} <= feed_v;
        else       {y_q, x_q} <= {z_q, y_q};
        if (all_q) begin
            o_slot_q <= slot_q;
            o_any_q  <= any;
            o_side_q <= side_q;
        end
        if (s3_last_q && s3_square_q) o_nn_q <= s3_sum_q[2*WD-1:0];
        if (n_valid)   {o_wait_q, o_normal_q} <= {1'b1, n_normal};
        else if (o_go) o_wait_q <= 1'b0;
        if (rst) {feed_q, o_wait_q} <= 4'd0;
    end
    rt_normalise #(.VW(FW), .BITS(WD)) u_normalise (
        .clk(clk), .rst(rst), .in_valid_i(|feed_q), .in_v_i(x_q),
        .out_valid_o(n_valid), .out_x_o(n_normal[`RT_VEC_X]), .out_y_o(n_normal[`RT_VEC_Y]),
        .out_z_o(n_normal[`RT_VEC_Z])
    );

    // ---- out: what goes by first ----
    assign normal_o[`RT_VECTOR_VALID] = in_direct || o_wait_q;
    assign normal_o[`RT_VECTOR_SLOT]  = in_direct ? in_slot : o_slot_q;
    assign normal_o[`RT_VECTOR_VEC]   = in_direct ? surface_i[`RT_SURFACE_NORMAL] : o_normal_q;
    assign side_o[`RT_SIDE_VALID] = normal_o[`RT_VECTOR_VALID];
    assign side_o[`RT_SIDE_SLOT]  = normal_o[`RT_VECTOR_SLOT];
    assign side_o[`RT_SIDE_BENT]  = !in_direct && o_any_q;
    assign side_o[`RT_SIDE_VEC]   = o_side_q;
    assign side_o[`RT_SIDE_NN]    = o_nn_q;
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_interpolated_normals /* verilator public_flat_rd */ =
        {r_read_q && busy_q, r_take, 5'd0, r_take || busy_q};
    wire unused = &{1'b0, regs_i, material_i, hit_i, surface_i, f_in, m_line, s5_sum[0], r};
endmodule
`default_nettype wire
