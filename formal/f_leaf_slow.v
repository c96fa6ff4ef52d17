// f_leaf_slow.v - proof that rt_leaf with INTERVAL 4 computes sph_leaf_test(), widths of profiles
// SPDX-License-Identifier: Apache-2.0
// As f_leaf_wide.v without SUMS: what is made of any b, k and their disc (f_leaf_sums.v,
// f_leaf_disc.v); that they keep their bounds (products.smt2, disc.smt2), is assumed.
`timescale 1ns / 1ps
`default_nettype none
module f_leaf_slow #(
    parameter W      = 16,
    parameter WD     = 17,
    parameter SHADOW = 1,
    parameter INSIDE = 1,
    parameter T_B    = 7,       // clock of b and k
    parameter T      = 16       // latency
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
    localparam INTERVAL = 4, SUMS = 0;
`include "leaf_dut.vh"

    // ---- b and k of the leaf ----
    (* hierconn *) wire signed [BW-1:0] \u_dut.g_four.u_four.b_q ;
    (* hierconn *) wire signed [KW-1:0] \u_dut.g_four.u_four.k_q ;
    reg signed [BW-1:0]  b_q;
    reg signed [KW-1:0]  k_q;
    always @(posedge clk) if (age_q == T_B)
        {b_q, k_q} <= {\u_dut.g_four.u_four.b_q , \u_dut.g_four.u_four.k_q };
`include "leaf_test.vh"
endmodule
`default_nettype wire
