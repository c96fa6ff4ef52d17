// rt_sphere_uv.v - texture coordinates of a sphere from its normal in the texture's frame
// SPDX-License-Identifier: Apache-2.0
//   s = plus_s + scale_s * around, t = plus_t + scale_t * down    half up to 20 bits of fraction
//   rt_longitude, UNITS of them | operands of s, of t | products | sums
// In order: each unit takes 39 clocks. Normals must come at least 5 clocks apart, as they do from
// rt_coords, which takes nine clocks to turn one: so results do not meet.
// Model: sph_coords_sphere() in cmodel/texture/coords.c
`timescale 1ns / 1ps
`default_nettype none
module rt_sphere_uv #(
    parameter TAG   = 6,                   // what travels along, bits
    parameter UNITS = 2                    // of rt_longitude
) (
    input  wire               clk,
    input  wire               rst,         // synchronous, active high
    input  wire               in_valid_i,
    output wire               in_ready_o,
    input  wire [TAG-1:0]     in_tag_i,
    input  wire signed [18:0] in_x_i,      // s2.16
    input  wire signed [18:0] in_y_i,
    input  wire signed [18:0] in_z_i,
    input  wire [31:0]        in_scale_i,  // {t, s} s7.8
    input  wire [31:0]        in_plus_i,   // {t, s} s3.12
    output reg                out_valid_o, // one clock
    output wire [TAG-1:0]     out_tag_o,
    output reg  [39:0]        out_s_o,     // s19.20
    output reg  [39:0]        out_t_o
);
    // ---- longitude and latitude ----
    wire [UNITS-1:0]     u_ready, u_take, u_done, u_tag, unused_give;
    wire [36*UNITS-1:0]  u_results;
    wire                 along_valid;
    wire [TAG-1:0]       along_tag;
    wire [31:0]          along_scale, along_plus;
    wire [17:0]          around, down;     // u0.18 turns, u1.17 half turns
    rt_pool #(.UNITS(UNITS), .RW(36), .TAG(TAG + 64)) u_pool (
        .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .in_ready_o(in_ready_o),
        .in_tag_i({in_tag_i, in_scale_i, in_plus_i}),
        .ready_i(u_ready), .take_o(u_take), .done_i(u_done), .give_o(unused_give),
        .results_i(u_results),
        .out_valid_o(along_valid), .out_ready_i(1'b1),
        .out_tag_o({along_tag, along_scale, along_plus}), .out_result_o({around, down})
    );
    genvar u;
    generate
        for (u = 0; u < UNITS; u = u + 1) begin : g_unit
            rt_longitude #(.TAG(1)) u_longitude (
                .clk(clk), .rst(rst), .in_valid_i(u_take[u]), .in_ready_o(u_ready[u]),
                .in_tag_i(1'b0), .in_x_i(in_x_i), .in_y_i(in_y_i), .in_z_i(in_z_i),
                .out_valid_o(u_done[u]), .out_tag_o(u_tag[u]),
                .out_around_o(u_results[36*u+18 +: 18]), .out_down_o(u_results[36*u +: 18])
            );
            // for benches: {turned away, taken, clocks of work}
            wire [7:0] work_longitudes /* verilator public_flat_rd */ =
                {in_valid_i && !in_ready_o, u_take[u], 5'd0, u_take[u] || !u_ready[u]};
        end
    endgenerate

    // ---- scaled and moved: s, and a clock later t; one hit at a time ----
    reg                  s0_s_q, s0_t_q, s1_s_q, s1_t_q;
    reg  [TAG-1:0]       tag_q;
    reg  [15:0]          scale_t_q, plus_s_q, plus_t_q;
    reg  [17:0]          down_q;
    reg  signed [15:0]   s0_a_q;
    reg  signed [18:0]   s0_b_q;
    reg  signed [35:0]   s1_prod_q;
    assign out_tag_o   = tag_q;
    wire signed [35:0]   by_s = s1_prod_q >>> 6;
    wire signed [35:0]   by_t = s1_prod_q >>> 5;
    always @(posedge clk) begin
        if (along_valid) begin
            {tag_q, scale_t_q, down_q} <= {along_tag, along_scale[31:16], down};
            {plus_t_q, plus_s_q}       <= along_plus;
        end
        s0_a_q    <= along_valid ? along_scale[15:0] : scale_t_q;
        s0_b_q    <= {1'b0, along_valid ? around : down_q};
        s1_prod_q <= s0_a_q * s0_b_q;
        if (s1_s_q) out_s_o <= {{16{plus_s_q[15]}}, plus_s_q, 8'd0} + {{4{by_s[35]}}, by_s} +
                               {39'd0, s1_prod_q[5]};
        if (s1_t_q) out_t_o <= {{16{plus_t_q[15]}}, plus_t_q, 8'd0} + {{4{by_t[35]}}, by_t} +
                               {39'd0, s1_prod_q[4]};
        {s0_s_q, s1_s_q}    <= {along_valid, s0_s_q};
        {s0_t_q, s1_t_q}    <= {s0_s_q, s0_t_q};
        out_valid_o         <= s1_t_q;
        if (rst) {s0_s_q, s1_s_q, s0_t_q, s1_t_q, out_valid_o} <= 5'd0;
    end
`ifndef SYNTHESIS
    always @(posedge clk) if (!rst && along_valid && (s0_s_q || s0_t_q || s1_t_q)) begin
        $display("rt_sphere_uv: a result meets another");
        $finish;
    end
`endif
    wire unused = &{1'b0, u_tag, unused_give};
endmodule
`default_nettype wire
