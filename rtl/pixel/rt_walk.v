// rt_walk.v - walks the window in columns of 8 pixels and separates background pixels
// SPDX-License-Identifier: Apache-2.0
//   0,0 --down, right--> corner of the window --> column by column, each row by row, top to bottom
// dir = (DIR_X0 + x*PITCH, DIR_Y0 - y*PITCH, DIR_Z), exact, by forward differences.
// Background separation: Borodavka et al. V.C; a background pixel leaves by its own port.
// One pixel a cycle; WIN_X0 + WIN_Y0 + 3 cycles from start_i to the first.
// Model: sph_primary_dir() and sph_is_background() in cmodel/pixel/walk.h
`default_nettype none
module rt_walk #(
    parameter WD   = 17,  // direction component, bits
    parameter RECT = 1    // background separation by rectangle, 0 or 1
) (
    input  wire                 clk,
    input  wire                 rst,
    input  wire                 start_i,       // begin with the window
    output wire                 busy_o,        // pixels are left
    // registers
    input  wire [13:0]          win_x0_i,      // first column
    input  wire [13:0]          win_y0_i,      // first row
    input  wire [13:0]          win_x1_i,      // one past the last column
    input  wire [13:0]          win_y1_i,      // one past the last row
    input  wire                 rect_on_i,     // separate by the rectangle
    input  wire [13:0]          rect_x0_i,
    input  wire [13:0]          rect_y0_i,
    input  wire [13:0]          rect_x1_i,
    input  wire [13:0]          rect_y1_i,
    input  wire signed [WD-1:0] dir_x0_i,      // of column 0
    input  wire signed [WD-1:0] dir_y0_i,      // of row 0
    input  wire [WD-1:0]        pitch_i,       // direction units a pixel
    // to the engines: pixels that are traced
    output wire                 ray_valid_o,
    input  wire                 ray_ready_i,
    output wire signed [WD-1:0] ray_dir_x_o,
    output wire signed [WD-1:0] ray_dir_y_o,
    // to the pixel port: pixels that see the background
    output wire                 bg_valid_o,
    input  wire                 bg_ready_i,
    // both
    output wire [13:0]          x_o,
    output wire [13:0]          y_o
);
    localparam IDLE = 2'd0, DOWN = 2'd1, RIGHT = 2'd2, WALK = 2'd3;
    reg [1:0]  state_q;
    reg [13:0] x_q, y_q;
    reg [13:0] left_x_q;                       // first pixel of the column
    reg [2:0]  column_q;                       // pixels from it
    reg        top_q;                          // in the window's first row
    reg signed [WD-1:0] dx_q, dy_q, left_dx_q, top_dy_q;

    // ---- which way ----
    wire traced = RECT == 0 || !rect_on_i || (x_q >= rect_x0_i && x_q < rect_x1_i &&
                                              y_q >= rect_y0_i && y_q < rect_y1_i);
    wire walking = state_q == WALK;
    assign ray_valid_o = walking && traced;
    assign bg_valid_o  = walking && !traced;
    wire step = (ray_valid_o && ray_ready_i) || (bg_valid_o && bg_ready_i);

    // ---- order. One row alone is one column: rt_cone has no head for the next one then ----
    wire [13:0] x_next     = x_q + 14'd1;
    wire [13:0] y_next     = y_q + 14'd1;
    wire        right      = x_next == win_x1_i;
    wire        bottom     = y_next == win_y1_i;
    wire        row_end    = right || (&column_q && !(top_q && bottom));
    wire        column_end = row_end && bottom;
    wire        seek_down  = state_q == DOWN && y_q != win_y0_i;
    wire        seek_right = state_q == RIGHT && x_q != win_x0_i;
    wire        seek_end   = state_q == RIGHT && x_q == win_x0_i;
    wire        step_right = step && !row_end;
    wire        step_down  = step && row_end && !bottom;
    wire        new_column = step && column_end;
    wire signed [WD-1:0] pitch   = $signed(pitch_i);
    wire signed [WD-1:0] dx_next = dx_q + pitch;
    wire signed [WD-1:0] dy_next = dy_q - pitch;
    always @(posedge clk) begin
        if (seek_right || step_right || new_column) begin
            x_q  <= x_next;
            dx_q <= dx_next;
        end else if (step_down) begin
            x_q  <= left_x_q;
            dx_q <= left_dx_q;
        end
        if (seek_down || step_down) begin
            y_q  <= y_next;
            dy_q <= dy_next;
        end else if (new_column) begin
            y_q  <= win_y0_i;
            dy_q <= top_dy_q;
        end
        if (step_right) column_q <= column_q + 3'd1;
        if (step_down || new_column || seek_end) column_q <= 3'd0;
        if (step_down) top_q <= 1'b0;
        if (seek_end || new_column) begin
            top_q     <= 1'b1;
            left_x_q  <= seek_end ? x_q : x_next;
            left_dx_q <= seek_end ? dx_q : dx_next;
        end
        if (seek_end) top_dy_q <= dy_q;
        case (state_q)
            DOWN:  if (!seek_down)
                state_q <= win_x0_i < win_x1_i && win_y0_i < win_y1_i ? RIGHT : IDLE;
            RIGHT: if (seek_end) state_q <= WALK;
            WALK:  if (new_column && right) state_q <= IDLE;
            default: if (start_i) begin
                state_q <= DOWN;
                x_q     <= 14'd0;
                y_q     <= 14'd0;
                dx_q    <= dir_x0_i;
                dy_q    <= dir_y0_i;
            end
        endcase
        if (rst) state_q <= IDLE;
    end
    assign busy_o      = state_q != IDLE;
    assign x_o         = x_q;
    assign y_o         = y_q;
    assign ray_dir_x_o = dx_q;
    assign ray_dir_y_o = dy_q;
    wire unused = &{1'b0, rect_on_i, rect_x0_i, rect_y0_i, rect_x1_i, rect_y1_i};
endmodule
`default_nettype wire
