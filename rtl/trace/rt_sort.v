// rt_sort.v - orders the children that a ray hits, near first, ties by child number
// SPDX-License-Identifier: Apache-2.0
// Position of a child = number of hit children before it: six comparisons, no exchange.
// Latency 2 cycles, one node a cycle.
// Model: insert() in cmodel/trace/traverse.c
`timescale 1ns / 1ps
`default_nettype none
module rt_sort (
    input  wire        clk,
    input  wire        in_valid_i, // a node
    input  wire [3:0]  hit_i,     // children to order
    input  wire [63:0] near_i,    // 4 x s16 filter depth
    output reg  [2:0]  count_o,   // children in the list
    output reg  [71:0] list_o     // 4 x {near s16, child u2}, nearest lowest
);
    // ---- stage 1: who comes before whom ----
    reg [3:0]  s1_hit_q;
    reg [63:0] s1_near_q;
    reg [15:0] s1_before_q;       // bit 4*i+j: j is hit and comes before i
    reg       s1_valid_q;
    integer i, j;
    always @(posedge clk) begin
        s1_valid_q <= in_valid_i;
        if (in_valid_i) begin
            s1_hit_q  <= hit_i;
            s1_near_q <= near_i;
            for (i = 0; i < 4; i = i + 1)
                for (j = 0; j < 4; j = j + 1)
                    s1_before_q[4*i + j] <= hit_i[j] && i != j &&
                        (j < i ? $signed(near_i[16*j +: 16]) <= $signed(near_i[16*i +: 16])
                               : $signed(near_i[16*j +: 16]) <  $signed(near_i[16*i +: 16]));
        end
    end
    // ---- stage 2: place ----
    reg [2:0]  place;
    reg [71:0] list;
    integer k, n;
    always @* begin
        list = 72'd0;
        for (k = 0; k < 4; k = k + 1) begin
            place = {2'b0, s1_before_q[4*k]} + {2'b0, s1_before_q[4*k + 1]} +
                    {2'b0, s1_before_q[4*k + 2]} + {2'b0, s1_before_q[4*k + 3]};
            for (n = 0; n < 4; n = n + 1)
                if (s1_hit_q[k] && place == n[2:0])
                    list[18*n +: 18] = {s1_near_q[16*k +: 16], k[1:0]};
        end
    end
    always @(posedge clk) if (s1_valid_q) begin
        list_o  <= list;
        count_o <= {2'b0, s1_hit_q[0]} + {2'b0, s1_hit_q[1]} + {2'b0, s1_hit_q[2]} +
                   {2'b0, s1_hit_q[3]};
    end
endmodule
`default_nettype wire
