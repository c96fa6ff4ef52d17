// f_any_groups.v - stands for rt_frame_groups: any group in any clock, which waits until taken
// SPDX-License-Identifier: Apache-2.0
// What it gives waits, as f_frame_groups proves of the one; so what holds with this holds with it.
`timescale 1ns / 1ps
`default_nettype none
module rt_frame_groups #(
    parameter BUFFERS = 16,
    parameter COLOURS = 1
) (
    input  wire         clk,
    input  wire         rst,
    input  wire         flush_i,
    output wire         empty_o,
    input  wire         pix_valid_i,
    output wire         pix_ready_o,
    input  wire [13:0]  pix_x_i,
    input  wire [13:0]  pix_y_i,
    input  wire [24*COLOURS-1:0] pix_rgb_i,
    output reg          group_valid_o,
    input  wire         group_ready_i,
    output reg  [10:0]  group_column_o,
    output reg  [13:0]  group_y_o,
    output reg  [7:0]   group_mask_o,
    output reg  [192*COLOURS-1:0] group_rgb_o
);
    (* anyseq *) wire         any, empty, ready;
    (* anyseq *) wire [192*COLOURS+32:0] group;
    assign pix_ready_o = ready;
    assign empty_o     = empty && !group_valid_o;
    always @(posedge clk) begin
        if (!group_valid_o || group_ready_i) begin
            group_valid_o <= any;
            {group_column_o, group_y_o, group_mask_o, group_rgb_o} <= group;
        end
        if (rst) group_valid_o <= 1'b0;
    end
endmodule
`default_nettype wire
