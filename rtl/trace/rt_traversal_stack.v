// rt_traversal_stack.v - after a visit: push, prune, pop, and the node to visit next
// SPDX-License-Identifier: Apache-2.0
// A group = {smallest near depth of all groups below it, base, count, list} of siblings still to
// visit, near first. The current group stands in a slot file, the others in the stack: one push or
// one pop a visit, so one write and one read port serve. A group whose nearest child lies deeper
// than the ray's limit is dropped whole, and so is the stack when its smallest near depth does.
//   0 choose a token, ask for its limit | 1 read its slot | 2 compare | 3 choose its group, write
// One token a cycle; a pruned top of stack costs one more pass (bubble_o).
// Model: the end of the loop of sph_traverse() in cmodel/trace/traverse.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_traversal_stack #(
    parameter FW    = 14,   // filter coordinate, bits
    parameter SLOTS = 32,   // power of two
    parameter DEPTH = 16,   // stack entries a slot, power of two
    parameter LUTS  = 0,    // LUT cells that a block RAM is worth, rt_slot_ram
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
    // from rt_closest_hit: asked in stage 0, answered in stage 1
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
    localparam CW = `RT_LINE_BITS + 3 + 72;            // a group: {base, count, list}
    localparam KW = `RT_LINE_BITS + 2 + 54;            // current one, its first child is gone
    localparam EW = 16 + `RT_LINE_BITS + 2 + 54;       // stack entry: {below, base, count, list}

    // ---- stage 0: one that goes round once more, else a new one ----
    reg              again_q;               // stage 3 sent its token round once more
    reg              s1_valid_q, s1_again_q;
    reg [SLOTW-1:0]  again_slot_q, s1_slot_q;
    assign in_ready_o = !again_q;
    assign read_o = again_q || in_valid_i;
    assign slot_o = again_q ? again_slot_q : in_slot_i;
    always @(posedge clk) begin
        s1_valid_q <= read_o;
        s1_again_q <= again_q;
        s1_slot_q  <= slot_o;
        if (rst) s1_valid_q <= 1'b0;
    end

    // ---- stage 1: read everything about the slot ----
    reg [SLOTW-1:0]  s3_slot_q;
    wire [CW+1:0]    s2_found;
    rt_slot_ram #(.WIDTH(CW+2), .SLOTS(SLOTS), .OLD(0), .LUTS(LUTS)) u_found (
        .clk(clk), .wr_en_i(found_valid_i), .wr_addr_i(found_slot_i),
        .wr_data_i({found_kill_i, found_fresh_i, found_base_i, found_count_i, found_list_i}),
        .rd_en_i(s1_valid_q), .rd_addr_i(s1_slot_q), .rd_data_o(s2_found)
    );
    wire             keep;                  // write the slot's new state
    wire [DEPTHW+17:0] s1_stack, stack_next; // {current group has more, smallest near, entries}
    rt_slot_file #(.WIDTH(DEPTHW+18), .SLOTS(SLOTS)) u_pointer (
        .clk(clk), .wr_en_i(keep), .wr_addr_i(s3_slot_q), .wr_data_i(stack_next),
        .rd_addr_i(s1_slot_q), .rd_data_o(s1_stack)
    );
    wire [KW-1:0]    s2_cur, cur_next;
    rt_slot_ram #(.WIDTH(KW), .SLOTS(SLOTS), .OLD(0), .LUTS(LUTS)) u_current (
        .clk(clk), .wr_en_i(keep), .wr_addr_i(s3_slot_q), .wr_data_i(cur_next),
        .rd_en_i(s1_valid_q && s1_stack[DEPTHW+17]), .rd_addr_i(s1_slot_q), .rd_data_o(s2_cur)
    );
    wire             push;
    wire [EW-1:0]    push_data, s2_top;
    wire [DEPTHW-1:0] push_at;
    wire [DEPTHW-1:0] s1_top_at = s1_stack[DEPTHW-1:0] - 1'b1;
    rt_slot_ram #(.WIDTH(EW), .SLOTS(SLOTS*DEPTH), .OLD(0)) u_stack (
        .clk(clk), .wr_en_i(push), .wr_addr_i({s3_slot_q, push_at}), .wr_data_i(push_data),
        .rd_en_i(s1_valid_q && s1_stack[DEPTHW:0] != 0),   // it is not empty
        .rd_addr_i({s1_slot_q, s1_top_at}), .rd_data_o(s2_top)
    );

    // ---- stage 2: compare ----
    // Groups: f that the visit found, c the current one, t the top of the stack.
    reg              s2_valid_q, s2_again_q, s2_more_q;
    reg [SLOTW-1:0]  s2_slot_q;
    reg [DEPTHW:0]   s2_sp_q;
    reg signed [15:0] s2_least_q;           // smallest near of the stack
    reg [FW:0]       s2_depth_q;
    reg              s2_ends_q;             // with the hit that it has
    wire             s2_kill, found_fresh;
    wire [`RT_LINE_BITS-1:0] f_base, c_base, t_base;
    wire [2:0]       f_found;                              // children
    wire [1:0]       c_left, t_count;
    wire [71:0]      f_list;
    wire [53:0]      c_list, t_list;
    wire signed [15:0] t_below;                            // smallest near of what lies below it
    assign {s2_kill, found_fresh, f_base, f_found, f_list} = s2_found;
    assign {c_base, c_left, c_list}                        = s2_cur;
    assign {t_below, t_base, t_count, t_list}              = s2_top;
    wire             fresh = found_fresh && !s2_again_q;
    wire [2:0]  f_count = s2_again_q ? 3'd0 : f_found;
    wire [1:0]  c_count = fresh || s2_again_q || !s2_more_q ? 2'd0 : c_left;
    wire [DEPTHW:0] sp  = fresh ? {(DEPTHW+1){1'b0}} : s2_sp_q;
    wire signed [15:0] depth = $signed({{(15-FW){1'b0}}, s2_depth_q});
    wire signed [15:0] f_near = $signed(f_list[17:2]);     // of the first child of the list
    wire signed [15:0] c_near = $signed(c_list[17:2]);
    wire signed [15:0] t_near = $signed(t_list[17:2]);
    reg              s3_valid_q, s3_ended_q, s3_f_ok_q, s3_c_ok_q, s3_c_any_q, s3_t_any_q;
    reg              s3_t_ok_q, s3_c_least_q;
    reg [DEPTHW:0]   s3_sp_q;
    reg signed [15:0] s3_least_q, s3_below_q;
    reg [CW-1:0]     s3_f_q, s3_c_q, s3_t_q;               // groups: {base, count, list}
    always @(posedge clk) begin
        s2_valid_q <= s1_valid_q;
        s2_again_q <= s1_again_q;
        s2_slot_q  <= s1_slot_q;
        if (s1_valid_q) begin
            {s2_more_q, s2_least_q, s2_sp_q} <= s1_stack;
            s2_depth_q <= depth_i;
        end
        s2_ends_q  <= ENDS != 0 && ends_i && hit_i;

        s3_valid_q <= s2_valid_q;
        s3_slot_q  <= s2_slot_q;
        if (s2_valid_q) begin
            s3_sp_q    <= sp;
            s3_least_q <= fresh ? FAR : s2_least_q;
            s3_below_q <= t_below;
            s3_f_q     <= {f_base, f_count, f_list};
            s3_c_q     <= {c_base, 1'b0, c_count, 18'd0, c_list};
            s3_t_q     <= {t_base, 1'b0, t_count, 18'd0, t_list};
            s3_ended_q <= s2_kill || s2_ends_q;
            s3_f_ok_q  <= f_count != 3'd0 && f_near <= depth;
            s3_c_ok_q  <= c_count != 2'd0 && c_near <= depth;
            s3_c_any_q <= c_count != 2'd0;
            s3_t_any_q <= sp != 0 && s2_least_q <= depth;      // the stack holds something to visit
            s3_t_ok_q  <= t_near <= depth;
            s3_c_least_q <= fresh || c_near < s2_least_q;      // the current one is nearer than it
        end
        if (rst) begin s2_valid_q <= 1'b0; s3_valid_q <= 1'b0; end
    end

    // ---- stage 3: choose ----
    wire use_f = s3_f_ok_q;
    wire use_c = !s3_f_ok_q && s3_c_ok_q;
    wire use_t = !s3_f_ok_q && !s3_c_ok_q && s3_t_any_q;
    wire full  = s3_sp_q[DEPTHW];
    wire want_push = use_f && s3_c_any_q;
    wire signed [15:0] c_first = $signed(s3_c_q[17:2]);    // near of its first child
    assign push      = s3_valid_q && !s3_ended_q && want_push && !full;
    assign push_at   = s3_sp_q[DEPTHW-1:0];
    assign push_data = {s3_least_q, s3_c_q[CW-1 -: `RT_LINE_BITS], s3_c_q[73:72], s3_c_q[53:0]};
    wire [CW-1:0] group = use_f ? s3_f_q : use_c ? s3_c_q : s3_t_q;
    wire [`RT_LINE_BITS-1:0] base;
    wire [2:0]    count;
    wire [71:0]   list;
    assign {base, count, list} = group;
    wire [1:0]    left = count[1:0] - 2'd1;              // of 1 to 4
    assign cur_next   = {base, left, list[71:18]};
    wire [DEPTHW:0] sp_next = want_push ? s3_sp_q + 1'b1 : use_t ? s3_sp_q - 1'b1 : s3_sp_q;
    wire signed [15:0] least_next = want_push ? (s3_c_least_q ? c_first : s3_least_q)
                                    : use_t ? s3_below_q : s3_least_q;
    assign stack_next = {left != 2'd0, least_next, sp_next};
    wire go    = s3_valid_q && !s3_ended_q && (use_f || use_c || (use_t && s3_t_ok_q)) &&
                 !(want_push && full);
    wire again = s3_valid_q && !s3_ended_q && use_t && !s3_t_ok_q;
    assign keep = go || again;

    wire unused = &{1'b0, list[17:2], count[2]};

    always @(posedge clk) begin
        again_q      <= again;
        again_slot_q <= s3_slot_q;

        issue_valid_o <= go;
        issue_slot_o  <= s3_slot_q;
        if (s3_valid_q) issue_line_o <= base + {{(`RT_LINE_BITS-2){1'b0}}, list[1:0]};
        done_valid_o  <= s3_valid_q && !go && !again;
        done_slot_o   <= s3_slot_q;
        bubble_o      <= again;
        overflow_o    <= s3_valid_q && !s3_ended_q && want_push && full;
        if (rst) begin
            again_q <= 1'b0; issue_valid_o <= 1'b0; done_valid_o <= 1'b0;
            bubble_o <= 1'b0; overflow_o <= 1'b0;
        end
    end
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_next_nodes /* verilator public_flat_rd */ =
        {in_valid_i && !in_ready_o, in_valid_i && in_ready_o, 5'd0, read_o};
endmodule
`default_nettype wire
