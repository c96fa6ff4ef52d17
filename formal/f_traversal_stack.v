// f_traversal_stack.v - proof: tokens leave once, the stack of a slot is one, within its bounds
// SPDX-License-Identifier: Apache-2.0
// Any slot and any depth of its stack may be marked. What is pushed there is the whole group that
// was current, and that is what is popped from there. A token leaves at the latest after as many
// passes as its stack is deep. Token rule: a slot's next visit comes only after its token has left.
`timescale 1ns / 1ps
`default_nettype none
module f_traversal_stack #(
    parameter FW    = 4,
    parameter SLOTS = 8,
    parameter SLOTW = 3,
    parameter DEPTH = 4
) (
    input wire             clk,
    input wire             rst,
    input wire             found_valid, found_fresh, found_kill,
    input wire [SLOTW-1:0] found_slot,
    input wire [25:0]      found_base,
    input wire [2:0]       found_count,
    input wire [71:0]      found_list,
    input wire             in_valid,
    input wire [SLOTW-1:0] in_slot,
    input wire [FW:0]      depth,
    input wire             hit, ends
);
    localparam DW = $clog2(DEPTH);
    (* anyconst *) wire [SLOTW-1:0] slot;       // marked
    (* anyconst *) wire [DW-1:0]    level;
    wire in_ready, read, issue_valid, done_valid, bubble, overflow;
    wire [SLOTW-1:0] read_slot, issue_slot, done_slot;
    wire [25:0] issue_line;
    rt_traversal_stack #(.FW(FW), .SLOTS(SLOTS), .DEPTH(DEPTH)) u_dut (
        .clk(clk), .rst(rst), .found_valid_i(found_valid), .found_slot_i(found_slot),
        .found_base_i(found_base), .found_count_i(found_count), .found_list_i(found_list),
        .found_fresh_i(found_fresh), .found_kill_i(found_kill),
        .in_valid_i(in_valid), .in_ready_o(in_ready), .in_slot_i(in_slot),
        .read_o(read), .slot_o(read_slot), .depth_i(depth), .hit_i(hit), .ends_i(ends),
        .issue_valid_o(issue_valid), .issue_slot_o(issue_slot), .issue_line_o(issue_line),
        .done_valid_o(done_valid), .done_slot_o(done_slot), .bubble_o(bubble),
        .overflow_o(overflow)
    );
    (* hierconn *) wire              \u_dut.again_q , \u_dut.s1_valid_q , \u_dut.s1_again_q ;
    (* hierconn *) wire              \u_dut.s2_valid_q , \u_dut.s2_again_q , \u_dut.s3_valid_q ;
    (* hierconn *) wire              \u_dut.s2_more_q ;
    (* hierconn *) wire [SLOTW-1:0]  \u_dut.again_slot_q , \u_dut.s1_slot_q , \u_dut.s2_slot_q ;
    (* hierconn *) wire [SLOTW-1:0]  \u_dut.s3_slot_q ;
    (* hierconn *) wire              \u_dut.push , \u_dut.keep , \u_dut.use_t , \u_dut.again ;
    (* hierconn *) wire [DW:0]       \u_dut.sp_next , \u_dut.s2_sp_q , \u_dut.s3_sp_q ;
    (* hierconn *) wire [DW-1:0]     \u_dut.push_at ;
    (* hierconn *) wire [97:0]       \u_dut.push_data , \u_dut.s2_top ;
    (* hierconn *) wire [81:0]       \u_dut.cur_next , \u_dut.s2_cur ;
    (* hierconn *) wire [2:0]        \u_dut.count ;
    (* hierconn *) wire [100:0]      \u_dut.s3_f_q , \u_dut.s3_c_q , \u_dut.s3_t_q ;
    (* hierconn *) wire [15:0]       \u_dut.s3_below_q ;
    (* hierconn *) wire              \u_dut.s3_c_any_q , \u_dut.s3_f_ok_q , \u_dut.s3_c_ok_q ;
    (* hierconn *) wire              \u_dut.s3_t_any_q ;
    (* hierconn *) wire [102:0]      \u_dut.s2_found ;
    (* hierconn *) wire [SLOTW-1:0]  \u_dut.u_found.mark , \u_dut.u_current.mark ;
    (* hierconn *) wire [SLOTW-1:0]  \u_dut.u_pointer.mark ;
    (* hierconn *) wire [SLOTW+DW-1:0] \u_dut.u_stack.mark ;
    (* hierconn *) wire [102:0]      \u_dut.u_found.word_q ;
    (* hierconn *) wire [81:0]       \u_dut.u_current.word_q ;
    (* hierconn *) wire [DW+17:0]    \u_dut.u_pointer.word_q ;
    (* hierconn *) wire [97:0]       \u_dut.u_stack.word_q ;
    always @* assume (\u_dut.u_found.mark == slot && \u_dut.u_current.mark == slot);
    always @* assume (\u_dut.u_pointer.mark == slot && \u_dut.u_stack.mark == {slot, level});

    // ---- model: tokens inside; of the marked slot the state, the stack's height, the group ----
    reg         old_q = 1'b0;
    reg [2:0]   count_q;                 // tokens inside
    reg         inside_q;                // that of the marked slot
    reg         found_q, fresh_q;        // its visit has been written; it is the ray's first
    reg         alive_q;                 // its ray goes on: there is a group and a stack
    reg [DW:0]  sp_q;                    // groups in its stack
    reg [81:0]  cur_q;                   // its current group: {base, count, list}
    reg [97:0]  group_q;                 // the group pushed at the marked level
    wire take  = in_valid && in_ready;
    wire leave = issue_valid || done_valid;
    wire mine_1 = \u_dut.s1_valid_q && \u_dut.s1_slot_q == slot;
    wire mine_2 = \u_dut.s2_valid_q && \u_dut.s2_slot_q == slot;
    wire mine  = \u_dut.s3_valid_q && \u_dut.s3_slot_q == slot;
    wire mine_a = \u_dut.again_q && \u_dut.again_slot_q == slot;
    wire out   = (issue_valid && issue_slot == slot) || (done_valid && done_slot == slot);
    reg  s3_again_q;                     // the token of stage 3 goes round once more
    wire now_2 = fresh_q && !\u_dut.s2_again_q ;     // a fresh ray has neither group nor stack
    wire now   = fresh_q && !s3_again_q;
    wire [97:0] top = {\u_dut.s3_below_q , \u_dut.s3_t_q [100:75], \u_dut.s3_t_q [73:72],
                       \u_dut.s3_t_q [53:0]};
    wire more = cur_q[55:54] != 0;       // the current group has children left, else it is not read
    wire [DW:0] sp = now ? {(DW+1){1'b0}} : sp_q;
    always @(posedge clk) begin
        old_q   <= 1'b1;
        s3_again_q <= \u_dut.s2_again_q ;
        count_q <= count_q + {2'd0, take} - {2'd0, leave};
        if (take && in_slot == slot)             inside_q <= 1'b1;
        if (out)                                 inside_q <= 1'b0;
        if (found_valid && found_slot == slot) begin
            found_q <= 1'b1;
            fresh_q <= found_fresh;
            if (found_fresh) alive_q <= 1'b0;
        end
        if (out) found_q <= 1'b0;
        if (out && done_valid) alive_q <= 1'b0;
        if (mine && \u_dut.keep ) begin
            alive_q <= 1'b1;
            sp_q  <= \u_dut.push ? sp + 1'b1 : \u_dut.use_t ? sp - 1'b1 : sp;
            cur_q <= \u_dut.cur_next ;
        end
        if (mine && \u_dut.push && sp == level) group_q <= \u_dut.push_data ;
        if (rst) begin
            count_q <= 0; inside_q <= 1'b0; found_q <= 1'b0; alive_q <= 1'b0;
        end
    end
    always @* begin
        if (!old_q) assume (rst);
        // token rule, and a slot's visit is written before its token comes
        if (in_valid && in_slot == slot) assume (found_q && !inside_q);
        if (found_valid && found_slot == slot) assume (!found_q && (found_fresh || alive_q));
        if (found_valid) assume (found_count <= 4);
        // a group has children left: asserted of the marked level, so it holds of the others too
        if (mine && \u_dut.use_t && sp != level + 1'b1) assume (top[55:54] != 0);
    end

    always @* if (old_q) begin
        // each token leaves once; none is made or lost
        assert (!(issue_valid && done_valid));
        assert (count_q == {2'd0, \u_dut.s1_valid_q } + {2'd0, \u_dut.s2_valid_q } +
                {2'd0, \u_dut.s3_valid_q } + {2'd0, \u_dut.again_q } + {2'd0, leave});
        assert (inside_q == (mine_1 || mine_2 || mine || mine_a || out));
        assert ({2'd0, mine_1} + {2'd0, mine_2} + {2'd0, mine} + {2'd0, mine_a} +
                {2'd0, out} <= 3'd1);
        assert (in_ready == !\u_dut.again_q );
        if (mine) begin
            // never over, never under; every pass more takes a group off the stack
            if (\u_dut.push )  assert (sp < DEPTH && \u_dut.push_at == sp && !\u_dut.use_t );
            if (\u_dut.again ) assert (sp > 0 && \u_dut.sp_next == sp - 1'b1 && \u_dut.use_t );
            if (\u_dut.keep && \u_dut.use_t ) assert (sp > 0);
            // a group that is kept has 1 to 4 children before its first one goes
            if (\u_dut.keep && !(\u_dut.use_t && sp != level + 1'b1))
                assert (\u_dut.count >= 1 && \u_dut.count <= 4);
            // what is put aside is the whole current group; what comes back is what was put there
            if (\u_dut.push ) assert (!now && \u_dut.push_data [81:0] == cur_q);
            if (\u_dut.push ) assert (cur_q[55:54] != 0);
            if (\u_dut.use_t && sp == level + 1'b1) assert (top == group_q);
        end
        // invariant
        if (inside_q) assert (found_q);
        if (found_q)  assert (fresh_q || alive_q);
        if (found_q) begin
            assert (\u_dut.u_found.word_q [101] == fresh_q);
            assert (\u_dut.u_found.word_q [74:72] <= 4);
        end
        if (alive_q) begin
            assert (\u_dut.u_current.word_q == cur_q && \u_dut.u_pointer.word_q [DW:0] == sp_q);
            assert (\u_dut.u_pointer.word_q [DW+17] == more);
            assert (sp_q <= DEPTH);
            if (sp_q > level) assert (\u_dut.u_stack.word_q == group_q && group_q[55:54] != 0);
        end
        if (mine_1 && \u_dut.s1_again_q ) assert (alive_q);
        if (mine_2) begin
            assert (\u_dut.s2_found == \u_dut.u_found.word_q && (now_2 || alive_q));
            if (!now_2) assert (\u_dut.s2_more_q == more && \u_dut.s2_sp_q == sp_q);
            if (!now_2 && more) assert (\u_dut.s2_cur == cur_q);
            if (!now_2 && sp_q == level + 1'b1) assert (\u_dut.s2_top == group_q);
            if (\u_dut.s2_again_q ) assert (alive_q);
        end
        if (mine) begin
            assert (\u_dut.s3_f_q [100:75] == \u_dut.u_found.word_q [100:75]);
            assert (\u_dut.s3_f_q [74:72] == (s3_again_q ? 3'd0 : \u_dut.u_found.word_q [74:72]));
            assert (\u_dut.s3_f_q [71:0] == \u_dut.u_found.word_q [71:0] && (now || alive_q));
            if (!now && more) assert (\u_dut.s3_c_q [100:75] == cur_q[81:56]);
            if (!now && more) assert (\u_dut.s3_c_q [71:0] == {18'd0, cur_q[53:0]});
            assert (\u_dut.s3_c_q [74:72] == (now || s3_again_q ? 3'd0 : {1'b0, cur_q[55:54]}));
            assert (\u_dut.s3_c_any_q == (\u_dut.s3_c_q [74:72] != 0));
            assert (!\u_dut.s3_f_ok_q || \u_dut.s3_f_q [74:72] != 0);
            assert (!\u_dut.s3_c_ok_q || \u_dut.s3_c_any_q );
            assert (!\u_dut.s3_t_any_q || \u_dut.s3_sp_q != 0);
            assert (\u_dut.s3_sp_q == sp && \u_dut.s3_t_q [74] == 1'b0);
            if (!now && sp_q == level + 1'b1) assert (top == group_q);
            if (s3_again_q) assert (alive_q);
        end
        if (mine_a) assert (alive_q);
        if (issue_valid && issue_slot == slot) assert (alive_q);
    end
endmodule
`default_nettype wire
