// rt_linear.v - a texture coordinate of a facet: linear in the hit point
// SPDX-License-Identifier: Apache-2.0
//   at = at_0 + round((x y z) . point * 2^-e), modulo 2^40; e < 0 multiplies
//   M products | 1 x + y | 1 + z | 1 shift by 32 and 16 | 1 by 8 to 1 | 1 rounded, added
// Free-running, latency M + 5: M = 1 (W + NG up to 18) or 2. Model: sph_coords_facet() in
// cmodel/texture/coords.c
`default_nettype none
`include "rt_fx.vh"
module rt_linear #(
    parameter W   = 16,                   // coordinate, bits
    parameter NG  = 2,                    // guard bits of the hit point; W + NG at most 28
    parameter TAG = 8                     // what travels along, bits
) (
    input  wire                clk,
    input  wire                rst,       // synchronous, active high
    input  wire                in_valid_i,
    input  wire [TAG-1:0]      in_tag_i,
    input  wire [3*(W+NG)-1:0] in_point_i,  // {z, y, x}, s(W+NG) each
    input  wire [53:0]         in_slope_i,  // {z, y, x}, s18 each
    input  wire [5:0]          in_e_i,      // s6
    input  wire [39:0]         in_at_0_i,   // s19.20
    output wire                out_valid_o,
    output wire [TAG-1:0]      out_tag_o,
    output wire [39:0]         out_at_o     // s19.20
);
    localparam VW = W + NG;
    localparam M  = VW > 18 ? `RT_PRODUCT_LATENCY(VW) : 1;
    localparam DW = VW + 20;              // of the dot product
    localparam L  = M + 5;

    // ---- products ----
    wire [3*(VW+18)-1:0] products;
    genvar i;
    generate
        for (i = 0; i < 3; i = i + 1) begin : g_axis
            wire signed [VW-1:0]  v = in_point_i[VW*i +: VW];
            wire signed [17:0]    g = in_slope_i[18*i +: 18];
            wire signed [VW+17:0] p;
            assign products[(VW+18)*i +: VW+18] = p;
            if (VW > 18) begin : g_wide
                rt_product #(.AW(VW), .BW(18)) u_product (.clk(clk), .a_i(v), .b_i(g), .p_o(p));
            end else begin : g_narrow
                reg signed [VW+17:0] p_q;
                always @(posedge clk) p_q <= v * g;
                assign p = p_q;
            end
        end
    endgenerate

    // ---- dot product ----
    wire signed [DW-1:0] p_x = {{2{products[VW+17]}}, products[VW+17:0]};
    wire signed [DW-1:0] p_y = {{2{products[2*VW+35]}}, products[VW+18 +: VW+18]};
    wire signed [DW-1:0] p_z = {{2{products[3*VW+53]}}, products[2*VW+36 +: VW+18]};
    reg  signed [DW-1:0] xy_q, z_q, dot_q;
    always @(posedge clk) begin
        xy_q  <= p_x + p_y;
        z_q   <= p_z;
        dot_q <= xy_q + z_q;
    end

    // ---- shift of dot * 2^33 right by e + 32: one bit of fraction stays, 40 before it ----
    wire [5:0]    e;
    wire [5:0]    right = e ^ 6'd32;
    wire [103:0]  n_0 = {{(71-DW){dot_q[DW-1]}}, dot_q, 33'd0};
    wire [71:0]   n_32 = right[5] ? n_0[103:32] : n_0[71:0];
    reg  [55:0]   a_q;
    reg  [3:0]    right_q;
    wire [47:0]   n_8 = right_q[3] ? a_q[55:8] : a_q[47:0];
    wire [43:0]   n_4 = right_q[2] ? n_8[47:4] : n_8[43:0];
    wire [41:0]   n_2 = right_q[1] ? n_4[43:2] : n_4[41:0];
    reg  [40:0]   b_q;
    rt_delay #(.WIDTH(6), .CYCLES(M + 2)) u_e (.clk(clk), .in_i(in_e_i), .out_o(e));
    always @(posedge clk) begin
        a_q     <= right[4] ? n_32[71:16] : n_32[55:0];
        right_q <= right[3:0];
        b_q     <= right_q[0] ? n_2[41:1] : n_2[40:0];
    end

    // ---- sum: half up ----
    wire [39:0] at_0;
    reg  [39:0] at_q;
    rt_delay #(.WIDTH(40), .CYCLES(L - 1)) u_at (.clk(clk), .in_i(in_at_0_i), .out_o(at_0));
    always @(posedge clk) at_q <= at_0 + b_q[40:1] + {39'd0, b_q[0]};
    assign out_at_o = at_q;

    rt_delay #(.WIDTH(TAG), .CYCLES(L)) u_tag (.clk(clk), .in_i(in_tag_i), .out_o(out_tag_o));
    rt_delay_valid #(.CYCLES(L)) u_valid (.clk(clk), .rst(rst), .in_i(in_valid_i),
                                          .out_o(out_valid_o));
endmodule
`default_nettype wire
