// f_any_quotient.v - stands for rt_quotient in proofs of its pool: a result at any time
// SPDX-License-Identifier: Apache-2.0
// The pool must not depend on how long a quotient takes or what it is: bits of key and a stand
// for it.
`timescale 1ns / 1ps
`default_nettype none
module rt_quotient #(
    parameter KW   = 35,
    parameter AW   = 34,
    parameter PQ   = 17,
    parameter STEP = 2
) (
    input  wire              clk,
    input  wire              rst,
    input  wire              in_valid_i,
    output wire              in_ready_o,
    input  wire [KW-1:0]     in_key_i,
    input  wire [AW-1:0]     in_a_i,
    output wire              out_valid_o,
    input  wire              out_ready_i,
    output wire [PQ-1:0]     out_mant_o,
    output wire signed [7:0] out_exp_o
);
    (* anyseq *) wire ends;
    reg          full_q, done_q;
    reg [KW-1:0] key_q;
    reg [AW-1:0] a_q;
    assign out_valid_o = full_q && done_q;
    assign in_ready_o  = !full_q;
    always @(posedge clk) begin
        if (full_q && ends)             done_q <= 1'b1;
        if (out_valid_o && out_ready_i) full_q <= 1'b0;
        if (in_valid_i && in_ready_o) begin
            full_q <= 1'b1;
            done_q <= 1'b0;
            key_q  <= in_key_i;
            a_q    <= in_a_i;
        end
        if (rst) full_q <= 1'b0;
    end
    assign out_mant_o = key_q[PQ-1:0];
    assign out_exp_o  = a_q[7:0];
endmodule
`default_nettype wire
