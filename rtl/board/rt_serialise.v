// rt_serialise.v - 10-bit symbols to pins of an ECP5, two bits a clock of five times the pixel's
// SPDX-License-Identifier: Apache-2.0
//   symbol --> 10-bit shift register, by two --> ODDRX1F --> pin; bit 0 first
// Both clocks come from one PLL, edges together. A flip-flop that pix_clk toggles tells clk5 where
// a symbol begins: it is loaded two to three clk5 after its edge, when it has long been still.
// A lane for the pixel clock is one whose symbol is always 10'b0000011111.
`timescale 1ns / 1ps
`default_nettype none
module rt_serialise #(
    parameter LANES = 4                   // pins
) (
    input  wire                pix_clk,
    input  wire [10*LANES-1:0] symbol_i,  // lane i in field i, in pix_clk
    input  wire                clk5,      // five times pix_clk
    output wire [LANES-1:0]    pin_o
);
    // ---- where a symbol begins ----
    reg toggle_q = 1'b0;                  // a start value, for nothing else resets it
    reg seen_q, before_q;
    always @(posedge pix_clk) toggle_q <= !toggle_q;
    always @(posedge clk5) begin
        seen_q   <= toggle_q;
        before_q <= seen_q;
    end
    wire load = seen_q != before_q;

    // ---- lanes ----
    genvar i;
    generate for (i = 0; i < LANES; i = i + 1) begin : g_lane
        reg [9:0] left_q;                 // bits to be sent, the next two lowest
        always @(posedge clk5)
            left_q <= load ? symbol_i[10*i +: 10] : {2'b00, left_q[9:2]};
        ODDRX1F u_pin (.SCLK(clk5), .RST(1'b0), .D0(left_q[0]), .D1(left_q[1]), .Q(pin_o[i]));
    end endgenerate
endmodule
`default_nettype wire
