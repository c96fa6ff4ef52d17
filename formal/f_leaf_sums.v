// f_leaf_sums.v - proof that rt_leaf_sums has b and k of sph_leaf_test(), at widths of one piece
// SPDX-License-Identifier: Apache-2.0
// A leaf is taken in the first clock, none in the three behind it. Products are a function of their
// factors; sums are modulo 2^BW, 2^KW, which hold them (docs/model/number_formats.md).
`timescale 1ns / 1ps
`default_nettype none
module f_leaf_sums #(
    parameter W  = 16,
    parameter WD = 17
) (
    input wire            clk,
    input wire            take,
    input wire [3*W+2:0]  oc,
    input wire [W-1:0]    rad,
    input wire [3*WD-1:0] dir
);
    localparam BW = W + WD + 2, KW = 2*W + 3;
    wire [BW-1:0] b;
    wire [KW-1:0] k;
    rt_leaf_sums #(.W(W), .WD(WD)) u_dut (
        .clk(clk), .take_i(take), .oc_i(oc), .rad_i(rad), .dir_i(dir), .b_o(b), .k_o(k)
    );
    function signed [35:0] times(input signed [17:0] x, input signed [17:0] y); times = x * y;
    endfunction
    wire signed [17:0] r = $signed({1'b0, rad});
    wire signed [17:0] o_x = $signed(oc[0 +: W+1]), o_y = $signed(oc[W+1 +: W+1]),
                       o_z = $signed(oc[2*W+2 +: W+1]);
    wire signed [17:0] d_x = $signed(dir[0 +: WD]), d_y = $signed(dir[WD +: WD]),
                       d_z = $signed(dir[2*WD +: WD]);
    wire signed [35:0] p_x = times(o_x, d_x), p_y = times(o_y, d_y), p_z = times(o_z, d_z);
    wire signed [35:0] q_x = times(o_x, o_x), q_y = times(o_y, o_y), q_z = times(o_z, o_z),
                       q_r = times(r, r);
    reg [2:0]     age_q = 3'd0;
    reg [BW-1:0]  b_q;
    reg [KW-1:0]  k_q;
    always @(posedge clk) begin
        if (age_q != 7) age_q <= age_q + 1'b1;
        if (age_q == 0) begin
            b_q <= p_x[BW-1:0] + p_y[BW-1:0] + p_z[BW-1:0];
            k_q <= {KW{1'b0}} - q_x[KW-1:0] - q_y[KW-1:0] - q_z[KW-1:0] + q_r[KW-1:0];
        end
    end
    always @* begin
        assume (take == (age_q == 0) || age_q >= 4);
        if (age_q == 6) assert (b == b_q && k == k_q);
    end
endmodule
`default_nettype wire
