// f_engine.v - stands for rt_engine in proofs: whatever it does, it does nothing while it is idle
// SPDX-License-Identifier: Apache-2.0
// Idle: no slot is used, nor was one taken in the clock before. Then no pixel leaves, nothing is
// counted, nothing is wrong, and a line is asked for only if one was in the clock before. rt_core
// stops a simulation in which an engine breaks this. Lines are taken at any time.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_engine #(
    `include "rt_effects.vh"
    `include "rt_shade_parameters.vh"
    parameter PIPES = 1, LEAF_UNITS = 1, SHADES = 1, SETUPS = 1, SLOTS = 64, SQUARES = 0, LUTS = 0,
    parameter STACK = 16, ACCEL = 0, NODE_LINES = 256, LEAF_LINES = 128, ROOTS = 3,
    parameter ROOT_STEP = 2, LEAF_INTERVAL = 2, FACET_INTERVAL = 2, UNITS = 2,
    parameter UNIT_INTERVAL = 2,
    parameter READS = PIPES + LEAF_UNITS + (TEXTURE != 0 ? SHADES : 0)
) (
    input  wire                       clk,
    input  wire                       rst,
    input  wire                       flush_i,
    output wire                       busy_o,
    input  wire [`RT_REGS_BITS-1:0]   regs_i,
    input  wire [`RT_LIGHT_BITS-1:0]  light_i,
    input  wire                       in_valid_i,
    output wire                       in_ready_o,
    input  wire [`RT_START_BITS-1:0]  start_i,
    output wire                       pix_valid_o,
    input  wire                       pix_ready_i,
    output wire [`RT_PIXEL_BITS-1:0]  pix_o,
    output wire [READS-1:0]           mem_req_valid_o,
    input  wire [READS-1:0]           mem_req_ready_i,
    output wire [`RT_LINE_BITS*READS-1:0] mem_req_line_o,
    input  wire [READS-1:0]           mem_rsp_valid_i,
    output wire [READS-1:0]           mem_rsp_ready_o,
    input  wire [255:0]               mem_rsp_data_i,
    input  wire                       mem_rsp_error_i,
    output wire [PIPES*`RT_TRACE_EVENT_BITS-1:0]  trace_event_o,
    output wire [LEAF_UNITS*`RT_EXACT_EVENT_BITS-1:0] exact_event_o,
    output wire [SHADES*`RT_SHADE_EVENT_BITS-1:0] shade_event_o,
    output wire [15:0]                fault_o
);
    // anything, but for what is assumed
    (* anyseq *) wire busy, in_ready, pix_valid;
    (* anyseq *) wire [READS-1:0] asks, takes;
    (* anyseq *) wire [`RT_LINE_BITS*READS-1:0] lines;
    (* anyseq *) wire [`RT_PIXEL_BITS-1:0] pix;
    (* anyseq *) wire [PIPES*`RT_TRACE_EVENT_BITS-1:0] trace;
    (* anyseq *) wire [LEAF_UNITS*`RT_EXACT_EVENT_BITS-1:0] exact;
    (* anyseq *) wire [SHADES*`RT_SHADE_EVENT_BITS-1:0] shade;
    (* anyseq *) wire [15:0] fault;
    assign {busy_o, in_ready_o, pix_valid_o, pix_o} = {busy, in_ready, pix_valid, pix};
    assign {mem_req_valid_o, mem_req_line_o, mem_rsp_ready_o} = {asks, lines, takes};
    assign {trace_event_o, exact_event_o, shade_event_o, fault_o} = {trace, exact, shade, fault};
    reg may_q = 1'b0;                    // it may be busy
    reg [READS-1:0] asked_q = 0;
    always @(posedge clk) begin
        may_q   <= (busy || (in_valid_i && in_ready)) && !rst;
        asked_q <= rst ? 0 : asks;
    end
    always @* begin
        assume (may_q || !busy);
        assume (busy || !(pix_valid || |trace || |exact || |shade || |fault));
        assume (busy || (asks & ~asked_q) == 0);
    end
endmodule
`default_nettype wire
