// rt_leaf_four.v - b, k, disc and the signs of rt_leaf, a leaf every four clocks
// SPDX-License-Identifier: Apache-2.0
//   b = oc.dir    k = rad^2 - oc.oc    disc = k*a + b*b
// Operands stay for four clocks and go through few multipliers in pieces of 17 bits:
//   1-4 oc, dir, rad | rt_leaf_sums | b, k: T_B to T_B+3, their signs from T_B+2 on
//                                   | rt_leaf_disc | disc
// Model: sph_leaf_test() in cmodel/prim/sphere.c
`timescale 1ns / 1ps
`default_nettype none
module rt_leaf_four #(
    parameter W  = 24,                           // coordinate, bits, up to 24
    parameter WD = 25                            // direction component, bits, up to 25
) (
    input  wire               clk,
    input  wire               take_i,            // clock 0 of a leaf
    input  wire               ready_i,           // its clock T_B-1
    input  wire [3*W+2:0]     oc_i,              // 3 x s(W+1), clock 0
    input  wire [W-1:0]       rad_i,             // uW, clock 0
    input  wire [3*WD-1:0]    dir_i,             // 3 x sWD, clock 0
    input  wire [2*WD-1:0]    a_i,               // u(2WD), clocks T_B to T_B+3
    output wire [W+WD+1:0]    b_o,               // s(W+WD+2), clocks T_B to T_B+3
    output wire               b_pos_o,           // b > 0, clock T_B+2 as all signs
    output wire               b_short_o,         // b < a
    output wire               k_pos_o,           // k > 0
    output wire               k_neg_o,           // k < 0
    output wire               light_out_o,       // k + 2b - a < 0
    output wire               light_in_o,        // k + 2b - a > 0
    output wire [2*W+2*WD+1:0] disc_o            // clock T_B + 7 or 8
);
    localparam BW = W + WD + 2;                  // |b| <= 3 * (2^W-1) * 2^(WD-1)
    localparam KW = 2*W + 3;                     // -3 * (2^W-1)^2 <= k <= (2^W-1)^2
    localparam MW = (W > WD - 1 ? W : WD - 1) + 1;   // |oc - dir| < 2^MW a component
    localparam LW = 2*MW + 3;                    // rad^2 - |oc - dir|^2
    localparam AW = (BW > 2*WD ? BW : 2*WD) + 2; // b - a

    // ---- b and k ----
    reg  signed [BW-1:0] b_q;
    reg  signed [KW-1:0] k_q;
    wire [BW-1:0]        b;
    wire [KW-1:0]        k;
    rt_leaf_sums #(.W(W), .WD(WD)) u_sums (
        .clk(clk), .take_i(take_i), .oc_i(oc_i), .rad_i(rad_i), .dir_i(dir_i), .b_o(b), .k_o(k)
    );
    always @(posedge clk)
        if (ready_i) begin
            b_q <= $signed(b);
            k_q <= $signed(k);
        end
    assign b_o = b_q;

    // ---- signs of b, k, b - a, k_light = k + 2b - a = rad^2 - |light - ctr|^2 ----
    reg                  b_pos_q, b_short_q, k_pos_q, k_neg_q;     // from T_B+1 on
    reg  signed [LW-1:0] part_q, light_q;        // 2b - a from T_B+1, k_light from T_B+2 on
    wire signed [LW-1:0] b_l = {{(LW-BW){b_q[BW-1]}}, b_q};
    wire signed [LW-1:0] k_l = {{(LW-KW){k_q[KW-1]}}, k_q};
    wire signed [LW-1:0] a_l = {{(LW-2*WD){1'b0}}, a_i};
    wire signed [AW-1:0] b_a = $signed({{(AW-BW){b_q[BW-1]}}, b_q})
                             - $signed({{(AW-2*WD){1'b0}}, a_i});
    always @(posedge clk) begin
        b_pos_q   <= !b_q[BW-1] && b_q != {BW{1'b0}};
        k_pos_q   <= !k_q[KW-1] && k_q != {KW{1'b0}};
        k_neg_q   <= k_q[KW-1];
        b_short_q <= b_a[AW-1];
        part_q    <= (b_l <<< 1) - a_l;
        light_q   <= k_l + part_q;
    end
    assign b_pos_o     = b_pos_q;
    assign b_short_o   = b_short_q;
    assign k_pos_o     = k_pos_q;
    assign k_neg_o     = k_neg_q;
    assign light_out_o = light_q[LW-1];
    assign light_in_o  = !light_q[LW-1] && light_q != {LW{1'b0}};

    // ---- disc ----
    rt_leaf_disc #(.W(W), .WD(WD)) u_disc (
        .clk(clk), .ready_i(ready_i), .b_i(b_q), .k_i(k_q), .a_i(a_i), .disc_o(disc_o)
    );
    wire unused = &{1'b0, b_a[AW-2:0]};
endmodule
`default_nettype wire
