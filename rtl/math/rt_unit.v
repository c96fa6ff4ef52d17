// rt_unit.v - unit vector u = v / |v| by a table of inverse square roots
// SPDX-License-Identifier: Apache-2.0
// vv = v.v, h = left shift that brings |v| into [2^(BITS-1), 2^BITS), y = rsqrt(vv << 2h),
// u = round((v << h) * y / 2^BITS); v = 0 gives 0. Three multipliers serve v.v in even clocks and
// (v << h) * y in odd ones: in_ready_o is high in every second clock. L = `RT_MUL_LATENCY(BITS+1):
//   1 operands | L products | 2 sum | 2 shift | 2 table | 2 slope | 1 y | 1 operands | L | 1 round
// What has no vector keeps its operands, so that nothing behind them switches.
// Free-running, latency 2*L + 12: 14 for BITS <= 17, else 18. Model: sph_unit() in math/arith.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
`include "rt_fx.vh"
module rt_unit #(
    parameter BITS = 17,                      // component of v, bits: 9 to 32
    parameter TAG  = 8,                       // what travels along, bits
    parameter ODD  = 0                        // 1: ready a clock after reset, 0: at once
) (
    input  wire                   clk,
    input  wire                   rst,        // synchronous, active high
    // a vector
    input  wire                   in_valid_i,
    output wire                   in_ready_o, // high every second clock
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
    `RT_CHECK(BITS >= 9 && BITS <= 32, rt_unit_BITS_must_be_9_to_32)
    localparam OW = BITS + 1 > 18 ? BITS + 1 : 18;  // operands of the multipliers
    localparam L  = `RT_MUL_LATENCY(OW);            // odd: 1 or 3
    localparam VW = 2*BITS;                         // v.v < 3/4 * 2^VW
    // The clock in which a value stands in its register; the input is taken at the end of clock 0.
    localparam T_VV  = L + 3;                       // v.v, even
    localparam T_H   = T_VV + 2;                    // shift h and the shifted v.v, even
    localparam T_Y   = T_H + 5;                     // y, odd
    localparam T_OUT = T_Y + L + 2;                 // u, even
    // What must wait does so in registers that are loaded every second clock at most.
    localparam N_TAG = T_OUT/2;                     // stage j stands in clocks 2j+1 and 2j+2
    localparam N_V   = T_H/2 + 1;                   // the same
    localparam N_VV  = (T_OUT - T_VV)/2;            // from T_VV+1 on
    localparam N_H   = (T_OUT - T_H)/2;             // from T_H+1 on
    localparam N_Y   = (T_OUT - T_Y + 1)/2;         // from T_Y+1 on

    // ---- phases, valid bits, tag ----
    reg                 phase_q;                    // 0 in even clocks, seen from clock 0
    reg [T_OUT-1:0]     valid_q;                    // bit i: clock i+1
    reg [N_TAG*TAG-1:0] tag_q;
    integer             i_tag, i_vv, i_h, i_v, i_y;    // one a block: Yosys sees one driver of each
    wire                take = in_valid_i && !phase_q;
    assign in_ready_o = !phase_q;
    always @(posedge clk) begin
        phase_q <= !phase_q;
        valid_q <= {valid_q[T_OUT-2:0], take};
        for (i_tag = 1; i_tag < N_TAG; i_tag = i_tag + 1)
            if (valid_q[2*i_tag-1]) tag_q[TAG*i_tag +: TAG] <= tag_q[TAG*(i_tag-1) +: TAG];
        if (take) tag_q[TAG-1:0] <= in_tag_i;
        if (rst) begin
            phase_q <= ODD != 0;
            valid_q <= {T_OUT{1'b0}};
        end
    end

    // ---- operands: v and v in odd clocks, v << h and y in even ones ----
    reg  signed [OW-1:0]   a_x_q, a_y_q, a_z_q, b_x_q, b_y_q, b_z_q;
    wire signed [OW-1:0]   in_x = {{(OW-BITS){in_x_i[BITS-1]}}, in_x_i};
    wire signed [OW-1:0]   in_y = {{(OW-BITS){in_y_i[BITS-1]}}, in_y_i};
    wire signed [OW-1:0]   in_z = {{(OW-BITS){in_z_i[BITS-1]}}, in_z_i};
    reg  signed [BITS:0]   back_x_q, back_y_q, back_z_q;     // s(BITS+1), v << h in clock T_Y
    reg  [16:0]            y_q;                              // u1.16, in clock T_Y
    wire signed [OW-1:0]   y = {{(OW-17){1'b0}}, y_q};
    wire                   back = valid_q[T_Y-1];            // in odd clocks alone
    always @(posedge clk) if (take || back) begin
        a_x_q <= back ? {{(OW-BITS-1){back_x_q[BITS]}}, back_x_q} : in_x;
        a_y_q <= back ? {{(OW-BITS-1){back_y_q[BITS]}}, back_y_q} : in_y;
        a_z_q <= back ? {{(OW-BITS-1){back_z_q[BITS]}}, back_z_q} : in_z;
        b_x_q <= back ? y : in_x;
        b_y_q <= back ? y : in_y;
        b_z_q <= back ? y : in_z;
    end

    // ---- products ----
    wire signed [2*OW-1:0] p_x, p_y, p_z;
    wire                   p_in = valid_q[0] || valid_q[T_Y];
    rt_multiply #(.W(OW)) u_mul_x (
        .clk(clk), .in_valid_i(p_in), .a_i(a_x_q), .b_i(b_x_q), .p_o(p_x)
    );
    rt_multiply #(.W(OW)) u_mul_y (
        .clk(clk), .in_valid_i(p_in), .a_i(a_y_q), .b_i(b_y_q), .p_o(p_y)
    );
    rt_multiply #(.W(OW)) u_mul_z (
        .clk(clk), .in_valid_i(p_in), .a_i(a_z_q), .b_i(b_z_q), .p_o(p_z)
    );

    // ---- sum: v.v in clock T_VV ----
    reg [VW-1:0]      xy_q, zz_q, vv_q;
    reg [N_VV*VW-1:0] vv_wait_q;
    wire [(N_VV+1)*VW-1:0] vv_wait_d = {vv_wait_q, vv_q};
    always @(posedge clk) begin
        if (valid_q[L]) begin
            xy_q <= p_x[VW-1:0] + p_y[VW-1:0];
            zz_q <= p_z[VW-1:0];
        end
        if (valid_q[L+1]) vv_q <= xy_q + zz_q;
        for (i_vv = 0; i_vv < N_VV; i_vv = i_vv + 1)
            if (valid_q[T_VV+2*i_vv-1])
                vv_wait_q[VW*i_vv +: VW] <= vv_wait_d[VW*i_vv +: VW];
    end

    // ---- shift: pairs of leading zeros, by 16 and 8, then by 4, 2 and 1 ----
    wire [63:0] n_0  = {vv_q, {(64-VW){1'b0}}};
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
    reg  [4:0]  h_q;                                         // in clock T_H; 0 for v = 0
    reg  [N_H*5-1:0] h_wait_q;
    wire [N_H*5+4:0] h_wait_d = {h_wait_q, h_q};
    always @(posedge clk) begin
        if (valid_q[T_VV-1]) begin
            n_8_q  <= h_8 ? n_16[47:16] : n_16[63:32];
            h_16_q <= h_16;
            h_8_q  <= h_8;
        end
        if (valid_q[T_VV]) begin
            x_q    <= n_1;
            h_q    <= n_1[17:16] == 2'd0 ? 5'd0 : {h_16_q, h_8_q, h_4, h_2, h_1};
        end
        for (i_h = 0; i_h < N_H; i_h = i_h + 1)
            if (valid_q[T_H+2*i_h-1]) h_wait_q[5*i_h +: 5] <= h_wait_d[5*i_h +: 5];
    end

    // ---- v waits for h and is shifted: stands from T_H+3 to T_H+4, then to T_Y+1 ----
    reg  [N_V*3*BITS-1:0] v_wait_q;
    reg  signed [BITS:0]  s_x_q, s_y_q, s_z_q;
    wire signed [BITS:0]  v_x = $signed({v_wait_q[N_V*3*BITS-1],
                                         v_wait_q[N_V*3*BITS-1 -: BITS]});
    wire signed [BITS:0]  v_y = $signed({v_wait_q[N_V*3*BITS-BITS-1],
                                         v_wait_q[N_V*3*BITS-BITS-1 -: BITS]});
    wire signed [BITS:0]  v_z = $signed({v_wait_q[N_V*3*BITS-2*BITS-1],
                                         v_wait_q[N_V*3*BITS-2*BITS-1 -: BITS]});
    always @(posedge clk) begin
        if (take) v_wait_q[3*BITS-1:0] <= {in_x_i, in_y_i, in_z_i};
        for (i_v = 1; i_v < N_V; i_v = i_v + 1)
            if (valid_q[2*i_v-1])
                v_wait_q[3*BITS*i_v +: 3*BITS] <= v_wait_q[3*BITS*(i_v-1) +: 3*BITS];
        if (valid_q[T_H+1]) begin
            s_x_q    <= v_x <<< h_wait_q[4:0];               // |v << h| < 2^BITS
            s_y_q    <= v_y <<< h_wait_q[4:0];
            s_z_q    <= v_z <<< h_wait_q[4:0];
        end
        if (valid_q[T_H+3]) begin
            back_x_q <= s_x_q;
            back_y_q <= s_y_q;
            back_z_q <= s_z_q;
        end
    end

    // ---- table, slope, y = start - floor(slope * frac / 1024) in clock T_Y ----
    // Block RAM and multiplier are slow, and lie where they lie: a clock for each, and for the way.
    wire [27:0] line;
    reg  [27:0] line_q;
    reg  [9:0]  frac_q, frac_two_q;
    reg  [20:0] slope_q, slope_two_q;                        // u11.10
    reg  [16:0] start_q, start_two_q;                        // u1.16
    reg  [N_Y*17-1:0] y_wait_q;
    wire [N_Y*17+16:0] y_wait_d = {y_wait_q, y_q};
    rt_rsqrt_rom u_rom (.clk(clk), .index_i(x_q[17:10]), .line_q(line));
    always @(posedge clk) begin
        if (valid_q[T_H-1]) frac_q <= x_q[9:0];
        if (valid_q[T_H]) begin
            line_q      <= line;
            frac_two_q  <= frac_q;
        end
        if (valid_q[T_H+1]) begin
            slope_q     <= {10'd0, line_q[27:17]} * {11'd0, frac_two_q};
            start_q     <= line_q[16:0];
        end
        if (valid_q[T_H+2]) begin
            slope_two_q <= slope_q;
            start_two_q <= start_q;
        end
        if (valid_q[T_H+3]) y_q <= start_two_q - {6'd0, slope_two_q[20:10]};
        for (i_y = 0; i_y < N_Y; i_y = i_y + 1)
            if (valid_q[T_Y+2*i_y-1])
                y_wait_q[17*i_y +: 17] <= y_wait_d[17*i_y +: 17];
    end

    // ---- round ----
    wire signed [2*OW-1-BITS:0] r_x = `RT_ROUND(p_x, 2*OW-1, BITS);
    wire signed [2*OW-1-BITS:0] r_y = `RT_ROUND(p_y, 2*OW-1, BITS);
    wire signed [2*OW-1-BITS:0] r_z = `RT_ROUND(p_z, 2*OW-1, BITS);
    reg  signed [17:0] u_x_q, u_y_q, u_z_q;                  // s1.16
    always @(posedge clk) if (valid_q[T_OUT-2]) begin
        u_x_q <= r_x[17:0];
        u_y_q <= r_y[17:0];
        u_z_q <= r_z[17:0];
    end
    assign out_valid_o = valid_q[T_OUT-1];
    assign out_tag_o   = tag_q[N_TAG*TAG-1 -: TAG];
    assign out_vv_o    = vv_wait_q[N_VV*VW-1 -: VW];
    assign out_h_o     = {1'b0, h_wait_q[N_H*5-1 -: 5]};
    assign out_y_o     = y_wait_q[N_Y*17-1 -: 17];
    assign out_u_x_o   = u_x_q;
    assign out_u_y_o   = u_y_q;
    assign out_u_z_o   = u_z_q;

    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_unit_vectors /* verilator public_flat_rd */ =
        {in_valid_i && !in_ready_o, take, 4'd0, take, 1'b0};
    wire unused = &{1'b0, p_x, p_y, p_z, r_x, r_y, r_z, n_16, n_2[11:0], slope_two_q[9:0],
                    vv_wait_d, h_wait_d, y_wait_d};
endmodule
`default_nettype wire
