// rt_coords.v - texture coordinates of a hit
// SPDX-License-Identifier: Apache-2.0
// Facet: s = s_0 + (s_x s_y s_z).point * 2^-s_e, t alike. Sphere: longitude and latitude of the
// unit normal, turned into the frame of the texture, scaled and moved. One multiplier, a product a
// clock:
//   operands | product | sum of three | facet: shift | shift | round, add
//                                     | sphere: turned normal, then rt_sphere_uv
// A facet every 13 clocks or so, or a sphere, of which UNITS are in rt_sphere_uv at a time; hits
// may overtake each other. 13 clocks for a facet, 57 for a sphere.
// Model: sph_coords() in cmodel/texture/coords.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_coords #(
    parameter W   = 16,                    // coordinate, bits
    parameter NG  = 2,                     // guard bits of the hit point
    parameter TAG = 6,                     // what travels along, bits
    parameter UNITS = 2                    // spheres in rt_sphere_uv at once
) (
    input  wire                clk,
    input  wire                rst,        // synchronous, active high
    input  wire                in_valid_i,
    output wire                in_ready_o,
    input  wire [TAG-1:0]      in_tag_i,
    input  wire [255:0]        in_map_i,   // mapping record
    input  wire [3*(W+NG)-1:0] in_point_i, // {z, y, x} s(W+NG), guarded hit point
    input  wire [53:0]         in_unit_i,  // {z, y, x} s1.16, normal towards the ray's side
    input  wire                in_far_i,   // hit from inside
    output wire                out_valid_o,// one clock
    output wire [TAG-1:0]      out_tag_o,
    output wire [39:0]         out_s_o,    // s19.20, modulo 2^20
    output wire [39:0]         out_t_o
);
    localparam GW = W + NG;
    localparam BW = GW > 18 ? GW : 18;     // second operand
    localparam PW = 18 + BW + 2;           // sum of three products
    localparam SW = PW + 33;               // before the shift: 32 places left, one bit to round

    // ---- the hit at hand ----
    reg              busy_q, far_q;
    reg [TAG-1:0]    tag_q;
    reg [255:0]      map_q;
    reg [3*GW-1:0]   point_q;
    reg [53:0]       unit_q;
    wire             take   = in_valid_i && in_ready_o;
    wire             sphere = map_q[`RT_MAP_KIND_LSB];
    assign in_ready_o = !busy_q;

    // ---- steps: products 0 to 5 of a facet, 0 to 8 of a sphere ----
    reg              go_q;                 // a product is begun in this clock
    reg [3:0]        step_q;
    reg [1:0]        part_q;               // x, y, z
    wire             end_facet  = !sphere && step_q == 4'd5;
    wire             end_sphere = sphere && step_q == 4'd8;
    reg              facet_q, sphere_q;    // a facet is done; a normal is turned
    wire             facet_go, sphere_go;  // it leaves
    always @(posedge clk) begin
        if (take) begin
            {tag_q, map_q, point_q, unit_q, far_q} <= {in_tag_i, in_map_i, in_point_i, in_unit_i,
                                                       in_far_i};
            step_q <= 4'd0;
            part_q <= 2'd0;
        end else if (go_q) begin
            step_q <= step_q + 4'd1;
            part_q <= part_q == 2'd2 ? 2'd0 : part_q + 2'd1;
        end
        if (take) go_q <= 1'b1;
        else if (end_facet || end_sphere) go_q <= 1'b0;
        if (take) busy_q <= 1'b1;
        else if (facet_go || sphere_go) busy_q <= 1'b0;
        if (rst) begin go_q <= 1'b0; busy_q <= 1'b0; end
    end

    // ---- operands ----
    // Chosen by name: a slice from a place that is computed is a multiplication and a long shift.
    wire [53:0]        s_axes = map_q[`RT_MAP_S_X_LSB +: 54];
    wire [53:0]        t_axes = map_q[`RT_MAP_T_X_LSB +: 54];
    wire [143:0]       turns  = map_q[`RT_MAP_TURN_LSB +: 144];
    wire               is_y = part_q == 2'd1, is_z = part_q == 2'd2;
    wire signed [17:0] first  = is_z ? s_axes[53:36] : is_y ? s_axes[35:18] : s_axes[17:0];
    wire signed [17:0] second = is_z ? t_axes[53:36] : is_y ? t_axes[35:18] : t_axes[17:0];
    wire signed [15:0] turn   = turns[16*step_q +: 16];
    wire signed [GW-1:0] point = is_z ? point_q[2*GW +: GW] : is_y ? point_q[GW +: GW]
                                                            : point_q[0 +: GW];
    wire signed [17:0] unit   = is_z ? unit_q[53:36] : is_y ? unit_q[35:18] : unit_q[17:0];
    reg                s0_go_q, s1_go_q, s2_go_q;        // last product of a sum
    reg                s0_first_q, s1_first_q;
    reg  [3:0]         s0_step_q, s1_step_q, s2_step_q;
    reg  signed [17:0] s0_a_q;
    reg  signed [BW-1:0] s0_b_q;
    reg  signed [PW-3:0] s1_prod_q;
    reg  signed [PW-1:0] s2_sum_q;
    always @(posedge clk) begin
        s0_go_q    <= go_q && part_q == 2'd2;
        s0_first_q <= part_q == 2'd0;
        s0_step_q  <= step_q;
        s0_a_q     <= sphere ? {{2{turn[15]}}, turn} : step_q < 4'd3 ? first : second;
        s0_b_q     <= sphere ? {{(BW-18){unit[17]}}, unit} : {{(BW-GW){point[GW-1]}}, point};
        s1_go_q    <= s0_go_q;
        s1_first_q <= s0_first_q;
        s1_step_q  <= s0_step_q;
        s1_prod_q  <= s0_a_q * s0_b_q;
        s2_go_q    <= s1_go_q;
        s2_step_q  <= s1_step_q;
        s2_sum_q   <= (s1_first_q ? {PW{1'b0}} : s2_sum_q) +
                      {{2{s1_prod_q[PW-3]}}, s1_prod_q};
        if (rst) {s0_go_q, s1_go_q, s2_go_q} <= 3'd0;
    end

    // ---- facet: shifted, rounded half up, added ----
    wire               s2_facet = s2_go_q && !sphere;
    wire               s2_t     = s2_step_q == 4'd5;
    wire [5:0]         e_s      = map_q[`RT_MAP_S_E_LSB +: 6];
    wire [5:0]         e_t      = map_q[`RT_MAP_T_E_LSB +: 6];
    wire [5:0]         shift    = (s2_t ? e_t : e_s) ^ 6'd32;    // e + 32
    reg                s3_go_q, s3_t_q, s4_go_q, s4_t_q;
    reg  [2:0]         s3_shift_q;
    reg  signed [SW-1:0] s3_q;
    reg  [40:0]        s4_q;
    wire signed [SW-1:0] s2_wide = $signed({s2_sum_q, 33'd0});
    wire signed [SW-1:0] s3_wide = s3_q >>> s3_shift_q;
    wire [40:0]        s4_round = s4_q + 41'd1;
    wire [39:0]        at_s     = map_q[`RT_MAP_S_0_LSB +: 40];
    wire [39:0]        at_t     = map_q[`RT_MAP_T_0_LSB +: 40];
    always @(posedge clk) begin
        s3_go_q    <= s2_facet;
        s3_t_q     <= s2_t;
        s3_shift_q <= shift[2:0];
        s3_q       <= s2_wide >>> {shift[5:3], 3'd0};
        s4_go_q    <= s3_go_q;
        s4_t_q     <= s3_t_q;
        s4_q       <= s3_wide[40:0];
        if (rst) {s3_go_q, s4_go_q} <= 2'd0;
    end

    reg  [39:0]        s_q, t_q;
    always @(posedge clk) begin
        if (s4_go_q && !s4_t_q) s_q <= s4_round[40:1] + at_s;
        if (s4_go_q && s4_t_q)  t_q <= s4_round[40:1] + at_t;
        if (s4_go_q && s4_t_q) facet_q <= 1'b1;
        else if (facet_go) facet_q <= 1'b0;
        if (rst) facet_q <= 1'b0;
    end

    // ---- sphere: the turned normal ----
    wire               s2_turned = s2_go_q && sphere;
    wire signed [PW-1:0] out_sum = far_q ? -s2_sum_q : s2_sum_q;          // outward
    wire [18:0]        turned = out_sum[33:15] + {18'd0, out_sum[14]};
    reg  signed [18:0] x_q, y_q, z_q;
    always @(posedge clk) begin
        if (s2_turned) {x_q, y_q, z_q} <= {y_q, z_q, turned};
        if (s2_turned && s2_step_q == 4'd8) sphere_q <= 1'b1;
        else if (sphere_go) sphere_q <= 1'b0;
        if (rst) sphere_q <= 1'b0;
    end
    wire               a_ready, a_valid;
    wire [TAG-1:0]     a_tag;
    wire [39:0]        a_s, a_t;
    assign sphere_go = sphere_q && a_ready;
    rt_sphere_uv #(.TAG(TAG), .UNITS(UNITS)) u_around (
        .clk(clk), .rst(rst), .in_valid_i(sphere_q), .in_ready_o(a_ready), .in_tag_i(tag_q),
        .in_x_i(x_q), .in_y_i(y_q), .in_z_i(z_q),
        .in_scale_i({map_q[`RT_MAP_SCALE_T_LSB +: 16], map_q[`RT_MAP_SCALE_S_LSB +: 16]}),
        .in_plus_i({map_q[`RT_MAP_PLUS_T_LSB +: 16], map_q[`RT_MAP_PLUS_S_LSB +: 16]}),
        .out_valid_o(a_valid), .out_tag_o(a_tag), .out_s_o(a_s), .out_t_o(a_t)
    );

    // ---- result: spheres first, a facet waits ----
    assign facet_go    = facet_q && !a_valid;
    assign out_valid_o = facet_q || a_valid;
    assign out_tag_o   = a_valid ? a_tag : tag_q;
    assign out_s_o     = a_valid ? a_s : s_q;
    assign out_t_o     = a_valid ? a_t : t_q;
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_texture_coordinates /* verilator public_flat_rd */ =
        {in_valid_i && !in_ready_o, take, 5'd0,
         take || (busy_q && !(sphere_q && !a_ready))};
    wire unused = &{1'b0, map_q, out_sum, s3_wide, s4_round[0]};
endmodule
`default_nettype wire
