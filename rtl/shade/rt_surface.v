// rt_surface.v - from a ray's first hit to the point and normal of its surface
// SPDX-License-Identifier: Apache-2.0
// t = key / a in one of QUOTIENTS iterative dividers, then the primitive record through the leaf
// cache, then org + t*dir and the normal. Tokens wait in queues between the three. A record is
// asked for when there is a place for it: it never keeps leaves from leaving the cache.
// Where no light, no mirror and no texture asks for the point (points_on_i low; POINTS 0: never
// built), a hit goes to its record at once and leaves as an unlit surface when that is there.
// Model: sph_quotient() in cmodel/math/arith.c, sph_surface_point() in cmodel/shade/surface.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_surface #(
    parameter W     = 16,      // coordinate, bits
    parameter WD    = 17,      // direction component, bits
    parameter PQ    = 17,      // significant bits of the quotient
    parameter NG    = 2,       // guard bits of the normal
    parameter POINTS  = 1,     // 0: no light, no mirror, no texture: the record is all
    parameter BOUNCES = 1,     // 0: every ray comes from the eye
    parameter INSIDE  = 1,     // 0: no ray starts inside a sphere
    parameter FACETS  = 0,     // 1: triangles and planes too
    parameter TEXTURE = 0,     // 1: textures
    parameter SMOOTH  = 0,     // 1: interpolated normals
    parameter SPREAD  = 0,     // 1: spheres spread rays
    parameter MATERIALS   = 0,     // 1: the rest of the material, for refraction and sum
    parameter SLOTS = 32,      // power of two
    parameter LUTS  = 0,       // LUT cells that a block RAM is worth, rt_slot_ram
    parameter QUOTIENTS = 2,   // dividers
    parameter QUOTIENT_STEP = 2, // quotient bits a clock
    parameter HIT_INTERVAL = 8 // clocks a hit point and its normal, 8 or 12
) (
    input  wire                       clk,
    input  wire                       rst,
    input  wire [`RT_REGS_BITS-1:0]   regs_i,
    //: {BOX[6*(W+2)], N_LOOSE[24], LEAF_BASE[26], N_PRIMS[24], VISIT_LIMIT[24], MEM_LINES[26],
    //: SMOOTH_BASE[26], PRIM_BASE[26], ROOT[26], EYE[3*W], AMBIENT[48], BACKGROUND[24],
    //: N_LIGHTS[4], LEAST[9], MAX_DEPTH[4], TEX_FILTER[2], EFFECTS[EFFECT_BITS]}
    input  wire                       points_on_i,    // run-time switch of POINTS
    input  wire [`RT_RAY_BITS-1:0]    ray_i,          // from rt_setup
    //: {SLOT[SLOTW], H[6], Y[17], UNIT[54], INSIDE, SKIP[24], A[2*WD], DIR[3*WD], ORG[3*W], SHADOW,
    //: PRIMARY, LIGHT, NORMAL, VALID}
    input  wire [`RT_HIT_BITS-1:0]    hit_i,          // from rt_slots: tokens
    //: {SLOT[SLOTW], KEY[W+WD+2], ID[24], FAR, PROBE, FIRST, LIT, SHADOW, MISS, HIT}
    // to and from rt_leaf_unit: primitive records
    output wire [`RT_FETCH_BITS-1:0]  fetch_o,
    //: {SLOT[SLOTW], LINE[26], VALID}
    input  wire                       fetch_ready_i,
    input  wire [`RT_RECORD_BITS-1:0] record_i,
    //: {SLOT[SLOTW], DATA[256], VALID}
    // the material, as the record arrives
    output wire [`RT_MATERIAL_BITS-1:0] material_o,
    //: {SLOT[SLOTW], SMOOTH[24], BEND[6], TEX[26], INDEX[12], POWER[12], KS[8], KD[9], KA[9], SUM,
    //: KT[9], KR[9], RGB[24], VALID}
    // the surface, without a point
    output wire                       unlit_valid_o,
    output wire [$clog2(SLOTS)-1:0]   unlit_slot_o,
    // the surface
    output wire [`RT_SURFACE_BITS-1:0] surface_o,
    //: {SLOT[SLOTW], FLAT, NORMAL[3*WD], LIFT[3*(NG+2)], GUARDED[3*(W+NG)], POINT[3*W], VALID}
    // events
    output wire                       quotient_o,
    output wire                       saturated_o
);
    localparam SLOTW = $clog2(SLOTS);
    localparam KW = W + WD + 2;
    localparam FARS = INSIDE != 0 || FACETS != 0 ? 1 : 0;  // normals that are turned

    wire on = POINTS != 0 && points_on_i;
    wire [`RT_EFFECT_BITS-1:0] effects  = regs_i[`RT_REGS_EFFECTS];
    wire             in_valid = hit_i[`RT_HIT_HIT];
    wire [SLOTW-1:0] in_slot  = hit_i[`RT_HIT_SLOT];
    wire [`RT_LINE_BITS-1:0] in_line  = regs_i[`RT_REGS_PRIM_BASE] + {2'b0, hit_i[`RT_HIT_ID]};
    wire             ray_valid = ray_i[`RT_RAY_VALID] && !ray_i[`RT_RAY_SHADOW];
    wire [SLOTW-1:0] ray_slot  = ray_i[`RT_RAY_SLOT];

    // ---- t; a hit that needs none goes past ----
    localparam TW = PQ + 8;                   // {mant, exp}
    wire             t_valid;
    wire [TW-1:0]    t;
    wire [SLOTW-1:0] t_slot;
    generate
        if (POINTS != 0) begin : g_quotient
            wire             h_valid, h_in, h_taken, divider;
            wire [SLOTW-1:0] h_slot;
            wire [KW-1:0]    h_key;
            wire [2*WD-1:0]  h_a;
            reg              h_read_q;        // h and h_a belong to the head
            rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_hits (
                .clk(clk), .rst(rst), .in_valid_i(in_valid && on), .in_ready_o(h_in),
                .in_data_i(in_slot),
                .out_valid_o(h_valid), .out_ready_i(h_taken), .out_data_o(h_slot)
            );
            rt_slot_ram #(.WIDTH(KW), .SLOTS(SLOTS), .OLD(0)) u_key (
                .clk(clk), .wr_en_i(in_valid), .wr_addr_i(in_slot),
                .wr_data_i(hit_i[`RT_HIT_KEY]),
                .rd_en_i(h_valid), .rd_addr_i(h_slot), .rd_data_o(h_key)
            );
            rt_slot_ram #(.WIDTH(2*WD), .SLOTS(SLOTS), .OLD(0)) u_a (
                .clk(clk), .wr_en_i(ray_valid), .wr_addr_i(ray_slot),
                .wr_data_i(ray_i[`RT_RAY_A]),
                .rd_en_i(h_valid), .rd_addr_i(h_slot), .rd_data_o(h_a)
            );
            always @(posedge clk) begin
                h_read_q <= h_valid && !h_taken;
                if (rst) h_read_q <= 1'b0;
            end
            assign h_taken    = h_read_q && divider;
            assign quotient_o = h_taken;
            rt_quotient_pool #(.KW(KW), .AW(2*WD), .PQ(PQ), .UNITS(QUOTIENTS),
                               .STEP(QUOTIENT_STEP), .TAG(SLOTW)) u_pool (
                .clk(clk), .rst(rst), .in_valid_i(h_read_q), .in_ready_o(divider),
                .in_tag_i(h_slot), .in_key_i(h_key), .in_a_i(h_a),
                .out_valid_o(t_valid), .out_ready_i(1'b1), .out_tag_o(t_slot),
                .out_mant_o(t[TW-1:8]), .out_exp_o(t[7:0])
            );
            wire unused = h_in;
        end else begin : g_none
            assign {t_valid, t, t_slot, quotient_o} = {(TW+SLOTW+2){1'b0}};
        end
    endgenerate

    // ---- fetch the primitive record, if there is a place for it; by way of a register ----
    wire             p_in, p_valid, room;
    wire [SLOTW-1:0] p_slot;
    reg              f_valid_q;               // the slot at the port; its line is read
    reg  [SLOTW-1:0] f_slot_q;
    wire             f_take = p_valid && room && (!f_valid_q || fetch_ready_i);
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_fetches (
        .clk(clk), .rst(rst), .in_valid_i(on ? t_valid : in_valid), .in_ready_o(p_in),
        .in_data_i(on ? t_slot : in_slot),
        .out_valid_o(p_valid), .out_ready_i(f_take), .out_data_o(p_slot)
    );
    rt_slot_ram #(.WIDTH(`RT_LINE_BITS), .SLOTS(SLOTS), .OLD(0)) u_line (
        .clk(clk), .wr_en_i(in_valid), .wr_addr_i(in_slot), .wr_data_i(in_line),
        .rd_en_i(f_take), .rd_addr_i(p_slot), .rd_data_o(fetch_o[`RT_FETCH_LINE])
    );
    assign fetch_o[`RT_FETCH_VALID] = f_valid_q;
    assign fetch_o[`RT_FETCH_SLOT]  = f_slot_q;
    always @(posedge clk) begin
        if (f_take) f_slot_q <= p_slot;
        f_valid_q <= f_take || (f_valid_q && !fetch_ready_i);
        if (rst) f_valid_q <= 1'b0;
    end
    wire [255:0]     prim = record_i[`RT_RECORD_DATA];
    wire [SLOTW-1:0] prim_slot = record_i[`RT_RECORD_SLOT];
    wire             r_valid = record_i[`RT_RECORD_VALID];
    assign material_o[`RT_MATERIAL_VALID] = r_valid;
    assign material_o[`RT_MATERIAL_SLOT]  = prim_slot;
    assign material_o[`RT_MATERIAL_RGB]   = prim[`RT_PRIM_RED_LSB +: `RT_RGB_BITS];
    assign material_o[`RT_MATERIAL_KR]    = prim[`RT_PRIM_KR_LSB +: `RT_PRIM_KR_BITS];
    assign material_o[`RT_MATERIAL_TEX] =
        TEXTURE != 0 ? prim[`RT_PRIM_TEX_LSB +: `RT_PRIM_TEX_BITS] : {`RT_PRIM_TEX_BITS{1'b0}};
    assign material_o[`RT_MATERIAL_BEND] =
        SPREAD != 0 && effects[`RT_EFFECT_SPREAD]
        ? prim[`RT_PRIM_BEND_LSB +: `RT_PRIM_BEND_BITS] : {`RT_PRIM_BEND_BITS{1'b0}};
    assign material_o[`RT_MATERIAL_SMOOTH] =
        SMOOTH != 0 && effects[`RT_EFFECT_SMOOTH]
        ? prim[`RT_PRIM_SMOOTH_LSB +: `RT_PRIM_SMOOTH_BITS] : {`RT_PRIM_SMOOTH_BITS{1'b0}};
    generate
        if (MATERIALS != 0) begin : g_material
            assign material_o[`RT_MATERIAL_KT]    = prim[`RT_PRIM_KT_LSB +: `RT_PRIM_KT_BITS];
            assign material_o[`RT_MATERIAL_SUM]   = prim[`RT_PRIM_SUM_LSB];
            assign material_o[`RT_MATERIAL_KA]    = prim[`RT_PRIM_KA_LSB +: `RT_PRIM_KA_BITS];
            assign material_o[`RT_MATERIAL_KD]    = prim[`RT_PRIM_KD_LSB +: `RT_PRIM_KD_BITS];
            assign material_o[`RT_MATERIAL_KS]    = prim[`RT_PRIM_KS_LSB +: `RT_PRIM_KS_BITS];
            assign material_o[`RT_MATERIAL_POWER] =
                prim[`RT_PRIM_POWER_LSB +: `RT_PRIM_POWER_BITS];
            assign material_o[`RT_MATERIAL_INDEX] =
                prim[`RT_PRIM_INDEX_LSB +: `RT_PRIM_INDEX_BITS];
        end else begin : g_no_material
            assign material_o[`RT_MATERIAL_KT]    = {`RT_PRIM_KT_BITS{1'b0}};
            assign material_o[`RT_MATERIAL_SUM]   = 1'b0;
            assign material_o[`RT_MATERIAL_KA]    = {`RT_PRIM_KA_BITS{1'b0}};
            assign material_o[`RT_MATERIAL_KD]    = {`RT_PRIM_KD_BITS{1'b0}};
            assign material_o[`RT_MATERIAL_KS]    = {`RT_PRIM_KS_BITS{1'b0}};
            assign material_o[`RT_MATERIAL_POWER] = {`RT_PRIM_POWER_BITS{1'b0}};
            assign material_o[`RT_MATERIAL_INDEX] = {`RT_PRIM_INDEX_BITS{1'b0}};
        end
    endgenerate

    // ---- an unlit surface: one cycle after its material ----
    reg              unlit_valid_q;
    reg [SLOTW-1:0]  unlit_slot_q;
    always @(posedge clk) begin
        unlit_valid_q <= r_valid && !on;
        unlit_slot_q  <= prim_slot;
        if (rst) unlit_valid_q <= 1'b0;
    end
    assign unlit_valid_o = unlit_valid_q;
    assign unlit_slot_o  = unlit_slot_q;

    // ---- record, ray and t side by side, then point and normal ----
    generate
        if (POINTS != 0) begin : g_point
            wire [TW-1:0]    r_t;
            wire [3*W-1:0]   r_org;
            wire [3*WD-1:0]  r_dir;
            wire             r_far, ready, saturated;
            wire [3*W-1:0]   point;
            wire [3*WD-1:0]  normal;
            reg              r_read_q;        // r_slot_q is loaded; its ray and t are read
            reg              r_valid_q;
            reg [SLOTW-1:0]  r_slot_q;
            reg [`RT_LEAF_STRIDE-1:0] r_shape_q;  // what is no material

            localparam EW = SLOTW + `RT_LEAF_STRIDE;
            wire             credit;
            wire             e_valid;         // the next record goes to r, then ray and t are read
            wire [EW-1:0]    e;
            wire             r_ready = !r_read_q && (!r_valid_q || ready);
            wire             e_load = e_valid && r_ready;
            assign room = !on || credit;
            rt_credit_fifo #(.WIDTH(EW), .DEPTH(16)) u_records (
                .clk(clk), .rst(rst),
                .credit_o(credit), .ask_i(on && f_take),
                .in_valid_i(on && r_valid), .in_data_i({prim_slot, prim[`RT_LEAF_STRIDE-1:0]}),
                .out_valid_o(e_valid), .out_ready_i(r_ready), .out_data_o(e)
            );
            rt_slot_ram #(.WIDTH(TW), .SLOTS(SLOTS), .OLD(0)) u_t (
                .clk(clk), .wr_en_i(t_valid), .wr_addr_i(t_slot),
                .wr_data_i(t),
                .rd_en_i(r_read_q), .rd_addr_i(r_slot_q), .rd_data_o(r_t)
            );
            if (BOUNCES != 0) begin : g_org
                rt_slot_ram #(.WIDTH(3*W+3*WD), .SLOTS(SLOTS), .OLD(0)) u_ray (
                    .clk(clk), .wr_en_i(ray_valid), .wr_addr_i(ray_slot),
                    .wr_data_i({ray_i[`RT_RAY_DIR], ray_i[`RT_RAY_ORG]}),
                    .rd_en_i(r_read_q), .rd_addr_i(r_slot_q), .rd_data_o({r_dir, r_org})
                );
            end else begin : g_eye
                rt_slot_ram #(.WIDTH(3*WD), .SLOTS(SLOTS), .OLD(0)) u_ray (
                    .clk(clk), .wr_en_i(ray_valid), .wr_addr_i(ray_slot),
                    .wr_data_i(ray_i[`RT_RAY_DIR]),
                    .rd_en_i(r_read_q), .rd_addr_i(r_slot_q), .rd_data_o(r_dir)
                );
                assign r_org = regs_i[`RT_REGS_EYE];
            end
            if (FARS != 0) begin : g_far
                rt_slot_ram #(.WIDTH(1), .SLOTS(SLOTS), .OLD(0), .LUTS(LUTS)) u_far (
                    .clk(clk), .wr_en_i(in_valid), .wr_addr_i(in_slot),
                    .wr_data_i(hit_i[`RT_HIT_FAR]),
                    .rd_en_i(r_read_q), .rd_addr_i(r_slot_q), .rd_data_o(r_far)
                );
            end else begin : g_near
                assign r_far = 1'b0;
            end
            always @(posedge clk) begin
                if (e_load)  {r_slot_q, r_shape_q} <= e;
                r_read_q  <= e_load;
                r_valid_q <= r_read_q || (r_valid_q && !ready);
                if (rst) begin r_read_q <= 1'b0; r_valid_q <= 1'b0; end
            end
            rt_hit #(.W(W), .WD(WD), .PQ(PQ), .NG(NG), .INSIDE(FARS), .FACETS(FACETS),
                     .GUARDED(TEXTURE != 0 || SMOOTH != 0 ? 1 : 0),
                     .INTERVAL(HIT_INTERVAL), .TAG(SLOTW)) u_hit (
                .clk(clk), .rst(rst), .effects_i(effects),
                .in_valid_i(r_valid_q), .in_ready_o(ready), .in_tag_i(r_slot_q),
                .in_mant_i(r_t[TW-1:8]), .in_exp_i($signed(r_t[7:0])),
                .in_org_x_i($signed(r_org[`RT_POINT_X])), .in_org_y_i($signed(r_org[`RT_POINT_Y])),
                .in_org_z_i($signed(r_org[`RT_POINT_Z])),
                .in_dir_x_i($signed(r_dir[`RT_VEC_X])), .in_dir_y_i($signed(r_dir[`RT_VEC_Y])),
                .in_dir_z_i($signed(r_dir[`RT_VEC_Z])),
                .in_shape_i(r_shape_q), .in_far_i(r_far),
                .out_valid_o(surface_o[`RT_SURFACE_VALID]),
                .out_tag_o(surface_o[`RT_SURFACE_SLOT]),
                .out_point_x_o(point[`RT_POINT_X]), .out_point_y_o(point[`RT_POINT_Y]),
                .out_point_z_o(point[`RT_POINT_Z]),
                .out_guarded_o(surface_o[`RT_SURFACE_GUARDED]),
                .out_lift_o(surface_o[`RT_SURFACE_LIFT]),
                .out_normal_x_o(normal[`RT_VEC_X]), .out_normal_y_o(normal[`RT_VEC_Y]),
                .out_normal_z_o(normal[`RT_VEC_Z]),
                .out_flat_o(surface_o[`RT_SURFACE_FLAT]), .out_saturated_o(saturated)
            );
            assign surface_o[`RT_SURFACE_POINT]  = point;
            assign surface_o[`RT_SURFACE_NORMAL] = normal;
            assign saturated_o = surface_o[`RT_SURFACE_VALID] && saturated;
        end else begin : g_unlit
            assign room = 1'b1;
            assign saturated_o = 1'b0;
            assign surface_o   = {`RT_SURFACE_BITS{1'b0}};
        end
    endgenerate
    wire unused = &{1'b0, regs_i, effects, ray_i, ray_valid, ray_slot, hit_i, prim, p_in, t,
                    t_slot};
endmodule
`default_nettype wire
