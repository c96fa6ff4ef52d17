// rt_mem_arbiter.v - shares one memory port among several readers of 256-bit lines
// SPDX-License-Identifier: Apache-2.0
//   client 0..n --> [round robin] --> mem_req, tag: number of the client
//   client of the tag <-- [line] <-- [beats of each tag] <-- mem_rsp, tag
// Request: latency 1 cycle, one a cycle. Line: 1 cycle after its last beat, one every 256/DATA.
// At most PENDING lines are on their way. Lines of one tag come in the order of their requests;
// those of several tags in any order, and their beats may alternate. A line waits for its client
// alone, and all others behind it: a client takes its lines whatever the others do.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
`include "rt_layout.vh"
module rt_mem_arbiter #(
    parameter CLIENTS = 2,    // readers, at least 1
    parameter PENDING = 64,   // lines on their way, a power of two
    parameter DATA    = 64    // bits of a beat: 64, 128, 256
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
    output wire                  busy_o,           // a line is asked for, on its way or not taken
    // to memory
    output reg                   mem_req_valid_o,
    input  wire                  mem_req_ready_i,
    output reg  [`RT_LINE_BITS-1:0] mem_req_line_o,
    output reg  [`RT_TAG_BITS-1:0] mem_req_tag_o,  // number of the client
    // from memory: beats of a line, low bits first
    input  wire                  mem_rsp_valid_i,
    output wire                  mem_rsp_ready_o,
    input  wire [`RT_TAG_BITS-1:0] mem_rsp_tag_i,  // whose line it is of
    input  wire [DATA-1:0]       mem_rsp_data_i,
    input  wire                  mem_rsp_error_i
);
    localparam NB = CLIENTS > 1 ? $clog2(CLIENTS) : 1; // bits of a client's number
    localparam PB = $clog2(PENDING);
    localparam TB = `RT_TAG_BITS;
    localparam BEATS = 256 / DATA;
    `RT_CHECK(CLIENTS <= 1 << TB, rt_mem_arbiter_CLIENTS_must_have_a_tag_each)
    `RT_CHECK(PENDING == 1 << PB, rt_mem_arbiter_PENDING_must_be_a_power_of_two)
    `RT_CHECK(DATA == 64 || DATA == 128 || DATA == 256, rt_mem_arbiter_DATA_must_be_64_128_or_256)

    // ---- choice ----
    wire [CLIENTS-1:0] grant;
    wire [NB-1:0] number;
    reg  [PB:0] coming_q;                          // lines on their way, up to PENDING
    reg         came_q;                            // ... less one that came in the last clock
    wire take                = !coming_q[PB] && (mem_req_ready_i || !mem_req_valid_o);
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
            mem_req_tag_o   <= {{(TB-NB){1'b0}}, number};
        end
        if (rst) mem_req_valid_o <= 1'b0;
    end

    // ---- beats: of each client those before the last one ----
    reg          full_q;                           // a whole line is there
    reg  [CLIENTS-1:0] owner_q;                    // its client, one-hot
    reg  [255:0] line_q;
    reg          error_q;
    wire         full_take = full_q && |(owner_q & rsp_ready_i);
    wire         beat_take = mem_rsp_valid_i && mem_rsp_ready_o;
    wire         last;                             // this beat makes a line whole
    wire [256:0] whole;                            // {error, line} with it
    wire [NB-1:0] of = mem_rsp_tag_i[NB-1:0];
    generate
        if (BEATS < 2) begin : g_line
            assign last  = 1'b1;
            assign whole = {mem_rsp_error_i, mem_rsp_data_i};
        end else begin : g_beats
            localparam BB = $clog2(BEATS);
            localparam [31:0] LAST = BEATS - 1;
            reg  [BB*CLIENTS-1:0] beats_q;         // of each client, that came of a line
            wire [BB-1:0] beat = beats_q[BB*of +: BB];
            wire [LAST:0] error;
            genvar b;
            for (b = 0; b < BEATS - 1; b = b + 1) begin : g_beat
                localparam [31:0] AT = b;
                rt_slot_file #(.WIDTH(DATA + 1), .SLOTS(1 << NB)) u_beat (
                    .clk(clk), .wr_en_i(beat_take && beat == AT[BB-1:0]), .wr_addr_i(of),
                    .wr_data_i({mem_rsp_error_i, mem_rsp_data_i}), .rd_addr_i(of),
                    .rd_data_o({error[b], whole[DATA*b +: DATA]})
                );
            end
            assign last  = beat == LAST[BB-1:0];
            assign error[LAST] = mem_rsp_error_i;
            assign whole[256 -: DATA + 1] = {|error, mem_rsp_data_i};
            always @(posedge clk) begin
                if (beat_take) beats_q[BB*of +: BB] <= beat + 1'b1;
                if (rst) beats_q <= {BB*CLIENTS{1'b0}};
            end
        end
    endgenerate

    // ---- line ----
    wire         line_take = beat_take && last;
    assign mem_rsp_ready_o = full_take || !full_q;
    assign rsp_valid_o     = owner_q & {CLIENTS{full_q}};
    assign rsp_data_o      = line_q;
    assign rsp_error_o     = error_q;
    assign busy_o          = |req_valid_i || mem_req_valid_o || coming_q != {(PB+1){1'b0}} ||
                             full_q;
    integer k;
    always @(posedge clk) begin
        came_q   <= line_take;
        coming_q <= coming_q + {{PB{1'b0}}, give} - {{PB{1'b0}}, came_q};
        if (full_take) full_q <= 1'b0;
        if (line_take) begin
            {error_q, line_q} <= whole;
            full_q            <= 1'b1;
            for (k = 0; k < CLIENTS; k = k + 1) owner_q[k] <= of == k[NB-1:0];
        end
        if (rst) begin coming_q <= {(PB+1){1'b0}}; came_q <= 1'b0; full_q <= 1'b0; end
    end
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_memory_port /* verilator public_flat_rd */ =
        {|req_valid_i && !take, full_take, 5'd0, beat_take};
    wire unused = &{1'b0, mem_rsp_tag_i};
endmodule
`default_nettype wire
