// rt_frames.v - which of the three frames is drawn, complete, shown
// SPDX-License-Identifier: Apache-2.0
//   begin: draw a frame that is neither shown nor the newest complete one
//   end, good: what was drawn is the newest; one that was never shown is lost
//   take: the newest is shown, or again the one that is; none, if all were forgotten
// So nothing is drawn into a frame that is read, and drawing never waits; with wait_i it waits
// until the newest one was taken. show_*_o changes in the cycle after take_i alone.
// With LAYERS a frame has three layers, and take chooses among them too: mux_i says which is shown.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_frames #(
    parameter LAYERS = 0,              // 1: a frame is Rendering, L1 and L2, layer_i bytes apart
    parameter ADDR   = 32              // bits of an address, 32 to 40
) (
    input  wire        clk,
    input  wire        rst,
    input  wire [3*ADDR-1:0] bases_i,  // addresses of the frames 2, 1, 0
    input  wire        wait_i,         // register FRAME_MODE
    input  wire [31:0] layer_i,        // register LAYER_BYTES
    input  wire [1:0]  mux_i,          // register MUX
    // from rt_machine, to the core
    input  wire        cfg_valid_i,
    input  wire [6:0]  cfg_addr_i,
    input  wire [31:0] cfg_data_i,
    // from rt_run
    input  wire        clear_i,        // forget all frames
    input  wire        load_i,         // START: from now on these addresses
    input  wire        begin_i,        // a frame begins; room_o is high
    input  wire        end_i,          // it ends
    input  wire        good_i,         // with end_i: it is complete
    output wire        room_o,         // a frame may begin
    output reg  [ADDR-1:0] draw_base_o, // address of the frame that is drawn
    // to the display, or to a processor in its place
    input  wire        take_i,
    output reg         show_valid_o,   // a frame is shown
    output wire [ADDR-1:0] show_base_o,
    // events, numbers of the frames
    output wire        swap_o,         // another frame is shown
    output wire        again_o,        // the same once more
    output wire        lost_o,         // a complete frame was never shown
    output reg  [1:0]  drawn_o,
    output reg  [1:0]  newest_o,
    output reg  [1:0]  shown_o
);
    reg  fresh_q;                      // the newest was not shown yet
    reg  [ADDR-1:0] newest_base_q;     // where the newest was drawn
    reg  gone_q;                       // the one that is shown was forgotten
    wire [1:0] taken = {(show_valid_o && shown_o == 2'd1) || (fresh_q && newest_o == 2'd1),
                        (show_valid_o && shown_o == 2'd0) || (fresh_q && newest_o == 2'd0)};
    wire [1:0] free  = !taken[0] ? 2'd0 : !taken[1] ? 2'd1 : 2'd2;
    reg  [3*ADDR-1:0] bases_q;
    always @(posedge clk) if (load_i) bases_q <= bases_i;
    assign room_o  = !wait_i || !fresh_q;
    assign swap_o  = take_i && fresh_q;
    assign again_o = take_i && !fresh_q && show_valid_o && !gone_q;
    assign lost_o  = end_i && good_i && fresh_q && !take_i;
    always @(posedge clk) begin
        if (begin_i) begin
            drawn_o     <= free;
            draw_base_o <= bases_q[ADDR*free +: ADDR];
        end
        if (take_i) begin
            fresh_q      <= 1'b0;
            gone_q       <= 1'b0;
            show_valid_o <= fresh_q || (show_valid_o && !gone_q);
        end
        if (take_i && fresh_q) shown_o <= newest_o;
        if (end_i && good_i) begin
            fresh_q  <= 1'b1;
            newest_o <= drawn_o;
            newest_base_q <= draw_base_o;
        end
        if (rst || clear_i) begin
            fresh_q <= 1'b0;
            gone_q  <= !rst;
        end
        if (rst) begin
            {drawn_o, newest_o, shown_o} <= 6'd0;
            show_valid_o <= 1'b0;
        end
    end

    // ---- where what is shown begins ----
    reg [ADDR-1:0] shown_base_q;       // the frame; without LAYERS that is all
    always @(posedge clk) if (take_i && fresh_q) shown_base_q <= newest_base_q;
    generate
        if (LAYERS == 0) begin : g_frame
            assign show_base_o = shown_base_q;
            wire unused = &{1'b0, layer_i, mux_i, cfg_valid_i, cfg_addr_i, cfg_data_i};
        end else begin : g_layers
            // which layer register FRAME of the core chooses: of a frame that is drawn now, is the
            // newest, is shown
            reg  [1:0]  layer_q, newest_q, shown_q;
            reg  [ADDR-1:0] show_base_q;
            wire [1:0]  own   = fresh_q ? newest_q : shown_q;
            wire [1:0]  layer = mux_i == 2'd0 ? own : mux_i - 2'd1;
            wire [ADDR-1:0] apart = {{(ADDR-32){1'b0}}, layer_i};
            wire [ADDR-1:0] base  = fresh_q ? newest_base_q : shown_base_q;
            always @(posedge clk) begin
                if (cfg_valid_i && cfg_addr_i == `RT_REG_FRAME)
                    layer_q <= {cfg_data_i[1], cfg_data_i[1:0] == 2'd1};
                if (end_i && good_i) newest_q <= layer_q;
                if (take_i && fresh_q) shown_q <= newest_q;
                if (take_i) show_base_q <= base + (layer == 2'd0 ? {ADDR{1'b0}}
                    : layer == 2'd1 ? apart : {apart[ADDR-2:0], 1'b0});
            end
            assign show_base_o = show_base_q;
            wire unused = &{1'b0, cfg_data_i};
        end
    endgenerate
endmodule
`default_nettype wire
