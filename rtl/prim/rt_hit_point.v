// rt_hit_point.v - primitives at a hit: the point, and a vector along the normal there
// SPDX-License-Identifier: Apache-2.0
//   sphere:        vector = g - ctr*2^NG    point = sat(round(g / 2^NG))
//   stored normal: vector = normal          point = sat(floor((g + up) / 2^NG)), in front of it:
//                  up = 2^NG, -1, 2^NG / 2 as the component of the turned vector is > 0, < 0, = 0
// The vector has any length and looks outwards or to the front; if the hit is far it is turned. A
// hit is taken with the part of its primitive record that is no material; then x, y, z of the
// guarded point g come, one a clock, and x, y, z of point and vector leave, one a clock. With
// `RT_PRIM_POINT_LATER they may come later than g: rt_hit takes no other hit before they have left.
// Today they come at once.
// Model: sph_surface_nearest(), sph_surface_outwards() in cmodel/shade/surface.c,
//        normal() in cmodel/prim/sphere.c, sph_stored_normal() in cmodel/prim/kinds.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_prim.vh"
module rt_hit_point #(
    parameter W   = 16,    // coordinate, bits
    parameter NG  = 2,     // guard bits of a point
    parameter FARS = 1,    // 0: no hit comes from inside or behind
    parameter FACETS = 0   // 1: stored normals too
) (
    input  wire                       clk,
    input  wire [`RT_EFFECT_BITS-1:0] effects_i, // register EFFECTS
    // from rt_hit: a hit
    input  wire                       take_i,
    input  wire [`RT_LEAF_STRIDE-1:0] shape_i,   // low half of the primitive record
    input  wire                       far_i,          // hit from inside, or from behind
    // its point: x, y, z
    input  wire                       in_valid_i,
    input  wire signed [W+NG-1:0]     in_guarded_i,
    // to rt_hit: x, y, z
    output wire                       out_valid_o,
    output wire signed [W-1:0]        out_point_o,
    output wire        [NG+1:0]       out_lift_o,     // point*2^NG - g, s(NG+2)
    output wire                       out_limited_o,  // the point was limited to the grid
    output wire                       out_flat_o,     // it lies in front of a flat primitive
    output wire signed [`RT_PRIM_VECTOR_BITS(W, NG, FACETS)-1:0] out_vector_o
);
    localparam GW = W + NG;
    localparam VW = `RT_PRIM_VECTOR_BITS(W, NG, FACETS);
    localparam CW = FACETS != 0 ? `RT_LEAF_CTR_X_BITS : W;
    localparam [GW:0] UNIT = {{GW{1'b0}}, 1'b1} << NG;
    localparam [GW:0] HALF = UNIT >> 1;          // NG 0: nothing to round

    // ---- shape: the component that is next stands in x ----
    reg  signed [CW-1:0] ctr_x_q, ctr_y_q, ctr_z_q;   // centre, or stored normal
    reg                  far_q, stored_q;
    always @(posedge clk)
        if (take_i) begin
            ctr_x_q  <= shape_i[`RT_LEAF_CTR_X_LSB +: CW];
            ctr_y_q  <= shape_i[`RT_LEAF_CTR_Y_LSB +: CW];
            ctr_z_q  <= shape_i[`RT_LEAF_CTR_Z_LSB +: CW];
            far_q    <= FARS != 0 && far_i;
            stored_q <= FACETS != 0 && effects_i[`RT_EFFECT_FACETS] &&
                        shape_i[`RT_PRIM_KIND_LSB +: `RT_PRIM_KIND_BITS] != `RT_SPHERE;
        end else if (in_valid_i) begin
            {ctr_x_q, ctr_y_q} <= {ctr_y_q, ctr_z_q};
        end

    // ---- point: the guarded one, rounded half up, or to the next along the normal ----
    wire        down = ctr_x_q[CW-1] != far_q;   // the turned normal looks down
    wire        up_any = stored_q && ctr_x_q != {CW{1'b0}};
    wire [GW:0] up   = !up_any ? HALF : down ? {(GW+1){1'b1}} : UNIT;
    wire signed [GW:0] sum = $signed({in_guarded_i[GW-1], in_guarded_i}) + $signed(up);
    assign out_limited_o = sum[GW] != sum[GW-1];
    assign out_point_o = out_limited_o ? $signed({sum[GW], {(W-1){!sum[GW]}}})
                                       : $signed(sum[GW-1:NG]);
    wire [GW:0] whole = {{(NG+1){out_point_o[W-1]}}, out_point_o} << NG;
    assign out_lift_o = whole[NG+1:0] - in_guarded_i[NG+1:0];   // at most 2^NG, either way

    // ---- vector: front - back, or what turns it, back - front ----
    wire signed [VW-1:0] guarded = {{(VW-GW+1){in_guarded_i[GW-1]}}, in_guarded_i[GW-2:0]};
    wire signed [VW-1:0] centre  = $signed({{(VW-W+1){ctr_x_q[W-1]}}, ctr_x_q[W-2:0]}) <<< NG;
    wire signed [VW-1:0] front, back;
    generate
        if (FACETS != 0) begin : g_stored
            assign front = stored_q ? $signed({{(VW-CW+1){ctr_x_q[CW-1]}}, ctr_x_q[CW-2:0]})
                           : guarded;
            assign back  = stored_q ? $signed({VW{1'b0}}) : centre;
        end else begin : g_centre
            assign front = guarded;
            assign back  = centre;
            wire unused = stored_q;
        end
    endgenerate
    assign out_vector_o = (far_q ? back : front) - (far_q ? front : back);
    assign out_valid_o  = in_valid_i;
    assign out_flat_o   = stored_q;
    wire unused = &{1'b0, effects_i, shape_i, sum, whole};
endmodule
`default_nettype wire
