// f_divide.v - proof of rt_divide: key = ceil(x / d)
// SPDX-License-Identifier: Apache-2.0
// With MULTIPLY a division taken in the first clock has this key ROUNDS + 1 clocks later: small
// widths. Without, every round makes the digits of which digits.smt2 shows it for integers, and the
// last one is rounded up: all widths.
`timescale 1ns / 1ps
`default_nettype none
module f_divide #(
    parameter DW   = 6,
    parameter QW   = 5,
    parameter STEP = 2,
    parameter MULTIPLY = 0
) (
    input wire             clk,
    input wire             in_valid,
    input wire [DW+QW-1:0] x,
    input wire [DW-1:0]    d,
    input wire             out_ready
);
    localparam ROUNDS = (QW + STEP - 1) / STEP;
    localparam MW     = ROUNDS*STEP;
    localparam CW     = $clog2(ROUNDS + 1);
    localparam X      = DW + QW + 2;
    wire in_ready, out_valid;
    wire [QW:0] key;
    rt_divide #(.DW(DW), .QW(QW), .STEP(STEP)) u_dut (
        .clk(clk), .rst(1'b0), .in_valid_i(in_valid), .in_ready_o(in_ready), .in_x_i(x),
        .in_d_i(d), .out_valid_o(out_valid), .out_ready_i(out_ready), .out_key_o(key)
    );
    (* hierconn *) wire          \u_dut.full_q , \u_dut.none_q ;
    (* hierconn *) wire [CW-1:0] \u_dut.count_q ;
    (* hierconn *) wire [DW-1:0] \u_dut.rem_q , \u_dut.d_q ;
    (* hierconn *) wire [MW-1:0] \u_dut.low_q ;
    reg [7:0]       age_q = 8'd0;
    reg [DW+QW-1:0] x_q;
    reg [DW-1:0]    d_q;
    wire [X-1:0]    product = key * d_q, x_w = x_q, d_w = d_q;
    always @(posedge clk) begin
        if (age_q != 255) age_q <= age_q + 1'b1;
        if (age_q == 0) {x_q, d_q} <= {x, d};
    end
    generate
        if (MULTIPLY != 0) begin : g_multiply
            always @* begin
                if (age_q == 0) assume (in_valid && in_ready && x[DW+QW-1:QW] < d);
                if (age_q == ROUNDS + 1)
                    assert (out_valid && product >= x_w && product < x_w + d_w);
            end
        end
    endgenerate

    // ---- a round: STEP times 2 rem + the next bit of x, less d if that is possible ----
    reg             round_q, took_q;
    reg [CW-1:0]    count_q;
    reg [DW-1:0]    in_d_q, rem_q;
    reg [MW-1:0]    low_q, low_d;
    reg [DW+1:0]    rem_d;
    integer i;
    always @* begin
        rem_d = rem_q;
        low_d = low_q;
        for (i = 0; i < STEP; i = i + 1) begin
            rem_d = {rem_d[DW:0], low_d[MW-1]};
            low_d = {low_d[MW-2:0], rem_d >= in_d_q};
            if (low_d[0]) rem_d = rem_d - in_d_q;
        end
    end
    always @(posedge clk) begin
        took_q  <= in_valid && in_ready;
        round_q <= !(in_valid && in_ready) && \u_dut.full_q && !\u_dut.none_q ;
        count_q <= \u_dut.count_q ;
        in_d_q  <= in_valid && in_ready ? d : \u_dut.d_q ;
        rem_q   <= \u_dut.rem_q ;
        low_q   <= \u_dut.low_q ;
    end
    always @* if (age_q == 0) assume (\u_dut.none_q == (\u_dut.count_q == 0));
    always @* if (age_q == 1 && MULTIPLY == 0) begin
        assert (\u_dut.none_q == (\u_dut.count_q == 0));
        assume (rem_q < in_d_q || took_q);
        assume (count_q <= ROUNDS);
        if (took_q) assert (\u_dut.count_q == ROUNDS && \u_dut.d_q == d_q);
        if (took_q) assert ({\u_dut.rem_q , \u_dut.low_q } == {{(MW-QW){1'b0}}, x_q});
        if (round_q) assert (\u_dut.rem_q == rem_d && \u_dut.low_q == low_d && rem_d < in_d_q);
        if (round_q) assert (\u_dut.count_q == count_q - 1'b1 && \u_dut.d_q == in_d_q);
        if (out_valid) assert (key == \u_dut.low_q [QW-1:0] + (\u_dut.rem_q != 0));
    end
endmodule
`default_nettype wire
