// rt_next.v - after a visit: push, prune, pop, and the node to visit next
// SPDX-License-Identifier: Apache-2.0
// A group = {smallest near depth of all groups below it, base, count, list} of siblings still to
// visit, near first. The current group stands in a slot file, the others in the stack: one push or
// one pop a visit, so one write and one read port serve. A group whose nearest child lies deeper
// than the ray's limit is dropped whole, and so is the stack when its smallest near depth does.
// Two stages, one token a cycle; a pruned top of stack costs one more pass (bubble_o).
// Model: the end of the loop of sph_traverse() in cmodel/trace/traverse.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_next #(
    parameter FW    = 14,   // filter coordinate, bits
    parameter SLOTS = 32,   // power of two
    parameter DEPTH = 16,   // stack entries a slot, power of two
    parameter ENDS  = 1     // 1: some rays end with a hit
) (
    input  wire             clk,
    input  wire             rst,
    // from rt_traverse: what the visit found, written before its token arrives
    input  wire             found_valid_i,
    input  wire [$clog2(SLOTS)-1:0] found_slot_i,
    input  wire [`RT_LINE_BITS-1:0] found_base_i,
    input  wire [2:0]       found_count_i,
    input  wire [71:0]      found_list_i,   // 4 x {near s16, child u2}
    input  wire             found_fresh_i,  // first visit of the ray
    input  wire             found_kill_i,   // an error ends the ray
    // tokens
    input  wire             in_valid_i,
    output wire             in_ready_o,
    input  wire [$clog2(SLOTS)-1:0] in_slot_i,
    // from rt_collect: asked in stage 0, answered in stage 1
    output wire             read_o,
    output wire [$clog2(SLOTS)-1:0] slot_o,
    input  wire [FW:0]      depth_i,        // what lies deeper does not matter
    input  wire             hit_i,          // the ray has a hit
    input  wire             ends_i,         // and ends with it
    // to rt_traverse: visit this node
    output reg              issue_valid_o,
    output reg [$clog2(SLOTS)-1:0] issue_slot_o,
    output reg [`RT_LINE_BITS-1:0] issue_line_o,
    // the ray is done
    output reg              done_valid_o,
    output reg [$clog2(SLOTS)-1:0] done_slot_o,
    output reg              bubble_o,       // counts passes for a pruned top of stack
    output reg              overflow_o      // the stack was full: the ray ends
);
    localparam SLOTW = $clog2(SLOTS);
    localparam DEPTHW = $clog2(DEPTH);
    localparam signed [15:0] FAR = 16'sh7fff;
    localparam CW = `RT_LINE_BITS + 3 + 72;            // current group: {base, count, list}
    localparam EW = 16 + `RT_LINE_BITS + 2 + 54;       // stack entry: {below, base, count, list}

    // ---- stage 0: read everything about the slot ----
    reg              again_q;               // stage 1 sent its token round once more
    reg [SLOTW-1:0]  again_slot_q, s1_slot_q;
    assign in_ready_o = !again_q;
    wire             s0_valid = again_q || in_valid_i;
    wire [SLOTW-1:0] s0_slot  = again_q ? again_slot_q : in_slot_i;
    assign read_o = s0_valid;
    assign slot_o = s0_slot;

    wire [CW+1:0]    s1_found;
    rt_slot_ram #(.WIDTH(CW+2), .SLOTS(SLOTS), .OLD(0)) u_found (
        .clk(clk), .wr_en_i(found_valid_i), .wr_addr_i(found_slot_i),
        .wr_data_i({found_kill_i, found_fresh_i, found_base_i, found_count_i, found_list_i}),
        .rd_en_i(s0_valid), .rd_addr_i(s0_slot), .rd_data_o(s1_found)
    );
    wire             keep;                  // write the slot's new state
    wire [CW-1:0]    s1_cur, cur_next;
    rt_slot_ram #(.WIDTH(CW), .SLOTS(SLOTS), .OLD(0)) u_current (
        .clk(clk), .wr_en_i(keep), .wr_addr_i(s1_slot_q), .wr_data_i(cur_next),
        .rd_en_i(s0_valid), .rd_addr_i(s0_slot), .rd_data_o(s1_cur)
    );
    wire [DEPTHW+16:0] s0_stack, stack_next; // {smallest near, entries}
    rt_slot_file #(.WIDTH(DEPTHW+17), .SLOTS(SLOTS)) u_pointer (
        .clk(clk), .wr_en_i(keep), .wr_addr_i(s1_slot_q), .wr_data_i(stack_next),
        .rd_addr_i(s0_slot), .rd_data_o(s0_stack)
    );
    wire             push;
    wire [EW-1:0]    push_data, s1_top;
    wire [DEPTHW-1:0] push_at;
    wire [DEPTHW-1:0] s0_top_at = s0_stack[DEPTHW-1:0] - 1'b1;
    rt_slot_ram #(.WIDTH(EW), .SLOTS(SLOTS*DEPTH), .OLD(0)) u_stack (
        .clk(clk), .wr_en_i(push), .wr_addr_i({s1_slot_q, push_at}), .wr_data_i(push_data),
        .rd_en_i(s0_valid), .rd_addr_i({s0_slot, s0_top_at}), .rd_data_o(s1_top)
    );

    // ---- stage 1: decide ----
    // Groups: f that the visit found, c the current one, t the top of the stack.
    reg              s1_valid_q, s1_again_q;
    wire             s1_kill, found_fresh;
    wire [`RT_LINE_BITS-1:0] f_base, c_base, t_base;
    wire [2:0]       f_found, c_left;                      // children
    wire [1:0]       t_count;
    wire [71:0]      f_list, c_list;
    wire [53:0]      t_list;
    wire signed [15:0] t_below;                            // smallest near of what lies below it
    assign {s1_kill, found_fresh, f_base, f_found, f_list} = s1_found;
    assign {c_base, c_left, c_list}                        = s1_cur;
    assign {t_below, t_base, t_count, t_list}              = s1_top;
    wire             s1_fresh = found_fresh && !s1_again_q;
    reg [DEPTHW:0]   s1_sp_q;
    reg signed [15:0] s1_least_q;
    wire [2:0]  f_count = s1_again_q ? 3'd0 : f_found;
    wire [2:0]  c_count = s1_fresh || s1_again_q ? 3'd0 : c_left;
    wire [DEPTHW:0] sp  = s1_fresh ? {(DEPTHW+1){1'b0}} : s1_sp_q;
    wire signed [15:0] least = s1_fresh ? FAR : s1_least_q;
    wire signed [15:0] depth = $signed({{(15-FW){1'b0}}, depth_i});
    wire signed [15:0] f_near = $signed(f_list[17:2]);     // of the first child of the list
    wire signed [15:0] c_near = $signed(c_list[17:2]);
    wire signed [15:0] t_near = $signed(t_list[17:2]);
    wire f_ok  = f_count != 3'd0 && f_near <= depth;
    wire c_ok  = c_count != 3'd0 && c_near <= depth;
    wire t_any = sp != 0 && least <= depth;       // the stack holds something to visit
    wire t_ok  = t_near <= depth;
    wire ended = s1_kill || (ENDS != 0 && ends_i && hit_i);

    wire use_f = f_ok;
    wire use_c = !f_ok && c_ok;
    wire use_t = !f_ok && !c_ok && t_any;
    wire full  = sp[DEPTHW];
    wire want_push = use_f && c_count != 3'd0;
    assign push      = s1_valid_q && !ended && want_push && !full;
    assign push_at   = sp[DEPTHW-1:0];
    assign push_data = {least, c_base, c_count[1:0], c_list[53:0]};

    wire [`RT_LINE_BITS-1:0] base = use_f ? f_base : use_c ? c_base : t_base;
    wire [2:0]  count = use_f ? f_count : use_c ? c_count : {1'b0, t_count};
    wire [71:0] list  = use_f ? f_list : use_c ? c_list : {18'd0, t_list};
    assign cur_next   = {base, count - 3'd1, 18'd0, list[71:18]};
    wire [DEPTHW:0] sp_next = want_push ? sp + 1'b1 : use_t ? sp - 1'b1 : sp;
    wire signed [15:0] least_next = want_push ? (c_near < least ? c_near : least)
                                    : use_t ? t_below : least;
    assign stack_next = {least_next, sp_next};
    wire go    = s1_valid_q && !ended && (use_f || use_c || (use_t && t_ok)) &&
                 !(want_push && full);
    wire again = s1_valid_q && !ended && use_t && !t_ok;
    assign keep = go || again;

    wire unused = &{1'b0, list[17:2]};

    always @(posedge clk) begin
        s1_valid_q  <= s0_valid;
        s1_again_q  <= again_q;
        s1_slot_q   <= s0_slot;
        {s1_least_q, s1_sp_q} <= s0_stack;
        again_q     <= again;
        again_slot_q <= s1_slot_q;

        issue_valid_o <= go;
        issue_slot_o  <= s1_slot_q;
        issue_line_o  <= base + {{(`RT_LINE_BITS-2){1'b0}}, list[1:0]};
        done_valid_o  <= s1_valid_q && !go && !again;
        done_slot_o   <= s1_slot_q;
        bubble_o      <= again;
        overflow_o    <= s1_valid_q && !ended && want_push && full;
        if (rst) begin
            s1_valid_q <= 1'b0; again_q <= 1'b0; issue_valid_o <= 1'b0; done_valid_o <= 1'b0;
            bubble_o <= 1'b0; overflow_o <= 1'b0;
        end
    end
endmodule
`default_nettype wire
