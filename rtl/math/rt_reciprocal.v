// rt_reciprocal.v - reciprocal of a normalised number, a straight line in each of 512 parts
// SPDX-License-Identifier: Apache-2.0
//   2^43 (1 - 2^-18.8) < y * size <= 2^43     size in (x - 1, x]: its first 22 bits, rounded up
//   1 line of the table | 2 slope | 3 reciprocal
// One a clock, latency 3. Model: sph_reciprocal() in cmodel/math/arith.c
`timescale 1ns / 1ps
`default_nettype none
module rt_reciprocal (
    input  wire        clk,
    input  wire [21:0] top_i,     // first bits, of which the first is 1
    input  wire        more_i,    // other bits are not 0: rounded up
    output reg  [21:0] y_o        // u22, first bit 1
);
    wire [33:0] s1_line;          // {slope u12, start u0.22}
    reg  [12:0] s1_rest_q;
    reg  [24:0] s2_less_q;
    reg  [21:0] s2_start_q;
    wire [24:0] s2_up = s2_less_q + 25'd2047;
    wire [21:0] s2_y  = s2_start_q - {8'd0, s2_up[24:11]};
    rt_reciprocal_rom u_rom (.clk(clk), .index_i(top_i[20:12]), .line_q(s1_line));
    always @(posedge clk) begin
        s1_rest_q  <= {1'b0, top_i[11:0]} + {12'd0, more_i};
        s2_less_q  <= s1_line[33:22] * s1_rest_q;
        s2_start_q <= s1_line[21:0];
        y_o        <= s2_y[21] ? s2_y : {1'b1, 21'd0};
    end
    wire unused = &{1'b0, top_i[21], s2_up[10:0]};
endmodule
`default_nettype wire
