// f_filter.v - proof that rt_filter computes sph_filter(), for every input of the real width
// SPDX-License-Identifier: Apache-2.0
// The formula of cmodel/trace/filter.c in words that hold every value, one clock of it from what
// the lane had a clock before: no register loses a bit or has the wrong sign. Of the axes only that
// is needed that (oc.p)^2 + (oc.q)^2 < 2^30, which is so for those of rt_across
// (docs/design/traversal.md). That the product of 2 rad - q and 2 rad + q is 4 rad^2 - q^2, and how
// large, are lemmas of products.smt2.
`timescale 1ns / 1ps
`default_nettype none
module f_filter #(
    parameter FW = 14
) (
    input wire                 clk,
    input wire signed [FW-1:0] org_x, org_y, org_z,
    input wire [1:0]           least,
    input wire signed [17:0]   p_a, p_b, q_x, q_y, q_z,
    input wire [1:0]           axis,
    input wire                 negative,
    input wire [FW:0]          depth_max,
    input wire signed [13:0]   ctr_x, ctr_y, ctr_z,
    input wire [13:0]          rad
);
    wire pass;
    wire signed [15:0] near;
    rt_filter #(.FW(FW)) u_dut (
        .clk(clk), .in_valid_i(1'b1),
        .in_org_x_i(org_x), .in_org_y_i(org_y), .in_org_z_i(org_z),
        .in_least_i(least), .s1_p_a_i(p_a), .s1_p_b_i(p_b),
        .s1_q_x_i(q_x), .s1_q_y_i(q_y), .s1_q_z_i(q_z), .in_axis_i(axis),
        .in_negative_i(negative), .in_depth_max_i(depth_max),
        .in_ctr_x_i(ctr_x), .in_ctr_y_i(ctr_y), .in_ctr_z_i(ctr_z), .in_rad_i(rad),
        .out_pass_o(pass), .out_near_o(near)
    );
    (* hierconn *) wire [7:1]         \u_dut.live_q ;
    (* hierconn *) wire signed [14:0] \u_dut.s1_oc_x_q , \u_dut.s1_oc_y_q , \u_dut.s1_oc_z_q ;
    (* hierconn *) wire signed [14:0] \u_dut.s2_oc_x_q , \u_dut.s2_oc_y_q , \u_dut.s2_oc_z_q ;
    (* hierconn *) wire signed [14:0] \u_dut.s2_oc_a_q , \u_dut.s2_oc_b_q , \u_dut.s2_depth_q ;
    (* hierconn *) wire signed [17:0] \u_dut.s2_p_a_q , \u_dut.s2_p_b_q ;
    (* hierconn *) wire signed [17:0] \u_dut.s2_q_x_q , \u_dut.s2_q_y_q , \u_dut.s2_q_z_q ;
    (* hierconn *) wire [1:0]         \u_dut.s1_axis_q , \u_dut.s1_least_q ;
    (* hierconn *) wire               \u_dut.s2_negative_q ;
    (* hierconn *) wire [13:0]        \u_dut.s3_rad_q ;
    (* hierconn *) wire [FW:0]        \u_dut.s4_depth_max_q ;
    (* hierconn *) wire signed [32:0] \u_dut.s3_pa_q , \u_dut.s3_pb_q , \u_dut.s3_qx_q ;
    (* hierconn *) wire signed [32:0] \u_dut.s3_qy_q , \u_dut.s3_qz_q , \u_dut.s4_qz_q ;
    (* hierconn *) wire signed [15:0] \u_dut.s3_depth_q , \u_dut.s4_near_q , \u_dut.s5_near_q ;
    (* hierconn *) wire signed [33:0] \u_dut.s4_p_q , \u_dut.s4_q_q , \u_dut.s5_p_q ;
    (* hierconn *) wire signed [33:0] \u_dut.s5_q_q ;
    (* hierconn *) wire               \u_dut.s4_behind_q , \u_dut.s5_ok_q , \u_dut.s6_ok_q ;
    (* hierconn *) wire               \u_dut.g_multipliers.s7_ok_q ;
    (* hierconn *) wire [15:0]        \u_dut.s6_p_q , \u_dut.s6_q_q ;
    (* hierconn *) wire [13:0]        \u_dut.s6_rad_q ;
    (* hierconn *) wire [15:0]        \u_dut.g_multipliers.s7_p_q ;
    (* hierconn *) wire signed [16:0] \u_dut.g_multipliers.s7_less_q ;
    (* hierconn *) wire [16:0]        \u_dut.g_multipliers.s7_more_q ;
    (* hierconn *) wire [31:0]        \u_dut.left_pp_q ;
    (* hierconn *) wire signed [15:0] \u_dut.near , \u_dut.left_near_q ;
    (* hierconn *) wire signed [32:0] \u_dut.left_q ;
    (* hierconn *) wire               \u_dut.left_ok_q ;

    // ---- what each stage must hold, from the stage before ----
    reg signed [39:0] oc_x, oc_y, oc_z, p, q, sum, depth, near_4, end_4, cut_p, cut_q;
    reg signed [39:0] less, more, p_7;
    reg signed [14:0] oc_a, oc_b, depth_2;
    reg signed [32:0] pa, pb, qx, qy, qz;
    reg signed [32:0] left;
    reg        [31:0] pp_8;
    reg               ok_5, ok_7, ok_8, pass_9;
    reg signed [15:0] near_5, near_8, near_9;
    wire signed [17:0] more_7 = {1'b0, \u_dut.g_multipliers.s7_more_q };
    wire [39:0]        w_rad  = {25'd0, \u_dut.s6_rad_q , 1'b0}, w_q = {24'd0, \u_dut.s6_q_q };
    wire signed [39:0] floor_p = \u_dut.s5_p_q >>> 16, floor_q = \u_dut.s5_q_q >>> 16;
    always @(posedge clk) begin
        // 1: oc
        oc_x    <= ctr_x - org_x;
        oc_y    <= ctr_y - org_y;
        oc_z    <= ctr_z - org_z;
        // 2: those of p, that of the largest
        oc_a    <= \u_dut.s1_least_q == 0 ? \u_dut.s1_oc_y_q : \u_dut.s1_oc_x_q ;
        oc_b    <= \u_dut.s1_least_q == 2 ? \u_dut.s1_oc_y_q : \u_dut.s1_oc_z_q ;
        depth_2 <= \u_dut.s1_axis_q == 0 ? \u_dut.s1_oc_x_q
                   : \u_dut.s1_axis_q == 1 ? \u_dut.s1_oc_y_q : \u_dut.s1_oc_z_q ;
        // 3: products; 15 bits by 18 are 33
        pa      <= \u_dut.s2_oc_a_q * \u_dut.s2_p_a_q ;
        pb      <= \u_dut.s2_oc_b_q * \u_dut.s2_p_b_q ;
        qx      <= \u_dut.s2_oc_x_q * \u_dut.s2_q_x_q ;
        qy      <= \u_dut.s2_oc_y_q * \u_dut.s2_q_y_q ;
        qz      <= \u_dut.s2_oc_z_q * \u_dut.s2_q_z_q ;
        depth   <= \u_dut.s2_negative_q ? -{{25{\u_dut.s2_depth_q [14]}}, \u_dut.s2_depth_q }
                                        : {{25{\u_dut.s2_depth_q [14]}}, \u_dut.s2_depth_q };
        // 4, 5: oc.p, oc.q, ends of the child
        p       <= \u_dut.s3_pa_q - \u_dut.s3_pb_q ;
        q       <= \u_dut.s3_qx_q + \u_dut.s3_qy_q ;
        near_4  <= \u_dut.s3_depth_q - $signed({2'd0, \u_dut.s3_rad_q });
        end_4   <= \u_dut.s3_depth_q + $signed({2'd0, \u_dut.s3_rad_q });
        sum     <= \u_dut.s4_q_q + \u_dut.s4_qz_q ;
        ok_5    <= end_4 >= 0 && near_4 <= $signed({1'b0, \u_dut.s4_depth_max_q });
        near_5  <= near_4;
        // 6, 7: cut; 2 rad less and more
        cut_p   <= floor_p < 0 ? -floor_p - 1 : floor_p;
        cut_q   <= floor_q < 0 ? -floor_q - 1 : floor_q;
        p_7     <= {24'd0, \u_dut.s6_p_q };
        less    <= w_rad - w_q;
        more    <= w_rad + w_q;
        ok_7    <= \u_dut.s6_ok_q && w_q <= w_rad;   // else nothing passes, and 7 is not loaded
        // 8, 9: pp <= 4 rad^2 - qq
        left    <= \u_dut.g_multipliers.s7_less_q * more_7;
        pp_8    <= \u_dut.g_multipliers.s7_p_q * \u_dut.g_multipliers.s7_p_q ;
        ok_8    <= \u_dut.g_multipliers.s7_ok_q ;
        near_8  <= \u_dut.near ;
        pass_9  <= \u_dut.left_ok_q && $signed({8'd0, \u_dut.left_pp_q }) <= \u_dut.left_q ;
        near_9  <= near_8;
    end

    // ---- the environment: centres of FW bits; |oc.p| and |oc.q| as of axes across a ray ----
    localparam signed [39:0] PART = 40'sd1 << 32;        // 2^17 |oc.p| < 2^32
    localparam signed [39:0] FAR  = (40'sd1 << FW) - 40'sd1;
    reg [3:0] age_q = 4'd0;                              // stages that hold what came in
    always @(posedge clk) age_q <= age_q + (age_q != 9);
    always @* begin
        assume (ctr_x >= -(FAR >>> 1) - 1 && ctr_x <= FAR >>> 1);
        assume (ctr_y >= -(FAR >>> 1) - 1 && ctr_y <= FAR >>> 1);
        assume (ctr_z >= -(FAR >>> 1) - 1 && ctr_z <= FAR >>> 1);
        if (age_q >= 5) assume (\u_dut.s5_p_q >= -PART && \u_dut.s5_p_q < PART);
        if (age_q >= 5) assume (sum >= -PART && sum < PART);
    end

    integer k;
    always @* begin
        for (k = 1; k <= 7; k = k + 1) if (age_q >= k) assert (\u_dut.live_q [k]);
        if (age_q >= 1) begin
            assert (\u_dut.s1_oc_x_q == oc_x && oc_x >= -FAR && oc_x <= FAR);
            assert (\u_dut.s1_oc_y_q == oc_y && oc_y >= -FAR && oc_y <= FAR);
            assert (\u_dut.s1_oc_z_q == oc_z && oc_z >= -FAR && oc_z <= FAR);
        end
        if (age_q >= 2) begin
            assert (\u_dut.s2_oc_a_q == oc_a && \u_dut.s2_oc_b_q == oc_b);
            assert (\u_dut.s2_depth_q == depth_2 && depth_2 >= -FAR && depth_2 <= FAR);
        end
        if (age_q >= 3) begin
            assert (\u_dut.s3_pa_q == pa && \u_dut.s3_pb_q == pb);
            assert (\u_dut.s3_qx_q == qx && \u_dut.s3_qy_q == qy && \u_dut.s3_qz_q == qz);
            assert (\u_dut.s3_depth_q == depth && depth >= -FAR && depth <= FAR);
        end
        if (age_q >= 4) begin
            assert (\u_dut.s4_p_q == p && \u_dut.s4_q_q == q);
            assert (\u_dut.s4_near_q == near_4 && \u_dut.s4_behind_q == (end_4 < 0));
        end
        if (age_q >= 5) begin
            assert (\u_dut.s5_q_q == sum);
            assert (\u_dut.s5_ok_q == ok_5 && \u_dut.s5_near_q == near_5);
        end
        if (age_q >= 6) begin
            assert ($signed({24'd0, \u_dut.s6_p_q }) == cut_p);
            assert ($signed({24'd0, \u_dut.s6_q_q }) == cut_q);
        end
        if (age_q >= 7) begin
            assert (\u_dut.g_multipliers.s7_ok_q == ok_7);
            assert (!ok_7 || $signed({24'd0, \u_dut.g_multipliers.s7_p_q }) == p_7);
            assert (!ok_7 || $signed({23'd0, \u_dut.g_multipliers.s7_less_q }) == less);
            assert (!ok_7 || $signed({23'd0, \u_dut.g_multipliers.s7_more_q }) == more);
        end
        if (age_q >= 8) begin
            assert (!ok_8 || (\u_dut.left_q == left && \u_dut.left_pp_q == pp_8));
            assert (\u_dut.left_ok_q == ok_8 && \u_dut.left_near_q == near_8);
        end
        if (age_q == 9) assert (pass == pass_9 && near == near_9);
    end

endmodule
`default_nettype wire
