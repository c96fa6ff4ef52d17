// rt_build_bound.v - the sphere around a run of leaves, in filter units, rounded outwards
// SPDX-License-Identifier: Apache-2.0
//   run --> [leaves, a clock each: extents] --> centre --> run --> [leaves again: distance,
//                                                          radius] --> the largest, rounded up
// Both passes run at the same time, on different runs. Distances are roots of W+1 digits, one a
// clock, each digit a stage, so that a leaf enters every clock and nothing depends on the leaf
// before it but the maximum at the end. At most 16 children are under way. With corner_i the second
// pass has one point, the corner of the box that is farthest from its middle.
// Model: sph_bt_enclose(), sph_bt_on_box() in cmodel/build/bound.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
`include "rt_layout.vh"
module rt_build_bound #(
    parameter W  = 16,                       // coordinate, bits
    parameter FW = 14,                       // filter coordinate, bits
    parameter AB = 12                        // bits of the number of a sphere
) (
    input  wire          clk,
    input  wire          rst,                // synchronous, active high
    // from rt_build; the last two stay while children are under way
    input  wire          start_i,            // the grid's sphere replaces larger ones
    input  wire          corner_i,           // a radius is made of the box of a run, not its leaves
    input  wire          whole_i,            // a box is cut at the grid; from now on its sphere
                                             // replaces larger ones
    // from rt_build_nodes, rt_build_groups: a child
    input  wire          child_valid_i,
    output wire          child_ready_o,
    input  wire [2*AB:0] child_i,            // the node's last, last, first
    // leaves by their place, two clocks later; two readers
    output wire          a_read_o,
    output wire [AB-1:0] a_place_o,
    input  wire [4*W-1:0] a_leaf_i,          // radius uW, centre z, y, x sW
    output wire          b_read_o,
    output wire [AB-1:0] b_place_o,
    input  wire [4*W-1:0] b_leaf_i,
    input  wire [AB:0]   b_mark_i,           // clear, number
    // to rt_build: a child, in the order in which they came
    output wire          out_valid_o,
    input  wire          out_ready_i,
    output wire [1:0]    out_kind_o,         // leaf, the node's last
    output wire [55:0]   out_child_o,        // as a node has it, with the filter's margin
    output wire [4*W+AB:0] out_leaf_o,       // of one sphere: clear, number, radius, centre
    // the same, earlier, for a later run
    output wire          ball_o,
    output wire [4*W-1:0] ball_leaf_o        // as a leaf: radius, centre
);
    localparam BW = W + 2;                   // an end along an axis, signed
    localparam XW = W + 3;                   // along a diagonal: below 3/2 2^W + 7/4 2^W
    localparam K  = W - FW;
    localparam CB = 3*FW;                    // a centre
    localparam RW = W + 2;                   // a reach: distance and radius
    localparam ROOT = W + 1;                 // digits of a distance
    `RT_CHECK(FW >= 6 && FW <= 14 && FW <= W, rt_build_bound_FW_must_be_6_to_14_and_at_most_W)

    // ---- credit: children between the two ends, which the queues below hold ----
    reg  [4:0]    under_q;
    wire          begins;
    wire          out_take = out_valid_o && out_ready_i;
    wire          room   = !under_q[4];
    wire [3:0]    rooms;                     // the queues always have room,
    wire [1:0]    some;                      // and something when it is wanted
    always @(posedge clk)
        if (rst) under_q <= 5'd0;
        else     under_q <= under_q + {4'd0, begins} - {4'd0, out_take};

    // ---- first pass: leaves of a run ----
    reg           a_on_q;                    // a run is being read
    reg  [AB-1:0] a_at_q, a_first_q, a_last_q;
    reg           a_end_q;
    wire          a_more = a_on_q && a_at_q != a_last_q;
    assign begins        = child_valid_i && room && !a_more;
    assign child_ready_o = room && !a_more;
    assign a_read_o      = begins || a_more;
    assign a_place_o     = begins ? child_i[0 +: AB] : a_at_q + 1'b1;
    always @(posedge clk) begin
        if (begins) begin
            {a_end_q, a_last_q, a_first_q} <= child_i;
            a_at_q <= child_i[0 +: AB];
        end else if (a_more) a_at_q <= a_at_q + 1'b1;
        a_on_q <= !rst && (begins || a_more);
    end
    // two clocks later: is it the first of its run, the last; the run
    wire          a_head, a_tail, a_here;
    wire [2*AB:0] a_run;
    reg           a_new_q;
    always @(posedge clk) a_new_q <= begins;
    reg  [2*AB+2:0] a1_q;
    reg           a1_here_q;
    always @(posedge clk) begin
        a1_q      <= {a_new_q, a_on_q && !a_more, a_end_q, a_last_q, a_first_q};
        a1_here_q <= a_on_q && !rst;
    end
    assign {a_head, a_tail, a_run} = a1_q;
    assign a_here = a1_here_q;

    // ---- 1: ends of a leaf, along the axes and four diagonals; 2: those of the run; 3: their
    // sums; 4: 16 times the centre, half up to filter units, limited to those of the grid ----
    reg  [2:0]    ends_q;                    // of the leaf: it is there, the run's first, its last
    reg           boxed2_q, boxed3_q, boxed_q; // the run's
    reg  [2*AB:0] ends_run_q, run2_q, run3_q, boxed_run_q;
    wire signed [XW-1:0] a_radius = {3'd0, a_leaf_i[3*W +: W]};
    wire signed [XW-1:0] a_longer = a_radius + (a_radius >>> 1) + (a_radius >>> 2);
    wire signed [XW-1:0] axis [0:2];
    wire signed [XW-1:0] along [0:6];
    wire signed [XW+2:0] sums [0:6];         // of both ends
    wire [CB-1:0] middle;
    wire [6*BW-1:0] box;                     // high and low ends, of each axis
    wire [3*BW-1:0] far;
    reg  [12*BW-1:0] far_q;                  // four clocks: until a distance is made of it
    function [BW-1:0] cut;                   // at the grid
        input whole;
        input [BW-1:0] v;
        cut = !whole || v[BW-1:W-1] == 3'b000 || v[BW-1:W-1] == 3'b111
              ? v : {{3{v[BW-1]}}, {(W-1){!v[BW-1]}}};
    endfunction
    genvar i;
    generate
        for (i = 0; i < 3; i = i + 1) begin : g_axis
            assign axis[i]  = {{3{a_leaf_i[W*i + W - 1]}}, a_leaf_i[W*i +: W]};
            assign along[i] = axis[i];
        end
        assign along[3] = axis[0] + axis[1] + axis[2];
        assign along[4] = axis[0] + axis[1] - axis[2];
        assign along[5] = axis[0] - axis[1] + axis[2];
        assign along[6] = axis[1] + axis[2] - axis[0];
        for (i = 0; i < 7; i = i + 1) begin : g_ends
            localparam EW = i < 3 ? BW : XW; // bits of an end
            wire signed [XW-1:0] radius = i < 3 ? a_radius : a_longer;
            wire signed [XW-1:0] low  = along[i] - radius;
            wire signed [XW-1:0] high = along[i] + radius;
            reg  signed [EW-1:0] from_q, to_q, lo_q, hi_q;
            wire signed [EW-1:0] lo_end, hi_end;
            reg  signed [EW:0] sum_q;
            assign sums[i] = {{(XW+2-EW){sum_q[EW]}}, sum_q};
            always @(posedge clk) begin
                from_q <= low[EW-1:0];
                to_q   <= high[EW-1:0];
                if (ends_q[2] && (ends_q[1] || from_q < lo_q)) lo_q <= from_q;
                if (ends_q[2] && (ends_q[1] || to_q > hi_q)) hi_q <= to_q;
                sum_q  <= lo_end + hi_end;
            end
            if (i < 3) begin : g_box
                reg [2*BW-1:0] both_q;
                assign lo_end = cut(whole_i, lo_q);
                assign hi_end = cut(whole_i, hi_q);
                assign box[2*BW*i +: 2*BW] = both_q;
                always @(posedge clk) both_q <= {hi_end, lo_end};
                wire unused = &{1'b0, low[XW-1:EW], high[XW-1:EW]};
            end else begin : g_diagonal
                assign lo_end = lo_q;
                assign hi_end = hi_q;
            end
        end
        for (i = 0; i < 3; i = i + 1) begin : g_middle
            wire signed [XW+2:0] one   = sums[3];
            wire signed [XW+2:0] two   = i == 2 ? -sums[4] : sums[4];
            wire signed [XW+2:0] three = i == 1 ? -sums[5] : sums[5];
            wire signed [XW+2:0] four  = i == 0 ? -sums[6] : sums[6];
            wire signed [XW+2:0] twice = sums[i];
            // of a box alone its half, rounded down to grid units first
            wire signed [XW+2:0] all   = corner_i ? (twice - (K == 0 ? 1 : 0)) <<< 3
                                       : (twice <<< 2) + one + two + three + four;
            wire signed [XW+2:0] up    = (all >>> (K + 3)) + 1;
            wire signed [XW+2:0] fine  = up >>> 1;
            wire fits = fine[XW+2:FW-1] == {(XW+4-FW){1'b0}} ||
                        fine[XW+2:FW-1] == {(XW+4-FW){1'b1}};
            reg  [FW-1:0] middle_q;
            always @(posedge clk)
                middle_q <= fits ? fine[FW-1:0] : {fine[XW+2], {(FW-1){!fine[XW+2]}}};
            assign middle[FW*i +: FW] = middle_q;
            // the farther end, as seen from there, which is above the half if it was rounded up
            assign far[BW*i +: BW] = K != 0 && fits && twice[K] ? box[2*BW*i +: BW]
                                                                : box[2*BW*i + BW +: BW];
            wire unused = &{1'b0, all[K+2:0], up[0]};
        end
    endgenerate
    always @(posedge clk) begin
        far_q      <= {far_q[9*BW-1:0], far};
        ends_q     <= {a_here, a_head, a_tail};
        ends_run_q <= a_run;
        boxed2_q   <= ends_q[2] && ends_q[0];
        run2_q     <= ends_run_q;
        boxed3_q   <= boxed2_q;
        run3_q     <= run2_q;
        boxed_q    <= boxed3_q;
        boxed_run_q <= run3_q;
        if (rst) begin
            ends_q   <= 3'd0;
            boxed2_q <= 1'b0;
            boxed3_q <= 1'b0;
            boxed_q  <= 1'b0;
        end
    end

    // ---- second pass ----
    wire          run_valid, run_take;
    wire [2*AB+CB:0] run;
    rt_fifo #(.WIDTH(2*AB + 1 + CB), .DEPTH(16)) u_runs (
        .clk(clk), .rst(rst),
        .in_valid_i(boxed_q), .in_ready_o(rooms[0]), .in_data_i({middle, boxed_run_q}),
        .out_valid_o(run_valid), .out_ready_i(run_take), .out_data_o(run)
    );
    reg           b_on_q, b_new_q, b_end_q;
    reg  [AB-1:0] b_at_q, b_last_q;
    reg  [CB-1:0] b_middle_q;
    reg           b_leaf_q;                  // one sphere
    wire          b_more = b_on_q && b_at_q != b_last_q;
    assign run_take  = !b_more;
    wire          b_begins = run_valid && !b_more;
    assign b_read_o  = b_begins || b_more;
    assign b_place_o = b_begins ? run[0 +: AB] : b_at_q + 1'b1;
    always @(posedge clk) begin
        b_new_q <= b_begins;
        if (b_begins) begin
            {b_middle_q, b_end_q, b_last_q} <= run[2*AB+CB:AB];
            b_at_q   <= corner_i ? run[AB +: AB] : run[0 +: AB];
            b_leaf_q <= run[0 +: AB] == run[AB +: AB] && !corner_i;
        end else if (b_more) b_at_q <= b_at_q + 1'b1;
        b_on_q <= !rst && (b_begins || b_more);
    end
    // s0: the leaf is there
    reg           s0_here_q;
    reg  [3:0]    s0_tag_q;                  // leaf, node's last, run's last, run's first
    reg  [CB-1:0] s0_middle_q;
    always @(posedge clk) begin
        s0_here_q   <= b_on_q && !rst;
        s0_tag_q    <= {b_leaf_q, b_end_q, !b_more, b_new_q};
        s0_middle_q <= b_middle_q;
    end

    // ---- s1: how far apart; s2: squares; s3: their sum ----
    reg  [6*W-1:0] s2_square_q;
    reg  [2*W+1:0] s3_sum_q;
    generate
        for (i = 0; i < 3; i = i + 1) begin : g_apart
            wire signed [BW:0] from = {{3{s0_middle_q[FW*i + FW - 1]}}, s0_middle_q[FW*i +: FW],
                                       {K{1'b0}}};
            wire signed [BW-1:0] to = corner_i ? far_q[BW*(9+i) +: BW]
                                               : {{2{b_leaf_i[W*i + W - 1]}}, b_leaf_i[W*i +: W]};
            wire signed [BW:0] d    = from - to;
            wire [W-1:0]   minus_d = ~d[W-1:0] + 1'b1;
            // of a leaf at most 2^W - 1; a corner beyond makes a sphere that is too large anyway
            wire           over = d[BW:W] != {3{d[BW]}} || (d[BW] && d[W-1:0] == 0);
            reg  [W-1:0]   s1_apart_q;
            always @(posedge clk) begin
                s1_apart_q <= over ? {W{1'b1}} : d[BW] ? minus_d : d[W-1:0];
                s2_square_q[2*W*i +: 2*W] <= s1_apart_q * s1_apart_q;
            end
        end
    endgenerate
    always @(posedge clk)
        s3_sum_q <= {2'b00, s2_square_q[0 +: 2*W]} + {2'b00, s2_square_q[2*W +: 2*W]} +
                    {2'b00, s2_square_q[4*W +: 2*W]};

    // ---- root: digit by digit, a stage each ----
    wire [2*ROOT-1:0] x [0:ROOT];            // digits that are left, at the top
    wire [ROOT+1:0] rem [0:ROOT];            // at most 2 * root
    wire [ROOT-1:0] root [0:ROOT];
    assign x[0]    = s3_sum_q;
    assign rem[0]  = {(ROOT+2){1'b0}};
    assign root[0] = {ROOT{1'b0}};
    generate
        for (i = 0; i < ROOT; i = i + 1) begin : g_digit
            wire [ROOT+3:0] more  = {rem[i], x[i][2*ROOT-1 -: 2]};
            wire [ROOT+4:0] less  = {1'b0, more} - {3'b000, root[i], 2'b01};
            reg  [2*ROOT-1:0] x_q;
            reg  [ROOT+1:0] rem_q;
            reg  [ROOT-1:0] root_q;
            always @(posedge clk) begin
                x_q    <= x[i] << 2;
                rem_q  <= less[ROOT+4] ? more[ROOT+1:0] : less[ROOT+1:0];
                root_q <= {root[i][ROOT-2:0], !less[ROOT+4]};
            end
            assign x[i+1]    = x_q;
            assign rem[i+1]  = rem_q;
            assign root[i+1] = root_q;
        end
    endgenerate

    // ---- beside it: radius and tags ----
    wire [W+3:0]  beside;
    wire          there;
    rt_delay #(.WIDTH(W + 4), .CYCLES(ROOT + 3)) u_beside (
        .clk(clk), .in_i({s0_tag_q, corner_i ? {W{1'b0}} : b_leaf_i[3*W +: W]}), .out_o(beside)
    );
    rt_delay_valid #(.CYCLES(ROOT + 3)) u_there (
        .clk(clk), .rst(rst), .in_i(s0_here_q), .out_o(there)
    );

    // ---- reach of a leaf, the most of a run ----
    reg  [RW-1:0] reach_q, most_q;
    reg  [3:0]    reach_tag_q;
    reg  [1:0]    most_tag_q;
    reg           reach_here_q, most_here_q;
    always @(posedge clk) begin
        reach_q      <= {1'b0, root[ROOT]} + {2'b00, beside[W-1:0]} +
                        {{(RW-1){1'b0}}, |rem[ROOT]};
        reach_tag_q  <= beside[W +: 4];
        reach_here_q <= there && !rst;
        if (reach_here_q && (reach_tag_q[0] || reach_q > most_q)) most_q <= reach_q;
        most_tag_q   <= reach_tag_q[3:2];
        most_here_q  <= reach_here_q && reach_tag_q[1] && !rst;
    end

    // ---- filter units, up; a sphere larger than that around the grid becomes it ----
    function integer root_up;                // ceil(sqrt(square)), up to 2^15
        input integer square;
        integer digit;
        begin
            root_up = 0;
            for (digit = 14; digit >= 0; digit = digit - 1)
                if ((root_up + (1 << digit)) * (root_up + (1 << digit)) < square)
                    root_up = root_up + (1 << digit);
            root_up = root_up + 1;
        end
    endfunction
    localparam integer CEILING = root_up(3 << 2*(FW-1));
    localparam [RW-K:0] WHOLE = CEILING[RW-K:0];
    localparam [RW:0] UP = (1 << K) - 1;
    wire [RW:0]   raised = {1'b0, most_q} + UP;
    wire [RW-K:0] units  = raised[RW:K];
    reg  [RW-K:0] cap_q;                     // of a radius
    reg  [CB-1:0] cap_centre_q;
    wire          beyond  = units > cap_q;
    wire [RW-K:0] least   = beyond ? cap_q : units; // at most sqrt(3) * 2^13 + 1
    wire [19:0]   margined = {{(17-FW){1'b0}}, least} + `RT_FILTER_MARGIN;
    wire [`RT_CHILD_RAD_BITS-1:0] radius = margined[`RT_CHILD_RAD_BITS-1:0];

    // ---- queues of centres, leaves and results ----
    wire [CB-1:0] waited;
    wire [CB-1:0] centre = beyond ? cap_centre_q : waited;
    always @(posedge clk)
        if (start_i) begin
            cap_q        <= WHOLE;
            cap_centre_q <= {CB{1'b0}};
        end else if (whole_i && most_here_q) begin
            cap_q        <= least;
            cap_centre_q <= centre;
        end
    rt_fifo #(.WIDTH(CB), .DEPTH(16)) u_middles (
        .clk(clk), .rst(rst),
        .in_valid_i(boxed_q), .in_ready_o(rooms[1]), .in_data_i(middle),
        .out_valid_o(some[0]), .out_ready_i(most_here_q), .out_data_o(waited)
    );
    rt_fifo #(.WIDTH(4*W + AB + 1), .DEPTH(16)) u_leaves (
        .clk(clk), .rst(rst),
        .in_valid_i(s0_here_q && s0_tag_q[3]), .in_ready_o(rooms[2]),
        .in_data_i({b_mark_i, b_leaf_i}),
        .out_valid_o(some[1]), .out_ready_i(out_take && out_kind_o[1]),
        .out_data_o(out_leaf_o)
    );
    wire [55:0] result;
    generate
        for (i = 0; i < 3; i = i + 1) begin : g_out
            assign result[14*i +: 14] = {{(15-FW){centre[FW*i + FW - 1]}}, centre[FW*i +: FW-1]};
            assign ball_leaf_o[W*i +: W] = {centre[FW*i +: FW], {K{1'b0}}};
        end
    endgenerate
    assign ball_o = most_here_q;
    assign ball_leaf_o[3*W +: W] = {least[FW-1:0], {K{1'b0}}}; // at most sqrt(3) * 2^(FW-1) + 1
    assign result[`RT_CHILD_RAD_LSB +: `RT_CHILD_RAD_BITS] = radius;
    rt_fifo #(.WIDTH(58), .DEPTH(16)) u_results (
        .clk(clk), .rst(rst),
        .in_valid_i(most_here_q), .in_ready_o(rooms[3]), .in_data_i({most_tag_q, result}),
        .out_valid_o(out_valid_o), .out_ready_i(out_ready_i),
        .out_data_o({out_kind_o, out_child_o})
    );
    wire unused = &{1'b0, rooms, some, raised[K:0], margined[19:14]};
endmodule
`default_nettype wire
