// f_rr_arbiter.v - proof of rt_rr_arbiter: one that asks is chosen, each other goes once before it
// SPDX-License-Identifier: Apache-2.0
// They ask when they like; the one in turn is served when its user likes, in one of R clocks at
// least: so who asks waits for less than R N clocks. Resets at any time.
`timescale 1ns / 1ps
`default_nettype none
module f_rr_arbiter #(
    parameter N = 4,
    parameter R = 3
) (
    input wire         clk,
    input wire         rst,
    input wire [N-1:0] asks,
    input wire         serve
);
    localparam NB = N > 1 ? $clog2(N) : 1;
    localparam CB = $clog2(N) + 1;
    wire [N-1:0]  turn;
    wire [NB-1:0] index;
    wire served = serve && |asks;
    rt_rr_arbiter #(.N(N)) u_dut (
        .clk(clk), .rst(rst), .asks_i(asks), .served_i(served), .turn_o(turn), .index_o(index)
    );
    (* hierconn *) wire [N-1:0] \u_dut.above_q ;

    // ---- any one: how many others were served while it asked, and how many are before it ----
    (* anyconst *) wire [CB-1:0] mine;
    reg           old_q = 1'b0;
    reg  [7:0]    wait_q, idle_q;         // clocks; clocks in which none is served
    reg  [CB-1:0] passed_q, low;          // low: those that are not above the one served last
    integer k;
    always @* begin
        low = 0;
        for (k = 0; k < N; k = k + 1) if (!\u_dut.above_q [k]) low = low + 1'b1;
    end
    wire [CB-1:0] first = low == N ? 0 : low;            // its turn comes first
    wire [CB-1:0] rank  = mine >= first ? mine - first : mine + N - first;
    always @(posedge clk) begin
        old_q <= 1'b1;
        if (!asks[mine] || (served && turn[mine])) passed_q <= 0;
        else if (served) passed_q <= passed_q + 1'b1;
        wait_q <= asks[mine] && !(served && turn[mine]) ? wait_q + 1'b1 : 0;
        idle_q <= serve ? 0 : idle_q + 1'b1;
        if (rst) {passed_q, wait_q, idle_q} <= 0;
    end
    always @* begin
        if (!old_q) assume (rst);
        assume (mine < N);
        assume (serve || idle_q < R - 1);
    end

    always @* if (old_q) begin
        assert ((turn & ~asks) == 0 && (turn & (turn - 1'b1)) == 0);
        assert ((turn == 0) == (asks == 0));
        if (|turn) assert (turn == {{(N-1){1'b0}}, 1'b1} << index);
        else       assert (index == 0);
        assert (passed_q < N && wait_q < R * N);
        assert (idle_q < R && wait_q <= R * passed_q + idle_q);
        // invariant: who was passed over is that many places nearer
        assert ({1'b0, passed_q} + rank < N || passed_q == 0);
        assert (\u_dut.above_q == ({N{1'b1}} << low) || low == N);
    end
endmodule
`default_nettype wire
