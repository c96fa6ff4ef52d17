// f_any_root.v - stands for rt_isqrt in proofs of its pool: a result at any time, known by its x
// SPDX-License-Identifier: Apache-2.0
// The pool must not depend on how long a root takes or what it is: the bits of x stand for it.
`timescale 1ns / 1ps
`default_nettype none
module rt_isqrt #(
    parameter XW   = 66,
    parameter STEP = 2,
    parameter BITS = 0
) (
    input  wire            clk,
    input  wire            rst,
    input  wire            in_valid_i,
    output wire            in_ready_o,
    input  wire [XW-1:0]   in_x_i,
    output wire            out_valid_o,
    input  wire            out_ready_i,
    output wire [(BITS != 0 ? BITS : XW/2)-1:0] out_root_o,
    output wire [5:0]      out_shift_o,
    output wire            out_inexact_o
);
    (* anyseq *) wire ends;
    reg          full_q, done_q;
    reg [XW-1:0] x_q;
    assign out_valid_o = full_q && done_q;
    assign in_ready_o  = !full_q;
    always @(posedge clk) begin
        if (full_q && ends)             done_q <= 1'b1;
        if (out_valid_o && out_ready_i) full_q <= 1'b0;
        if (in_valid_i && in_ready_o) begin
            full_q <= 1'b1;
            done_q <= 1'b0;
            x_q    <= in_x_i;
        end
        if (rst) full_q <= 1'b0;
    end
    assign out_root_o    = x_q[(BITS != 0 ? BITS : XW/2)-1:0];
    assign out_shift_o   = BITS != 0 ? {4'd0, x_q[XW-2 -: 2]} : 6'd0;
    assign out_inexact_o = x_q[XW-1];
endmodule
`default_nettype wire
