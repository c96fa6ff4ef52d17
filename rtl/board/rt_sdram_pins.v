// rt_sdram_pins.v - pins of an SDRAM at an ECP5, whose clock is half a clock late
// SPDX-License-Identifier: Apache-2.0
//   clk --> ODDRX1F, inverted --> clk_o      dq_i, dq_oe_i --> pin <--> dq_io --> IDDRX1F --> dq_o
// The part takes commands and words in the middle of the clock that sends them. Its own words come
// up to 6 ns after such an edge, and the delays of pins and board later; they are taken at the
// falling edge of clk that follows, a whole clock after the part's edge, and given a clock later.
`timescale 1ns / 1ps
`default_nettype none
module rt_sdram_pins (
    input  wire        clk,
    output wire        clk_o,             // pin
    inout  wire [15:0] dq_io,             // pins
    input  wire [15:0] dq_i,
    input  wire        dq_oe_i,
    output wire [15:0] dq_o
);
    ODDRX1F u_clk (.SCLK(clk), .RST(1'b0), .D0(1'b0), .D1(1'b1), .Q(clk_o));
    wire [15:0] in, unused_rise;
    wire        unused = &{1'b0, unused_rise};
    genvar i;
    generate for (i = 0; i < 16; i = i + 1) begin : g_pin
        TRELLIS_IO #(.DIR("BIDIR")) u_pin (
            .I(dq_i[i]), .T(!dq_oe_i), .O(in[i]), .B(dq_io[i])
        );
        IDDRX1F u_in (.D(in[i]), .SCLK(clk), .RST(1'b0), .Q0(unused_rise[i]), .Q1(dq_o[i]));
    end endgenerate
endmodule
`default_nettype wire
