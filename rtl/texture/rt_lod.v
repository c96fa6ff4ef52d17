// rt_lod.v - level of detail of a hit: log2(path) - base, limited to the image's levels
// SPDX-License-Identifier: Apache-2.0
//   lod = min(max(log2(path) - 4 - base, 0), levels - 1); path 0: 0
//   1..3 log2 | 4 difference | 5 limits
// Free-running, latency 5. Model: sph_lod() in cmodel/texture/lod.c
`timescale 1ns / 1ps
`default_nettype none
module rt_lod #(
    parameter PB  = 24,                 // path, bits: W + 8
    parameter TAG = 8                   // what travels along, bits
) (
    input  wire               clk,
    input  wire               rst,      // synchronous, active high
    input  wire               in_valid_i,
    input  wire [TAG-1:0]     in_tag_i,
    input  wire [PB-1:0]      in_path_i,    // u(PB-4).4 grid units
    input  wire signed [15:0] in_base_i,    // s7.8
    input  wire [3:0]         in_levels_i,  // 1 to 12
    output wire               out_valid_o,
    output wire [TAG-1:0]     out_tag_o,
    output wire [11:0]        out_lod_o     // u4.8
);
    // ---- stages 1 to 3: logarithm ----
    wire [13:0]        log2;                // u6.8
    wire signed [15:0] s3_base;
    wire [3:0]         s3_levels;
    wire               s3_zero;
    rt_log2 #(.XB(PB)) u_log2 (.clk(clk), .in_x_i(in_path_i), .out_log2_o(log2));
    rt_delay #(.WIDTH(21), .CYCLES(3)) u_wait (
        .clk(clk), .in_i({in_path_i == {PB{1'b0}}, in_levels_i, in_base_i}),
        .out_o({s3_zero, s3_levels, s3_base})
    );

    // ---- stage 4: difference, less 4: the path has four bits of fraction ----
    reg  signed [16:0] s4_lod_q;            // s8.8, -132 .. 156
    reg  [3:0]         s4_last_q;           // levels - 1
    always @(posedge clk) begin
        s4_lod_q  <= $signed({3'd0, log2}) - 17'sd1024 - {s3_base[15], s3_base};
        s4_last_q <= s3_levels - 4'd1;
        if (s3_zero) s4_lod_q <= 17'sd0;
    end

    // ---- stage 5: limits ----
    reg  [11:0]        s5_lod_q;
    wire               deep = s4_lod_q[15:8] >= {4'd0, s4_last_q};
    always @(posedge clk) s5_lod_q <= s4_lod_q[16] ? 12'd0 :
                                      deep ? {s4_last_q, 8'd0} : s4_lod_q[11:0];
    assign out_lod_o = s5_lod_q;

    rt_delay #(.WIDTH(TAG), .CYCLES(5)) u_tag (.clk(clk), .in_i(in_tag_i), .out_o(out_tag_o));
    rt_delay_valid #(.CYCLES(5)) u_valid (.clk(clk), .rst(rst), .in_i(in_valid_i),
                                          .out_o(out_valid_o));
endmodule
`default_nettype wire
