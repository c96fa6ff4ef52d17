// f_isqrt_bits.v - proof of rt_isqrt with BITS: the first BITS bits of the root, and what is lost
// SPDX-License-Identifier: Apache-2.0
// With s = shift and root the bits there are: root^2 <= x / 4^s < (root+1)^2; s is 0, or root has
// all BITS bits; inexact = ((root 2^s)^2 != x). The square is kept digit by digit, as f_isqrt.v
// does it, or with MULTIPLY is that of a multiplier: small widths.
`timescale 1ns / 1ps
`default_nettype none
module f_isqrt_bits #(
    parameter XW       = 10,
    parameter STEP     = 2,
    parameter BITS     = 3,
    parameter MULTIPLY = 0
) (
    input wire          clk,
    input wire          rst,
    input wire          in_valid,
    input wire [XW-1:0] in_x,
    input wire          out_ready
);
    localparam ROUNDS = (XW/2 + STEP - 1) / STEP;
    localparam RW     = ROUNDS*STEP;
    localparam CW     = $clog2(ROUNDS + 1);
    localparam SW     = 2*RW + 2;        // of x and squares
    wire in_ready, out_valid, out_inexact;
    wire [BITS-1:0] out_root;
    wire [5:0]      out_shift;
    rt_isqrt #(.XW(XW), .STEP(STEP), .BITS(BITS)) u_dut (
        .clk(clk), .rst(rst), .in_valid_i(in_valid), .in_ready_o(in_ready), .in_x_i(in_x),
        .out_valid_o(out_valid), .out_ready_i(out_ready), .out_root_o(out_root),
        .out_shift_o(out_shift), .out_inexact_o(out_inexact)
    );
    (* hierconn *) wire            \u_dut.full_q ;
    (* hierconn *) wire [CW-1:0]   \u_dut.count_q ;
    (* hierconn *) wire            \u_dut.none_q ;
    (* hierconn *) wire [2*RW-1:0] \u_dut.x_q ;
    (* hierconn *) wire [BITS-1:0] \u_dut.root_q ;
    (* hierconn *) wire [BITS:0]   \u_dut.rem_q ;
    (* hierconn *) wire [BITS-1:0] \u_dut.root_d ;
    (* hierconn *) wire [5:0]      \u_dut.excess_d ;
    (* hierconn *) wire            \u_dut.done ;
    (* hierconn *) wire [5:0]      \u_dut.g_cut.excess_q ;
    (* hierconn *) wire            \u_dut.g_cut.lost_q ;

    // ---- model: the radicand; clocks until its root is there ----
    reg          old_q = 1'b0;
    reg          full_q;
    reg [XW-1:0] x_q;
    reg [CW+1:0] age_q;
    wire         take = in_valid && in_ready;
    always @(posedge clk) begin
        old_q <= 1'b1;
        if (!out_valid) age_q <= age_q + 1'b1;
        if (out_valid && out_ready) full_q <= 1'b0;
        if (take) begin full_q <= 1'b1; x_q <= in_x; age_q <= 1; end
        if (rst) full_q <= 1'b0;
    end
    always @* if (!old_q) assume (rst);

    // ---- the bits of x whose digits are there, and those behind ----
    wire [2*RW-1:0] wide   = x_q;
    wire [7:0]      rest   = STEP * \u_dut.count_q ;     // digits of the rounds left
    wire [7:0]      over   = \u_dut.count_q == ROUNDS ? 0 : \u_dut.g_cut.excess_q ;
    wire [7:0]      shift  = rest + over;
    wire [SW-1:0]   behind = wide & ~({SW{1'b1}} << (2*shift));
    wire [SW-1:0]   root   = \u_dut.root_q ;
    wire [SW-1:0]   square;
    wire            lost   = |((wide >> (2*rest)) & ~({SW{1'b1}} << (2*over)));
    wire            top    = \u_dut.root_q [BITS-1];

    // ---- digit by digit: the bits of x that are used, and the square ----
    reg [SW-1:0]   used_q, used_d, square_q, square_d;
    reg [2*RW-1:0] next;                 // bits of x
    reg [BITS-1:0] part;                 // of the root
    reg            digit;
    integer i;
    always @* begin
        used_d   = used_q;
        square_d = square_q;
        next     = \u_dut.x_q ;
        part     = \u_dut.root_q ;
        digit    = 1'b0;
        for (i = STEP - 1; i >= 0; i = i - 1)
            if (i >= \u_dut.excess_d ) begin
                digit    = \u_dut.root_d [i - \u_dut.excess_d ];
                used_d   = {used_d[SW-3:0], next[2*RW-1 -: 2]};
                square_d = {square_d[SW-3:0], 2'd0} + (digit ? {part, 2'b01} : {SW{1'b0}});
                next     = next << 2;
                part     = {part[BITS-2:0], digit};
            end
    end
    always @(posedge clk)
        if (take) {used_q, square_q} <= 0;
        else if (!\u_dut.done ) {used_q, square_q} <= {used_d, square_d};
    assign square = MULTIPLY ? root * root : square_q;

    // ---- last clock ----
    reg wait_q, inexact_q;
    reg [BITS-1:0] root_q;
    reg [5:0]      shift_q;
    always @(posedge clk) begin
        wait_q    <= out_valid && !out_ready && !rst;
        root_q    <= out_root;
        shift_q   <= out_shift;
        inexact_q <= out_inexact;
    end

    always @* if (old_q) begin
        assert (in_ready == !full_q);
        if (wait_q) assert (out_valid && out_root == root_q && out_shift == shift_q &&
                            out_inexact == inexact_q);
        if (out_valid) begin
            assert (full_q && out_root == root && out_shift == shift);
            assert (square <= used_q && used_q < square + 2*root + 1);
            assert (out_inexact == (used_q != square || behind != 0));
            if (shift != 0) assert (top);
            assert (shift < XW/2);
            // as many rounds as its digits take
            assert (age_q == (RW - shift + STEP - 1) / STEP + 1);
        end
        // invariant
        assert (full_q == \u_dut.full_q );
        assert (\u_dut.count_q <= ROUNDS);
        assert (\u_dut.none_q == (\u_dut.count_q == 0));
        if (full_q) begin
            assert (age_q >= 1 && age_q + \u_dut.count_q == ROUNDS + 1);
            assert (out_valid == (\u_dut.count_q == 0 || top));
            assert (over < STEP && (over == 0 || top));
            assert (used_q == wide >> (2*shift));
            assert ({1'b0, square} + \u_dut.rem_q == {1'b0, used_q} && \u_dut.rem_q <= 2*root);
            assert (\u_dut.x_q == wide << (2*(RW - rest)));
            if (\u_dut.count_q != ROUNDS) assert (\u_dut.g_cut.lost_q == lost);
            if (\u_dut.count_q == ROUNDS) assert (root == 0);
        end else begin
            assert (\u_dut.count_q == 0 || top);
        end
    end
endmodule
`default_nettype wire
