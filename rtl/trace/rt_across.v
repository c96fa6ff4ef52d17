// rt_across.v - two axes across a ray, for rt_filter: p, q and the unit vector u at right angles
// SPDX-License-Identifier: Apache-2.0
// m = axis of the smallest |u|, a < b the other two; r = 1/sqrt(1 - u_m^2) by rt_rsqrt_rom:
//   p = r * (u_b, -u_a)    q = (u_m * p_b, u_m * p_a, -u_a * p_b - u_b * p_a)
// Four multipliers with two products each, stages of two clocks (phase 0, 1):
//   u_m | u_m^2 | table | slope | r | u_b*r, u_a*r | p | u_m*p, u*p | q
// A ray every second clock at most. What has no ray keeps its operands, so that nothing behind them
// switches. Latency 14 or 15.
// Model: sph_across() in cmodel/trace/setup.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_fx.vh"
module rt_across #(
    parameter TAG = 8                     // what travels along, bits
) (
    input  wire             clk,
    input  wire             rst,
    // a unit vector, not in the clock behind another
    input  wire             in_valid_i,
    input  wire [TAG-1:0]   in_tag_i,
    input  wire [53:0]      in_u_i,       // {u_m, u_b, u_a} s1.16
    input  wire [15:0]      in_mag_i,     // |u_m| u0.16, below 1/sqrt(3) + 2^-16
    input  wire [1:0]       in_least_i,   // m
    // its axes
    output reg              out_valid_o,
    output reg  [TAG-1:0]   out_tag_o,
    output reg  [1:0]       out_least_o,  // m
    output reg signed [17:0] out_p_a_o,   // s0.17
    output reg signed [17:0] out_p_b_o,   // s0.17, negated
    output reg  [53:0]      out_q_o       // {z, y, x} s0.17
);
    // ---- phase, valid bits, tags: stage n stands for two clocks ----
    localparam STAGES = 6;
    reg                  phase_q, wait_q;
    reg [STAGES:1]       valid_q;
    reg [TAG-1:0]        tag_q;                      // of the ray that waits for its phase
    reg [STAGES*TAG-1:0] tags_q;
    wire [STAGES:0]      live = {valid_q, wait_q};   // stages that hold a ray
    integer              i;
    always @(posedge clk) begin
        phase_q <= !phase_q;
        wait_q  <= in_valid_i || (wait_q && !phase_q);
        if (in_valid_i) tag_q <= in_tag_i;
        if (phase_q) begin
            valid_q <= live[STAGES-1:0];
            if (wait_q) tags_q[TAG-1:0] <= tag_q;
            for (i = 1; i < STAGES; i = i + 1)
                if (live[i]) tags_q[TAG*i +: TAG] <= tags_q[TAG*(i-1) +: TAG];
        end
        if (rst) begin
            phase_q <= 1'b0;
            wait_q  <= 1'b0;
            valid_q <= {STAGES{1'b0}};
        end
    end

    // ---- |u_m|; {m, u_m, u_b, u_a} of each stage ----
    reg  [15:0] mag0_q, mag1_q;                      // u0.16
    reg  [55:0] u0_q, u1_q, u2_q, u3_q, u4_q, u5_q;
    reg  [1:0]  least6_q;
    always @(posedge clk) begin
        if (in_valid_i) begin
            u0_q   <= {in_least_i, in_u_i};
            mag0_q <= in_mag_i;
        end
        if (phase_q) begin
            if (live[0]) {u1_q, mag1_q} <= {u0_q, mag0_q};
            if (live[1]) u2_q <= u1_q;
            if (live[2]) u3_q <= u2_q;
            if (live[3]) u4_q <= u3_q;
            if (live[4]) u5_q <= u4_q;
            if (live[5]) least6_q <= u5_q[55:54];
        end
    end

    // ---- stages 1 to 3: u_m^2, 1 - u_m^2, straight line, r ----
    reg  [15:0] m1_a_q, m1_b_q;                      // |u_m| twice, slope and fraction
    reg  [31:0] m1_p_q;                              // u0.32 in phase 0 of stage 2
    wire [17:0] x = ~m1_p_q[31:14];                  // u0.18, at least 2^17
    wire [27:0] line;                                // in phase 1 of stage 2
    reg  [9:0]  frac_q;
    reg  [16:0] start_q;                             // u1.16, in stage 3
    wire [16:0] r = start_q - {6'd0, m1_p_q[20:10]};
    rt_rsqrt_rom u_rom (.clk(clk), .index_i({1'b1, x[16:10]}), .line_q(line));
    always @(posedge clk) begin
        if (!phase_q) frac_q <= x[9:0];
        if (phase_q ? valid_q[2] : valid_q[1]) begin
            m1_a_q <= phase_q ? {5'd0, line[27:17]} : mag1_q;
            m1_b_q <= phase_q ? {6'd0, frac_q} : mag1_q;
        end
        m1_p_q <= m1_a_q * m1_b_q;
        if (phase_q && valid_q[2]) start_q <= line[16:0] - 17'd`RT_ACROSS_SHORT;
    end

    // ---- stage 4: r with u_b, then with u_a ----
    reg  signed [17:0] m2_a_q, m2_b_q;               // s1.16
    reg  signed [35:0] m2_p_q;                       // s3.32; u_b*r in phase 1, u_a*r a clock later
    wire signed [20:0] p = `RT_ROUND(m2_p_q, 35, 15);  // s0.17, |p| < 1
    always @(posedge clk) begin
        if (phase_q ? valid_q[3] : valid_q[4])
            m2_a_q <= phase_q ? $signed(u3_q[35:18]) : $signed(u4_q[17:0]);
        if (phase_q && valid_q[3]) m2_b_q <= {1'b0, r};
        m2_p_q <= m2_a_q * m2_b_q;
    end

    // ---- stage 5: u_m and u_b with p_a, then u_m and u_a with p_b ----
    reg  signed [17:0] m3_a_q, m4_a_q, m_b_q;
    reg  signed [35:0] m3_p_q, m4_p_q;               // s2.33
    reg  signed [17:0] p_a_q;                        // in stage 6 p_b stands in p_b_q
    reg  signed [17:0] p_b_q;
    wire signed [19:0] q = `RT_ROUND(m3_p_q, 35, 16);  // s0.17, |q| < 1
    reg  signed [35:0] part_q, sum_q;                // s2.33
    wire signed [19:0] q_m = `RT_ROUND(sum_q, 35, 16);
    reg  [17:0]        q_a_q, q_b_q;
    always @(posedge clk) begin
        if (phase_q ? valid_q[4] : valid_q[5]) begin
            m3_a_q <= phase_q ? $signed(u4_q[53:36]) : $signed(u5_q[53:36]);
            m4_a_q <= phase_q ? $signed(u4_q[35:18]) : $signed(u5_q[17:0]);
            m_b_q  <= p[17:0];
        end
        m3_p_q <= m3_a_q * m_b_q;
        m4_p_q <= m4_a_q * m_b_q;
        if (!phase_q) p_a_q <= m_b_q;
        if (phase_q)  p_b_q <= m_b_q;
        if (phase_q)  q_b_q <= q[17:0];
        if (!phase_q) q_a_q <= q[17:0];
        part_q <= ~m4_p_q;
        sum_q  <= part_q - m4_p_q;                   // -u_b*p_a - 1 - u_a*p_b in phase 1
    end

    // ---- stage 6, phase 1: p_a waited from phase 1 of stage 5 ----
    reg  signed [17:0] p_a_wait_q;
    always @(posedge clk) begin
        if (phase_q) p_a_wait_q <= p_a_q;
        out_valid_o <= phase_q && valid_q[6];
        if (phase_q && valid_q[6]) begin
            out_tag_o   <= tags_q[STAGES*TAG-1 -: TAG];
            out_least_o <= least6_q;
            out_p_a_o   <= p_a_wait_q;
            out_p_b_o   <= p_b_q;
            out_q_o[17:0]  <= least6_q == 2'd0 ? q_m[17:0] : q_a_q;
            out_q_o[35:18] <= least6_q == 2'd1 ? q_m[17:0] : least6_q == 2'd0 ? q_a_q : q_b_q;
            out_q_o[53:36] <= least6_q == 2'd2 ? q_m[17:0] : q_b_q;
        end
        if (rst) out_valid_o <= 1'b0;
    end

    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_axes_across_rays /* verilator public_flat_rd */ =
        {1'b0, in_valid_i, 4'd0, in_valid_i, 1'b0};
    wire unused = &{1'b0, u5_q, x[17], m1_p_q[9:0], m2_p_q[13:0], m3_p_q[14:0],
                    sum_q[14:0], p[20:18], q[19:18], q_m[19:18]};
endmodule
`default_nettype wire
