// rt_table.v - asks for the lines of a table, in order, once or over and over
// SPDX-License-Identifier: Apache-2.0
//   start --> first, first+1 .. first+lines-1, and again, passes times
// One line a cycle at most. Answers go straight to who uses them: rt_spans or the cones.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_table (
    input  wire        clk,
    input  wire        rst,
    input  wire        start_i,      // ask for all of it; only when nothing is left to ask for
    input  wire [`RT_LINE_BITS-1:0] first_i,      // first line
    input  wire [11:0] lines_i,      // of the table
    input  wire [11:0] passes_i,     // times that it is read
    input  wire        room_i,       // there is a place for one more line; falls only with asked_o
    output wire        asked_o,      // one is asked for in this cycle
    // to memory
    output wire        req_valid_o,
    input  wire        req_ready_i,
    output reg  [`RT_LINE_BITS-1:0] req_line_o
);
    reg  [11:0] line_q, pass_q;      // lines left in this pass and passes left, this one included
    wire        last = line_q == 12'd1;
    assign req_valid_o = pass_q != 12'd0 && room_i;
    assign asked_o     = req_valid_o && req_ready_i;
    always @(posedge clk) begin
        if (start_i || asked_o) begin
            line_q     <= start_i || last ? lines_i : line_q - 12'd1;
            req_line_o <= start_i || last ? first_i : req_line_o + 1'b1;
        end
        if (start_i)              pass_q <= lines_i == 12'd0 ? 12'd0 : passes_i;
        else if (asked_o && last) pass_q <= pass_q - 12'd1;
        if (rst) pass_q <= 12'd0;
    end
endmodule
`default_nettype wire
