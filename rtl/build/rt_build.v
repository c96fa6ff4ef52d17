// rt_build.v - builds the tree of a scene of spheres: primitive records to nodes and leaf records
// SPDX-License-Identifier: Apache-2.0
//   records --> keys --> rt_build_sort --> rt_build_join -->  rt_build_nodes --> rt_build_bound
//                              `--> rt_build_groups --^                              v
//                                                                          nodes, leaf records
// One phase after another, but nodes, their spheres and writing, which go on together. Nothing is
// written before all records are read and found sound, so that a tree of before stays whole if one
// is not, and stays as it is if root_i stands elsewhere. A refit goes from reading to nodes: order
// and binary tree lie where the build before left them.
// Model: sph_bt_words() in cmodel/build/words.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
`include "rt_layout.vh"
module rt_build #(
    parameter W     = 16,                    // coordinate, bits: 8 to 24
    parameter FW    = 14,                    // filter coordinate, bits: 6 to 14, at most W
    parameter COUNT = 4096                   // spheres at most, a power of two, 16 to 65536
) (
    input  wire          clk,
    input  wire          rst,                // synchronous, active high
    // what is wanted; stays as it is while busy_o is high
    input  wire          start_i,            // while busy_o is low
    input  wire [1:0]    mode_i,             // RT_BUILD_CURVE, _PAPER, _REFIT
    input  wire [1:0]    rounds_i,           // of CURVE: rounds of joining that follow the first
    input  wire [`RT_ID_BITS-1:0] count_i,   // spheres
    input  wire [`RT_LINE_BITS-1:0] prim_base_i, // line of the record of sphere 0
    input  wire [`RT_LINE_BITS-1:0] root_i,  // line of the root, nodes and leaf records follow
    input  wire [`RT_LINE_BITS-1:0] lines_i, // that they may take
    // what became of it
    output wire          busy_o,
    output reg           done_o,             // one clock
    output reg  [4:0]    error_o,            // until the next start: mode, bus, record, room, many
    output reg  [`RT_LINE_BITS-1:0] written_o, // lines from the root's on
    // lines that are read come in their order; each is taken at once
    output wire          req_valid_o,
    input  wire          req_ready_i,
    output wire [`RT_LINE_BITS-1:0] req_line_o,
    input  wire          rsp_valid_i,
    input  wire [255:0]  rsp_data_i,
    input  wire          rsp_error_i,
    // lines that are written
    output wire          wr_valid_o,
    input  wire          wr_ready_i,
    output wire [`RT_LINE_BITS-1:0] wr_line_o,
    output wire [255:0]  wr_data_o,
    input  wire          wr_idle_i,          // all that was taken is in memory
    input  wire          wr_error_i          // and some of it was refused: one clock
);
    localparam AB   = $clog2(COUNT);
    localparam LB   = AB + 2;                // bits of a line, from the root's
    localparam SW   = AB > `RT_BUILD_SIDE ? AB : `RT_BUILD_SIDE; // bits of a size
    localparam ADDR = `RT_LINE_BITS;
    localparam AXIS = `RT_BUILD_AXIS;
    `RT_CHECK(W >= 8 && W <= 24, rt_build_W_must_be_8_to_24)
    `RT_CHECK(FW >= 6 && FW <= 14 && FW <= W, rt_build_FW_must_be_6_to_14_and_at_most_W)
    `RT_CHECK(COUNT == 1 << AB && AB >= 4 && AB <= 16,
              rt_build_COUNT_must_be_a_power_of_two_of_16_to_65536)

    localparam [2:0] IDLE = 3'd0, READ = 3'd1, SCALE = 3'd2, KEYS = 3'd3, SORT = 3'd4,
                     JOIN = 3'd5, NODES = 3'd6, END = 3'd7;
    reg  [2:0]    state_q;
    wire          reading = state_q == READ;
    wire          keying  = state_q == KEYS;
    wire [AB:0]   count   = count_i[AB:0];
    wire          many    = |(count_i >> AB) && count_i != COUNT[`RT_ID_BITS-1:0];
    wire [`RT_ID_BITS+1:0] need = count_i == 0 ? 1 : {1'b0, count_i, 1'b0};
    // what is kept of the build before, and which it was
    reg           kept_q, paper_q;
    reg  [AB:0]   kept_count_q;
    wire          refit   = mode_i == `RT_BUILD_REFIT;
    wire          other   = &mode_i || (refit && !(kept_q && kept_count_q == count));
    wire          tight   = {{(`RT_ID_BITS){1'b0}}, lines_i} < {{(ADDR-2){1'b0}}, need};
    assign busy_o = state_q != IDLE;

    // ---- records ----
    reg  [AB:0]   asked_q, came_q;
    reg           line_q;                    // a line came in the last clock
    reg           void_q;                    // with an error
    reg  [127:0]  record_q;
    assign req_valid_o = reading && asked_q != count;
    assign req_line_o  = prim_base_i + {{(ADDR-AB-1){1'b0}}, asked_q};
    wire [3*W-1:0] ctr;
    wire [2:0]    wide;                      // a coordinate of more than W bits
    wire [`RT_LEAF_RAD_BITS-1:0] rad = record_q[`RT_LEAF_RAD_LSB +: `RT_LEAF_RAD_BITS];
    wire [`RT_ID_BITS-1:0] id = {{(`RT_ID_BITS-AB-1){1'b0}}, came_q};
    wire          wrong = |wide || rad == 0 || |(rad >> W) ||
                          record_q[`RT_LEAF_ID_LSB +: `RT_LEAF_ID_BITS] != id ||
                          record_q[`RT_LEAF_CLEAR_LSB-1:`RT_LEAF_ID_LSB+`RT_LEAF_ID_BITS] != 0;
    wire          put   = reading && line_q;

    // ---- least and greatest centre ----
    reg  [4:0]    shift_q;
    reg  [W-1:0]  extents_q;
    wire [W-1:0]  extent [0:2];
    wire [3*AXIS-1:0] curve;
    wire [4*W:0]  leaf_a, leaf_b;            // clear, radius, centre z, y, x
    genvar i;
    genvar j;
    generate
        for (i = 0; i < 3; i = i + 1) begin : g_axis
            wire [23:0] field = record_q[24*i +: 24];
            assign ctr[W*i +: W] = field[W-1:0];
            assign wide[i]       = |(field ^ {{(25-W){field[W-1]}}, field[W-2:0]});
            wire signed [W-1:0] c = field[W-1:0];
            reg  signed [W-1:0] lo_q, hi_q;
            always @(posedge clk) if (put) begin
                if (came_q == 0 || c < lo_q) lo_q <= c;
                if (came_q == 0 || c > hi_q) hi_q <= c;
            end
            assign extent[i] = hi_q - lo_q;
            reg  [W-1:0]    off_q;
            always @(posedge clk) off_q <= leaf_a[W*i +: W] - lo_q;
            wire [W-1:0]    moved = off_q >> shift_q; // AXIS bits are left
            if (W > AXIS) begin : g_rest
                wire unused = &{1'b0, moved[W-1:AXIS]};
            end
            for (j = 0; j < AXIS; j = j + 1) begin : g_bit
                assign curve[3*j + 2 - i] = moved[j];
            end
        end
    endgenerate
    reg  [W-1:0]  z_q;
    reg  [3*AXIS-1:0] key_q;                 // of the paper's order: the greatest z first
    always @(posedge clk) begin
        z_q   <= leaf_a[2*W +: W];
        key_q <= paper_q ? {{(3*AXIS-W){1'b0}}, z_q[W-1], ~z_q[W-2:0]} : curve;
    end

    // ---- keys: 0 the leaf is there, 1 its distance from the least, 2 its key ----
    reg  [AB:0]   at_q;
    reg  [2:0]    keys_q;
    wire          sort_ready, sorted;
    wire          key_read = keying && sort_ready && at_q != count;
    wire [AB-1:0] id_a, id_b;
    reg  [AB-1:0] id_b_q;
    wire          join_read, a_read, b_read;
    wire [AB-1:0] join_place, a_place, b_place;
    reg  [AB:0]   copy_q;                    // places of which there is no copy yet
    wire          link, walk;
    wire [AB-1:0] link_from, link_to, walk_place, walk_id;
    rt_build_sort #(.AB(AB)) u_sort (
        .clk(clk), .rst(rst),
        .clear_i(start_i && !busy_o && !refit), .ready_o(sort_ready),
        .key_valid_i(keys_q[2]), .key_i(key_q), .sort_i(state_q == SORT), .count_i(count),
        .done_o(sorted),
        .a_en_i(join_read || a_read), .a_copy_i(paper_q ? low : a_read && |copy_q),
        .a_place_i(join_read ? join_place : a_place),
        .a_id_o(id_a),
        .b_en_i(b_read || walk), .b_place_i(walk ? walk_id : b_place), .b_id_o(id_b),
        .link_i(link), .link_from_i(link_from), .link_to_i(link_to),
        .put_i(walk), .put_place_i(walk_place), .put_id_i(walk_id)
    );
    wire [4*W:0]  leaf_in = {record_q[`RT_LEAF_CLEAR_LSB], rad[W-1:0], ctr};
    rt_slot_ram #(.WIDTH(4*W + 1), .SLOTS(COUNT), .OLD(0)) u_leaves_a (
        .clk(clk), .wr_en_i(put), .wr_addr_i(came_q[AB-1:0]), .wr_data_i(leaf_in),
        .rd_en_i(!put), .rd_addr_i(keying ? at_q[AB-1:0] : id_a), .rd_data_o(leaf_a)
    );
    // spheres of a level replace the second copy, which none of those above it reads
    wire          ball, low, upper, whole;
    wire          corner  = paper_q && !low;
    wire [4*W-1:0] ball_leaf;
    wire [AB-1:0] ball_at;
    reg  [AB-1:0] a_place_q;
    reg           a_read_q, b_read_q;
    wire          put_ball = ball && corner && !whole;
    rt_slot_ram #(.WIDTH(4*W + 1), .SLOTS(COUNT), .OLD(0)) u_leaves_b (
        .clk(clk), .wr_en_i(put || put_ball),
        .wr_addr_i(put ? came_q[AB-1:0] : ball_at), .wr_data_i(put ? leaf_in : {1'b0, ball_leaf}),
        .rd_en_i(upper ? a_read_q : b_read_q), .rd_addr_i(upper ? a_place_q : id_b),
        .rd_data_o(leaf_b)
    );

    // ---- binary tree ----
    reg           join_start_q;
    wire          joined, pair_put, pair_read;
    wire [AB-1:0] pair_to, pair_at, root;
    wire [2*AB+SW-1:0] pair_in, pair;
    wire [AB-1:0] cut;
    rt_build_join #(.W(W), .AB(AB), .SW(SW)) u_join (
        .clk(clk), .rst(rst),
        .start_i(join_start_q), .count_i(count), .rounds_i(rounds_i),
        .done_o(joined), .root_o(root),
        .read_o(join_read), .place_o(join_place), .id_i(id_a), .leaf_i(leaf_a[4*W-1:0]),
        .pair_o(pair_put), .number_o(pair_to), .pair_data_o(pair_in),
        .link_o(link), .link_from_o(link_from), .link_to_o(link_to),
        .put_o(walk), .put_place_o(walk_place), .put_id_o(walk_id), .next_i(id_b)
    );
    rt_slot_ram #(.WIDTH(2*AB + SW), .SLOTS(COUNT), .OLD(0)) u_pairs (
        .clk(clk), .wr_en_i(pair_put), .wr_addr_i(pair_to), .wr_data_i(pair_in),
        .rd_en_i(pair_read), .rd_addr_i(pair_at), .rd_data_o(pair)
    );
    rt_slot_ram #(.WIDTH(AB), .SLOTS(COUNT), .OLD(0)) u_cuts (
        .clk(clk), .wr_en_i(walk), .wr_addr_i(walk_id), .wr_data_i(walk_place),
        .rd_en_i(pair_read), .rd_addr_i(pair_at), .rd_data_o(cut)
    );

    // ---- nodes of four, spheres around their children ----
    reg           nodes_start_q;
    wire          pairs_idle, pairs_node_valid, pairs_child_valid;
    wire          groups_idle, groups_node_valid, groups_child_valid, groups_upper;
    assign upper = paper_q && groups_upper;
    wire [LB-1:0] pairs_next, groups_next;
    wire [2*LB+5:0] pairs_node, groups_node;
    wire [2*AB:0] pairs_child, groups_child;
    wire [LB-1:0] next        = paper_q ? groups_next : pairs_next;
    wire [2*LB+5:0] node_word = paper_q ? groups_node : pairs_node;
    wire [2*AB:0] child       = paper_q ? groups_child : pairs_child;
    wire [2*LB+5:0] head;
    wire          child_ready, node_room, heads, takes;
    wire          nodes_idle  = pairs_idle && groups_idle;
    wire          node_in     = pairs_node_valid || groups_node_valid;
    wire          child_valid = pairs_child_valid || groups_child_valid;
    rt_build_nodes #(.AB(AB), .SW(SW)) u_nodes (
        .clk(clk), .rst(rst),
        .start_i(nodes_start_q && !paper_q), .last_i(count_i[AB-1:0] - 1'b1), .root_i(root),
        .idle_o(pairs_idle), .next_o(pairs_next),
        .read_o(pair_read), .number_o(pair_at), .pair_i({cut, pair}),
        .node_valid_o(pairs_node_valid), .node_ready_i(node_room), .node_o(pairs_node),
        .child_valid_o(pairs_child_valid), .child_ready_i(child_ready), .child_o(pairs_child)
    );
    rt_build_groups #(.AB(AB)) u_groups (
        .clk(clk), .rst(rst),
        .start_i(nodes_start_q && paper_q), .count_i(count),
        .idle_o(groups_idle), .next_o(groups_next),
        .drained_i(!heads && !wr_valid_o), .whole_done_i(takes),
        .low_o(low), .upper_o(groups_upper), .whole_o(whole),
        .ball_i(put_ball), .ball_at_o(ball_at),
        .node_valid_o(groups_node_valid), .node_ready_i(node_room), .node_o(groups_node),
        .child_valid_o(groups_child_valid), .child_ready_i(child_ready), .child_o(groups_child)
    );
    // runs differ in length: many children may wait
    wire          run_valid, run_ready;
    wire [2*AB:0] run;
    rt_fifo #(.WIDTH(2*AB + 1), .DEPTH(128)) u_children (
        .clk(clk), .rst(rst),
        .in_valid_i(child_valid && child_ready), .in_ready_o(child_ready), .in_data_i(child),
        .out_valid_o(run_valid), .out_ready_i(run_ready), .out_data_o(run)
    );
    wire          head_take;
    rt_fifo #(.WIDTH(2*LB + 6), .DEPTH(64)) u_heads (
        .clk(clk), .rst(rst),
        .in_valid_i(node_in && node_room), .in_ready_o(node_room), .in_data_i(node_word),
        .out_valid_o(heads), .out_ready_i(head_take), .out_data_o(head)
    );
    wire          done_valid, done_take;
    wire [1:0]    done_kind;
    wire [55:0]   done_child;
    wire [4*W+AB:0] done_leaf;
    rt_build_bound #(.W(W), .FW(FW), .AB(AB)) u_bound (
        .clk(clk), .rst(rst),
        .start_i(nodes_start_q), .corner_i(corner), .whole_i(whole),
        .child_valid_i(run_valid), .child_ready_o(run_ready), .child_i(run),
        .a_read_o(a_read), .a_place_o(a_place),
        .a_leaf_i(upper ? leaf_b[4*W-1:0] : leaf_a[4*W-1:0]),
        .b_read_o(b_read), .b_place_o(b_place), .b_leaf_i(leaf_b[4*W-1:0]),
        .b_mark_i({leaf_b[4*W], id_b_q}),
        .out_valid_o(done_valid), .out_ready_i(done_take), .out_kind_o(done_kind),
        .out_child_o(done_child), .out_leaf_o(done_leaf),
        .ball_o(ball), .ball_leaf_o(ball_leaf)
    );

    // ---- a line of two leaf records, or of a node ----
    reg  [223:0]  children_q;
    reg  [1:0]    slot_q;
    reg  [255:0]  records_q;
    reg           second_q;                  // the next leaf is the second of its line
    reg  [1:0]    records_line_q;            // lines of the node's that were written
    reg           put_records_q, put_node_q; // a line waits to be written
    wire [LB-1:0] head_line   = head[0 +: LB];
    wire [LB-1:0] head_base   = head[LB +: LB];
    wire [2:0]    head_inner  = head[2*LB +: 3];
    wire [2:0]    head_leaves = head[2*LB+3 +: 3];
    wire          empty       = count == 0;
    // they stay for some clocks before the first line of theirs is written
    reg  [ADDR-1:0] head_line_q, base_q, records_at_q;
    wire [2:0]    behind      = head_inner + {1'b0, records_line_q};
    always @(posedge clk) begin
        head_line_q  <= root_i + (empty ? {ADDR{1'b0}} : {{(ADDR-LB){1'b0}}, head_line});
        base_q       <= root_i + (empty ? {{(ADDR-1){1'b0}}, 1'b1}
                                        : {{(ADDR-LB){1'b0}}, head_base});
        records_at_q <= root_i + {{(ADDR-LB){1'b0}}, head_base} + {{(ADDR-3){1'b0}}, behind};
    end
    assign done_take  = !put_records_q && !put_node_q;
    assign takes      = done_valid && done_take;
    wire [127:0]  record;
    generate
        for (i = 0; i < 3; i = i + 1) begin : g_record
            assign record[24*i +: 24] = {{(25-W){done_leaf[W*i + W - 1]}}, done_leaf[W*i +: W-1]};
        end
    endgenerate
    assign record[127:72] = {done_leaf[4*W+AB], 7'd0, {(24-AB){1'b0}}, done_leaf[4*W +: AB],
                             {(24-W){1'b0}}, done_leaf[3*W +: W]};
    assign wr_valid_o = put_records_q || put_node_q;
    assign wr_line_o  = put_records_q ? records_at_q : head_line_q;
    assign wr_data_o  = put_records_q ? records_q
                      : empty ? {6'd0, base_q, 224'd0}
                              : {head_leaves, head_inner, base_q, children_q};
    wire          wrote = wr_valid_o && wr_ready_i;
    assign head_take  = wrote && !put_records_q;

    integer n;
    always @(posedge clk) begin
        id_b_q    <= id_b;
        a_place_q <= a_place;
        a_read_q  <= a_read;
        b_read_q  <= b_read && !corner;
        line_q   <= reading && rsp_valid_i;
        void_q   <= rsp_error_i;
        record_q <= rsp_data_i[127:0];
        keys_q   <= {keys_q[1:0], key_read};
        done_o   <= 1'b0;
        join_start_q <= 1'b0;
        nodes_start_q <= 1'b0;
        if (req_valid_o && req_ready_i) asked_q <= asked_q + 1'b1;
        if (put) came_q <= came_q + 1'b1;
        if (put && void_q) error_o[3] <= 1'b1;
        if (put && !void_q && wrong) error_o[2] <= 1'b1;
        if (key_read) at_q <= at_q + 1'b1;
        if (a_read && |copy_q) copy_q <= copy_q - 1'b1;
        if (busy_o && wr_error_i) error_o[3] <= 1'b1;

        if (takes && !whole) begin
            for (n = 0; n < 4; n = n + 1)
                if (slot_q == n[1:0]) children_q[56*n +: 56] <= done_child;
            slot_q     <= slot_q + 1'b1;
            put_node_q <= done_kind[0];
            if (done_kind[1]) begin
                if (second_q) records_q[255:128] <= record;
                else records_q[127:0] <= record;
                second_q      <= !second_q;
                put_records_q <= second_q || done_kind[0];
            end
        end
        if (wrote && put_records_q) begin
            put_records_q  <= 1'b0;
            second_q       <= 1'b0;
            records_q[255:128] <= 128'd0;
            records_line_q <= records_line_q + 1'b1;
        end
        if (wrote && !put_records_q) begin
            put_node_q     <= 1'b0;
            slot_q         <= 2'd0;
            children_q     <= 224'd0;
            records_line_q <= 2'd0;
        end

        case (state_q)
            IDLE: if (start_i) begin
                state_q <= many || tight || other ? END : READ;
                error_o <= {other, 2'b00, tight, many};
                written_o <= {ADDR{1'b0}};
                asked_q <= {(AB+1){1'b0}};
                came_q  <= {(AB+1){1'b0}};
                at_q    <= {(AB+1){1'b0}};
                shift_q <= 5'd0;
            end
            READ: if (came_q == count && !line_q) begin
                extents_q     <= extent[0] | extent[1] | extent[2];
                state_q       <= |error_o ? END : count == 0 || refit ? NODES : SCALE;
                put_node_q    <= !(|error_o) && count == 0;
                nodes_start_q <= !(|error_o) && count != 0 && refit;
                if (!refit && !(|error_o)) begin
                    kept_q       <= count == 0;
                    kept_count_q <= count;
                    paper_q      <= mode_i == `RT_BUILD_PAPER;
                end
            end
            SCALE: if (|(extents_q >> AXIS)) begin
                extents_q <= extents_q >> 1;
                shift_q   <= shift_q + 1'b1;
            end else state_q <= KEYS;
            KEYS: if (at_q == count && keys_q == 3'd0 && sort_ready) state_q <= SORT;
            SORT: if (sorted) begin
                state_q       <= paper_q ? NODES : JOIN;
                join_start_q  <= !paper_q;
                nodes_start_q <= paper_q;
                kept_q        <= paper_q;
            end
            JOIN: if (joined) begin
                state_q <= NODES;
                kept_q  <= 1'b1;
                nodes_start_q <= 1'b1;
                copy_q  <= count;
            end
            NODES: if (nodes_idle && !nodes_start_q && !heads && !wr_valid_o) begin
                state_q   <= END;
                written_o <= count == 0 ? 1 : {{(ADDR-LB){1'b0}}, next};
            end
            END: if (wr_idle_i) begin
                state_q <= IDLE;
                done_o  <= 1'b1;
            end
            default: ;
        endcase
        if (rst) begin
            state_q       <= IDLE;
            kept_q        <= 1'b0;
            paper_q       <= 1'b0;
            line_q        <= 1'b0;
            keys_q        <= 3'd0;
            error_o       <= 5'd0;
            done_o        <= 1'b0;
            slot_q        <= 2'd0;
            children_q    <= 224'd0;
            second_q      <= 1'b0;
            records_q[255:128] <= 128'd0;
            records_line_q <= 2'd0;
            put_records_q <= 1'b0;
            put_node_q    <= 1'b0;
            join_start_q <= 1'b0;
            nodes_start_q <= 1'b0;
        end
    end
    wire unused = &{1'b0, rsp_data_i[255:128], leaf_a[4*W]};
endmodule
`default_nettype wire
