// rt_delay_valid.v - a valid bit, CYCLES later; cleared by reset
// SPDX-License-Identifier: Apache-2.0
`timescale 1ns / 1ps
`default_nettype none
module rt_delay_valid #(
    parameter CYCLES = 1   // at least 1
) (
    input  wire clk,
    input  wire rst,
    input  wire in_i,
    output wire out_o
);
    reg [CYCLES:0] line_q;
    always @(posedge clk) begin
        line_q <= {line_q[CYCLES-1:0], in_i};
        if (rst) line_q <= {(CYCLES+1){1'b0}};
    end
    assign out_o = line_q[CYCLES-1];
    wire unused = &{1'b0, line_q[CYCLES]};
endmodule
`default_nettype wire
