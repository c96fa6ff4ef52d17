// f_any_build.v - stand for the parts of rt_build in proofs: they say anything in any clock
// SPDX-License-Identifier: Apache-2.0
// A queue holds its first word until it is taken.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_slot_ram #(
    parameter WIDTH = 32, parameter SLOTS = 16, parameter OLD = 1, parameter AB = $clog2(SLOTS)
) (
    input wire clk, input wire wr_en_i, input wire [AB-1:0] wr_addr_i,
    input wire [WIDTH-1:0] wr_data_i, input wire rd_en_i, input wire [AB-1:0] rd_addr_i,
    output wire [WIDTH-1:0] rd_data_o
);
    (* anyseq *) wire [WIDTH-1:0] any;
    assign rd_data_o = any;
endmodule
module rt_fifo #(parameter WIDTH = 8, parameter DEPTH = 16) (
    input wire clk, input wire rst, input wire in_valid_i, output wire in_ready_o,
    input wire [WIDTH-1:0] in_data_i, output reg out_valid_o, input wire out_ready_i,
    output reg [WIDTH-1:0] out_data_o
);
    (* anyseq *) wire [WIDTH+1:0] any;
    assign in_ready_o = any[WIDTH+1];
    always @(posedge clk) begin
        if (!out_valid_o || out_ready_i) {out_valid_o, out_data_o} <= any[WIDTH:0];
        if (rst) out_valid_o <= 1'b0;
    end
endmodule
module rt_build_sort #(parameter AB = 12) (
    input wire clk, input wire rst, input wire clear_i, output wire ready_o,
    input wire key_valid_i, input wire [3*`RT_BUILD_AXIS-1:0] key_i, input wire sort_i,
    input wire [AB:0] count_i, output wire done_o, input wire a_en_i, input wire a_copy_i,
    input wire [AB-1:0] a_place_i, output wire [AB-1:0] a_id_o, input wire b_en_i,
    input wire [AB-1:0] b_place_i, output wire [AB-1:0] b_id_o, input wire link_i,
    input wire [AB-1:0] link_from_i, input wire [AB-1:0] link_to_i, input wire put_i,
    input wire [AB-1:0] put_place_i, input wire [AB-1:0] put_id_i
);
    (* anyseq *) wire [2*AB+1:0] any;
    assign {ready_o, done_o, a_id_o, b_id_o} = any;
endmodule
module rt_build_join #(parameter W = 16, parameter AB = 12, parameter SW = 12) (
    input wire clk, input wire rst, input wire start_i, input wire [AB:0] count_i,
    input wire [1:0] rounds_i, output wire done_o, output wire [AB-1:0] root_o,
    output wire read_o, output wire [AB-1:0] place_o, input wire [AB-1:0] id_i,
    input wire [4*W-1:0] leaf_i, output wire pair_o, output wire [AB-1:0] number_o,
    output wire [2*AB+SW-1:0] pair_data_o, output wire link_o, output wire [AB-1:0] link_from_o,
    output wire [AB-1:0] link_to_o, output wire put_o, output wire [AB-1:0] put_place_o,
    output wire [AB-1:0] put_id_o, input wire [AB-1:0] next_i
);
    (* anyseq *) wire [9*AB+SW+4:0] any;
    assign {done_o, root_o, read_o, place_o, pair_o, number_o, pair_data_o, link_o, link_from_o,
            link_to_o, put_o, put_place_o, put_id_o} = any;
endmodule
module rt_build_nodes #(parameter AB = 12, parameter SW = 20, parameter LB = AB + 2) (
    input wire clk, input wire rst, input wire start_i, input wire [AB-1:0] last_i,
    input wire [AB-1:0] root_i, output wire idle_o, output wire [LB-1:0] next_o,
    output wire read_o, output wire [AB-1:0] number_o, input wire [3*AB+SW-1:0] pair_i,
    output wire node_valid_o, input wire node_ready_i, output wire [2*LB+5:0] node_o,
    output wire child_valid_o, input wire child_ready_i, output wire [2*AB:0] child_o
);
    (* anyseq *) wire [3*AB+3*LB+10:0] any;
    assign {idle_o, next_o, read_o, number_o, node_valid_o, node_o, child_valid_o, child_o} =
           any[3*AB+3*LB+10:0];
endmodule
module rt_build_groups #(parameter AB = 12, parameter LB = AB + 2) (
    input wire clk, input wire rst, input wire start_i, input wire [AB:0] count_i,
    output wire idle_o, output wire [LB-1:0] next_o, input wire drained_i,
    input wire whole_done_i, output wire low_o, output wire upper_o, output wire whole_o,
    input wire ball_i, output wire [AB-1:0] ball_at_o, output wire node_valid_o,
    input wire node_ready_i, output wire [2*LB+5:0] node_o, output wire child_valid_o,
    input wire child_ready_i, output wire [2*AB:0] child_o
);
    (* anyseq *) wire [3*AB+3*LB+12:0] any;
    assign {idle_o, next_o, low_o, upper_o, whole_o, ball_at_o, node_valid_o, node_o,
            child_valid_o, child_o} = any;
endmodule
module rt_build_bound #(parameter W = 16, parameter FW = 14, parameter AB = 12) (
    input wire clk, input wire rst, input wire start_i, input wire corner_i, input wire whole_i,
    input wire child_valid_i, output wire child_ready_o, input wire [2*AB:0] child_i,
    output wire a_read_o, output wire [AB-1:0] a_place_o, input wire [4*W-1:0] a_leaf_i,
    output wire b_read_o, output wire [AB-1:0] b_place_o, input wire [4*W-1:0] b_leaf_i,
    input wire [AB:0] b_mark_i, output wire out_valid_o, input wire out_ready_i,
    output wire [1:0] out_kind_o, output wire [55:0] out_child_o,
    output wire [4*W+AB:0] out_leaf_o, output wire ball_o, output wire [4*W-1:0] ball_leaf_o
);
    (* anyseq *) wire [3*AB+8*W+62:0] any;
    assign {child_ready_o, a_read_o, a_place_o, b_read_o, b_place_o, out_valid_o, out_kind_o,
            out_child_o, out_leaf_o, ball_o, ball_leaf_o} = any;
endmodule
`default_nettype wire
