// rt_blends.v - blends the surfaces of every slot's pixel, and keeps its state and frames
// SPDX-License-Identifier: Apache-2.0
// Two rt_blend take turns, a surface every 4 cycles. The state of a pixel between two surfaces is
// {depth, frames, weight, sum}: 116 bits for three frames, 89 for two (one reflection, no depth).
// Without reflections there is one surface and no state: rt_colour makes the one frame.
// read_i reads the state of a slot for the surface that enters one cycle later. What is blended
// leaves a cycle after rt_blend has it: whether a ray goes on is compared before.
// Model: sph_surface_colour(), sph_blend_add() in cmodel/shade/colour.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_blends #(
    parameter REFLECT = 5,   // reflections, 0..10
    parameter PROBE   = 1,   // 1: some surfaces are probed (INTERPENETRATE)
    parameter LUTS    = 0,   // LUT cells that a block RAM is worth, rt_slot_ram
    parameter SLOTS   = 32  // power of two
) (
    input  wire             clk,
    input  wire             rst,
    input  wire [8:0]       least_i,          // u1.8, weight below which no ray is followed
    // a surface, or the background behind a mirror
    input  wire             read_i,
    input  wire [$clog2(SLOTS)-1:0] read_slot_i,
    input  wire             in_first_i,       // what the pixel sees itself; one cycle after read_i
    output wire [3:0]       depth_o,          // reflections before it
    input  wire             in_valid_i,
    output wire             in_ready_o,
    input  wire [$clog2(SLOTS)-1:0] in_slot_i,
    input  wire [50:0]      in_light_i,       // 3 x u2.15, red low
    input  wire [`RT_RGB_BITS-1:0] in_albedo_i,      // 0xBBGGRR
    input  wire             in_background_i,  // nothing hit: albedo is the colour
    input  wire [8:0]       in_kr_i,          // u1.8, 0..256, share of the reflection
    input  wire             in_last_i,        // nothing lies behind: the frames are complete
    input  wire             in_probe_i,       // to be probed
    // it is blended
    output reg              out_valid_o,      // one cycle
    output reg [$clog2(SLOTS)-1:0] out_slot_o,
    output reg              out_last_o,
    output reg              out_probe_o,
    // complete frames of a slot, one cycle after
    input  wire             frames_read_i,
    input  wire [$clog2(SLOTS)-1:0] frames_slot_i,
    output wire [3*`RT_RGB_BITS-1:0] frames_o          // L2, L1, Rendering
);
    localparam SLOTW = $clog2(SLOTS);
    localparam FRAMES = REFLECT > 1 ? 3 : REFLECT + 1;
    localparam TAG    = SLOTW + 1 + PROBE;
    localparam CB     = `RT_RGB_BITS;                // of a frame
    wire [SLOTW+1:0]     in_tag = {in_probe_i, in_last_i, in_slot_i};
    wire [TAG-1:0]       out_tag;
    wire                 b_valid, b_last;            // it leaves in the next cycle
    wire [SLOTW-1:0]     b_slot = out_tag[SLOTW-1:0];
    wire [CB*FRAMES-1:0] out_colour, frames;
    always @(posedge clk) begin
        out_valid_o <= b_valid;
        out_slot_o  <= b_slot;
        out_last_o  <= b_last;
        out_probe_o <= PROBE != 0 && out_tag[TAG-1];
        if (rst) out_valid_o <= 1'b0;
    end
    rt_slot_ram #(.WIDTH(CB*FRAMES), .SLOTS(SLOTS), .OLD(0)) u_frames (
        .clk(clk), .wr_en_i(b_valid && b_last), .wr_addr_i(b_slot),
        .wr_data_i(out_colour),
        .rd_en_i(frames_read_i), .rd_addr_i(frames_slot_i), .rd_data_o(frames)
    );
    genvar u;
    generate
        if (FRAMES == 3) begin : g_three
            assign frames_o = frames;
        end else begin : g_less                      // the deepest again
            assign frames_o = {{(3-FRAMES){frames[CB*FRAMES-1 -: CB]}}, frames};
        end

        if (REFLECT == 0) begin : g_colour
            assign depth_o = 4'd0;
            assign b_last = out_tag[SLOTW];
            rt_colour #(.TAG(TAG)) u_colour (
                .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .in_ready_o(in_ready_o),
                .in_tag_i(in_tag[TAG-1:0]), .in_light_i(in_light_i),
                .in_albedo_i(in_albedo_i), .out_valid_o(b_valid),
                .out_tag_o(out_tag), .out_colour_o(out_colour)
            );
            wire unused = &{1'b0, read_i, read_slot_i, in_first_i, in_background_i, in_kr_i,
                            least_i};
        end else begin : g_blend
            localparam DW   = $clog2(REFLECT + 1);   // depth
            localparam LB   = 48;                    // sum of lights
            localparam WB   = 17;                    // weight
            localparam KEPT = CB*(FRAMES - 1);       // frames that later depths leave alone
            localparam CW   = KEPT + WB + LB;        // {frames, weight, sum}
            localparam SW   = REFLECT > 1 ? CW + DW : CW;
            localparam BW   = DW + CB + CW;          // {depth, deepest frame, frames, weight, sum}
            wire [SW-1:0]         state;
            wire [DW-1:0]         depth;
            wire [1:0]            ready, valid;
            wire [2*TAG-1:0]      tags;
            wire [2*BW-1:0]       results;
            wire [KEPT-1:0]       s_frames;          // of the pixel before
            wire [WB-1:0]         s_weight, o_weight;
            wire [LB-1:0]         s_sum, o_sum;
            wire [DW-1:0]         o_depth;           // what is blended
            assign {s_frames, s_weight, s_sum} = state[CW-1:0];
            assign {o_depth, out_colour, o_weight, o_sum} = valid[0] ? results[BW-1:0]
                                                                     : results[2*BW-1:BW];
            assign depth_o     = {{(4-DW){1'b0}}, depth};
            assign b_last      = out_tag[SLOTW] || o_weight[16:8] < least_i;
            assign in_ready_o  = |ready;
            assign b_valid     = |valid;             // never both: one enters a cycle
            assign out_tag     = valid[0] ? tags[TAG-1:0] : tags[2*TAG-1:TAG];
            wire [SW-1:0]         next;
            if (REFLECT > 1) begin : g_depth
                assign depth = in_first_i ? {DW{1'b0}} : state[CW +: DW];
                assign next  = {o_depth, out_colour[KEPT-1:0], o_weight, o_sum};
            end else begin : g_behind                // after the first comes the last
                assign depth = !in_first_i;
                assign next  = {out_colour[KEPT-1:0], o_weight, o_sum};
                wire unused = &{1'b0, o_depth};
            end
            rt_slot_ram #(.WIDTH(SW), .SLOTS(SLOTS), .OLD(0), .LUTS(LUTS)) u_state (
                .clk(clk), .wr_en_i(b_valid), .wr_addr_i(b_slot),
                .wr_data_i(next),
                .rd_en_i(read_i), .rd_addr_i(read_slot_i), .rd_data_o(state)
            );
            for (u = 0; u < 2; u = u + 1) begin : g_unit
                wire [DW-1:0]      u_depth;
                wire [KEPT+CB-1:0] u_colour;
                wire [WB-1:0]      u_weight;
                wire [LB-1:0]      u_sum;
                assign results[BW*u +: BW] = {u_depth, u_colour, u_weight, u_sum};
                rt_blend #(.REFLECT(REFLECT), .TAG(TAG)) u_blend (
                    .clk(clk), .rst(rst),
                    .in_valid_i(in_valid_i && (u == 0 || !ready[0])), .in_ready_o(ready[u]),
                    .in_tag_i(in_tag[TAG-1:0]), .in_light_i(in_light_i),
                    .in_albedo_i(in_albedo_i), .in_background_i(in_background_i),
                    .in_kr_i(in_kr_i),
                    .in_sum_i(in_first_i ? {LB{1'b0}} : s_sum),
                    .in_weight_i(in_first_i ? 17'h10000 : s_weight),
                    .in_depth_i(depth), .in_colour_i(s_frames),
                    .out_valid_o(valid[u]), .out_tag_o(tags[TAG*u +: TAG]),
                    .out_sum_o(u_sum), .out_weight_o(u_weight),
                    .out_depth_o(u_depth), .out_colour_o(u_colour)
                );
            end
        end
    endgenerate
    wire unused = &{1'b0, in_tag};
endmodule
`default_nettype wire
