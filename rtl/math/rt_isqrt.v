// rt_isqrt.v - integer square root, or its first bits, STEP bits a clock
// SPDX-License-Identifier: Apache-2.0
// root = floor(sqrt(x)), inexact = (root^2 != x). Digit by digit: two radicand bits enter rem, and
// the trial 4*root+1 is subtracted if it fits. Invariant: rem = x / 4^i - root^2 <= 2*root.
// One radicand at a time: a result ceil(XW/2/STEP) + 1 clocks after its radicand. BITS not 0: the
// digits end BITS after the first 1, and so do the clocks.
// Model: sph_isqrt_bits() in cmodel/math/arith.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
module rt_isqrt #(
    parameter XW   = 66,                   // radicand, bits: even
    parameter STEP = 2,                    // root bits a clock: 1 to XW/2
    parameter BITS = 0                     // significant bits of the root: 2 to XW/2-1, 0: all
) (
    input  wire            clk,
    input  wire            rst,            // synchronous, active high
    // from rt_root_pool
    input  wire            in_valid_i,
    output wire            in_ready_o,
    input  wire [XW-1:0]   in_x_i,         // uXW
    // to rt_root_pool
    output wire            out_valid_o,
    input  wire            out_ready_i,
    output wire [(BITS != 0 ? BITS : XW/2)-1:0] out_root_o,  // root / 2^shift
    output wire [5:0]      out_shift_o,    // 0 if all bits are there
    output wire            out_inexact_o   // root^2 != x
);
    `RT_CHECK(XW % 2 == 0, rt_isqrt_XW_must_be_even)
    `RT_CHECK(STEP >= 1 && STEP <= XW/2, rt_isqrt_STEP_must_be_1_to_half_of_XW)
    `RT_CHECK(BITS == 0 || (BITS >= 2 && BITS < XW/2),
              rt_isqrt_BITS_must_be_0_or_2_to_less_than_half_of_XW)
    localparam ROUNDS = (XW/2 + STEP - 1) / STEP;
    localparam RW     = ROUNDS*STEP;       // root bits of whole rounds; the first ones are 0
    localparam BW     = BITS != 0 ? BITS : RW;
    localparam CUT    = BITS != 0;         // digits end when the top one is 1
    localparam CW     = $clog2(ROUNDS + 1);
    localparam [CW-1:0] FIRST = ROUNDS[CW-1:0];

    // ---- one round: STEP digits ----
    reg [2*RW-1:0] x_q;                    // radicand, next bits at the top
    reg [BW-1:0]   root_q;                 // digits so far
    reg [BW:0]     rem_q;                  // at most 2*root
    reg [2*RW-1:0] x_d;
    reg [BW-1:0]   root_d;
    reg [BW+2:0]   rem_d;
    reg [BW+2:0]   left;                   // rem - trial, top bit: it does not fit
    reg [5:0]      excess_d;                 // CUT: digits of this round behind the last one
    reg            lost_d;                 // CUT: a radicand bit of theirs is 1
    integer i;
    always @* begin
        x_d    = x_q;
        root_d = root_q;
        rem_d  = {2'd0, rem_q};
        left   = {(BW+3){1'b0}};
        excess_d = 6'd0;
        lost_d = 1'b0;
        for (i = 0; i < STEP; i = i + 1) begin
            if (CUT && i != 0 && root_d[BW-1]) begin
                excess_d = excess_d + 6'd1;
                lost_d = lost_d || x_d[2*RW-1 -: 2] != 2'd0;
            end else begin
                rem_d  = {rem_d[BW:0], x_d[2*RW-1 -: 2]};
                left   = rem_d - {1'b0, root_d, 2'b01};
                root_d = {root_d[BW-2:0], !left[BW+2]};
                if (!left[BW+2]) rem_d = left;
            end
            x_d = x_d << 2;
        end
    end

    // ---- control: rounds left; the result stays in the registers until it is taken ----
    reg          full_q;                   // a radicand or its root is inside
    reg [CW-1:0] count_q;                  // rounds left
    reg          none_q;                   // there are none
    wire         done = none_q || (CUT && root_q[BW-1]);
    wire         take = in_valid_i && in_ready_o;
    always @(posedge clk) begin
        if (take) begin
            full_q  <= 1'b1;
            count_q <= FIRST;
            none_q  <= 1'b0;
            x_q     <= {{(2*RW-XW){1'b0}}, in_x_i};
            root_q  <= {BW{1'b0}};
            rem_q   <= {(BW+1){1'b0}};
        end else if (!done) begin
            count_q <= count_q - 1'b1;
            none_q  <= count_q == 1;
            x_q     <= x_d;
            root_q  <= root_d;
            rem_q   <= rem_d[BW:0];
        end else if (out_ready_i) begin
            full_q <= 1'b0;
        end
        if (rst) begin
            full_q  <= 1'b0;
            count_q <= {CW{1'b0}};
            none_q  <= 1'b1;
        end
    end
    assign out_valid_o = full_q && done;
    assign in_ready_o  = !full_q;           // not in the clock in which a root is taken
    generate
        if (CUT) begin : g_cut
            localparam       STEP_BITS = STEP;     // as 32 bits
            localparam [5:0] DIGITS    = STEP_BITS[5:0];
            reg [5:0] excess_q;
            reg       lost_q;
            always @(posedge clk) if (!done) {excess_q, lost_q} <= {excess_d, lost_d};
            wire [5:0] rounds = {{(6-CW){1'b0}}, count_q};
            assign out_root_o    = root_q;
            assign out_shift_o   = rounds * DIGITS + excess_q;
            assign out_inexact_o = |rem_q || lost_q || |x_q;
        end else begin : g_all
            assign out_root_o    = root_q[XW/2-1:0];
            assign out_shift_o   = 6'd0;
            assign out_inexact_o = |rem_q;
            wire unused = &{1'b0, root_q, excess_d, lost_d};
        end
    endgenerate

    wire unused = &{1'b0, rem_d[BW+2:BW+1]};
endmodule
`default_nettype wire
