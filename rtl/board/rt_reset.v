// rt_reset.v - a reset that lasts until 16 clocks after what asks for it is gone
// SPDX-License-Identifier: Apache-2.0
// hold_i is of no clock: it comes through two flip-flops. The flip-flops start in reset, as those
// of an ECP5 do when it is configured.
`timescale 1ns / 1ps
`default_nettype none
module rt_reset (
    input  wire clk,
    input  wire hold_i,
    output reg  rst_o = 1'b1
);
    wire hold;
    reg  [3:0] left_q = 4'd15;            // clocks to wait
    rt_sync u_hold (.clk(clk), .d_i(hold_i), .q_o(hold));
    always @(posedge clk) begin
        rst_o <= hold || left_q != 4'd0;
        if (left_q != 4'd0) left_q <= left_q - 4'd1;
        if (hold) left_q <= 4'd15;
    end
endmodule
`default_nettype wire
