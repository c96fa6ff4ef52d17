// f_any_facet.v - stand for the parts of rt_facet in proofs of what it makes of them: say anything
// SPDX-License-Identifier: Apache-2.0
`timescale 1ns / 1ps
`default_nettype none
`include "rt_facet.vh"
module rt_facet_sums #(
    parameter W  = 16,
    parameter WD = 17,
    parameter INTERVAL = 2,
    parameter VW = 51
) (
    input  wire                 clk,
    input  wire                 take_i,
    input  wire                 plane_i,
    input  wire [71:0]          v0_i,
    input  wire [71:0]          v1_i,
    input  wire [71:0]          v2_i,
    input  wire [3*W-1:0]       org_i,
    input  wire [3*WD-1:0]      dir_i,
    output wire [3*`RT_FACET_WIDE(W, WD)-1:0] n_o,
    output wire [VW-1:0]        det_o,
    output wire [VW-1:0]        num_o,
    output wire [VW-1:0]        u2_o,
    output wire [VW-1:0]        v_o
);
    (* anyseq *) wire [3*`RT_FACET_WIDE(W, WD) + 4*VW - 1:0] any;
    assign {n_o, det_o, num_o, u2_o, v_o} = any;
endmodule
module rt_facet_ahead #(
    parameter CW   = 34,
    parameter NG   = 2,
    parameter WAIT = 1
) (
    input  wire                 clk,
    input  wire [3*CW-1:0]      n_i,
    input  wire [3*(NG+2)-1:0]  lift_i,
    output wire [CW+NG+1:0]     along_o,
    output wire                 carry_o,
    output wire [CW:0]          size_o
);
    (* anyseq *) wire [2*CW + NG + 3:0] any;
    assign {along_o, carry_o, size_o} = any;
endmodule
module rt_facet_key #(
    parameter W     = 16,
    parameter WD    = 17,
    parameter TAG   = 30,
    parameter DW    = 50,
    parameter MW    = 49,
    parameter HOLD  = 16
) (
    input  wire             clk,
    input  wire             rst,
    input  wire             in_valid_i,
    input  wire [TAG-1:0]   in_tag_i,
    input  wire             in_plane_i,
    input  wire [DW-1:0]    in_det_i,
    input  wire [MW-1:0]    in_num_i,
    input  wire [2*WD-1:0]  in_a_i,
    input  wire [W:0]       in_room_i,
    input  wire [WD-1:0]    in_size_i,
    output wire             out_valid_o,
    input  wire             out_ready_i,
    output wire [TAG-1:0]   out_tag_o,
    output wire [W+WD+1:0]  out_key_o,
    output wire             divide_o
);
    (* anyseq *) wire [TAG + W + WD + 3:0] any;
    assign {divide_o, out_valid_o, out_tag_o, out_key_o} = any;
endmodule
module rt_fifo #(
    parameter WIDTH = 8,
    parameter DEPTH = 16
) (
    input  wire             clk,
    input  wire             rst,
    input  wire             in_valid_i,
    output wire             in_ready_o,
    input  wire [WIDTH-1:0] in_data_i,
    output wire             out_valid_o,
    input  wire             out_ready_i,
    output wire [WIDTH-1:0] out_data_o
);
    (* anyseq *) wire [WIDTH + 1:0] any;
    assign {in_ready_o, out_valid_o, out_data_o} = any;
endmodule
`default_nettype wire
