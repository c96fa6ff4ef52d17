// rt_rr_arbiter.v - whose turn it is: round robin among those that ask
// SPDX-License-Identifier: Apache-2.0
// The first one above the one served last, else the first of all; so who asks waits for at most
// N-1 others. Combinational from asks_i; served_i tells that the one chosen is served in this
// clock. After reset the lowest goes first.
`timescale 1ns / 1ps
`default_nettype none
module rt_rr_arbiter #(
    parameter N = 4                    // those that may ask, at least 1
) (
    input  wire         clk,
    input  wire         rst,           // synchronous, active high
    input  wire [N-1:0] asks_i,
    input  wire         served_i,      // some ask, and the one in turn is served
    output wire [N-1:0] turn_o,        // one-hot; nobody's while none asks
    output reg  [(N > 1 ? $clog2(N) : 1)-1:0] index_o  // its number; 0 while none asks
);
    localparam NB = N > 1 ? $clog2(N) : 1;
    reg  [N-1:0] above_q;              // those above the one served last
    wire [N-1:0] high = asks_i & above_q;
    wire [N-1:0] from = |high ? high : asks_i;
    assign turn_o = from & (~from + 1'b1);
    integer i;
    always @* begin
        index_o = {NB{1'b0}};
        for (i = 0; i < N; i = i + 1) if (turn_o[i]) index_o = index_o | i[NB-1:0];
    end
    always @(posedge clk) begin
        if (served_i) above_q <= ~(turn_o | (turn_o - 1'b1));
        if (rst)      above_q <= {N{1'b0}};
    end
endmodule
`default_nettype wire
