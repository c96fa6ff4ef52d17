// f_pool.v - proof of rt_pool: how long a result is passed over by those of other units
// SPDX-License-Identifier: Apache-2.0
// Units take as long as they like, and the consumer takes a result in one of R clocks at least.
// Each other unit goes once before a result, so that it waits for less than R UNITS clocks. Inputs
// come when they like. Resets at any time.
`timescale 1ns / 1ps
`default_nettype none
module f_pool #(
    parameter UNITS = 3,
    parameter R     = 2
) (
    input wire             clk,
    input wire             rst,
    input wire             in_valid, out_ready,
    input wire [UNITS-1:0] ends
);
    localparam UB = $clog2(UNITS) + 1;
    wire in_ready, out_valid;
    wire [UNITS-1:0] take, give;
    wire [3:0] tag;
    wire [7:0] result;
    reg  [UNITS-1:0] full_q, done_q, gone_q;         // gone: gave a result while the one waited
    rt_pool #(.UNITS(UNITS), .TAG(4)) u_dut (
        .clk(clk), .rst(rst), .in_valid_i(in_valid), .in_ready_o(in_ready), .in_tag_i(4'd0),
        .ready_i(~full_q), .take_o(take), .done_i(done_q), .give_o(give),
        .results_i({8*UNITS{1'b0}}), .out_valid_o(out_valid), .out_ready_i(out_ready),
        .out_tag_o(tag), .out_result_o(result)
    );
    (* hierconn *) wire [UNITS-1:0] \u_dut.u_turns.above_q ;

    // ---- any unit: its result waits, others leave ----
    (* anyconst *) wire [UB-1:0] mine;
    reg old_q = 1'b0;
    reg [7:0] passed_q, wait_q, idle_q;              // results, clocks; clocks without ready
    wire waits = done_q[mine] && !give[mine];
    reg [7:0] gone;                                  // how many
    reg [UB-1:0] low;                                // not above the unit that gave last
    integer u;
    always @* begin
        gone = 0;
        low  = 0;
        for (u = 0; u < UNITS; u = u + 1) begin
            gone = gone + gone_q[u];
            if (!\u_dut.u_turns.above_q [u]) low = low + 1'b1;
        end
    end
    // How many units have their turn before one.
    function [UB-1:0] before_it(input [UB-1:0] one, input [UB-1:0] first);
        before_it = one >= first ? one - first : one + UNITS - first;
    endfunction
    wire [UB-1:0] first = low == UNITS ? 0 : low;
    always @(posedge clk) begin
        old_q    <= 1'b1;
        idle_q   <= out_ready ? 0 : idle_q + 1'b1;
        full_q   <= (full_q | take) & ~give;
        done_q   <= (done_q | (full_q & ends)) & ~give;
        wait_q   <= waits ? wait_q + 1'b1 : 0;
        passed_q <= waits ? passed_q + |give : 0;
        gone_q   <= waits ? gone_q | give : 0;
        if (rst) begin
            full_q <= 0; done_q <= 0; gone_q <= 0; wait_q <= 0; passed_q <= 0; idle_q <= 0;
        end
    end
    always @* begin
        if (!old_q) assume (rst);
        assume (mine < UNITS);
        assume (out_ready || idle_q < R - 1);
    end

    always @* if (old_q) begin
        if (waits) assert ((gone_q & give) == 0);    // each other unit goes once before
        assert (passed_q < UNITS);
        assert (wait_q < R * UNITS);
        assert ((take & full_q) == 0 && (take & (take - 1'b1)) == 0);
        assert ((give & ~done_q) == 0 && (give & (give - 1'b1)) == 0);
        assert (in_ready == !(&full_q) && out_valid == |done_q);
        // invariant: who went has its turn after the one
        assert (idle_q < R && passed_q == gone);
        assert ((done_q & ~full_q) == 0);
        assert (!done_q[mine] ? wait_q == 0 && gone_q == 0 : wait_q <= R * passed_q + idle_q);
        assert (\u_dut.u_turns.above_q == ({UNITS{1'b1}} << low) || low == UNITS);
        for (u = 0; u < UNITS; u = u + 1)
            if (gone_q[u]) assert (before_it(u, first) > before_it(mine, first));
    end
endmodule
`default_nettype wire
