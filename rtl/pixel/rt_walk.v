// rt_walk.v - walks the window in 8x4 tiles and separates background pixels
// SPDX-License-Identifier: Apache-2.0
// dir = (DIR_X0 + x*PITCH, DIR_Y0 - y*PITCH, DIR_Z), exact, by forward differences.
// Background separation: Borodavka et al. V.C; a background pixel leaves by its own port.
// One pixel a cycle; 15 cycles from start_i to the first.
// Model: sph_primary_dir() and sph_is_background() in cmodel/pixel/walk.h
`default_nettype none
module rt_walk #(
    parameter WD = 17  // direction component, bits
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
    localparam IDLE = 2'd0, SETUP = 2'd1, WALK = 2'd2;
    reg [1:0]  state_q;
    reg [3:0]  bit_q;                          // multiplier bit of set-up
    reg [13:0] x_q, y_q, tile_x_q, tile_y_q;
    reg signed [WD-1:0] dx_q, dy_q, tile_dx_q, tile_dy_q;

    // ---- set-up: WIN * PITCH, one bit a cycle ----
    reg [WD-1:0] add_q;                        // PITCH << bit
    wire signed [WD-1:0] add_x = win_x0_i[bit_q] ? $signed(add_q) : {WD{1'b0}};
    wire signed [WD-1:0] add_y = win_y0_i[bit_q] ? $signed(add_q) : {WD{1'b0}};

    // ---- walk ----
    wire in_rect = x_q >= rect_x0_i && x_q < rect_x1_i && y_q >= rect_y0_i && y_q < rect_y1_i;
    wire traced  = !rect_on_i || in_rect;
    wire walking = state_q == WALK;
    assign ray_valid_o = walking && traced;
    assign bg_valid_o  = walking && !traced;
    wire step = (ray_valid_o && ray_ready_i) || (bg_valid_o && bg_ready_i);
    wire row_end   = x_q + 14'd1 == win_x1_i || x_q - tile_x_q == 14'd7;
    wire tile_end  = row_end && (y_q + 14'd1 == win_y1_i || y_q - tile_y_q == 14'd3);
    wire strip_end = tile_end && x_q + 14'd1 == win_x1_i;
    wire last      = strip_end && y_q + 14'd1 == win_y1_i;
    wire signed [WD-1:0] pitch = $signed(pitch_i);
    reg signed [WD-1:0] left_dx_q;             // of column WIN_X0

    always @(posedge clk) begin
        case (state_q)
            SETUP: begin
                bit_q <= bit_q + 4'd1;
                add_q <= add_q << 1;
                dx_q  <= dx_q + add_x;
                dy_q  <= dy_q - add_y;
                tile_dx_q <= dx_q + add_x;
                left_dx_q <= dx_q + add_x;
                tile_dy_q <= dy_q - add_y;
                if (bit_q == 4'd13)
                    state_q <= win_x0_i < win_x1_i && win_y0_i < win_y1_i ? WALK : IDLE;
            end
            WALK: if (step) begin
                if (last) state_q <= IDLE;
                if (!row_end) begin
                    x_q  <= x_q + 14'd1;
                    dx_q <= dx_q + pitch;
                end else if (!tile_end) begin
                    x_q  <= tile_x_q;
                    dx_q <= tile_dx_q;
                    y_q  <= y_q + 14'd1;
                    dy_q <= dy_q - pitch;
                end else if (!strip_end) begin
                    x_q       <= x_q + 14'd1;
                    tile_x_q  <= x_q + 14'd1;
                    dx_q      <= dx_q + pitch;
                    tile_dx_q <= dx_q + pitch;
                    y_q       <= tile_y_q;
                    dy_q      <= tile_dy_q;
                end else begin
                    x_q       <= win_x0_i;
                    tile_x_q  <= win_x0_i;
                    dx_q      <= left_dx_q;
                    tile_dx_q <= left_dx_q;
                    y_q       <= y_q + 14'd1;
                    tile_y_q  <= y_q + 14'd1;
                    dy_q      <= dy_q - pitch;
                    tile_dy_q <= dy_q - pitch;
                end
            end
            default: if (start_i) begin
                state_q  <= SETUP;
                bit_q    <= 4'd0;
                add_q    <= pitch_i;
                dx_q     <= dir_x0_i;
                dy_q     <= dir_y0_i;
                x_q      <= win_x0_i;
                y_q      <= win_y0_i;
                tile_x_q <= win_x0_i;
                tile_y_q <= win_y0_i;
            end
        endcase
        if (rst) state_q <= IDLE;
    end
    assign busy_o      = state_q != IDLE;
    assign x_o         = x_q;
    assign y_o         = y_q;
    assign ray_dir_x_o = dx_q;
    assign ray_dir_y_o = dy_q;
endmodule
`default_nettype wire
