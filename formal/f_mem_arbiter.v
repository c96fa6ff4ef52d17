// f_mem_arbiter.v - proof of rt_mem_arbiter: each client gets its own lines, in order, never stuck
// SPDX-License-Identifier: Apache-2.0
// Any request may be marked. Its line is handed to its client as the one that many lines after the
// lines asked for before it, with the data and the errors of its four beats. Memory answers only
// what was asked for; it and the clients may stall at any time.
`timescale 1ns / 1ps
`default_nettype none
module f_mem_arbiter #(
    parameter CLIENTS = 3,
    parameter PENDING = 4
) (
    input wire                  clk,
    input wire                  rst,
    input wire [CLIENTS-1:0]    req_valid,
    input wire [26*CLIENTS-1:0] req_line,
    input wire [CLIENTS-1:0]    rsp_ready,
    input wire                  mem_req_ready,
    input wire                  mem_rsp_valid,
    input wire [63:0]           mem_rsp_data,
    input wire                  mem_rsp_error,
    input wire                  pick     // mark the request that is taken
);
    localparam AB = $clog2(PENDING);
    wire [CLIENTS-1:0] req_ready, rsp_valid;
    wire [255:0] rsp_data;
    wire rsp_error, mem_req_valid, mem_rsp_ready;
    wire [25:0] mem_req_line;
    rt_mem_arbiter #(.CLIENTS(CLIENTS), .PENDING(PENDING)) u_dut (
        .clk(clk), .rst(rst), .req_valid_i(req_valid), .req_ready_o(req_ready),
        .req_line_i(req_line), .rsp_valid_o(rsp_valid), .rsp_ready_i(rsp_ready),
        .rsp_data_o(rsp_data), .rsp_error_o(rsp_error), .mem_req_valid_o(mem_req_valid),
        .mem_req_ready_i(mem_req_ready), .mem_req_line_o(mem_req_line),
        .mem_rsp_valid_i(mem_rsp_valid), .mem_rsp_ready_o(mem_rsp_ready),
        .mem_rsp_data_i(mem_rsp_data), .mem_rsp_error_i(mem_rsp_error)
    );
    (* hierconn *) wire [AB:0]        \u_dut.u_order.wr_q ;
    (* hierconn *) wire [AB:0]        \u_dut.u_order.rd_q ;
    (* hierconn *) wire [AB-1:0]      \u_dut.u_order.u_words.mark ;
    (* hierconn *) wire [CLIENTS-1:0] \u_dut.u_order.u_words.word_q ;
    (* hierconn *) wire [1:0]         \u_dut.beat_q ;
    (* hierconn *) wire               \u_dut.full_q ;
    (* hierconn *) wire [255:0]       \u_dut.line_q ;
    (* hierconn *) wire               \u_dut.error_q ;

    // ---- model: lines on their way; of the marked one, how many before it, and its beats ----
    reg               old_q = 1'b0;
    reg [AB:0]        count_q;           // taken from clients, not yet given back
    reg [AB:0]        asked_q;           // of these, asked of memory, not yet given back
    reg               marked_q;
    reg [AB:0]        ahead_q;           // lines before the marked one
    reg [CLIENTS-1:0] client_q;
    reg [25:0]        line_q;
    reg [255:0]       data_q;            // beats of the line at the head
    reg [3:0]         error_q;
    reg [2:0]         beats_q;
    wire [CLIENTS-1:0] taken = req_valid & req_ready;
    wire take  = |taken;
    wire ask   = mem_req_valid && mem_req_ready;
    wire beat  = mem_rsp_valid && mem_rsp_ready;
    wire give  = |(rsp_valid & rsp_ready);
    wire mark  = take && pick && !marked_q &&
                 \u_dut.u_order.wr_q [AB-1:0] == \u_dut.u_order.u_words.mark ;
    reg [25:0] line;
    integer i;
    always @* begin
        line = 26'd0;
        for (i = 0; i < CLIENTS; i = i + 1) if (taken[i]) line = req_line[26*i +: 26];
    end
    always @(posedge clk) begin
        old_q   <= 1'b1;
        count_q <= count_q + take - give;
        asked_q <= asked_q + ask - give;
        if (mark) begin
            marked_q <= 1'b1;
            ahead_q  <= count_q - give;
            client_q <= taken;
            line_q   <= line;
        end else if (give) begin
            ahead_q <= ahead_q - 1'b1;
            if (ahead_q == 0) marked_q <= 1'b0;
        end
        if (give) beats_q <= beat;
        else      beats_q <= beats_q + beat;
        if (beat) begin
            data_q[64*\u_dut.beat_q +: 64] <= mem_rsp_data;
            error_q[\u_dut.beat_q ]        <= mem_rsp_error;
        end
        if (rst) begin count_q <= 0; asked_q <= 0; marked_q <= 1'b0; beats_q <= 0; end
    end
    always @* if (!old_q) assume (rst);
    // memory sends no beat of a line that was not asked for
    always @* if (mem_rsp_valid) assume (asked_q > (\u_dut.full_q ? 1 : 0));

    // ---- fairness: any client, and how many others were served while it asked ----
    localparam CB = $clog2(CLIENTS) + 1;
    (* anyconst *) wire [CB-1:0] mine;
    (* hierconn *) wire [CLIENTS-1:0] \u_dut.u_turns.above_q ;
    reg [CB-1:0] passed_q, low;          // low: clients that are not above the one served last
    integer k;
    always @* begin
        low = 0;
        for (k = 0; k < CLIENTS; k = k + 1) if (!\u_dut.u_turns.above_q [k]) low = low + 1'b1;
    end
    wire [CB-1:0] last = low == CLIENTS ? 0 : low;       // the turn comes to this one first
    wire [CB-1:0] rank = mine >= last ? mine - last : mine + CLIENTS - last;
    always @(posedge clk) begin
        if (!req_valid[mine] || taken[mine]) passed_q <= 0;
        else if (take) passed_q <= passed_q + 1'b1;
        if (rst) passed_q <= 0;
    end
    always @* assume (mine < CLIENTS);

    // ---- last clock ----
    reg asking_q;
    reg [25:0] ask_line_q;
    always @(posedge clk) begin
        asking_q   <= mem_req_valid && !mem_req_ready && !rst;
        ask_line_q <= mem_req_line;
    end

    always @* if (old_q) begin
        assert ((taken & (taken - 1'b1)) == 0);                  // one a clock
        assert (count_q <= PENDING);
        assert (count_q == asked_q + mem_req_valid);             // each is asked for, once
        if (asking_q) assert (mem_req_valid && mem_req_line == ask_line_q);
        if (marked_q && mem_req_valid && ahead_q + 1'b1 == count_q) assert (mem_req_line == line_q);
        if (marked_q && ahead_q == 0) begin                      // the marked line is next
            assert (rsp_valid == (beats_q == 4 ? client_q : 0));
            if (|rsp_valid) assert (rsp_data == data_q && rsp_error == |error_q);
        end
        assert (passed_q < CLIENTS);                             // each other one goes once before
        assert ({1'b0, passed_q} + rank < CLIENTS || passed_q == 0);
        assert (\u_dut.u_turns.above_q == ({CLIENTS{1'b1}} << low) || low == CLIENTS);
        // never stuck: a line, beats or a request move if clients and memory are ready
        if (&rsp_ready && mem_req_ready && marked_q && ahead_q == 0)
            assert (ask || give || mem_rsp_ready);
        if (|req_valid && mem_req_ready && count_q != PENDING) assert (take);
        // invariant
        assert (count_q == \u_dut.u_order.wr_q - \u_dut.u_order.rd_q );
        assert (beats_q <= 4 && \u_dut.full_q == (beats_q == 4));
        assert (\u_dut.beat_q == beats_q[1:0]);
        assert (asked_q <= count_q);
        if (beats_q != 0) assert (asked_q != 0);
        if (beats_q >= 1) assert (\u_dut.line_q [255 - 64*(beats_q - 1) -: 64] == data_q[63:0]);
        if (beats_q >= 2) assert (\u_dut.line_q [255 - 64*(beats_q - 2) -: 64] == data_q[127:64]);
        if (beats_q >= 3) assert (\u_dut.line_q [255 - 64*(beats_q - 3) -: 64] == data_q[191:128]);
        if (beats_q == 4) assert (\u_dut.line_q [255 -: 64] == data_q[255:192]);
        if (beats_q != 0)
            assert (\u_dut.error_q == |(error_q & ((5'd1 << beats_q) - 5'd1)));
        if (marked_q) begin
            assert (ahead_q < count_q);
            assert (client_q != 0 && (client_q & (client_q - 1'b1)) == 0);
            assert (\u_dut.u_order.u_words.word_q == client_q);
            assert (\u_dut.u_order.u_words.mark ==
                    \u_dut.u_order.rd_q [AB-1:0] + ahead_q[AB-1:0]);
        end
    end
endmodule
`default_nettype wire
