// rt_unit_four.v - unit vector u = v / |v|, one every four clocks
// SPDX-License-Identifier: Apache-2.0
// The numbers of rt_unit. Components are cut into pieces of 17 bits, h above l; three multipliers
// serve x, y, z at once, the fourth one after the other. Phase of an operand, vector taken in 3:
//            0          1          2          3
//   x y z    l*l        l*2h       h*h        h(v<<h)*y, of an earlier vector
//   fourth   l(x)*y     l(y)*y     l(z)*y     slope*frac, of one between
// What has no vector keeps its operands, so that nothing behind them switches.
// Free-running, latency 23. Model: sph_unit() in math/arith.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
`include "rt_fx.vh"
module rt_unit_four #(
    parameter BITS = 25,                      // component of v, bits: 18 to 32
    parameter TAG  = 8,                       // what travels along, bits
    parameter ODD  = 0                        // 1: ready two clocks after reset, 0: at once
) (
    input  wire                   clk,
    input  wire                   rst,        // synchronous, active high
    // a vector
    input  wire                   in_valid_i,
    output wire                   in_ready_o, // high every fourth clock
    input  wire [TAG-1:0]         in_tag_i,
    input  wire signed [BITS-1:0] in_x_i,     // sBITS
    input  wire signed [BITS-1:0] in_y_i,
    input  wire signed [BITS-1:0] in_z_i,
    // its unit vector
    output wire                   out_valid_o,
    output wire [TAG-1:0]         out_tag_o,
    output wire [2*BITS-1:0]      out_vv_o,   // u(2BITS), v.v
    output wire signed [17:0]     out_u_x_o,  // s1.16
    output wire signed [17:0]     out_u_y_o,
    output wire signed [17:0]     out_u_z_o,
    output wire [16:0]            out_y_o,    // u1.16, 2^(BITS+16-h) / |v| from below
    output wire [5:0]             out_h_o     // left shift of v
);
    `RT_CHECK(BITS >= 18 && BITS <= 32, rt_unit_four_BITS_must_be_18_to_32)
    localparam VW    = 2*BITS;                // v.v < 3/4 * 2^VW
    localparam LOW   = BITS - 17;             // of (v << h) * y the high products lie 17 bits up
    localparam STAGES = 6;                    // stage n stands in clocks 4n+1 to 4n+4

    // ---- phase: the first clock of a stage has phase 0; valid bits, tag ----
    reg [1:0]            phase_q;
    reg [STAGES-1:0]     valid_q;
    reg [STAGES*TAG-1:0] tag_q;
    integer              i;
    wire                 last = phase_q == 2'd3;
    wire                 take = last && in_valid_i;
    assign in_ready_o = last;
    always @(posedge clk) begin
        phase_q <= phase_q + 2'd1;
        if (last) begin
            valid_q <= {valid_q[STAGES-2:0], in_valid_i};
            for (i = 1; i < STAGES; i = i + 1)
                if (valid_q[i-1]) tag_q[TAG*i +: TAG] <= tag_q[TAG*(i-1) +: TAG];
        end
        if (take) tag_q[TAG-1:0] <= in_tag_i;
        if (rst) begin
            phase_q <= ODD != 0 ? 2'd1 : 2'd3;
            valid_q <= {STAGES{1'b0}};
        end
    end

    // ---- v: in stages 0 to 2, then shifted, one component after the other ----
    reg  [3*BITS-1:0]    v0_q, v1_q, v2_q;    // {z, y, x}
    reg  [BITS-1:0]      z_q;                 // z of stage 2, for a clock longer
    reg  [4:0]           h_q;                 // in phases 2, 3, 0, 1 from clock 11 on
    reg  signed [BITS:0] shift_q;             // x, y, z in phases 3, 0, 1; |v << h| < 2^BITS
    wire [BITS-1:0]      turn = phase_q == 2'd2 ? v2_q[0 +: BITS]
                                : last ? v2_q[BITS +: BITS] : z_q;
    reg  signed [BITS:0] s_x_q, s_y_q, s_z_q;                // v << h, in phases 2 and 3
    reg  [16:0]          low_q;               // l of v << h: x, y, z in phases 0, 1, 2 of stage 4
    wire signed [BITS:0] turn_s = {turn[BITS-1], turn};
    always @(posedge clk) begin
        if (take) v0_q <= {in_z_i, in_y_i, in_x_i};
        if (last && valid_q[0]) v1_q <= v0_q;
        if (last && valid_q[1]) v2_q <= v1_q;
        if (last && valid_q[2]) z_q  <= v2_q[2*BITS +: BITS];
        if (phase_q != 2'd1 && |valid_q[3:2]) shift_q <= turn_s <<< h_q;
        if (phase_q != 2'd2 && |valid_q[4:2]) begin
            {s_x_q, s_y_q, s_z_q} <= {s_y_q, s_z_q, shift_q};
            low_q <= s_x_q[16:0];             // y and z move to x while the next vector comes
        end
    end

    // ---- operands and products of x, y, z; those of squares are added ----
    reg  [16:0]        y_q;                   // u1.16, in phases 2, 3, 0, 1 from clock 15 on
    reg  [16:0]        y4_q, y5_q;            // the same in stages 4 and 5
    wire signed [35:0] p [0:2];
    genvar g;
    generate
        for (g = 0; g < 3; g = g + 1) begin : g_lane
            wire signed [BITS:0] s = g == 0 ? s_x_q : g == 1 ? s_y_q : s_z_q;
            wire [34:0]          v = {{(35-BITS){v0_q[BITS*g + BITS-1]}}, v0_q[BITS*g +: BITS]};
            wire signed [17:0]   v_l = {1'b0, v[16:0]}, v_h = v[34:17];
            wire [34:0]          back = {{(34-BITS){s[BITS]}}, s};
            reg  signed [17:0]   a_q, b_q;
            reg  signed [35:0]   p_q;
            always @(posedge clk) begin
                if (last ? valid_q[3] : valid_q[0]) begin
                    a_q <= last ? $signed(back[34:17]) : phase_q[1] ? v_h : v_l;
                    b_q <= last ? $signed({1'b0, y_q}) : phase_q[1] ? v_h
                           : phase_q[0] ? v_h <<< 1 : v_l;
                end
                p_q <= a_q * b_q;
            end
            assign p[g] = p_q;
            wire unused = &{1'b0, back[16:0]};
        end
    endgenerate
    reg  signed [36:0] xy_q;
    reg  signed [35:0] zz_q;
    reg  signed [37:0] sum_q;
    reg  signed [39:0] acc_q;                 // 17 bits leave with every step
    reg  [33:0]        acc_low_q;
    wire signed [39:0] acc_old = acc_q >>> 17;
    wire [73:0]        acc = {acc_q, acc_low_q};             // v.v in phase 3 of stage 1
    reg  [VW-1:0]      vv2_q, vv3_q, vv4_q, vv5_q;           // in stages 2 to 5
    always @(posedge clk) begin
        if (phase_q != 2'd1) begin            // then it is h*y
            xy_q <= p[0] + p[1];
            zz_q <= p[2];
        end
        sum_q <= xy_q + $signed({zz_q[35], zz_q});
        if (last ? valid_q[0] : valid_q[1])
            acc_q <= last ? 40'sd0 : acc_old + $signed({{2{sum_q[37]}}, sum_q});
        if (^phase_q && valid_q[1]) acc_low_q <= {acc_q[16:0], acc_low_q[33:17]};
        if (last && valid_q[1]) vv2_q <= acc[VW-1:0];
        if (last && valid_q[2]) vv3_q <= vv2_q;
        if (last && valid_q[3]) vv4_q <= vv3_q;
        if (last && valid_q[4]) vv5_q <= vv4_q;
    end

    // ---- shift: pairs of leading zeros, by 16 and 8, then by 4, 2 and 1 ----
    wire [63:0] n_0  = {vv2_q, {(64-VW){1'b0}}};
    wire        h_16 = n_0[63:32] == 32'd0;
    wire [63:0] n_16 = h_16 ? {n_0[31:0], 32'd0} : n_0;
    wire        h_8  = n_16[63:48] == 16'd0;
    reg  [31:0] n_8_q;                                       // more does not reach the table
    reg         h_16_q, h_8_q;
    wire        h_4  = n_8_q[31:24] == 8'd0;
    wire [31:0] n_4  = h_4 ? n_8_q << 8 : n_8_q;
    wire        h_2  = n_4[31:28] == 4'd0;
    wire [31:0] n_2  = h_2 ? n_4 << 4 : n_4;
    wire        h_1  = n_2[31:30] == 2'd0;
    wire [17:0] n_1  = h_1 ? n_2[29:12] : n_2[31:14];
    reg  [17:0] x_q;                                         // u18, in [2^16, 2^18) or 0
    reg  [4:0]  h3_q, h4_q, h5_q;                            // h in stages 3 to 5; 0 for v = 0
    always @(posedge clk) begin
        n_8_q  <= h_8 ? n_16[47:16] : n_16[63:32];
        h_16_q <= h_16;
        h_8_q  <= h_8;
        if (phase_q == 2'd1) begin
            x_q <= n_1;
            h_q <= n_1[17:16] == 2'd0 ? 5'd0 : {h_16_q, h_8_q, h_4, h_2, h_1};
        end
        if (last) {h5_q, h4_q, h3_q} <= {h4_q, h3_q, h_q};
    end

    // ---- table, fourth multiplier, y = start - floor(slope * frac / 1024) ----
    wire [27:0]        line;                  // in phases 3, 0, 1, 2 from clock 12 on
    reg  signed [17:0] a_q, b_q;
    reg  signed [35:0] p_q;                   // slope * frac in phase 1; l*y of x, y, z in 2, 3, 0
    rt_rsqrt_rom u_rom (.clk(clk), .index_i(x_q[17:10]), .line_q(line));
    always @(posedge clk) begin
        if (last ? valid_q[2] : valid_q[4]) begin
            a_q <= last ? $signed({7'd0, line[27:17]}) : $signed({1'b0, low_q});
            b_q <= last ? $signed({8'd0, x_q[9:0]}) : $signed({1'b0, y4_q});
        end
        p_q <= a_q * b_q;
        if (phase_q == 2'd1 && valid_q[3]) y_q <= line[16:0] - {6'd0, p_q[20:10]};
        if (last) {y5_q, y4_q} <= {y4_q, y_q};
    end

    // ---- u: h*y waits for l*y; then rounded ----
    reg  signed [35:0] h_x_q, h_y_q, h_z_q;
    reg  signed [35:0] r_q;                                  // floor((v << h) * y / 2^17)
    wire signed [35-LOW:0] u = `RT_ROUND(r_q, 35, LOW);
    reg  [53:0]        u_q;                                  // {z, y, x} s1.16 in phase 2
    always @(posedge clk) begin
        if (phase_q != 2'd1) {h_x_q, h_y_q} <= {h_y_q, h_z_q};
        else if (valid_q[4]) {h_x_q, h_y_q, h_z_q} <= {p[0], p[1], p[2]};
        if (phase_q[1] ? valid_q[4] : valid_q[5]) r_q <= h_x_q + $signed({17'd0, p_q[35:17]});
        if (last ? valid_q[4] : valid_q[5] && phase_q != 2'd2) u_q <= {u[17:0], u_q[53:18]};
    end
    assign out_valid_o = valid_q[STAGES-1] && phase_q == 2'd2;
    assign out_tag_o   = tag_q[STAGES*TAG-1 -: TAG];
    assign out_vv_o    = vv5_q;
    assign out_h_o     = {1'b0, h5_q};
    assign out_y_o     = y5_q;
    assign out_u_x_o   = $signed(u_q[17:0]);
    assign out_u_y_o   = $signed(u_q[35:18]);
    assign out_u_z_o   = $signed(u_q[53:36]);

    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_unit_vectors /* verilator public_flat_rd */ =
        {in_valid_i && !in_ready_o, take, 3'd0, take, 2'd0};
    wire unused = &{1'b0, acc, n_16, n_2[11:0], u, p_q};
endmodule
`default_nettype wire
