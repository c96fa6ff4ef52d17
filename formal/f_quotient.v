// f_quotient.v - proof of rt_quotient: mantissa and exponent as sph_quotient() defines them
// SPDX-License-Identifier: Apache-2.0
// With kn, an the operands shifted until their top bits are set, in words of W bits:
// 2 an mant <= 2^PQ kn < 2 an (mant + 1). With MULTIPLY this is asserted, from the invariant
// 2^i kn = 2 an mant + rem, 0 <= rem < 2 an: small widths. Without, that every round makes the
// digits of which digits.smt2 shows it for integers: all widths.
`timescale 1ns / 1ps
`default_nettype none
module f_quotient #(
    parameter KW   = 6,
    parameter AW   = 5,
    parameter PQ   = 4,
    parameter STEP = 2,
    parameter MULTIPLY = 0
) (
    input wire          clk,
    input wire          rst,
    input wire          in_valid,
    input wire [KW-1:0] in_key,
    input wire [AW-1:0] in_a,
    input wire          out_ready
);
    localparam W      = KW > AW ? KW : AW;
    localparam ROUNDS = (PQ + STEP - 1) / STEP;
    localparam MW     = ROUNDS*STEP;
    localparam CW     = $clog2(ROUNDS + 1);
    localparam LW     = W + MW + 2;      // of products: 2 an mant < 2^(W+MW+1)
    wire in_ready, out_valid;
    wire [PQ-1:0] out_mant;
    wire signed [7:0] out_exp;
    rt_quotient #(.KW(KW), .AW(AW), .PQ(PQ), .STEP(STEP)) u_dut (
        .clk(clk), .rst(rst), .in_valid_i(in_valid), .in_ready_o(in_ready), .in_key_i(in_key),
        .in_a_i(in_a), .out_valid_o(out_valid), .out_ready_i(out_ready), .out_mant_o(out_mant),
        .out_exp_o(out_exp)
    );
    (* hierconn *) wire              \u_dut.full_q ;
    (* hierconn *) wire              \u_dut.ready_q ;
    (* hierconn *) wire [CW-1:0]     \u_dut.count_q ;
    (* hierconn *) wire              \u_dut.none_q ;
    (* hierconn *) wire [W:0]        \u_dut.rem_q ;
    (* hierconn *) wire [W-1:0]      \u_dut.div_q ;
    (* hierconn *) wire [MW-1:0]     \u_dut.mant_q ;
    (* hierconn *) wire [MW-1:0]     \u_dut.mant_d ;
    (* hierconn *) wire signed [7:0] \u_dut.exp_q ;

    // ---- model: the operands, normalised at once; clocks ----
    reg          old_q = 1'b0, full_q;
    reg [W-1:0]  kn_q, an_q;             // top bits set
    reg [7:0]    zk_q, za_q;             // leading zeros they had
    reg [7:0]    lk_q, la_q;             // of these, left
    reg [7:0]    age_q;
    reg [LW-1:0] scaled_q;               // 2^(digits so far) kn
    wire         take  = in_valid && in_ready;
    wire         round = full_q && \u_dut.ready_q && \u_dut.count_q != 0;
    wire [W-1:0] key   = {in_key, {(W-KW){1'b0}}};       // of equal weight at the top
    wire [W-1:0] a     = {in_a, {(W-AW){1'b0}}};
    always @(posedge clk) begin
        old_q <= 1'b1;
        age_q <= &age_q ? age_q : age_q + 1'b1;
        if (out_valid && out_ready) full_q <= 1'b0;
        if (round) scaled_q <= scaled_q << STEP;
        if (full_q && !\u_dut.ready_q ) begin
            lk_q <= lk_q - (lk_q >= STEP ? STEP : lk_q != 0);
            la_q <= la_q - (la_q >= STEP ? STEP : la_q != 0);
        end
        if (take) begin
            full_q   <= 1'b1;
            age_q    <= 8'd1;
            zk_q     <= zeros(key);
            za_q     <= zeros(a);
            lk_q     <= zeros(key);
            la_q     <= zeros(a);
            kn_q     <= key << zeros(key);
            an_q     <= a << zeros(a);
            scaled_q <= key << zeros(key);
        end
        if (rst) full_q <= 1'b0;
    end
    always @* if (!old_q) assume (rst);
    always @* if (in_valid) assume (in_key != 0 && in_a != 0);

    function [7:0] zeros(input [W-1:0] word);    // leading ones
        integer i;
        begin
            zeros = W;
            for (i = 0; i < W; i = i + 1) if (word[i]) zeros = W - 1 - i;
        end
    endfunction
    function [7:0] clocks(input [7:0] z);        // to shift z zeros away
        clocks = z / STEP + z % STEP;
    endfunction
    wire [7:0] tk = clocks(zk_q), ta = clocks(za_q);
    wire [7:0] latency = (tk > ta ? tk : ta) + ROUNDS + 2;
    wire [7:0] left = clocks(lk_q) > clocks(la_q) ? clocks(lk_q) : clocks(la_q);
    wire [MW-1:0] mant = \u_dut.count_q == ROUNDS ? {MW{1'b0}}      // digits so far
                       : \u_dut.mant_q & ~({MW{1'b1}} << (STEP*(ROUNDS - \u_dut.count_q )));
    wire [LW-1:0] an2 = {{(LW-W-1){1'b0}}, an_q, 1'b0};
    wire [LW-1:0] product = mant * an2;  // unused, and so not there, without MULTIPLY
    generate
        if (MULTIPLY) begin : g_multiply
            always @* if (old_q && full_q && \u_dut.ready_q ) begin
                if (!out_valid) assert (scaled_q == product + \u_dut.rem_q );
                assert (product <= scaled_q && scaled_q < product + an2);
            end
        end
    endgenerate

    // ---- a round: digit d = rem >= an, mant' = 2 mant + d, rem' = 2 (rem - d an) ----
    reg          stepped_q;
    reg [W+2:0]  rem_q, rem_d;
    reg [MW-1:0] mant_before_q, mant_d;
    integer i;
    always @* begin
        rem_d  = rem_q;
        mant_d = mant_before_q;
        for (i = 0; i < STEP; i = i + 1) begin
            mant_d = {mant_d[MW-2:0], rem_d >= an_q};
            rem_d  = rem_d >= an_q ? 2*(rem_d - an_q) : 2*rem_d;
        end
    end
    always @(posedge clk) begin
        stepped_q     <= round && !rst;
        rem_q         <= \u_dut.rem_q ;
        mant_before_q <= mant;
    end

    // ---- last clock ----
    reg wait_q;
    reg [PQ-1:0] mant_q;
    reg signed [7:0] exp_q;
    always @(posedge clk) begin
        wait_q <= out_valid && !out_ready && !rst;
        mant_q <= out_mant;
        exp_q  <= out_exp;
    end

    always @* if (old_q) begin
        assert (in_ready == !full_q);
        if (full_q) assert (out_valid == (age_q >= latency));       // whatever out_ready did
        else        assert (!out_valid);
        if (wait_q) assert (out_valid && out_mant == mant_q && out_exp == exp_q);
        if (out_valid) begin
            assert (out_mant == mant >> (MW - PQ));             // the last digits are cut off
            assert (out_exp == $signed(PQ - 1 - KW + zk_q + AW - za_q));
        end
        if (stepped_q) assert (full_q && mant == mant_d && \u_dut.rem_q == rem_d);
        // invariant
        assert (full_q == \u_dut.full_q );
        assert (\u_dut.count_q <= ROUNDS && \u_dut.none_q == (\u_dut.count_q == 0));
        if (!full_q) assert (\u_dut.count_q == 0);
        if (full_q) begin
            assert (age_q >= 1 && kn_q[W-1] && an_q[W-1]);
            if (!\u_dut.ready_q ) begin
                assert (\u_dut.count_q == ROUNDS && !\u_dut.rem_q [W] && !stepped_q);
                assert (lk_q <= zk_q && la_q <= za_q && zk_q < W && za_q < W);
                assert (age_q + left + ROUNDS + 1 == latency);
                assert (\u_dut.rem_q << lk_q == kn_q && \u_dut.rem_q == kn_q >> lk_q);
                assert (\u_dut.div_q << la_q == an_q && \u_dut.div_q == an_q >> la_q);
                assert (\u_dut.exp_q == $signed(PQ - 1 - KW + (zk_q - lk_q) + AW - (za_q - la_q)));
                assert (scaled_q == kn_q);
            end else begin
                if (\u_dut.count_q != 0) assert (age_q + \u_dut.count_q == latency);
                else                     assert (age_q >= latency);
                assert (\u_dut.exp_q == $signed(PQ - 1 - KW + zk_q + AW - za_q));
                if (!out_valid) begin
                    assert (\u_dut.div_q == an_q && \u_dut.rem_q < an2);
                    if (\u_dut.count_q == ROUNDS) assert (\u_dut.rem_q == kn_q);
                end
            end
            assert (scaled_q == {{(LW-W){1'b0}}, kn_q} << (STEP*(ROUNDS - \u_dut.count_q )));
        end
    end
endmodule
`default_nettype wire
