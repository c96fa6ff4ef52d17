// rt_frames.v - which of the three frames is drawn, complete, shown
// SPDX-License-Identifier: Apache-2.0
//   begin: draw a frame that is neither shown nor the newest complete one
//   end, good: what was drawn is the newest; one that was never shown is lost
//   take: the newest is shown, or again the one that is; none, if all were forgotten
// So nothing is drawn into a frame that is read, and drawing never waits; with wait_i it waits
// until the newest one was taken. show_*_o changes in the cycle after take_i alone.
`timescale 1ns / 1ps
`default_nettype none
module rt_frames (
    input  wire        clk,
    input  wire        rst,
    input  wire [95:0] bases_i,        // addresses of the frames 2, 1, 0
    input  wire        wait_i,         // register FRAME_MODE
    // from rt_run
    input  wire        clear_i,        // forget all frames
    input  wire        load_i,         // START: from now on these addresses
    input  wire        begin_i,        // a frame begins; room_o is high
    input  wire        end_i,          // it ends
    input  wire        good_i,         // with end_i: it is complete
    output wire        room_o,         // a frame may begin
    output reg  [31:0] draw_base_o,    // address of the frame that is drawn
    // to the display, or to a processor in its place
    input  wire        take_i,
    output reg         show_valid_o,   // a frame is shown
    output reg  [31:0] show_base_o,
    // events, numbers of the frames
    output wire        swap_o,         // another frame is shown
    output wire        again_o,        // the same once more
    output wire        lost_o,         // a complete frame was never shown
    output reg  [1:0]  drawn_o,
    output reg  [1:0]  newest_o,
    output reg  [1:0]  shown_o
);
    reg  fresh_q;                      // the newest was not shown yet
    reg  [31:0] newest_base_q;         // where the newest was drawn
    reg  gone_q;                       // the one that is shown was forgotten
    wire [1:0] taken = {(show_valid_o && shown_o == 2'd1) || (fresh_q && newest_o == 2'd1),
                        (show_valid_o && shown_o == 2'd0) || (fresh_q && newest_o == 2'd0)};
    wire [1:0] free  = !taken[0] ? 2'd0 : !taken[1] ? 2'd1 : 2'd2;
    reg  [95:0] bases_q;
    always @(posedge clk) if (load_i) bases_q <= bases_i;
    assign room_o  = !wait_i || !fresh_q;
    assign swap_o  = take_i && fresh_q;
    assign again_o = take_i && !fresh_q && show_valid_o && !gone_q;
    assign lost_o  = end_i && good_i && fresh_q && !take_i;
    always @(posedge clk) begin
        if (begin_i) begin
            drawn_o     <= free;
            draw_base_o <= bases_q[32*free +: 32];
        end
        if (take_i) begin
            fresh_q      <= 1'b0;
            gone_q       <= 1'b0;
            show_valid_o <= fresh_q || (show_valid_o && !gone_q);
        end
        if (take_i && fresh_q) begin
            shown_o     <= newest_o;
            show_base_o <= newest_base_q;
        end
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
endmodule
`default_nettype wire
