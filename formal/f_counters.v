// f_counters.v - stands for rt_counters in proofs: counts the clocks since anything was counted
// SPDX-License-Identifier: Apache-2.0
// After how many of them no total changes any more: f_counts.v.
`timescale 1ns / 1ps
`default_nettype none
module rt_counters #(
    parameter PLACES = 16,
    parameter MOST   = 63,
    parameter USED   = PLACES
) (
    input  wire                clk,
    input  wire                rst,
    input  wire                clear_i,
    input  wire [8*PLACES-1:0] add_i,
    input  wire [4:0]          addr_i,
    output reg  [47:0]         data_o
);
    (* anyseq *) wire [47:0] any;
    reg [7:0] calm_q;
    always @(posedge clk) begin
        data_o <= any;
        calm_q <= rst || clear_i || |add_i ? 8'd0 : &calm_q ? calm_q : calm_q + 1'b1;
    end
endmodule
`default_nettype wire
