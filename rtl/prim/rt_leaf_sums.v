// rt_leaf_sums.v - b = oc.dir and k = rad^2 - oc.oc over four clocks
// SPDX-License-Identifier: Apache-2.0
// One piece (`RT_LEAF_PIECES): x, y, z, rad follow one another through two multipliers:
//   oc_x*dir_x oc_x^2 | oc_y*dir_y oc_y^2 | oc_z*dir_z oc_z^2 | rad^2, and 1 clock to add each
// Two pieces of 17 bits, h above l, of each: three multipliers for b and three for k, which serve
// the three components at once, rad in one of the clocks; products of equal weight are added:
//   b  l*l      | l*h      | h*l         | h*h     operands | products | 2 sums | accumulators
//   k  oc l*l   | oc 2*l*h | rad ll lh hh| oc h*h
// Model: b and k of sph_leaf_test() in cmodel/prim/sphere.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
`include "rt_fx.vh"
module rt_leaf_sums #(
    parameter W  = 24,                           // coordinate, bits
    parameter WD = 25                            // direction component, bits
) (
    input  wire             clk,
    input  wire             take_i,              // clock 0 of a leaf
    input  wire [3*W+2:0]   oc_i,                // 3 x s(W+1), clock 0
    input  wire [W-1:0]     rad_i,               // uW, clock 0
    input  wire [3*WD-1:0]  dir_i,               // 3 x sWD, clock 0
    output wire [W+WD+1:0]  b_o,                 // s(W+WD+2), clock 6, with two pieces 9
    output wire [2*W+2:0]   k_o                  // s(2W+3), the same clock
);
    localparam BW = W + WD + 2;
    localparam KW = 2*W + 3;
    genvar i;

    // ---- operands and the step that they are in: steps 0 to 3 in clocks 1 to 4 ----
    reg [1:0] step_q, s1_step_q;
    always @(posedge clk) begin
        step_q    <= take_i ? 2'd0 : step_q + 2'd1;
        s1_step_q <= step_q;
    end
    generate
        if (`RT_LEAF_PIECES(W, WD) == 1) begin : g_one
            reg signed [17:0] oc_x_q, oc_y_q, oc_z_q, rad_q, dir_x_q, dir_y_q, dir_z_q;
            always @(posedge clk)
                if (take_i) begin
                    oc_x_q  <= {{(17-W){oc_i[W]}}, oc_i[0 +: W+1]};
                    oc_y_q  <= {{(17-W){oc_i[2*W+1]}}, oc_i[W+1 +: W+1]};
                    oc_z_q  <= {{(17-W){oc_i[3*W+2]}}, oc_i[2*W+2 +: W+1]};
                    rad_q   <= {{(18-W){1'b0}}, rad_i};
                    dir_x_q <= {{(18-WD){dir_i[WD-1]}}, dir_i[0 +: WD]};
                    dir_y_q <= {{(18-WD){dir_i[2*WD-1]}}, dir_i[WD +: WD]};
                    dir_z_q <= {{(18-WD){dir_i[3*WD-1]}}, dir_i[2*WD +: WD]};
                end else begin
                    {oc_x_q, oc_y_q, oc_z_q} <= {oc_y_q, oc_z_q, rad_q};
                    {dir_x_q, dir_y_q} <= {dir_y_q, dir_z_q};
                end
            // ---- products, sums: b complete behind step 2, k behind step 3 ----
            reg signed [35:0] s1_b_q, s1_k_q;
            reg signed [37:0] b_q, k_q;
            wire signed [37:0] s1_b = {{2{s1_b_q[35]}}, s1_b_q}, s1_k = {{2{s1_k_q[35]}}, s1_k_q};
            always @(posedge clk) begin
                s1_b_q <= oc_x_q * dir_x_q;
                s1_k_q <= oc_x_q * oc_x_q;
                if (s1_step_q != 2'd3) b_q <= (s1_step_q == 2'd0 ? 38'sd0 : b_q) + s1_b;
                if (s1_step_q == 2'd3) k_q <= k_q + s1_k;
                else k_q <= (s1_step_q == 2'd0 ? 38'sd0 : k_q) - s1_k;
            end
            assign b_o = b_q[BW-1:0];
            assign k_o = k_q[KW-1:0];
            wire unused = &{1'b0, b_q, k_q};
        end else begin : g_two
            // ---- operands: pieces {h, l}, 18 bits signed each ----
            wire signed [35:0] b_p [0:2], k_p [0:2]; // products
            reg [W-1:0] rad_q;
            wire [34:0] rad = {{(35-W){1'b0}}, rad_q};
            wire signed [17:0] rad_l = {1'b0, rad[16:0]}, rad_h = rad[34:17];
            always @(posedge clk) if (take_i) rad_q <= rad_i;
            for (i = 0; i < 3; i = i + 1) begin : g_lane
                reg  [W:0]    oc_q;
                reg  [WD-1:0] dir_q;
                wire [34:0] oc  = {{(34-W){oc_q[W]}}, oc_q};
                wire [34:0] dir = {{(35-WD){dir_q[WD-1]}}, dir_q};
                wire signed [17:0] oc_l  = {1'b0, oc[16:0]},  oc_h  = oc[34:17];
                wire signed [17:0] dir_l = {1'b0, dir[16:0]}, dir_h = dir[34:17];
                wire signed [17:0] rad_a = i == 2 ? rad_h : rad_l;     // l*l, l*2h, h*h
                wire signed [17:0] rad_b = i == 0 ? rad_l : i == 1 ? rad_h <<< 1 : rad_h;
                reg  signed [17:0] s1_oc_q, s1_dir_q, s1_a_q, s1_b_q;
                reg  signed [35:0] s2_b_q, s2_k_q;
                always @(posedge clk) begin
                    if (take_i) begin
                        oc_q  <= oc_i[(W+1)*i +: W+1];
                        dir_q <= dir_i[WD*i +: WD];
                    end
                    s1_oc_q  <= step_q[1] ? oc_h : oc_l;
                    s1_dir_q <= step_q[0] ? dir_h : dir_l;
                    s1_a_q   <= step_q == 2'd3 ? oc_h : step_q == 2'd2 ? rad_a : oc_l;
                    s1_b_q   <= step_q == 2'd3 ? oc_h : step_q == 2'd2 ? rad_b
                                : step_q == 2'd1 ? oc_h <<< 1 : oc_l;
                    s2_b_q   <= s1_oc_q * s1_dir_q;
                    s2_k_q   <= s1_a_q * s1_b_q;
                end
                assign b_p[i] = s2_b_q;
                assign k_p[i] = s2_k_q;
            end

            // ---- stages 3 and 4: sums of a step; rad^2 from its three products ----
            reg [1:0] s2_step_q, s3_step_q, s4_step_q;
            reg signed [36:0] s3_b_xy_q, s3_k_xy_q;
            reg signed [35:0] s3_b_z_q, s3_k_z_q;
            reg signed [37:0] s4_b_q, s4_k_q;
            reg [2*W-1:0]     rad2_q;
            wire [71:0]       rad2 = {{2{1'b0}}, k_p[2], k_p[0][33:0]};
            wire [71:0]       rad2_all = {rad2[71:17] + {{19{1'b0}}, k_p[1]}, rad2[16:0]};
            always @(posedge clk) begin
                s2_step_q <= s1_step_q;
                s3_step_q <= s2_step_q;
                s4_step_q <= s3_step_q;
                s3_b_xy_q <= b_p[0] + b_p[1];
                s3_k_xy_q <= k_p[0] + k_p[1];
                s3_b_z_q  <= b_p[2];
                s3_k_z_q  <= k_p[2];
                s4_b_q    <= s3_b_xy_q + $signed({s3_b_z_q[35], s3_b_z_q});
                s4_k_q    <= s3_k_xy_q + $signed({s3_k_z_q[35], s3_k_z_q});
                if (s2_step_q == 2'd2) rad2_q <= rad2_all[2*W-1:0];
            end

            // ---- accumulators: 17 bits leave when the weight grows ----
            reg signed [39:0] b_q, k_q;
            reg [33:0]        b_low_q, k_low_q;
            wire signed [39:0] b_old = s4_step_q == 2'd2 ? b_q : b_q >>> 17, k_old = k_q >>> 17;
            wire signed [39:0] s4_b  = {{2{s4_b_q[37]}}, s4_b_q};
            wire signed [39:0] s4_k  = {{2{s4_k_q[37]}}, s4_k_q};
            always @(posedge clk) begin
                b_q <= (s4_step_q == 2'd0 ? 40'sd0 : b_old) + s4_b;
                if (s4_step_q != 2'd2) k_q <= (s4_step_q == 2'd0 ? 40'sd0 : k_old) + s4_k;
                if (s4_step_q[0]) begin
                    b_low_q <= {b_q[16:0], b_low_q[33:17]};
                    k_low_q <= {k_q[16:0], k_low_q[33:17]};
                end
            end
            wire [73:0] b = {b_q, b_low_q}, oc2 = {k_q, k_low_q};
            assign b_o = b[BW-1:0];
            assign k_o = {3'd0, rad2_q} - oc2[KW-1:0];
            wire unused = &{1'b0, b, oc2, rad2_all};
        end
    endgenerate
endmodule
`default_nettype wire
