// rt_divide.v - quotient rounded up, STEP bits a clock
// SPDX-License-Identifier: Apache-2.0
// key = ceil(x / d). Restoring division; the quotient enters below as x leaves above. Invariant:
// rem < d. One division at a time: a result ceil(QW/STEP) + 1 clocks after its operands.
// Model: the division in sph_facet_key(), cmodel/prim/facet.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
module rt_divide #(
    parameter DW   = 50,                     // divisor, bits
    parameter QW   = 34,                     // quotient, bits: x < d * 2^QW
    parameter STEP = 2,                      // quotient bits a clock: 1 to QW
    parameter AT_ONCE = 1                    // 1: operands may come as a result leaves, 0: behind it
) (
    input  wire             clk,
    input  wire             rst,             // synchronous, active high
    // from rt_facet_key
    input  wire             in_valid_i,
    output wire             in_ready_o,
    input  wire [DW+QW-1:0] in_x_i,          // u(DW+QW)
    input  wire [DW-1:0]    in_d_i,          // uDW, > 0
    // to rt_facet_key
    output wire             out_valid_o,
    input  wire             out_ready_i,
    output wire [QW:0]      out_key_o        // u(QW+1)
);
    `RT_CHECK(STEP >= 1 && STEP <= QW, rt_divide_STEP_must_be_1_to_QW)
    localparam ROUNDS = (QW + STEP - 1) / STEP;
    localparam MW     = ROUNDS*STEP;         // quotient bits of whole rounds; the first ones are 0
    localparam CW     = $clog2(ROUNDS + 1);
    localparam [CW-1:0] FIRST = ROUNDS[CW-1:0];

    // ---- one round: STEP quotient bits ----
    reg [DW-1:0] rem_q, rem_d;
    reg [MW-1:0] low_q, low_d;               // rest of x, then the quotient
    reg [DW-1:0] d_q;
    reg [DW+1:0] left;                       // top bit: d does not fit
    integer i;
    always @* begin
        rem_d = rem_q;
        low_d = low_q;
        left  = {(DW+2){1'b0}};
        for (i = 0; i < STEP; i = i + 1) begin
            left  = {1'b0, rem_d, low_d[MW-1]} - {2'd0, d_q};
            rem_d = left[DW+1] ? {rem_d[DW-2:0], low_d[MW-1]} : left[DW-1:0];
            low_d = {low_d[MW-2:0], !left[DW+1]};
        end
    end

    // ---- control: rounds left; the result stays in the registers until it is taken ----
    reg          full_q;                     // operands or their quotient are inside
    reg [CW-1:0] count_q;
    reg          none_q;                     // there are none
    wire         take = in_valid_i && in_ready_o;
    wire [DW+MW:0] x = {{(MW-QW+1){1'b0}}, in_x_i};
    always @(posedge clk) begin
        if (take) begin
            full_q  <= 1'b1;
            count_q <= FIRST;
            none_q  <= 1'b0;
            {rem_q, low_q} <= x[DW+MW-1:0];
            d_q     <= in_d_i;
        end else if (!none_q) begin
            count_q <= count_q - 1'b1;
            none_q  <= count_q == 1;
            rem_q   <= rem_d;
            low_q   <= low_d;
        end else if (out_ready_i) begin
            full_q <= 1'b0;
        end
        if (rst) begin
            full_q  <= 1'b0;
            count_q <= {CW{1'b0}};
            none_q  <= 1'b1;
        end
    end
    assign out_valid_o = full_q && none_q;
    assign in_ready_o  = !full_q || (AT_ONCE != 0 && out_valid_o && out_ready_i);
    assign out_key_o   = {1'b0, low_q[QW-1:0]} + {{QW{1'b0}}, |rem_q};

    wire unused = &{1'b0, low_q, left[DW], x[DW+MW]};
endmodule
`default_nettype wire
