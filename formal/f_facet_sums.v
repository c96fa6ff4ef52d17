// f_facet_sums.v - proof that rt_facet_sums has N and the sums of sph_facet_test(), real widths
// SPDX-License-Identifier: Apache-2.0
// A facet is taken in the first clock, others at any time INTERVAL clocks apart. Products are a
// function of their factors, sums are modulo 2^CW and 2^VW, which hold them
// (docs/design/primitives.md);
// N and m = dir x A0 first, and from what they are det, num, U2 and V.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_fx.vh"
`include "rt_facet.vh"
module f_facet_sums #(
    parameter W  = 16,
    parameter WD = 17,
    parameter VW = 51,
    parameter INTERVAL = 2                           // or 4
) (
    input wire            clk,
    input wire            take, plane,
    input wire [71:0]     v0, v1, v2,
    input wire [3*W-1:0]  org,
    input wire [3*WD-1:0] dir
);
    localparam NW = `RT_FACET_NARROW(W, WD);
    localparam CW = `RT_FACET_WIDE(W, WD);
    localparam N  = `RT_FACET_NORMAL(W, WD, INTERVAL);       // clocks until N
    localparam M  = N + INTERVAL / 2;                // until m
    localparam T  = `RT_FACET_SUMS_LATENCY(W, WD, INTERVAL); // until the sums
    wire [3*CW-1:0] n;
    wire signed [VW-1:0] det, num, u2, v;
    reg [3:0] age_q = 4'd0;
    rt_facet_sums #(.W(W), .WD(WD), .INTERVAL(INTERVAL), .VW(VW)) u_dut (
        .clk(clk), .take_i(take), .plane_i(plane), .v0_i(v0), .v1_i(v1), .v2_i(v2), .org_i(org),
        .dir_i(dir), .n_o(n), .det_o(det), .num_o(num), .u2_o(u2), .v_o(v)
    );
    always @(posedge clk) if (age_q != 15) age_q <= age_q + 1'b1;
    // the facet is taken; none in the clocks before and behind it
    (* hierconn *) wire [N+1:1] \u_dut.at_q ;
    always @* begin
        if (age_q == 0) assume (take && \u_dut.at_q [INTERVAL-1:1] == 0);
        if (age_q > 0 && age_q < INTERVAL) assume (!take);
    end

    // ---- the model: A0, e1, e2, dir, given normal ----
    function signed [2*NW-1:0] times(input signed [NW-1:0] x, input signed [NW-1:0] y);
        times = x * y;
    endfunction
    function signed [CW+NW-1:0] times_wide(input signed [CW-1:0] x, input signed [NW-1:0] y);
        times_wide = x * y;
    endfunction
    reg               plane_q;
    reg [3*NW-1:0]    a0_q, e1_q, e2_q, dir_q;
    reg [71:0]        given_q;
    wire [3*CW-1:0]   cross_n, cross_m, normal;
    reg  [3*CW-1:0]   n_q, m_q;                      // as the module has them
    wire [3*VW-1:0]   by_dir, by_a0, by_e1, by_e2;   // products of n_q and m_q
    genvar i;
    generate
        for (i = 0; i < 3; i = i + 1) begin : g_axis
            localparam Y = (i + 1) % 3, Z = (i + 2) % 3;
            wire signed [W-1:0]  p0 = v0[24*i +: W], p1 = v1[24*i +: W], p2 = v2[24*i +: W];
            wire signed [W-1:0]  o = org[W*i +: W];
            wire signed [WD-1:0] d = dir[WD*i +: WD];
            wire signed [NW-1:0] a0 = p0 - o, e1 = p1 - p0, e2 = p2 - p0, dd = d;
            always @(posedge clk)
                if (age_q == 0) begin
                    a0_q[NW*i +: NW]  <= a0;
                    e1_q[NW*i +: NW]  <= e1;
                    e2_q[NW*i +: NW]  <= e2;
                    dir_q[NW*i +: NW] <= dd;
                end
            wire signed [CW+2*NW-1:0] n_1 = times(e1_q[NW*Y +: NW], e2_q[NW*Z +: NW]),
                                      n_2 = times(e1_q[NW*Z +: NW], e2_q[NW*Y +: NW]),
                                      m_1 = times(dir_q[NW*Y +: NW], a0_q[NW*Z +: NW]),
                                      m_2 = times(dir_q[NW*Z +: NW], a0_q[NW*Y +: NW]);
            wire signed [23:0]   given = given_q[24*i +: 24];
            wire signed [CW-1:0] given_n = given;
            assign cross_n[CW*i +: CW] = n_1[CW-1:0] - n_2[CW-1:0];
            assign cross_m[CW*i +: CW] = m_1[CW-1:0] - m_2[CW-1:0];
            assign normal[CW*i +: CW]  = plane_q ? given_n : cross_n[CW*i +: CW];
            wire signed [CW-1:0] n_i = n_q[CW*i +: CW], m_i = m_q[CW*i +: CW];
            wire signed [VW+CW+NW-1:0] w_dir = times_wide(n_i, dir_q[NW*i +: NW]),
                                       w_a0  = times_wide(n_i, a0_q[NW*i +: NW]),
                                       w_e1  = times_wide(m_i, e1_q[NW*i +: NW]),
                                       w_e2  = times_wide(m_i, e2_q[NW*i +: NW]);
            assign by_dir[VW*i +: VW] = w_dir[VW-1:0];
            assign by_a0[VW*i +: VW]  = w_a0[VW-1:0];
            assign by_e1[VW*i +: VW]  = w_e1[VW-1:0];
            assign by_e2[VW*i +: VW]  = w_e2[VW-1:0];
        end
    endgenerate
    function [VW-1:0] sum(input [3*VW-1:0] x);
        sum = (x[0 +: VW] + x[VW +: VW]) + x[2*VW +: VW];
    endfunction
    reg good_q = 1'b1;
    always @(posedge clk) begin
        if (age_q == 0) {plane_q, given_q} <= {plane, v1};
        if (age_q == N) n_q <= n;                    // its normal leaves now, too
        if (age_q == M) m_q <= n;
        if (age_q == N && n != normal) good_q <= 1'b0;
        if (age_q == M && n != cross_m) good_q <= 1'b0;
    end
    always @* if (age_q == T) begin
        assert (good_q);
        assert (det == sum(by_dir) && num == sum(by_a0) && u2 == sum(by_e1) && v == sum(by_e2));
    end
endmodule
`default_nettype wire
