// rt_reset_pair.v - a reset of either clock resets both sides of a crossing, however short it is
// SPDX-License-Identifier: Apache-2.0
//   a_rst --> request, until side b is in reset --> b_rst_o        and the same the other way
// A side is in reset while its own reset is high, while its request waits, and while the other
// side asks. So each side sees the other one in reset before it leaves its own for good.
// At power-up both resets are held until both clocks run.
`timescale 1ns / 1ps
`default_nettype none
module rt_reset_pair (
    input  wire a_clk,
    input  wire a_rst,                    // synchronous to a_clk, active high
    output wire a_rst_o,                  // reset of side a
    input  wire b_clk,
    input  wire b_rst,                    // synchronous to b_clk, active high
    output wire b_rst_o                   // reset of side b
);
    reg  a_q, a_held_q;                   // request of side a; it is in reset
    reg  b_q, b_held_q;
    wire a_seen, a_held_seen;             // in b_clk
    wire b_seen, b_held_seen;             // in a_clk
    assign a_rst_o = a_rst || a_q || b_seen;
    assign b_rst_o = b_rst || b_q || a_seen;
    always @(posedge a_clk) begin
        a_held_q <= a_rst_o;
        a_q      <= a_rst || (a_q && !b_held_seen);
    end
    always @(posedge b_clk) begin
        b_held_q <= b_rst_o;
        b_q      <= b_rst || (b_q && !a_held_seen);
    end
    rt_sync #(.WIDTH(2)) u_to_a (.clk(a_clk), .d_i({b_q, b_held_q}), .q_o({b_seen, b_held_seen}));
    rt_sync #(.WIDTH(2)) u_to_b (.clk(b_clk), .d_i({a_q, a_held_q}), .q_o({a_seen, a_held_seen}));
endmodule
`default_nettype wire
