// f_isqrt.v - proof of rt_isqrt: root^2 <= x < (root+1)^2, inexact, latency, handshake
// SPDX-License-Identifier: Apache-2.0
// The square of the digits so far is kept beside the root: with root' = 2 root + d, root'^2 is
// 4 root^2 + d (4 root + 1). So no multiplication is needed, and full widths can be proved. With
// MULTIPLY the square is that of a multiplier: small widths.
`timescale 1ns / 1ps
`default_nettype none
module f_isqrt #(
    parameter XW       = 66,
    parameter STEP     = 2,
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
    wire in_ready, out_valid, out_inexact;
    wire [XW/2-1:0] out_root;
    rt_isqrt #(.XW(XW), .STEP(STEP)) u_dut (
        .clk(clk), .rst(rst), .in_valid_i(in_valid), .in_ready_o(in_ready), .in_x_i(in_x),
        .out_valid_o(out_valid), .out_ready_i(out_ready), .out_root_o(out_root),
        .out_inexact_o(out_inexact)
    );
    (* hierconn *) wire            \u_dut.full_q ;
    (* hierconn *) wire [CW-1:0]   \u_dut.count_q ;
    (* hierconn *) wire            \u_dut.none_q ;
    (* hierconn *) wire [2*RW-1:0] \u_dut.x_q ;
    (* hierconn *) wire [RW-1:0]   \u_dut.root_q ;
    (* hierconn *) wire [RW:0]     \u_dut.rem_q ;
    (* hierconn *) wire [RW-1:0]   \u_dut.root_d ;

    // ---- model: the radicand, the square of the root so far, clocks since the radicand ----
    reg              old_q = 1'b0;
    reg              full_q;
    reg [XW-1:0]     x_q;
    reg [CW+1:0]     age_q;
    wire             take = in_valid && in_ready;
    wire [2*RW-1:0]  square;
    reg [2*RW-1:0]   used_q;             // the bits of x whose digits are there
    always @(posedge clk) begin
        old_q <= 1'b1;
        age_q <= age_q == ROUNDS + 1 ? age_q : age_q + 1'b1;
        if (out_valid && out_ready) full_q <= 1'b0;
        if (take) begin full_q <= 1'b1; x_q <= in_x; age_q <= 1; end
        if (take) used_q <= 0;
        else if (\u_dut.count_q != 0) used_q <= {used_q, \u_dut.x_q [2*RW-1 -: 2*STEP]};
        if (rst) full_q <= 1'b0;
    end
    always @* if (!old_q) assume (rst);
    generate
        if (MULTIPLY) begin : g_multiply
            assign square = \u_dut.root_q * \u_dut.root_q ;
        end else begin : g_digits
            reg [2*RW-1:0] square_q, square_d;
            reg [RW-1:0]   root;
            integer i;
            always @* begin
                square_d = square_q;
                root     = \u_dut.root_q ;
                for (i = STEP - 1; i >= 0; i = i - 1) begin
                    square_d = {square_d[2*RW-3:0], 2'd0} +
                               (\u_dut.root_d [i] ? {root, 2'b01} : {(2*RW){1'b0}});
                    root     = {root[RW-2:0], \u_dut.root_d [i]};
                end
            end
            always @(posedge clk)
                if (take) square_q <= 0;
                else if (\u_dut.count_q != 0) square_q <= square_d;
            assign square = square_q;
        end
    endgenerate

    // ---- last clock ----
    reg wait_q, inexact_q;
    reg [XW/2-1:0] root_q;
    always @(posedge clk) begin
        wait_q    <= out_valid && !out_ready && !rst;
        root_q    <= out_root;
        inexact_q <= out_inexact;
    end

    wire [2*RW-1:0]  wide = x_q;         // the radicand in whole rounds
    always @* if (old_q) begin
        assert (in_ready == !full_q);
        assert (out_valid == (full_q && age_q == ROUNDS + 1));      // whatever out_ready did
        if (wait_q) assert (out_valid && out_root == root_q && out_inexact == inexact_q);
        if (out_valid) begin
            // root^2 <= x = root^2 + rem < (root+1)^2
            assert ({1'b0, square} + \u_dut.rem_q == {1'b0, wide});
            assert (\u_dut.rem_q <= {out_root, 1'b0});
            assert (out_inexact == (\u_dut.rem_q != 0));
            assert (\u_dut.root_q >> (XW/2) == 0);                  // no digit is cut off
        end
        // invariant: rem = used bits of x - root^2 <= 2 root
        assert (full_q == \u_dut.full_q );
        assert (\u_dut.count_q <= ROUNDS);
        assert (\u_dut.none_q == (\u_dut.count_q == 0));
        if (full_q) begin
            assert (age_q >= 1 && age_q <= ROUNDS + 1);
            assert (age_q + \u_dut.count_q == ROUNDS + 1);
            assert ({1'b0, square} + \u_dut.rem_q == {1'b0, used_q});
            assert (\u_dut.rem_q <= {\u_dut.root_q , 1'b0});
            assert (({used_q, \u_dut.x_q } << (2*STEP*\u_dut.count_q )) == {wide, {(2*RW){1'b0}}});
            assert (used_q >> (2*(RW - STEP*\u_dut.count_q )) == 0);
            // digits so far; the first ones, of whole rounds, are 0
            assert (\u_dut.root_q >> (\u_dut.count_q == ROUNDS ? 0 :
                                      XW/2 - STEP*\u_dut.count_q ) == 0);
        end else begin
            assert (\u_dut.count_q == 0);
        end
    end
endmodule
`default_nettype wire
