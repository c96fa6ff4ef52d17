// rt_mem_arbiter.v - shares one memory port among several readers of 256-bit lines
// SPDX-License-Identifier: Apache-2.0
//   client 0..n --> [round robin] --> mem_req        mem_rsp --> [4 beats] --> client of the line
//                        +------ order of requests -------------------^
// Request: latency 1 cycle, one a cycle. Line: 1 cycle after its last beat, one every 4 cycles.
// At most PENDING lines are on their way. Each client gets its lines in the order it asked for
// them; it must take them without waiting for the line of another client.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_mem_arbiter #(
    parameter CLIENTS = 2,    // readers, at least 1
    parameter PENDING = 16    // lines on their way, a power of two
) (
    input  wire                  clk,
    input  wire                  rst,              // synchronous, active high
    // from the clients, client i in bit i and in field i
    input  wire [CLIENTS-1:0]    req_valid_i,
    output wire [CLIENTS-1:0]    req_ready_o,
    input  wire [`RT_LINE_BITS*CLIENTS-1:0] req_line_i,
    // to the clients
    output wire [CLIENTS-1:0]    rsp_valid_o,      // one-hot
    input  wire [CLIENTS-1:0]    rsp_ready_i,
    output wire [255:0]          rsp_data_o,       // one bus for all
    output wire                  rsp_error_o,      // any beat had one
    // to memory
    output reg                   mem_req_valid_o,
    input  wire                  mem_req_ready_i,
    output reg  [`RT_LINE_BITS-1:0] mem_req_line_o,
    // from memory: four beats a line, low bits first, in the order of requests
    input  wire                  mem_rsp_valid_i,
    output wire                  mem_rsp_ready_o,
    input  wire [63:0]           mem_rsp_data_i,
    input  wire                  mem_rsp_error_i
);
    // ---- choice ----
    wire [CLIENTS-1:0] grant;
    wire [(CLIENTS > 1 ? $clog2(CLIENTS) : 1)-1:0] number;
    wire order_room;
    wire take                = order_room && (mem_req_ready_i || !mem_req_valid_o);
    wire give                = take && |req_valid_i;
    assign req_ready_o       = grant & {CLIENTS{take}};
    rt_rr_arbiter #(.N(CLIENTS)) u_turns (
        .clk(clk), .rst(rst), .asks_i(req_valid_i), .served_i(give), .turn_o(grant),
        .index_o(number)
    );

    // ---- request register ----
    reg  [`RT_LINE_BITS-1:0] line;                              // of the client chosen
    integer i;
    always @* begin
        line = {`RT_LINE_BITS{1'b0}};
        for (i = 0; i < CLIENTS; i = i + 1)
            if (grant[i]) line = line | req_line_i[`RT_LINE_BITS*i +: `RT_LINE_BITS];
    end
    always @(posedge clk) begin
        if (mem_req_ready_i || !mem_req_valid_o) begin
            mem_req_valid_o <= give;
            mem_req_line_o  <= line;
        end
        if (rst) mem_req_valid_o <= 1'b0;
    end

    // ---- order: whose line comes next ----
    wire               order_valid;
    wire [CLIENTS-1:0] owner;                      // one-hot
    wire               full_take;                  // the line leaves
    rt_fifo #(.WIDTH(CLIENTS), .DEPTH(PENDING)) u_order (
        .clk(clk), .rst(rst),
        .in_valid_i(give), .in_ready_o(order_room), .in_data_i(grant),
        .out_valid_o(order_valid), .out_ready_i(full_take), .out_data_o(owner)
    );

    // ---- line: four beats shifted in from the top ----
    reg  [255:0] line_q;
    reg          error_q;
    reg  [1:0]   beat_q;                           // beats of this line so far
    reg          full_q;                           // all four are there
    wire         beat_take = mem_rsp_valid_i && mem_rsp_ready_o;
    assign full_take       = full_q && |(owner & rsp_ready_i);
    assign mem_rsp_ready_o = full_take || !full_q;
    assign rsp_valid_o     = owner & {CLIENTS{full_q}};
    assign rsp_data_o      = line_q;
    assign rsp_error_o     = error_q;
    always @(posedge clk) begin
        if (full_take) full_q <= 1'b0;
        if (beat_take) begin
            line_q  <= {mem_rsp_data_i, line_q[255:64]};
            error_q <= mem_rsp_error_i || (error_q && beat_q != 2'd0);
            beat_q  <= beat_q + 1'b1;
            if (&beat_q) full_q <= 1'b1;
        end
        if (rst) begin beat_q <= 2'd0; full_q <= 1'b0; end
    end
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_memory_port /* verilator public_flat_rd */ =
        {|req_valid_i && !take, full_take, 5'd0, beat_take};
    wire unused = &{1'b0, number, order_valid};
endmodule
`default_nettype wire
