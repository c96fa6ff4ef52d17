// late_point.v - a primitive whose point and normal come late: rt_hit gives the same surfaces
// SPDX-License-Identifier: Apache-2.0
// The same hits go to rt_hit and to rt_hit_late, which tests/prim/test_kinds.sh makes of it by
// giving it rt_prim_point_late. Prints `same` or what differs.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_prim.vh"
module rt_prim_point_late #(
    parameter W = 16, parameter NG = 2, parameter FARS = 1, parameter FACETS = 0
) (
    input  wire                              clk,
    input  wire [`RT_EFFECT_BITS-1:0]        effects_i,
    input  wire                              take_i,
    input  wire [`RT_LEAF_STRIDE-1:0]        shape_i,
    input  wire                              far_i,
    input  wire                              in_valid_i,
    input  wire signed [W+NG-1:0]            in_guarded_i,
    output wire                              out_valid_o,
    output wire signed [W-1:0]               out_point_o,
    output wire        [NG+1:0]              out_lift_o,
    output wire                              out_limited_o,
    output wire                              out_flat_o,
    output wire signed [`RT_PRIM_VECTOR_BITS(W, NG, FACETS)-1:0] out_vector_o
);
    localparam VW = `RT_PRIM_VECTOR_BITS(W, NG, FACETS), B = VW + W + NG + 5, CLOCKS = 9;
    wire valid, limited, flat;
    wire signed [W-1:0]  point;
    wire [NG+1:0]        lift;
    wire signed [VW-1:0] vector;
    rt_hit_point #(.W(W), .NG(NG), .FARS(FARS), .FACETS(FACETS)) u_prim (
        .clk(clk), .effects_i(effects_i), .take_i(take_i), .shape_i(shape_i), .far_i(far_i),
        .in_valid_i(in_valid_i), .in_guarded_i(in_guarded_i), .out_valid_o(valid),
        .out_point_o(point), .out_lift_o(lift), .out_limited_o(limited), .out_flat_o(flat),
        .out_vector_o(vector)
    );
    reg [CLOCKS*B-1:0] q = {CLOCKS*B{1'b0}};
    always @(posedge clk) q <= {q[(CLOCKS-1)*B-1:0], valid, limited, flat, lift, point, vector};
    assign {out_valid_o, out_limited_o, out_flat_o, out_lift_o, out_point_o, out_vector_o} =
        q[CLOCKS*B-1 -: B];
endmodule

module late_point;
    parameter INTERVAL = 8;                      // of rt_hit, 8 or 12
    localparam W = 16, WD = 17, PQ = 17, NG = 2, HITS = 300;
    localparam OB = 8 + 3*W + 3*(W+NG) + 3*WD + 3*(NG+2) + 2;
    reg clk = 1'b0, rst = 1'b1;
    always #2 clk = !clk;
    reg [3*W-1:0]  org   [0:HITS-1];
    reg [3*WD-1:0] dir   [0:HITS-1];
    reg [127:0]    shape [0:HITS-1];
    reg [PQ+8:0]   t     [0:HITS-1];             // far, exponent, mantissa
    wire [1:0]     ready, valid;
    wire [2*OB-1:0] out;
    reg  [OB-1:0]  first [0:HITS-1];
    integer        sent [0:1], come [0:1], bad = 0, n, k, seed = 5;
    reg  [1:0]     offer, taken;
    genvar g;
    generate
        for (g = 0; g < 2; g = g + 1) begin : g_hit
            wire [OB-1:0] o;
            assign out[OB*g +: OB] = o;
            wire [3*W-1:0]  a = org[sent[g] % HITS];
            wire [3*WD-1:0] d = dir[sent[g] % HITS];
            wire [PQ+8:0]   m = t[sent[g] % HITS];
            wire [7:0]      tag = sent[g];
            `define PORTS \
                .clk(clk), .rst(rst), .effects_i({`RT_EFFECT_BITS{1'b1}}), \
                .in_valid_i(offer[g]), .in_ready_o(ready[g]), .in_tag_i(tag), \
                .in_mant_i(m[PQ-1:0]), .in_exp_i(m[PQ +: 8]), .in_org_x_i(a[0 +: W]), \
                .in_org_y_i(a[W +: W]), .in_org_z_i(a[2*W +: W]), .in_dir_x_i(d[0 +: WD]), \
                .in_dir_y_i(d[WD +: WD]), .in_dir_z_i(d[2*WD +: WD]), \
                .in_shape_i(shape[sent[g] % HITS]), .in_far_i(m[PQ+8]), .out_valid_o(valid[g]), \
                .out_tag_o(o[OB-1 -: 8]), .out_point_x_o(o[0 +: W]), .out_point_y_o(o[W +: W]), \
                .out_point_z_o(o[2*W +: W]), .out_guarded_o(o[3*W +: 3*(W+NG)]), \
                .out_normal_x_o(o[6*W+3*NG +: WD]), .out_normal_y_o(o[6*W+3*NG+WD +: WD]), \
                .out_normal_z_o(o[6*W+3*NG+2*WD +: WD]), .out_saturated_o(o[OB-9]), \
                .out_flat_o(o[OB-10]), .out_lift_o(o[6*W+3*NG+3*WD +: 3*(NG+2)])
            if (g == 0) begin : g_now
                rt_hit #(.W(W), .WD(WD), .PQ(PQ), .NG(NG), .FACETS(1), .TEXTURE(1),
                         .INTERVAL(INTERVAL)) u_hit (`PORTS);
            end else begin : g_late
                rt_hit_late #(.W(W), .WD(WD), .PQ(PQ), .NG(NG), .FACETS(1), .TEXTURE(1),
                              .INTERVAL(INTERVAL)) u_hit (`PORTS);
            end
        end
    endgenerate

    initial begin
        for (n = 0; n < HITS; n = n + 1) begin
            org[n]   = {$random(seed), $random(seed)};
            dir[n]   = {$random(seed), $random(seed)};
            shape[n] = {$random(seed), $random(seed), $random(seed), $random(seed)};
            shape[n][`RT_PRIM_KIND_LSB +: `RT_PRIM_KIND_BITS] = n % 2;
            if (n % 7 == 0) shape[n][71:0] = 72'd0;
            t[n]     = {n % 3 == 0, 8'd14 + {4'd0, n[3:0]}, 1'b1, {(PQ-1){1'b0}}} + n*37;
        end
        for (k = 0; k < 2; k = k + 1) begin sent[k] = 0; come[k] = 0; end
        offer = 2'd0;
        repeat (4) @(negedge clk);
        rst = 1'b0;
        for (n = 0; come[1] < HITS && n < 40*HITS && bad == 0; n = n + 1) begin
            for (k = 0; k < 2; k = k + 1) offer[k] = sent[k] < HITS && (n % 50 > 10 || offer[k]);
            #1;
            for (k = 0; k < 2; k = k + 1) if (valid[k]) begin
                if (k == 0) first[come[0]] = out[0 +: OB];
                else if (first[come[1]] !== out[OB +: OB]) bad = 1;
                come[k] = come[k] + 1;
            end
            taken = offer & ready;
            @(negedge clk) for (k = 0; k < 2; k = k + 1) if (taken[k]) begin
                sent[k]  = sent[k] + 1;
                offer[k] = 1'b0;
            end
        end
        if (bad != 0 || come[1] < HITS || come[0] != HITS)
            $display("differs: hit %0d of %0d, %0d", come[1], come[0], bad);
        else $display("same: %0d hits, sent %0d", come[1], sent[0]);
        $finish(0);
    end
endmodule
`default_nettype wire
