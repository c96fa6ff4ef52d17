// rt_spans.v - the span of each row of the window, over and over, from lines of eight
// SPDX-License-Identifier: Apache-2.0
//   line (rows 8n .. 8n+7) --> rows of the window, one a cycle --> 32 spans --> row of the walk
// A line is asked for only if the queue has a place for it, so it is taken at once: 8 cycles at
// most. First span: 1 cycle after its line. Rows go from WIN_Y0 to WIN_Y1-1 and begin again.
// Model: sph_is_background() in cmodel/pixel/background.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_spans (
    input  wire         clk,
    input  wire         rst,
    input  wire         start_i,       // begin with row win_y0_i; only when all is taken
    input  wire [13:0]  win_y0_i,      // first row
    input  wire [13:0]  win_y1_i,      // one past the last row
    // from memory
    output wire         room_o,        // one more line may be asked for
    input  wire         asked_i,       // it is
    input  wire         rsp_valid_i,
    output wire         rsp_ready_o,
    input  wire [255:0] rsp_data_i,
    // to the walk
    output wire         span_valid_o,
    input  wire         span_next_i,   // done with this row
    output wire [15:0]  span_x0_o,     // first pixel traced
    output wire [15:0]  span_x1_o      // one past the last
);
    localparam LINES = 4;              // in the queue or on their way
    localparam SB    = `RT_SPAN_STRIDE;

    // ---- rows of a line, from the first to the last that lies in the window ----
    reg  [13:0] row_q, end_q;          // end_q: the window's last row
    reg         bottom_q, line_end;    // row_q is that, or the last of a line, too
    wire        again = start_i || (rsp_valid_i && bottom_q);
    wire [13:0] row_next = again ? win_y0_i : row_q + 14'd1;
    wire [13:0] end_i    = win_y1_i - 14'd1;   // of start_i: end_q is of the clock before
    wire        bottom   = start_i ? win_y0_i == end_i : row_next == end_q;
    assign rsp_ready_o = line_end;
    always @(posedge clk) begin
        end_q <= end_i;
        if (again || rsp_valid_i) begin
            row_q    <= row_next;
            bottom_q <= bottom;
            line_end <= bottom || &row_next[2:0];
        end
    end

    // ---- queue; the last row of a line gives its place back ----
    wire in_ready, span_end;
    rt_fifo #(.WIDTH(SB + 1), .DEPTH(8*LINES)) u_queue (
        .clk(clk), .rst(rst),
        .in_valid_i(rsp_valid_i), .in_ready_o(in_ready),
        .in_data_i({line_end, rsp_data_i[SB*row_q[2:0] +: SB]}),
        .out_valid_o(span_valid_o), .out_ready_i(span_next_i),
        .out_data_o({span_end, span_x1_o, span_x0_o})
    );
    reg  [2:0] lines_q;
    wire       given = span_valid_o && span_next_i && span_end;
    assign room_o    = lines_q != LINES[2:0];
    always @(posedge clk) begin
        lines_q <= lines_q + {2'd0, asked_i} - {2'd0, given};
        if (rst) lines_q <= 3'd0;
    end
    wire unused = &{1'b0, in_ready};
endmodule
`default_nettype wire
