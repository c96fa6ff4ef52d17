// p_cache_moves.v - proof of rt_cache: bounded time, no errors kept, no word read while written
// SPDX-License-Identifier: Apache-2.0
// A small cache without the words of its lines, before a client and a memory that may stall at any
// time and answer with errors; flushes at any time. Where memory ends, within 8 lines, may change
// while nothing is under way. Tags of requests under way differ. Clocks count
// in which the client takes answers, memory takes requests and sends what it owes, and nothing is
// flushed. In any QUIET of them in a row
// - what waits for memory goes on: a line is asked for or comes, the head is loaded or leaves;
// - a request before that goes on by a stage, a set is cleared, or what waits for memory goes on.
// Requests keep their order up to stage 2 and in the queue, which has room for PENDING of them, and
// each of these asks for GROUP lines at most. So one is answered within QUIET clocks for each step
// of those before it, whatever hits overtake it. For abc's pdr: bad_o is never 1.
`timescale 1ns / 1ps
`default_nettype none
module p_cache_moves #(
    parameter LINES   = 4,
    parameter WAYS    = 2,
    parameter GROUP   = 1,
    parameter PENDING = 2,
    parameter QUIET   = 2
) (
    input  wire       clk,
    input  wire       flush,
    input  wire       req_valid,
    input  wire [2:0] req_line,
    input  wire       req_tag,
    input  wire       rsp_ready,
    input  wire       mem_req_ready,
    input  wire       mem_rsp_valid,
    input  wire       mem_error,
    input  wire [3:0] lines,             // of memory, looked at in the first clock
    input  wire       move,              // and in these, if nothing is under way
    output wire       bad_o
);
    localparam SETS = LINES / GROUP / WAYS, SB = $clog2(SETS), ALL = SETS * WAYS;
    localparam HB = $clog2(PENDING) + 1;
    localparam HW = SB + $clog2(GROUP) + (GROUP > 1 ? 1 : 0); // of rt_cache's s2_what
    reg        old_q = 1'b0;
    reg  [1:0] busy_q = 2'd0;
    reg  [3:0] count_q = 4'd0;                   // lines that memory owes
    reg  [3:0] lines_q = 4'd0;
    reg  [1:0] void_q = 2'd0;                    // a request's line is beyond memory
    wire req = req_valid && !(req_tag ? busy_q[1] : busy_q[0]);
    wire req_ready, rsp_valid, rsp_tag, rsp_error, mem_req_valid, mem_rsp_ready, miss;
    wire [255:0] rsp_data;
    wire [25:0]  mem_req_line;
    wire take = req && req_ready;
    wire give = rsp_valid && rsp_ready;
    wire ask  = mem_req_valid && mem_req_ready;
    wire send = mem_rsp_valid && count_q != 0;
    always @(posedge clk) begin
        old_q   <= 1'b1;
        count_q <= count_q + {3'd0, ask} - {3'd0, send && mem_rsp_ready};
        busy_q  <= (busy_q & ~{give && rsp_tag, give && !rsp_tag}) |
                   {take && req_tag, take && !req_tag};
        if (take && !req_tag) void_q[0] <= {1'b0, req_line} >= lines_q;
        if (take &&  req_tag) void_q[1] <= {1'b0, req_line} >= lines_q;
        if (!old_q) begin busy_q <= 2'd0; count_q <= 4'd0; end
        if (!old_q || (move && busy_q == 2'd0 && !take)) lines_q <= lines[3] ? 4'd8 : lines;
    end
    rt_cache #(.TAG(1), .LINES(LINES), .WAYS(WAYS), .GROUP(GROUP), .PENDING(PENDING)) u_dut (
        .clk(clk), .rst(!old_q), .flush_i(flush), .mem_lines_i({22'd0, lines_q}), .miss_o(miss),
        .req_valid_i(req), .req_ready_o(req_ready), .req_line_i({23'd0, req_line}),
        .req_tag_i(req_tag), .rsp_valid_o(rsp_valid), .rsp_ready_i(rsp_ready),
        .rsp_data_o(rsp_data), .rsp_tag_o(rsp_tag), .rsp_error_o(rsp_error),
        .mem_req_valid_o(mem_req_valid), .mem_req_ready_i(mem_req_ready),
        .mem_req_line_o(mem_req_line), .mem_rsp_valid_i(send), .mem_rsp_ready_o(mem_rsp_ready),
        .mem_rsp_data_i(256'd0), .mem_rsp_error_i(mem_error)
    );
    // ---- what moves: a request by a stage, a line, a set that is cleared ----
    (* hierconn *) wire \u_dut.s1_valid_q ;
    (* hierconn *) wire \u_dut.s1_wait ;
    (* hierconn *) wire \u_dut.s1_free ;
    (* hierconn *) wire \u_dut.s2_free ;
    (* hierconn *) wire \u_dut.s2_go ;
    (* hierconn *) wire \u_dut.queue_valid ;
    (* hierconn *) wire \u_dut.head_free ;
    (* hierconn *) wire \u_dut.head_go ;
    (* hierconn *) wire \u_dut.fill ;
    (* hierconn *) wire \u_dut.walk_step ;
    (* hierconn *) wire \u_dut.skid_q ;
    (* hierconn *) wire \u_dut.s2_valid_q ;
    (* hierconn *) wire [HB-1:0] \u_dut.held_q ;
    wire willing = rsp_ready && mem_req_ready && mem_rsp_valid && !flush;
    wire behind  = \u_dut.held_q != 0;
    wire looking = \u_dut.skid_q || \u_dut.s1_valid_q || \u_dut.s2_valid_q ;
    wire moves_behind = ask || \u_dut.fill || \u_dut.head_go ||
                        (\u_dut.head_free && \u_dut.queue_valid );
    wire moves_before = \u_dut.s2_go || \u_dut.walk_step ||
                        (\u_dut.s1_valid_q && \u_dut.s2_free && !\u_dut.s1_wait ) ||
                        (\u_dut.skid_q && \u_dut.s1_free );
    reg [2:0] behind_q = 3'd0, before_q = 3'd0;
    always @(posedge clk) begin
        behind_q <= old_q && behind && willing && !moves_behind ? behind_q + 3'd1 : 3'd0;
        before_q <= old_q && looking && willing && !moves_before && !moves_behind
                    ? before_q + 3'd1 : 3'd0;
    end

    // ---- what else holds, which helps to show it: copies of the queue, of lines' states ----
    (* hierconn *) wire \u_dut.head_valid_q ;
    (* hierconn *) wire \u_dut.head_filled_q ;
    (* hierconn *) wire \u_dut.head_leader ;
    (* hierconn *) wire \u_dut.queue_go ;
    (* hierconn *) wire \u_dut.alloc ;
    (* hierconn *) wire \u_dut.walk_q ;
    (* hierconn *) wire \u_dut.fill_last ;
    (* hierconn *) wire \u_dut.done_q ;
    (* hierconn *) wire \u_dut.done_asked_q ;
    (* hierconn *) wire [HW-1:0]   \u_dut.s2_what ;
    (* hierconn *) wire [WAYS-1:0] \u_dut.victim ;
    (* hierconn *) wire [WAYS-1:0] \u_dut.s2_filled_q ;
    (* hierconn *) wire [WAYS-1:0] \u_dut.s2_coming_q ;
    (* hierconn *) wire [WAYS-1:0] \u_dut.done_way_q ;
    (* hierconn *) wire [SB-1:0]   \u_dut.s2_set ;
    (* hierconn *) wire [SB-1:0]   \u_dut.walk_set_q ;
    (* hierconn *) wire [SB-1:0]   \u_dut.done_set_q ;
    wire [ALL-1:0] way_s2   = {{(ALL-WAYS){1'b0}}, \u_dut.victim } << WAYS * \u_dut.s2_set ;
    wire [ALL-1:0] way_done = {{(ALL-WAYS){1'b0}}, \u_dut.done_way_q } << WAYS * \u_dut.done_set_q ;
    wire [ALL-1:0] way_walk = {{(ALL-WAYS){1'b0}}, {WAYS{1'b1}}} << WAYS * \u_dut.walk_set_q ;
    wire [ALL-1:0] now_2    = {{(ALL-WAYS){1'b0}}, \u_dut.s2_filled_q } << WAYS * \u_dut.s2_set ;
    reg  [ALL-1:0] used_q = 0, asked_q = 0, filled_q = 0;
    reg  [2:0]     held_q = 3'd0;        // requests in the queue and its head
    reg  [ALL-1:0] to_0_q = 0, to_1_q = 0, to_2_q = 0; // lines that its leaders fill; the oldest: 0
    reg  [2:0]     as_q = 3'd0;          // what makes them filled
    reg  [2:0]     short_q = 3'd0;       // memory ends within their groups
    reg            ask_short_q = 1'b0;   // within that whose lines are asked for
    wire [2:0]     stay = held_q - {2'd0, \u_dut.head_go };
    wire [ALL-1:0] made  = \u_dut.alloc ? way_s2 : {ALL{1'b0}};
    wire           mark = |(~\u_dut.s2_filled_q & \u_dut.victim );
    wire [ALL-1:0] left_0 = \u_dut.head_go ? to_1_q : to_0_q;
    wire [ALL-1:0] left_1 = \u_dut.head_go ? to_2_q : to_1_q;
    wire [2:0]     as_left = as_q >> \u_dut.head_go ;
    wire [2:0]     short_left = short_q >> \u_dut.head_go ;
    wire           short = GROUP > 1 && \u_dut.s2_what [HW-1];
    always @(posedge clk) begin
        held_q <= stay + {2'd0, \u_dut.queue_go };
        to_0_q <= left_0 | (stay == 0 && \u_dut.queue_go ? made : {ALL{1'b0}});
        to_1_q <= left_1 | (stay == 1 && \u_dut.queue_go ? made : {ALL{1'b0}});
        to_2_q <= stay == 2 && \u_dut.queue_go ? made : {ALL{1'b0}};
        short_q <= short_left | ({2'd0, short && \u_dut.alloc } << stay);
        if (\u_dut.alloc ) ask_short_q <= short;
        as_q   <= as_left | ({2'd0, mark && \u_dut.alloc } << stay);
        if (\u_dut.walk_step ) begin
            used_q   <= used_q & ~way_walk;
            asked_q  <= asked_q & ~way_walk;
            filled_q <= filled_q & ~way_walk;
        end else begin
            if (\u_dut.alloc ) begin
                used_q  <= used_q | way_s2;
                asked_q <= (asked_q & ~way_s2) | (~now_2 & way_s2);
            end
            if (\u_dut.done_q )
                filled_q <= (filled_q & ~way_done) | (\u_dut.done_asked_q ? way_done : {ALL{1'b0}});
        end
        if (!old_q) begin
            held_q <= 3'd0; as_q <= 3'd0; short_q <= 3'd0;
            {to_0_q, to_1_q, to_2_q} <= {(3*ALL){1'b0}};
            {used_q, asked_q, filled_q} <= {(3*ALL){1'b0}};
        end
    end
    wire [ALL-1:0] to_0   = \u_dut.head_filled_q ? {ALL{1'b0}} : to_0_q;
    wire [ALL-1:0] done   = \u_dut.done_q ? way_done : {ALL{1'b0}};
    wire [ALL-1:0] coming = asked_q ^ filled_q;
    wire [WAYS-1:0] coming_2 = coming >> WAYS * \u_dut.s2_set ;
    wire [WAYS-1:0] filled_2 = filled_q >> WAYS * \u_dut.s2_set ;
    wire           states = coming == (to_0 | to_1_q | to_2_q | done) && (coming & ~used_q) == 0 &&
                           (to_0 & (to_1_q | to_2_q | done)) == 0 && (to_1_q & to_2_q) == 0 &&
                           (done & (to_1_q | to_2_q)) == 0;
    wire           words = (to_0 & (as_q[0] ? ~asked_q : asked_q)) == 0 &&
                           (to_1_q & (as_q[1] ? ~asked_q : asked_q)) == 0 &&
                           (to_2_q & (as_q[2] ? ~asked_q : asked_q)) == 0 &&
                           (done & (\u_dut.done_asked_q ? ~asked_q : asked_q)) == 0;
    wire           looks = !\u_dut.s2_valid_q || \u_dut.walk_q ||
                           (\u_dut.s2_coming_q == coming_2 && \u_dut.s2_filled_q == filled_2);
    wire [2:0] where = {2'd0, \u_dut.skid_q } + {2'd0, \u_dut.s1_valid_q } +
                       {2'd0, \u_dut.s2_valid_q } + {2'd0, rsp_valid} + held_q;
    reg  [1:0] part_q = 2'd0;            // lines of the oldest group that are there
    always @(posedge clk)
        if (!old_q || (\u_dut.fill && \u_dut.fill_last )) part_q <= 2'd0;
        else part_q <= part_q + {1'b0, \u_dut.fill };
    wire [3:0] tail  = lines_q & (GROUP - 1);    // lines of the last group, if not all
    wire [3:0] of_0  = |to_0 ? (short_q[0] ? tail : GROUP) : 4'd0; // lines of memory of each lead
    wire [3:0] of_1  = |to_1_q ? (short_q[1] ? tail : GROUP) : 4'd0;
    wire [3:0] of_2  = |to_2_q ? (short_q[2] ? tail : GROUP) : 4'd0;
    wire [3:0] place = mem_req_line[3:0] & (GROUP - 1);
    wire [3:0] lines_to_ask = mem_req_valid ? (ask_short_q ? tail : GROUP) - place : 4'd0;
    wire [3:0] came  = {2'd0, part_q} < of_0 ? {2'd0, part_q} : of_0; // of memory, of the oldest
    wire queue = where == {2'd0, busy_q[0]} + {2'd0, busy_q[1]} && held_q == \u_dut.held_q &&
                 (!\u_dut.head_valid_q || (held_q != 0 && \u_dut.head_leader == |to_0_q)) &&
                 (!\u_dut.head_filled_q || (\u_dut.head_valid_q && |to_0_q)) &&
                 (held_q > 0 || to_0_q == 0) && (held_q > 1 || to_1_q == 0) &&
                 (held_q > 2 || to_2_q == 0) &&
                 of_0 + of_1 + of_2 == count_q + lines_to_ask + came;
    wire holds = states && words && looks && queue;

    // ---- a line that came with an error is not kept: what is found at once has none ----
    (* hierconn *) wire \u_dut.hit_go ;
    reg hit_q = 1'b0;
    always @(posedge clk) if (rsp_ready || !rsp_valid) hit_q <= \u_dut.hit_go ;
    wire kept = old_q && rsp_valid && hit_q && rsp_error && !(rsp_tag ? void_q[1] : void_q[0]);

    // ---- no word of the data RAM, no key is read while it is written ----
    (* hierconn *) wire \u_dut.u_data.collision ;
    (* hierconn *) wire \u_dut.u_keys.collision ;
    assign bad_o = behind_q == QUIET || before_q == QUIET || kept || (old_q && !holds) ||
                   (old_q && (\u_dut.u_data.collision || \u_dut.u_keys.collision ));
endmodule
`default_nettype wire
