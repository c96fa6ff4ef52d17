// rt_rays.v - which ray follows a surface: mirrored, refracted, one that waits, or none
// SPDX-License-Identifier: Apache-2.0
// A surface with a transmitted share goes through rt_refract. If a mirror ray leaves it too, that
// goes first and the refracted ray waits with all that it needs, in one of DEEPEST places of its
// slot, a place a depth. After a surface that no ray leaves, the deepest ray that waits goes on; if
// none waits, the pixel is complete. Surfaces that refract go before others.
// Model: path(), leaving_rays() in cmodel/engine/render_pixel.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_rays #(
    parameter W     = 16,  // coordinate, bits
    parameter WD    = 17,  // direction component, bits
    parameter PQ    = 17,  // quotient, significant bits
    parameter NG    = 2,   // guard bits of the hit point
    parameter PR    = 0,   // significant bits of the root, 0: all
    parameter DEEPEST = 5, // rays one after another, at most
    parameter PATHS = 0,   // bits kept of a ray's path: W+8 for textures, W+18 with its spread
    parameter SLOTS = 32  // power of two
) (
    input  wire              clk,
    input  wire              rst,
    // what a ray needs: from rt_setup, rt_slots, rt_surface, rt_texture
    input  wire [`RT_RAY_BITS-1:0]      ray_i,
    //: {SLOT[SLOTW], H[6], Y[17], UNIT[54], INSIDE, SKIP[24], A[2*WD], DIR[3*WD], ORG[3*W], SHADOW,
    //: PRIMARY, LIGHT, NORMAL, VALID}
    input  wire [`RT_HIT_BITS-1:0]      hit_i,
    //: {SLOT[SLOTW], KEY[W+WD+2], ID[24], FAR, PROBE, FIRST, LIT, SHADOW, MISS, HIT}
    input  wire [`RT_MATERIAL_BITS-1:0] material_i,
    //: {SLOT[SLOTW], SMOOTH[24], BEND[6], TEX[26], INDEX[12], POWER[12], KS[8], KD[9], KA[9], SUM,
    //: KT[9], KR[9], RGB[24], VALID}
    input  wire [`RT_SURFACE_BITS-1:0]  surface_i,
    //: {SLOT[SLOTW], FLAT, NORMAL[3*WD], LIFT[3*(NG+2)], GUARDED[3*(W+NG)], POINT[3*W], VALID}
    input  wire                         path_valid_i,
    input  wire [$clog2(SLOTS)-1:0]     path_slot_i,
    input  wire [W+17:0]                path_i,     // {bend, spread, path}: rt_texture_path
    // from rt_compose: a surface is blended
    input  wire [`RT_BLEND_BITS-1:0]    blend_i,
    //: {SLOT[SLOTW], W_TOTAL[17], W_REFRACT[17], W_MIRROR[17], DEPTH[4], REFRACT, MIRROR, PROBE,
    //: LAST, VALID}
    // the next ray of its pixel, or none
    output wire              mirror_valid_o,  // to rt_mirrors
    output wire [$clog2(SLOTS)-1:0] slot_o,
    output wire              end_valid_o,     // the pixel is complete
    output wire              next_valid_o,    // weight and depth of what the next ray will hit
    output wire [16:0]       next_weight_o,
    output wire [3:0]        next_depth_o,
    // a refracted ray, to rt_setup and to where its origin is kept
    output wire              out_valid_o,     // with out_ready_i
    input  wire              out_ready_i,
    output wire [3*WD-1:0]   out_vec_o,
    output wire [3*W-1:0]    out_point_o,
    output wire [`RT_ID_BITS:0] out_skip_o,   // {inside, id}
    output wire [W+17:0]     out_path_o
);
    localparam SLOTW = $clog2(SLOTS);
    localparam IB   = `RT_ID_BITS;
    localparam WB   = 17;                            // u1.16, weight
    localparam RW   = 3*WD + 3*W + IB + 1;           // {skip, point, dir}
    localparam GW   = RW + WB;                       // {weight, ray}
    localparam DB   = $clog2(DEEPEST + 1);           // depth
    localparam EW   = SLOTW + DB + 1 + 3*WB;         // {weights, mirror, depth, slot}
    localparam BW   = SLOTW + DB + 1 + WB;

    // ---- queues: surfaces to refract at, all others ----
    wire             a_valid, a_take, a_in, b_valid, b_take, b_in;
    wire [EW-1:0]    a;
    wire [SLOTW-1:0] b_slot, r_slot;
    wire [DB-1:0]    b_depth, r_depth;
    wire             b_mirror, r_mirror;
    wire [WB-1:0]    b_weight;
    wire             in_valid   = blend_i[`RT_BLEND_VALID];
    wire             in_refract = blend_i[`RT_BLEND_REFRACT];
    wire             in_mirror  = blend_i[`RT_BLEND_MIRROR] || blend_i[`RT_BLEND_PROBE];
    wire [3:0]       in_depth   = blend_i[`RT_BLEND_DEPTH];
    wire [SLOTW+DB:0] in_what = {in_mirror, in_depth[DB-1:0], blend_i[`RT_BLEND_SLOT]};
    rt_fifo #(.WIDTH(EW), .DEPTH(SLOTS)) u_bends (
        .clk(clk), .rst(rst), .in_valid_i(in_valid && in_refract), .in_ready_o(a_in),
        .in_data_i({blend_i[`RT_BLEND_W_TOTAL], blend_i[`RT_BLEND_W_REFRACT],
                    blend_i[`RT_BLEND_W_MIRROR], in_what}),
        .out_valid_o(a_valid), .out_ready_i(a_take), .out_data_o(a)
    );
    rt_fifo #(.WIDTH(BW), .DEPTH(SLOTS)) u_others (
        .clk(clk), .rst(rst), .in_valid_i(in_valid && !in_refract), .in_ready_o(b_in),
        .in_data_i({blend_i[`RT_BLEND_W_MIRROR], in_what}),
        .out_valid_o(b_valid), .out_ready_i(b_take),
        .out_data_o({b_weight, b_mirror, b_depth, b_slot})
    );

    // ---- refraction: one at a time, its result waits ----
    wire [SLOTW-1:0] a_slot = a[SLOTW-1:0];
    wire [3*WD-1:0]  a_dir, a_normal;
    wire [2*WD-1:0]  a_a, a_nn;
    wire [11:0]      a_index;
    wire             a_far, bend_ready, bent, bent_total, r_take;
    wire [EW-1:0]    bent_what;
    wire [3*WD-1:0]  bent_dir;
    reg              a_read_q;                       // what belongs to the head is read
    reg              r_valid_q, r_total_q;
    reg [EW-1:0]     r_q;
    reg [3*WD-1:0]   r_dir_q;
    wire [WB-1:0]    r_weight, r_bent, r_total;      // mirrored; refracted; all is reflected
    assign {r_total, r_bent, r_weight, r_mirror, r_depth, r_slot} = r_q;
    rt_slot_ram #(.WIDTH(5*WD), .SLOTS(SLOTS), .OLD(0)) u_dir (
        .clk(clk), .wr_en_i(ray_i[`RT_RAY_VALID] && !ray_i[`RT_RAY_SHADOW]),
        .wr_addr_i(ray_i[`RT_RAY_SLOT]), .wr_data_i({ray_i[`RT_RAY_A], ray_i[`RT_RAY_DIR]}),
        .rd_en_i(a_valid), .rd_addr_i(a_slot), .rd_data_o({a_a, a_dir})
    );
    rt_slot_ram #(.WIDTH(5*WD), .SLOTS(SLOTS), .OLD(0)) u_normal (
        .clk(clk), .wr_en_i(ray_i[`RT_RAY_NORMAL]), .wr_addr_i(ray_i[`RT_RAY_SLOT]),
        .wr_data_i({ray_i[`RT_RAY_A], ray_i[`RT_RAY_DIR]}),
        .rd_en_i(a_valid), .rd_addr_i(a_slot), .rd_data_o({a_nn, a_normal})
    );
    rt_slot_ram #(.WIDTH(12), .SLOTS(SLOTS), .OLD(0)) u_index (
        .clk(clk), .wr_en_i(material_i[`RT_MATERIAL_VALID]),
        .wr_addr_i(material_i[`RT_MATERIAL_SLOT]), .wr_data_i(material_i[`RT_MATERIAL_INDEX]),
        .rd_en_i(a_valid), .rd_addr_i(a_slot), .rd_data_o(a_index)
    );
    rt_slot_file #(.WIDTH(1), .SLOTS(SLOTS)) u_far (
        .clk(clk), .wr_en_i(hit_i[`RT_HIT_HIT]), .wr_addr_i(hit_i[`RT_HIT_SLOT]),
        .wr_data_i(hit_i[`RT_HIT_FAR]),
        .rd_addr_i(a_slot), .rd_data_o(a_far)
    );
    wire             a_go = a_read_q && !r_valid_q;   // with a result bend_ready is low
    assign a_take = a_go && bend_ready;
    always @(posedge clk) begin
        a_read_q <= a_valid && !a_take;
        if (bent) begin
            r_valid_q <= 1'b1;
            r_total_q <= bent_total;
            r_q       <= bent_what;
            r_dir_q   <= bent_dir;
        end else if (r_take) begin
            r_valid_q <= 1'b0;
        end
        if (rst) begin a_read_q <= 1'b0; r_valid_q <= 1'b0; end
    end
    rt_refract #(.W(W), .WD(WD), .PR(PR), .TAG(EW)) u_refract (
        .clk(clk), .rst(rst), .in_valid_i(a_go), .in_ready_o(bend_ready), .in_tag_i(a),
        .in_dir_i(a_dir), .in_a_i(a_a), .in_normal_i(a_normal), .in_nn_i(a_nn),
        .in_from_i(a_far ? a_index : 12'd`RT_INDEX_ONE),
        .in_to_i(a_far ? 12'd`RT_INDEX_ONE : a_index),
        .out_valid_o(bent), .out_tag_o(bent_what), .out_total_o(bent_total),
        .out_dir_o(bent_dir)
    );

    // ---- where a refracted ray starts: behind a facet, steps back from the point before it ----
    // 1 for its rounding, what the quotient may have lost, 1 for the guard bits
    localparam [31:0] BACKWARDS = 2 + (W + 2 >= PQ ? 1 << (W + 2 - PQ) : 0);
    wire [3*W-1:0]   point = surface_i[`RT_SURFACE_POINT];
    wire [3*WD-1:0]  normal = surface_i[`RT_SURFACE_NORMAL];
    wire [3*W-1:0]   behind;
    genvar           c;
    generate
        for (c = 0; c < 3; c = c + 1) begin : g_behind
            wire         any  = surface_i[`RT_SURFACE_FLAT] && normal[WD*c +: WD] != {WD{1'b0}};
            wire [W:0]   step = normal[WD*c+WD-1] ? BACKWARDS[W:0] : -BACKWARDS[W:0];
            wire [W:0]   sum  = {point[W*c+W-1], point[W*c +: W]} + (any ? step : {(W+1){1'b0}});
            assign behind[W*c +: W] = sum[W] != sum[W-1] ? {sum[W], {(W-1){!sum[W]}}}
                                      : sum[W-1:0];
        end
    endgenerate

    // ---- a surface with all that is known of it ----
    localparam [1:0] IDLE = 2'd0, ACT = 2'd1, POP = 2'd2, GO = 2'd3;
    reg  [1:0]       state_q;
    reg              v_bend_q, v_mirror_q;           // rays that leave it
    reg  [SLOTW-1:0] v_slot_q;
    reg  [DB-1:0]    v_depth_q;
    reg  [WB-1:0]    v_weight_q, v_bent_q;           // of a mirrored, of a refracted ray
    reg  [3*WD-1:0]  v_dir_q;
    wire             pick = state_q == IDLE && (r_valid_q || b_valid);
    wire [SLOTW-1:0] slot = r_valid_q ? r_slot : b_slot;
    assign r_take = state_q == IDLE && r_valid_q;
    assign b_take = state_q == IDLE && !r_valid_q;
    always @(posedge clk)
        if (state_q == IDLE) begin
            v_slot_q   <= slot;
            v_depth_q  <= r_valid_q ? r_depth : b_depth;
            v_bend_q   <= r_valid_q && !r_total_q;
            v_mirror_q <= r_valid_q ? r_total_q || r_mirror : b_mirror;
            v_weight_q <= !r_valid_q ? b_weight : r_total_q ? r_total : r_weight;
            v_bent_q   <= r_bent;
            v_dir_q    <= r_dir_q;
        end
    wire             v_far;
    wire [`RT_ID_BITS-1:0] v_id;
    wire [3*W-1:0]   v_point;
    rt_slot_ram #(.WIDTH(IB+1), .SLOTS(SLOTS), .OLD(0)) u_hit (
        .clk(clk), .wr_en_i(hit_i[`RT_HIT_HIT]), .wr_addr_i(hit_i[`RT_HIT_SLOT]),
        .wr_data_i({hit_i[`RT_HIT_FAR], hit_i[`RT_HIT_ID]}),
        .rd_en_i(pick), .rd_addr_i(slot), .rd_data_o({v_far, v_id})
    );
    rt_slot_ram #(.WIDTH(3*W), .SLOTS(SLOTS), .OLD(0)) u_point (
        .clk(clk), .wr_en_i(surface_i[`RT_SURFACE_VALID]), .wr_addr_i(surface_i[`RT_SURFACE_SLOT]),
        .wr_data_i(behind),
        .rd_en_i(pick), .rd_addr_i(slot), .rd_data_o(v_point)
    );

    // ---- places: bit d of a slot's word tells that a ray of depth d waits ----
    wire [DEEPEST:1] kept, places;
    reg  [DEEPEST:1] places_d;
    rt_slot_file #(.WIDTH(DEEPEST), .SLOTS(SLOTS)) u_places (
        .clk(clk), .wr_en_i(state_q == ACT), .wr_addr_i(v_slot_q), .wr_data_i(places_d),
        .rd_addr_i(v_slot_q), .rd_data_o(kept)
    );
    assign places = v_depth_q == {DB{1'b0}} ? {DEEPEST{1'b0}} : kept; // a new pixel
    reg  [DB-1:0]    deepest;                        // that waits; 1 if none does
    wire [DB-1:0]    below   = v_depth_q + 1'b1;     // depth of what leaves this surface
    wire             act     = state_q == ACT;
    wire             push    = act && v_bend_q && v_mirror_q;
    wire             back    = act && !v_bend_q && !v_mirror_q && places != {DEEPEST{1'b0}};
    integer d;
    always @* begin
        deepest = 1;
        for (d = 2; d <= DEEPEST; d = d + 1)
            if (places[d]) deepest = d[DB-1:0];
        places_d = places;
        for (d = 1; d <= DEEPEST; d = d + 1) begin
            if (push && below == d[DB-1:0])   places_d[d] = 1'b1;
            if (back && deepest == d[DB-1:0]) places_d[d] = 1'b0;
        end
    end
    wire [GW-1:0]    v_ray = {v_bent_q, !v_far, v_id, v_point, v_dir_q};
    wire [GW-1:0]    w_ray;
    rt_slot_ram #(.WIDTH(GW), .SLOTS(SLOTS << DB), .OLD(0)) u_waiting (
        .clk(clk), .wr_en_i(push), .wr_addr_i({v_slot_q, below}), .wr_data_i(v_ray),
        .rd_en_i(back), .rd_addr_i({v_slot_q, deepest}), .rd_data_o(w_ray)
    );

    // ---- the ray that goes: at once, or out of its place ----
    reg  [GW-1:0]    g_q;
    reg  [DB-1:0]    g_depth_q;
    always @(posedge clk) begin
        case (state_q)
            IDLE: if (pick) state_q <= ACT;
            ACT:  state_q <= back ? POP : v_bend_q && !v_mirror_q ? GO : IDLE;
            POP:  state_q <= GO;
            default: if (out_ready_i) state_q <= IDLE;
        endcase
        if (state_q == ACT) begin
            g_q       <= v_ray;
            g_depth_q <= v_bend_q ? below : deepest;
        end else if (state_q == POP) begin
            g_q       <= w_ray;
        end
        if (rst) state_q <= IDLE;
    end
    generate
        if (PATHS != 0) begin : g_path
            wire [PATHS-1:0] v_path, v_bent, w_path;
            reg  [PATHS-1:0] g_path_q;
            rt_slot_ram #(.WIDTH(PATHS), .SLOTS(SLOTS), .OLD(0)) u_path (
                .clk(clk), .wr_en_i(path_valid_i), .wr_addr_i(path_slot_i),
                .wr_data_i(path_i[PATHS-1:0]),
                .rd_en_i(pick), .rd_addr_i(slot), .rd_data_o(v_path)
            );
            if (PATHS > W + 8) begin : g_bent    // out of a sphere: spread by less; into it: not
                localparam BB = `RT_PRIM_BEND_BITS;
                localparam [BB-1:0] THROUGH = `RT_BEND_THROUGH;
                wire [BB-1:0] bend = v_path[PATHS-1 -: BB];
                assign v_bent = {v_far && bend != {BB{1'b0}} ? bend + THROUGH : {BB{1'b0}},
                                 v_path[PATHS-BB-1:0]};
            end else begin : g_straight
                assign v_bent = v_path;
            end
            rt_slot_ram #(.WIDTH(PATHS), .SLOTS(SLOTS << DB), .OLD(0)) u_waiting_path (
                .clk(clk), .wr_en_i(push), .wr_addr_i({v_slot_q, below}), .wr_data_i(v_bent),
                .rd_en_i(back), .rd_addr_i({v_slot_q, deepest}), .rd_data_o(w_path)
            );
            always @(posedge clk)
                if (state_q == ACT)      g_path_q <= v_bent;
                else if (state_q == POP) g_path_q <= w_path;
            assign out_path_o = {{(W+18-PATHS){1'b0}}, g_path_q};
            if (PATHS < W + 18) begin : g_short
                wire unused = &{1'b0, path_i};
            end
        end else begin : g_no_path
            assign out_path_o = {(W+18){1'b0}};
            wire unused = &{1'b0, path_valid_i, path_slot_i, path_i};
        end
    endgenerate
    assign slot_o         = v_slot_q;
    assign mirror_valid_o = act && v_mirror_q;
    assign end_valid_o    = act && !v_mirror_q && !v_bend_q && places == {DEEPEST{1'b0}};
    assign out_valid_o    = state_q == GO;
    assign {out_skip_o, out_point_o, out_vec_o} = g_q[RW-1:0];
    assign next_valid_o   = mirror_valid_o || (out_valid_o && out_ready_i);
    assign next_weight_o  = act ? v_weight_q : g_q[RW +: WB];
    assign next_depth_o   = {{(4-DB){1'b0}}, act ? below : g_depth_q};
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_rays_that_follow /* verilator public_flat_rd */ =
        {state_q != IDLE && (r_valid_q || b_valid), pick, 5'd0,
         pick || (state_q != IDLE && !(state_q == GO && !out_ready_i))};
    wire unused = &{1'b0, ray_i, hit_i, material_i, surface_i, blend_i, in_depth, a_in,
                    b_in};
endmodule
`default_nettype wire
