// f_multiply.v - proof that rt_multiply joins the products of its chunks, at its widths
// SPDX-License-Identifier: Apache-2.0
// Factors come in any clock, others before and behind them. Products of chunks, C*C of 36 bits, are
// any that are not too great (products.smt2): from what they are after a clock the sum of all, each
// in its place, is the result, modulo 2^2W, which holds it.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_fx.vh"
module f_multiply #(
    parameter W = 35
) (
    input wire clk,
    input wire signed [W-1:0] a, b
);
    localparam C = `RT_MUL_CHUNKS(W);
    localparam L = `RT_MUL_LATENCY(W);
    wire signed [2*W-1:0] p;
    rt_multiply #(.W(W)) u_dut (.clk(clk), .in_valid_i(1'b1), .a_i(a), .b_i(b), .p_o(p));
    (* hierconn *) wire [36*C*C-1:0] \u_dut.g_many.s1_p ;
    wire [36*C*C-1:0] s1_p = \u_dut.g_many.s1_p ;
    reg [3:0] age_q = 4'd0;
    function signed [35:0] times(input signed [17:0] x, input signed [17:0] y); times = x * y;
    endfunction
    wire [17*C:0] a_all = {{(17*C+1-W){a[W-1]}}, a}, b_all = {{(17*C+1-W){b[W-1]}}, b};
    wire [C*C-1:0]   ok, fit;
    wire [2*W-1:0]   sum [0:C*C];
    reg  [2*W*L-1:0] late_q;
    wire [2*W*(L+1)-1:0] late = {late_q, sum[C*C]};
    assign sum[0] = 0;
    genvar i, j;
    generate
        for (i = 0; i < C; i = i + 1) begin : g_row
            for (j = 0; j < C; j = j + 1) begin : g_column
                wire signed [17:0] ca = {i == C-1 ? a_all[17*C] : 1'b0, a_all[17*i +: 17]};
                wire signed [17:0] cb = {j == C-1 ? b_all[17*C] : 1'b0, b_all[17*j +: 17]};
                wire signed [35:0] now = s1_p[36*(C*i+j) +: 36];
                reg  signed [35:0] should_q;
                wire signed [2*W+35:0] wide = now;
                always @(posedge clk) should_q <= times(ca, cb);
                assign ok[C*i+j] = now == should_q;
                // of two chunks without sign: 0 to 2^34 - 1
                assign fit[C*i+j] = i == C-1 || j == C-1 || now[35:34] == 2'd0;
                wire [2*W+35:0] put = wide <<< (17*(i+j));
                assign sum[C*i+j+1] = sum[C*i+j] + put[2*W-1:0];
            end
        end
    endgenerate
    always @(posedge clk) begin
        if (age_q != 15) age_q <= age_q + 1'b1;
        late_q <= late[2*W*L-1:0];
    end
    always @* begin
        if (age_q == 1) assume (&fit);
        if (age_q == L) assert (p == late[2*W*L-1 -: 2*W]);
        if (age_q != 0) assert (&ok);
    end
endmodule
`default_nettype wire
