// rt_build_chain.v - neighbours of an order joined to a binary tree
// SPDX-License-Identifier: Apache-2.0
//   behind: .. q p | x .. ahead, then spheres that nobody has looked at
// If the box around q and p is no larger than that around p and x, q and p are joined and become x;
// if it is, x is put behind, where it is the next p. A step takes 2 clocks: the edges of the box
// around p and x, then what is done. n spheres take 3n steps at most. p, q, x are registers; what
// is below them stands in one memory, `behind` from its start up, `ahead` from its end down.
// Model: sph_bt_chain() in cmodel/build/chain.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_build_chain #(
    parameter W  = 16,                       // coordinate, bits
    parameter AB = 12,                       // bits of the number of a sphere
    parameter SW = W + 4                     // bits of a size, derived: leave alone
) (
    input  wire          clk,
    input  wire          rst,                // synchronous, active high
    // from rt_build
    input  wire          start_i,
    input  wire [AB:0]   count_i,            // spheres, at least 1
    output reg           done_o,
    output wire [AB-1:0] root_o,             // number of the last pair
    // spheres in their order, two clocks after their place
    output wire          read_o,
    output wire [AB-1:0] place_o,
    input  wire [4*W-1:0] leaf_i,            // radius uW, centre z, y, x sW
    // pairs to rt_build_nodes
    output wire          pair_o,
    output wire [AB-1:0] number_o,
    output wire [2*AB+SW-1:0] pair_data_o    // size, right, left
);
    localparam BW = W + 2;                   // bits of a side of a box, signed
    localparam SB = $clog2(`RT_BUILD_STACK);
    localparam CW = 6*BW + 2*AB + 1 + SW;    // a cluster: size, leaf, last, number, box
    localparam NUMBER = 6*BW, PLACE = 6*BW + AB, LEAF = 6*BW + 2*AB, SIZE = LEAF + 1;

    // ---- boxes: low x, y, z, then high x, y, z ----
    function [6*BW-1:0] around;
        input [6*BW-1:0] a;
        input [6*BW-1:0] b;
        integer i;
        begin
            for (i = 0; i < 3; i = i + 1) begin
                around[BW*i +: BW] = $signed(a[BW*i +: BW]) < $signed(b[BW*i +: BW])
                                     ? a[BW*i +: BW] : b[BW*i +: BW];
                around[BW*(3+i) +: BW] = $signed(a[BW*(3+i) +: BW]) > $signed(b[BW*(3+i) +: BW])
                                         ? a[BW*(3+i) +: BW] : b[BW*(3+i) +: BW];
            end
        end
    endfunction
    localparam [1:0] IDLE = 2'd0, EDGES = 2'd1, ACT = 2'd2;
    reg  [1:0]     state_q;
    reg  [CW-1:0]  p_q, q_q, x_q;
    reg            any_q;                    // x is there
    reg  [SB:0]    behind_q;                 // with p and q
    reg  [SB-1:0]  ahead_q;                  // without x
    reg  [BW-1:0]  edge_x_q, edge_y_q, edge_z_q; // of the box around p and x
    wire [SW-1:0]  size = {{(SW-BW){1'b0}}, edge_x_q} + {{(SW-BW){1'b0}}, edge_y_q} +
                          {{(SW-BW){1'b0}}, edge_z_q};
    reg  [AB:0]    taken_q;                  // spheres that are or were x
    reg            refill_q;                 // q is to be read
    wire           act  = state_q == ACT;
    wire           two  = behind_q > 1;
    wire           full = x_q[LEAF] && behind_q == `RT_BUILD_STACK;
    wire           merge = act && two && (!any_q || p_q[SIZE +: SW] <= size || full);
    wire           push = act && !merge && any_q;
    wire           wait_x = state_q != IDLE && !any_q && taken_q != count_i;

    // ---- the next spheres, read ahead: at most four that are asked for and not yet x ----
    reg  [AB:0]    asked_q;                  // places asked for
    reg  [1:0]     coming_q;                 // asked for a clock ago, two clocks ago
    wire [AB:0]    ahead_of = asked_q - taken_q;
    wire           leaf_valid;
    wire [4*W-1:0] leaf;
    wire           use_leaf = leaf_valid && (wait_x || (push && ahead_q == 0));
    wire           leaf_room;                // always, by ahead_of
    rt_fifo #(.WIDTH(4*W), .DEPTH(4)) u_leaves (
        .clk(clk), .rst(rst || start_i),
        .in_valid_i(coming_q[1]), .in_ready_o(leaf_room), .in_data_i(leaf_i),
        .out_valid_o(leaf_valid), .out_ready_i(use_leaf), .out_data_o(leaf)
    );
    assign read_o  = state_q != IDLE && asked_q != count_i && ahead_of < 4;
    assign place_o = asked_q[AB-1:0];
    wire [6*BW-1:0] leaf_box;
    genvar i;
    generate
        for (i = 0; i < 3; i = i + 1) begin : g_axis
            wire [BW-1:0] centre = {{2{leaf[W*i + W - 1]}}, leaf[W*i +: W]};
            wire [BW-1:0] radius = {2'b00, leaf[3*W +: W]};
            assign leaf_box[BW*i +: BW]     = centre - radius;
            assign leaf_box[BW*(3+i) +: BW] = centre + radius;
        end
    endgenerate

    // ---- clusters that wait ----
    wire [SB-1:0]  low  = behind_q[SB-1:0];
    wire [SB-1:0]  top  = ~ahead_q;          // the first free place ahead
    wire [SB-1:0]  below_p = low - {{(SB-2){1'b0}}, 2'd2};
    wire [SB-1:0]  below_q = low - {{(SB-2){1'b0}}, 2'd3};
    wire [CW-1:0]  popped;
    rt_slot_file #(.WIDTH(CW), .SLOTS(`RT_BUILD_STACK)) u_stack (
        .clk(clk),
        .wr_en_i((merge && any_q) || (push && two)),
        .wr_addr_i(merge ? top : below_p),
        .wr_data_i(merge ? x_q : q_q),
        .rd_addr_i(refill_q ? below_p : merge ? below_q : top + 1'b1),
        .rd_data_o(popped)
    );
    assign pair_o      = merge;
    assign number_o    = q_q[PLACE +: AB];
    assign pair_data_o = {p_q[SIZE +: SW], p_q[NUMBER +: AB], q_q[NUMBER +: AB]};
    assign root_o      = p_q[NUMBER +: AB];

    wire [6*BW-1:0] both = around(p_q[6*BW-1:0], x_q[6*BW-1:0]);
    always @(posedge clk) begin
        edge_x_q <= both[BW*3 +: BW] - both[BW*0 +: BW];
        edge_y_q <= both[BW*4 +: BW] - both[BW*1 +: BW];
        edge_z_q <= both[BW*5 +: BW] - both[BW*2 +: BW];
        refill_q <= merge && behind_q > 3;
        done_o   <= 1'b0;
        coming_q <= {coming_q[0], read_o};
        if (read_o) asked_q <= asked_q + 1'b1;
        if (use_leaf) taken_q <= taken_q + 1'b1;
        if (refill_q) q_q <= popped;
        case (state_q)
            EDGES: state_q <= wait_x ? EDGES : ACT;
            ACT: begin
                state_q <= EDGES;
                if (!two && !any_q) begin
                    state_q <= IDLE;
                    done_o  <= 1'b1;
                end
            end
            default: ;
        endcase
        if (merge) begin
            x_q      <= {{SW{1'b0}}, 1'b0, p_q[PLACE +: AB], q_q[PLACE +: AB],
                         around(q_q[6*BW-1:0], p_q[6*BW-1:0])};
            any_q    <= 1'b1;
            p_q      <= popped;
            behind_q <= behind_q - {{(SB-1){1'b0}}, 2'd2};
            if (any_q) ahead_q <= ahead_q + 1'b1;
        end
        if (push) begin
            q_q      <= p_q;
            p_q      <= {size, x_q[SIZE-1:0]};
            behind_q <= behind_q + 1'b1;
            any_q    <= ahead_q != 0;
            x_q      <= popped;
            if (ahead_q != 0) ahead_q <= ahead_q - 1'b1;
        end
        if (use_leaf) begin
            x_q   <= {{SW{1'b0}}, 1'b1, taken_q[AB-1:0], taken_q[AB-1:0], leaf_box};
            any_q <= 1'b1;
        end
        if (start_i) begin
            state_q  <= EDGES;
            any_q    <= 1'b0;
            behind_q <= {(SB+1){1'b0}};
            ahead_q  <= {SB{1'b0}};
            taken_q  <= {(AB+1){1'b0}};
            asked_q  <= {(AB+1){1'b0}};
            coming_q <= 2'd0;
        end
        if (rst) begin
            state_q <= IDLE;
            done_o  <= 1'b0;
        end
    end
    wire unused = &{1'b0, leaf_room};
endmodule
`default_nettype wire
