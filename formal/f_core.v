// f_core.v - proof of rt_core: while active_o is low, an edge of clk changes nothing that is seen
// SPDX-License-Identifier: Apache-2.0
// So a clock that stands still then is one that runs. No request, pixel or line is under way; an
// edge leaves registers, errors and the addressed counter as they are, and the core idle, until
// rst, start_i, cfg_valid_i or another counter is seen. f_engine.v and f_pixel_scans.v stand for
// what is inside; counters have been left alone for as many clocks as f_counts.v asks for, which is
// not so of the clocks after a reset, in which they are cleared.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module f_core #(
    parameter ENGINES = 1,
    parameter SPANS   = 1,
    parameter CALM    = 36,      // clocks in which counters come to rest, PLACES + 4
    parameter W       = 16,
    parameter WD      = 17
) (
    input wire         clk,
    input wire         rst,
    input wire         cfg_valid, start, keep,
    input wire [6:0]   cfg_addr,
    input wire [31:0]  cfg_data,
    input wire         req_ready, rsp_valid, rsp_error, pix_ready,
    input wire [`RT_TAG_BITS-1:0] rsp_tag,
    input wire [63:0]  rsp_data,
    input wire [4:0]   count_addr
);
    localparam KW = W + WD + 2;
    wire busy, active, req_valid, rsp_ready, pix_valid;
    wire [`RT_LINE_BITS-1:0] req_line;
    wire [`RT_TAG_BITS-1:0] req_tag;
    wire [13:0] x, y;
    wire [71:0] colour;
    wire [`RT_RGB_BITS-1:0] pix_frame;
    wire [`RT_ID_BITS-1:0] id;
    wire [KW-1:0] key;
    wire [`RT_VISITS_BITS-1:0] visits;
    wire [31:0] texture;
    wire [47:0] count;
    wire [`RT_ERRORS-1:0] errors;
    rt_core #(.W(W), .WD(WD), .LIGHTS(0), .SHADOW(0), .REFLECT(0), .INSIDE(0), .FIRST(0),
              .INTERPENETRATE(0), .CONES(0), .RECT(0), .SPANS(SPANS), .ENGINES(ENGINES),
              .MEM_PENDING(16)) u_dut (
        .clk(clk), .rst(rst), .cfg_valid_i(cfg_valid), .cfg_addr_i(cfg_addr),
        .cfg_data_i(cfg_data), .start_i(start), .keep_cache_i(keep), .busy_o(busy),
        .active_o(active), .mem_req_valid_o(req_valid), .mem_req_ready_i(req_ready),
        .mem_req_line_o(req_line), .mem_req_tag_o(req_tag), .mem_rsp_valid_i(rsp_valid),
        .mem_rsp_ready_o(rsp_ready), .mem_rsp_tag_i(rsp_tag), .mem_rsp_data_i(rsp_data),
        .mem_rsp_error_i(rsp_error), .pix_valid_o(pix_valid), .pix_ready_i(pix_ready),
        .pix_x_o(x), .pix_y_o(y), .pix_colour_o(colour), .pix_frame_o(pix_frame), .pix_id_o(id),
        .pix_key_o(key), .pix_visits_o(visits), .pix_texture_o(texture),
        .count_addr_i(count_addr), .count_data_o(count), .errors_o(errors)
    );
    (* hierconn *) wire [`RT_REGS_BITS-1:0] \u_dut.regs ;
    (* hierconn *) wire [31:0] \u_dut.effects , \u_dut.profile ;
    (* hierconn *) wire [1:0]  \u_dut.frame , \u_dut.bg_mode ;
    (* hierconn *) wire [55:0] \u_dut.window ;
    (* hierconn *) wire [`RT_LINE_BITS-1:0] \u_dut.bg_base ;
    (* hierconn *) wire [4:0]  \u_dut.u_arbiter.coming_q ;
    (* hierconn *) wire        \u_dut.u_arbiter.full_q , \u_dut.u_arbiter.came_q ;
    (* hierconn *) wire [7:0]  \u_dut.u_counters.calm_q ;
    (* hierconn *) wire [8*(CALM - 4)-1:0] \u_dut.add_q ;
    (* hierconn *) wire [5:0]  \u_dut.settle_q ;
    (* hierconn *) wire        \u_dut.working , \u_dut.u_walks.may_q ;
    (* hierconn *) wire        \u_dut.g_engine[0].u_engine.may_q ;
    // ---- what is seen, and what it was before the last edge ----
    wire [`RT_REGS_BITS+64+4+56+`RT_LINE_BITS+`RT_ERRORS-1:0] seen = {\u_dut.regs , \u_dut.effects ,
        \u_dut.profile , \u_dut.frame , \u_dut.bg_mode , \u_dut.window , \u_dut.bg_base , errors};
    reg [`RT_REGS_BITS+64+4+56+`RT_LINE_BITS+`RT_ERRORS-1:0] seen_q;
    reg        old_q = 1'b0;
    reg        idle_q;                   // active_o was low
    reg [4:0]  addr_q;
    reg [7:0]  reset_q;                  // clocks since a reset, up to CALM + 2
    always @(posedge clk) begin
        old_q   <= 1'b1;
        idle_q  <= !active && old_q;
        seen_q  <= seen;
        addr_q  <= count_addr;
        reset_q <= rst ? 8'd0 : reset_q < CALM + 2 ? reset_q + 1'b1 : reset_q;
    end
    wire woken = rst || start || cfg_valid || count_addr != addr_q;
    always @* begin
        if (!old_q) assume (rst);
        // memory answers what it was asked for
        if (\u_dut.u_arbiter.coming_q == \u_dut.u_arbiter.came_q ) assume (!rsp_valid);
    end
    always @* if (old_q) begin
        if (!active) begin
            assert (!busy && !req_valid && !pix_valid && !woken);
            assert (\u_dut.u_arbiter.coming_q == 0 && !\u_dut.u_arbiter.full_q );
        end
        if (idle_q) begin
            assert (seen == seen_q);
            assert (!busy && !req_valid && !pix_valid);
            assert (active == woken);
            if (reset_q == CALM + 2) assert (\u_dut.u_counters.calm_q >= CALM);
        end
        // invariants; what works has begun to settle, which ends no earlier than counters do
        if (\u_dut.working || \u_dut.u_walks.may_q || \u_dut.g_engine[0].u_engine.may_q )
            assert (\u_dut.settle_q == CALM + 1);
        assert (\u_dut.u_arbiter.coming_q >= \u_dut.u_arbiter.came_q );
        assert (reset_q <= CALM + 2 && \u_dut.settle_q <= CALM + 1);
        assert (\u_dut.u_counters.calm_q + 2 >= reset_q ||
                (\u_dut.settle_q != 0 && \u_dut.u_counters.calm_q + \u_dut.settle_q >= CALM));
        if (\u_dut.add_q != 0) assert (reset_q == 0 || \u_dut.settle_q == CALM + 1);
    end
endmodule
`default_nettype wire
