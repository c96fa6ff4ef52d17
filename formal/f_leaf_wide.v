// f_leaf_wide.v - proof that rt_leaf computes sph_leaf_test(), at the widths of profiles
// SPDX-License-Identifier: Apache-2.0
// As f_leaf.v, but products are a function of their factors, and rt_multiply makes them at once.
// SUMS: b and k, modulo 2^VW, which holds them, a stage at a time. Without: what is made of any b
// and k; that they, a and disc keep their bounds (products.smt2, disc.smt2), is assumed.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_fx.vh"
module f_leaf_wide #(
    parameter W      = 16,
    parameter WD     = 17,
    parameter SHADOW = 1,
    parameter INSIDE = 1,
    parameter SUMS   = 0,
    parameter T_B    = 4,       // clock of b; k comes in the next
    parameter T      = 12       // latency
) (
    input wire                 clk,
    input wire                 in_valid,
    input wire                 on,
    input wire [1:0]           tag,
    input wire signed [W-1:0]  ctr_x, ctr_y, ctr_z, org_x, org_y, org_z,
    input wire [W-1:0]         rad,
    input wire [23:0]          id, skip_id,
    input wire signed [WD-1:0] dir_x, dir_y, dir_z,
    input wire [2*WD-1:0]      dir_dir,
    input wire                 shadow, skip_inside
);
    localparam INTERVAL = 2;
    localparam OW0 = W + 1 > WD ? W + 1 : WD;
    localparam OW = OW0 > 18 ? OW0 : 18; // factors of narrow products
    localparam L  = `RT_MUL_LATENCY(OW); // clocks of these
`include "leaf_dut.vh"

    // ---- b, then k of the leaf ----
    function signed [2*OW-1:0] times(input signed [OW-1:0] x, input signed [OW-1:0] y);
        times = x * y;
    endfunction
    wire signed [OW-1:0] oc_x = ctr_x - org_x, oc_y = ctr_y - org_y, oc_z = ctr_z - org_z;
    wire signed [OW-1:0] d_x  = dir_x, d_y = dir_y, d_z = dir_z, r = $signed({1'b0, rad});
    (* hierconn *) wire [VW-1:0] \u_dut.g_two.u_two.val_q ;
    wire signed [VW-1:0] val = \u_dut.g_two.u_two.val_q ;
    reg  signed [VW-1:0] b_q, k_q;
    always @(posedge clk) begin
        if (age_q == T_B)     b_q <= val;
        if (age_q == T_B + 1) k_q <= val;
    end
`include "leaf_test.vh"

    // ---- the sums: what each stage must hold, from the stage before; T clocks later ----
    (* hierconn *) wire [VW-1:0]   \u_dut.g_two.u_two.xy_q , \u_dut.g_two.u_two.z_q ;
    (* hierconn *) wire [2*OW-1:0] \u_dut.g_two.u_two.p_x , \u_dut.g_two.u_two.p_y ,
        \u_dut.g_two.u_two.p_z , \u_dut.g_two.u_two.p_rad ;
    wire signed [2*OW-1:0] p_x = \u_dut.g_two.u_two.p_x , p_y = \u_dut.g_two.u_two.p_y ,
                    p_z = \u_dut.g_two.u_two.p_z , p_r = \u_dut.g_two.u_two.p_rad ;
    wire [VW-1:0]   xy = \u_dut.g_two.u_two.xy_q , z = \u_dut.g_two.u_two.z_q ;
    reg  [2*OW-1:0] b_x, b_y, b_z, k_x, k_y, k_z, k_r;   // the model's products
    reg signed [VW-1:0] xy_1, z_1, val_1;
    reg             good_q = 1'b1;                       // until now
    always @(posedge clk) begin
        if (age_q == 0 && SUMS != 0) begin
            {b_x, b_y, b_z} <= {times(oc_x, d_x), times(oc_y, d_y), times(oc_z, d_z)};
            {k_x, k_y, k_z} <= {times(oc_x, oc_x), times(oc_y, oc_y), times(oc_z, oc_z)};
            k_r <= times(r, r);
        end
        xy_1  <= p_x + p_y;
        z_1   <= age_q == L + 1 ? p_z : p_r - p_z;
        val_1 <= age_q == L + 2 ? z + xy : z - xy;
        if (age_q == L + 1 && !(p_x == b_x && p_y == b_y && p_z == b_z)) good_q <= 1'b0;
        if (age_q == L + 2 && !(p_x == k_x && p_y == k_y && p_z == k_z && p_r == k_r))
            good_q <= 1'b0;
        if ((age_q == L + 2 || age_q == L + 3) && !(xy == xy_1 && z == z_1)) good_q <= 1'b0;
        if (age_q == L + 3 && val != val_1) good_q <= 1'b0;
    end
    always @* if (SUMS != 0 && age_q == L + 4) assert (good_q && val == val_1);
endmodule
`default_nettype wire
