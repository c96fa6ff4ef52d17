// rt_interpenetrate.v - spheres in spheres: probes the first surface found, repeats the ray
// SPDX-License-Identifier: Apache-2.0
// A primary ray that ended at its first hit may have found a surface inside another sphere. The
// mirror ray of that surface tells: if any sphere that it finds holds its origin, but for the one
// that it leaves from inside, the surface lies in there, all that the pixel has is void, and its
// primary ray starts again, nearest first.
// Borodavka et al. VI.D. Model: path() in cmodel/engine/render_pixel.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_interpenetrate #(
    parameter WD    = 17,  // direction component, bits
    parameter SLOTS = 32  // power of two
) (
    input  wire              clk,
    input  wire              rst,
    // a new pixel; z of its direction is the same for all pixels of a frame
    input  wire              pixel_valid_i,
    input  wire [$clog2(SLOTS)-1:0] pixel_slot_i,
    input  wire [3*WD-1:0]   pixel_dir_i,
    // a surface is blended, its mirror ray starts unless it is the last and no probe
    input  wire              blend_valid_i,
    input  wire [$clog2(SLOTS)-1:0] blend_slot_i,
    input  wire              blend_probe_i,  // a surface that a first-hit ray found
    input  wire              blend_last_i,   // the mirror ray is no more than a probe
    // a ray will be done in the next cycle
    input  wire              ask_valid_i,
    input  wire [$clog2(SLOTS)-1:0] ask_slot_i,
    // a primary or mirror ray is done
    input  wire              done_valid_i,
    input  wire [$clog2(SLOTS)-1:0] done_slot_i,
    input  wire              done_primary_i,
    input  wire              done_found_i,   // a sphere with a record
    input  wire              done_far_i,
    input  wire [1:0]        done_fars_i,    // hits from inside, its own among them; 2: or more
    output wire              done_void_o,    // the pixel starts again
    output wire              done_end_o,     // the pixel is complete
    // to rt_setup: the primary ray once more
    output wire              again_valid_o,
    input  wire              again_ready_i,
    output wire [$clog2(SLOTS)-1:0] again_slot_o,
    output wire [3*WD-1:0]   again_dir_o,
    // which primary rays are repeated
    input  wire [$clog2(SLOTS)-1:0] ray_slot_i,
    output wire              ray_again_o
);
    localparam SLOTW = $clog2(SLOTS);
    // ---- the mirror ray of a probe is done ----
    wire             probe, last;                    // of the slot's latest surface
    wire             first_far;                      // the primary ray found it from inside
    rt_slot_ram #(.WIDTH(2), .SLOTS(SLOTS), .OLD(0)) u_surface (
        .clk(clk), .wr_en_i(blend_valid_i), .wr_addr_i(blend_slot_i),
        .wr_data_i({blend_probe_i, blend_last_i}),
        .rd_en_i(ask_valid_i), .rd_addr_i(ask_slot_i), .rd_data_o({probe, last})
    );
    rt_slot_ram #(.WIDTH(1), .SLOTS(SLOTS), .OLD(0)) u_first (
        .clk(clk), .wr_en_i(done_valid_i && done_primary_i), .wr_addr_i(done_slot_i),
        .wr_data_i(done_far_i),
        .rd_en_i(ask_valid_i), .rd_addr_i(ask_slot_i), .rd_data_o(first_far)
    );
    wire probed = !done_primary_i && probe;
    wire other  = done_found_i && done_fars_i > {1'b0, first_far};
    assign done_void_o = probed && other;
    assign done_end_o  = probed && last && !other;

    // ---- queue of pixels that start again ----
    wire             q_valid, q_in, load;
    wire [SLOTW-1:0] q_slot;
    wire             again = again_valid_o && again_ready_i;
    wire [2*WD-1:0]  dir;                            // {y, x}
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_queue (
        .clk(clk), .rst(rst), .in_valid_i(done_valid_i && done_void_o), .in_ready_o(q_in),
        .in_data_i(done_slot_i),
        .out_valid_o(q_valid), .out_ready_i(load), .out_data_o(q_slot)
    );
    rt_slot_ram #(.WIDTH(2*WD), .SLOTS(SLOTS), .OLD(0)) u_dir (
        .clk(clk), .wr_en_i(pixel_valid_i), .wr_addr_i(pixel_slot_i),
        .wr_data_i(pixel_dir_i[2*WD-1:0]),
        .rd_en_i(load && q_valid), .rd_addr_i(q_slot), .rd_data_o(dir)
    );
    rt_reg_slice #(.WIDTH(SLOTW)) u_head (
        .clk(clk), .rst(rst), .in_valid_i(q_valid), .in_ready_o(load), .in_data_i(q_slot),
        .out_valid_o(again_valid_o), .out_ready_i(again_ready_i), .out_data_o(again_slot_o)
    );
    assign again_dir_o = {pixel_dir_i[3*WD-1:2*WD], dir};

    // ---- never both: new pixels wait while one starts again ----
    rt_slot_file #(.WIDTH(1), .SLOTS(SLOTS)) u_again (
        .clk(clk), .wr_en_i(pixel_valid_i || again),
        .wr_addr_i(again ? again_slot_o : pixel_slot_i), .wr_data_i(again),
        .rd_addr_i(ray_slot_i), .rd_data_o(ray_again_o)
    );
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_repeated_primary_rays /* verilator public_flat_rd */ =
        {again_valid_o && !again_ready_i, again, 5'd0, again};
    wire unused = &{1'b0, q_in};
endmodule
`default_nettype wire
