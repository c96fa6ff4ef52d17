// f_filter.v - proof that rt_filter computes sph_filter(), for every input of the real width
// SPDX-License-Identifier: Apache-2.0
// The formula of cmodel/trace/filter.c in words that hold every value, one clock of it from what
// the lane had a clock before: no register loses a bit or has the wrong sign. Of u only that is
// needed that 16 |oc x u|^2 < 2^34, which is so for a unit vector (docs/blocks/filter.md). The
// square of the radius is that of s_square.v.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_fx.vh"
module f_filter #(
    parameter FW = 14
) (
    input wire                 clk,
    input wire signed [FW-1:0] org_x, org_y, org_z,
    input wire signed [17:0]   u_x, u_y, u_z,
    input wire [1:0]           axis,
    input wire                 negative,
    input wire [FW:0]          depth_max,
    input wire signed [13:0]   ctr_x, ctr_y, ctr_z,
    input wire [13:0]          rad
);
    wire pass;
    wire signed [15:0] near;
    rt_filter #(.FW(FW)) u_dut (
        .clk(clk), .in_org_x_i(org_x), .in_org_y_i(org_y), .in_org_z_i(org_z),
        .in_u_x_i(u_x), .in_u_y_i(u_y), .in_u_z_i(u_z), .in_axis_i(axis),
        .in_negative_i(negative), .in_depth_max_i(depth_max),
        .in_ctr_x_i(ctr_x), .in_ctr_y_i(ctr_y), .in_ctr_z_i(ctr_z), .in_rad_i(rad),
        .out_pass_o(pass), .out_near_o(near)
    );
    (* hierconn *) wire signed [14:0] \u_dut.s1_oc_x_q , \u_dut.s1_oc_y_q , \u_dut.s1_oc_z_q ;
    (* hierconn *) wire signed [17:0] \u_dut.s1_u_x_q , \u_dut.s1_u_y_q , \u_dut.s1_u_z_q ;
    (* hierconn *) wire signed [14:0] \u_dut.s1_rad_q , \u_dut.s2_rad_q , \u_dut.s3_rad_q ;
    (* hierconn *) wire [1:0]         \u_dut.s1_axis_q ;
    (* hierconn *) wire               \u_dut.s1_negative_q , \u_dut.s2_negative_q ;
    (* hierconn *) wire [FW:0]        \u_dut.s1_depth_max_q , \u_dut.s2_depth_max_q ;
    (* hierconn *) wire [FW:0]        \u_dut.s3_depth_max_q , \u_dut.s4_depth_max_q ;
    (* hierconn *) wire signed [32:0] \u_dut.s2_yz_q , \u_dut.s2_zy_q , \u_dut.s2_zx_q ;
    (* hierconn *) wire signed [32:0] \u_dut.s2_xz_q , \u_dut.s2_xy_q , \u_dut.s2_yx_q ;
    (* hierconn *) wire signed [14:0] \u_dut.s2_depth_q ;
    (* hierconn *) wire signed [33:0] \u_dut.s3_x_q , \u_dut.s3_y_q , \u_dut.s3_z_q ;
    (* hierconn *) wire signed [15:0] \u_dut.s3_depth_q ;
    (* hierconn *) wire signed [17:0] \u_dut.s4_x_q , \u_dut.s4_y_q , \u_dut.s4_z_q ;
    (* hierconn *) wire signed [15:0] \u_dut.s4_near_q , \u_dut.s5_near_q , \u_dut.s6_near_q ;
    (* hierconn *) wire               \u_dut.s4_behind_q , \u_dut.s5_ok_q , \u_dut.s6_ok_q ;
    (* hierconn *) wire signed [35:0] \u_dut.s5_xx_q , \u_dut.s5_yy_q , \u_dut.s5_zz_q ;
    (* hierconn *) wire [27:0]        \u_dut.s5_rad2_q ;
    (* hierconn *) wire [34:0]        \u_dut.s6_sum_q ;
    (* hierconn *) wire signed [35:0] \u_dut.s6_left_q ;

    // ---- what each stage must hold, from the stage before ----
    reg signed [39:0] oc_x, oc_y, oc_z, x, y, z, depth, near_4, end_4, r_x, r_y, r_z;
    reg signed [14:0] rad_1, depth_2;
    reg signed [32:0] yz, zy, zx, xz, xy, yx;
    reg signed [35:0] xx, yy, zz;
    reg signed [39:0] sum, left;
    reg               ok_5, ok_6, pass_7;
    reg signed [15:0] near_5, near_6, near_7;
    wire signed [39:0] w_xx = {4'd0, \u_dut.s5_xx_q }, w_yy = {4'd0, \u_dut.s5_yy_q };
    wire signed [39:0] w_zz = {4'd0, \u_dut.s5_zz_q }, w_rr = {8'd0, \u_dut.s5_rad2_q , 4'd0};
    always @(posedge clk) begin
        // 1: oc
        oc_x    <= ctr_x - org_x;
        oc_y    <= ctr_y - org_y;
        oc_z    <= ctr_z - org_z;
        rad_1   <= {1'b0, rad};
        // 2: products; 15 bits by 18 are 33
        yz      <= \u_dut.s1_oc_y_q * \u_dut.s1_u_z_q ;
        zy      <= \u_dut.s1_oc_z_q * \u_dut.s1_u_y_q ;
        zx      <= \u_dut.s1_oc_z_q * \u_dut.s1_u_x_q ;
        xz      <= \u_dut.s1_oc_x_q * \u_dut.s1_u_z_q ;
        xy      <= \u_dut.s1_oc_x_q * \u_dut.s1_u_y_q ;
        yx      <= \u_dut.s1_oc_y_q * \u_dut.s1_u_x_q ;
        depth_2 <= \u_dut.s1_axis_q == 0 ? \u_dut.s1_oc_x_q
                   : \u_dut.s1_axis_q == 1 ? \u_dut.s1_oc_y_q : \u_dut.s1_oc_z_q ;
        // 3: cross product, depth
        x       <= \u_dut.s2_yz_q - \u_dut.s2_zy_q ;
        y       <= \u_dut.s2_zx_q - \u_dut.s2_xz_q ;
        z       <= \u_dut.s2_xy_q - \u_dut.s2_yx_q ;
        depth   <= \u_dut.s2_negative_q ? -{{25{\u_dut.s2_depth_q [14]}}, \u_dut.s2_depth_q }
                                        : {{25{\u_dut.s2_depth_q [14]}}, \u_dut.s2_depth_q };
        // 4: sph_round(, 14), ends of the child
        r_x     <= ((\u_dut.s3_x_q >>> 13) + 40'sd1) >>> 1;
        r_y     <= ((\u_dut.s3_y_q >>> 13) + 40'sd1) >>> 1;
        r_z     <= ((\u_dut.s3_z_q >>> 13) + 40'sd1) >>> 1;
        near_4  <= \u_dut.s3_depth_q - \u_dut.s3_rad_q ;
        end_4   <= \u_dut.s3_depth_q + \u_dut.s3_rad_q ;
        // 5: squares of 18 bits are 36
        xx      <= \u_dut.s4_x_q * \u_dut.s4_x_q ;
        yy      <= \u_dut.s4_y_q * \u_dut.s4_y_q ;
        zz      <= \u_dut.s4_z_q * \u_dut.s4_z_q ;
        ok_5    <= end_4 >= 0 && near_4 <= $signed({1'b0, \u_dut.s4_depth_max_q });
        near_5  <= near_4;
        // 6, 7: xx + yy + zz <= 16 rad^2
        sum     <= w_xx + w_yy;
        left    <= w_rr - w_zz;
        ok_6    <= \u_dut.s5_ok_q ;
        near_6  <= \u_dut.s5_near_q ;
        pass_7  <= ok_6 && sum <= left;
        near_7  <= near_6;
    end

    // ---- the environment: centres of FW bits; |oc x u| as of a unit vector ----
    localparam signed [39:0] PART = 40'sd1 << 17;        // 16 |oc x u|^2 < 2^34
    localparam signed [39:0] FAR  = (40'sd1 << FW) - 40'sd1;
    reg [2:0] age_q = 3'd0;                              // stages that hold what came in
    always @(posedge clk) age_q <= age_q + (age_q != 7);
    always @* begin
        assume (ctr_x >= -(FAR >>> 1) - 1 && ctr_x <= FAR >>> 1);
        assume (ctr_y >= -(FAR >>> 1) - 1 && ctr_y <= FAR >>> 1);
        assume (ctr_z >= -(FAR >>> 1) - 1 && ctr_z <= FAR >>> 1);
        if (age_q >= 4) assume (r_x >= -PART && r_x < PART);
        if (age_q >= 4) assume (r_y >= -PART && r_y < PART);
        if (age_q >= 4) assume (r_z >= -PART && r_z < PART);
        if (age_q >= 5) assume (w_xx + w_yy + w_zz < PART * PART);
    end

    always @* begin
        if (age_q >= 1) begin
            assert (\u_dut.s1_oc_x_q == oc_x && oc_x >= -FAR && oc_x <= FAR);
            assert (\u_dut.s1_oc_y_q == oc_y && oc_y >= -FAR && oc_y <= FAR);
            assert (\u_dut.s1_oc_z_q == oc_z && oc_z >= -FAR && oc_z <= FAR);
            assert (\u_dut.s1_rad_q == rad_1 && rad_1 >= 0);
        end
        if (age_q >= 2) begin
            assert (\u_dut.s2_yz_q == yz && \u_dut.s2_zy_q == zy && \u_dut.s2_zx_q == zx);
            assert (\u_dut.s2_xz_q == xz && \u_dut.s2_xy_q == xy && \u_dut.s2_yx_q == yx);
            assert (\u_dut.s2_depth_q == depth_2 && depth_2 >= -FAR && depth_2 <= FAR);
            assert (\u_dut.s2_rad_q >= 0);
        end
        if (age_q >= 3) begin
            assert (\u_dut.s3_x_q == x && \u_dut.s3_y_q == y && \u_dut.s3_z_q == z);
            assert (\u_dut.s3_depth_q == depth && depth >= -FAR && depth <= FAR);
            assert (\u_dut.s3_rad_q >= 0);
        end
        if (age_q >= 4) begin
            assert (\u_dut.s4_x_q == r_x && \u_dut.s4_y_q == r_y && \u_dut.s4_z_q == r_z);
            assert (\u_dut.s4_near_q == near_4 && \u_dut.s4_behind_q == (end_4 < 0));
        end
        if (age_q >= 5) begin
            assert (\u_dut.s5_xx_q == xx && \u_dut.s5_yy_q == yy && \u_dut.s5_zz_q == zz);
            assert (\u_dut.s5_ok_q == ok_5 && \u_dut.s5_near_q == near_5);
        end
        if (age_q >= 6) begin
            assert ($signed({5'd0, \u_dut.s6_sum_q }) == sum && \u_dut.s6_left_q == left);
            assert (\u_dut.s6_ok_q == ok_6 && \u_dut.s6_near_q == near_6);
        end
        if (age_q == 7) assert (pass == pass_7 && near == near_7);
    end
endmodule
`default_nettype wire
