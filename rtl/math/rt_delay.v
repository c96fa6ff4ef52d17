// rt_delay.v - a word, CYCLES later; data registers only
// SPDX-License-Identifier: Apache-2.0
`timescale 1ns / 1ps
`default_nettype none
module rt_delay #(
    parameter WIDTH  = 8,  // bits
    parameter CYCLES = 1   // at least 1
) (
    input  wire             clk,
    input  wire [WIDTH-1:0] in_i,
    output wire [WIDTH-1:0] out_o
);
    reg [WIDTH*CYCLES-1:0] line_q;
    generate
        if (CYCLES == 1) begin : g_one
            always @(posedge clk) line_q <= in_i;
        end else begin : g_many
            always @(posedge clk) line_q <= {line_q[WIDTH*(CYCLES-1)-1:0], in_i};
        end
    endgenerate
    assign out_o = line_q[WIDTH*CYCLES-1 -: WIDTH];
endmodule
`default_nettype wire
