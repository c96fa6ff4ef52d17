// rt_cosine.v - Lambert's cosine of every light, and whether it wants a shadow ray
// SPDX-License-Identifier: Apache-2.0
// The unit normal of each slot's surface is kept here. A light that the surface does not face, or
// every light where there are no shadow rays, is decided at once; the others wait for a shadow ray.
//   rt_setup: next light | its unit vector, the normal | rt_lambert, 5 clocks
// Model: sph_lambert() in cmodel/shade/colour.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_bundles.vh"
module rt_cosine #(
    parameter W      = 16,  // coordinate, bits
    parameter WD     = 17,  // direction component, bits
    parameter SHADOW = 1,   // 0: no shadow rays
    parameter SLOTS  = 32   // power of two
) (
    input  wire                     clk,
    input  wire                     rst,
    input  wire                     shadow_on_i,   // run-time switch of SHADOW
    // from rt_setup: unit normals and unit vectors to lights
    input  wire [`RT_RAY_BITS-1:0]  ray_i,
    //: {SLOT[SLOTW], H[6], Y[17], UNIT[54], INSIDE, SKIP[24], A[2*WD], DIR[3*WD], ORG[3*W], SHADOW,
    //: PRIMARY, LIGHT, NORMAL, VALID}
    input  wire                     next_light_i,  // a light comes in the next clock
    input  wire [$clog2(SLOTS)-1:0] next_slot_i,
    // a cosine
    output wire                     out_valid_o,   // one cycle
    output wire [$clog2(SLOTS)-1:0] out_slot_o,
    output wire [15:0]              out_cosine_o,  // u1.15; 0: faces away
    output wire                     shadow_go_o,   // token: its shadow ray starts
    output wire                     unshadowed_valid_o,  // instead: the light is decided
    output wire                     unshadowed_lit_o     // and it shines
);
    localparam SLOTW = $clog2(SLOTS);
    wire [53:0] normal;
    wire [53:0] light = ray_i[`RT_RAY_UNIT];
    wire        ready;
    rt_slot_ram #(.WIDTH(54), .SLOTS(SLOTS), .OLD(0)) u_normal (
        .clk(clk), .wr_en_i(ray_i[`RT_RAY_NORMAL]), .wr_addr_i(ray_i[`RT_RAY_SLOT]),
        .wr_data_i(light),
        .rd_en_i(next_light_i), .rd_addr_i(next_slot_i), .rd_data_o(normal)
    );
    rt_lambert #(.TAG(SLOTW)) u_lambert (
        .clk(clk), .rst(rst),
        .in_valid_i(ray_i[`RT_RAY_LIGHT]), .in_ready_o(ready), .in_tag_i(ray_i[`RT_RAY_SLOT]),
        .in_normal_x_i($signed(normal[`RT_UNIT_X])), .in_normal_y_i($signed(normal[`RT_UNIT_Y])),
        .in_normal_z_i($signed(normal[`RT_UNIT_Z])),
        .in_light_x_i($signed(light[`RT_UNIT_X])), .in_light_y_i($signed(light[`RT_UNIT_Y])),
        .in_light_z_i($signed(light[`RT_UNIT_Z])),
        .out_valid_o(out_valid_o), .out_tag_o(out_slot_o), .out_cosine_o(out_cosine_o)
    );
    wire dark  = out_cosine_o == 16'd0;
    wire trace = SHADOW != 0 && shadow_on_i && !dark;
    assign shadow_go_o  = out_valid_o && trace;
    assign unshadowed_valid_o = out_valid_o && !trace;
    assign unshadowed_lit_o   = !dark;
    wire unused = &{1'b0, shadow_on_i, ready, ray_i};
endmodule
`default_nettype wire
