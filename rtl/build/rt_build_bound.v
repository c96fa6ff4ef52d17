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
    reg           a_more_q;                  // there is another leaf of it
    reg  [AB-1:0] a_next_q, a_first_q, a_last_q;
    reg           a_end_q;
    assign begins        = child_valid_i && room && !a_more_q;
    assign child_ready_o = room && !a_more_q;
    assign a_read_o      = begins || a_more_q;
    assign a_place_o     = begins ? child_i[0 +: AB] : a_next_q;
    always @(posedge clk) begin
        if (begins) {a_end_q, a_last_q, a_first_q} <= child_i;
        a_next_q <= a_place_o + 1'b1;
        a_more_q <= !rst && a_read_o && a_place_o != (begins ? child_i[AB +: AB] : a_last_q);
        a_on_q   <= !rst && a_read_o;
    end
    // is it the first of its run, the last
    reg           a_new_q;
    always @(posedge clk) a_new_q <= begins;
    // ---- 1: the leaf; 2: sums of two axes; 3: it along the axes and four diagonals; 4: its ends;
    // 5: those of the run; 6: their sums; 7, 8: 16 times the centre; 9: half up to filter units,
    // limited to those of the grid ----
    wire [2:0]    ends;                      // 4: it is there, the run's first, its last
    wire [2*AB:0] boxed_run;                 // 9
    reg  [5:1]    boxed_q;                   // 5 to 9: the run's
    reg  [4*W-1:0] leaf_q;
    reg  signed [XW-1:0] plus_q, minus_q, half_q, long_q; // of x and y; 3/2, 7/4 of the radius
    reg  [3*XW-1:0] axis2_q;
    wire signed [XW-1:0] z2 = axis2_q[2*XW +: XW];
    reg  signed [XW-1:0] radius2_q, radius_q;
    wire signed [XW-1:0] axis1 [0:2];
    wire signed [XW-1:0] radius1 = {3'd0, leaf_q[3*W +: W]};
    reg  signed [XW+2:0] near_q, apart_q, turn_q, away_q; // sums of sums along diagonals
    reg  [7*XW-1:0] along_q;
    wire signed [XW+2:0] sums [0:6];         // of both ends
    wire [CB-1:0] middle;
    wire [6*BW-1:0] box;                     // high and low ends, of each axis
    wire [3*BW-1:0] far;
    reg  [15*BW-1:0] far_q;                  // five clocks: until a distance is made of it
    rt_delay #(.WIDTH(2), .CYCLES(5)) u_ends (
        .clk(clk), .in_i({a_new_q, a_on_q && !a_more_q}), .out_o(ends[1:0])
    );
    rt_delay_valid #(.CYCLES(5)) u_here (.clk(clk), .rst(rst), .in_i(a_on_q), .out_o(ends[2]));
    rt_delay #(.WIDTH(2*AB + 1), .CYCLES(10)) u_run (
        .clk(clk), .in_i({a_end_q, a_last_q, a_first_q}), .out_o(boxed_run)
    );
    function [BW-1:0] cut;                   // at the grid
        input whole;
        input [BW-1:0] v;
        cut = !whole || v[BW-1:W-1] == 3'b000 || v[BW-1:W-1] == 3'b111
              ? v : {{3{v[BW-1]}}, {(W-1){!v[BW-1]}}};
    endfunction
    genvar i;
    generate
        for (i = 0; i < 3; i = i + 1) begin : g_axis
            assign axis1[i] = {{3{leaf_q[W*i + W - 1]}}, leaf_q[W*i +: W]};
            always @(posedge clk) begin
                axis2_q[XW*i +: XW] <= axis1[i];
                along_q[XW*i +: XW] <= axis2_q[XW*i +: XW];
            end
        end
        for (i = 0; i < 7; i = i + 1) begin : g_ends
            localparam EW = i < 3 ? BW : XW; // bits of an end
            wire signed [XW-1:0] radius = i < 3 ? radius_q : long_q;
            wire signed [XW-1:0] along = along_q[XW*i +: XW];
            wire signed [XW-1:0] low  = along - radius;
            wire signed [XW-1:0] high = along + radius;
            reg  signed [EW-1:0] from_q, to_q, lo_q, hi_q;
            wire signed [EW-1:0] lo_end, hi_end;
            reg  signed [EW:0] sum_q;
            assign sums[i] = {{(XW+2-EW){sum_q[EW]}}, sum_q};
            always @(posedge clk) begin
                from_q <= low[EW-1:0];
                to_q   <= high[EW-1:0];
                if (ends[2] && (ends[1] || from_q < lo_q)) lo_q <= from_q;
                if (ends[2] && (ends[1] || to_q > hi_q)) hi_q <= to_q;
                sum_q  <= lo_end + hi_end;
            end
            if (i < 3) begin : g_box
                reg [2*BW-1:0] both6_q, both7_q, both_q;
                assign lo_end = cut(whole_i, lo_q);
                assign hi_end = cut(whole_i, hi_q);
                assign box[2*BW*i +: 2*BW] = both_q;
                always @(posedge clk) begin
                    both6_q <= {hi_end, lo_end};
                    both7_q <= both6_q;
                    both_q  <= both7_q;
                end
                wire unused = &{1'b0, low[XW-1:EW], high[XW-1:EW]};
            end else begin : g_diagonal
                assign lo_end = lo_q;
                assign hi_end = hi_q;
            end
        end
        for (i = 0; i < 3; i = i + 1) begin : g_middle
            reg  signed [XW+2:0] twice_q, up_q;
            wire signed [XW+2:0] mean;
            if (i == 0) begin : g_x
                assign mean = (twice_q <<< 2) + near_q + turn_q;
            end else if (i == 1) begin : g_y
                assign mean = (twice_q <<< 2) + near_q - turn_q;
            end else begin : g_z
                assign mean = (twice_q <<< 2) + apart_q + away_q;
            end
            // of a box alone its half, rounded down to grid units first
            wire signed [XW+2:0] all   = corner_i ? (twice_q - (K == 0 ? 1 : 0)) <<< 3 : mean;
            reg           odd_q;
            always @(posedge clk) begin
                twice_q <= sums[i];
                up_q    <= all >>> (K + 3);
                odd_q   <= twice_q[K];
            end
            wire signed [XW+2:0] fine  = (up_q + 1) >>> 1;
            wire fits = fine[XW+2:FW-1] == {(XW+4-FW){1'b0}} ||
                        fine[XW+2:FW-1] == {(XW+4-FW){1'b1}};
            reg  [FW-1:0] middle_q;
            always @(posedge clk)
                middle_q <= fits ? fine[FW-1:0] : {fine[XW+2], {(FW-1){!fine[XW+2]}}};
            assign middle[FW*i +: FW] = middle_q;
            // the farther end, as seen from there, which is above the half if it was rounded up
            assign far[BW*i +: BW] = K != 0 && fits && odd_q ? box[2*BW*i +: BW]
                                                                : box[2*BW*i + BW +: BW];
            wire unused = &{1'b0, all[K+2:0]};
        end
    endgenerate
    always @(posedge clk) begin
        leaf_q   <= a_leaf_i;
        plus_q   <= axis1[0] + axis1[1];
        minus_q  <= axis1[0] - axis1[1];
        along_q[3*XW +: XW] <= plus_q + z2;
        along_q[4*XW +: XW] <= plus_q - z2;
        along_q[5*XW +: XW] <= minus_q + z2;
        along_q[6*XW +: XW] <= z2 - minus_q;
        radius2_q <= radius1;
        half_q   <= radius1 + (radius1 >>> 1);
        radius_q <= radius2_q;
        long_q   <= half_q + (radius2_q >>> 2);
        near_q   <= sums[3] + sums[4];
        apart_q  <= sums[3] - sums[4];
        turn_q   <= sums[5] - sums[6];
        away_q   <= sums[5] + sums[6];
        far_q    <= {far_q[12*BW-1:0], far};
        boxed_q  <= {boxed_q[4:1], ends[2] && ends[0]};
        if (rst) boxed_q <= 5'd0;
    end

    // ---- second pass ----
    wire          run_valid, run_take;
    wire [2*AB+CB:0] run;
    rt_fifo #(.WIDTH(2*AB + 1 + CB), .DEPTH(16)) u_runs (
        .clk(clk), .rst(rst),
        .in_valid_i(boxed_q[5]), .in_ready_o(rooms[0]), .in_data_i({middle, boxed_run}),
        .out_valid_o(run_valid), .out_ready_i(run_take), .out_data_o(run)
    );
    reg           b_on_q, b_new_q, b_end_q;
    reg           b_more_q;
    reg  [AB-1:0] b_next_q, b_last_q;
    reg  [CB-1:0] b_middle_q;
    reg           b_leaf_q;                  // one sphere
    wire [AB-1:0] run_first = run[0 +: AB];
    wire [AB-1:0] run_last  = run[AB +: AB];
    assign run_take  = !b_more_q;
    wire          b_begins = run_valid && !b_more_q;
    assign b_read_o  = b_begins || b_more_q;
    assign b_place_o = b_begins ? run_first : b_next_q;
    always @(posedge clk) begin
        b_new_q  <= b_begins;
        b_next_q <= b_place_o + 1'b1;
        b_more_q <= !rst && !corner_i && b_read_o && b_place_o != (b_begins ? run_last : b_last_q);
        b_on_q   <= !rst && b_read_o;
        if (b_begins) begin
            {b_middle_q, b_end_q, b_last_q} <= run[2*AB+CB:AB];
            b_leaf_q <= run_first == run_last && !corner_i;
        end
    end
    // s0: the leaf is there
    reg           s_here_q, s0_here_q;
    reg  [3:0]    s_tag_q, s0_tag_q;         // leaf, node's last, run's last, run's first
    reg  [CB-1:0] s_middle_q, s0_middle_q;
    reg  [4*W+AB:0] s0_leaf_q;               // with its mark
    always @(posedge clk) begin
        s_here_q    <= b_on_q && !rst;
        s_tag_q     <= {b_leaf_q, b_end_q, !b_more_q, b_new_q};
        s_middle_q  <= b_middle_q;
        s0_here_q   <= s_here_q && !rst;
        s0_tag_q    <= s_tag_q;
        s0_middle_q <= s_middle_q;
        s0_leaf_q   <= {b_mark_i, b_leaf_i};
    end

    // ---- s1: how far apart; s2: squares; s3: their sum ----
    reg  [6*W-1:0] s2_square_q;
    reg  [2*W+1:0] s3_sum_q;
    generate
        for (i = 0; i < 3; i = i + 1) begin : g_apart
            wire signed [BW:0] from = {{3{s0_middle_q[FW*i + FW - 1]}}, s0_middle_q[FW*i +: FW],
                                       {K{1'b0}}};
            wire signed [BW-1:0] to = corner_i ? far_q[BW*(12+i) +: BW]
                                       : {{2{s0_leaf_q[W*i + W - 1]}}, s0_leaf_q[W*i +: W]};
            wire signed [BW:0] d    = from - to;
            wire [W-1:0]   minus_d = to[W-1:0] - from[W-1:0];
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
            wire [ROOT+2:0] taken = {1'b0, root[i], 2'b01};
            wire [i+2:0] more     = {rem[i][i:0], x[i][2*ROOT-1 -: 2]}; // rem is below 2^(i+1)
            wire [i+3:0] less     = {1'b0, more} - taken[i+3:0];
            reg  [2*ROOT-1:0] x_q;
            reg  [i+1:0]  rem_q;
            reg  [ROOT-1:0] root_q;
            always @(posedge clk) begin
                x_q    <= x[i] << 2;
                rem_q  <= less[i+3] ? more[i+1:0] : less[i+1:0];
                root_q <= {root[i][ROOT-2:0], !less[i+3]};
            end
            assign x[i+1]    = x_q;
            assign rem[i+1]  = {{(ROOT-i){1'b0}}, rem_q};
            assign root[i+1] = root_q;
            wire unused = &{1'b0, taken, less[i+2], rem[i][ROOT+1:i+1], root[i][ROOT-1]};
        end
    endgenerate

    // ---- beside it: radius and tags ----
    wire [W+3:0]  beside;
    wire          there;
    rt_delay #(.WIDTH(W + 4), .CYCLES(ROOT + 3)) u_beside (
        .clk(clk), .in_i({s0_tag_q, corner_i ? {W{1'b0}} : s0_leaf_q[3*W +: W]}), .out_o(beside)
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
    reg  [RW-K:0] units_q;
    reg  [1:0]    units_tag_q;
    reg           units_here_q;
    always @(posedge clk) begin
        units_q      <= raised[RW:K];
        units_tag_q  <= most_tag_q;
        units_here_q <= most_here_q && !rst;
    end
    reg  [RW-K:0] cap_q;                     // of a radius
    reg  [CB-1:0] cap_centre_q;
    wire          beyond  = units_q > cap_q;
    wire [RW-K:0] least   = beyond ? cap_q : units_q; // at most sqrt(3) * 2^13 + 1
    wire [19:0]   margined = {{(17-FW){1'b0}}, least} + `RT_FILTER_MARGIN;
    wire [`RT_CHILD_RAD_BITS-1:0] radius = margined[`RT_CHILD_RAD_BITS-1:0];

    // ---- queues of centres, leaves and results ----
    wire [CB-1:0] waited;
    wire [CB-1:0] centre = beyond ? cap_centre_q : waited;
    always @(posedge clk)
        if (start_i) begin
            cap_q        <= WHOLE;
            cap_centre_q <= {CB{1'b0}};
        end else if (whole_i && units_here_q) begin
            cap_q        <= least;
            cap_centre_q <= centre;
        end
    rt_fifo #(.WIDTH(CB), .DEPTH(16)) u_middles (
        .clk(clk), .rst(rst),
        .in_valid_i(boxed_q[5]), .in_ready_o(rooms[1]), .in_data_i(middle),
        .out_valid_o(some[0]), .out_ready_i(units_here_q), .out_data_o(waited)
    );
    rt_fifo #(.WIDTH(4*W + AB + 1), .DEPTH(16)) u_leaves (
        .clk(clk), .rst(rst),
        .in_valid_i(s0_here_q && s0_tag_q[3]), .in_ready_o(rooms[2]),
        .in_data_i(s0_leaf_q),
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
    assign ball_o = units_here_q;
    assign ball_leaf_o[3*W +: W] = {least[FW-1:0], {K{1'b0}}}; // at most sqrt(3) * 2^(FW-1) + 1
    assign result[`RT_CHILD_RAD_LSB +: `RT_CHILD_RAD_BITS] = radius;
    rt_fifo #(.WIDTH(58), .DEPTH(16)) u_results (
        .clk(clk), .rst(rst),
        .in_valid_i(units_here_q), .in_ready_o(rooms[3]), .in_data_i({units_tag_q, result}),
        .out_valid_o(out_valid_o), .out_ready_i(out_ready_i),
        .out_data_o({out_kind_o, out_child_o})
    );
    wire unused = &{1'b0, rooms, some, raised[K:0], margined[19:14]};
endmodule
`default_nettype wire
