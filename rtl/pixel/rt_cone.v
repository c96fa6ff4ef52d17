// rt_cone.v - which pixels may see one sphere, exactly, by forward differences
// SPDX-License-Identifier: Apache-2.0
//   record --load--> saved --fetch--> row below, moves down --enter--> pixel, moves right --> hit
//                      ^----------------------------save------------------'
// f(x,y) = f + x*fx + x(x-1)/2*fxx + y*fy + y(y-1)/2*fyy + x*y*fxy,  b(x,y) = b + x*bx + y*by
// hit = f > 0 && (b > 0 || inside): the discriminant, the projection of the sphere's centre.
// A place is (f, gx, gy, b) with gx = f(x+1,y) - f(x,y), gy = f(x,y+1) - f(x,y). Latency 1 cycle.
// Model: sph_is_background() in cmodel/pixel/background.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_cone #(
    parameter W  = 16,  // coordinate, bits
    parameter WD = 17   // direction component, bits
) (
    input  wire         clk,
    // record: its place is saved
    input  wire [3:0]   load_i,   // one-hot: which line of it
    input  wire [255:0] line_i,
    // moves; save and enter may come together, the others alone
    input  wire         fetch_i,  // row <= saved
    input  wire         enter_i,  // pixel <= row, row <= one down
    input  wire         right_i,  // pixel <= one to the right
    input  wire         save_i,   // saved <= pixel
    output wire         hit_o     // the pixel may see the sphere
);
    // |f| < 2^(2W+2WD+3) and |b| < 2^(W+WD+3) at every pixel of a frame; the differences may wrap
    localparam FB = 2*W + 2*WD + 4;
    localparam BB = W + WD + 4;
    localparam LB = 256;                           // bits of a line
    reg [FB-1:0] fxx_q, fxy_q, fyy_q;
    reg [BB-1:0] bx_q, by_q;
    reg          inside_q;
    always @(posedge clk) begin
        if (load_i[1]) fxx_q    <= line_i[`RT_CONE_FXX_LSB-LB +: FB];
        if (load_i[2]) fxy_q    <= line_i[`RT_CONE_FXY_LSB-2*LB +: FB];
        if (load_i[2]) fyy_q    <= line_i[`RT_CONE_FYY_LSB-2*LB +: FB];
        if (load_i[3]) bx_q     <= line_i[`RT_CONE_BX_LSB-3*LB +: BB];
        if (load_i[3]) by_q     <= line_i[`RT_CONE_BY_LSB-3*LB +: BB];
        if (load_i[3]) inside_q <= line_i[`RT_CONE_INSIDE_LSB-3*LB];
    end

    // ---- three places ----
    reg [FB-1:0] saved_f_q, saved_gx_q, saved_gy_q, row_f_q, row_gx_q, row_gy_q, f_q, gx_q, gy_q;
    reg [BB-1:0] saved_b_q, row_b_q, b_q;
    always @(posedge clk) begin
        if (load_i[0] || save_i) begin
            saved_f_q  <= save_i ? f_q  : line_i[`RT_CONE_F_LSB +: FB];
            saved_gx_q <= save_i ? gx_q : line_i[`RT_CONE_FX_LSB +: FB];
        end
        if (load_i[1] || save_i)
            saved_gy_q <= save_i ? gy_q : line_i[`RT_CONE_FY_LSB-LB +: FB];
        if (load_i[3] || save_i)
            saved_b_q  <= save_i ? b_q  : line_i[`RT_CONE_B_LSB-3*LB +: BB];
        if (fetch_i || enter_i) begin
            row_f_q  <= fetch_i ? saved_f_q  : row_f_q + row_gy_q;
            row_gx_q <= fetch_i ? saved_gx_q : row_gx_q + fxy_q;
            row_gy_q <= fetch_i ? saved_gy_q : row_gy_q + fyy_q;
            row_b_q  <= fetch_i ? saved_b_q  : row_b_q + by_q;
        end
        if (enter_i || right_i) begin
            f_q  <= enter_i ? row_f_q  : f_q + gx_q;
            gx_q <= enter_i ? row_gx_q : gx_q + fxx_q;
            gy_q <= enter_i ? row_gy_q : gy_q + fxy_q;
            b_q  <= enter_i ? row_b_q  : b_q + bx_q;
        end
    end

    // ---- above zero: no sign, and some bit ----
    wire f_above = !f_q[FB-1] && |f_q;
    wire b_above = !b_q[BB-1] && |b_q;
    assign hit_o = f_above && (b_above || inside_q);
endmodule
`default_nettype wire
