// f_build_bound.v - proof of rt_build_bound: a radius is not too small, by each of its roundings
// SPDX-License-Identifier: Apache-2.0
// From any state: the root of what was a sum of squares ROOT clocks ago, 1 more if it is not exact,
// is its square root rounded up; a reach is that and the radius; the most of a run is no less than
// the reach that came; filter units are no less than the most, but for spheres that are limited. So
// r 2^K - rad >= |c - ctr| for every leaf.
`timescale 1ns / 1ps
`default_nettype none
module f_build_bound #(
    parameter W  = 8,
    parameter FW = 6
) (
    input wire clk
);
    localparam ROOT = W + 1, K = W - FW, RW = W + 2;
    rt_build_bound #(.W(W), .FW(FW), .AB(4)) u_dut (
        .clk(clk), .rst(1'b0), .start_i(1'b0), .corner_i(1'b0), .whole_i(1'b0),
        .child_valid_i(1'b0), .child_i(9'd0), .a_leaf_i({(4*W){1'b0}}),
        .b_leaf_i({(4*W){1'b0}}), .b_mark_i(5'd0), .out_ready_i(1'b0)
    );
    (* hierconn *) wire [2*W+1:0] \u_dut.s3_sum_q ;
    (* hierconn *) wire [ROOT-1:0] \u_dut.g_digit[8].root_q ;
    (* hierconn *) wire [ROOT:0]   \u_dut.g_digit[8].rem_q ;
    (* hierconn *) wire [W+3:0]   \u_dut.beside ;
    (* hierconn *) wire [RW-1:0]  \u_dut.reach_q , \u_dut.most_q ;
    (* hierconn *) wire           \u_dut.reach_here_q , \u_dut.beyond ;
    (* hierconn *) wire [RW-K:0]  \u_dut.units_q , \u_dut.least ;
    reg  [4:0]     clocks_q = 5'd0;
    reg  [2*W+1:0] x_q;
    reg  [RW-1:0]  up_q, reach_q, most_q;
    reg  [W-1:0]   rad_q;
    reg            here_q;
    wire [RW-1:0]  up = \u_dut.g_digit[8].root_q + (\u_dut.g_digit[8].rem_q != 0);
    wire [2*RW-1:0] square = up * up;
    always @(posedge clk) begin
        clocks_q <= clocks_q + 1'b1;
        if (clocks_q == 0) x_q <= \u_dut.s3_sum_q ;
        up_q    <= up;
        rad_q   <= \u_dut.beside [W-1:0];
        reach_q <= \u_dut.reach_q ;
        here_q  <= \u_dut.reach_here_q ;
        most_q  <= \u_dut.most_q ;
    end
    always @* begin
        if (clocks_q == ROOT) assert (square >= x_q);
        if (clocks_q != 0) assert (\u_dut.reach_q == up_q + rad_q);
        if (clocks_q != 0 && here_q) assert (\u_dut.most_q >= reach_q);
        if (clocks_q != 0) assert (\u_dut.beyond || (\u_dut.least == \u_dut.units_q &&
                                                     {\u_dut.least , {K{1'b0}}} >= most_q));
    end
endmodule
`default_nettype wire
