// f_long_product.v - proof that rt_long_product is the product of its operands
// SPDX-License-Identifier: Apache-2.0
// From any state: a product begins in clock 0, others before and behind it. The products of pieces
// are any function of them, at most (2^17 - 1)^2 (products.smt2).
`timescale 1ns / 1ps
`default_nettype none
module f_long_product #(
    parameter AW = 50,
    parameter BW = 34
) (
    input wire          clk,
    input wire          rst, start,
    input wire [AW-1:0] a,
    input wire [BW-1:0] b
);
    localparam A = (AW + 16) / 17, B = (BW + 16) / 17, PW = 17*(A + B);
    localparam [33:0] MOST = (35'd1 << 34) - (34'd1 << 18) + 1;
    wire done;
    wire [AW+BW-1:0] p;
    rt_long_product #(.AW(AW), .BW(BW)) u_dut (
        .clk(clk), .rst(rst), .start_i(start), .a_i(a), .b_i(b), .done_o(done), .p_o(p)
    );
    reg  [5:0]    age_q = 6'd0;
    reg  [AW-1:0] a_q;
    reg  [BW-1:0] b_q;
    function [33:0] times(input [16:0] x, input [16:0] y); times = x * y;
    endfunction
    (* anyseq *) wire [17*A-1:0] a_all;              // a constant bit would leave its product
    (* anyseq *) wire [17*B-1:0] b_all;
    wire [A*B-1:0] fit;
    wire [PW-1:0]  sum [0:A*B], all;
    assign sum[0] = 0;
    assign all = sum[A*B];
    genvar i, j;
    generate
        for (j = 0; j < B; j = j + 1) begin : g_row
            for (i = 0; i < A; i = i + 1) begin : g_piece
                wire [33:0]   one  = times(a_all[17*i +: 17], b_all[17*j +: 17]);
                wire [PW-1:0] wide = one;
                assign fit[A*j+i] = one <= MOST;
                assign sum[A*j+i+1] = sum[A*j+i] + (wide << 17*(i + j));
            end
        end
    endgenerate
    always @(posedge clk) begin
        if (!(&age_q)) age_q <= age_q + 1'b1;
        if (age_q == 0) {a_q, b_q} <= {a, b};
    end
    always @* begin
        assume (!rst);
        if (age_q == 0) assume (start);
        if (age_q >= 1 && age_q < B) assume (!start);
        if (age_q == B + 3) begin
            assume (a_all == a_q && b_all == b_q && &fit);
            assert (done);
            assert (p == all[AW+BW-1:0]);
        end
    end
endmodule
`default_nettype wire
