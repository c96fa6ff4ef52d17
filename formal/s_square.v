// s_square.v - all inputs of rt_square, one a clock: it keeps nothing, so this is every case
// SPDX-License-Identifier: Apache-2.0
`timescale 1ns / 1ps
`default_nettype none
module s_square #(
    parameter BITS = 14
);
    reg               clk = 1'b0;
    reg  [BITS:0]     n = {(BITS+1){1'b0}};   // clocks so far
    wire [2*BITS-1:0] square;
    rt_square #(.BITS(BITS)) u_dut (.clk(clk), .in_i(n[BITS-1:0]), .out_q(square));
    always #1 clk = !clk;
    wire [BITS:0]     taken = n - 3;          // at the 4th edge
    wire [2*BITS-1:0] r = {{(BITS-1){1'b0}}, taken};
    always @(negedge clk) begin
        if (n >= 3 && square !== r*r) begin
            $display("fails: square of %0d is %0d", taken, square);
            $finish;
        end else if (taken == {1'b0, {BITS{1'b1}}}) begin
            $display("proved");
            $finish;
        end
        n <= n + 1'b1;
    end
endmodule
`default_nettype wire
