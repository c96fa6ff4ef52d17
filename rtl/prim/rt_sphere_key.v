// rt_sphere_key.v - square roots of leaf hits, and their keys
// SPDX-License-Identifier: Apache-2.0
// key = b - root for the near root, b + root + inexact for the far one: ceil(a*t).
// PR not 0: of the root its first PR bits count; a far key is then at least 1.
// Keys leave in the order of their hits, each for one clock: rt_isqrt says when.
// Model: sph_leaf_key_bits() in cmodel/prim/sphere.c
`timescale 1ns / 1ps
`default_nettype none
module rt_sphere_key #(
    parameter W     = 16,  // coordinate, bits
    parameter WD    = 17,  // direction component, bits
    parameter PR    = 0,   // significant bits of the root, 0: all
    parameter STAGES = 3,  // roots under way at once
    parameter STEP  = 2,   // root bits a clock
    parameter TAG   = 8,   // tag, bits
    parameter INSIDE = 1   // 1: the far root may count
) (
    input  wire                    clk,
    input  wire                    rst,
    input  wire                    in_valid_i,
    output wire                    in_ready_o,
    input  wire [TAG-1:0]          in_tag_i,
    input  wire                    in_far_i,   // the far root counts
    input  wire [2*W+2*WD-1:0]     in_disc_i,  // > 0
    input  wire signed [W+WD+1:0]  in_b_i,
    output wire                    out_valid_o, // for one clock
    output wire [TAG-1:0]          out_tag_o,
    output wire                    out_far_o,
    output wire [W+WD+1:0]         out_key_o   // > 0
);
    localparam XW = 2*W + 2*WD;                // radicand
    localparam KW = W + WD + 2;                // key
    localparam BW = PR != 0 ? PR : XW/2;       // root, without the 0s behind it
    localparam IB = INSIDE != 0 ? 1 : 0;       // bits of far, if it is elaborated
    wire [KW+TAG:0]      in = {in_far_i, in_tag_i, in_b_i};
    wire [KW+TAG+IB-1:0] along;
    wire [KW-1:0]        b = along[KW-1:0];
    wire [BW-1:0]        root;
    wire [5:0]           shift;
    wire                 inexact;
    rt_isqrt #(.XW(XW), .STEP(STEP), .BITS(PR), .STAGES(STAGES), .TAG(KW+TAG+IB)) u_isqrt (
        .clk(clk), .rst(rst),
        .in_valid_i(in_valid_i), .in_ready_o(in_ready_o), .in_x_i(in_disc_i),
        .in_tag_i(in[KW+TAG+IB-1:0]),
        .out_valid_o(out_valid_o), .out_root_o(root), .out_shift_o(shift),
        .out_inexact_o(inexact), .out_tag_o(along)
    );
    assign out_tag_o = along[KW +: TAG];
    assign out_far_o = INSIDE != 0 && along[KW+TAG+IB-1];
    wire [KW-1:0] wide = {{(KW-BW){1'b0}}, root} << (PR != 0 ? shift : 6'd0);
    wire [KW-1:0] key  = b + (out_far_o ? wide : ~wide) + {{(KW-1){1'b0}}, !out_far_o || inexact};
    // PR: b < 0, and the lost bits outweigh what the root is longer
    wire          none = PR != 0 && out_far_o && b[KW-1] && (key[KW-1] || key == {KW{1'b0}});
    assign out_key_o = none ? {{(KW-1){1'b0}}, 1'b1} : key;
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_roots /* verilator public_flat_rd */ =
        {in_valid_i && !in_ready_o, in_valid_i && in_ready_o, 5'd0, in_valid_i || !in_ready_o};
    wire unused = &{1'b0, in, shift};
endmodule
`default_nettype wire
