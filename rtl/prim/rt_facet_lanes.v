// rt_facet_lanes.v - three multipliers and the sums that rt_facet makes of their products
// SPDX-License-Identifier: Apache-2.0
//   clock 0 operands | L products p | c: p, or p - c      lane by lane, a cross product
//                                   | p0 + p1 | + p2 = r  a dot product; wide: p1, p2 lie CUT and
//                                                         2 CUT bits higher, one long product
// Free-running: c after L + 1 clocks, r after L + 2, L = `RT_PRODUCT_LATENCY(AW).
// Model: cross() and dot() in cmodel/prim/facet.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_fx.vh"
module rt_facet_lanes #(
    parameter AW  = 35,                        // bits of the wide operand
    parameter BW  = 18,                        // bits of the narrow operand
    parameter CW  = 34,                        // bits of a component of a cross product
    parameter RW  = 84,                        // bits of a sum, at least AW + BW
    parameter CUT = 17                         // bits of a piece of a long operand
) (
    input  wire                 clk,
    input  wire [3*AW-1:0]      a_i,           // 3 x sAW, to be registered
    input  wire [3*BW-1:0]      b_i,           // 3 x sBW
    input  wire                 cross_i,       // with the products: they belong to a cross product
    input  wire                 first_i,       // with the products: the ones to be subtracted
    input  wire                 wide_i,        // with the products: pieces of one
    output wire [3*CW-1:0]      c_o,           // 3 x sCW
    output wire signed [RW-1:0] r_o            // sRW
);
    localparam PW = AW + BW;
    reg [3*AW-1:0]  a_q;
    reg [3*BW-1:0]  b_q;
    wire [3*PW-1:0] p;
    always @(posedge clk) begin
        a_q <= a_i;
        b_q <= b_i;
    end

    // ---- products, cross products ----
    wire [3*RW-1:0] wide;                      // products as long as the sum
    genvar j;
    generate
        for (j = 0; j < 3; j = j + 1) begin : g_lane
            rt_product #(.AW(AW), .BW(BW)) u_product (
                .clk(clk), .a_i($signed(a_q[AW*j +: AW])), .b_i($signed(b_q[BW*j +: BW])),
                .p_o(p[PW*j +: PW])
            );
            reg [CW-1:0] c_q;
            always @(posedge clk)
                if (cross_i) c_q <= p[PW*j +: CW] - (first_i ? {CW{1'b0}} : c_q);
            assign c_o[CW*j +: CW] = c_q;
            assign wide[RW*j +: RW] = {{(RW-PW){p[PW*j+PW-1]}}, p[PW*j +: PW]};
        end
    endgenerate

    // ---- sum of the three ----
    reg          wide_q;
    reg [RW-1:0] low_q, p2_q, r_q;
    always @(posedge clk) begin
        wide_q <= wide_i;
        p2_q   <= wide[2*RW +: RW];
        low_q  <= wide[0 +: RW] + (wide_i ? wide[RW +: RW] << CUT : wide[RW +: RW]);
        r_q    <= low_q + (wide_q ? p2_q << (2*CUT) : p2_q);
    end
    assign r_o = $signed(r_q);
endmodule
`default_nettype wire
