// rt_build_join.v - spheres that are near on a curve joined to a binary tree
// SPDX-License-Identifier: Apache-2.0
//   row of clusters --> x | 1 2 .. WINDOW before it --> distances --> the nearest of each
//        ^                                                               | two of each other
//        +------------ the row of the next pass, one for two <-----------+--> pairs, list
// A pass takes a clock a cluster and DECIDES + 6 more. All stages move every clock, what is no
// cluster as well. Position p of a cluster is how many clocks ago it became x: at NEAREST it has
// met all of its window, at DECIDES so has all of its window. What is joined stays in the place of
// the left one. When one cluster is left, the list of its spheres becomes the order, and maybe the
// row of the next round.
// Model: sph_bt_join() in cmodel/build/join.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_build_join #(
    parameter W  = 16,                       // coordinate, bits
    parameter AB = 12,                       // bits of the number of a sphere
    parameter SW = 12                        // bits of a size, at least those of a side
) (
    input  wire          clk,
    input  wire          rst,                // synchronous, active high
    // from rt_build
    input  wire          start_i,
    input  wire [AB:0]   count_i,            // spheres, at least 1
    input  wire [1:0]    rounds_i,           // it is joined again along its own order so often
    output reg           done_o,
    output wire [AB-1:0] root_o,             // number of the root's pair
    // spheres along the curve: the number a clock after the place, the sphere two
    output wire          read_o,
    output wire [AB-1:0] place_o,
    input  wire [AB-1:0] id_i,
    input  wire [4*W-1:0] leaf_i,            // radius uW, centre z, y, x sW
    // pairs to rt_build_nodes
    output reg           pair_o,
    output reg  [AB-1:0] number_o,
    output reg  [2*AB+SW-1:0] pair_data_o,   // size, right, left
    // who follows whom
    output wire          link_o,
    output wire [AB-1:0] link_from_o,
    output wire [AB-1:0] link_to_o,
    // the order: the list is read, a clock a sphere
    output wire          put_o,
    output wire [AB-1:0] put_place_o,
    output wire [AB-1:0] put_id_o,
    input  wire [AB-1:0] next_i              // who follows put_id_o, a clock later
);
    localparam BW  = W + 2;                  // bits of a side of a sphere's box, signed
    localparam SB  = BW < `RT_BUILD_SIDE ? BW : `RT_BUILD_SIDE; // of one of a cluster's
    localparam WIN = `RT_BUILD_WINDOW;       // a power of two
    localparam LOG = $clog2(WIN);
    localparam KB  = LOG + 1;                // bits of how many places on
    localparam DB  = SB + 1;                 // of a distance: there is none, longest edge
    localparam CW  = 6*SB + 3*AB;            // of a cluster: tail, head, number, box
    localparam NUMBER = 6*SB, HEAD = NUMBER + AB, TAIL = HEAD + AB;
    localparam NEAREST = WIN + 3;            // positions, as above
    localparam DECIDES = NEAREST + 1 + WIN;
    localparam RINGED = DECIDES + 1 - 2*WIN; // what enters the ring, of 2*WIN clusters
    localparam RB  = LOG + 1;                // bits of a place in it
    localparam [1:0] IDLE = 2'd0, PASS = 2'd1, WALK = 2'd2;

    reg  [1:0]    state_q;
    reg  [1:0]    round_q;
    reg           first_q;                   // the pass reads spheres
    reg           even_q;                    // it joins every two
    reg  [AB:0]   m_q;                       // clusters of the pass
    reg  [AB:0]   asked_q, passed_q;         // those that were asked for, are decided
    reg  [AB:0]   out_q;                     // clusters of the next one
    wire          pass = state_q == PASS;
    wire          ask  = pass && asked_q != m_q;
    assign read_o  = ask && first_q;
    assign place_o = asked_q[AB-1:0];

    // ---- row of clusters ----
    wire          wr;
    wire [CW-1:0] joined, row;
    rt_slot_ram #(.WIDTH(CW), .SLOTS(1 << AB), .OLD(0)) u_row (
        .clk(clk), .wr_en_i(wr), .wr_addr_i(out_q[AB-1:0]), .wr_data_i(joined),
        .rd_en_i(ask), .rd_addr_i(asked_q[AB-1:0]), .rd_data_o(row)
    );
    reg  [1:0]    coming_q;                  // asked for a clock ago, two clocks ago
    reg  [AB-1:0] id_q;
    reg  [CW-1:0] row_q;
    wire [6*SB-1:0] leaf_box;
    genvar i, k;
    generate
        for (i = 0; i < 3; i = i + 1) begin : g_leaf
            wire [BW-1:0] centre = {{2{leaf_i[W*i + W - 1]}}, leaf_i[W*i +: W]};
            wire [BW-1:0] radius = {2'b00, leaf_i[3*W +: W]};
            wire [BW-1:0] lo = centre - radius;
            wire [BW-1:0] hi = centre + radius;
            assign leaf_box[SB*i +: SB]     = lo[BW-1 -: SB];
            assign leaf_box[SB*(3+i) +: SB] = hi[BW-1 -: SB];
            if (BW > SB) begin : g_rest
                wire unused = &{1'b0, lo[BW-SB-1:0], hi[BW-SB-1:0]};
            end
        end
    endgenerate
    wire [CW-1:0] x = first_q ? {id_q, id_q, id_q, leaf_box} : row_q;

    // ---- boxes of x and of the window before it; whole clusters, until they are decided ----
    reg  [6*SB*(WIN+1)-1:0] box_q;           // positions 0 to WIN
    reg  [DECIDES:0] here_q;                 // it is a cluster
    reg  [RB-1:0] ring_q;
    wire [CW-1:0] left, right;               // at DECIDES; that it is joined with
    wire [KB-1:0] on;                        // which is so many places on
    wire [RB-1:0] left_at = ring_q + 1'b1;   // the oldest, at DECIDES
    wire [3*AB-1:0] numbers;
    rt_delay #(.WIDTH(3*AB), .CYCLES(RINGED + 1)) u_numbers (
        .clk(clk), .in_i(x[NUMBER +: 3*AB]), .out_o(numbers)
    );
    wire [CW-1:0] ringed  = {numbers, box_q[6*SB*RINGED +: 6*SB]};
    rt_slot_file #(.WIDTH(CW), .SLOTS(1 << RB)) u_left (
        .clk(clk), .wr_en_i(1'b1), .wr_addr_i(ring_q), .wr_data_i(ringed),
        .rd_addr_i(left_at), .rd_data_o(left)
    );
    rt_slot_file #(.WIDTH(CW), .SLOTS(1 << RB)) u_right (
        .clk(clk), .wr_en_i(1'b1), .wr_addr_i(ring_q), .wr_data_i(ringed),
        .rd_addr_i(left_at + on), .rd_data_o(right)
    );
    always @(posedge clk) begin
        coming_q <= {coming_q[0], ask};
        id_q     <= id_i;
        row_q    <= row;
        box_q    <= {box_q[6*SB*WIN-1:0], x[6*SB-1:0]};
        here_q   <= {here_q[DECIDES-1:0], coming_q[1]};
        ring_q   <= ring_q + 1'b1;
        if (rst || start_i) begin
            coming_q <= 2'd0;
            here_q   <= {(DECIDES+1){1'b0}};
            ring_q   <= {RB{1'b0}};
        end
    end

    // ---- around two: high and low sides; the longest of three edges ----
    function [6*SB-1:0] around;
        input [6*SB-1:0] a;
        input [6*SB-1:0] b;
        integer j;
        for (j = 0; j < 3; j = j + 1) begin
            around[SB*j +: SB] = $signed(a[SB*j +: SB]) < $signed(b[SB*j +: SB])
                                 ? a[SB*j +: SB] : b[SB*j +: SB];
            around[SB*(3+j) +: SB] = $signed(a[SB*(3+j) +: SB]) > $signed(b[SB*(3+j) +: SB])
                                     ? a[SB*(3+j) +: SB] : b[SB*(3+j) +: SB];
        end
    endfunction
    function [3*SB-1:0] edges;
        input [6*SB-1:0] box;
        integer j;
        for (j = 0; j < 3; j = j + 1)
            edges[SB*j +: SB] = box[SB*(3+j) +: SB] - box[SB*j +: SB];
    endfunction
    function [SB-1:0] longest;
        input [3*SB-1:0] e;
        begin
            longest = e[0 +: SB] > e[SB +: SB] ? e[0 +: SB] : e[SB +: SB];
            if (e[2*SB +: SB] > longest) longest = e[2*SB +: SB];
        end
    endfunction

    // ---- x and the one k places before it; the nearest after each, step by step ----
    wire [DB+KB-1:0] met [1:WIN];            // with k, at position 2 of x
    wire [DB+KB-1:0] after [1:WIN];          // of the one that was k before x, with x
    generate
        for (k = 1; k <= WIN; k = k + 1) begin : g_met
            localparam [KB-1:0] K = k;
            reg  [3*SB-1:0] edges_q;
            reg  [SB-1:0] apart_q;
            reg  [1:0]    two_q;             // both are clusters
            always @(posedge clk) begin
                edges_q <= edges(around(box_q[0 +: 6*SB], box_q[6*SB*k +: 6*SB]));
                apart_q <= even_q || !two_q[0] ? {SB{1'b0}} : longest(edges_q);
                two_q   <= {two_q[0], here_q[0] && here_q[k]};
            end
            assign met[k] = {!two_q[1], apart_q, K};
            if (k == 1) begin : g_one
                assign after[k] = met[k];
            end else begin : g_more
                reg [DB+KB-1:0] least_q;     // of those that came after it
                always @(posedge clk) least_q <= after[k-1];
                assign after[k] = met[k][KB +: DB] < least_q[KB +: DB] ? met[k] : least_q;
            end
        end
    endgenerate

    // ---- the nearest before x: a tree of LOG stages, then it waits for those after it ----
    wire [DB+KB-1:0] nearer [1:2*WIN-1];     // node j has nodes 2j and 2j + 1
    generate
        for (k = 0; k < WIN; k = k + 1) begin : g_tree_leaf
            assign nearer[WIN + k] = met[k + 1];
        end
        for (k = 1; k < WIN; k = k + 1) begin : g_tree
            reg [DB+KB-1:0] least_q;
            always @(posedge clk)
                least_q <= nearer[2*k+1][KB +: DB] < nearer[2*k][KB +: DB] ? nearer[2*k+1]
                                                                            : nearer[2*k];
            assign nearer[k] = least_q;
        end
    endgenerate
    wire [DB+KB-1:0] lefts;
    reg  [DB+KB-1:0] rights_q;
    rt_delay #(.WIDTH(DB + KB), .CYCLES(WIN + 1 - LOG)) u_lefts (
        .clk(clk), .in_i(nearer[1]), .out_o(lefts)
    );
    reg  [KB-1:0] index_q;                   // of the cluster at NEAREST
    wire [KB-1:0] lowest  = lefts[KB-1:0] & (~lefts[KB-1:0] + 1'b1);
    wire          to_left = lefts < rights_q || (lefts == rights_q && |(index_q & lowest));
    wire          alone   = lefts[DB+KB-1] && rights_q[DB+KB-1];
    localparam FB = KB + 2;                  // of what was found: any, to the left, k
    reg  [FB*(WIN+1)-1:0] found_q;           // from NEAREST + 1 on
    wire [FB-1:0] decided = found_q[FB*WIN +: FB];
    reg  [WIN:0]  taken_q;                   // it was joined to one before
    always @(posedge clk) begin
        rights_q <= after[WIN];
        if (here_q[NEAREST]) index_q <= index_q + 1'b1;
        if (start_i || (pass && asked_q == 0)) index_q <= {KB{1'b0}};
        found_q  <= {found_q[0 +: FB*WIN], here_q[NEAREST] && !alone, to_left,
                     to_left ? lefts[KB-1:0] : rights_q[KB-1:0]};
    end

    // ---- two that found each other ----
    wire [WIN:1]  match;                     // with the one k places on
    generate
        for (k = 1; k <= WIN; k = k + 1) begin : g_match
            localparam [KB-1:0] K = k;
            assign match[k] = decided == {2'b10, K} && found_q[FB*(WIN-k) +: FB] == {2'b11, K};
            always @(posedge clk) taken_q[WIN-k+1] <= taken_q[WIN-k] || match[k];
        end
    endgenerate
    always @(posedge clk) taken_q[0] <= 1'b0;
    assign on = decided[KB-1:0];

    // ---- out: 1 both are there, 2 they are joined, 3 edges of their box, 4 the pair ----
    reg           out1_q, out2_q, join1_q, join2_q, join3_q;
    reg  [CW-1:0] left_q, right_q;
    reg  [6*SB-1:0] both_q;
    reg  [3*AB-1:0] who_q;
    reg  [2*AB-1:0] halves_q, halves3_q;
    reg  [AB-1:0] number3_q;
    reg  [3*SB-1:0] edges3_q;
    reg  [AB-1:0] head_q;                    // of the right one
    assign wr     = out2_q;
    assign joined = {who_q, both_q};
    assign link_o = join2_q;
    assign link_from_o = who_q[0 +: AB];
    assign link_to_o   = head_q;
    always @(posedge clk) begin
        left_q  <= left;
        right_q <= right;
        out1_q  <= here_q[DECIDES] && !taken_q[WIN];
        join1_q <= |match;
        out2_q  <= out1_q;
        join2_q <= out1_q && join1_q;
        both_q  <= join1_q ? around(left_q[0 +: 6*SB], right_q[0 +: 6*SB]) : left_q[0 +: 6*SB];
        who_q   <= join1_q ? {right_q[TAIL +: AB], left_q[HEAD +: AB], left_q[TAIL +: AB]}
                           : left_q[NUMBER +: 3*AB];
        halves_q <= {right_q[NUMBER +: AB], left_q[NUMBER +: AB]};
        head_q   <= right_q[HEAD +: AB];
        join3_q   <= join2_q;
        edges3_q  <= edges(both_q);
        number3_q <= who_q[0 +: AB];
        halves3_q <= halves_q;
        pair_o    <= join3_q;
        number_o  <= number3_q;
        pair_data_o <= {{(SW-SB){1'b0}}, longest(edges3_q), halves3_q};
        if (rst || start_i) begin
            out1_q  <= 1'b0;
            out2_q  <= 1'b0;
            join2_q <= 1'b0;
            join3_q <= 1'b0;
            pair_o  <= 1'b0;
        end
    end

    // ---- the list of the last cluster ----
    reg  [AB-1:0] root_q, from_q;            // its number, its first sphere
    reg           begun_q;                   // next_i follows what was put
    wire          last = asked_q[AB-1:0] == count_i[AB-1:0] - 1'b1;
    assign root_o      = root_q;
    assign put_o       = state_q == WALK;
    assign put_place_o = asked_q[AB-1:0];
    assign put_id_o    = begun_q ? next_i : from_q;

    // ---- control ----
    wire          over = pass && passed_q == m_q && !out1_q && !out2_q;
    wire          again = put_o && last && round_q != rounds_i;
    always @(posedge clk) begin
        done_o <= 1'b0;
        if (ask || put_o) asked_q <= asked_q + 1'b1;
        if (here_q[DECIDES]) passed_q <= passed_q + 1'b1;
        if (out2_q) begin
            out_q  <= out_q + 1'b1;
            root_q <= who_q[0 +: AB];
            from_q <= who_q[AB +: AB];
        end
        begun_q <= put_o;
        if (start_i || over || again) begin
            state_q  <= PASS;
            first_q  <= !over;
            even_q   <= over && !even_q && out_q > m_q - (m_q >> 3);
            m_q      <= over ? out_q : count_i;
            asked_q  <= {(AB+1){1'b0}};
            passed_q <= {(AB+1){1'b0}};
            out_q    <= {(AB+1){1'b0}};
        end
        if (start_i) round_q <= 2'd0;
        if (again) round_q <= round_q + 1'b1;
        if (over && out_q == 1) state_q <= WALK;
        if (put_o && last && !again) begin
            state_q <= IDLE;
            done_o  <= 1'b1;
        end
        if (rst) begin
            state_q <= IDLE;
            done_o  <= 1'b0;
            begun_q <= 1'b0;
        end
    end
endmodule
`default_nettype wire
