// rt_frame_groups.v - joins pixels that come in any order to groups of eight of one row
// SPDX-License-Identifier: Apache-2.0
// BUFFERS groups are filled at once, row y in buffer y mod BUFFERS: the walk goes down columns of
// eight pixels. A group leaves when it is full, when a pixel of another one wants its buffer, or
// with flush_i. One pixel a cycle, less two that finds its buffer taken; a group every two cycles.
//   stage 1: is the group of its buffer the pixel's?   stage 2: into the buffer, or that leaves
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
    reg  [BUFFERS-1:0] used_q, full_q;

    // ---- stage 1: the pixel's buffer, as the pixel before it leaves it ----
    wire [AB-1:0] at    = pix_y_i[AB-1:0];
    wire [TB-1:0] tag   = {pix_x_i[13:3], pix_y_i[13:AB]};
    wire [TB-1:0] held;                               // tag of its buffer
    reg           s2_valid_q, s2_used_q, s2_same_q;   // its buffer is used, by its own group
    reg  [AB-1:0] s2_at_q;
    reg  [TB-1:0] s2_tag_q;
    reg  [7:0]    s2_one_q;                           // its place in the group
    reg  [24*COLOURS-1:0] s2_rgb_q;
    wire [BUFFERS-1:0] leaves;                        // the buffer whose group leaves
    wire          put;
    wire          behind = put && s2_at_q == at;
    assign pix_ready_o   = !s2_valid_q || put;
    always @(posedge clk) begin
        if (pix_ready_o) begin
            s2_valid_q <= pix_valid_i;
            s2_at_q    <= at;
            s2_tag_q   <= tag;
            s2_one_q   <= 8'd1 << pix_x_i[2:0];
            s2_rgb_q   <= pix_rgb_i;
            s2_same_q  <= behind ? s2_tag_q == tag : held == tag;
            s2_used_q  <= behind || (used_q[at] && !leaves[at]);
        end else if (leaves[s2_at_q]) s2_used_q <= 1'b0;
        if (rst) s2_valid_q <= 1'b0;
    end

    // ---- stage 2: into the buffer, unless another group is in the way or its own leaves ----
    reg           pick_valid_q;                       // the group that leaves next
    reg  [AB-1:0] pick_q;
    wire          in_way  = s2_valid_q && s2_used_q && !s2_same_q;
    wire [7:0]    mask_at;                            // which pixels are there
    wire [7:0]    mask    = (s2_used_q ? mask_at : 8'd0) | s2_one_q;
    assign        put     = s2_valid_q && !in_way && !(pick_valid_q && pick_q == s2_at_q);

    // ---- which group leaves: the lowest that is full, or any, else the one in the way ----
    wire [AB-1:0] from  = pick_valid_q ? pick_q : s2_at_q;
    wire          leave = !group_valid_o && (pick_valid_q || in_way);
    wire [BUFFERS-1:0] at_hot = {{(BUFFERS-1){1'b0}}, 1'b1} << s2_at_q;
    wire [BUFFERS-1:0] pick_hot = {{(BUFFERS-1){1'b0}}, 1'b1} << pick_q;
    assign leaves = group_valid_o ? {BUFFERS{1'b0}} : pick_valid_q ? pick_hot
                    : in_way ? at_hot : {BUFFERS{1'b0}};
    wire [BUFFERS-1:0] may = (flush_i && !s2_valid_q ? used_q : full_q) &
                             ~(pick_valid_q ? pick_hot : {BUFFERS{1'b0}}) &
                             ~(in_way ? at_hot : {BUFFERS{1'b0}});
    reg  [AB-1:0]      lowest;
    integer            i;
    always @* begin
        lowest = {AB{1'b0}};
        for (i = BUFFERS - 1; i >= 0; i = i - 1) if (may[i]) lowest = i[AB-1:0];
    end
    always @(posedge clk) begin
        group_valid_o <= group_valid_o ? !group_ready_i : leave;
        if (!pick_valid_q || !group_valid_o) begin
            pick_valid_q <= may != {BUFFERS{1'b0}};
            pick_q       <= lowest;
        end
        used_q <= (used_q & ~leaves) | (put ? at_hot : {BUFFERS{1'b0}});
        full_q <= (full_q & ~leaves) | (put && &mask ? at_hot : {BUFFERS{1'b0}});
        if (rst) begin
            used_q        <= {BUFFERS{1'b0}};
            full_q        <= {BUFFERS{1'b0}};
            pick_valid_q  <= 1'b0;
            group_valid_o <= 1'b0;
        end
    end
    assign empty_o = used_q == {BUFFERS{1'b0}} && !s2_valid_q && !group_valid_o;

    // ---- what is held ----
    wire [TB-1:0]  tag_from;
    wire [7:0]     mask_from;
    wire [192*COLOURS-1:0] rgb_from;
    rt_slot_file #(.WIDTH(TB), .SLOTS(BUFFERS)) u_held (
        .clk(clk), .wr_en_i(put), .wr_addr_i(s2_at_q), .wr_data_i(s2_tag_q),
        .rd_addr_i(at), .rd_data_o(held)
    );
    rt_slot_file #(.WIDTH(8), .SLOTS(BUFFERS)) u_mask (
        .clk(clk), .wr_en_i(put), .wr_addr_i(s2_at_q), .wr_data_i(mask),
        .rd_addr_i(s2_at_q), .rd_data_o(mask_at)
    );
    rt_slot_file #(.WIDTH(TB+8), .SLOTS(BUFFERS)) u_leaves (
        .clk(clk), .wr_en_i(put), .wr_addr_i(s2_at_q), .wr_data_i({s2_tag_q, mask}),
        .rd_addr_i(from), .rd_data_o({tag_from, mask_from})
    );
    genvar p;
    generate
        for (p = 0; p < 8; p = p + 1) begin : g_pixel
            rt_slot_file #(.WIDTH(24*COLOURS), .SLOTS(BUFFERS)) u_rgb (
                .clk(clk), .wr_en_i(put && s2_one_q[p]), .wr_addr_i(s2_at_q),
                .wr_data_i(s2_rgb_q), .rd_addr_i(from),
                .rd_data_o(rgb_from[24*COLOURS*p +: 24*COLOURS])
            );
        end
    endgenerate
    always @(posedge clk)
        if (leave) begin
            {group_column_o, group_y_o[13:AB]} <= tag_from;
            group_y_o[AB-1:0]                  <= from;
            group_mask_o                       <= mask_from;
            group_rgb_o                        <= rgb_from;
        end
endmodule
`default_nettype wire
