// rt_isqrt.v - integer square roots, or their first bits, STEP bits a clock, in STAGES stages
// SPDX-License-Identifier: Apache-2.0
// root = floor(sqrt(x)), inexact = (root^2 != x). Digit by digit: two radicand bits enter rem, and
// the trial 4*root+1 is subtracted if it fits. Invariant: rem = x / 4^i - root^2 <= 2*root.
//   x --> digits of INTERVAL clocks --> as many --> ... --> those that are left --> root
// A stage works on one root, and is as wide as the digits that are there behind it. A result comes
// ROUNDS + 1 clocks after its radicand, whatever else is under way, and is there for one clock; a
// radicand is taken each INTERVAL = floor(ROUNDS / STAGES) + 1 clocks, ROUNDS = ceil(XW/2/STEP).
// BITS not 0: digits behind the first BITS from the top 1 on are not made, but counted.
// Model: sph_isqrt_bits() in cmodel/math/arith.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
module rt_isqrt #(
    parameter XW     = 66,                 // radicand, bits: even
    parameter STEP   = 2,                  // root bits a clock: 1 to XW/2
    parameter BITS   = 0,                  // significant bits of the root: 2 to XW/2-1, 0: all
    parameter STAGES = 1,                  // roots under way at once
    parameter TAG    = 1                   // what goes along with a radicand, bits
) (
    input  wire            clk,
    input  wire            rst,            // synchronous, active high
    // from rt_sphere_key
    input  wire            in_valid_i,
    output wire            in_ready_o,
    input  wire [XW-1:0]   in_x_i,         // uXW
    input  wire [TAG-1:0]  in_tag_i,
    // to rt_sphere_key
    output wire            out_valid_o,    // for one clock
    output wire [(BITS != 0 ? BITS : XW/2)-1:0] out_root_o,  // root / 2^shift
    output wire [5:0]      out_shift_o,    // 0 if all bits are there
    output wire            out_inexact_o,  // root^2 != x
    output wire [TAG-1:0]  out_tag_o
);
    `RT_CHECK(XW % 2 == 0, rt_isqrt_XW_must_be_even)
    `RT_CHECK(STEP >= 1 && STEP <= XW/2, rt_isqrt_STEP_must_be_1_to_half_of_XW)
    `RT_CHECK(BITS == 0 || (BITS >= 2 && BITS < XW/2),
              rt_isqrt_BITS_must_be_0_or_2_to_less_than_half_of_XW)
    `RT_CHECK(STAGES >= 1, rt_isqrt_STAGES_must_be_at_least_1)
    localparam ROUNDS   = (XW/2 + STEP - 1) / STEP;
    localparam RW       = ROUNDS*STEP;     // root bits of whole rounds; the first ones are 0
    localparam BW       = BITS != 0 ? BITS : RW;
    localparam INTERVAL = ROUNDS / STAGES + 1;
    localparam LAST     = ROUNDS / INTERVAL;      // number of the last stage

    // ---- roots under way: bit k in the k-th clock after their radicand ----
    reg  [ROUNDS+1:1] age_q;
    wire [ROUNDS+1:0] age = {age_q, in_valid_i && in_ready_o};
    always @(posedge clk) age_q <= rst ? {(ROUNDS+1){1'b0}} : age[ROUNDS:0];
    assign in_ready_o  = (age_q & ~({(ROUNDS+1){1'b1}} << (INTERVAL-1))) == {(ROUNDS+1){1'b0}};
    assign out_valid_o = age_q[ROUNDS+1];

    // ---- stages: what leaves stage s is in field s + 1 ----
    localparam SW = TAG + 1 + 6 + BW+1 + BW + 2*RW;   // {tag, lost, shift, rem, root, x}
    wire [SW*(LAST+2)-1:0] all;
    assign all[SW-1:0] = {in_tag_i, {(SW-TAG-XW){1'b0}}, in_x_i};
    genvar s;
    generate
        for (s = 0; s <= LAST; s = s + 1) begin : g_stage
            localparam BEFORE = s*INTERVAL;                    // rounds before it
            localparam CLOCKS = s == LAST ? ROUNDS - BEFORE : INTERVAL;  // rounds of its own
            localparam KEPT   = s == LAST ? CLOCKS : CLOCKS-1; // the next stage keeps the last one
            localparam DIGITS = (BEFORE + CLOCKS)*STEP;        // root bits behind it
            localparam RB     = DIGITS < 2 ? 2 : DIGITS < BW ? DIGITS : BW;
            localparam CUT    = DIGITS > BW;                   // digits may end in it
            localparam MOVED  = CLOCKS < 2 ? 0 : 2*(CLOCKS-1)*STEP;  // bits of x that move up
            localparam [2*RW-1:0] STAY = {(2*RW){1'b1}} >> MOVED;
            wire           load  = age[BEFORE];
            wire           round = |(age[BEFORE +: KEPT+1] >> 1);
            wire [TAG-1:0] in_tag;
            wire           in_lost;
            wire [5:0]     in_shift;
            wire [BW:0]    in_rem;
            wire [BW-1:0]  in_root;
            wire [2*RW-1:0] in_x;
            assign {in_tag, in_lost, in_shift, in_rem, in_root, in_x} = all[SW*s +: SW];

            // one round: STEP digits
            reg [TAG-1:0]  tag_q;
            reg            lost_q, lost_d;                     // CUT: a bit of x behind them is 1
            reg [5:0]      shift_q, shift_d;                   // CUT: digits behind the last one
            reg [RB:0]     rem_q;                              // at most 2*root
            reg [RB-1:0]   root_q, root_d;                     // digits so far
            reg [2*RW-1:0] x_q, x_d;                           // next bits at the top
            reg [RB+2:0]   rem_d, left;                        // left: top bit: it does not fit
            integer i;
            always @* begin
                lost_d  = lost_q;
                shift_d = shift_q;
                rem_d   = {2'd0, rem_q};
                root_d  = root_q;
                x_d     = x_q;
                left    = {(RB+3){1'b0}};
                for (i = 0; i < STEP; i = i + 1) begin
                    if (CUT && root_d[RB-1]) begin
                        lost_d  = lost_d || x_d[2*RW-1 -: 2] != 2'd0;
                        shift_d = shift_d + 6'd1;
                    end else begin
                        rem_d  = {rem_d[RB:0], x_d[2*RW-1 -: 2]};
                        left   = rem_d - {1'b0, root_d, 2'b01};
                        root_d = {root_d[RB-2:0], !left[RB+2]};
                        if (!left[RB+2]) rem_d = left;
                    end
                    x_d = x_d << 2;
                end
            end
            always @(posedge clk)
                if (load) begin
                    {tag_q, lost_q, shift_q} <= {in_tag, in_lost, in_shift};
                    rem_q  <= in_rem[RB:0];
                    root_q <= in_root[RB-1:0];
                    x_q    <= in_x;
                end else if (round) begin
                    {lost_q, shift_q} <= {lost_d, shift_d};
                    rem_q  <= rem_d[RB:0];
                    root_q <= root_d;
                    x_q    <= (x_d & ~STAY) | (x_q & STAY);
                end
            wire [RB:0]   rem  = s == LAST ? rem_q : rem_d[RB:0];
            wire [RB-1:0] root = s == LAST ? root_q : root_d;
            assign all[SW*(s+1) +: SW] = {
                tag_q, s == LAST ? {lost_q, shift_q} : {lost_d, shift_d},
                {{(BW-RB){1'b0}}, rem}, {{(BW-RB){1'b0}}, root}, x_q << 2*CLOCKS*STEP};
            wire unused = &{1'b0, in_rem, in_root, rem_d, left};
        end
    endgenerate

    // ---- result ----
    wire [BW:0]     rem;
    wire [BW-1:0]   root;
    wire            lost;
    wire [2*RW-1:0] no_x;
    assign {out_tag_o, lost, out_shift_o, rem, root, no_x} = all[SW*(LAST+1) +: SW];
    assign out_root_o    = root[(BITS != 0 ? BITS : XW/2)-1:0];
    assign out_inexact_o = |rem || lost;
    wire unused = &{1'b0, root, no_x};
endmodule
`default_nettype wire
