// f_bih_step.v - proof that the bounds of rt_bih_step are never too narrow, at the real width
// SPDX-License-Identifier: Apache-2.0
// One clock at a time, in words that hold every value: distances, products, what rounding up adds.
// Then, for any product: below upper * 2^shift, unless that says no bound, and not below
// lower * 2^shift. docs/design/bih.md says why that loses no hit.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module f_bih_step #(
    parameter W = 16
) (
    input wire                 clk,
    input wire signed [W-1:0]  org,
    input wire                 back, flat, open,
    input wire [5:0]           shift,
    input wire [`RT_BIH_G-1:0] g,
    input wire signed [W+1:0]  clip_l, clip_r
);
    localparam TW = `RT_BIH_T;
    localparam GW = `RT_BIH_G;
    localparam V  = W + 2 > `RT_BIH_V ? W + 2 - `RT_BIH_V : 0;
    localparam VW = W + 2 - V;
    localparam PW = VW + GW + 1;
    localparam X  = TW + 64;                         // bits of the exact words
    wire out_back, out_near, out_far;
    wire [TW-1:0] upper, lower;
    rt_bih_step #(.W(W)) u_dut (
        .clk(clk), .in_org_i(org), .in_back_i(back), .in_flat_i(flat), .in_open_i(open),
        .in_shift_i(shift), .in_g_i(g), .in_clip_l_i(clip_l), .in_clip_r_i(clip_r),
        .out_back_o(out_back), .out_near_o(out_near), .out_far_o(out_far),
        .out_upper_o(upper), .out_lower_o(lower)
    );
    (* hierconn *) wire signed [W+2:0]  \u_dut.s1_near_q , \u_dut.s1_far_q ;
    (* hierconn *) wire                 \u_dut.s1_back_q , \u_dut.s1_flat_q , \u_dut.s1_open_q ;
    (* hierconn *) wire [GW-1:0]        \u_dut.s1_g_q ;
    (* hierconn *) wire [5:0]           \u_dut.s1_shift_q , \u_dut.s2_shift_q , \u_dut.s3_shift_q ;
    (* hierconn *) wire [VW+GW-1:0]     \u_dut.s2_near_q , \u_dut.s2_far_q , \u_dut.s3_far_q ;
    (* hierconn *) wire [PW-1:0]        \u_dut.s2_more_q , \u_dut.s3_near_q ;

    // ---- what each stage must hold, from the stage before ----
    reg signed [W+3:0] near_1, far_1;
    reg [VW+GW-1:0]    p_near_2, p_far_2, p_far_3;
    reg [PW:0]         more_2, sum_3;
    reg [5:0]          shift_2, shift_3, shift_4, shift_5;
    reg [PW-1:0]       near_4, near_5;               // products, and their flags beside them
    reg [VW+GW-1:0]    far_4, far_5;
    reg [4:0]          side_2, side_3, side_4, side_5;
    wire signed [W+2:0] v_near = \u_dut.s1_near_q , v_far = \u_dut.s1_far_q ;
    wire [V:0]         low = {v_near, 1'b0} & ((1 << (V + 1)) - 1);
    wire [VW:0]        up  = v_near[W+1:V] + (low != 0);
    always @(posedge clk) begin
        near_1   <= back ? org - clip_r : clip_l - org;
        far_1    <= back ? org - clip_l : clip_r - org;
        p_near_2 <= v_near[W+1:V] * \u_dut.s1_g_q ;
        p_far_2  <= v_far[W+1:V] * \u_dut.s1_g_q ;
        more_2   <= 2*up + (low != 0 ? \u_dut.s1_g_q : 0);  // up*(g+2) less v*g
        shift_2  <= \u_dut.s1_shift_q ;
        side_2   <= {\u_dut.s1_back_q , v_near >= 0, v_far > 0, \u_dut.s1_flat_q ,
                     \u_dut.s1_open_q };
        sum_3    <= \u_dut.s2_near_q + \u_dut.s2_more_q ;
        p_far_3  <= \u_dut.s2_far_q ;
        shift_3  <= \u_dut.s2_shift_q ;
        side_3   <= side_2;
        near_4   <= \u_dut.s3_near_q ;
        far_4    <= \u_dut.s3_far_q ;
        shift_4  <= \u_dut.s3_shift_q ;
        side_4   <= side_3;
        near_5   <= near_4;
        far_5    <= far_4;
        shift_5  <= shift_4;
        side_5   <= side_4;
    end
    wire t_back, t_near, t_far, t_flat, t_open;
    assign {t_back, t_near, t_far, t_flat, t_open} = side_5;
    wire [X-1:0] near = near_5, far = far_5, above = upper, below = lower;

    reg [2:0] age_q = 3'd0;                          // stages that hold what came in
    always @(posedge clk) age_q <= age_q + (age_q != 5);
    always @* begin
        if (age_q >= 1) assert (\u_dut.s1_near_q == near_1 && \u_dut.s1_far_q == far_1);
        if (age_q >= 2) begin
            assert (\u_dut.s2_near_q == p_near_2 && \u_dut.s2_far_q == p_far_2);
            if (side_2[3]) assert (\u_dut.s2_more_q == more_2);
            assert (\u_dut.s2_shift_q == shift_2);
        end
        if (age_q >= 3) begin
            if (side_3[3]) assert (\u_dut.s3_near_q == sum_3[PW-1:0]);
            assert (\u_dut.s3_far_q == p_far_3 && \u_dut.s3_shift_q == shift_3);
        end
        if (age_q >= 5) begin
            assert (out_back == t_back && out_near == t_near && out_far == (!t_flat || !t_far));
            if (upper != {TW{1'b1}}) assert (!t_flat && !t_open && near < above << shift_5);
            if (t_flat || !t_far) assert (lower == 0);
            else assert (below << shift_5 <= far);
        end
    end
endmodule
`default_nettype wire
