// f_leaf_sums.v - proof that rt_leaf_sums has b and k of sph_leaf_test()
// SPDX-License-Identifier: Apache-2.0
// A leaf is taken in the first clock, none in the three behind it. Products are a function of their
// factors; sums are modulo 2^BW, 2^KW, which hold them (docs/reference/machine_file.md). Of two
// pieces a number is 2^17 h + l, 0 <= l < 2^17, and products.smt2 has the product; that of 2 h and
// l is twice that of h and l.
`timescale 1ns / 1ps
`default_nettype none
module f_leaf_sums #(
    parameter W      = 16,
    parameter WD     = 17,
    parameter PIECES = 1,
    parameter T      = PIECES == 1 ? 6 : 9       // clocks until b and k
) (
    input wire            clk,
    input wire            take,
    input wire [3*W+2:0]  oc,
    input wire [W-1:0]    rad,
    input wire [3*WD-1:0] dir
);
    localparam BW = W + WD + 2, KW = 2*W + 3, X = 76;
    wire [BW-1:0] b;
    wire [KW-1:0] k;
    rt_leaf_sums #(.W(W), .WD(WD)) u_dut (
        .clk(clk), .take_i(take), .oc_i(oc), .rad_i(rad), .dir_i(dir), .b_o(b), .k_o(k)
    );
    function signed [35:0] times(input signed [17:0] x, input signed [17:0] y); times = x * y;
    endfunction
    wire signed [X-1:0] b_sum, k_sum;
    wire                known;                   // what is known of products
    genvar i;
    generate
        if (PIECES == 1) begin : g_one
            wire signed [35:0] od [0:2], oo [0:2];
            for (i = 0; i < 3; i = i + 1) begin : g_lane
                wire signed [17:0] o = $signed(oc[(W+1)*i +: W+1]);
                wire signed [17:0] d = $signed(dir[WD*i +: WD]);
                assign od[i] = times(o, d);
                assign oo[i] = times(o, o);
            end
            wire signed [17:0] r = $signed({1'b0, rad});
            wire signed [35:0] rr = times(r, r);
            assign b_sum = od[0] + od[1] + od[2];
            assign k_sum = rr - oo[0] - oo[1] - oo[2];
            assign known = 1'b1;
        end else begin : g_two
            // sums of a weight first, as the module has them: a solver sees where their bits go
            wire signed [35:0] b0 [0:2], b1 [0:2], b2 [0:2], b3 [0:2], k0 [0:2], k1 [0:2], k3 [0:2];
            wire [2:0] twice;
            for (i = 0; i < 3; i = i + 1) begin : g_lane
                wire [34:0] o = {{(34-W){oc[(W+1)*i+W]}}, oc[(W+1)*i +: W+1]};
                wire [34:0] d = {{(35-WD){dir[WD*i+WD-1]}}, dir[WD*i +: WD]};
                wire signed [17:0] o_l = {1'b0, o[16:0]}, o_h = o[34:17];
                wire signed [17:0] d_l = {1'b0, d[16:0]}, d_h = d[34:17];
                (* anyseq *) wire signed [17:0] o_2h;    // a constant bit would leave its product
                assign twice[i] = o_2h == o_h <<< 1;
                assign {b0[i], b1[i]} = {times(o_l, d_l), times(o_l, d_h)};
                assign {b2[i], b3[i]} = {times(o_h, d_l), times(o_h, d_h)};
                assign {k0[i], k1[i], k3[i]} = {times(o_l, o_l), times(o_l, o_2h), times(o_h, o_h)};
            end
            wire signed [X-1:0] s0 = b0[0] + b0[1] + b0[2], s1 = b1[0] + b1[1] + b1[2],
                                s2 = b2[0] + b2[1] + b2[2], s3 = b3[0] + b3[1] + b3[2],
                                t0 = k0[0] + k0[1] + k0[2], t1 = k1[0] + k1[1] + k1[2],
                                t3 = k3[0] + k3[1] + k3[2];
            wire [34:0] r = {{(35-W){1'b0}}, rad};
            wire signed [17:0] r_l = {1'b0, r[16:0]}, r_h = r[34:17];
            (* anyseq *) wire signed [17:0] r_2h;
            wire signed [35:0]  r0 = times(r_l, r_l), r1 = times(r_l, r_2h), r3 = times(r_h, r_h);
            wire [X-1:0] rr = {r3, r0[33:0]} + ({{(X-36){1'b0}}, r1} << 17);
            assign b_sum = s0 + (s1 <<< 17) + (s2 <<< 17) + (s3 <<< 34);
            assign k_sum = $signed({{(X-2*W){1'b0}}, rr[2*W-1:0]}) -
                           (t0 + (t1 <<< 17) + (t3 <<< 34));
            // of factors that are not negative, the first below 2^17, both below 2^W
            assign known = r0 >> 34 == 0 && r1 >= 0 && r3 >= 0 && rr >> 2*W == 0 &&
                           r_2h == r_h <<< 1 && &twice;
        end
    endgenerate
    reg [3:0]    age_q = 4'd0;
    reg [BW-1:0] b_q;
    reg [KW-1:0] k_q;
    always @(posedge clk) begin
        if (age_q != 15) age_q <= age_q + 1'b1;
        if (age_q == 0) begin
            b_q <= b_sum[BW-1:0];
            k_q <= k_sum[KW-1:0];
        end
    end
    always @* begin
        assume (take == (age_q == 0) || age_q >= 4);
        if (age_q == 0) assume (known);
        if (age_q == T) assert (b == b_q && k == k_q);
    end
endmodule
`default_nettype wire
