// f_product.v - proof that rt_product of two chunks by one joins their products
// SPDX-License-Identifier: Apache-2.0
// As f_multiply.v.
`timescale 1ns / 1ps
`default_nettype none
module f_product #(
    parameter AW = 34,                   // 19 to 35
    parameter BW = 17                    // up to 18
) (
    input wire clk,
    input wire signed [AW-1:0] a,
    input wire signed [BW-1:0] b
);
    wire signed [AW+BW-1:0] p;
    rt_product #(.AW(AW), .BW(BW)) u_dut (.clk(clk), .a_i(a), .b_i(b), .p_o(p));
    (* hierconn *) wire [71:0] \u_dut.s1_p ;
    wire signed [35:0] low = \u_dut.s1_p [35:0], high = \u_dut.s1_p [71:36];
    function signed [35:0] times(input signed [17:0] x, input signed [17:0] y); times = x * y;
    endfunction
    reg [1:0] age_q = 2'd0;
    reg signed [35:0] low_q, high_q;             // products of the chunks
    reg [AW+BW-1:0]   sum_q;
    wire signed [AW+BW+35:0] high_wide = high, low_wide = low;
    wire [AW+BW+35:0] sum = (high_wide <<< 17) + low_wide;
    wire signed [17:0] b_all = b, a_high = a >>> 17, a_low = {1'b0, a[16:0]};
    always @(posedge clk) begin
        if (age_q != 3) age_q <= age_q + 1'b1;
        low_q  <= times(a_low, b_all);
        high_q <= times(a_high, b_all);
        sum_q  <= sum[AW+BW-1:0];
    end
    always @* if (age_q == 2) assert (low == low_q && high == high_q && p == sum_q);
endmodule
`default_nettype wire
