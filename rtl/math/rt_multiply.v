// rt_multiply.v - signed product of any width from 18x18 multipliers, one a clock
// SPDX-License-Identifier: Apache-2.0
// p = a * b. Operands are cut into C chunks of 17 bits (the top one up to 18, signed), so that each
// product fits an 18x18 multiplier. Products i*j with equal j-i lie 34 bits apart and are joined
// without adding; what is left are 2C-1 words:
//   stage 1 C*C products | stage 2 words j-i = +d and -d added | stages 3.. one word a stage
// Free-running, latency `RT_MUL_LATENCY(W) = 1 (C = 1) or C + 1. Model: the product itself.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_fx.vh"
module rt_multiply #(
    parameter W = 35                     // operand width, bits
) (
    input  wire                  clk,
    input  wire                  in_valid_i, // operands; else nothing switches
    input  wire signed [W-1:0]   a_i,    // sW
    input  wire signed [W-1:0]   b_i,    // sW
    output wire signed [2*W-1:0] p_o     // s2W
);
    localparam C  = `RT_MUL_CHUNKS(W);
    localparam AW = C*17 + 1;            // operands extended to whole chunks
    localparam PW = 2*AW;                // product of these
    generate
        if (C == 1) begin : g_one
            // ---- stage 1: product ----
            reg signed [2*W-1:0] s1_p_q;
            always @(posedge clk) if (in_valid_i) s1_p_q <= a_i * b_i;
            assign p_o = s1_p_q;
        end else begin : g_many
            wire signed [AW-1:0] a = {{(AW-W){a_i[W-1]}}, a_i};
            wire signed [AW-1:0] b = {{(AW-W){b_i[W-1]}}, b_i};
            reg [C:1]            valid_q;    // stages that hold a product
            always @(posedge clk) valid_q <= {valid_q[C-1:1], in_valid_i};
            // ---- stage 1: C*C products, 36 bits each ----
            wire [36*C*C-1:0] s1_p;
            genvar i, j, d;
            for (i = 0; i < C; i = i + 1) begin : g_row
                for (j = 0; j < C; j = j + 1) begin : g_col
                    wire signed [17:0] ca = {i == C-1 ? a[AW-1] : 1'b0, a[17*i +: 17]};
                    wire signed [17:0] cb = {j == C-1 ? b[AW-1] : 1'b0, b[17*j +: 17]};
                    reg signed [35:0] s1_p_q;
                    always @(posedge clk) if (in_valid_i) s1_p_q <= ca * cb;
                    assign s1_p[36*(i*C + j) +: 36] = s1_p_q;
                end
            end
            // ---- words: products with |j-i| = d, shifted by 17*d; stage 2 adds the two ----
            wire signed [PW-1:0] s2_word [0:C-1];
            for (d = 0; d < C; d = d + 1) begin : g_word
                localparam N = C - d;    // products in a word
                wire [34*N+1:0] up, down;
                for (i = 0; i < N; i = i + 1) begin : g_join
                    assign up[34*i +: 34]   = s1_p[36*(i*C + i + d) +: 34];
                    assign down[34*i +: 34] = s1_p[36*((i + d)*C + i) +: 34];
                end
                assign up[34*N +: 2]   = s1_p[36*((N-1)*C + C-1) + 34 +: 2];
                assign down[34*N +: 2] = s1_p[36*((C-1)*C + N-1) + 34 +: 2];
                reg signed [34*N+2:0] s2_sum_q;
                if (d == 0) begin : g_middle
                    always @(posedge clk) if (valid_q[1]) s2_sum_q <= {up[34*N+1], up};
                    wire unused = &{1'b0, down};
                end else begin : g_pair
                    always @(posedge clk) if (valid_q[1])
                        s2_sum_q <= $signed({up[34*N+1], up}) + $signed({down[34*N+1], down});
                end
                // delayed to the stage that adds it
                wire signed [34*N+2:0] late;
                if (d < 2) begin : g_now
                    assign late = s2_sum_q;
                end else begin : g_wait
                    reg [(34*N+3)*(d-1)-1:0] wait_q;
                    wire [(34*N+3)*d-1:0] wait_d = {wait_q, s2_sum_q};
                    always @(posedge clk) wait_q <= wait_d[(34*N+3)*(d-1)-1:0];
                    assign late = wait_d[(34*N+3)*d-1 -: 34*N+3];
                end
                wire signed [PW:0] wide = {{(PW+1-(34*N+3)){late[34*N+2]}}, late};
                assign s2_word[d] = wide[PW-1:0] <<< (17*d);
                wire unused = wide[PW];
            end
            // ---- stages 3 to C+1: one more word each ----
            wire signed [PW-1:0] sum [0:C-1];
            assign sum[0] = s2_word[0];
            for (d = 1; d < C; d = d + 1) begin : g_sum
                reg signed [PW-1:0] sum_q;
                always @(posedge clk) if (valid_q[d+1]) sum_q <= sum[d-1] + s2_word[d];
                assign sum[d] = sum_q;
            end
            assign p_o = sum[C-1][2*W-1:0];
            wire unused = &{1'b0, sum[C-1], s1_p};
        end
    endgenerate
endmodule
`default_nettype wire
