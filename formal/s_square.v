// s_square.v - all 2^14 inputs of rt_square, one a clock: it keeps nothing, so this is every case
// SPDX-License-Identifier: Apache-2.0
`timescale 1ns / 1ps
`default_nettype none
module s_square;
    reg         clk = 1'b0;
    reg  [14:0] n = 15'd0;               // clocks so far
    wire [27:0] square;
    rt_square u_dut (.clk(clk), .in_i(n[13:0]), .out_q(square));
    always #1 clk = !clk;
    wire [14:0] taken = n - 15'd3;       // at the 4th edge
    wire [27:0] r = {13'd0, taken};
    always @(negedge clk) begin
        if (n >= 3 && square !== r*r) begin
            $display("fails: square of %0d is %0d", taken, square);
            $finish;
        end else if (taken == 15'h3fff) begin
            $display("proved");
            $finish;
        end
        n <= n + 15'd1;
    end
endmodule
`default_nettype wire
