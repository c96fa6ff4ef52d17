// f_pixel_scans.v - stands for rt_pixel_scans in proofs: it does nothing from its last pixel on
// SPDX-License-Identifier: Apache-2.0
// As f_engine.v; it is busy from a start on, as long as it likes.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_pixel_scans #(
    parameter W     = 16,
    parameter WD    = 17,
    parameter RECT  = 1,
    parameter SPANS = 1,
    parameter CONES = 1,
    parameter TURNED = 0,
    parameter WALKS = 1
) (
    input  wire                 clk,
    input  wire                 rst,
    input  wire                 start_i,
    output wire                 busy_o,
    input  wire [55:0]          window_i,
    input  wire [3*WD-1:0]      dir_i,
    input  wire [WD-1:0]        pitch_i,
    input  wire [95:0]          first_i,
    input  wire [95:0]          across_i,
    input  wire [95:0]          down_i,
    input  wire [1:0]           bg_mode_i,
    input  wire [55:0]          rect_i,
    input  wire [`RT_LINE_BITS-1:0] bg_base_i,
    input  wire [4:0]           bg_count_i,
    input  wire [`RT_LINE_BITS-1:0] mem_lines_i,
    output wire                 ray_valid_o,
    input  wire                 ray_ready_i,
    output wire [`RT_START_BITS-1:0] ray_o,
    output wire                 bg_valid_o,
    input  wire                 bg_ready_i,
    output wire [27:0]          bg_place_o,
    output wire [WALKS-1:0]     mem_req_valid_o,
    input  wire [WALKS-1:0]     mem_req_ready_i,
    output wire [`RT_LINE_BITS*WALKS-1:0] mem_req_line_o,
    input  wire [WALKS-1:0]     mem_rsp_valid_i,
    output wire [WALKS-1:0]     mem_rsp_ready_o,
    input  wire [255:0]         mem_rsp_data_i,
    input  wire                 mem_rsp_error_i,
    output wire                 bad_table_o,
    output wire                 bus_error_o
);
    (* anyseq *) wire busy, ray_valid, bg_valid, bad, bus;
    (* anyseq *) wire [`RT_START_BITS-1:0] ray;
    (* anyseq *) wire [27:0] place;
    (* anyseq *) wire [WALKS-1:0] asks, takes;
    (* anyseq *) wire [`RT_LINE_BITS*WALKS-1:0] lines;
    assign {busy_o, ray_valid_o, ray_o, bg_valid_o, bg_place_o} =
        {busy, ray_valid, ray, bg_valid, place};
    assign {mem_req_valid_o, mem_req_line_o, mem_rsp_ready_o} = {asks, lines, takes};
    assign {bad_table_o, bus_error_o} = {bad, bus};
    reg may_q = 1'b0;                    // it may be busy
    reg [WALKS-1:0] asked_q = 0;
    always @(posedge clk) begin
        may_q   <= (busy || start_i) && !rst;
        asked_q <= rst ? 0 : asks;
    end
    always @* begin
        assume (may_q || !busy);
        assume (busy || !(ray_valid || bg_valid || bad || bus));
        assume (busy || (asks & ~asked_q) == 0);
    end
endmodule
`default_nettype wire
