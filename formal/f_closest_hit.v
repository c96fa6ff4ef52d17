// f_closest_hit.v - proof of rt_closest_hit: each slot's first hit, what it bounds, hits inside
// SPDX-License-Identifier: Apache-2.0
//   new ray --> ready --> visit: want --> results --> last --> 4 clocks --> token, ready
// Any slot may be marked; others do as they like. Token rule: a slot's results come as many as its
// visit wants; the next visit, a new ray and reads come from its token on. Nothing comes while
// slots are cleared after a reset, which may come at any time.
// best_q: the first hit that a result leads to in the clock after it, and in the three behind that;
// its depth is s3_depth, which f_closest_hit_depth.v is about.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module f_closest_hit #(
    parameter W     = 6,
    parameter WD    = 11,
    parameter KEYS  = 0,
    parameter FW    = KEYS == 1 ? `RT_BIH_T - 1 : KEYS == 2 ? 14 : 5,
    parameter SLOTS = 4,
    parameter SLOTW = 2
) (
    input wire             clk,
    input wire             rst,
    input wire             want_valid, new_valid, in_valid, filter_valid, next_valid, done_valid,
    input wire [SLOTW-1:0] want_slot, new_slot, in_slot, filter_slot, next_slot, done_slot,
    input wire [2:0]       want_count,
    input wire [16:0]      new_scale,
    input wire [5:0]       new_shift,
    input wire             new_shadow, new_primary, new_first, in_hit, in_far,
    input wire [FW:0]      new_depth,
    input wire [`RT_ID_BITS-1:0] in_id,
    input wire [W+WD+1:0]  in_key
);
    localparam KW  = W + WD + 2;
    localparam IDB = `RT_ID_BITS;
    localparam BB  = 2 + IDB + KW;                    // {found, far, id, key}
    wire out_valid, next_found, next_ends, done_found, done_shadow, done_primary, done_first;
    wire done_far;
    wire [1:0] done_fars;
    wire [SLOTW-1:0] out_slot;
    wire [FW:0]      filter_depth, next_depth;
    wire [IDB-1:0]   done_id;
    wire [KW-1:0]    done_key;
    rt_closest_hit #(.W(W), .WD(WD), .FW(FW), .SLOTS(SLOTS), .KEYS(KEYS)) u_dut (
        .clk(clk), .rst(rst), .want_valid_i(want_valid), .want_slot_i(want_slot),
        .want_count_i(want_count), .new_valid_i(new_valid), .new_slot_i(new_slot),
        .new_scale_i(new_scale), .new_shift_i(new_shift), .new_shadow_i(new_shadow),
        .new_primary_i(new_primary), .new_first_i(new_first), .new_depth_i(new_depth),
        .in_valid_i(in_valid), .in_slot_i(in_slot), .in_hit_i(in_hit), .in_far_i(in_far),
        .in_id_i(in_id), .in_key_i(in_key), .out_valid_o(out_valid), .out_slot_o(out_slot),
        .filter_valid_i(filter_valid), .filter_slot_i(filter_slot),
        .filter_depth_o(filter_depth), .next_valid_i(next_valid), .next_slot_i(next_slot),
        .next_depth_o(next_depth), .next_found_o(next_found), .next_ends_o(next_ends),
        .done_valid_i(done_valid), .done_slot_i(done_slot), .done_found_o(done_found),
        .done_shadow_o(done_shadow), .done_primary_o(done_primary), .done_first_o(done_first),
        .done_far_o(done_far), .done_fars_o(done_fars), .done_id_o(done_id), .done_key_o(done_key)
    );
    (* anyconst *) wire [SLOTW-1:0] slot;             // the marked one
    (* hierconn *) wire [SLOTW:0]   \u_dut.clear_q ;
    (* hierconn *) wire [FW:0]      \u_dut.s3_depth ;
    (* hierconn *) wire [SLOTW-1:0] \u_dut.u_mark.mark , \u_dut.u_scale.mark , \u_dut.u_want.mark ;
    (* hierconn *) wire [SLOTW-1:0] \u_dut.u_seen.mark , \u_dut.u_best.mark , \u_dut.u_done.mark ;
    (* hierconn *) wire [SLOTW-1:0] \u_dut.u_first_f.mark , \u_dut.u_best_f.mark ;
    (* hierconn *) wire [SLOTW-1:0] \u_dut.u_first_n.mark , \u_dut.u_best_n.mark ;
    (* hierconn *) wire [SLOTW-1:0] \u_dut.u_first_d.mark ;
    (* hierconn *) wire [SLOTW-1:0] \u_dut.g_fars.u_fars.mark , \u_dut.g_fars.u_fars_d.mark ;
    (* hierconn *) wire [2:0]       \u_dut.g_fars.u_fars.word_q , \u_dut.g_fars.u_fars_d.word_q ;
    (* hierconn *) wire             \u_dut.u_mark.word_q ;
    (* hierconn *) wire [(KEYS != 0 ? 0 : 23):0] \u_dut.u_scale.word_q ;
    (* hierconn *) wire [2:0]       \u_dut.u_want.word_q , \u_dut.u_seen.word_q ;
    (* hierconn *) wire [BB-1:0]    \u_dut.u_best.word_q , \u_dut.u_done.word_q ;
    (* hierconn *) wire [FW+1:0]    \u_dut.u_first_f.word_q , \u_dut.u_best_f.word_q ;
    (* hierconn *) wire [FW+2:0]    \u_dut.u_first_n.word_q ;
    (* hierconn *) wire [FW+1:0]    \u_dut.u_best_n.word_q ;
    (* hierconn *) wire [3:0]       \u_dut.u_first_d.word_q ;

    // ---- model ----
    reg            old_q = 1'b0;
    reg            ray_q;                             // the slot has a ray
    reg  [2:0]     left_q, count_q;                   // results that its visit waits for; had
    reg  [3:0]     end_q;                             // its last result came so many clocks before
    reg  [4*BB-1:0] best_q;
    reg  [2:0]     wins_q;
    reg  [7:0]     fars_q;                            // hits from inside that there were, up to 2
    reg  [FW:0]    far_q;                             // depth of the hit that was written last
    reg  [22:0]    scale_q;                           // {shift, scale}
    reg            shadow_q, primary_q, first_q;
    reg  [FW:0]    depth_q;
    reg            filter_q, next_q, done_q;          // read in the clock before
    wire new_mine  = new_valid && new_slot == slot;
    wire want_mine = want_valid && want_slot == slot;
    wire in_mine   = in_valid && in_slot == slot;
    wire out_mine  = out_valid && out_slot == slot;
    wire filter_mine = filter_valid && filter_slot == slot;
    wire next_mine = next_valid && next_slot == slot;
    wire done_mine = done_valid && done_slot == slot;
    wire ready     = ray_q && left_q == 0 && end_q[2:0] == 0;
    wire clearing  = !\u_dut.clear_q [SLOTW];
    wire cleared   = !clearing || \u_dut.clear_q > {1'b0, slot};
    wire [BB-1:0]  best = best_q[BB-1:0];
    wire [KW+IDB-1:0] b_key = {best[KW-1:0], best[KW +: IDB]}, i_key = {in_key, in_id};
    wire [1:0] fars = fars_q[1:0];
    wire wins = in_mine && in_hit && (!best[BB-1] || i_key < b_key);
    always @(posedge clk) begin
        old_q  <= 1'b1;
        best_q <= {best_q[3*BB-1:0], wins ? {1'b1, in_far, in_id, in_key} : best};
        end_q  <= {end_q[2:0], in_mine && left_q == 1};
        if (in_mine) {left_q, count_q} <= {left_q - 3'd1, left_q == 1 ? 3'd0 : count_q + 3'd1};
        if (want_mine) left_q <= want_count;
        if (new_mine) begin
            ray_q  <= 1'b1;
            best_q <= 0;
            scale_q <= {new_shift, new_scale};
            {shadow_q, primary_q, first_q} <= {new_shadow, new_primary, new_first};
            depth_q                        <= new_depth;
        end
        wins_q <= {wins_q[1:0], wins};
        fars_q <= {fars_q[5:0], fars + {1'b0, in_mine && in_hit && in_far && !fars[1]}};
        if (new_mine) fars_q <= 8'd0;
        if (wins_q[2]) far_q <= \u_dut.s3_depth ;
        {filter_q, next_q, done_q} <= {filter_mine, next_mine, done_mine};
        if (rst) begin
            {ray_q, left_q, count_q, end_q, wins_q} <= 0;
            {filter_q, next_q, done_q}      <= 3'd0;
            best_q                          <= 0;
            fars_q                          <= 8'd0;
        end
    end
    always @* begin
        if (!old_q) assume (rst);
        assume (\u_dut.u_mark.mark == slot && \u_dut.u_scale.mark == slot);
        assume (\u_dut.u_want.mark == slot && \u_dut.u_seen.mark == slot);
        assume (\u_dut.u_best.mark == slot && \u_dut.u_done.mark == slot);
        assume (\u_dut.u_first_f.mark == slot && \u_dut.u_best_f.mark == slot);
        assume (\u_dut.u_first_n.mark == slot && \u_dut.u_best_n.mark == slot);
        assume (\u_dut.u_first_d.mark == slot);
        assume (\u_dut.g_fars.u_fars.mark == slot && \u_dut.g_fars.u_fars_d.mark == slot);
        if (rst || (old_q && clearing))
            assume (!new_valid && !want_valid && !in_valid && !filter_valid && !next_valid &&
                    !done_valid);
        if (in_mine)   assume (left_q != 0);
        if (new_mine)  assume (left_q == 0 && end_q[2:0] == 0);
        if (want_mine) assume (ready && !new_mine && want_count <= 4);
        if (filter_mine || next_mine || done_mine) assume (ready && !new_mine);
        assume (!(&in_key[KW-1 -: 17]));              // below 2.4 * 2^(W + WD)
    end

    // ---- properties ----
    wire [BB-1:0] kept = best_q[3*BB +: BB];          // as the memories of depths have it
    reg  [BB-1:0] read_q;
    reg  [1:0]    read_fars_q;
    always @(posedge clk) {read_q, read_fars_q} <= {best, fars};
    wire mark = \u_dut.u_scale.word_q [KEYS != 0 ? 0 : 23];
    wire [FW:0] read_depth = read_q[BB-1] ? far_q : depth_q;
    wire [BB-1:0] written = best_q[2*BB +: BB];
    always @* if (old_q) begin
        assert (out_mine == end_q[3]);
        if (filter_q) assert (filter_depth == read_depth);
        if (next_q) begin
            assert (next_found == read_q[BB-1] && next_depth == read_depth);
            assert (next_ends == (shadow_q || first_q));
        end
        if (done_q) begin
            assert (done_found == read_q[BB-1]);
            assert ({done_shadow, done_primary, done_first} == {shadow_q, primary_q, first_q});
            if (done_found) assert ({done_far, done_id, done_key} == read_q[BB-2:0]);
            if (done_found) assert (done_fars == read_fars_q);
        end
        // invariant
        assert (left_q <= 4 && \u_dut.clear_q <= SLOTS);
        if (left_q != 0) assert (ray_q && \u_dut.u_want.word_q == count_q + left_q);
        if (left_q == 0) assert (count_q == 0);
        if (ray_q) assert (!clearing);
        if (cleared) begin
            assert (\u_dut.u_seen.word_q == count_q);
            assert (\u_dut.u_mark.word_q == \u_dut.u_best.word_q [BB-2]);
            assert (\u_dut.u_best.word_q == \u_dut.u_done.word_q );
            assert (\u_dut.u_best_f.word_q == \u_dut.u_best_n.word_q );
            assert (\u_dut.g_fars.u_fars.word_q == \u_dut.g_fars.u_fars_d.word_q );
            assert (\u_dut.g_fars.u_fars.word_q [2] == \u_dut.u_mark.word_q );
            if (!ray_q) assert (\u_dut.u_best_f.word_q [FW+1] == \u_dut.u_mark.word_q );
        end
        if (!ray_q) assert (best_q == 0 && fars_q == 0);
        if (!best[BB-1]) assert (fars == 0);
        if (ray_q && written[BB-1]) assert (\u_dut.g_fars.u_fars.word_q [1:0] == fars_q[5:4]);
        if (ray_q) begin
            assert (mark == \u_dut.u_first_f.word_q [0] && mark == \u_dut.u_first_n.word_q [0] &&
                    mark == \u_dut.u_first_d.word_q [0]);
            assert (\u_dut.u_first_f.word_q [FW+1:1] == depth_q);
            assert (\u_dut.u_first_n.word_q [FW+2:1] == {shadow_q || first_q, depth_q});
            assert (\u_dut.u_first_d.word_q [3:1] == {first_q, shadow_q, primary_q});
            if (KEYS == 0) assert (\u_dut.u_scale.word_q == {mark, scale_q});
            assert ((\u_dut.u_mark.word_q != mark) == written[BB-1]);
            if (written[BB-1])
                assert ({\u_dut.u_best.word_q [BB-1], \u_dut.u_best.word_q [BB-3:0]} ==
                        written[BB-2:0]);
            assert ((\u_dut.u_best_f.word_q [FW+1] != mark) == kept[BB-1]);
            if (kept[BB-1]) assert (\u_dut.u_best_f.word_q [FW:0] == far_q);
        end
        if (left_q == 0 && end_q[2:0] == 0)           // nothing is on its way
            assert (best_q == {4{best}});
    end
endmodule
`default_nettype wire
