// rt_video_timing.v - syncs and blanking of a mode
// SPDX-License-Identifier: Apache-2.0
//   a row:   sync, back, active, front      begins where hsync rises, as vsync does
//   a frame: front, sync, back, active      begins where vertical blanking does
// Each part is counted down from its length to 1. Outputs are of the pixel that stands now; the
// next one comes with a clock in which advance_i is high. While run_i is low nothing is shown and
// syncs rest; a frame begins as soon as it is high.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_modes.vh"
module rt_video_timing (
    input  wire clk,
    input  wire rst,                      // synchronous, active high
    input  wire run_i,                    // the display is on
    input  wire advance_i,                // the clock counts
    input  wire [`RT_MODE_BITS-1:0] mode_i, // stable while the display is on
    output reg  run_o,                    // a frame is on its way
    output wire start_o,                  // with the next edge a frame begins
    output reg  frame_o,                  // changes where a frame begins
    output wire blank_o,                  // vertical blanking
    output wire de_o,                     // a pixel of the picture
    output reg  first_o,                  // no pixel of this frame came yet
    output wire last_o,                   // the last pixel of its row
    output wire hsync_o,                  // with its polarity
    output wire vsync_o
);
    localparam [1:0] H_SYNC  = 2'd0, H_BACK = 2'd1, H_ACTIVE = 2'd2, H_FRONT  = 2'd3;
    localparam [1:0] V_FRONT = 2'd0, V_SYNC = 2'd1, V_BACK   = 2'd2, V_ACTIVE = 2'd3;
    reg [1:0]  h_part_q, v_part_q;        // where it stands
    reg [12:0] h_left_q, v_left_q;        // pixels, rows of this part, with this one

    // ---- lengths of the next parts ----
    reg [12:0] h_next, v_next;
    always @* begin
        case (h_part_q)
            H_SYNC:  h_next = mode_i[`RT_MODE_H_BACK];
            H_BACK:  h_next = mode_i[`RT_MODE_H_ACTIVE];
            H_ACTIVE:h_next = mode_i[`RT_MODE_H_FRONT];
            default: h_next = mode_i[`RT_MODE_H_SYNC];
        endcase
        case (v_part_q)
            V_FRONT: v_next = mode_i[`RT_MODE_V_SYNC];
            V_SYNC:  v_next = mode_i[`RT_MODE_V_BACK];
            V_BACK:  v_next = mode_i[`RT_MODE_V_ACTIVE];
            default: v_next = mode_i[`RT_MODE_V_FRONT];
        endcase
    end

    // ---- counters ----
    wire h_end   = h_left_q == 13'd1;
    wire v_end   = v_left_q == 13'd1 && h_part_q == H_FRONT && h_end;   // of its last row
    wire begins  = run_i && !run_o;
    wire step    = run_i && run_o && advance_i;
    assign start_o = begins || (step && v_end && v_part_q == V_ACTIVE);
    always @(posedge clk) begin
        run_o <= run_i;
        if (step) begin
            h_left_q <= h_end ? h_next : h_left_q - 13'd1;
            if (h_end) h_part_q <= h_part_q + 2'd1;
            if (h_end && h_part_q == H_FRONT)
                v_left_q <= v_end ? v_next : v_left_q - 13'd1;
            if (v_end) v_part_q <= v_part_q + 2'd1;
            if (de_o) first_o <= 1'b0;
        end
        if (begins) begin
            h_part_q <= H_SYNC;
            h_left_q <= mode_i[`RT_MODE_H_SYNC];
            v_part_q <= V_FRONT;
            v_left_q <= mode_i[`RT_MODE_V_FRONT];
        end
        if (start_o) begin
            first_o <= 1'b1;
            frame_o <= !frame_o;
        end
        if (rst) begin
            run_o   <= 1'b0;
            frame_o <= 1'b0;
        end
    end

    // ---- outputs ----
    assign blank_o = !run_o || v_part_q != V_ACTIVE;
    assign de_o    = run_o && v_part_q == V_ACTIVE && h_part_q == H_ACTIVE;
    assign last_o  = h_end;
    assign hsync_o = (run_o && h_part_q == H_SYNC) == mode_i[`RT_MODE_H_POL];
    assign vsync_o = (run_o && v_part_q == V_SYNC) == mode_i[`RT_MODE_V_POL];
endmodule
`default_nettype wire
