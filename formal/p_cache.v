// p_cache.v - proof of rt_cache: each request is answered once, with its line or, beyond memory, an
// error
// SPDX-License-Identifier: Apache-2.0
// A small cache, its memories as flip-flops, before a memory of 0 to 8 lines of which any one is
// marked: a line's data says whether it is that one. A line that memory has not comes with an
// error, and is asked for only if the whole of its group is beyond. Where memory ends may change
// while nothing is under way; without groups it only grows, since lines stay. Client and memory may
// stall at any time, lines come as late as they like, flushes at any time. Tags of requests under
// way differ (token rule). For abc's pdr, which finds the invariant itself: bad_o is never 1.
`timescale 1ns / 1ps
`default_nettype none
module p_cache #(
    parameter LINES   = 4,
    parameter WAYS    = 2,
    parameter GROUP   = 1,
    parameter PENDING = 2
) (
    input  wire       clk,
    input  wire       flush,
    input  wire       req_valid,
    input  wire [2:0] req_line,
    input  wire       req_tag,
    input  wire       rsp_ready,
    input  wire       mem_req_ready,
    input  wire       mem_rsp_valid,
    input  wire [2:0] mark,              // looked at in the first clock
    input  wire [3:0] lines,             // in the first, too,
    input  wire       move,              // and in these, if nothing is under way
    output wire       bad_o
);
    // ---- reset in the first clock; what memory holds ----
    wire      take;                      // a request of the client, below
    reg [1:0] busy_q = 2'd0;
    reg       old_q = 1'b0;
    reg [2:0] mark_q = 3'd0;
    reg [3:0] lines_q = 4'd0;
    wire [3:0] wanted = lines[3] ? 4'd8 : lines;
    wire       more   = wanted >= lines_q;
    always @(posedge clk) begin
        old_q <= 1'b1;
        if (!old_q) mark_q <= mark;
        if (!old_q || (move && busy_q == 2'd0 && !take && (GROUP > 1 || more)))
            lines_q <= wanted;
    end

    // ---- requests of the client: none with a tag that is under way ----
    reg        line_0_q = 1'b0, line_1_q = 1'b0; // is it the marked line?
    reg  [1:0] void_q = 2'd0;                    // is it beyond memory?
    wire req = req_valid && !(req_tag ? busy_q[1] : busy_q[0]);
    wire req_ready, rsp_valid, rsp_tag, rsp_error, mem_req_valid, mem_rsp_ready, miss;
    wire [255:0] rsp_data;
    wire [25:0]  mem_req_line;
    assign take = req && req_ready;
    wire give = rsp_valid && rsp_ready;

    // ---- memory: lines asked for, in order ----
    localparam N = PENDING * GROUP;
    reg  [3:0] count_q = 4'd0;
    reg  [N-1:0] ask_q = {N{1'b0}};              // is it the marked line? The oldest in bit 0
    reg  [N-1:0] none_q = {N{1'b0}};             // is it beyond memory?
    wire ask  = mem_req_valid && mem_req_ready;
    wire send = mem_rsp_valid && count_q != 0;
    wire sent = send && mem_rsp_ready;
    wire [3:0] left = count_q - {3'd0, sent};
    wire       line_asked = mem_req_line[2:0] == mark_q;
    wire       none_asked = {1'b0, mem_req_line[2:0]} >= lines_q;
    wire [2:0] group_asked = mem_req_line[2:0] & ~(GROUP[2:0] - 3'd1); // its first line
    always @(posedge clk) begin
        ask_q   <= (ask_q >> sent) | ({{(N-1){1'b0}}, ask && line_asked} << left);
        none_q  <= (none_q >> sent) | ({{(N-1){1'b0}}, ask && none_asked} << left);
        count_q <= left + {3'd0, ask};
        if (take && !req_tag) void_q[0] <= {1'b0, req_line} >= lines_q;
        if (take &&  req_tag) void_q[1] <= {1'b0, req_line} >= lines_q;
        if (take && !req_tag) line_0_q <= req_line == mark_q;
        if (take &&  req_tag) line_1_q <= req_line == mark_q;
        busy_q <= (busy_q & ~{give && rsp_tag, give && !rsp_tag}) |
                  {take && req_tag, take && !req_tag};
        if (!old_q) begin
            busy_q <= 2'd0; count_q <= 4'd0; ask_q <= {N{1'b0}}; none_q <= {N{1'b0}};
        end
    end
    rt_cache #(.TAG(1), .LINES(LINES), .WAYS(WAYS), .GROUP(GROUP), .PENDING(PENDING)) u_dut (
        .clk(clk), .rst(!old_q), .flush_i(flush), .mem_lines_i({22'd0, lines_q}), .miss_o(miss),
        .req_valid_i(req), .req_ready_o(req_ready), .req_line_i({23'd0, req_line}),
        .req_tag_i(req_tag), .rsp_valid_o(rsp_valid), .rsp_ready_i(rsp_ready),
        .rsp_data_o(rsp_data), .rsp_tag_o(rsp_tag), .rsp_error_o(rsp_error),
        .mem_req_valid_o(mem_req_valid), .mem_req_ready_i(mem_req_ready),
        .mem_req_line_o(mem_req_line), .mem_rsp_valid_i(send), .mem_rsp_ready_o(mem_rsp_ready),
        .mem_rsp_data_i({255'd0, ask_q[0]}), .mem_rsp_error_i(none_q[0])
    );

    // ---- an answer that nobody asked for, or with another line; more lines than may be ----
    wire line = rsp_tag ? line_1_q : line_0_q;
    wire none = rsp_tag ? void_q[1] : void_q[0];
    assign bad_o = old_q && ((rsp_valid && !(rsp_tag ? busy_q[1] : busy_q[0])) ||
                             (rsp_valid && rsp_error != none) ||
                             (rsp_valid && !none && rsp_data[0] != line) ||
                             (ask && none_asked && {1'b0, group_asked} < lines_q) ||
                             (ask && left == N));
endmodule
`default_nettype wire
