// rt_cache.v - read-only, set-associative, non-blocking cache of 256-bit lines
// SPDX-License-Identifier: Apache-2.0
//   req --> [s1: tags, hit?] --> [s2: where to] --hit--> [data RAM] --> rsp  hits overtake misses
//                                  | miss, or line on its way   ^  ^
//                                  +----> queue, in order ------+  +-- memory, in order of mem_req
// Hit: latency 3 cycles, one a cycle. Miss: waits in the queue for its line, 2 cycles more.
// Responses carry the tag of their request; only requests that queue keep their order.
// A line of the cache is an aligned group of GROUP lines of memory; a miss fetches those of them
// that memory has, and a line beyond it is answered with an error. mem_lines_i says where memory
// ends; with GROUP > 1 every line is forgotten when it changes, else lines that are held stay, also
// beyond an end that comes nearer without a flush.
// Why it is right: docs/design/shared_units.md.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_check.vh"
module rt_cache #(
    parameter TAG     = 8,    // bits of a request's tag
    parameter LINES   = 256,  // lines of memory held, a power of two
    parameter WAYS    = 4,    // groups of a set, a power of two, 1 .. LINES/GROUP/2
    parameter GROUP   = 1,    // lines of memory fetched together, a power of two
    parameter PENDING = 16,   // requests that may wait for memory, a power of two
    parameter LINE_BITS = `RT_LINE_BITS // bits of a line's number: no other line is asked for
) (
    input  wire           clk,
    input  wire           rst,              // synchronous, active high
    input  wire           flush_i,          // one cycle: forget every line
    input  wire [`RT_LINE_BITS-1:0] mem_lines_i,      // lines of memory, changes while idle
    output reg            miss_o,           // one cycle per group asked of memory
    // from the client
    input  wire           req_valid_i,
    output wire           req_ready_o,
    input  wire [`RT_LINE_BITS-1:0] req_line_i,       // line wanted
    input  wire [TAG-1:0] req_tag_i,        // comes back with it
    // to the client
    output reg            rsp_valid_o,
    input  wire           rsp_ready_i,
    output wire [255:0]   rsp_data_o,
    output reg  [TAG-1:0] rsp_tag_o,
    output wire           rsp_error_o,      // bus error, or beyond memory: data is void
    // to memory
    output reg            mem_req_valid_o,
    input  wire           mem_req_ready_i,
    output reg  [`RT_LINE_BITS-1:0] mem_req_line_o,
    // from memory, in the order of requests
    input  wire           mem_rsp_valid_i,
    output wire           mem_rsp_ready_o,
    input  wire [255:0]   mem_rsp_data_i,
    input  wire           mem_rsp_error_i
);
    localparam SETS = LINES / GROUP / WAYS;
    localparam GB   = $clog2(GROUP);        // bits of a place in a group
    localparam SB   = $clog2(SETS);         // bits of a set number
    localparam WB   = WAYS > 1 ? $clog2(WAYS) : 1; // bits of a way number
    localparam PB   = SB + GB;              // bits of a set and a place in its group
    localparam HB   = PB + (GROUP > 1 ? 1 : 0); // of these in the queue, and of whether memory ends
    localparam KB   = LINE_BITS - PB;       // line number above them
    localparam KW   = KB + 1;               // of a way: {asked, key}
    localparam HALF = KB / 2;
    localparam AB   = $clog2(LINES);        // bits of an address of the data RAM
    `RT_CHECK(LINES == (1 << AB), rt_cache_LINES_must_be_a_power_of_two)
    `RT_CHECK(WAYS == (1 << $clog2(WAYS)), rt_cache_WAYS_must_be_a_power_of_two)
    `RT_CHECK(GROUP == (1 << GB), rt_cache_GROUP_must_be_a_power_of_two)
    `RT_CHECK(SETS >= 2, rt_cache_LINES_must_be_at_least_2_sets_of_WAYS_groups)
    `RT_CHECK(KB >= 2 && LINE_BITS <= `RT_LINE_BITS, rt_cache_LINE_BITS_must_have_a_key)

    function [WB-1:0] number(input [WAYS-1:0] onehot);
        integer i;
        begin
            number = {WB{1'b0}};
            for (i = 0; i < WAYS; i = i + 1) if (onehot[i]) number = number | i[WB-1:0];
        end
    endfunction

    // ---- walk: after reset and flush, clears the state of one set a cycle; lookups wait ----
    reg            walk_q;
    reg  [SB-1:0]  walk_set_q;
    wire           none_held;               // the queue is empty
    wire           forget;                  // flush_i, or memory ends elsewhere than before
    wire           walk_step = walk_q && none_held;
    always @(posedge clk) begin
        if (walk_step) begin
            walk_set_q <= walk_set_q + 1'b1;
            if (&walk_set_q) walk_q <= 1'b0;
        end
        if (rst || forget) begin walk_q <= 1'b1; walk_set_q <= {SB{1'b0}}; end
    end

    // ---- stage 1: has the keys of a set; a request that it cannot take waits before it ----
    // Keys are read while a request comes. What an allocation changes in that clock, or while the
    // request waits, is read again.
    reg            skid_q, s1_valid_q;
    reg            stale_q;                 // keys are not those of the set any more
    reg  [`RT_LINE_BITS-1:0] skid_line_q, s1_line_q;
    reg  [TAG-1:0] skid_tag_q, s1_tag_q;
    reg            s2_valid_q;
    reg  [`RT_LINE_BITS-1:0] s2_line_q;
    reg  [TAG-1:0] s2_tag_q;
    reg  [WAYS-1:0] s2_low_q, s2_high_q;    // its line is the wanted one, by half a key each
    reg  [WAYS-1:0] s2_good_q;              // line of the way is held, without error
    reg  [WAYS-1:0] s2_coming_q;            // ... is on its way, whichever it is
    reg  [WAYS-1:0] s2_filled_q;
    wire [WAYS-1:0] s2_match  = s2_low_q & s2_high_q;
    wire [WAYS-1:0] s2_hits   = s2_match & s2_good_q;
    wire           s2_hit    = |s2_hits;
    wire           s2_follow = |(s2_match & s2_coming_q);
    wire           s2_miss   = !s2_hit && !s2_follow;
    wire           s2_go;                   // the lookup is done with
    wire [PB-1:0]  s2_place = s2_line_q[PB-1:0];
    wire [SB-1:0]  s1_set = s1_line_q[PB-1:GB];
    wire [SB-1:0]  s2_set = s2_place[PB-1:GB];
    wire           s2_free = s2_go || !s2_valid_q;
    // An allocation of this clock is not read in it: a lookup in the same set waits.
    wire           s1_wait = walk_q || stale_q || (s2_valid_q && s2_miss && s1_set == s2_set);
    wire           s1_free = s1_valid_q ? s2_free && !s1_wait : !stale_q;
    wire [`RT_LINE_BITS-1:0] s0_line = skid_q ? skid_line_q : req_line_i;
    wire [SB-1:0]  s0_set = s0_line[PB-1:GB];
    wire           alloc;                   // this cycle allocates a way
    wire           s0_valid = skid_q || req_valid_i;
    wire           s0_stale = alloc && s0_valid && s0_set == s2_set;
    wire           s1_stale = alloc && s1_valid_q && s1_set == s2_set;
    assign req_ready_o = !skid_q;
    always @(posedge clk) begin
        stale_q <= walk_q || s0_stale || s1_stale;
        skid_q <= !s1_free && s0_valid;
        if (!skid_q && req_valid_i) begin
            skid_line_q <= req_line_i;
            skid_tag_q  <= req_tag_i;
        end
        if (s1_free) begin
            s1_valid_q <= s0_valid;
            s1_line_q  <= s0_line;
            s1_tag_q   <= skid_q ? skid_tag_q : req_tag_i;
        end
        if (s2_free) s2_valid_q <= s1_valid_q && !s1_wait;
        if (s2_free && s1_valid_q) begin
            s2_line_q  <= s1_line_q;
            s2_tag_q   <= s1_tag_q;
        end
        if (rst) begin skid_q <= 1'b0; s1_valid_q <= 1'b0; s2_valid_q <= 1'b0; end
    end

    // State of a line, in two memories because two places write it:
    //   by allocation: {asked, key}, of all ways in a word     by fill: {error, filled}
    // asked and filled differ while the line is on its way; an allocation makes them differ, the
    // fill (the last one of a group) makes them equal again, a clock after the line. A line that is
    // forgotten has an error.
    wire [WAYS-1:0] victim;                 // which, one-hot
    wire            fill;                   // this cycle writes a line from memory
    wire            fill_last;              // it is the last of its group
    wire            fill_error;             // a bus error came with one of the group so far
    wire            head_asked;             // of the line at the head of the queue
    wire [PB-1:0]   head_place;
    wire [SB-1:0]   head_set = head_place[PB-1:GB];
    wire [WB-1:0]   head_way;
    reg             done_q, done_error_q, done_asked_q; // a group was filled in the last clock
    reg  [SB-1:0]   done_set_q;
    reg  [WAYS-1:0] done_way_q;
    integer         w;
    always @(posedge clk) begin
        done_q       <= fill && fill_last && !rst;
        done_error_q <= fill_error;
        done_asked_q <= head_asked;
        done_set_q   <= head_set;
        for (w = 0; w < WAYS; w = w + 1) done_way_q[w] <= head_way == w[WB-1:0];
    end
    wire [WAYS-1:0] done_1 = done_way_q & {WAYS{done_q && done_set_q == s1_set}};
    wire [WAYS-1:0] done_2 = done_way_q & {WAYS{done_q && done_set_q == s2_set}};
    wire [WAYS*KW-1:0] s1_keys, s2_keys;    // as they are; with the allocation of this clock
    rt_slot_ram #(.WIDTH(WAYS*KW), .SLOTS(SETS), .OLD(0)) u_keys (
        .clk(clk),
        .wr_en_i(walk_step || alloc), .wr_addr_i(walk_q ? walk_set_q : s2_set),
        .wr_data_i(s2_keys),
        .rd_en_i(!walk_q && (stale_q ? s1_valid_q && !s1_stale : s1_free && s0_valid && !s0_stale)),
        .rd_addr_i(stale_q ? s1_set : s0_set), .rd_data_o(s1_keys)
    );
    genvar g;
    generate
        for (g = 0; g < WAYS; g = g + 1) begin : g_way
            wire          asked, error, filled;
            wire [KB-1:0] key;
            reg  [KW-1:0] key_q;
            assign {asked, key} = s1_keys[KW*g +: KW];
            assign s2_keys[KW*g +: KW] = walk_q ? {KW{1'b0}}
                : victim[g] ? {!s2_filled_q[g], s2_line_q[LINE_BITS-1:PB]} : key_q;
            always @(posedge clk) begin
                if (s2_free && s1_valid_q) key_q <= {asked, key};
                if (walk_q)  key_q <= {KW{1'b0}};
            end
            rt_slot_file #(.WIDTH(2), .SLOTS(SETS)) u_fill (
                .clk(clk),
                .wr_en_i(walk_step || (done_q && done_way_q[g])),
                .wr_addr_i(walk_step ? walk_set_q : done_set_q),
                .wr_data_i({walk_step || done_error_q, !walk_step && done_asked_q}),
                .rd_addr_i(s1_set), .rd_data_o({error, filled})
            );
            wire [KB-1:0] other = key ^ s1_line_q[LINE_BITS-1:PB];
            wire coming = asked != filled && !done_1[g];
            wire good   = done_1[g] ? !done_error_q : asked == filled && !error;
            always @(posedge clk) begin
                if (s2_free) begin
                    s2_low_q[g]    <= other[HALF-1:0] == {HALF{1'b0}};
                    s2_high_q[g]   <= other[KB-1:HALF] == {(KB-HALF){1'b0}};
                    s2_good_q[g]   <= good;
                    s2_coming_q[g] <= coming;
                    s2_filled_q[g] <= filled ^ done_1[g];
                end else if (done_2[g]) begin
                    s2_good_q[g]   <= s2_good_q[g] || (s2_coming_q[g] && !done_error_q);
                    s2_coming_q[g] <= 1'b0;
                    s2_filled_q[g] <= done_asked_q;
                end
                if (walk_q) begin           // every line is forgotten
                    s2_low_q[g]    <= 1'b0;
                    s2_coming_q[g] <= 1'b0;
                    s2_filled_q[g] <= 1'b0;
                end
            end
        end
    endgenerate

    // ---- stage 2: victim, the first way not used recent; never one whose line is coming ----
    reg  [WAYS-1:0] recent_q;               // ways used since all were
    wire [WAYS-1:0] may   = ~s2_coming_q;
    wire [WAYS-1:0] pick  = |(may & ~recent_q) ? may & ~recent_q : may;
    assign victim         = pick & (~pick + 1'b1);
    wire [WAYS-1:0] found = s2_match & (s2_good_q | s2_coming_q);
    wire [WAYS-1:0] touch = s2_miss ? victim : found;
    wire [WAYS-1:0] after = recent_q | touch;
    wire [WAYS-1:0] s1_recent;
    rt_slot_file #(.WIDTH(WAYS), .SLOTS(SETS)) u_recent (
        .clk(clk),
        .wr_en_i(walk_step || s2_go),
        .wr_addr_i(walk_q ? walk_set_q : s2_set),
        .wr_data_i(walk_q ? {WAYS{1'b0}} : &after ? touch : after),
        .rd_addr_i(s1_set), .rd_data_o(s1_recent)
    );
    // Read in stage 1. A lookup of the same set in stage 2 has found its line, or stage 1 waits.
    wire [WAYS-1:0] both  = recent_q | found;
    always @(posedge clk) begin
        if (s2_free) recent_q <= !s2_valid_q || s1_set != s2_set ? s1_recent
                               : &both ? found : both;
        if (walk_q)  recent_q <= {WAYS{1'b0}};
    end

    // ---- stage 2: where to. A hit needs the data RAM, the rest a place in the queue ----
    wire rsp_free;                          // the response register can take a line
    wire head_ready;                        // the head of the queue wants the data RAM
    reg  room_q;                            // the queue takes one more
    wire mem_go    = mem_req_ready_i || !mem_req_valid_o;
    wire mem_more;                          // lines of the group at hand are still to be asked for
    wire s2_run    = s2_valid_q && !walk_q;
    wire hit_go    = s2_run && s2_hit && rsp_free && !head_ready;
    wire follow_go = s2_run && s2_follow && room_q;
    assign alloc   = s2_run && s2_miss && room_q && !mem_req_valid_o && |may;
    assign s2_go   = hit_go || follow_go || alloc;
    always @(posedge clk) begin
        if (mem_go) mem_req_valid_o <= alloc || mem_more;
        miss_o <= alloc;
        if (rst) begin mem_req_valid_o <= 1'b0; miss_o <= 1'b0; end
    end
    // for benches: what happens; {every line is forgotten, a group came, with an error, a lookup}
    wire [3:0] seen /* verilator public_flat_rd */ =
        {forget, fill && fill_last, fill_error, s2_go};

    // ---- the lines of a group: asked for and filled in order ----
    wire [PB-1:0] fill_place;
    wire          fill_void;                // a line beyond memory: an error in its place
    wire [HB-1:0] s2_what, head_what;       // place, and whether memory ends within its group
    generate
        if (GROUP == 1) begin : g_line
            always @(posedge clk) if (s2_valid_q && !mem_req_valid_o) mem_req_line_o <= s2_line_q;
            assign forget     = flush_i;
            assign s2_what    = s2_place;
            assign head_place = head_what;
            assign mem_more   = 1'b0;
            assign fill_place = head_place;
            assign fill_last  = 1'b1;
            assign fill_void  = 1'b0;
            assign fill_error = mem_rsp_error_i;
            wire unused_end   = &{1'b0, mem_lines_i};
        end else begin : g_group
            reg [`RT_LINE_BITS-1:0] lines_q;
            reg          s2_short_q;        // memory ends within the group at hand
            wire         head_short;        // ... within that of the head
            reg [GB-1:0] last_q;            // place of the last line to be asked for
            reg [GB-1:0] fill_q;            // place of the next line that is filled
            reg          error_q;           // a bus error came with one before it
            wire [GB-1:0] tail = mem_lines_i[GB-1:0]; // lines of the group in which memory ends
            always @(posedge clk) begin
                lines_q <= mem_lines_i;
                if (s2_free) s2_short_q <= tail != {GB{1'b0}} &&
                    s1_line_q[`RT_LINE_BITS-1:GB] == mem_lines_i[`RT_LINE_BITS-1:GB];
                if (alloc) last_q <= s2_short_q ? tail - 1'b1 : {GB{1'b1}};
                if (mem_go) mem_req_line_o <= mem_more ? mem_req_line_o + 1'b1
                                              : {s2_line_q[`RT_LINE_BITS-1:GB], {GB{1'b0}}};
                if (fill) begin
                    fill_q  <= fill_q + 1'b1;
                    error_q <= fill_error && !fill_last;
                end
                if (rst) begin fill_q <= {GB{1'b0}}; error_q <= 1'b0; end
            end
            assign forget     = flush_i || lines_q != mem_lines_i;
            assign s2_what    = {s2_short_q, s2_place};
            assign {head_short, head_place} = head_what;
            assign mem_more   = mem_req_valid_o && mem_req_line_o[GB-1:0] != last_q;
            assign fill_place = {head_set, fill_q};
            assign fill_last  = &fill_q;
            assign fill_void  = head_short && fill_q >= tail;
            assign fill_error = (mem_rsp_error_i && !fill_void) || error_q;
        end
    endgenerate

    // ---- queue: leaders, whose line is asked of memory, and followers, in order; its head ----
    localparam QB = 2 + HB + WB + TAG;
    localparam CB = $clog2(PENDING) + 1;
    wire           queue_go = follow_go || alloc;
    wire           queue_in, queue_valid;
    wire [QB-1:0]  queue_data;
    reg            head_valid_q;
    reg  [QB-1:0]  head_q;
    wire           head_leader;
    wire           head_go;                 // the head reads the data RAM and leaves
    wire           head_free = head_go || !head_valid_q;
    wire [TAG-1:0] head_tag;
    reg            head_filled_q;           // the group of the leader is written
    wire           head_lacks = head_valid_q && head_leader && !head_filled_q;
    reg  [CB-1:0]  held_q;                  // requests in the queue and in its head
    rt_fifo #(.WIDTH(QB), .DEPTH(PENDING)) u_queue (
        .clk(clk), .rst(rst),
        .in_valid_i(queue_go), .in_ready_o(queue_in),
        .in_data_i({alloc, |(~s2_filled_q & victim), s2_what, number(touch), s2_tag_q}),
        .out_valid_o(queue_valid), .out_ready_i(head_free), .out_data_o(queue_data)
    );
    assign {head_leader, head_asked, head_what, head_way, head_tag} = head_q;
    assign none_held       = held_q == {CB{1'b0}};
    assign mem_rsp_ready_o = head_lacks && !fill_void;
    assign fill            = head_lacks && (mem_rsp_valid_i || fill_void);
    assign head_ready      = head_valid_q && (!head_leader || head_filled_q);
    assign head_go         = head_ready && rsp_free;
    always @(posedge clk) begin
        if (head_free) head_valid_q <= queue_valid;
        if (head_free && queue_valid) head_q <= queue_data;
        held_q <= held_q + {{(CB-1){1'b0}}, queue_go} - {{(CB-1){1'b0}}, head_go};
        room_q <= held_q < PENDING[CB-1:0] - 1'b1;
        if (fill && fill_last) head_filled_q <= 1'b1;
        if (head_go) head_filled_q <= 1'b0;
        if (rst) begin
            head_valid_q <= 1'b0; head_filled_q <= 1'b0;
            held_q <= {CB{1'b0}}; room_q <= 1'b1;
        end
    end
    wire unused = &{1'b0, queue_in};

    // ---- stage 3: data RAM; its output is the response ----
    wire [AB-1:0] fill_at, head_at, hit_at;
    generate
        if (WAYS == 1) begin : g_direct
            assign {fill_at, head_at, hit_at} = {fill_place, head_place, s2_place};
        end else begin : g_ways
            assign fill_at = {head_way, fill_place};
            assign head_at = {head_way, head_place};
            assign hit_at  = {number(s2_hits), s2_place};
        end
    endgenerate
    assign rsp_free = rsp_ready_i || !rsp_valid_o;
    rt_slot_ram #(.WIDTH(257), .SLOTS(LINES), .OLD(0)) u_data (
        .clk(clk),
        .wr_en_i(fill), .wr_addr_i(fill_at),
        .wr_data_i({mem_rsp_error_i || fill_void, mem_rsp_data_i}),
        .rd_en_i(rsp_free && (head_ready || (s2_run && s2_hit))),   // head_go || hit_go
        .rd_addr_i(head_ready ? head_at : hit_at),
        .rd_data_o({rsp_error_o, rsp_data_o})
    );
    always @(posedge clk) begin
        if (rsp_free) begin
            rsp_valid_o <= head_go || hit_go;
            rsp_tag_o   <= head_ready ? head_tag : s2_tag_q;
        end
        if (rst) rsp_valid_o <= 1'b0;
    end
endmodule
`default_nettype wire
