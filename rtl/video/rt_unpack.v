// rt_unpack.v - pixels of the display out of words of the queue; black where there is none
// SPDX-License-Identifier: Apache-2.0
//   word {first, frame, data}: of another frame: dropped; first: header; else DATA/32 or /16 pixels
// A row begins with a new word. A pixel that is needed and not there is an underrun: from it on the
// frame is black and its words wait; all words go when the next frame begins. So a frame is shown
// from one frame of the store, row by row and pixel by pixel, or is black from some pixel on.
`timescale 1ns / 1ps
`default_nettype none
module rt_unpack #(
    parameter DATA = 64                   // bits of a word, 64 or 128
) (
    input  wire            clk,
    input  wire            rst,           // synchronous, active high
    input  wire            advance_i,     // the clock counts
    // from rt_video_timing
    input  wire            run_i,
    input  wire            start_i,       // with the next edge a frame begins
    input  wire            frame_i,
    input  wire            de_i,          // a pixel is needed
    input  wire            last_i,        // the last of its row
    // from the queue
    input  wire            word_valid_i,
    output wire            word_ready_o,
    input  wire [DATA+1:0] word_data_i,
    // to the display
    output wire [23:0]     rgb_o,         // red in the high bits
    output reg             underrun_o     // changes with the first pixel that is missing
);
    localparam IB = $clog2(DATA / 16);    // bits of the number of a pixel of 16 bits

    // ---- the word ----
    wire first = word_data_i[DATA+1];
    wire mine  = run_i && word_valid_i && word_data_i[DATA] == frame_i;
    reg  head_q;                          // the header was read
    reg  shown_q;                         // it says: there is a frame
    reg  rgb565_q;                        // RGB565, else XRGB8888
    reg  double_q;                        // a pixel counts twice
    reg  lost_q;                          // a pixel was missing
    wire need  = de_i && advance_i;
    wire there = mine && !first && head_q && shown_q && !lost_q;
    wire lacks = need && !lost_q && (head_q ? shown_q && !there : 1'b1);

    // ---- the pixel of it ----
    reg  [IB-1:0] at_q;                   // number of the pixel in its word
    reg           again_q;                // double_q: it was shown once
    wire          step   = !double_q || again_q;
    wire          at_end = rgb565_q ? &at_q : &at_q[IB-2:0];
    wire          done   = need && there && (last_i || (step && at_end));
    wire [31:0]   wide   = word_data_i[{1'b0, at_q[IB-2:0], 5'd0} +: 32];
    wire [15:0]   narrow = word_data_i[{1'b0, at_q, 4'd0} +: 16];
    wire [4:0]    red    = narrow[15:11];
    wire [5:0]    green  = narrow[10:5];
    wire [4:0]    blue   = narrow[4:0];
    wire [23:0]   spread = {red, red[4:2], green, green[5:4], blue, blue[4:2]};
    assign rgb_o         = !there ? 24'd0 : rgb565_q ? spread : wide[23:0];
    // of another frame; a header; a word before any header; a word whose pixels are used
    assign word_ready_o  = !mine || !head_q || done;

    always @(posedge clk) begin
        if (mine && first && !head_q) begin
            head_q <= 1'b1;
            {double_q, rgb565_q, shown_q} <= word_data_i[2:0];
        end
        if (need && there) begin
            again_q <= double_q && !again_q && !last_i;
            if (step)   at_q <= at_q + 1'b1;
            if (done)   at_q <= {IB{1'b0}};
        end
        if (lacks) begin
            lost_q     <= 1'b1;
            underrun_o <= !underrun_o;
        end
        if (start_i) begin
            head_q  <= 1'b0;
            lost_q  <= 1'b0;
            at_q    <= {IB{1'b0}};
            again_q <= 1'b0;
        end
        if (rst) underrun_o <= 1'b0;
    end
    wire unused = &{1'b0, wide[31:24]};
endmodule
`default_nettype wire
