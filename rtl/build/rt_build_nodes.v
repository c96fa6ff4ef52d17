// rt_build_nodes.v - nodes of four of a binary tree, from the root down
// SPDX-License-Identifier: Apache-2.0
//   stack of runs --> [choose the largest, open it, until there are four] --> children: inner ones,
//                                                                            then leaves
// A run is a cluster: places first to last of the order, and its pair. The children of a node go
// to rt_build_bound one a clock, inner ones to the stack besides, the last one first. A run of more
// than 4^(STACK_DEPTH - level) spheres is cut in halves, and so is all below it.
// Model: sph_bt_nodes() in cmodel/build/nodes.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_build_nodes #(
    parameter AB = 12,                       // bits of the number of a sphere
    parameter SW = 12,                       // bits of a size, at least AB
    parameter LB = AB + 2                    // bits of a line, derived: leave alone
) (
    input  wire          clk,
    input  wire          rst,                // synchronous, active high
    // from rt_build
    input  wire          start_i,
    input  wire [AB-1:0] last_i,             // spheres - 1
    input  wire [AB-1:0] root_i,             // number of the root's pair
    output wire          idle_o,             // every node is out
    output reg  [LB-1:0] next_o,             // lines of what is out
    // pairs, a clock after their number
    output wire          read_o,
    output wire [AB-1:0] number_o,
    input  wire [3*AB+SW-1:0] pair_i,        // cut, size, right, left
    // a node, and its children while it waits
    output wire          node_valid_o,
    input  wire          node_ready_i,
    output wire [2*LB+5:0] node_o,           // leaves, inner ones, base, line
    // to rt_build_bound: a child
    output wire          child_valid_o,
    input  wire          child_ready_i,
    output wire [2*AB:0] child_o             // the node's last, last, first
);
    localparam LV = 5;                       // bits of a level
    localparam RW = 3*AB + 1;                // even, number, last, first
    localparam QW = RW + LB + LV;            // level, line, run
    localparam [2:0] IDLE = 3'd0, POP = 3'd1, READ = 3'd2, CHOOSE = 3'd3, OPEN = 3'd4, OUT = 3'd5;

    reg  [2:0]    state_q;
    reg  [5:0]    waits_q;                   // on the stack
    reg  [LV-1:0] level_q;                   // of the node's children
    reg  [LB-1:0] line_q;
    // ---- up to four runs; the fourth is never opened ----
    reg  [AB-1:0] first_q [0:3];
    reg  [AB-1:0] last_q [0:3];
    reg  [AB-1:0] number_q [0:3];
    reg  [3:0]    inner_q;                   // more than one sphere
    reg  [AB-1:0] cut_q [0:3];               // the last place of its left half
    reg  [AB-1:0] left_q [0:3];              // numbers of its halves
    reg  [AB-1:0] right_q [0:3];
    reg  [SW-1:0] size_q [0:3];              // even: its spheres but one
    reg  [2:0]    runs_q;
    reg           even_q;
    reg           read_q;                    // the pair of the last run is to be read
    reg  [1:0]    got_q;                     // whose comes
    reg           gets_q;

    // ---- the node's own run, beside its pair: is it cut in halves ----
    wire [AB-1:0] span    = last_q[0] - first_q[0];
    wire [LV-1:0] depth   = `RT_STACK_DEPTH + 1 - level_q; // levels that are left
    wire [AB-1:0] above   = {AB{1'b1}} << {depth, 1'b0};
    wire          beyond  = |(span & above);
    wire          own     = gets_q && runs_q == 3'd1;
    wire          even    = even_q || (own && beyond);

    // ---- the largest of those that can be opened, the first of equals ----
    reg  [1:0]    most_q;
    wire          over01  = inner_q[1] && (!inner_q[0] || size_q[1] > size_q[0]);
    wire          over02  = inner_q[2] && (!inner_q[0] || size_q[2] > size_q[0]);
    wire          over12  = inner_q[2] && (!inner_q[1] || size_q[2] > size_q[1]);
    wire [1:0]    most    = (over01 ? over12 : over02) ? 2'd2 : {1'b0, over01};

    // ---- its halves ----
    wire [1:0]    low     = {1'b0, most_q[0]};
    wire [AB-1:0] first   = most_q[1] ? first_q[2] : first_q[low];
    wire [AB-1:0] last    = most_q[1] ? last_q[2] : last_q[low];
    wire [AB-1:0] left    = most_q[1] ? left_q[2] : left_q[low];
    wire [AB-1:0] right   = most_q[1] ? right_q[2] : right_q[low];
    wire [AB-1:0] found   = most_q[1] ? cut_q[2] : cut_q[low];
    wire [SW-1:0] size    = most_q[1] ? size_q[2] : size_q[low];
    wire [SW-1:0] half    = size >> 1;
    wire [AB-1:0] cut     = even_q ? first + half[AB-1:0] : found;
    wire [1:0]    added   = runs_q[1:0];     // where the right half goes
    wire          left_inner  = even_q ? half != 0 : found != first;
    wire          right_inner = even_q ? size > 2 : found + 1'b1 != last;

    // ---- a node and its children go out ----
    reg  [3:0]    out_q;                     // inner ones to go out
    reg  [3:0]    leaf_q;                    // leaves to go out
    reg  [3:0]    push_q;                    // inner ones to be pushed
    reg           head_q;                    // the node itself is out
    reg  [1:0]    slot_q;                    // of the child that is pushed
    function [1:0] lowest;
        input [3:0] set;
        lowest = set[0] ? 2'd0 : set[1] ? 2'd1 : {1'b1, !set[2] && set[3]};
    endfunction
    function [2:0] number_of;
        input [3:0] set;
        number_of = {2'd0, set[0]} + {2'd0, set[1]} + {2'd0, set[2]} + {2'd0, set[3]};
    endfunction
    wire [3:0]    going  = |out_q ? out_q : leaf_q;
    wire [1:0]    child  = lowest(going);
    wire          gone   = going == (4'd1 << child) && !(|out_q && |leaf_q);
    wire [1:0]    pushed = push_q[3] ? 2'd3 : push_q[2] ? 2'd2 : push_q[1] ? 2'd1 : 2'd0;
    wire          out    = state_q == OUT;
    wire          pushes = out && |push_q;
    assign node_valid_o  = out && !head_q;
    assign child_valid_o = out && |going;
    assign child_o       = {gone, last_q[child], first_q[child]};
    reg  [2:0]    n_inner_q, n_leaf_q;
    assign node_o = {n_leaf_q, n_inner_q, next_o, line_q};

    // ---- runs that wait ----
    wire [QW-1:0] top;
    wire [5:0]    under = waits_q - 1'b1;
    rt_slot_file #(.WIDTH(QW), .SLOTS(64)) u_stack (
        .clk(clk),
        .wr_en_i(pushes),
        .wr_addr_i(waits_q),
        .wr_data_i({level_q, next_o + {{(LB-2){1'b0}}, slot_q}, even_q, number_q[pushed],
                    last_q[pushed], first_q[pushed]}),
        .rd_addr_i(under),
        .rd_data_o(top)
    );

    // ---- control ----
    wire          opens   = state_q == OPEN && |inner_q && !runs_q[2];
    wire [1:0]    newest  = {runs_q[1] && runs_q[0], runs_q[1] && !runs_q[0]};
    wire [2:0]    inners  = number_of(inner_q);
    wire [1:0]    highest = inners[1:0] - 1'b1; // slot of the last
    wire [3:0]    all     = runs_q[2] ? 4'b1111 : ~(4'b1111 << runs_q);
    wire [LB-1:0] lines   = {{(LB-3){1'b0}}, n_inner_q} + {{(LB-2){1'b0}}, n_leaf_q[2:1]} +
                            {{(LB-1){1'b0}}, n_leaf_q[0]};
    wire          pops    = state_q == POP && |waits_q;
    // the left half's pair is read while its run is opened
    assign read_o   = pops || opens || (state_q == READ && read_q);
    assign number_o = pops ? top[2*AB +: AB]
                    : opens ? left : newest[1] ? number_q[2] : number_q[{1'b0, newest[0]}];
    assign idle_o   = state_q == IDLE;
    always @(posedge clk) begin
        gets_q <= read_o;
        got_q  <= pops ? 2'd0 : opens ? most_q : newest;
        even_q <= even;
        if (gets_q) begin
            {cut_q[got_q], right_q[got_q], left_q[got_q]} <=
                {pair_i[2*AB+SW +: AB], pair_i[0 +: 2*AB]};
            if (!even) size_q[got_q] <= pair_i[2*AB +: SW];
            else if (own) size_q[0] <= {{(SW-AB){1'b0}}, span};
        end
        case (state_q)
            POP: begin
                waits_q     <= under;
                first_q[0]  <= top[0 +: AB];
                last_q[0]   <= top[AB +: AB];
                number_q[0] <= top[2*AB +: AB];
                even_q      <= top[3*AB];
                inner_q     <= 4'd1;
                line_q      <= top[RW +: LB];
                level_q     <= top[RW + LB +: LV] + 1'b1;
                runs_q      <= 3'd1;
                most_q      <= 2'd0;
                read_q      <= 1'b0;
                state_q     <= |waits_q ? READ : IDLE;
            end
            READ: begin
                read_q <= 1'b0;
                if (!read_q) state_q <= runs_q == 3'd1 ? OPEN : CHOOSE;
            end
            CHOOSE: begin
                most_q  <= most;
                state_q <= OPEN;
            end
            OPEN: if (opens) begin
                last_q[most_q]   <= cut;
                number_q[most_q] <= left;
                size_q[most_q]   <= half;
                inner_q[most_q]  <= left_inner;
                first_q[added]   <= cut + 1'b1;
                last_q[added]    <= last;
                number_q[added]  <= right;
                size_q[added]    <= (size - 1'b1) >> 1;
                inner_q[added]   <= right_inner;
                runs_q           <= runs_q + 1'b1;
                read_q           <= right_inner;
                state_q          <= &added ? OPEN : left_inner || right_inner ? READ : CHOOSE;
            end else begin
                out_q     <= inner_q;
                push_q    <= inner_q;
                leaf_q    <= all & ~inner_q;
                n_inner_q <= inners;
                n_leaf_q  <= number_of(all & ~inner_q);
                slot_q    <= highest;
                head_q    <= 1'b0;
                state_q   <= OUT;
            end
            OUT: begin
                if (node_ready_i) head_q <= 1'b1;
                if (pushes) begin
                    waits_q        <= waits_q + 1'b1;
                    push_q[pushed] <= 1'b0;
                    slot_q         <= slot_q - 1'b1;
                end
                if (child_valid_o && child_ready_i) begin
                    if (|out_q) out_q[child] <= 1'b0;
                    else leaf_q[child] <= 1'b0;
                end
                if ((head_q || node_ready_i) && (~|going || (gone && child_ready_i)) &&
                    (push_q & (push_q - 1'b1)) == 4'd0) begin
                    next_o  <= next_o + lines;
                    state_q <= POP;
                end
            end
            default: ;
        endcase
        if (start_i) begin
            state_q     <= READ;
            waits_q     <= 6'd0;
            first_q[0]  <= {AB{1'b0}};
            last_q[0]   <= last_i;
            number_q[0] <= root_i;
            inner_q     <= {3'd0, |last_i};
            even_q      <= 1'b0;
            line_q      <= {LB{1'b0}};
            level_q     <= {{(LV-2){1'b0}}, 2'd2};
            runs_q      <= 3'd1;
            most_q      <= 2'd0;
            read_q      <= 1'b1;
            next_o      <= {{(LB-1){1'b0}}, 1'b1};
        end
        if (rst) state_q <= IDLE;
    end
endmodule
`default_nettype wire
