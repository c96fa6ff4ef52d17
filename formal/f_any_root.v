// f_any_root.v - stands for rt_isqrt in proofs of its user: a result at any time, known by its x
// SPDX-License-Identifier: Apache-2.0
// The user must not depend on how long a root takes or what it is: the bits of x stand for it. One
// root at a time is enough, since f_isqrt.v proves that what is under way keeps its order.
`timescale 1ns / 1ps
`default_nettype none
module rt_isqrt #(
    parameter XW   = 66,
    parameter STEP = 2,
    parameter BITS = 0,
    parameter STAGES = 1,
    parameter TAG  = 1
) (
    input  wire            clk,
    input  wire            rst,
    input  wire            in_valid_i,
    output wire            in_ready_o,
    input  wire [XW-1:0]   in_x_i,
    input  wire [TAG-1:0]  in_tag_i,
    output wire            out_valid_o,
    output wire [(BITS != 0 ? BITS : XW/2)-1:0] out_root_o,
    output wire [5:0]      out_shift_o,
    output wire            out_inexact_o,
    output wire [TAG-1:0]  out_tag_o
);
    (* anyseq *) wire ends;
    reg              full_q;
    reg [TAG+XW-1:0] held_q;
    wire [XW-1:0]    x;
    assign out_valid_o = full_q && ends;
    assign in_ready_o  = !full_q;
    always @(posedge clk) begin
        if (out_valid_o) full_q <= 1'b0;
        if (in_valid_i && in_ready_o) begin
            full_q <= 1'b1;
            held_q <= {in_tag_i, in_x_i};
        end
        if (rst) full_q <= 1'b0;
    end
    assign {out_tag_o, x} = held_q;
    assign out_root_o    = x[(BITS != 0 ? BITS : XW/2)-1:0];
    assign out_shift_o   = BITS != 0 ? {4'd0, x[XW-2 -: 2]} : 6'd0;
    assign out_inexact_o = x[XW-1];
endmodule
`default_nettype wire
