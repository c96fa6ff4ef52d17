// rt_build_groups.v - nodes of four spheres of an order by z, level by level, the lowest first
// SPDX-License-Identifier: Apache-2.0
//   nodes of leaves --> the sphere on the box of all --> nodes of those nodes --> nodes of these ..
// A pass sends nodes and their children as rt_build_nodes does, and waits until they are written:
// the next one reads spheres that this one made. A child is one leaf in the first pass; then it is
// the run of what its own node holds, leaves in the second pass, spheres in later ones. Nodes stand
// in memory from the root down, leaf records behind them.
// Model: sph_bt_groups() in cmodel/build/groups.c
`timescale 1ns / 1ps
`default_nettype none
module rt_build_groups #(
    parameter AB = 12,                       // bits of the number of a sphere
    parameter LB = AB + 2                    // bits of a line, derived: leave alone
) (
    input  wire          clk,
    input  wire          rst,                // synchronous, active high
    // from rt_build
    input  wire          start_i,
    input  wire [AB:0]   count_i,            // spheres, at least 1
    output wire          idle_o,             // every node is out
    output reg  [LB-1:0] next_o,             // lines of what is out
    input  wire          drained_i,          // every node that was sent is written
    input  wire          whole_done_i,       // the sphere on the box of all is there
    // what a child is now
    output reg           low_o,              // a leaf
    output reg           upper_o,            // a run of spheres of the pass before
    output wire          whole_o,            // all leaves, which is no child
    input  wire          ball_i,             // the sphere of a child comes,
    output reg  [AB-1:0] ball_at_o,          // of this one
    // a node, before its children; both wait together
    output wire          node_valid_o,
    input  wire          node_ready_i,
    output wire [2*LB+5:0] node_o,           // leaves, inner ones, base, line
    // to rt_build_bound: a child
    output wire          child_valid_o,
    input  wire          child_ready_i,
    output wire [2*AB:0] child_o             // the node's last, last, first
);
    localparam [2:0] IDLE = 3'd0, SIZE = 3'd1, BEGIN = 3'd2, HEAD = 3'd3, CHILD = 3'd4,
                     DRAIN = 3'd5, WHOLE = 3'd6, AWAIT = 3'd7;
    reg  [2:0]    state_q;
    reg  [AB:0]   items_q;                   // children of the pass
    reg  [AB-1:0] below_q;                   // what they are runs of, without the last
    reg  [AB-1:0] at_q;                      // child
    reg  [LB-1:0] first_q;                   // line of the first node of the pass before
    reg  [LB-1:0] line_q, base_q;
    wire [AB:0]   nodes = (items_q >> 2) + {{AB{1'b0}}, |items_q[1:0]}; // of the pass
    wire          one   = nodes == 1;
    wire [LB-1:0] many  = {{(LB-AB-1){1'b0}}, nodes};
    wire [AB:0]   left  = items_q - {1'b0, at_q};
    wire [2:0]    here  = |left[AB:2] ? 3'd4 : left[2:0]; // children of the node
    wire          ends  = &at_q[1:0] || left == 1;
    wire [AB-1:0] run   = {at_q[AB-3:0], 2'b00};
    wire [AB-1:0] run_last = {at_q[AB-3:0], below_q[AB-1:2] == at_q[AB-3:0] ? below_q[1:0] : 2'd3};
    assign idle_o        = state_q == IDLE;
    assign whole_o       = state_q == WHOLE || state_q == AWAIT;
    assign node_valid_o  = state_q == HEAD;
    assign node_o        = {low_o ? {here, 3'd0} : {3'd0, here}, base_q, line_q};
    assign child_valid_o = state_q == CHILD || state_q == WHOLE;
    assign child_o       = whole_o ? {1'b0, below_q, {AB{1'b0}}}
                         : {ends, low_o ? {2{at_q}} : {run_last, run}};
    always @(posedge clk) begin
        if (ball_i) ball_at_o <= ball_at_o + 1'b1;
        case (state_q)
            SIZE: begin
                first_q <= first_q + many;
                items_q <= one ? count_i : nodes;
                if (one) state_q <= BEGIN;
            end
            BEGIN: begin
                at_q      <= {AB{1'b0}};
                ball_at_o <= {AB{1'b0}};
                base_q  <= first_q;
                line_q  <= first_q - many;
                first_q <= first_q - many;
                if (low_o) next_o <= first_q + {{(LB-AB){1'b0}}, count_i[AB:1]} +
                                     {{(LB-1){1'b0}}, count_i[0]};
                state_q <= HEAD;
            end
            HEAD: if (node_ready_i) state_q <= CHILD;
            CHILD: if (child_ready_i) begin
                at_q <= at_q + 1'b1;
                if (ends) begin
                    line_q  <= line_q + 1'b1;
                    base_q  <= base_q + {{(LB-3){1'b0}}, low_o ? 3'd2 : 3'd4};
                    state_q <= left == 1 ? DRAIN : HEAD;
                end
            end
            DRAIN: if (drained_i) begin
                below_q <= items_q[AB-1:0] - 1'b1;
                if (!low_o) begin
                    items_q <= nodes;
                    upper_o <= 1'b1;
                end
                low_o   <= 1'b0;
                state_q <= one ? IDLE : low_o ? WHOLE : BEGIN;
            end
            WHOLE: if (child_ready_i) state_q <= AWAIT;
            AWAIT: if (whole_done_i) begin
                items_q <= nodes;
                state_q <= BEGIN;
            end
            default: ;
        endcase
        if (start_i) begin
            state_q <= SIZE;
            items_q <= count_i;
            first_q <= {LB{1'b0}};
            low_o   <= 1'b1;
            upper_o <= 1'b0;
        end
        if (rst) state_q <= IDLE;
    end
endmodule
`default_nettype wire
