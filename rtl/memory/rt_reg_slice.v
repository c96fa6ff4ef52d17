// rt_reg_slice.v - register slice: one word between a producer and a consumer
// SPDX-License-Identifier: Apache-2.0
// The word comes from a register, so that what it reads begins there. Latency 1 cycle, a word
// every cycle; in_ready_o depends on out_ready_i.
`timescale 1ns / 1ps
`default_nettype none
module rt_reg_slice #(
    parameter WIDTH = 8    // bits of a word
) (
    input  wire             clk,
    input  wire             rst,          // synchronous, active high
    // from the producer
    input  wire             in_valid_i,
    output wire             in_ready_o,   // there is no word, or it leaves
    input  wire [WIDTH-1:0] in_data_i,
    // to the consumer
    output reg              out_valid_o,
    input  wire             out_ready_i,
    output reg  [WIDTH-1:0] out_data_o
);
    assign in_ready_o = !out_valid_o || out_ready_i;
    always @(posedge clk) begin
        if (in_ready_o) begin
            out_valid_o <= in_valid_i;
            out_data_o  <= in_data_i;
        end
        if (rst) out_valid_o <= 1'b0;
    end
endmodule
`default_nettype wire
