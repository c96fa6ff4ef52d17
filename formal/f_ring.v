// f_ring.v - proof of the token rule on queues and the real rt_traversal_stack: none overflows
// SPDX-License-Identifier: Apache-2.0
//   launch -> [new queue] --+--> [rest: waits] --> rt_traversal_stack --+--> done: slot is idle
//             [next queue] -+                                           +--> issue -> next queue
// SLOTS tokens, one a slot, and queues of SLOTS words (rt_traverse has the same two). What a queue
// gives it was given (f_fifo.v). The queue in the middle stands for caches, filters and leaves: it
// holds a token as long as it likes.
`timescale 1ns / 1ps
`default_nettype none
module f_ring #(
    parameter SLOTS = 8,
    parameter SLOTW = 3,
    parameter FW    = 4,
    parameter DEPTH = 4
) (
    input wire             clk,
    input wire             rst,
    input wire             launch, issue_now, rest_now,  // when they like
    input wire [SLOTW-1:0] launch_slot,
    input wire             found_valid, found_fresh, found_kill, hit, ends,
    input wire [SLOTW-1:0] found_slot,
    input wire [25:0]      found_base,
    input wire [2:0]       found_count,
    input wire [71:0]      found_list,
    input wire [FW:0]      depth
);
    (* anyconst *) wire [SLOTW-1:0] slot;                // any one
    wire new_room, next_room, rest_room, new_valid, next_valid, rest_valid, next_ready;
    wire [SLOTW-1:0] new_slot, next_slot, rest_slot;
    wire issue_valid, done_valid, read, bubble, overflow;
    wire [SLOTW-1:0] issue_slot, done_slot, read_slot;
    wire [25:0] issue_line;
    reg [SLOTW:0] idle_q;                                // slots without a token
    wire start    = launch && idle_q != 0;
    wire take     = issue_now && (next_valid || new_valid);      // rays under way go first
    wire take_new = issue_now && !next_valid;
    wire [SLOTW-1:0] take_slot = next_valid ? next_slot : new_slot;
    wire to_next  = rest_now && rest_valid;
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_new (
        .clk(clk), .rst(rst), .in_valid_i(start), .in_ready_o(new_room), .in_data_i(launch_slot),
        .out_valid_o(new_valid), .out_ready_i(take_new), .out_data_o(new_slot)
    );
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_next (
        .clk(clk), .rst(rst), .in_valid_i(issue_valid), .in_ready_o(next_room),
        .in_data_i(issue_slot),
        .out_valid_o(next_valid), .out_ready_i(issue_now), .out_data_o(next_slot)
    );
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_rest (
        .clk(clk), .rst(rst), .in_valid_i(take), .in_ready_o(rest_room), .in_data_i(take_slot),
        .out_valid_o(rest_valid), .out_ready_i(rest_now && next_ready), .out_data_o(rest_slot)
    );
    rt_traversal_stack #(.FW(FW), .SLOTS(SLOTS), .DEPTH(DEPTH)) u_dut (
        .clk(clk), .rst(rst), .found_valid_i(found_valid), .found_slot_i(found_slot),
        .found_base_i(found_base), .found_count_i(found_count), .found_list_i(found_list),
        .found_fresh_i(found_fresh), .found_kill_i(found_kill),
        .in_valid_i(to_next), .in_ready_o(next_ready), .in_slot_i(rest_slot),
        .read_o(read), .slot_o(read_slot), .depth_i(depth), .hit_i(hit), .ends_i(ends),
        .issue_valid_o(issue_valid), .issue_slot_o(issue_slot), .issue_line_o(issue_line),
        .done_valid_o(done_valid), .done_slot_o(done_slot), .bubble_o(bubble),
        .overflow_o(overflow)
    );
    (* hierconn *) wire [SLOTW:0] \u_new.wr_q , \u_new.rd_q , \u_next.wr_q , \u_next.rd_q ;
    (* hierconn *) wire [SLOTW:0] \u_rest.wr_q , \u_rest.rd_q ;
    (* hierconn *) wire \u_new.some_q , \u_new.room_q , \u_next.some_q , \u_next.room_q ;
    (* hierconn *) wire \u_rest.some_q , \u_rest.room_q ;
    (* hierconn *) wire \u_dut.again_q , \u_dut.s1_valid_q , \u_dut.s2_valid_q , \u_dut.s3_valid_q ;
    (* hierconn *) wire [SLOTW-1:0] \u_dut.u_found.mark , \u_dut.u_current.mark ;
    (* hierconn *) wire [SLOTW+$clog2(DEPTH)-1:0] \u_dut.u_stack.mark ;
    (* hierconn *) wire [SLOTW-1:0] \u_dut.again_slot_q , \u_dut.s1_slot_q , \u_dut.s2_slot_q ;
    (* hierconn *) wire [SLOTW-1:0] \u_dut.s3_slot_q ;

    // ---- model: idle slots; where the token of the chosen slot is ----
    reg  old_q = 1'b0, idle_mine_q, new_mine_q, next_mine_q, rest_mine_q;
    wire start_mine = start && launch_slot == slot;
    wire take_mine  = take && take_slot == slot;
    wire give_mine  = to_next && next_ready && rest_slot == slot;
    wire issue_mine = issue_valid && issue_slot == slot;
    wire done_mine  = done_valid && done_slot == slot;
    wire again_mine = \u_dut.again_q && \u_dut.again_slot_q == slot;
    wire s1_mine    = \u_dut.s1_valid_q && \u_dut.s1_slot_q == slot;
    wire s2_mine    = \u_dut.s2_valid_q && \u_dut.s2_slot_q == slot;
    wire s3_mine    = \u_dut.s3_valid_q && \u_dut.s3_slot_q == slot;
    always @(posedge clk) begin
        old_q  <= 1'b1;
        idle_q <= idle_q + done_valid - start;
        idle_mine_q <= (idle_mine_q && !start_mine) || done_mine;
        new_mine_q  <= (new_mine_q && !(take_mine && !next_valid)) || start_mine;
        next_mine_q <= (next_mine_q && !(take_mine && next_valid)) || issue_mine;
        rest_mine_q <= (rest_mine_q && !give_mine) || take_mine;
        if (rst) begin
            idle_q <= SLOTS;
            {idle_mine_q, new_mine_q, next_mine_q, rest_mine_q} <= 4'b1000;
        end
    end
    always @* begin
        if (!old_q) assume (rst);
        if (start) assume (launch_slot != slot || idle_mine_q);          // an idle slot
        // what a visit found is written while its token waits for rt_traversal_stack
        if (found_valid && found_slot == slot) assume (rest_mine_q && !give_mine);
        assume (\u_dut.u_found.mark == slot && \u_dut.u_current.mark == slot);
        assume (\u_dut.u_stack.mark >> $clog2(DEPTH) == slot);
        // f_fifo.v: a queue gives what it holds
        if (new_valid && new_slot == slot)   assume (new_mine_q);
        if (next_valid && next_slot == slot) assume (next_mine_q);
        if (rest_valid && rest_slot == slot) assume (rest_mine_q);
    end

    wire [SLOTW:0] n_new  = \u_new.wr_q - \u_new.rd_q , n_next = \u_next.wr_q - \u_next.rd_q ;
    wire [SLOTW:0] n_rest = \u_rest.wr_q - \u_rest.rd_q ;
    wire [SLOTW+2:0] all = {2'd0, idle_q} + {2'd0, n_new} + {2'd0, n_next} + {2'd0, n_rest} +
                           \u_dut.again_q + \u_dut.s1_valid_q + \u_dut.s2_valid_q +
                           \u_dut.s3_valid_q + issue_valid + done_valid;
    always @* if (old_q) begin
        // no push into a full queue
        if (start)       assert (new_room);
        if (issue_valid) assert (next_room);
        if (take)        assert (rest_room);
        // what f_traversal_stack.v assumes: no second token of a slot
        if (to_next && rest_slot == slot)
            assert (!again_mine && !s1_mine && !s2_mine && !s3_mine && !issue_mine && !done_mine);
        // f_fifo.v: flags of a queue
        assert (\u_new.some_q == (n_new != 0) && \u_new.room_q == (n_new != SLOTS));
        assert (\u_next.some_q == (n_next != 0) && \u_next.room_q == (n_next != SLOTS));
        assert (\u_rest.some_q == (n_rest != 0) && \u_rest.room_q == (n_rest != SLOTS));
        // tokens: as many as slots, each slot's in one place
        assert (all == SLOTS);
        assert (n_new <= SLOTS && n_next <= SLOTS && n_rest <= SLOTS && idle_q <= SLOTS);
        assert (idle_mine_q + new_mine_q + next_mine_q + rest_mine_q + again_mine + s1_mine +
                s2_mine + s3_mine + issue_mine + done_mine == 4'd1);
        // something moves: an idle slot can start, a waiting token be taken or given on
        if (idle_q != 0 && launch)                    assert (start && new_room);
        if ((n_new != 0 || n_next != 0) && issue_now) assert (take && rest_room);
        if (n_rest != 0 && rest_now)                  assert (next_ready || \u_dut.again_q );
    end
endmodule
`default_nettype wire
