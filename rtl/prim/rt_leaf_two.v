// rt_leaf_two.v - b, k, disc and the signs of rt_leaf, a leaf every second clock
// SPDX-License-Identifier: Apache-2.0
//   b = oc.dir    k = rad^2 - oc.oc    disc = k*a + b*b
// Each multiplier serves two clocks of a leaf:
//   1,2 operands (oc,dir) (oc,oc) | L products | 2 sums: b, k | 1 operands (b,b) (k,a) | M products
//   1 sum: disc                   L, M = `RT_MUL_LATENCY of the operands' widths
// Model: sph_leaf_test() in cmodel/prim/sphere.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
`include "rt_fx.vh"
module rt_leaf_two #(
    parameter W  = 16,                           // coordinate, bits
    parameter WD = 17,                           // direction component, bits
    parameter T_DISC = 10                        // the clock of a leaf in which disc stands
) (
    input  wire               clk,
    input  wire               take_i,            // clock 0 of a leaf
    input  wire [T_DISC-1:0]  valid_i,           // bit t: its clock t
    input  wire [3*W+2:0]     oc_i,              // 3 x s(W+1), clock 0
    input  wire [W-1:0]       rad_i,             // uW, clock 0
    input  wire [3*WD-1:0]    dir_i,             // 3 x sWD, clock 0
    input  wire [2*WD-1:0]    a_i,               // u(2WD), clocks T_B and T_B+1
    output wire [W+WD+1:0]    b_o,               // s(W+WD+2), clock T_B = L + 3
    output wire               b_pos_o,           // b > 0, clock T_B+2 as all signs
    output wire               b_short_o,         // b < a
    output wire               k_pos_o,           // k > 0
    output wire               k_neg_o,           // k < 0
    output wire               light_out_o,       // k + 2b - a < 0
    output wire               light_in_o,        // k + 2b - a > 0
    output wire [2*W+2*WD+1:0] disc_o            // clock T_DISC
);
    localparam OW0 = W + 1 > WD ? W + 1 : WD;
    localparam OW  = OW0 > 18 ? OW0 : 18;        // operands of the narrow multipliers
    localparam BW  = W + WD + 2;                 // |b| <= 3 * (2^W-1) * 2^(WD-1)
    localparam KW  = 2*W + 3;                    // -3 * (2^W-1)^2 <= k <= (2^W-1)^2
    localparam VW  = KW > BW ? KW : BW;          // k or b
    localparam NW  = VW > 2*WD + 1 ? VW : 2*WD + 1;  // operands of the wide multiplier
    localparam DW  = 2*W + 2*WD + 2;             // -2^(DW-1) < disc < 2^(DW-2): sums wrap rightly
    localparam MW  = (W > WD - 1 ? W : WD - 1) + 1;  // |oc - dir| < 2^MW a component
    localparam LW  = 2*MW + 3;                   // rad^2 - |oc - dir|^2
    localparam AW  = (BW > 2*WD ? BW : 2*WD) + 2;    // b - a
    localparam L   = `RT_MUL_LATENCY(OW);
    localparam T_B = L + 3;                      // b; k one clock later
    `RT_CHECK(OW <= 35, rt_leaf_two_W_and_WD_must_be_below_36)

    // ---- operands: (oc, dir) in clock 1, (oc, oc) in clock 2 ----
    reg signed [W:0]    oc_x_q, oc_y_q, oc_z_q;  // s(W+1)
    reg signed [OW-1:0] op_x_q, op_y_q, op_z_q;  // dir, then oc
    reg [W-1:0]         rad_q;                   // uW
    wire signed [OW-1:0] oc_x = {{(OW-W-1){oc_x_q[W]}}, oc_x_q};
    wire signed [OW-1:0] oc_y = {{(OW-W-1){oc_y_q[W]}}, oc_y_q};
    wire signed [OW-1:0] oc_z = {{(OW-W-1){oc_z_q[W]}}, oc_z_q};
    wire signed [OW-1:0] rad  = {{(OW-W){1'b0}}, rad_q};
    wire [WD-1:0] dir_x = dir_i[0 +: WD], dir_y = dir_i[WD +: WD], dir_z = dir_i[2*WD +: WD];
    always @(posedge clk) begin
        if (valid_i[1]) begin
            op_x_q <= oc_x;
            op_y_q <= oc_y;
            op_z_q <= oc_z;
        end
        if (take_i) begin
            oc_x_q <= $signed(oc_i[0 +: W+1]);
            oc_y_q <= $signed(oc_i[W+1 +: W+1]);
            oc_z_q <= $signed(oc_i[2*W+2 +: W+1]);
            op_x_q <= {{(OW-WD){dir_x[WD-1]}}, dir_x};
            op_y_q <= {{(OW-WD){dir_y[WD-1]}}, dir_y};
            op_z_q <= {{(OW-WD){dir_z[WD-1]}}, dir_z};
            rad_q  <= rad_i;
        end
    end

    // ---- products in clocks L+1, L+2; rad^2 in both ----
    wire signed [2*OW-1:0] p_x, p_y, p_z, p_rad;
    rt_multiply #(.W(OW)) u_mul_x (
        .clk(clk), .in_valid_i(|valid_i[2:1]), .a_i(oc_x), .b_i(op_x_q), .p_o(p_x)
    );
    rt_multiply #(.W(OW)) u_mul_y (
        .clk(clk), .in_valid_i(|valid_i[2:1]), .a_i(oc_y), .b_i(op_y_q), .p_o(p_y)
    );
    rt_multiply #(.W(OW)) u_mul_z (
        .clk(clk), .in_valid_i(|valid_i[2:1]), .a_i(oc_z), .b_i(op_z_q), .p_o(p_z)
    );
    rt_multiply #(.W(OW)) u_mul_rad (
        .clk(clk), .in_valid_i(|valid_i[2:1]), .a_i(rad), .b_i(rad), .p_o(p_rad)
    );

    // ---- sums: b = (x + y) + z in clock T_B, k = (rad^2 - z) - (x + y) in the next ----
    // -v = ~v + 1; the 1 is the carry into an extra bit at the bottom.
    localparam PW = 2*OW;
    localparam EW = VW > PW ? VW : PW;           // products as they are, sums need VW bits of them
    wire [EW-1:0] e_x   = {{(EW-PW+1){p_x[PW-1]}},   p_x[PW-2:0]};
    wire [EW-1:0] e_y   = {{(EW-PW+1){p_y[PW-1]}},   p_y[PW-2:0]};
    wire [EW-1:0] e_z   = {{(EW-PW+1){p_z[PW-1]}},   p_z[PW-2:0]};
    wire [EW-1:0] e_rad = {{(EW-PW+1){p_rad[PW-1]}}, p_rad[PW-2:0]};
    wire          z_sub  = valid_i[L+2];
    wire          xy_sub = valid_i[L+3];
    reg  [VW-1:0] xy_q, z_q;
    reg  [VW-1:0] val_q;                         // b in clock T_B, k in T_B+1
    wire [VW:0]   z_sum  = {z_sub ? e_rad[VW-1:0] : {VW{1'b0}}, 1'b1}
                         + {e_z[VW-1:0] ^ {VW{z_sub}}, z_sub};
    wire [VW:0]   xy_sum = {z_q, 1'b1} + {xy_q ^ {VW{xy_sub}}, xy_sub};
    always @(posedge clk) begin
        if (|valid_i[L+2:L+1]) begin
            xy_q <= e_x[VW-1:0] + e_y[VW-1:0];
            z_q  <= z_sum[VW:1];
        end
        if (|valid_i[T_B:T_B-1]) val_q <= xy_sum[VW:1];
    end

    // ---- wide operands: (b, b) in clock T_B+1, (k, a) in clock T_B+2 ----
    reg  signed [NW-1:0]   wide_a_q, wide_b_q;
    wire signed [2*NW-1:0] p_wide;
    wire signed [NW-1:0]   val = {{(NW-VW+1){val_q[VW-1]}}, val_q[VW-2:0]};
    always @(posedge clk) if (|valid_i[T_B+1:T_B]) begin // else nothing switches behind them
        wide_a_q <= val;
        wide_b_q <= valid_i[T_B+1] ? $signed({{(NW-2*WD){1'b0}}, a_i}) : val;
    end
    rt_multiply #(.W(NW)) u_mul_wide (
        .clk(clk), .in_valid_i(|valid_i[T_B+2:T_B+1]),
        .a_i(wide_a_q), .b_i(wide_b_q), .p_o(p_wide)
    );

    // ---- signs of b, k, b - a, k_light = k + 2b - a = rad^2 - |light - ctr|^2 ----
    reg                  b_pos_q, b_short_q;     // b > 0, b < a, in clock T_B+1
    reg                  bb_pos_q, bb_short_q;   // the same in clock T_B+2
    reg                  k_pos_q, k_neg_q;       // in clock T_B+2
    reg  signed [LW-1:0] part_q, light_q;        // 2b - a in T_B+1, k_light in T_B+2
    wire signed [LW-1:0] val_l = {{(LW-VW){val_q[VW-1]}}, val_q};
    wire signed [LW-1:0] a_l   = {{(LW-2*WD){1'b0}}, a_i};
    wire signed [AW-1:0] b_a   = $signed({{(AW-BW){val_q[BW-1]}}, val_q[BW-1:0]})
                               - $signed({{(AW-2*WD){1'b0}}, a_i});
    wire                 val_pos = !val_q[VW-1] && val_q != {VW{1'b0}};
    always @(posedge clk) begin
        b_pos_q    <= val_pos;
        b_short_q  <= b_a[AW-1];
        if (valid_i[T_B]) part_q <= (val_l <<< 1) - a_l;
        bb_pos_q   <= b_pos_q;
        bb_short_q <= b_short_q;
        k_pos_q    <= val_pos;
        k_neg_q    <= val_q[VW-1];
        if (valid_i[T_B+1]) light_q <= val_l + part_q;
    end
    assign b_o         = val_q[BW-1:0];
    assign b_pos_o     = bb_pos_q;
    assign b_short_o   = bb_short_q;
    assign k_pos_o     = k_pos_q;
    assign k_neg_o     = k_neg_q;
    assign light_out_o = light_q[LW-1];
    assign light_in_o  = !light_q[LW-1] && light_q != {LW{1'b0}};

    // ---- disc: b*b, then k*a added, in clock T_DISC ----
    reg [DW-1:0] disc_q;
    always @(posedge clk) if (|valid_i[T_DISC-1:T_DISC-2])
        disc_q <= p_wide[DW-1:0] + (valid_i[T_DISC-1] ? disc_q : {DW{1'b0}});
    assign disc_o = disc_q;

    wire unused = &{1'b0, e_x, e_y, e_z, e_rad, z_sum[0], xy_sum[0], p_wide, b_a[AW-2:0], valid_i};
endmodule
`default_nettype wire
