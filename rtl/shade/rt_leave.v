// rt_leave.v - the ray that leaves a surface when it is blended: mirrored, refracted, or none
// SPDX-License-Identifier: Apache-2.0
// With REFRACT rt_rays decides which of a pixel's rays comes next. Without it a surface that
// mirrors or is to be probed sends its mirror ray off, and any other is the last of its pixel.
// Model: leaving_rays() in cmodel/engine/render_pixel.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_bundles.vh"
module rt_leave #(
    parameter W       = 16,  // coordinate, bits
    parameter WD      = 17,  // direction component, bits
    parameter PQ      = 17,  // quotient, significant bits
    parameter NG      = 2,   // guard bits of the hit point
    parameter PR      = 0,   // significant bits of the root, 0: all
    parameter MIRRORS = 1,   // 0: no mirror rays
    parameter REFRACT = 0,   // 1: refracted rays
    parameter DEEPEST = 5,   // rays one after another, at most
    parameter PATHS   = 0,   // bits that waiting rays keep of their path, 0, W+8 or W+18
    parameter SMOOTH  = 0,   // 1: interpolated normals
    parameter BOUNCE_INTERVAL = 10, // clocks a mirrored direction, 10 or 12
    parameter SLOTS   = 32   // power of two
) (
    input  wire                         clk,
    input  wire                         rst,
    // what rays need: from rt_setup, rt_slots, rt_surface, rt_texture
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
    input  wire [`RT_SIDE_BITS-1:0]     side_i,         // from rt_smooth
    //: {SLOT[SLOTW], NN[2*WD], VEC[3*WD], BENT, VALID}
    input  wire                         path_valid_i,
    input  wire [$clog2(SLOTS)-1:0]     path_slot_i,
    input  wire [W+17:0]                path_i,         // {bend, spread, path}: rt_texture_path
    // from rt_compose: a surface is blended; to it: what the next ray is worth
    input  wire [`RT_BLEND_BITS-1:0]    blend_i,
    //: {SLOT[SLOTW], W_TOTAL[17], W_REFRACT[17], W_MIRROR[17], DEPTH[4], REFRACT, MIRROR, PROBE,
    //: LAST, VALID}
    output wire                         next_valid_o,
    output wire [$clog2(SLOTS)-1:0]     next_slot_o,
    output wire [16:0]                  next_weight_o,  // u1.16
    output wire [3:0]                   next_depth_o,
    // to rt_slots: a pixel is complete
    output wire                         end_valid_o,
    output wire [$clog2(SLOTS)-1:0]     end_slot_o,
    // to rt_setup; where a refracted ray starts, to where that is kept
    output wire [`RT_VECTOR_BITS-1:0]   bounce_o,
    //: {SLOT[SLOTW], VEC[3*WD], VALID}
    output wire [`RT_BACK_BITS-1:0]     back_o,
    //: {SLOT[SLOTW], PATH[W+18], INSIDE, ID[24], POINT[3*W], VALID}
    input  wire                         back_ready_i,
    output wire                         reflected_o,    // a mirror ray goes
    output wire                         refracted_o     // a refracted ray goes
);
    localparam SLOTW = $clog2(SLOTS);
    wire             m_valid, m_out;          // a surface to mirror at; its mirrored direction
    wire [SLOTW-1:0] m_slot, m_out_slot;
    wire [3*WD-1:0]  m_vec;
    generate
        if (REFRACT != 0) begin : g_rays
            wire             go, go_ready, back;
            wire [3*WD-1:0]  vec;
            rt_rays #(.W(W), .WD(WD), .PQ(PQ), .NG(NG), .PR(PR), .DEEPEST(DEEPEST),
                      .PATHS(PATHS), .SLOTS(SLOTS)) u_rays (
                .clk(clk), .rst(rst), .ray_i(ray_i), .hit_i(hit_i), .material_i(material_i),
                .surface_i(surface_i), .path_valid_i(path_valid_i), .path_slot_i(path_slot_i),
                .path_i(path_i), .blend_i(blend_i),
                .mirror_valid_o(m_valid), .slot_o(m_slot), .end_valid_o(end_valid_o),
                .next_valid_o(next_valid_o), .next_weight_o(next_weight_o),
                .next_depth_o(next_depth_o),
                .out_valid_o(go), .out_ready_i(go_ready), .out_vec_o(vec),
                .out_point_o(back_o[`RT_BACK_POINT]),
                .out_skip_o({back_o[`RT_BACK_INSIDE], back_o[`RT_BACK_ID]}),
                .out_path_o(back_o[`RT_BACK_PATH])
            );
            assign go_ready = back_ready_i && !m_out;
            assign back     = go && go_ready;
            assign back_o[`RT_BACK_VALID] = back;
            assign back_o[`RT_BACK_SLOT]  = m_slot;
            assign bounce_o[`RT_VECTOR_VALID] = m_out || back;
            assign bounce_o[`RT_VECTOR_SLOT]  = m_out ? m_out_slot : m_slot;
            assign bounce_o[`RT_VECTOR_VEC]   = m_out ? m_vec : vec;
            assign refracted_o = back;
        end else begin : g_mirror
            wire mirror = blend_i[`RT_BLEND_MIRROR] || blend_i[`RT_BLEND_PROBE];
            assign m_valid       = blend_i[`RT_BLEND_VALID] && mirror;
            assign m_slot        = blend_i[`RT_BLEND_SLOT];
            assign end_valid_o   = blend_i[`RT_BLEND_VALID] && !mirror;
            assign next_valid_o  = m_valid;
            assign next_weight_o = blend_i[`RT_BLEND_W_MIRROR];
            assign next_depth_o  = blend_i[`RT_BLEND_DEPTH] + 4'd1;
            assign back_o        = {`RT_BACK_BITS{1'b0}};
            assign bounce_o[`RT_VECTOR_VALID] = m_out;
            assign bounce_o[`RT_VECTOR_SLOT]  = m_out_slot;
            assign bounce_o[`RT_VECTOR_VEC]   = m_vec;
            assign refracted_o   = 1'b0;
            wire unused = &{1'b0, hit_i, material_i, surface_i, path_valid_i, path_slot_i, path_i,
                            blend_i, back_ready_i};
        end
        if (MIRRORS != 0) begin : g_mirrors
            rt_mirrors #(.W(W), .WD(WD), .INTERVAL(BOUNCE_INTERVAL), .SMOOTH(SMOOTH),
                         .SLOTS(SLOTS)) u_mirrors (
                .clk(clk), .rst(rst), .ray_i(ray_i), .side_i(side_i),
                .in_valid_i(m_valid), .in_slot_i(m_slot),
                .out_valid_o(m_out), .out_slot_o(m_out_slot), .out_vec_o(m_vec)
            );
            assign reflected_o = m_valid;
        end else begin : g_no_mirror
            assign {m_out, m_out_slot, m_vec} = {(SLOTW+3*WD+1){1'b0}};
            assign reflected_o = 1'b0;
            wire unused = &{1'b0, clk, rst, ray_i, side_i, m_valid};
        end
    endgenerate
    assign next_slot_o = m_slot;
    assign end_slot_o  = m_slot;
endmodule
`default_nettype wire
