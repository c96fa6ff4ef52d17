// rt_shares.v - blends by shares: what of a pixel each of its rays decides, and its three frames
// SPDX-License-Identifier: Apache-2.0
// It takes the place of rt_blends in a core that refracts or has materials with sum. The ray of a
// slot has a weight and a depth; frames are sums, so that rays may come in any order.
// read_i reads what belongs to the surface that enters one cycle later.
// Model: path(), shade() in cmodel/engine/render_pixel.c, sph_shares_add() in cmodel/shade/colour.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_shares #(
    parameter REFLECT  = 5,   // effects elaborated, see rt_core
    parameter REFRACT  = 1,
    parameter SPECULAR = 1,
    parameter SUM      = 1,
    parameter MIRRORS  = 1,   // 0: no mirror rays
    parameter PROBE    = 0,   // 1: some surfaces are probed (INTERPENETRATE)
    parameter SLOTS    = 32   // power of two
) (
    input  wire                         clk,
    input  wire                         rst,
    // registers
    input  wire [`RT_EFFECT_BITS-1:0]   effects_i,
    input  wire [3:0]                   max_depth_i,     // at most what the core was built for
    input  wire [8:0]                   least_i,         // u1.8, LEAST_WEIGHT
    input  wire [47:0]                  ambient_i,       // 3 x u1.15, red low
    // the material; light, as highlights; what the next ray of a slot is worth
    input  wire [`RT_MATERIAL_BITS-1:0] material_i,
    //: {SLOT[SLOTW], SMOOTH[24], BEND[6], TEX[26], INDEX[12], POWER[12], KS[8], KD[9], KA[9], SUM,
    //: KT[9], KR[9], RGB[24], VALID}
    input  wire                         gloss_valid_i,
    input  wire [$clog2(SLOTS)-1:0]     gloss_slot_i,
    input  wire [50:0]                  gloss_i,         // 3 x u2.15
    input  wire                         next_valid_i,
    input  wire [$clog2(SLOTS)-1:0]     next_slot_i,
    input  wire [16:0]                  next_weight_i,   // u1.16
    input  wire [3:0]                   next_depth_i,
    // a surface, or the background behind a ray
    input  wire                         read_i,
    input  wire [$clog2(SLOTS)-1:0]     read_slot_i,
    input  wire                         in_first_i,      // what the pixel sees itself
    input  wire                         in_valid_i,      // one cycle after read_i
    output wire                         in_ready_o,
    input  wire [$clog2(SLOTS)-1:0]     in_slot_i,
    input  wire [50:0]                  in_light_i,      // 3 x u2.15, red low
    input  wire [`RT_RGB_BITS-1:0]      in_albedo_i,     // 0xBBGGRR
    input  wire                         in_background_i, // nothing hit: albedo is the colour
    input  wire [8:0]                   in_kr_i,         // u1.8, 0..256, share of the reflection
    input  wire                         in_probe_i,      // to be probed
    // it is blended
    output wire [`RT_BLEND_BITS-1:0]    blend_o,
    //: {SLOT[SLOTW], W_TOTAL[17], W_REFRACT[17], W_MIRROR[17], DEPTH[4], REFRACT, MIRROR, PROBE,
    //: LAST, VALID}
    // frames of a slot, one cycle after
    input  wire                         frames_read_i,
    input  wire [$clog2(SLOTS)-1:0]     frames_slot_i,
    output wire [3*`RT_RGB_BITS-1:0]    frames_o         // L2, L1, Rendering
);
    localparam SLOTW = $clog2(SLOTS);
    localparam DB  = `RT_DEEPEST > 3 ? $clog2(`RT_DEEPEST + 1) : 2;  // bits of a depth
    localparam TAG = SLOTW + DB + 3;          // {refract, mirror, probe, depth, slot}

    // ---- the ray that found it, the pixel so far, the material ----
    wire             out_valid;
    wire [SLOTW-1:0] out_slot;
    wire [143:0]     frames, sums;
    wire [DB-1:0]    e_depth;                 // of the ray
    wire [16:0]      e_weight;
    wire [8:0]       e_kt, e_ka, e_kd;
    wire [7:0]       e_ks;
    wire             e_sum;
    wire [50:0]      gloss;
    rt_slot_ram #(.WIDTH(144), .SLOTS(SLOTS), .OLD(0)) u_sums (
        .clk(clk), .wr_en_i(out_valid), .wr_addr_i(out_slot), .wr_data_i(sums),
        .rd_en_i(read_i), .rd_addr_i(read_slot_i), .rd_data_o(frames)
    );
    rt_slot_ram #(.WIDTH(17 + DB), .SLOTS(SLOTS), .OLD(0)) u_state (
        .clk(clk), .wr_en_i(next_valid_i), .wr_addr_i(next_slot_i),
        .wr_data_i({next_depth_i[DB-1:0], next_weight_i}),
        .rd_en_i(read_i), .rd_addr_i(read_slot_i), .rd_data_o({e_depth, e_weight})
    );
    rt_slot_ram #(.WIDTH(36), .SLOTS(SLOTS), .OLD(0)) u_material (
        .clk(clk), .wr_en_i(material_i[`RT_MATERIAL_VALID]),
        .wr_addr_i(material_i[`RT_MATERIAL_SLOT]),
        .wr_data_i({material_i[`RT_MATERIAL_KS], material_i[`RT_MATERIAL_KD],
                    material_i[`RT_MATERIAL_KA], material_i[`RT_MATERIAL_SUM],
                    material_i[`RT_MATERIAL_KT]}),
        .rd_en_i(read_i), .rd_addr_i(read_slot_i), .rd_data_o({e_ks, e_kd, e_ka, e_sum, e_kt})
    );
    generate
        if (SPECULAR != 0) begin : g_gloss
            rt_slot_ram #(.WIDTH(51), .SLOTS(SLOTS), .OLD(0)) u_gloss (
                .clk(clk), .wr_en_i(gloss_valid_i), .wr_addr_i(gloss_slot_i), .wr_data_i(gloss_i),
                .rd_en_i(read_i), .rd_addr_i(read_slot_i), .rd_data_o(gloss)
            );
        end else begin : g_matt
            assign gloss = 51'd0;
            wire unused = &{1'b0, gloss_valid_i, gloss_slot_i, gloss_i};
        end
    endgenerate

    // ---- shares ----
    wire [DB-1:0]    depth  = in_first_i ? {DB{1'b0}} : e_depth;
    wire [3:0]       deep   = {{(4-DB){1'b0}}, depth};
    wire [16:0]      weight = in_first_i ? 17'h10000 : e_weight;
    wire             rays   = !in_background_i && depth != max_depth_i[DB-1:0];
    wire [8:0]       kr     = REFLECT != 0 && effects_i[`RT_EFFECT_REFLECT] && rays ? in_kr_i
                                                                                  : 9'd0;
    wire [8:0]       kt     = REFRACT != 0 && effects_i[`RT_EFFECT_REFRACT] && rays ? e_kt
                                                                                  : 9'd0;
    wire [TAG-1:0]   tag;
    wire             light_mirror, light_refract;        // too light to be followed
    rt_share #(.SUM(SUM), .SPECULAR(SPECULAR), .TAG(TAG)) u_share (
        .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .in_ready_o(in_ready_o),
        .in_tag_i({kt != 9'd0, kr != 9'd0, in_probe_i, depth, in_slot_i}),
        .in_background_i(in_background_i), .in_ambient_i(ambient_i), .in_lights_i(in_light_i),
        .in_gloss_i(gloss), .in_albedo_i(in_albedo_i),
        .in_sum_i(effects_i[`RT_EFFECT_SUM] && e_sum), .in_ka_i(e_ka), .in_kd_i(e_kd),
        .in_ks_i(effects_i[`RT_EFFECT_SPECULAR] ? e_ks : 8'd0),
        .in_kr_i(kr), .in_kt_i(kt), .in_weight_i(weight), .in_least_i(least_i),
        .in_depth_i(deep[3:1] != 3'd0 ? 2'd2 : deep[1:0]),
        .in_frames_i(in_first_i ? 144'd0 : frames),
        .out_valid_o(out_valid), .out_tag_o(tag), .out_frames_o(sums),
        .out_mirror_o(blend_o[`RT_BLEND_W_MIRROR]), .out_refract_o(blend_o[`RT_BLEND_W_REFRACT]),
        .out_total_o(blend_o[`RT_BLEND_W_TOTAL]),
        .out_light_mirror_o(light_mirror), .out_light_refract_o(light_refract)
    );
    wire             refract = REFRACT != 0 && tag[TAG-1] && !light_refract;
    wire             mirror  = MIRRORS != 0 && tag[TAG-2] && !light_mirror;
    assign out_slot = tag[SLOTW-1:0];
    assign blend_o[`RT_BLEND_VALID]   = out_valid;
    assign blend_o[`RT_BLEND_SLOT]    = out_slot;
    assign blend_o[`RT_BLEND_LAST]    = !mirror && !refract;
    assign blend_o[`RT_BLEND_PROBE]   = PROBE != 0 && tag[TAG-3];
    assign blend_o[`RT_BLEND_MIRROR]  = mirror;
    assign blend_o[`RT_BLEND_REFRACT] = refract;
    assign blend_o[`RT_BLEND_DEPTH]   = {{(4-DB){1'b0}}, tag[SLOTW +: DB]};

    // ---- bytes of the frames: half up, limited ----
    wire [71:0]      bytes;
    genvar i;
    generate
        for (i = 0; i < 9; i = i + 1) begin : g_byte
            wire [8:0] up = {1'b0, sums[16*i+8 +: 8]} + {8'd0, sums[16*i+7]};
            assign bytes[8*i +: 8] = up[8] ? 8'd255 : up[7:0];
        end
    endgenerate
    rt_slot_ram #(.WIDTH(72), .SLOTS(SLOTS), .OLD(0)) u_frames (
        .clk(clk), .wr_en_i(out_valid), .wr_addr_i(out_slot), .wr_data_i(bytes),
        .rd_en_i(frames_read_i), .rd_addr_i(frames_slot_i), .rd_data_o(frames_o)
    );
    wire unused = &{1'b0, effects_i, material_i, in_kr_i, tag, max_depth_i, next_depth_i};
endmodule
`default_nettype wire
