// rt_quotient.v - t = key / a as a normalised number, STEP bits a clock
// SPDX-License-Identifier: Apache-2.0
// Both operands are shifted left until their top bit is set, by STEP or 1 a clock; then restoring
// division gives mant = floor(key' / a' * 2^(PQ-1)): key / a = mant * 2^-exp, truncated.
// One quotient at a time. It takes n(z) + ceil(PQ/STEP) + 2 clocks with n = floor(z/STEP) + z%STEP,
// that of the two operands' leading zeros z whose n is greater, and a clock more until the next
// operands. Model: sph_quotient() in math/arith.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
module rt_quotient #(
    parameter KW   = 35,                     // key, bits
    parameter AW   = 34,                     // a, bits
    parameter PQ   = 17,                     // quotient, bits
    parameter STEP = 2                       // quotient bits a clock: 1 to PQ
) (
    input  wire              clk,
    input  wire              rst,            // synchronous, active high
    // from the engine
    input  wire              in_valid_i,
    output wire              in_ready_o,
    input  wire [KW-1:0]     in_key_i,       // uKW, > 0
    input  wire [AW-1:0]     in_a_i,         // uAW, > 0
    // to rt_hit
    output wire              out_valid_o,
    input  wire              out_ready_i,
    output wire [PQ-1:0]     out_mant_o,     // u1.(PQ-1), or half of it
    output wire signed [7:0] out_exp_o       // s8, t = mant * 2^-exp
);
    `RT_CHECK(STEP >= 1 && STEP <= PQ, rt_quotient_STEP_must_be_1_to_PQ)
    `RT_CHECK(KW <= 64 && AW <= 64, rt_quotient_KW_and_AW_must_be_at_most_64)
    localparam W      = KW > AW ? KW : AW;
    localparam ROUNDS = (PQ + STEP - 1) / STEP;
    localparam MW     = ROUNDS*STEP;         // quotient bits of whole rounds
    localparam CW     = $clog2(ROUNDS + 1);
    localparam [CW-1:0]     FIRST = ROUNDS[CW-1:0];
    localparam STEP_BITS = STEP;             // as 32 bits
    localparam EXP_FULL = PQ - 1 - KW + AW;
    localparam signed [7:0] EXP   = EXP_FULL[7:0];

    // ---- normalise: STEP bits at once while the top STEP are 0, then single ones ----
    localparam signed [7:0] MANY = STEP_BITS[7:0];
    reg [W:0]   rem_q;                       // key, then the remainder, below 2*div
    reg [W-1:0] div_q;                       // a
    wire key_many = rem_q[W-1 -: STEP] == {STEP{1'b0}};
    wire key_one  = !rem_q[W-1];
    wire a_many   = div_q[W-1 -: STEP] == {STEP{1'b0}};
    wire a_one    = !div_q[W-1];
    wire signed [7:0] up   = key_many ? MANY : key_one ? 8'sd1 : 8'sd0;
    wire signed [7:0] down = a_many   ? MANY : a_one   ? 8'sd1 : 8'sd0;

    // ---- one round: STEP quotient bits; while normalising, the shift without subtracting: then
    // rem is below 2^W, and 2^W more than div does not fit ----
    reg          ready_q;                    // both operands are normalised
    reg [MW-1:0] mant_q, mant_d;
    reg [W:0]    rem_d;
    reg [W+1:0]  left;                       // rem - div, top bit: negative
    integer i;
    always @* begin
        rem_d  = rem_q;
        mant_d = mant_q;
        left   = {(W+2){1'b0}};
        for (i = 0; i < STEP; i = i + 1) begin
            left   = {1'b0, rem_d} - {1'b0, !ready_q, div_q};
            mant_d = {mant_d[MW-2:0], !left[W+1]};
            rem_d  = {left[W+1] ? rem_d[W-1:0] : left[W-1:0], 1'b0};
        end
    end

    // ---- control; the result stays in the registers until it is taken ----
    reg              full_q;                 // operands or their quotient are inside
    reg [CW-1:0]     count_q;                // rounds left
    reg              none_q;                 // there are none
    reg signed [7:0] exp_q;
    wire             take = in_valid_i && in_ready_o;
    always @(posedge clk) begin
        if (take) begin
            full_q  <= 1'b1;
            ready_q <= 1'b0;
            count_q <= FIRST;
            none_q  <= 1'b0;
            exp_q   <= EXP;
        end else if (full_q && !ready_q) begin
            ready_q <= !key_one && !a_one;
            exp_q   <= exp_q + up - down;
        end else if (!none_q) begin
            count_q <= count_q - 1'b1;
            none_q  <= count_q == 1;
            mant_q  <= mant_d;
        end else if (out_ready_i) begin
            full_q <= 1'b0;
        end
        if (!full_q || out_valid_o)    rem_q <= {1'b0, in_key_i, {(W-KW){1'b0}}};
        else if (ready_q || key_many)  rem_q <= rem_d;
        else if (key_one)              rem_q <= {rem_q[W-1:0], 1'b0};
        if (!full_q || out_valid_o)    div_q <= {in_a_i, {(W-AW){1'b0}}};
        else if (!ready_q && a_many)   div_q <= div_q << STEP;
        else if (!ready_q && a_one)    div_q <= {div_q[W-2:0], 1'b0};
        if (rst) begin
            full_q  <= 1'b0;
            count_q <= {CW{1'b0}};
            none_q  <= 1'b1;
        end
    end
    assign out_valid_o = full_q && ready_q && none_q;
    assign in_ready_o  = !full_q;            // not in the clock in which a quotient is taken
    assign out_mant_o  = mant_q[MW-1 -: PQ];
    assign out_exp_o   = exp_q;

    wire unused = &{1'b0, mant_q, left[W]};
endmodule
`default_nettype wire
