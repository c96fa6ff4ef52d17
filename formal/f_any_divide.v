// f_any_divide.v - stand for rt_long_product, rt_divide in proofs: results at any time
// SPDX-License-Identifier: Apache-2.0
// What is made of a product or quotient must not depend on how long it takes or what it is: factors
// side by side stand for a product; a quotient is anything, and its operands are kept beside it.
`timescale 1ns / 1ps
`default_nettype none
module rt_long_product #(
    parameter AW = 50,
    parameter BW = 34,
    parameter BN = 17
) (
    input  wire             clk,
    input  wire             rst,
    input  wire             start_i,
    output wire             ready_o,
    input  wire             narrow_i,
    input  wire [AW-1:0]    a_i,
    input  wire [BW-1:0]    b_i,
    output wire             done_o,
    output wire [AW+BW-1:0] p_o,
    output wire [AW+BN-1:0] narrow_o
);
    (* anyseq *) wire ends;
    (* anyseq *) wire [AW+BW-1:0] any;       // operands did not stand still
    reg               busy_q;
    reg [1:0]         come_q;                // clocks behind the last step
    reg [AW+BW-1:0]   p_q, next_q;
    reg               first_q, odd_q;
    reg [AW+BW:0]     stood_q;
    wire              last = busy_q && ends;
    wire              odd = !first_q && (odd_q || stood_q != {narrow_i, a_i, b_i});
    assign ready_o  = !busy_q || last;
    assign done_o   = come_q[1];
    assign p_o      = p_q;
    assign narrow_o = {p_q[AW+BW-1 -: AW], p_q[BN-1:0]};
    always @(posedge clk) begin
        if (ready_o) busy_q <= start_i;
        first_q <= ready_o;
        stood_q <= {narrow_i, a_i, b_i};
        odd_q   <= odd;
        come_q <= {come_q[0], last};
        if (last) next_q <= odd ? any : {a_i, b_i};
        if (come_q[0]) p_q <= next_q;
        if (rst) begin
            busy_q <= 1'b0;
            come_q <= 2'd0;
        end
    end
    // a row takes two clocks or more
    always @* assume (!(last && (first_q || come_q[0])));
endmodule
module rt_divide #(
    parameter DW   = 50,
    parameter QW   = 34,
    parameter STEP = 2,
    parameter AT_ONCE = 1
) (
    input  wire             clk,
    input  wire             rst,
    input  wire             in_valid_i,
    output wire             in_ready_o,
    input  wire [DW+QW-1:0] in_x_i,
    input  wire [DW-1:0]    in_d_i,
    output wire             out_valid_o,
    input  wire             out_ready_i,
    output wire [QW:0]      out_key_o
);
    (* anyseq *) wire  ends;
    (* anyseq *) wire [QW:0] any;
    reg                full_q, done_q;
    reg [2*DW+QW-1:0]  all_q;
    reg [QW:0]         key_q;
    assign out_valid_o = full_q && done_q;
    assign in_ready_o  = !full_q || (AT_ONCE != 0 && out_valid_o && out_ready_i);
    assign out_key_o   = key_q;
    always @(posedge clk) begin
        if (full_q && ends)             done_q <= 1'b1;
        if (out_valid_o && out_ready_i) full_q <= 1'b0;
        if (in_valid_i && in_ready_o) begin
            full_q <= 1'b1;
            done_q <= 1'b0;
            all_q  <= {in_x_i, in_d_i};
            key_q  <= any;
        end
        if (rst) full_q <= 1'b0;
    end
endmodule
`default_nettype wire
