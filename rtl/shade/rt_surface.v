// rt_surface.v - from a ray's first hit to the point and normal of its surface
// SPDX-License-Identifier: Apache-2.0
// t = key / a in one of QUOTIENTS iterative dividers, then the primitive record through the leaf
// cache, then org + t*dir and the normal. Tokens wait in queues between the three.
// Where no light, no mirror and no texture asks for the point (points_on_i low; POINTS 0: never
// built), a hit goes to its record at once and leaves as a bare surface when that is there.
// Model: sph_quotient() in cmodel/math/quotient.c, sph_surface_at() in cmodel/shade/surface.c
`default_nettype none
`include "rt_layout.vh"
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
    parameter LOOKS   = 0,     // 1: the rest of the material, for refraction and sum
    parameter SLOTS = 32,      // power of two
    parameter SLOTW = 5,       // log2 of SLOTS
    parameter QUOTIENTS = 3,   // dividers
    parameter QUOTIENT_STEP = 2 // quotient bits a clock
) (
    input  wire              clk,
    input  wire              rst,
    input  wire [25:0]       prim_base_i,    // register
    input  wire [3*W-1:0]    eye_i,          // register
    input  wire              points_on_i,    // run-time switches of POINTS, FACETS
    input  wire              facets_on_i,
    // from rt_setup: primary and reflected rays
    input  wire              ray_valid_i,
    input  wire [SLOTW-1:0]  ray_slot_i,
    input  wire [3*W-1:0]    ray_org_i,
    input  wire [3*WD-1:0]   ray_dir_i,
    input  wire [2*WD-1:0]   ray_a_i,
    // a token and its ray's first hit
    input  wire              in_valid_i,
    input  wire [SLOTW-1:0]  in_slot_i,
    input  wire              in_far_i,
    input  wire [23:0]       in_id_i,
    input  wire [W+WD+1:0]   in_key_i,
    // to and from rt_leaf_unit: primitive records
    output wire              prim_valid_o,
    input  wire              prim_ready_i,
    output wire [SLOTW-1:0]  prim_slot_o,
    output wire [25:0]       prim_line_o,
    input  wire              prim_valid_i,
    output wire              prim_ready_o,
    input  wire [SLOTW-1:0]  prim_slot_i,
    input  wire [255:0]      prim_data_i,
    // the material, as the record arrives
    output wire              material_valid_o,
    output wire [SLOTW-1:0]  material_slot_o,
    output wire [32:0]       material_o,     // {kr u1.8, 0xBBGGRR}
    output wire [25:0]       material_tex_o, // line of the mapping record, 0: none
    output wire [59:0]       material_look_o, // {index, power, ks, kd, ka, sum, kt}; with LOOKS
    // the surface, without a point
    output wire              bare_valid_o,
    output wire [SLOTW-1:0]  bare_slot_o,
    // the surface
    output wire              out_valid_o,
    output wire [SLOTW-1:0]  out_slot_o,
    output wire [3*W-1:0]    out_point_o,
    output wire [3*(W+NG)-1:0] out_guarded_o, // before it is rounded, s(W+NG); with TEXTURE
    output wire [3*WD-1:0]   out_normal_o,
    // counters
    output wire              quotient_o,
    output wire              saturated_o
);
    localparam KW = W + WD + 2;
    localparam FARS = INSIDE != 0 || FACETS != 0 ? 1 : 0;  // normals that are turned

    localparam FB = SLOTW + 26;               // {slot, line of the record}
    wire on = POINTS != 0 && points_on_i;
    wire [25:0]      in_line = prim_base_i + {2'b0, in_id_i};

    // ---- t; a hit that needs none goes past ----
    localparam TW = PQ + 8;                   // {mant, exp}
    wire             t_valid;
    wire [TW-1:0]    t;
    wire [FB-1:0]    t_fetch;
    generate
        if (POINTS != 0) begin : g_quotient
            wire             h_valid, h_in, h_taken, divider;
            wire [SLOTW-1:0] h_slot;
            wire [KW+25:0]   h;               // {line, key}
            wire [2*WD-1:0]  h_a;
            reg              h_read_q;        // h and h_a belong to the head
            rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_hits (
                .clk(clk), .rst(rst), .in_valid_i(in_valid_i && on), .in_ready_o(h_in),
                .in_data_i(in_slot_i),
                .out_valid_o(h_valid), .out_ready_i(h_taken), .out_data_o(h_slot)
            );
            rt_slot_ram #(.WIDTH(KW+26), .SLOTS(SLOTS), .OLD(0)) u_hit_data (
                .clk(clk), .wr_en_i(in_valid_i), .wr_addr_i(in_slot_i),
                .wr_data_i({in_line, in_key_i}),
                .rd_en_i(h_valid), .rd_addr_i(h_slot), .rd_data_o(h)
            );
            rt_slot_ram #(.WIDTH(2*WD), .SLOTS(SLOTS), .OLD(0)) u_a (
                .clk(clk), .wr_en_i(ray_valid_i), .wr_addr_i(ray_slot_i), .wr_data_i(ray_a_i),
                .rd_en_i(h_valid), .rd_addr_i(h_slot), .rd_data_o(h_a)
            );
            always @(posedge clk) begin
                h_read_q <= h_valid && !h_taken;
                if (rst) h_read_q <= 1'b0;
            end
            assign h_taken    = h_read_q && divider;
            assign quotient_o = h_taken;
            rt_quotient_pool #(.KW(KW), .AW(2*WD), .PQ(PQ), .UNITS(QUOTIENTS),
                               .STEP(QUOTIENT_STEP), .TAG(FB)) u_pool (
                .clk(clk), .rst(rst), .in_valid_i(h_read_q), .in_ready_o(divider),
                .in_tag_i({h_slot, h[KW +: 26]}), .in_key_i(h[KW-1:0]), .in_a_i(h_a),
                .out_valid_o(t_valid), .out_ready_i(1'b1), .out_tag_o(t_fetch),
                .out_mant_o(t[TW-1:8]), .out_exp_o(t[7:0])
            );
            wire unused = h_in;
        end else begin : g_none
            assign {t_valid, t, t_fetch, quotient_o} = {(TW+FB+2){1'b0}};
        end
    endgenerate

    // ---- fetch the primitive record ----
    wire p_in;
    rt_fifo #(.WIDTH(FB), .DEPTH(SLOTS)) u_fetches (
        .clk(clk), .rst(rst), .in_valid_i(on ? t_valid : in_valid_i), .in_ready_o(p_in),
        .in_data_i(on ? t_fetch : {in_slot_i, in_line}),
        .out_valid_o(prim_valid_o), .out_ready_i(prim_ready_i),
        .out_data_o({prim_slot_o, prim_line_o})
    );
    wire             hit_ready;               // whatever waits for the record's centre can have it
    wire             r_load = prim_valid_i && prim_ready_o;
    assign prim_ready_o     = !on || hit_ready;
    assign material_valid_o = r_load;
    assign material_slot_o  = prim_slot_i;
    assign material_o = {prim_data_i[`RT_PRIM_KR_LSB +: 9], prim_data_i[`RT_PRIM_RED_LSB +: 24]};
    assign material_look_o = LOOKS == 0 ? 60'd0 :
        {prim_data_i[`RT_PRIM_INDEX_LSB +: 12], prim_data_i[`RT_PRIM_POWER_LSB +: 12],
         prim_data_i[`RT_PRIM_KS_LSB +: 8], prim_data_i[`RT_PRIM_KD_LSB +: 9],
         prim_data_i[`RT_PRIM_KA_LSB +: 9], prim_data_i[`RT_PRIM_SUM_LSB],
         prim_data_i[`RT_PRIM_KT_LSB +: 9]};
    assign material_tex_o = TEXTURE != 0 ? prim_data_i[`RT_PRIM_TEX_LSB +: 26] : 26'd0;

    // ---- a bare surface: one cycle after its material ----
    reg              bare_valid_q;
    reg [SLOTW-1:0]  bare_slot_q;
    always @(posedge clk) begin
        bare_valid_q <= r_load && !on;
        bare_slot_q  <= prim_slot_i;
        if (rst) bare_valid_q <= 1'b0;
    end
    assign bare_valid_o = bare_valid_q;
    assign bare_slot_o  = bare_slot_q;

    // ---- record, ray and t side by side, then point and normal ----
    generate
        if (POINTS != 0) begin : g_point
            wire [TW-1:0]    r_t;
            wire [3*W-1:0]   r_org;
            wire [3*WD-1:0]  r_dir;
            wire             r_far, ready, saturated;
            reg              r_valid_q;
            reg [SLOTW-1:0]  r_slot_q;
            reg [71:0]       r_ctr_q;         // {z, y, x} s24
            reg              r_facet_q;
            rt_slot_ram #(.WIDTH(TW), .SLOTS(SLOTS), .OLD(0)) u_t (
                .clk(clk), .wr_en_i(t_valid), .wr_addr_i(t_fetch[26 +: SLOTW]), .wr_data_i(t),
                .rd_en_i(r_load), .rd_addr_i(prim_slot_i), .rd_data_o(r_t)
            );
            if (BOUNCES != 0) begin : g_org
                rt_slot_ram #(.WIDTH(3*W+3*WD), .SLOTS(SLOTS), .OLD(0)) u_ray (
                    .clk(clk), .wr_en_i(ray_valid_i), .wr_addr_i(ray_slot_i),
                    .wr_data_i({ray_dir_i, ray_org_i}),
                    .rd_en_i(r_load), .rd_addr_i(prim_slot_i), .rd_data_o({r_dir, r_org})
                );
            end else begin : g_eye
                rt_slot_ram #(.WIDTH(3*WD), .SLOTS(SLOTS), .OLD(0)) u_ray (
                    .clk(clk), .wr_en_i(ray_valid_i), .wr_addr_i(ray_slot_i),
                    .wr_data_i(ray_dir_i),
                    .rd_en_i(r_load), .rd_addr_i(prim_slot_i), .rd_data_o(r_dir)
                );
                assign r_org = eye_i;
            end
            if (FARS != 0) begin : g_far
                rt_slot_ram #(.WIDTH(1), .SLOTS(SLOTS), .OLD(0)) u_far (
                    .clk(clk), .wr_en_i(in_valid_i), .wr_addr_i(in_slot_i), .wr_data_i(in_far_i),
                    .rd_en_i(r_load), .rd_addr_i(prim_slot_i), .rd_data_o(r_far)
                );
            end else begin : g_near
                assign r_far = 1'b0;
            end
            assign hit_ready = !r_valid_q || ready;
            always @(posedge clk) begin
                if (r_load) begin
                    r_slot_q <= prim_slot_i;
                    r_ctr_q  <= prim_data_i[71:0];
                    r_facet_q <= FACETS != 0 && facets_on_i && prim_data_i[`RT_PRIM_FACET_LSB];
                end
                if (hit_ready) r_valid_q <= prim_valid_i && on;
                if (rst) r_valid_q <= 1'b0;
            end
            rt_hit #(.W(W), .WD(WD), .PQ(PQ), .NG(NG), .INSIDE(FARS), .FACETS(FACETS),
                     .TEXTURE(TEXTURE), .TAG(SLOTW)) u_hit (
                .clk(clk), .rst(rst), .in_valid_i(r_valid_q), .in_ready_o(ready),
                .in_tag_i(r_slot_q), .in_mant_i(r_t[TW-1:8]), .in_exp_i($signed(r_t[7:0])),
                .in_org_x_i($signed(r_org[0 +: W])), .in_org_y_i($signed(r_org[W +: W])),
                .in_org_z_i($signed(r_org[2*W +: W])),
                .in_dir_x_i($signed(r_dir[0 +: WD])), .in_dir_y_i($signed(r_dir[WD +: WD])),
                .in_dir_z_i($signed(r_dir[2*WD +: WD])),
                .in_ctr_x_i($signed(r_ctr_q[23:0])), .in_ctr_y_i($signed(r_ctr_q[47:24])),
                .in_ctr_z_i($signed(r_ctr_q[71:48])), .in_facet_i(r_facet_q), .in_far_i(r_far),
                .out_valid_o(out_valid_o), .out_tag_o(out_slot_o),
                .out_point_x_o(out_point_o[0 +: W]), .out_point_y_o(out_point_o[W +: W]),
                .out_point_z_o(out_point_o[2*W +: W]), .out_guarded_o(out_guarded_o),
                .out_normal_x_o(out_normal_o[0 +: WD]), .out_normal_y_o(out_normal_o[WD +: WD]),
                .out_normal_z_o(out_normal_o[2*WD +: WD]), .out_saturated_o(saturated)
            );
            assign saturated_o = out_valid_o && saturated;
        end else begin : g_bare
            assign hit_ready = 1'b1;
            assign {out_valid_o, saturated_o} = 2'b00;
            assign out_slot_o   = {SLOTW{1'b0}};
            assign out_point_o  = {3*W{1'b0}};
            assign out_guarded_o = {3*(W+NG){1'b0}};
            assign out_normal_o = {3*WD{1'b0}};
        end
    endgenerate
    wire unused = &{1'b0, facets_on_i, p_in, prim_data_i, t, t_fetch, hit_ready, eye_i, ray_valid_i,
                    ray_slot_i, ray_org_i, ray_dir_i, ray_a_i, in_far_i, in_key_i};
endmodule
`default_nettype wire
