// rt_bih_stack.v - what a ray does next in a BIH: child, leaf records, put aside, done
// SPDX-License-Identifier: Apache-2.0
// A token is a pass of rt_bih_step, which cannot wait, or a ray that popped a node behind its hit
// and tries once more, or a ray whose leaf records have been tested. Three stages take a token a
// clock: the first reads all about the slot, the second compares, the third decides. An interval
// {hi, lo} bounds where along the ray the node lies that the ray is at.
// Model: sph_bih_walk() in cmodel/trace/bih_walk.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bih.vh"
module rt_bih_stack #(
    parameter SLOTS = 32,   // power of two
    parameter DEPTH = `RT_BIH_STACK,  // stack entries a slot, power of two
    parameter ENDS  = 1,    // 1: some rays end with a hit
    parameter FACETS = 0,   // 1: a leaf record may have a whole line
    parameter TW    = `RT_BIH_T  // not to be set: bits of a bound
) (
    input  wire             clk,
    input  wire             rst,
    // registers
    input  wire             facets_on_i,
    input  wire [`RT_LINE_BITS-1:0] root_i,
    input  wire [`RT_LINE_BITS-1:0] leaf_base_i,
    input  wire [`RT_ID_BITS-1:0] n_loose_i,
    // from rt_bih_box: where along the ray the global box lies, before the ray starts
    input  wire             box_valid_i,
    input  wire [$clog2(SLOTS)-1:0] box_slot_i,
    input  wire [2*TW-1:0]  box_span_i,     // {hi, lo}, lo > hi: nowhere
    // from rt_bih: what the node says, before its pass comes
    input  wire             node_valid_i,
    input  wire [$clog2(SLOTS)-1:0] node_slot_i,
    input  wire [2*`RT_ID_BITS-1:0] node_i, // inner: line of the children; leaf: {count, first}
    // a pass, and two clocks later what rt_bih_step makes of it
    input  wire             pass_valid_i,
    input  wire [$clog2(SLOTS)-1:0] pass_slot_i,
    input  wire [2:0]       pass_kind_i,    // rt_bih.vh
    input  wire             step_back_i,
    input  wire             step_near_i,
    input  wire             step_far_i,
    input  wire [TW-1:0]    step_upper_i,
    input  wire [TW-1:0]    step_lower_i,
    // from rt_closest_hit: the records of a chunk are tested; asked in stage 0, answered in stage 1
    input  wire             tested_valid_i,
    input  wire [$clog2(SLOTS)-1:0] tested_slot_i,
    output wire             read_o,
    output wire [$clog2(SLOTS)-1:0] slot_o,
    input  wire [TW-1:0]    limit_i,        // what begins later does not matter
    input  wire             hit_i,          // the ray has a hit
    input  wire             ends_i,         // and ends with it
    // to rt_bih: visit this node
    output reg              issue_valid_o,
    output reg [$clog2(SLOTS)-1:0] issue_slot_o,
    output reg [`RT_LINE_BITS:0] issue_place_o,  // {line, half}
    // to rt_leaf_unit and rt_closest_hit: a chunk of leaf records
    output reg              leaf_valid_o,
    output reg [$clog2(SLOTS)-1:0] leaf_slot_o,
    output reg [3:0]        leaf_mask_o,    // bit j: record j from the start of the line
    output reg [2:0]        leaf_count_o,
    output reg [`RT_LINE_BITS-1:0] leaf_line_o,
    // the ray is done
    output reg              done_valid_o,
    output reg [$clog2(SLOTS)-1:0] done_slot_o,
    output reg              bubble_o,       // counts nodes popped behind the hit
    output reg              overflow_o      // the stack was full: the ray ends
);
    localparam SLOTW = $clog2(SLOTS);
    localparam SPW = $clog2(DEPTH);
    localparam IB  = `RT_ID_BITS;           // number or count of leaf records
    localparam LB  = `RT_LINE_BITS;
    localparam EW  = LB + 1 + 2*TW;           // stack entry: {place, hi, lo}
    wire       whole = FACETS != 0 && facets_on_i;

    // ---- which token is next ----
    wire             again, again_valid, again_in, tested_valid, tested_in;
    wire [SLOTW-1:0] again_slot, tested_slot;
    reg              s1_valid_q, s1_again_q, s1_tested_q;
    reg [SLOTW-1:0]  s1_slot_q;
    reg [2:0]        s1_kind_q;
    reg              s2_valid_q, s2_again_q, s2_tested_q;
    reg [SLOTW-1:0]  s2_slot_q;
    reg [2:0]        s2_kind_q;
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_again (
        .clk(clk), .rst(rst), .in_valid_i(again), .in_ready_o(again_in), .in_data_i(s2_slot_q),
        .out_valid_o(again_valid), .out_ready_i(!pass_valid_i), .out_data_o(again_slot)
    );
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_tested (
        .clk(clk), .rst(rst), .in_valid_i(tested_valid_i), .in_ready_o(tested_in),
        .in_data_i(tested_slot_i),
        .out_valid_o(tested_valid), .out_ready_i(!pass_valid_i && !again_valid),
        .out_data_o(tested_slot)
    );
    reg              s0_valid_q, s0_pass_q, s0_again_q;
    reg [SLOTW-1:0]  s0_slot_q;
    reg [2:0]        s0_kind_q;
    assign read_o = s0_valid_q;
    assign slot_o = s0_slot_q;
    always @(posedge clk) begin
        s0_valid_q  <= pass_valid_i || again_valid || tested_valid;
        s0_pass_q   <= pass_valid_i;
        s0_again_q  <= !pass_valid_i && again_valid;
        s0_slot_q   <= pass_valid_i ? pass_slot_i : again_valid ? again_slot : tested_slot;
        s0_kind_q   <= pass_kind_i;
        s1_valid_q  <= s0_valid_q;
        s1_again_q  <= s0_again_q;
        s1_tested_q <= !s0_pass_q && !s0_again_q;
        s1_slot_q   <= s0_slot_q;
        s1_kind_q   <= s0_kind_q;
        if (rst) begin s0_valid_q <= 1'b0; s1_valid_q <= 1'b0; end
    end

    // ---- stage 0: read everything about its slot ----
    wire [2*IB-1:0]  node;
    rt_slot_ram #(.WIDTH(2*IB), .SLOTS(SLOTS), .OLD(0)) u_node (
        .clk(clk), .wr_en_i(node_valid_i), .wr_addr_i(node_slot_i), .wr_data_i(node_i),
        .rd_en_i(s0_pass_q), .rd_addr_i(s0_slot_q), .rd_data_o(node)
    );
    wire             span_wr, chunk, keep, push;
    wire [2*TW-1:0]  span, span_next;       // {hi, lo}
    rt_slot_ram #(.WIDTH(2*TW), .SLOTS(SLOTS), .OLD(0)) u_span (
        .clk(clk), .wr_en_i(span_wr), .wr_addr_i(s2_slot_q), .wr_data_i(span_next),
        .rd_en_i(s0_pass_q), .rd_addr_i(s0_slot_q), .rd_data_o(span)
    );
    wire [2*TW-1:0]  box;                   // {hi, lo}
    rt_slot_ram #(.WIDTH(2*TW), .SLOTS(SLOTS), .OLD(0)) u_box (
        .clk(clk), .wr_en_i(box_valid_i), .wr_addr_i(box_slot_i), .wr_data_i(box_span_i),
        .rd_en_i(s0_valid_q), .rd_addr_i(s0_slot_q), .rd_data_o(box)
    );
    wire [2*IB-1:0]  chunk_rest, chunk_next;  // leaf records still to test: {count, first}
    rt_slot_ram #(.WIDTH(2*IB), .SLOTS(SLOTS), .OLD(0)) u_chunk (
        .clk(clk), .wr_en_i(chunk), .wr_addr_i(s2_slot_q), .wr_data_i(chunk_next),
        .rd_en_i(s0_valid_q), .rd_addr_i(s0_slot_q), .rd_data_o(chunk_rest)
    );
    wire [SPW+1:0]   s0_state, state_next;  // {records of no node, stack entries}
    reg [SPW+1:0]    s1_state_q, s2_state_q;
    rt_slot_file #(.WIDTH(SPW+2), .SLOTS(SLOTS)) u_state (
        .clk(clk), .wr_en_i(keep), .wr_addr_i(s2_slot_q), .wr_data_i(state_next),
        .rd_addr_i(s0_slot_q), .rd_data_o(s0_state)
    );
    always @(posedge clk) s1_state_q <= s0_state;
    wire [EW-1:0]    top, push_data;
    wire [SPW-1:0]   s0_top_at = s0_state[SPW-1:0] - 1'b1;
    rt_slot_ram #(.WIDTH(EW), .SLOTS(SLOTS*DEPTH), .OLD(0)) u_stack (
        .clk(clk), .wr_en_i(push), .wr_addr_i({s2_slot_q, s2_state_q[SPW-1:0]}),
        .wr_data_i(push_data),
        .rd_en_i(s0_valid_q), .rd_addr_i({s0_slot_q, s0_top_at}), .rd_data_o(top)
    );

    // ---- stage 1: children ----
    wire s1_pass  = !s1_again_q && !s1_tested_q;
    wire [TW-1:0] lo = span[TW-1:0], hi = span[2*TW-1:TW];
    wire [TW-1:0] box_lo = box[TW-1:0], box_hi = box[2*TW-1:TW];
    reg           back_q, near_q, far_q;
    reg           overlap_q;                        // something lies between the planes
    reg           top_counts_q;                     // the top of the stack is not behind the hit
    reg  [TW-1:0] lo_q, hi_q, later_q, earlier_q;
    reg           inside_q;                         // the ray meets the box, not behind the hit
    reg  [2*TW-1:0] box_q;
    reg           s2_ended_q;
    reg  [EW-1:0] top_q;
    reg  [LB-1:0] child_q;                          // line of the children
    always @(posedge clk) begin
        s2_valid_q   <= s1_valid_q && !rst;
        s2_again_q   <= s1_again_q;
        s2_tested_q  <= s1_tested_q;
        s2_slot_q    <= s1_slot_q;
        s2_kind_q    <= s1_kind_q;
        s2_state_q   <= s1_state_q;
        s2_ended_q   <= ENDS != 0 && ends_i && hit_i;
        back_q       <= step_back_i;
        near_q       <= step_near_i && lo <= step_upper_i;
        far_q        <= step_far_i && step_lower_i <= hi && step_lower_i <= limit_i;
        overlap_q    <= step_lower_i <= step_upper_i;
        later_q      <= step_lower_i > lo ? step_lower_i : lo;
        earlier_q    <= step_upper_i < hi ? step_upper_i : hi;
        {hi_q, lo_q} <= {hi, lo};
        inside_q     <= box_lo <= box_hi && box_lo <= limit_i;
        box_q        <= box;
        top_q        <= top;
        top_counts_q <= top[TW-1:0] <= limit_i;
        child_q      <= node[LB-1:0];
    end

    // ---- stage 1: leaf records, up to four of two lines ----
    wire            s1_leave = s1_pass && s1_kind_q == `RT_BIH_LEAVE;
    wire            s1_start = s1_pass && s1_kind_q == `RT_BIH_START;
    wire [IB-1:0]   leaf_first, leaf_count, rest_first, rest_count;
    assign {leaf_count, leaf_first} = node;
    assign {rest_count, rest_first} = chunk_rest;
    reg  [IB-1:0]   first_q, count_q;
    always @(posedge clk) begin
        first_q <= s1_start ? {IB{1'b0}} : s1_leave ? leaf_first : rest_first;
        count_q <= s1_start ? n_loose_i : s1_leave ? leaf_count : rest_count;
    end

    // ---- stage 2: what is it? ----
    wire pass  = s2_valid_q && !s2_again_q && !s2_tested_q;
    wire inner = pass && s2_kind_q == `RT_BIH_INNER;
    wire fit   = pass && s2_kind_q == `RT_BIH_FIT;
    wire leave = pass && s2_kind_q == `RT_BIH_LEAVE;
    wire start = pass && s2_kind_q == `RT_BIH_START;
    wire [SPW:0] sp = s2_state_q[SPW:0];
    wire loose = s2_state_q[SPW+1];
    wire ended = (pass && s2_kind_q == `RT_BIH_KILL) || s2_ended_q;
    wire both  = near_q && far_q && overlap_q;

    // ---- stage 2: the records that are tested now ----
    wire        odd   = !whole && first_q[0];                 // begins with the second of a line
    wire [2:0]  room  = odd ? 3'd3 : 3'd4;
    wire        fits  = count_q <= {{(IB-3){1'b0}}, room};
    wire [2:0]  n     = fits ? count_q[2:0] : room;
    wire [3:0]  ones  = ~(4'hf << n);
    wire        some  = count_q != {IB{1'b0}};
    assign chunk      = (leave || start || (s2_valid_q && s2_tested_q)) && some && !ended;
    assign chunk_next = {fits ? {IB{1'b0}} : count_q - {{(IB-3){1'b0}}, room},
                         first_q + {{(IB-3){1'b0}}, room}};

    // ---- what next? ----
    wire finished = s2_valid_q && s2_tested_q && !some;       // all records of a leaf
    wire pop      = s2_again_q || (finished && !loose) || (leave && !some) ||
                    (inner && !near_q && !far_q) || (fit && !both);
    wire down     = (inner && (near_q || far_q)) || (fit && both);
    wire full     = sp[SPW];
    wire aside    = inner && near_q && far_q;
    wire to_root  = ((finished && loose) || (start && !some)) && inside_q;
    wire to_top   = s2_valid_q && pop && sp != 0 && top_counts_q;
    wire go       = !ended && ((down && !(aside && full)) || to_root || to_top);
    assign again  = s2_valid_q && !ended && pop && sp != 0 && !to_top;
    assign keep   = go || again || chunk;
    assign push   = aside && !full && !ended;

    // The left child stands in half 0: the near one unless the ray runs back.
    wire half     = fit ? 1'b0 : near_q ? back_q : !back_q;
    assign push_data  = {child_q, !back_q, hi_q, later_q};
    assign span_wr    = go;
    assign span_next  = to_root ? box_q : pop ? top_q[2*TW-1:0]
                        : {inner && !near_q ? hi_q : earlier_q, inner && near_q ? lo_q : later_q};
    assign state_next = {(start || loose) && chunk,
                         start ? {(SPW+1){1'b0}} : push ? sp + 1'b1 : pop ? sp - 1'b1 : sp};
    always @(posedge clk) begin
        issue_valid_o <= go;
        issue_slot_o  <= s2_slot_q;
        issue_place_o <= to_root ? {root_i, 1'b0} : pop ? top_q[EW-1 -: LB+1] : {child_q, half};
        leaf_valid_o  <= chunk;
        leaf_slot_o   <= s2_slot_q;
        leaf_mask_o   <= odd ? {ones[2:0], 1'b0} : ones;
        leaf_count_o  <= n;
        leaf_line_o   <= leaf_base_i + (whole ? {{(LB-IB){1'b0}}, first_q}
                                        : {{(LB-IB+1){1'b0}}, first_q[IB-1:1]});
        done_valid_o  <= s2_valid_q && !keep;
        done_slot_o   <= s2_slot_q;
        bubble_o      <= again;
        overflow_o    <= aside && full && !ended;
        if (rst) begin
            issue_valid_o <= 1'b0; leaf_valid_o <= 1'b0;
            done_valid_o <= 1'b0; bubble_o <= 1'b0; overflow_o <= 1'b0;
        end
    end
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_next_nodes /* verilator public_flat_rd */ =
        {pass_valid_i && (again_valid || tested_valid), s0_valid_q, 5'd0, s0_valid_q};
    wire unused = &{1'b0, facets_on_i, again_in, tested_in};
endmodule
`default_nettype wire
