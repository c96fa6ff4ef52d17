// rt_pixel_scan.v - walks the window in columns of 8 pixels and separates background pixels
// SPDX-License-Identifier: Apache-2.0
//   0,0 --down, right--> corner of the window --> column by column, each row by row, top to bottom
// dir = (DIR_X0 + x*PITCH, DIR_Y0 - y*PITCH, DIR_Z), exact, by forward differences; with TURNED the
// top WD of the 32 bits of each component of DIR + x*ACROSS + y*DOWN.
// Background separation: Borodavka et al. V.C; a background pixel leaves by its own port.
// Ends of rows and of the column are told a pixel ahead; what leaves does so from a register.
// One pixel a cycle, with CONES less 3 cycles a column; WIN_X0 + WIN_Y0 + 4 cycles from start_i to
// the first, and more with CONES or SPANS.
// Model: sph_primary_dir() in cmodel/pixel/background.h, sph_is_background() in
// cmodel/pixel/background.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_pixel_scan #(
    parameter W     = 16,  // coordinate, bits
    parameter WD    = 17,  // direction component, bits
    parameter RECT  = 1,   // background separation by rectangle, 0 or 1
    parameter SPANS = 1,   // by spans in memory, 0 or 1
    parameter CONES = 1,   // exactly, by up to so many spheres, 0..16
    parameter TURNED = 0   // 0 or 1: a grid in any axes
) (
    input  wire                 clk,
    input  wire                 rst,
    input  wire                 start_i,       // begin with the window
    output wire                 busy_o,        // pixels are left
    // registers
    input  wire [55:0]          window_i,      // {y1, x1, y0, x0}; ends are one past the last
    input  wire signed [WD-1:0] dir_x0_i,      // of column 0
    input  wire signed [WD-1:0] dir_y0_i,      // of row 0
    input  wire signed [WD-1:0] dir_z_i,
    input  wire [WD-1:0]        pitch_i,       // direction units a pixel
    input  wire [95:0]          first_i,       // TURNED: of pixel 0, 0; three of sWD.(32-WD)
    input  wire [95:0]          across_i,      // TURNED: to the next column
    input  wire [95:0]          down_i,        // TURNED: to the next row
    input  wire [1:0]           bg_mode_i,     // 0 all is traced, 1 rectangle, 2 spans, 3 cones
    input  wire [55:0]          rect_i,        // as the window
    input  wire [`RT_LINE_BITS-1:0] bg_base_i,     // first line of the spans or cones
    input  wire [4:0]           bg_count_i,    // cones
    input  wire [`RT_LINE_BITS-1:0] mem_lines_i,   // lines of memory
    // to the engines: pixels that are traced
    output wire                 ray_valid_o,
    input  wire                 ray_ready_i,
    output wire signed [WD-1:0] ray_dir_x_o,
    output wire signed [WD-1:0] ray_dir_y_o,
    output wire signed [WD-1:0] ray_dir_z_o,
    // to the pixel port: pixels that see the background
    output wire                 bg_valid_o,
    input  wire                 bg_ready_i,
    // both
    output wire [13:0]          x_o,
    output wire [13:0]          y_o,
    // memory: tables of the background
    output wire                 mem_req_valid_o,
    input  wire                 mem_req_ready_i,
    output wire [`RT_LINE_BITS-1:0] mem_req_line_o,
    input  wire                 mem_rsp_valid_i,
    output wire                 mem_rsp_ready_o,
    input  wire [255:0]         mem_rsp_data_i,
    input  wire                 mem_rsp_error_i,
    // errors
    output wire                 bad_table_o,   // the table does not lie in memory
    output wire                 bus_error_o
);
    localparam TABLES = SPANS != 0 || CONES != 0;
    localparam IDLE   = 3'd0, LOAD = 3'd1;         // LOAD: the cones come
    localparam DOWN   = 3'd2, RIGHT = 3'd3;        // to the corner of the window
    localparam COLUMN = 3'd4, HEAD = 3'd5;         // the cones go to the head of a column
    localparam WALK   = 3'd6, TURN = 3'd7;         // TURN: they stand at the next column's head
    reg [2:0]  state_q;
    wire [13:0] x0 = window_i[13:0],  y0 = window_i[27:14];
    wire [13:0] x1 = window_i[41:28], y1 = window_i[55:42];
    reg [13:0] x_q, y_q;
    reg [13:0] left_x_q;                           // first pixel of the column
    reg [2:0]  column_q;                           // pixels from it
    reg        top_q;                              // in the window's first row
    localparam DW = TURNED != 0 ? 96 : WD;
    reg [DW-1:0] dx_q, dy_q, left_dx_q, top_dy_q;  // TURNED: a direction is dx_q + dy_q

    // ---- order ----
    wire        step;                              // the pixel leaves
    wire [13:0] x_next     = x_q + 14'd1;
    wire [13:0] y_next     = y_q + 14'd1;
    reg         end_x_q, end_y_q;                  // the last pixel to the right, downwards
    reg         left_end_q, top_end_q;             // the same of the column's left, top pixel
    reg         row_end_q;                         // of the column or of the window
    wire        next_end_x = x_q == x1 - 14'd2;    // the pixel to the right is the last one
    wire        next_end_y = y_q == y1 - 14'd2;
    wire        turn       = CONES != 0 && top_q;  // the row's end takes a cycle more
    wire        seek_down  = state_q == DOWN && y_q != y0;
    wire        seek_right = state_q == RIGHT && x_q != x0;
    wire        seek_end   = state_q == RIGHT && x_q == x0;
    // Where to is known before it is known whether: `step` enables, and chooses nothing.
    wire        row        = state_q == TURN || row_end_q;
    wire        move       = state_q == TURN || (step && !(row_end_q && turn));
    wire        step_right = move && !row;
    wire        step_row   = move && row;
    wire        step_down  = step_row && !end_y_q;
    wire        new_column = step_row && end_y_q;
    wire [DW-1:0] dx_first, dy_first, dx_next, dy_next;
    wire [3*WD-1:0] dir;                           // {z, y, x}
    wire        loaded;
    always @(posedge clk) begin
        if (seek_right || move) begin
            x_q     <= state_q == RIGHT || !row || end_y_q ? x_next : left_x_q;
            dx_q    <= state_q == RIGHT || !row || end_y_q ? dx_next : left_dx_q;
            end_x_q <= state_q == RIGHT || !row || end_y_q ? next_end_x : left_end_q;
        end
        if (seek_down || step_row) begin
            y_q     <= state_q == DOWN || !end_y_q ? y_next : y0;
            dy_q    <= state_q == DOWN || !end_y_q ? dy_next : top_dy_q;
            end_y_q <= state_q == DOWN || !end_y_q ? next_end_y : top_end_q;
        end
        if (step_right) begin
            column_q  <= column_q + 3'd1;
            row_end_q <= next_end_x || column_q == 3'd6;
        end
        if (step_row || seek_end) begin
            column_q  <= 3'd0;
            row_end_q <= seek_end ? end_x_q : end_y_q ? next_end_x : left_end_q;
        end
        if (step_down) top_q <= 1'b0;
        if (seek_end || new_column) begin
            top_q     <= 1'b1;
            left_x_q  <= seek_end ? x_q : x_next;
            left_dx_q <= seek_end ? dx_q : dx_next;
            left_end_q <= seek_end ? end_x_q : next_end_x;
        end
        if (seek_end) begin
            top_dy_q  <= dy_q;
            top_end_q <= end_y_q;
        end
        case (state_q)
            LOAD:    if (loaded) state_q <= DOWN;
            DOWN:    if (!seek_down) state_q <= x0 < x1 && y0 < y1 ? RIGHT : IDLE;
            RIGHT:   if (seek_end) state_q <= CONES != 0 ? COLUMN : WALK;
            COLUMN:  state_q <= HEAD;
            HEAD:    state_q <= WALK;
            WALK:    if (step && row_end_q && turn) state_q <= TURN;
                     else if (new_column) state_q <= end_x_q ? IDLE : CONES != 0 ? COLUMN : WALK;
            TURN:    state_q <= !end_y_q ? WALK : end_x_q ? IDLE : COLUMN;
            default: if (start_i) begin
                state_q <= CONES != 0 ? LOAD : DOWN;
                x_q     <= 14'd0;
                y_q     <= 14'd0;
                dx_q    <= dx_first;
                dy_q    <= dy_first;
                end_x_q <= x1 == 14'd1;
                end_y_q <= y1 == 14'd1;
            end
        endcase
        if (rst) state_q <= IDLE;
    end

    // ---- directions ----
    genvar i;
    generate
        if (TURNED != 0) begin : g_turned
            assign dx_first = first_i;
            assign dy_first = 96'd0;
            for (i = 0; i < 3; i = i + 1) begin : g_axis
                wire [31:0] sum = dx_q[32*i +: 32] + dy_q[32*i +: 32];
                assign dx_next[32*i +: 32] = dx_q[32*i +: 32] + across_i[32*i +: 32];
                assign dy_next[32*i +: 32] = dy_q[32*i +: 32] + down_i[32*i +: 32];
                assign dir[WD*i +: WD]     = sum[31 -: WD];
                wire unused = &{1'b0, sum[31-WD:0]};
            end
            wire unused = &{1'b0, dir_x0_i, dir_y0_i, dir_z_i, pitch_i};
        end else begin : g_camera
            assign dx_first = dir_x0_i;
            assign dy_first = dir_y0_i;
            assign dx_next  = dx_q + pitch_i;
            assign dy_next  = dy_q - pitch_i;
            assign dir      = {dir_z_i, dy_q, dx_q};
            wire unused = &{1'b0, first_i, across_i, down_i};
        end
    endgenerate

    // ---- which way: by rectangle, or by a table ----
    wire outside  = x_q < rect_i[13:0] || x_q >= rect_i[41:28] ||
                    y_q < rect_i[27:14] || y_q >= rect_i[55:42];
    wire in_rect  = RECT == 0 || bg_mode_i != 2'd1 || !outside;
    wire in_table;                                 // with decided: as the table says
    wire decided;
    generate
        if (TABLES) begin : g_tables
            rt_background #(.W(W), .WD(WD), .SPANS(SPANS), .CONES(CONES)) u_background (
                .clk(clk), .rst(rst), .start_i(start_i && state_q == IDLE),
                .window_i(window_i), .mode_i(bg_mode_i), .base_i(bg_base_i),
                .count_i(bg_count_i), .mem_lines_i(mem_lines_i),
                .x_i(x_q), .row_next_i(step && row_end_q),
                .fetch_i((state_q == LOAD && loaded) || state_q == COLUMN),
                .enter_i(state_q == DOWN || state_q == HEAD || step_down),
                .right_i(seek_right || step_right || (step && turn)),
                .save_i(seek_end || state_q == TURN),
                .ready_o(loaded), .valid_o(decided), .traced_o(in_table),
                .req_valid_o(mem_req_valid_o), .req_ready_i(mem_req_ready_i),
                .req_line_o(mem_req_line_o),
                .rsp_valid_i(mem_rsp_valid_i), .rsp_ready_o(mem_rsp_ready_o),
                .rsp_data_i(mem_rsp_data_i), .rsp_error_i(mem_rsp_error_i),
                .bad_table_o(bad_table_o), .bus_error_o(bus_error_o)
            );
        end else begin : g_no_tables
            assign {loaded, decided, in_table} = 3'b111;
            assign {mem_req_valid_o, mem_rsp_ready_o, bad_table_o, bus_error_o} = 4'd0;
            assign mem_req_line_o = {`RT_LINE_BITS{1'b0}};
            wire unused = &{1'b0, bg_base_i, bg_count_i, mem_lines_i, mem_req_ready_i,
                            mem_rsp_valid_i, mem_rsp_data_i, mem_rsp_error_i};
        end
    endgenerate
    wire offered = state_q == WALK && decided;
    wire traced  = in_rect && in_table;

    // ---- output; a register parts the choice of way from what follows ----
    localparam KEPT = TURNED != 0 ? 3*WD : 2*WD;   // dir_z_i stays
    reg        valid_q, traced_q;
    reg [13:0] out_x_q, out_y_q;
    reg [KEPT-1:0] out_dir_q;
    wire free   = !valid_q || (traced_q ? ray_ready_i : bg_ready_i);
    assign step = offered && free;
    always @(posedge clk) begin
        if (free) begin
            valid_q  <= offered;
            traced_q <= traced;
            out_x_q  <= x_q;
            out_y_q  <= y_q;
            out_dir_q <= dir[KEPT-1:0];
        end
        if (rst) valid_q <= 1'b0;
    end
    assign busy_o      = state_q != IDLE || valid_q;
    assign ray_valid_o = valid_q && traced_q;
    assign bg_valid_o  = valid_q && !traced_q;
    assign {x_o, y_o} = {out_x_q, out_y_q};
    assign {ray_dir_y_o, ray_dir_x_o} = out_dir_q[2*WD-1:0];
    assign ray_dir_z_o = TURNED != 0 ? out_dir_q[KEPT-1 -: WD] : dir[3*WD-1 -: WD];
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_pixel_walk /* verilator public_flat_rd */ =
        {1'b0, step, 5'd0, state_q != IDLE && !(offered && !free)};
    wire unused = &{1'b0, rect_i, bg_mode_i};
endmodule
`default_nettype wire
