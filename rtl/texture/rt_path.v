// rt_path.v - length of the rays from the eye to a hit
// SPDX-License-Identifier: Apache-2.0
//   path = min(path + round(key * y / 2^(WD+12-h)), all ones): the way t*dir is key/|dir| long,
//   and 1/|dir| is y * 2^(h-WD-16) by rt_unit
//   P product | 1 shift by 16 and 8 | 1 by 4, 2 and 1 | 1 rounded, added; P = `RT_PRODUCT_LATENCY
// Free-running, latency P + 3: 5 or 6. Model: sph_path_add() in cmodel/texture/lod.c
`default_nettype none
`include "rt_fx.vh"
module rt_path #(
    parameter W   = 16,                    // coordinate, bits
    parameter WD  = 17,                    // direction component, bits; W + WD at most 49
    parameter TAG = 8                      // what travels along, bits
) (
    input  wire            clk,
    input  wire            rst,            // synchronous, active high
    input  wire            in_valid_i,
    input  wire [TAG-1:0]  in_tag_i,
    input  wire [W+WD+1:0] in_key_i,       // u(W+WD+2), of the hit
    input  wire [16:0]     in_y_i,         // u1.16, of the ray's unit vector
    input  wire [5:0]      in_h_i,         // 0 to WD
    input  wire [W+7:0]    in_path_i,      // u(W+4).4 grid units, before
    output wire            out_valid_o,
    output wire [TAG-1:0]  out_tag_o,
    output wire [W+7:0]    out_path_o      // u(W+4).4
);
    localparam KB = W + WD + 2;
    localparam PB = W + 8;
    localparam P  = `RT_PRODUCT_LATENCY(KB + 1);
    localparam SB = KB + 6;                // the product without 11 bits that no shift keeps

    // ---- product ----
    wire signed [KB+18:0] product;
    wire [5:0]            h;
    wire [5:0]            right = WD[5:0] - h;   // 0 to WD, less than 32
    rt_product #(.AW(KB + 1), .BW(18)) u_product (
        .clk(clk), .a_i({1'b0, in_key_i}), .b_i({1'b0, in_y_i}), .p_o(product)
    );
    rt_delay #(.WIDTH(6), .CYCLES(P)) u_h (.clk(clk), .in_i(in_h_i), .out_o(h));

    // ---- shift: one bit of fraction stays ----
    wire [SB-1:0] n_0 = product[KB+16:11];
    wire [SB-1:0] n_16 = right[4] ? n_0 >> 16 : n_0;
    reg  [SB-1:0] a_q, b_q;
    reg  [2:0]    right_q;
    wire [SB-1:0] n_4 = right_q[2] ? a_q >> 4 : a_q;
    wire [SB-1:0] n_2 = right_q[1] ? n_4 >> 2 : n_4;
    always @(posedge clk) begin
        a_q     <= right[3] ? n_16 >> 8 : n_16;
        right_q <= right[2:0];
        b_q     <= right_q[0] ? n_2 >> 1 : n_2;
    end

    // ---- sum: (length + 1) / 2 rounds half up ----
    wire [PB-1:0] path;
    reg  [PB-1:0] path_q;
    wire [SB:0]   twice = {1'b0, b_q} + {{SB{1'b0}}, 1'b1};
    wire [SB:0]   sum = {1'b0, twice[SB:1]} + {{(SB+1-PB){1'b0}}, path};
    rt_delay #(.WIDTH(PB), .CYCLES(P + 2)) u_path (.clk(clk), .in_i(in_path_i), .out_o(path));
    always @(posedge clk) path_q <= |sum[SB:PB] ? {PB{1'b1}} : sum[PB-1:0];
    assign out_path_o = path_q;

    rt_delay #(.WIDTH(TAG), .CYCLES(P + 3)) u_tag (.clk(clk), .in_i(in_tag_i), .out_o(out_tag_o));
    rt_delay_valid #(.CYCLES(P + 3)) u_valid (.clk(clk), .rst(rst), .in_i(in_valid_i),
                                              .out_o(out_valid_o));
    wire unused = &{1'b0, product[KB+18:KB+17], product[10:0], right[5], twice[0]};
endmodule
`default_nettype wire
