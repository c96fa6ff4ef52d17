// f_pool.v - proof of rt_pool: how long a result is passed over by those of lower units
// SPDX-License-Identifier: Apache-2.0
// Units that take T clocks or more, how many is their own affair, and a consumer that takes a
// result in one of R clocks at least. With T >= R UNITS each lower unit goes once before, so that
// a result of unit u waits for less than R (u + 1) clocks. Inputs come when they like. Resets at
// any time.
`timescale 1ns / 1ps
`default_nettype none
module f_pool #(
    parameter UNITS = 3,
    parameter R     = 2,
    parameter T     = R * UNITS
) (
    input wire             clk,
    input wire             rst,
    input wire             in_valid, out_ready,
    input wire [UNITS-1:0] ends
);
    localparam AB = $clog2(T + 1);
    wire in_ready, out_valid;
    wire [UNITS-1:0] take, give;
    wire [3:0] tag;
    wire [7:0] result;
    reg  [UNITS-1:0] full_q, done_q, gone_q;         // gone: gave a result while the one waited
    reg  [AB*UNITS-1:0] age_q;                       // clocks since it took, up to T
    rt_pool #(.UNITS(UNITS), .TAG(4)) u_dut (
        .clk(clk), .in_valid_i(in_valid), .in_ready_o(in_ready), .in_tag_i(4'd0),
        .ready_i(~full_q), .take_o(take), .done_i(done_q), .give_o(give),
        .results_i({8*UNITS{1'b0}}), .out_valid_o(out_valid), .out_ready_i(out_ready),
        .out_tag_o(tag), .out_result_o(result)
    );

    // ---- any unit: its result waits, others leave ----
    (* anyconst *) wire [$clog2(UNITS):0] mine;
    reg old_q = 1'b0;
    reg [7:0] passed_q, wait_q, idle_q;              // results, clocks; clocks without ready
    wire waits = done_q[mine] && !give[mine];
    reg [7:0] gone;                                  // how many
    integer u;
    always @* begin
        gone = 0;
        for (u = 0; u < UNITS; u = u + 1) gone = gone + gone_q[u];
    end
    always @(posedge clk) begin
        old_q  <= 1'b1;
        idle_q <= out_ready ? 0 : idle_q + 1'b1;
        for (u = 0; u < UNITS; u = u + 1) begin
            if (age_q[AB*u +: AB] != T) age_q[AB*u +: AB] <= age_q[AB*u +: AB] + 1'b1;
            if (full_q[u] && ends[u] && age_q[AB*u +: AB] >= T - 1) done_q[u] <= 1'b1;
            if (give[u]) begin full_q[u] <= 1'b0; done_q[u] <= 1'b0; end
            if (take[u]) begin full_q[u] <= 1'b1; age_q[AB*u +: AB] <= 0; end
        end
        wait_q   <= waits ? wait_q + 1'b1 : 0;
        passed_q <= waits ? passed_q + |give : 0;
        gone_q   <= waits ? gone_q | give : 0;
        if (rst) begin
            full_q <= 0; done_q <= 0; gone_q <= 0; age_q <= 0;
            wait_q <= 0; passed_q <= 0; idle_q <= 0;
        end
    end
    always @* begin
        if (!old_q) assume (rst);
        assume (mine < UNITS);
        assume (out_ready || idle_q < R - 1);
    end

    always @* if (old_q) begin
        assert (passed_q <= mine);                   // each lower unit goes once before
        assert (wait_q < R * (mine + 1));
        assert ((take & full_q) == 0 && (take & (take - 1'b1)) == 0);
        assert ((give & ~done_q) == 0 && (give & (give - 1'b1)) == 0);
        assert (in_ready == !(&full_q) && out_valid == |done_q);
        // invariant
        assert (idle_q < R && passed_q == gone);
        assert ((done_q & ~full_q) == 0);
        assert (!done_q[mine] ? wait_q == 0 && gone_q == 0 : wait_q <= R * passed_q + idle_q);
        for (u = 0; u < UNITS; u = u + 1) begin
            assert (age_q[AB*u +: AB] <= T);
            if (done_q[u]) assert (age_q[AB*u +: AB] == T);
            if (gone_q[u]) assert (u < mine && !done_q[u]);
            if (gone_q[u] && full_q[u]) assert (age_q[AB*u +: AB] < wait_q);
        end
    end
endmodule
`default_nettype wire
