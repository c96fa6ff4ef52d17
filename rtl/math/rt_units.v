// rt_units.v - one unit for unit vectors, or two that take turns: UNITS vectors in INTERVAL clocks
// SPDX-License-Identifier: Apache-2.0
// The second one starts half an interval behind, so never both take, and never both give.
// Below 18 bits they are rt_unit in any case. Latency that of rt_unit or rt_unit_four.
// Model: sph_unit() in cmodel/math/arith.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
module rt_units #(
    parameter BITS  = 17,                     // component of v, bits: 9 to 32
    parameter TAG   = 8,                      // what travels along, bits
    parameter UNITS = 2,                      // 1 or 2
    parameter SPREADS = 1,                    // 2: the second unit has its own kind of them
    parameter INTERVAL = 2                    // clocks a vector of each: 2 or 4
) (
    input  wire                   clk,
    input  wire                   rst,
    // a vector {z, y, x}
    input  wire                   in_valid_i,
    input  wire                   in_spread_i, // not a clock behind another such: of two fast units
                                               // the first only, or
    input  wire                   in_second_i, // with SPREADS, the second only
    output wire                   in_ready_o,
    output wire                   first_o,    // the first unit may take in this clock
    input  wire [TAG-1:0]         in_tag_i,
    input  wire [3*BITS-1:0]      in_vec_i,
    // its unit vector
    output wire                   out_valid_o,
    output wire [TAG-1:0]         out_tag_o,
    output wire [2*BITS-1:0]      out_vv_o,   // u(2BITS), v.v
    output wire [53:0]            out_u_o,    // {z, y, x} s1.16
    output wire [16:0]            out_y_o,    // u1.16, 2^(BITS+16-h) / |v| from below
    output wire [5:0]             out_h_o     // left shift of v
);
    localparam RW = TAG + 2*BITS + 54 + 17 + 6;
    wire [UNITS-1:0] ready, valid;
    wire [UNITS*RW-1:0] results;
    localparam FOUR = INTERVAL == 4 && BITS >= 18;    // narrower ones need no pieces
    localparam SECOND = SPREADS > 1 && UNITS > 1;
    wire [1:0] only = SECOND && in_second_i ? 2'b10 : 2'b01;
    wire [UNITS-1:0] may = {UNITS{FOUR || !in_spread_i}} | only[UNITS-1:0];
    `RT_CHECK(UNITS >= 1 && UNITS <= 2, rt_units_UNITS_must_be_1_or_2)
    `RT_CHECK(INTERVAL == 2 || INTERVAL == 4, rt_units_INTERVAL_must_be_2_or_4)
    genvar g;
    generate
        for (g = 0; g < UNITS; g = g + 1) begin : g_unit
            wire signed [17:0] x, y, z;
            wire [TAG-1:0]     tag;
            wire [2*BITS-1:0]  vv;
            wire [16:0]        rsqrt;
            wire [5:0]         h;
            if (!FOUR) begin : g_two
                rt_unit #(.BITS(BITS), .TAG(TAG), .ODD(g)) u_unit (
                    .clk(clk), .rst(rst),
                    .in_valid_i(in_valid_i && may[g]), .in_ready_o(ready[g]), .in_tag_i(in_tag_i),
                    .in_x_i($signed(in_vec_i[0 +: BITS])), .in_y_i($signed(in_vec_i[BITS +: BITS])),
                    .in_z_i($signed(in_vec_i[2*BITS +: BITS])),
                    .out_valid_o(valid[g]), .out_tag_o(tag), .out_vv_o(vv),
                    .out_u_x_o(x), .out_u_y_o(y), .out_u_z_o(z), .out_y_o(rsqrt), .out_h_o(h)
                );
            end else begin : g_four
                rt_unit_four #(.BITS(BITS), .TAG(TAG), .ODD(g)) u_unit (
                    .clk(clk), .rst(rst),
                    .in_valid_i(in_valid_i && may[g]), .in_ready_o(ready[g]), .in_tag_i(in_tag_i),
                    .in_x_i($signed(in_vec_i[0 +: BITS])), .in_y_i($signed(in_vec_i[BITS +: BITS])),
                    .in_z_i($signed(in_vec_i[2*BITS +: BITS])),
                    .out_valid_o(valid[g]), .out_tag_o(tag), .out_vv_o(vv),
                    .out_u_x_o(x), .out_u_y_o(y), .out_u_z_o(z), .out_y_o(rsqrt), .out_h_o(h)
                );
            end
            assign results[RW*g +: RW] = {tag, vv, z, y, x, rsqrt, h};
        end
    endgenerate
    assign in_ready_o  = |(ready & may);
    assign first_o     = ready[0];
    assign out_valid_o = |valid;
    assign {out_tag_o, out_vv_o, out_u_o, out_y_o, out_h_o} =
        valid[0] ? results[RW-1:0] : results[UNITS*RW-1 -: RW];
    wire unused = &{1'b0, in_second_i, only};
endmodule
`default_nettype wire
