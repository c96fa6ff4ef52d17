// rt_box_depth.v - the depth of a T-word, by which boxes are ordered: its first bits, rising
// SPDX-License-Identifier: Apache-2.0
//   n = max(0, length(time) - 12)      depth = n * 2^11 + (time >> n)
// The first bit of time >> n is 1 if n > 0, so that the sum is {n + 1, the 11 bits behind it}.
// Combinational.
// Model: sph_box_depth() in cmodel/trace/bih.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_box_depth (
    input  wire [`RT_BIH_T-1:0] time_i,
    output reg  [14:0]          depth_o    // below 11 * 2^11
);
    localparam NW = `RT_BOX_NEAR;
    localparam MOST = `RT_BIH_T - NW - 1;        // places that the longest word is shifted
    integer n;
    always @* begin
        depth_o = time_i >> (NW + 1) == 0 ? {{(14-NW){1'b0}}, time_i[NW:0]} : 15'd0;
        for (n = 1; n <= MOST; n = n + 1)
            if (time_i >> (NW + n) == 1) depth_o = depth_o | {n[3:0] + 4'd1, time_i[n +: NW]};
    end
endmodule
`default_nettype wire
