// f_mem_arbiter.v - proof of rt_mem_arbiter: each client gets its own lines, in order, never stuck
// SPDX-License-Identifier: Apache-2.0
// Any request of any client may be marked. It is asked of memory once, with its line and its
// client's tag, and its line is handed to its client as the one that many lines after those that
// this client asked for before it, with the data and the errors of its four beats, however beats of
// other clients alternate with them. Memory answers only what was asked for, lines of a tag in
// order; it and the clients may stall at any time.
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
    input wire [4:0]            mem_rsp_tag,
    input wire [63:0]           mem_rsp_data,
    input wire                  mem_rsp_error,
    input wire                  pick     // mark the request that is taken
);
    localparam AB = $clog2(PENDING) + 1;         // bits of a number of lines
    localparam CB = $clog2(CLIENTS) + 1;
    localparam NB = CLIENTS > 1 ? $clog2(CLIENTS) : 1;
    wire [CLIENTS-1:0] req_ready, rsp_valid;
    wire [255:0] rsp_data;
    wire rsp_error, mem_req_valid, mem_rsp_ready;
    wire [25:0] mem_req_line;
    wire [4:0] mem_req_tag;
    rt_mem_arbiter #(.CLIENTS(CLIENTS), .PENDING(PENDING), .DATA(64)) u_dut (
        .clk(clk), .rst(rst), .req_valid_i(req_valid), .req_ready_o(req_ready),
        .req_line_i(req_line), .rsp_valid_o(rsp_valid), .rsp_ready_i(rsp_ready),
        .rsp_data_o(rsp_data), .rsp_error_o(rsp_error), .mem_req_valid_o(mem_req_valid),
        .mem_req_ready_i(mem_req_ready), .mem_req_line_o(mem_req_line),
        .mem_req_tag_o(mem_req_tag), .mem_rsp_valid_i(mem_rsp_valid),
        .mem_rsp_ready_o(mem_rsp_ready), .mem_rsp_tag_i(mem_rsp_tag),
        .mem_rsp_data_i(mem_rsp_data), .mem_rsp_error_i(mem_rsp_error)
    );
    (* hierconn *) wire [AB-1:0]        \u_dut.coming_q ;
    (* hierconn *) wire                 \u_dut.came_q , \u_dut.full_q ;
    (* hierconn *) wire [CLIENTS-1:0]   \u_dut.owner_q ;
    (* hierconn *) wire [2*CLIENTS-1:0] \u_dut.g_beats.beats_q ;
    (* hierconn *) wire [NB-1:0]        \u_dut.g_beats.g_beat[0].u_beat.mark ;
    (* hierconn *) wire [NB-1:0]        \u_dut.g_beats.g_beat[1].u_beat.mark ;
    (* hierconn *) wire [NB-1:0]        \u_dut.g_beats.g_beat[2].u_beat.mark ;
    (* hierconn *) wire [64:0]          \u_dut.g_beats.g_beat[0].u_beat.word_q ;
    (* hierconn *) wire [64:0]          \u_dut.g_beats.g_beat[1].u_beat.word_q ;
    (* hierconn *) wire [64:0]          \u_dut.g_beats.g_beat[2].u_beat.word_q ;

    // ---- model: of each client, lines that memory owes and beats of the first of them ----
    reg                   old_q = 1'b0;
    reg [AB*CLIENTS-1:0]  asked_q;       // asked of memory, whose last beat has not come
    reg [2*CLIENTS-1:0]   beats_q;
    wire [CLIENTS-1:0] taken = req_valid & req_ready;
    wire [CLIENTS-1:0] given = rsp_valid & rsp_ready;
    wire take = |taken;
    wire ask  = mem_req_valid && mem_req_ready;
    wire beat = mem_rsp_valid && mem_rsp_ready;
    reg [AB+1:0] sum;                    // lines on their way
    integer i, c;
    always @(posedge clk) begin
        old_q <= 1'b1;
        for (c = 0; c < CLIENTS; c = c + 1) begin
            asked_q[AB*c +: AB] <= asked_q[AB*c +: AB] + (ask && mem_req_tag == c) -
                                   (beat && mem_rsp_tag == c && &beats_q[2*c +: 2]);
            if (beat && mem_rsp_tag == c) beats_q[2*c +: 2] <= beats_q[2*c +: 2] + 1'b1;
        end
        if (rst) begin asked_q <= 0; beats_q <= 0; end
    end
    always @* begin
        sum = mem_req_valid;
        for (i = 0; i < CLIENTS; i = i + 1) sum = sum + asked_q[AB*i +: AB];
    end
    always @* if (!old_q) assume (rst);
    // memory sends no beat of a line that was not asked for
    always @* if (mem_rsp_valid)
        assume (mem_rsp_tag < CLIENTS && asked_q[AB*mem_rsp_tag +: AB] != 0);

    // ---- the marked request: lines of its client before it, its beats ----
    (* anyconst *) wire [CB-1:0] mine;
    always @* assume (mine < CLIENTS && \u_dut.g_beats.g_beat[0].u_beat.mark == mine &&
                      \u_dut.g_beats.g_beat[1].u_beat.mark == mine &&
                      \u_dut.g_beats.g_beat[2].u_beat.mark == mine);
    reg            marked_q, newest_q, whole_q; // nobody's was taken since; all of its beats came
    reg [AB:0]     ahead_q;              // not yet given
    reg [AB:0]     before_q;             // not yet come
    reg [25:0]     line_q;
    reg [255:0]    data_q;
    reg [3:0]      error_q;
    wire           my_beat = beat && mem_rsp_tag == mine;
    wire           my_last = my_beat && &beats_q[2*mine +: 2];
    wire [AB:0]    owed    = asked_q[AB*mine +: AB] + (mem_req_valid && mem_req_tag == mine);
    wire           held    = \u_dut.full_q && \u_dut.owner_q [mine];
    wire           mark    = taken[mine] && pick && !marked_q;
    always @(posedge clk) begin
        newest_q <= mark || (newest_q && !take);
        if (mark) begin
            marked_q <= 1'b1;
            whole_q  <= 1'b0;
            before_q <= owed - my_last;
            ahead_q  <= owed + held - given[mine];
            line_q   <= req_line[26*mine +: 26];
        end else if (marked_q) begin
            if (my_last) begin
                if (before_q == 0) whole_q <= 1'b1;
                else before_q <= before_q - 1'b1;
            end
            if (given[mine]) begin
                ahead_q <= ahead_q - 1'b1;
                if (ahead_q == 0) marked_q <= 1'b0;
            end
        end
        if (my_beat && !whole_q) begin
            data_q[64*beats_q[2*mine +: 2] +: 64] <= mem_rsp_data;
            error_q[beats_q[2*mine +: 2]]         <= mem_rsp_error;
        end
        if (rst) marked_q <= 1'b0;
    end

    // ---- fairness: how many others were served while a client asked ----
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

    // ---- last clock ----
    reg asking_q;
    reg [30:0] request_q;
    always @(posedge clk) begin
        asking_q  <= mem_req_valid && !mem_req_ready && !rst;
        request_q <= {mem_req_tag, mem_req_line};
    end

    always @* if (old_q) begin
        assert ((taken & (taken - 1'b1)) == 0);                  // one a clock
        assert (sum + \u_dut.came_q == \u_dut.coming_q );        // each is asked for, once
        assert (\u_dut.coming_q <= PENDING);
        if (mem_req_valid) assert (mem_req_tag < CLIENTS);
        if (asking_q) assert (mem_req_valid && {mem_req_tag, mem_req_line} == request_q);
        if (marked_q && newest_q && mem_req_valid)
            assert (mem_req_line == line_q && mem_req_tag == mine);
        assert ((rsp_valid & (rsp_valid - 1'b1)) == 0);
        if (marked_q && ahead_q == 0) begin                      // the marked line is next
            assert (rsp_valid[mine] == whole_q);
            if (whole_q) assert (rsp_data == data_q && rsp_error == |error_q);
        end
        assert (passed_q < CLIENTS);                             // each other one goes once before
        assert ({1'b0, passed_q} + rank < CLIENTS || passed_q == 0);
        assert (\u_dut.u_turns.above_q == ({CLIENTS{1'b1}} << low) || low == CLIENTS);
        // never stuck: a beat and a request move if clients and memory are ready
        if (&rsp_ready) assert (mem_rsp_ready && rsp_valid == given);
        if (|req_valid && mem_req_ready && \u_dut.coming_q != PENDING) assert (take);
        // invariant
        if (\u_dut.full_q )
            assert (\u_dut.owner_q != 0 && (\u_dut.owner_q & (\u_dut.owner_q - 1'b1)) == 0);
        assert (\u_dut.g_beats.beats_q == beats_q);
        if (beats_q[2*mine +: 2] != 0) assert (asked_q[AB*mine +: AB] != 0);
        if (marked_q) begin
            assert (ahead_q == before_q + (held && !whole_q));
            if (whole_q) assert (before_q == 0 && held);
            else assert (before_q < owed);
            if (newest_q && !whole_q) assert (before_q + 1'b1 == owed);
            if (before_q == 0 && !whole_q) begin
                if (beats_q[2*mine +: 2] > 0) assert ({error_q[0], data_q[63:0]} ==
                    \u_dut.g_beats.g_beat[0].u_beat.word_q );
                if (beats_q[2*mine +: 2] > 1) assert ({error_q[1], data_q[127:64]} ==
                    \u_dut.g_beats.g_beat[1].u_beat.word_q );
                if (beats_q[2*mine +: 2] > 2) assert ({error_q[2], data_q[191:128]} ==
                    \u_dut.g_beats.g_beat[2].u_beat.word_q );
            end
        end
    end
endmodule
`default_nettype wire
