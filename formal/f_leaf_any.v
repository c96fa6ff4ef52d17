// f_leaf_any.v - stand for rt_leaf_sums, rt_leaf_disc in proofs of rt_leaf, as late as those
// SPDX-License-Identifier: Apache-2.0
// Sums are anything. disc is made of operands that stand for four clocks; of others it is anything,
// and so it is in clocks other than its own.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_fx.vh"
module rt_leaf_sums #(
    parameter W  = 24,
    parameter WD = 25
) (
    input  wire             clk,
    input  wire             take_i,
    input  wire [3*W+2:0]   oc_i,
    input  wire [W-1:0]     rad_i,
    input  wire [3*WD-1:0]  dir_i,
    output wire [W+WD+1:0]  b_o,
    output wire [2*W+2:0]   k_o
);
    (* anyseq *) wire [3*W+WD+4:0] any;
    assign {b_o, k_o} = any;
endmodule
module rt_leaf_disc #(
    parameter W  = 24,
    parameter WD = 25
) (
    input  wire                clk,
    input  wire                ready_i,
    input  wire [W+WD+1:0]     b_i,
    input  wire [2*W+2:0]      k_i,
    input  wire [2*WD-1:0]     a_i,
    output wire [2*W+2*WD+1:0] disc_o
);
    localparam BW = W + WD + 2, KW = 2*W + 3, DW = 2*W + 2*WD + 2;
    localparam VW = KW > BW ? KW : BW;
    localparam NW = VW > 2*WD + 1 ? VW : 2*WD + 1;
    (* anyseq *) wire [DW-1:0] any;
    reg  [2:0]             step_q;
    reg                    moved_q;
    reg  [BW+KW+2*WD-1:0]  stood_q;
    localparam N = `RT_LEAF_PIECES(W, WD) == 1 ? 4 : 5;
    reg  [DW*N-1:0]        wait_q;               // from step 3 to the clock of disc
    wire signed [NW-1:0]   b = $signed(b_i), k = $signed(k_i), a = $signed({1'b0, a_i});
    wire signed [2*NW-1:0] ka = k * a, bb = b * b;
    wire                   moves = step_q != 0 && (moved_q || stood_q != {b_i, k_i, a_i});
    wire [DW-1:0]          sum = ka[DW-1:0] + bb[DW-1:0];
    always @(posedge clk) begin
        step_q  <= ready_i ? 3'd0 : step_q == 3'd4 ? 3'd4 : step_q + 3'd1;
        moved_q <= moves;
        stood_q <= {b_i, k_i, a_i};
        wait_q  <= {wait_q[DW*(N-1)-1:0], step_q == 3'd3 && !moves ? sum : any};
    end
    assign disc_o = wait_q[DW*N-1 -: DW];
endmodule
`default_nettype wire
