// rt_frame_groups.v - joins pixels that come in any order to groups of eight of one row
// SPDX-License-Identifier: Apache-2.0
// BUFFERS groups are filled at once, row y in buffer y mod BUFFERS: the walk goes down columns of
// eight pixels. A group leaves when it is full, when a pixel of another one wants its buffer, or
// with flush_i. One pixel a cycle, less one that finds its buffer taken; a group a cycle.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
module rt_frame_groups #(
    parameter BUFFERS = 16,          // groups filled at once, a power of two, 4..64
    parameter COLOURS = 1            // of a pixel, 1 or 3
) (
    input  wire         clk,
    input  wire         rst,
    input  wire         flush_i,     // no pixel follows: all groups leave
    output wire         empty_o,     // nothing is held
    // from the core
    input  wire         pix_valid_i,
    output wire         pix_ready_o,
    input  wire [13:0]  pix_x_i,
    input  wire [13:0]  pix_y_i,
    input  wire [24*COLOURS-1:0] pix_rgb_i, // each 0xBBGGRR
    // to rt_frame_write
    output reg          group_valid_o,
    input  wire         group_ready_i,
    output reg  [10:0]  group_column_o, // x/8
    output reg  [13:0]  group_y_o,
    output reg  [7:0]   group_mask_o,   // which of the eight there are
    output reg  [192*COLOURS-1:0] group_rgb_o // pixel i at 24 COLOURS i
);
    localparam AB = $clog2(BUFFERS);
    `RT_CHECK(BUFFERS >= 4 && BUFFERS <= 64 && BUFFERS == (1 << AB),
              rt_frame_groups_BUFFERS_must_be_a_power_of_two_from_4_to_64)
    localparam TB = 25 - AB;                          // column and the rest of the row
    reg  [BUFFERS-1:0]   used_q, full_q;
    reg  [8*BUFFERS-1:0] mask_q;

    // ---- the pixel's buffer ----
    wire [AB-1:0] at    = pix_y_i[AB-1:0];
    wire [TB-1:0] tag   = {pix_x_i[13:3], pix_y_i[13:AB]};
    wire [TB-1:0] held;                               // tag of its buffer
    wire          other = used_q[at] && held != tag;  // which is another group's
    wire [7:0]    one   = 8'd1 << pix_x_i[2:0];
    wire [7:0]    mask  = (used_q[at] ? mask_q[8*at +: 8] : 8'd0) | one;
    wire          put   = pix_valid_i && pix_ready_o;

    // ---- which group leaves: the one in the way, else the lowest that is full, or any ----
    wire [BUFFERS-1:0] may = full_q != {BUFFERS{1'b0}} ? full_q
                             : flush_i ? used_q : {BUFFERS{1'b0}};
    reg  [AB-1:0]      lowest;
    integer            i;
    always @* begin
        lowest = {AB{1'b0}};
        for (i = BUFFERS - 1; i >= 0; i = i - 1) if (may[i]) lowest = i[AB-1:0];
    end
    wire          in_way = pix_valid_i && other;
    wire [AB-1:0] from   = in_way ? at : lowest;
    wire          room   = !group_valid_o || group_ready_i;
    wire          leave  = room && (in_way || may != {BUFFERS{1'b0}});
    assign pix_ready_o   = !other && !(leave && from == at);
    always @(posedge clk) begin
        if (room) group_valid_o <= leave;
        if (leave) used_q[from] <= 1'b0;
        if (leave) full_q[from] <= 1'b0;
        if (put) begin
            used_q[at]        <= 1'b1;
            full_q[at]        <= &mask;
            mask_q[8*at +: 8] <= mask;
        end
        if (rst) begin
            used_q        <= {BUFFERS{1'b0}};
            full_q        <= {BUFFERS{1'b0}};
            group_valid_o <= 1'b0;
        end
    end
    assign empty_o = used_q == {BUFFERS{1'b0}} && !group_valid_o;

    // ---- what is held ----
    wire [TB-1:0]  tag_from;
    wire [192*COLOURS-1:0] rgb_from;
    rt_slot_file #(.WIDTH(TB), .SLOTS(BUFFERS)) u_held (
        .clk(clk), .wr_en_i(put), .wr_addr_i(at), .wr_data_i(tag),
        .rd_addr_i(at), .rd_data_o(held)
    );
    rt_slot_file #(.WIDTH(TB), .SLOTS(BUFFERS)) u_leaves (
        .clk(clk), .wr_en_i(put), .wr_addr_i(at), .wr_data_i(tag),
        .rd_addr_i(from), .rd_data_o(tag_from)
    );
    genvar p;
    generate
        for (p = 0; p < 8; p = p + 1) begin : g_pixel
            rt_slot_file #(.WIDTH(24*COLOURS), .SLOTS(BUFFERS)) u_rgb (
                .clk(clk), .wr_en_i(put && one[p]), .wr_addr_i(at), .wr_data_i(pix_rgb_i),
                .rd_addr_i(from), .rd_data_o(rgb_from[24*COLOURS*p +: 24*COLOURS])
            );
        end
    endgenerate
    always @(posedge clk)
        if (leave) begin
            {group_column_o, group_y_o[13:AB]} <= tag_from;
            group_y_o[AB-1:0]                  <= from;
            group_mask_o                       <= mask_q[8*from +: 8];
            group_rgb_o                        <= rgb_from;
        end
endmodule
`default_nettype wire
