// rt_compose.v - composes each pixel's three frames from the surfaces that its rays find
// SPDX-License-Identifier: Apache-2.0
// Surfaces whose lights are summed, and the background behind mirrors, wait in queues. One at a
// time is read with its light and material, and blended into the frames of its slot: by rt_blends,
// or with REFRACT or SUM by rt_shares. Surfaces go before background.
// Model: path(), shade() in cmodel/engine/render_pixel.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_compose #(
    parameter W       = 16,  // coordinate, bits
    parameter WD      = 17,  // direction component, bits
    parameter REFLECT = 5,   // effects elaborated, see rt_core
    parameter LIGHTS  = 8,
    parameter INTERPENETRATE = 1,
    parameter REFRACT = 0,
    parameter SPECULAR = 0,
    parameter SUM     = 0,
    parameter LUTS    = 0,   // LUT cells that a block RAM is worth, rt_slot_ram
    parameter SLOTS   = 32   // power of two
) (
    input  wire                         clk,
    input  wire                         rst,
    input  wire [`RT_REGS_BITS-1:0]     regs_i,
    //: {BOX[6*(W+2)], N_LOOSE[24], LEAF_BASE[26], N_PRIMS[24], VISIT_LIMIT[24], MEM_LINES[26],
    //: SMOOTH_BASE[26], PRIM_BASE[26], ROOT[26], EYE[3*W], AMBIENT[48], BACKGROUND[24],
    //: N_LIGHTS[4], LEAST[9], MAX_DEPTH[4], TEX_FILTER[2], EFFECTS[EFFECT_BITS]}
    input  wire [`RT_HIT_BITS-1:0]      hit_i,          // from rt_slots
    //: {SLOT[SLOTW], KEY[W+WD+2], ID[24], FAR, PROBE, FIRST, LIT, SHADOW, MISS, HIT}
    // from rt_surface; from rt_texture, the part that a texture may change
    input  wire [`RT_MATERIAL_BITS-1:0] material_i,
    //: {SLOT[SLOTW], SMOOTH[24], BEND[6], TEX[26], INDEX[12], POWER[12], KS[8], KD[9], KA[9], SUM,
    //: KT[9], KR[9], RGB[24], VALID}
    input  wire [`RT_ALBEDO_BITS-1:0]   albedo_i,
    //: {SLOT[SLOTW], KR[9], RGB[24], VALID}
    // from rt_lighting: token, all lights of a surface are summed
    input  wire                         sum_valid_i,
    input  wire [$clog2(SLOTS)-1:0]     sum_slot_i,
    input  wire [50:0]                  sum_i,          // 3 x u2.15, red low
    input  wire [50:0]                  gloss_i,        // the same of highlights
    // from rt_leave: what the next ray of a slot is worth, with REFRACT or SUM
    input  wire                         next_valid_i,
    input  wire [$clog2(SLOTS)-1:0]     next_slot_i,
    input  wire [16:0]                  next_weight_i,  // u1.16
    input  wire [3:0]                   next_depth_i,
    // a surface or background is blended
    output wire [`RT_BLEND_BITS-1:0]    blend_o,
    //: {SLOT[SLOTW], W_TOTAL[17], W_REFRACT[17], W_MIRROR[17], DEPTH[4], REFRACT, MIRROR, PROBE,
    //: LAST, VALID}
    // frames of a slot, a clock after it
    input  wire                         read_i,
    input  wire [$clog2(SLOTS)-1:0]     read_slot_i,
    output wire [3*`RT_RGB_BITS-1:0]    colour_o        // L2, L1, Rendering
);
    localparam SLOTW = $clog2(SLOTS);
    localparam SHARES = REFRACT != 0 || SUM != 0 ? 1 : 0;   // blends by shares
    localparam FB = REFLECT != 0 || REFRACT != 0 ? 1 : 0;   // more than the first one is blended
    localparam PB = INTERPENETRATE != 0 ? 1 : 0;            // bits of a flag about probes
    wire [`RT_EFFECT_BITS-1:0] effects    = regs_i[`RT_REGS_EFFECTS];
    wire [`RT_RGB_BITS-1:0] background = regs_i[`RT_REGS_BACKGROUND];

    // ---- queues of surfaces and of background behind mirrors ----
    wire             q_hit, q_miss, q_hit_in, q_miss_in, blend_ready;
    wire [SLOTW-1:0] q_hit_slot, q_miss_slot;
    reg              e_valid_q, e_miss_q;
    reg [SLOTW-1:0]  e_slot_q;
    wire [50:0]      e_light;
    wire             e_load = !e_valid_q || blend_ready;
    wire [SLOTW-1:0] e_slot = q_hit ? q_hit_slot : q_miss_slot;
    wire             e_read = e_load && (q_hit || q_miss);
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_sums (
        .clk(clk), .rst(rst), .in_valid_i(sum_valid_i), .in_ready_o(q_hit_in),
        .in_data_i(sum_slot_i),
        .out_valid_o(q_hit), .out_ready_i(e_load), .out_data_o(q_hit_slot)
    );
    generate
        if (LIGHTS != 0) begin : g_light
            rt_slot_ram #(.WIDTH(51), .SLOTS(SLOTS), .OLD(0)) u_light (
                .clk(clk), .wr_en_i(sum_valid_i), .wr_addr_i(sum_slot_i), .wr_data_i(sum_i),
                .rd_en_i(e_read), .rd_addr_i(e_slot), .rd_data_o(e_light)
            );
        end else begin : g_ambient                   // the same for every surface
            assign e_light = sum_i;
        end
        if (FB != 0) begin : g_miss
            rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_misses (
                .clk(clk), .rst(rst), .in_valid_i(hit_i[`RT_HIT_MISS]), .in_ready_o(q_miss_in),
                .in_data_i(hit_i[`RT_HIT_SLOT]),
                .out_valid_o(q_miss), .out_ready_i(e_load && !q_hit), .out_data_o(q_miss_slot)
            );
        end else begin : g_no_miss
            assign {q_miss, q_miss_in, q_miss_slot} = {(SLOTW+2){1'b0}};
        end
    endgenerate
    always @(posedge clk) begin
        if (e_load) begin
            e_valid_q <= q_hit || q_miss;
            e_miss_q  <= FB != 0 && !q_hit;
            e_slot_q  <= e_slot;
        end
        if (rst) e_valid_q <= 1'b0;
    end

    // ---- which surface of its pixel it is; its material ----
    localparam CB = `RT_RGB_BITS;
    localparam MW = REFLECT != 0 ? CB + 9 : CB;      // without a mirror's share
    wire [CB+8:0] albedo = {albedo_i[`RT_ALBEDO_KR], albedo_i[`RT_ALBEDO_RGB]};
    wire         e_first, e_probe;                   // what the pixel sees itself; to be probed
    wire [MW-1:0] e_material;
    wire [8:0]   e_kr;
    generate
        if (FB + PB != 0) begin : g_surface
            wire [1:0]       flags = {hit_i[`RT_HIT_PROBE], hit_i[`RT_HIT_FIRST]};
            wire [FB+PB-1:0] e_flags;
            rt_slot_ram #(.WIDTH(FB+PB), .SLOTS(SLOTS), .OLD(0), .LUTS(LUTS)) u_surface (
                .clk(clk), .wr_en_i(hit_i[`RT_HIT_HIT] || hit_i[`RT_HIT_MISS]),
                .wr_addr_i(hit_i[`RT_HIT_SLOT]), .wr_data_i(flags[PB -: FB+PB]),
                .rd_en_i(e_read), .rd_addr_i(e_slot), .rd_data_o(e_flags)
            );
            assign e_first = FB == 0 || e_flags[0];
            assign e_probe = PB != 0 && e_flags[FB+PB-1];
            wire unused = &{1'b0, flags};
        end else begin : g_only
            assign {e_first, e_probe} = 2'b10;
        end
        if (REFLECT != 0) begin : g_kr
            assign e_kr = e_miss_q ? 9'd0 : e_material[MW-1:CB];
        end else begin : g_matt
            assign e_kr = 9'd0;
        end
    endgenerate
    rt_slot_ram #(.WIDTH(MW), .SLOTS(SLOTS), .OLD(0)) u_material (
        .clk(clk), .wr_en_i(albedo_i[`RT_ALBEDO_VALID]), .wr_addr_i(albedo_i[`RT_ALBEDO_SLOT]),
        .wr_data_i(albedo[MW-1:0]),
        .rd_en_i(e_read), .rd_addr_i(e_slot), .rd_data_o(e_material)
    );
    wire [CB-1:0] e_albedo = e_miss_q ? background : e_material[CB-1:0];

    // ---- blend ----
    generate
        if (SHARES != 0) begin : g_shares
            rt_shares #(.REFLECT(REFLECT), .REFRACT(REFRACT), .SPECULAR(SPECULAR), .SUM(SUM),
                        .MIRRORS(FB + PB != 0 ? 1 : 0), .PROBE(PB), .SLOTS(SLOTS)) u_shares (
                .clk(clk), .rst(rst), .effects_i(effects),
                .max_depth_i(regs_i[`RT_REGS_MAX_DEPTH]), .least_i(regs_i[`RT_REGS_LEAST]),
                .ambient_i(regs_i[`RT_REGS_AMBIENT]),
                .material_i(material_i),
                .gloss_valid_i(sum_valid_i), .gloss_slot_i(sum_slot_i), .gloss_i(gloss_i),
                .next_valid_i(next_valid_i), .next_slot_i(next_slot_i),
                .next_weight_i(next_weight_i), .next_depth_i(next_depth_i),
                .read_i(e_read), .read_slot_i(e_slot), .in_first_i(e_first),
                .in_valid_i(e_valid_q), .in_ready_o(blend_ready), .in_slot_i(e_slot_q),
                .in_light_i(e_light), .in_albedo_i(e_albedo), .in_background_i(e_miss_q),
                .in_kr_i(e_kr), .in_probe_i(e_probe && !e_miss_q), .blend_o(blend_o),
                .frames_read_i(read_i), .frames_slot_i(read_slot_i), .frames_o(colour_o)
            );
        end else begin : g_blends
            localparam DB = REFLECT > 1 ? $clog2(REFLECT + 1) : 1;  // bits of a depth
            wire [3:0] e_depth;
            wire [3:0] deepest = regs_i[`RT_REGS_MAX_DEPTH];        // at most REFLECT
            wire       e_last = e_kr == 9'd0 ||      // background has no share either
                                REFLECT == 0 || !effects[`RT_EFFECT_REFLECT] ||
                                e_depth[DB-1:0] == deepest[DB-1:0];
            wire       last;
            rt_blends #(.REFLECT(REFLECT), .PROBE(PB), .LUTS(LUTS),
                        .SLOTS(SLOTS)) u_blends (
                .clk(clk), .rst(rst), .least_i(regs_i[`RT_REGS_LEAST]),
                .read_i(e_read), .read_slot_i(e_slot), .in_first_i(e_first), .depth_o(e_depth),
                .in_valid_i(e_valid_q), .in_ready_o(blend_ready), .in_slot_i(e_slot_q),
                .in_light_i(e_light), .in_albedo_i(e_albedo), .in_background_i(e_miss_q),
                .in_kr_i(e_kr), .in_last_i(e_last), .in_probe_i(e_probe),
                .out_valid_o(blend_o[`RT_BLEND_VALID]), .out_slot_o(blend_o[`RT_BLEND_SLOT]),
                .out_last_o(last), .out_probe_o(blend_o[`RT_BLEND_PROBE]),
                .frames_read_i(read_i), .frames_slot_i(read_slot_i), .frames_o(colour_o)
            );
            assign blend_o[`RT_BLEND_LAST]      = last;
            assign blend_o[`RT_BLEND_MIRROR]    = !last;
            assign blend_o[`RT_BLEND_REFRACT]   = 1'b0;
            assign blend_o[`RT_BLEND_DEPTH]     = 4'd0;
            assign blend_o[`RT_BLEND_W_MIRROR]  = 17'd0;
            assign blend_o[`RT_BLEND_W_REFRACT] = 17'd0;
            assign blend_o[`RT_BLEND_W_TOTAL]   = 17'd0;
            wire unused = &{1'b0, material_i, gloss_i, next_valid_i, next_slot_i, next_weight_i,
                            next_depth_i, e_depth, deepest};
        end
    endgenerate
    wire unused = &{1'b0, regs_i, effects, hit_i, albedo, albedo_i, q_hit_in, q_miss_in};
endmodule
`default_nettype wire
