// p_cache_read.v - proof of rt_cache: no word of its data RAM is read while it is written
// SPDX-License-Identifier: Apache-2.0
// A small cache without the words of its lines, before a client and a memory that may stall at any
// time and answer with errors; flushes at any time. Tags of requests under way differ. For abc's
// pdr: bad_o is never 1.
`timescale 1ns / 1ps
`default_nettype none
module p_cache_read #(
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
    input  wire       mem_error,
    output wire       bad_o
);
    reg        old_q = 1'b0;
    reg  [1:0] busy_q = 2'd0;
    reg  [3:0] count_q = 4'd0;                   // lines that memory owes
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
        if (!old_q) begin busy_q <= 2'd0; count_q <= 4'd0; end
    end
    rt_cache #(.TAG(1), .LINES(LINES), .WAYS(WAYS), .GROUP(GROUP), .PENDING(PENDING)) u_dut (
        .clk(clk), .rst(!old_q), .flush_i(flush), .miss_o(miss),
        .req_valid_i(req), .req_ready_o(req_ready), .req_line_i({23'd0, req_line}),
        .req_tag_i(req_tag), .rsp_valid_o(rsp_valid), .rsp_ready_i(rsp_ready),
        .rsp_data_o(rsp_data), .rsp_tag_o(rsp_tag), .rsp_error_o(rsp_error),
        .mem_req_valid_o(mem_req_valid), .mem_req_ready_i(mem_req_ready),
        .mem_req_line_o(mem_req_line), .mem_rsp_valid_i(send), .mem_rsp_ready_o(mem_rsp_ready),
        .mem_rsp_data_i(256'd0), .mem_rsp_error_i(mem_error)
    );
    (* hierconn *) wire \u_dut.u_data.collision ;
    assign bad_o = old_q && \u_dut.u_data.collision ;
endmodule
`default_nettype wire
