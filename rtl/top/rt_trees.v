// rt_trees.v - trees of two places: which is built, which is the newest, which a frame reads
// SPDX-License-Identifier: Apache-2.0
//   IDLE -- BUILD --> WAIT until no frame reads the place -> GO -> RUN rt_build -> IDLE
//   any -- SOFT_RESET, silent bus --> CUT until the buses owe nothing -> IDLE
// A tree is built in the place that the newest complete one does not have, so that this stays whole
// after an error; without an error the other is the newest. A frame reads the tree that was the
// newest at its START, in place of register ROOT if root_i says so. START with BUILD waits for the
// tree, and for the frame before it; after an error it does nothing.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_top.vh"
module rt_trees (
    input  wire        clk,
    input  wire        rst,
    // from rt_control
    input  wire [7:0]  order_i,         // bits of CONTROL that are written
    input  wire [31:0] limit_i,         // register WATCHDOG
    input  wire [`RT_LINE_BITS-1:0] tree0_i,
    input  wire [`RT_LINE_BITS-1:0] tree1_i,
    input  wire        root_i,          // frames read the newest tree
    // to rt_control
    output wire [5:0]  errors_o,        // bits of ERRORS, from BUILD_MANY on, that are set now
    output wire        done_o,          // a build ended
    output wire        building_o,
    output wire        draining_o,
    output reg         valid_o,         // a tree is complete
    output reg         newest_o,        // the place of the newest one
    output reg  [31:0] clocks_o,        // of the last build
    // rt_run
    output wire        start_o,         // START
    output reg         held_o,          // a START waits for its tree
    input  wire        load_i,          // registers to the core
    input  wire        frame_i,         // a frame is drawn, or drained
    // the tree that the frame reads
    output reg         reads_o,         // there is one
    output reg  [`RT_LINE_BITS-1:0] reads_line_o,
    // rt_build, its masters
    output wire        accept_o,        // what is wanted, from now on
    output reg  [`RT_LINE_BITS-1:0] line_o, // of the tree's root
    output wire        go_o,
    input  wire        built_i,         // one clock
    input  wire [4:0]  errors_i,        // with it: order, bus, record, room, many
    output wire        cut_o,           // it is in reset, its masters end
    input  wire        idle_i,          // the buses owe nothing
    input  wire        stall_i          // they do, and do nothing
);
    localparam [2:0] IDLE = 3'd0, WAIT = 3'd1, GO = 3'd2, RUN = 3'd3, CUT = 3'd4;
    reg  [2:0]  state_q;
    reg         to_q, reads_place_q;    // places: of the tree that is built, that a frame reads
    reg  [`RT_LINE_BITS-1:0] newest_line_q;
    reg  [31:0] silent_q;               // clocks
    wire        anew   = order_i[`RT_TOP_CONTROL_SOFT_RESET];
    wire        asked  = order_i[`RT_TOP_CONTROL_BUILD] && !anew;
    wire        to     = valid_o && !newest_o;
    wire        taken  = reads_o && frame_i && reads_place_q == to_q;
    wire        late   = state_q == RUN && !built_i && limit_i != 32'd0 && silent_q >= limit_i;
    wire        good   = built_i && errors_i == 5'd0;
    assign accept_o    = asked && state_q == IDLE;
    assign go_o        = state_q == GO;
    assign cut_o       = state_q == CUT;
    assign building_o  = state_q != IDLE && state_q != CUT;
    assign draining_o  = state_q == CUT;
    assign done_o      = (built_i || late) && !anew;
    assign errors_o    = {asked && !accept_o, (built_i ? errors_i : 5'd0) | {1'b0, late, 3'd0}};

    // ---- START ----
    wire        stop   = anew || order_i[`RT_TOP_CONTROL_STOP];
    wire        fire   = held_o && state_q == IDLE && !frame_i && !stop;
    wire        alone  = !order_i[`RT_TOP_CONTROL_BUILD];
    assign start_o     = (order_i[`RT_TOP_CONTROL_START] && alone) || fire;

    always @(posedge clk) begin
        silent_q <= stall_i ? silent_q + {31'd0, !(&silent_q)} : 32'd0;
        if (state_q == RUN) clocks_o <= clocks_o + {31'd0, !(&clocks_o)};
        case (state_q)
            IDLE: if (asked) begin
                state_q <= WAIT;
                to_q    <= to;
                line_o  <= to ? tree1_i : tree0_i;
            end
            WAIT: if (!taken) state_q <= GO;
            GO: begin
                state_q  <= RUN;
                clocks_o <= 32'd0;
            end
            RUN: if (built_i) state_q <= IDLE;
                 else if (late) state_q <= CUT;
            default: if (idle_i) state_q <= IDLE;
        endcase
        if (good) begin
            valid_o       <= 1'b1;
            newest_o      <= to_q;
            newest_line_q <= line_o;
        end
        if (load_i) begin
            reads_o       <= root_i && valid_o;
            reads_place_q <= newest_o;
            reads_line_o  <= newest_line_q;
        end
        if (fire || stop || late || (built_i && !good)) held_o <= 1'b0;
        if (accept_o && order_i[`RT_TOP_CONTROL_START]) held_o <= 1'b1;
        if (anew) begin
            if (state_q == GO || state_q == RUN) state_q <= CUT;
            if (state_q == WAIT) state_q <= IDLE;
            valid_o <= 1'b0;
        end
        if (rst) begin
            state_q  <= IDLE;
            valid_o  <= 1'b0;
            newest_o <= 1'b0;
            held_o   <= 1'b0;
            reads_o  <= 1'b0;
            silent_q <= 32'd0;
            clocks_o <= 32'd0;
        end
    end
    wire unused = &{1'b0, order_i};      // those that others take
endmodule
`default_nettype wire
