// f_frame_groups.v - proof of rt_frame_groups: each pixel leaves once, in its own group
// SPDX-License-Identifier: Apache-2.0
// Followed is one pixel of any group, the first or the sixth of its eight, of any colour, that the
// core sends once until it has left. The user takes groups, and flushes, in any clock.
`timescale 1ns / 1ps
`default_nettype none
module f_frame_groups #(
    parameter BUFFERS = 4,
    parameter COLOURS = 1,
    parameter CW = 24*COLOURS            // derived: leave alone
) (
    input wire        clk,
    input wire        rst,
    input wire        flush,
    input wire        pix_valid,
    input wire [13:0] pix_x,
    input wire [13:0] pix_y,
    input wire [CW-1:0] pix_rgb,
    input wire        group_ready
);
    localparam AB = $clog2(BUFFERS);
    localparam TB = 25 - AB;
    wire empty, pix_ready, group_valid;
    wire [10:0]  group_column;
    wire [13:0]  group_y;
    wire [7:0]   group_mask;
    wire [8*CW-1:0] group_rgb;
    rt_frame_groups #(.BUFFERS(BUFFERS), .COLOURS(COLOURS)) u_dut (
        .clk(clk), .rst(rst), .flush_i(flush), .empty_o(empty), .pix_valid_i(pix_valid),
        .pix_ready_o(pix_ready), .pix_x_i(pix_x), .pix_y_i(pix_y), .pix_rgb_i(pix_rgb),
        .group_valid_o(group_valid), .group_ready_i(group_ready), .group_column_o(group_column),
        .group_y_o(group_y), .group_mask_o(group_mask), .group_rgb_o(group_rgb)
    );
    (* hierconn *) wire [BUFFERS-1:0]   \u_dut.used_q ;
    (* hierconn *) wire [BUFFERS-1:0]   \u_dut.full_q ;
    (* hierconn *) wire          \u_dut.pick_valid_q ;
    (* hierconn *) wire [AB-1:0] \u_dut.pick_q ;
    (* hierconn *) wire          \u_dut.s2_valid_q ;
    (* hierconn *) wire          \u_dut.s2_used_q ;
    (* hierconn *) wire          \u_dut.s2_same_q ;
    (* hierconn *) wire [AB-1:0] \u_dut.s2_at_q ;
    (* hierconn *) wire [TB-1:0] \u_dut.s2_tag_q ;
    (* hierconn *) wire [7:0]    \u_dut.s2_one_q ;
    (* hierconn *) wire [CW-1:0] \u_dut.s2_rgb_q ;
    (* hierconn *) wire [AB-1:0] \u_dut.u_mask.mark ;
    (* hierconn *) wire [7:0]    \u_dut.u_mask.word_q ;
    (* hierconn *) wire [AB-1:0] \u_dut.u_held.mark ;
    (* hierconn *) wire [TB-1:0] \u_dut.u_held.word_q ;
    (* hierconn *) wire [AB-1:0] \u_dut.u_leaves.mark ;
    (* hierconn *) wire [TB+7:0] \u_dut.u_leaves.word_q ;
    (* hierconn *) wire [AB-1:0] \u_dut.g_pixel[0].u_rgb.mark ;
    (* hierconn *) wire [CW-1:0] \u_dut.g_pixel[0].u_rgb.word_q ;
    (* hierconn *) wire [AB-1:0] \u_dut.g_pixel[5].u_rgb.mark ;
    (* hierconn *) wire [CW-1:0] \u_dut.g_pixel[5].u_rgb.word_q ;

    // ---- the pixel ----
    (* anyconst *) wire [13:0] x;
    (* anyconst *) wire [13:0] y;
    wire [AB-1:0] at    = y[AB-1:0];
    wire [CW-1:0] kept  = x[2:0] == 0 ? \u_dut.g_pixel[0].u_rgb.word_q
                                      : \u_dut.g_pixel[5].u_rgb.word_q ;
    wire          it    = pix_valid && pix_x == x && pix_y == y;
    wire [TB-1:0] tag   = {x[13:3], y[13:AB]};
    wire [7:0]    mask  = \u_dut.u_mask.word_q ;
    wire          in_s2 = \u_dut.s2_valid_q && \u_dut.s2_at_q == at && \u_dut.s2_tag_q == tag &&
                          \u_dut.s2_one_q [x[2:0]];
    wire          held  = \u_dut.used_q [at] && mask[x[2:0]] &&
                          \u_dut.u_held.word_q == tag;
    wire          there = group_valid && group_column == x[13:3] && group_y == y &&
                          group_mask[x[2:0]];
    reg           old_q = 1'b0, in_q, wait_q, stuck_q, flush_q;
    reg  [CW-1:0] rgb_q;
    reg  [8*CW+32:0] group_q;
    wire [8*CW+32:0] group = {group_column, group_y, group_mask, group_rgb};
    always @(posedge clk) begin
        old_q <= 1'b1;
        if (there && group_ready) in_q <= 1'b0;
        if (it && pix_ready) {in_q, rgb_q} <= {1'b1, pix_rgb};
        wait_q  <= group_valid && !group_ready && !rst;
        group_q <= group;
        stuck_q <= pix_valid && !pix_ready && !group_valid && !rst;
        flush_q <= flush && !\u_dut.s2_valid_q && |\u_dut.used_q && !group_valid && !rst;
        if (rst) in_q <= 1'b0;
    end
    always @* begin
        if (!old_q) assume (rst);
        assume (x[2:0] == 0 || x[2:0] == 5);
        assume (\u_dut.u_held.mark == at && \u_dut.u_leaves.mark == at);
        assume (\u_dut.u_mask.mark == at);
        assume (\u_dut.g_pixel[0].u_rgb.mark == at && \u_dut.g_pixel[5].u_rgb.mark == at);
        if (it) assume (!in_q);
    end

    always @* if (old_q) begin
        if (there) assert (in_q && group_rgb[CW*x[2:0] +: CW] == rgb_q);  // once, its own colour
        if (in_q) assert (!empty);
        if (wait_q) assert (group_valid && group == group_q);             // stable until ready
        if (stuck_q) assert (pix_ready || group_valid);                   // it waits for a group
        if (flush_q) assert (group_valid || \u_dut.pick_valid_q );        // one in two clocks
        // invariant
        assert (in_q == (in_s2 || held || there));
        assert (in_s2 + held + there < 2);
        if (held) assert (kept == rgb_q);
        if (in_s2) assert (\u_dut.s2_rgb_q == rgb_q);
        assert ((\u_dut.full_q & ~\u_dut.used_q ) == 0);
        if (\u_dut.used_q [at]) begin
            assert (\u_dut.full_q [at] == &mask);
            assert (\u_dut.u_leaves.word_q == {\u_dut.u_held.word_q , mask});
        end
        if (\u_dut.pick_valid_q ) assert (\u_dut.used_q [\u_dut.pick_q ]);
        if (\u_dut.s2_valid_q ) begin
            assert (\u_dut.s2_one_q != 0 &&
                    (\u_dut.s2_one_q & (\u_dut.s2_one_q - 1'b1)) == 0);
            assert (\u_dut.s2_used_q == \u_dut.used_q [\u_dut.s2_at_q ]);
            if (\u_dut.s2_used_q && \u_dut.s2_at_q == at)
                assert (\u_dut.s2_same_q == (\u_dut.s2_tag_q == \u_dut.u_held.word_q ));
        end
    end
endmodule
`default_nettype wire
