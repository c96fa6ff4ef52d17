// rt_run.v - a frame from START to its end, STOP and resets, bus errors, watchdogs
// SPDX-License-Identifier: Apache-2.0
//   IDLE -> LOAD registers -> WAIT for a frame -> START -> DRAW -> FLUSH pixels -> END -> IDLE
//   any -- STOP, SOFT_RESET --> DRAIN until the buses owe nothing -> IDLE
// A bus that owes an answer and does nothing for limit_i cycles is given up (dead): if it is that
// of reads, the core is reset; pixels for that of writes are thrown away. So the frame ends, and a
// soft reset drains the bus before the next one. A frame with any error is not complete. A display
// whose bus is silent shows black and goes on by itself: the error is told once for each silence.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_top.vh"
module rt_run (
    input  wire        clk,
    input  wire        rst,
    // from rt_control
    input  wire [7:0]  order_i,         // bits of CONTROL that are written
    input  wire [31:0] limit_i,         // register WATCHDOG
    output wire [15:0] errors_o,        // bits of ERRORS that are set now
    output wire        done_o,          // a frame ended
    output wire        busy_o,
    output wire        draining_o,
    output wire        waiting_o,       // for a frame to be shown
    // to rt_machine and the core
    output wire        load_o,          // registers into the core
    input  wire        loading_i,
    output wire        core_rst_o,
    output wire        core_start_o,
    output wire        core_keep_o,
    input  wire        core_busy_i,
    input  wire [`RT_ERRORS-1:0] core_errors_i,
    // to rt_frames
    input  wire        room_i,
    output wire        clear_o,
    output wire        begin_o,
    output wire        end_o,
    output wire        good_o,
    // to both masters
    output wire        forget_o,
    // rt_axi_read
    input  wire        read_idle_i,
    input  wire        read_stall_i,
    input  wire [1:0]  read_errors_i,   // {DECERR, SLVERR}
    // rt_frame_write
    output wire        cut_o,
    output wire        write_dead_o,
    output wire        flush_o,
    input  wire        write_empty_i,
    input  wire        write_idle_i,
    input  wire        write_stall_i,
    input  wire [1:0]  write_errors_i,
    // rt_video
    input  wire        scan_error_i,
    input  wire        scan_stall_i
);
    localparam IDLE = 3'd0, LOAD = 3'd1, WAIT = 3'd2, START = 3'd3, DRAW = 3'd4, FLUSH = 3'd5,
               END = 3'd6, DRAIN = 3'd7;
    reg  [2:0] state_q;
    reg        keep_q, bad_q;
    reg  [1:0] dead_q;                  // {write, read}
    reg        empty_q;                 // pixels do not begin anew in FLUSH
    reg        halt_q;                  // DRAIN, or reads are dead: reaches all of the core
    wire [1:0] dead;                    // dead_q from the next clock on
    wire       anew   = order_i[`RT_TOP_CONTROL_SOFT_RESET];
    wire       stop   = anew || (order_i[`RT_TOP_CONTROL_STOP] && state_q != IDLE);
    wire       start  = order_i[`RT_TOP_CONTROL_START];
    wire       accept = start && !stop && state_q == IDLE && dead_q == 2'd0;
    wire       quiet  = read_idle_i && write_idle_i;

    // ---- states ----
    always @(posedge clk) begin
        case (state_q)
            LOAD:    if (!loading_i)   state_q <= WAIT;
            WAIT:    if (room_i)       state_q <= START;
            START:                     state_q <= DRAW;
            DRAW:    if (!core_busy_i) state_q <= FLUSH;
            FLUSH:   if (empty_q || dead_q[1]) state_q <= END;
            END:                       state_q <= IDLE;
            DRAIN:   if (quiet)        state_q <= IDLE;
            default: if (accept)       state_q <= LOAD;
        endcase
        empty_q <= write_empty_i;
        if (stop) state_q <= DRAIN;
        halt_q <= !rst && (stop || (state_q == DRAIN && !quiet) || dead[0]);
        if (accept) keep_q <= order_i[`RT_TOP_CONTROL_KEEP_CACHE];
        if (rst) state_q <= IDLE;
    end
    assign load_o       = accept;
    assign begin_o      = state_q == WAIT && room_i && !stop;
    assign core_start_o = state_q == START;
    assign core_keep_o  = keep_q;
    assign core_rst_o   = rst || halt_q;
    assign cut_o        = state_q == DRAIN;
    assign forget_o     = anew && order_i[`RT_TOP_CONTROL_FORGET];
    assign flush_o      = state_q == FLUSH;
    assign clear_o      = anew;
    assign end_o        = state_q == END && !stop;
    assign good_o       = !bad_q && core_errors_i == {`RT_ERRORS{1'b0}};
    assign busy_o       = state_q != IDLE && state_q != DRAIN;
    assign draining_o   = state_q == DRAIN;
    assign waiting_o    = state_q == WAIT;
    assign done_o       = end_o || (stop && busy_o);

    // ---- watchdogs ----
    reg  [31:0] read_q, write_q, scan_q; // cycles without any move
    reg         silent_q;               // of the display, told already
    wire        read_late  = limit_i != 32'd0 && read_q >= limit_i && !dead_q[0] && busy_o;
    wire        write_late = limit_i != 32'd0 && write_q >= limit_i && !dead_q[1] && busy_o;
    assign      dead       = rst || forget_o || (state_q == DRAIN && quiet)
                             ? 2'd0 : dead_q | {write_late, read_late};
    wire        scan_late  = limit_i != 32'd0 && scan_q >= limit_i && !silent_q;
    always @(posedge clk) begin
        read_q  <= read_stall_i ? read_q + {31'd0, !(&read_q)} : 32'd0;
        write_q <= write_stall_i ? write_q + {31'd0, !(&write_q)} : 32'd0;
        scan_q  <= scan_stall_i ? scan_q + {31'd0, !(&scan_q)} : 32'd0;
        dead_q  <= dead;
        silent_q <= scan_stall_i && (silent_q || scan_late);
        if (rst || forget_o) begin
            read_q  <= 32'd0;
            write_q <= 32'd0;
            scan_q  <= 32'd0;
            silent_q <= 1'b0;
        end
    end
    assign write_dead_o = dead_q[1];

    // ---- errors ----
    reg  [`RT_ERRORS-1:0] seen_q;       // of the core, told already
    assign errors_o[`RT_ERRORS-1:0] = core_errors_i & ~seen_q;
    assign errors_o[`RT_TOP_ERRORS_SCENE_SLVERR-1:`RT_ERRORS] = 0;
    assign errors_o[`RT_TOP_ERRORS_SCENE_SLVERR] = read_errors_i[0];
    assign errors_o[`RT_TOP_ERRORS_SCENE_DECERR] = read_errors_i[1];
    assign errors_o[`RT_TOP_ERRORS_FRAME_SLVERR] = write_errors_i[0];
    assign errors_o[`RT_TOP_ERRORS_FRAME_DECERR] = write_errors_i[1];
    assign errors_o[`RT_TOP_ERRORS_SCAN_ERROR]   = scan_error_i;
    assign errors_o[`RT_TOP_ERRORS_WATCHDOG]     = read_late || write_late;
    assign errors_o[`RT_TOP_ERRORS_REFUSED]      = start && !accept;
    assign errors_o[`RT_TOP_ERRORS_SCAN_WATCHDOG] = scan_late;
    always @(posedge clk) begin
        seen_q <= core_errors_i;
        if (begin_o) bad_q <= 1'b0;
        else if (read_errors_i != 2'd0 || write_errors_i != 2'd0 || read_late || write_late)
            bad_q <= 1'b1;
        if (rst) seen_q <= {`RT_ERRORS{1'b0}};
    end
    wire unused = &{1'b0, order_i};      // those that others take
endmodule
`default_nettype wire
