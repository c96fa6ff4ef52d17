// rt_leaf_disc.v - disc = k*a + b*b over four clocks
// SPDX-License-Identifier: Apache-2.0
// Operands are cut into pieces of 17 bits, 0 the lowest. Products of a step lie 17 bits above those
// of the step before or at their place; 17 bits leave the accumulator when the weight grows.
//   step, of two pieces    0            1            2            3
//     2 multipliers      b0b0 k0a0    b0b1 k0a1    b1b0 k1a0    b1b1 k1a1
//   step, of three pieces; weight of the step, and 17 bits more behind the bar
//     4 multipliers      b0b0 k0a0   2b0b1         2b0b2 b1b1     2b1b2
//                      | k0a1 k1a0 | k0a2 k1a1 k2a0 | k1a2 k2a1 | b2b2 k2a2
// Model: disc of sph_leaf_test() in cmodel/prim/sphere.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
`include "rt_fx.vh"
module rt_leaf_disc #(
    parameter W  = 24,                           // coordinate, bits
    parameter WD = 25                            // direction component, bits
) (
    input  wire                clk,
    input  wire                ready_i,          // the clock before step 0
    input  wire [W+WD+1:0]     b_i,              // s(W+WD+2), in steps 0 to 3
    input  wire [2*W+2:0]      k_i,              // s(2W+3)
    input  wire [2*WD-1:0]     a_i,              // u(2WD)
    output wire [2*W+2*WD+1:0] disc_o            // with two pieces 7 clocks behind step 0, else 8
);
    localparam BW = W + WD + 2;
    localparam KW = 2*W + 3;
    localparam DW = 2*W + 2*WD + 2;              // sums wrap rightly
    `RT_CHECK(KW <= 52 && BW <= 52 && 2*WD <= 51, rt_leaf_disc_W_must_be_to_24_and_WD_to_25)
    wire signed [51:0] b = {{(52-BW){b_i[BW-1]}}, b_i};
    wire signed [51:0] k = {{(52-KW){k_i[KW-1]}}, k_i};
    wire        [51:0] a = {{(52-2*WD){1'b0}}, a_i};
    reg [1:0] step_q, s1_step_q, s2_step_q;      // of the operands, products, sums
    always @(posedge clk) begin
        step_q    <= ready_i ? 2'd0 : step_q + 2'd1;
        s1_step_q <= step_q;
        s2_step_q <= s1_step_q;
    end
    wire signed [17:0] b0 = {1'b0, b[16:0]}, k0 = {1'b0, k[16:0]}, a0 = {1'b0, a[16:0]};
    generate
        if (`RT_LEAF_PIECES(W, WD) == 1) begin : g_two
            // ---- operands, products, their sum ----
            wire signed [17:0] b1 = b[34:17], k1 = k[34:17], a1 = a[34:17];
            reg signed [17:0] s1_b_q, s1_bb_q, s1_k_q, s1_a_q;
            reg signed [35:0] s2_b_q, s2_k_q;
            reg signed [36:0] s3_q;
            reg [1:0]         s3_step_q;
            always @(posedge clk) begin
                s1_b_q    <= step_q[1] ? b1 : b0;
                s1_bb_q   <= step_q[0] ? b1 : b0;
                s1_k_q    <= step_q[1] ? k1 : k0;
                s1_a_q    <= step_q[0] ? a1 : a0;
                s2_b_q    <= s1_b_q * s1_bb_q;
                s2_k_q    <= s1_k_q * s1_a_q;
                s3_q      <= s2_b_q + s2_k_q;
                s3_step_q <= s2_step_q;
            end

            // ---- accumulator ----
            reg signed [39:0]  sum_q;
            reg [33:0]         low_q;
            wire signed [39:0] old = s3_step_q == 2'd2 ? sum_q : sum_q >>> 17;
            wire signed [39:0] s3  = {{3{s3_q[36]}}, s3_q};
            always @(posedge clk) begin
                sum_q <= (s3_step_q == 2'd0 ? 40'sd0 : old) + s3;
                if (s3_step_q[0]) low_q <= {sum_q[16:0], low_q[33:17]};
            end
            wire [73:0] disc = {sum_q, low_q};
            assign disc_o = disc[DW-1:0];
            wire unused = &{1'b0, disc, b[51:35], k[51:35], a[51:35]};
        end else begin : g_three
            // ---- operands, products ----
            wire signed [17:0] b1 = {1'b0, b[33:17]}, k1 = {1'b0, k[33:17]}, a1 = {1'b0, a[33:17]};
            wire signed [17:0] b2 = b[51:34], k2 = k[51:34], a2 = a[51:34];
            reg signed [17:0] s1_0a_q, s1_0b_q, s1_1a_q, s1_1b_q;
            reg signed [17:0] s1_2a_q, s1_2b_q, s1_3a_q, s1_3b_q;
            reg signed [35:0] s2_0_q, s2_1_q, s2_2_q, s2_3_q;
            always @(posedge clk) begin
                s1_0a_q <= step_q == 2'd3 ? b1 : b0;
                s1_0b_q <= step_q == 2'd0 ? b0 : step_q == 2'd1 ? b1 : b2;
                s1_1a_q <= step_q == 2'd3 ? b2 : step_q == 2'd2 ? b1 : k0;
                s1_1b_q <= step_q == 2'd3 ? b2 : step_q == 2'd2 ? b1 : step_q == 2'd1 ? a2 : a0;
                s1_2a_q <= step_q == 2'd0 ? k0 : step_q == 2'd1 ? k1 : k2;
                s1_2b_q <= step_q == 2'd3 ? a2 : a1;
                s1_3a_q <= step_q == 2'd3 ? 18'sd0 : step_q == 2'd1 ? k2 : k1;
                s1_3b_q <= step_q == 2'd2 ? a2 : a0;
                s2_0_q  <= s1_0a_q * s1_0b_q;
                s2_1_q  <= s1_1a_q * s1_1b_q;
                s2_2_q  <= s1_2a_q * s1_2b_q;
                s2_3_q  <= s1_3a_q * s1_3b_q;
            end

            // ---- sums of a step: of its own weight, and of 17 bits more ----
            reg signed [37:0] s3_low_q, s4_low_q, s4_high_q;
            reg signed [36:0] s3_23_q;
            reg signed [35:0] s3_1_q;
            reg [1:0]         s3_step_q, s4_step_q;
            wire signed [37:0] s2_0 = {{2{s2_0_q[35]}}, s2_0_q};
            wire signed [37:0] s2_1 = {{2{s2_1_q[35]}}, s2_1_q};
            always @(posedge clk) begin
                s3_low_q  <= (s2_step_q == 2'd0 ? s2_0 : s2_0 <<< 1)
                           + (s2_step_q[0] ? 38'sd0 : s2_1);
                s3_1_q    <= s2_step_q[0] ? s2_1_q : 36'sd0;
                s3_23_q   <= s2_2_q + s2_3_q;
                s3_step_q <= s2_step_q;
                s4_low_q  <= s3_low_q;
                s4_high_q <= s3_23_q + $signed({s3_1_q[35], s3_1_q});
                s4_step_q <= s3_step_q;
            end

            // ---- accumulator ----
            reg signed [58:0]  sum_q;
            reg [50:0]         low_q;
            wire signed [58:0] old  = sum_q >>> 17;
            wire [41:0]        high = {{21{s4_low_q[37]}}, s4_low_q[37:17]}
                                    + {{4{s4_high_q[37]}}, s4_high_q};
            wire signed [58:0] add  = {high, s4_low_q[16:0]};
            always @(posedge clk) begin
                sum_q <= (s4_step_q == 2'd0 ? 59'sd0 : old) + add;
                if (s4_step_q != 2'd0) low_q <= {sum_q[16:0], low_q[50:17]};
            end
            wire [109:0] disc = {sum_q, low_q};
            assign disc_o = disc[DW-1:0];
            wire unused = &{1'b0, disc};
        end
    endgenerate
endmodule
`default_nettype wire
