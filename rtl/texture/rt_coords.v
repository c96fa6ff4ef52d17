// rt_coords.v - texture coordinates of a hit
// SPDX-License-Identifier: Apache-2.0
// Facet: s = s_0 + (s_x s_y s_z).point * 2^-s_e, t alike. Sphere: longitude and latitude of the
// unit normal, turned into the frame of the texture, scaled and moved. One multiplier, a product a
// clock:
//   operands | product | sum of three | facet: shift | shift | round, add
//                                     | sphere: turned normal .. rt_longitude .. scaled, added
// One hit at a time: 14 clocks for a facet, 59 for a sphere.
// Model: sph_coords() in cmodel/texture/coords.c
`default_nettype none
`include "rt_layout.vh"
module rt_coords #(
    parameter W   = 16,                    // coordinate, bits
    parameter NG  = 2                      // guard bits of the hit point
) (
    input  wire                clk,
    input  wire                rst,        // synchronous, active high
    input  wire                in_valid_i,
    output wire                in_ready_o,
    input  wire [255:0]        in_map_i,   // mapping record
    input  wire [3*(W+NG)-1:0] in_point_i, // {z, y, x} s(W+NG), guarded hit point
    input  wire [53:0]         in_unit_i,  // {z, y, x} s1.16, normal towards the ray's side
    input  wire                in_far_i,   // hit from inside
    output reg                 out_valid_o,
    input  wire                out_ready_i,
    output reg  [39:0]         out_s_o,    // s19.20, modulo 2^20
    output reg  [39:0]         out_t_o
);
    localparam GW = W + NG;
    localparam BW = GW > 19 ? GW : 19;     // second operand
    localparam PW = 18 + BW + 2;           // sum of three products
    localparam SW = PW + 33;               // before the shift: 32 places left, one bit to round

    // ---- the hit at hand ----
    reg              busy_q, far_q;
    reg [255:0]      map_q;
    reg [3*GW-1:0]   point_q;
    reg [53:0]       unit_q;
    wire             take   = in_valid_i && in_ready_o;
    wire             sphere = map_q[`RT_MAP_KIND_LSB];
    assign in_ready_o = !busy_q;

    // ---- steps: products 0 to 5 of a facet, 0 to 8 and then 9, 10 of a sphere ----
    reg              go_q;                 // a product is begun in this clock
    reg [3:0]        step_q;
    reg [1:0]        part_q;               // x, y, z
    wire             end_facet  = !sphere && step_q == 4'd5;
    wire             end_turns  = sphere && step_q == 4'd8;
    wire             end_sphere = sphere && step_q == 4'd10;
    wire             along_valid;          // of rt_longitude
    wire [17:0]      around, down;
    reg  [17:0]      around_q, down_q;
    always @(posedge clk) begin
        if (along_valid) {around_q, down_q} <= {around, down};
        if (take) begin
            {map_q, point_q, unit_q, far_q} <= {in_map_i, in_point_i, in_unit_i, in_far_i};
            step_q <= 4'd0;
            part_q <= 2'd0;
        end else if (go_q) begin
            step_q <= step_q + 4'd1;
            part_q <= part_q == 2'd2 ? 2'd0 : part_q + 2'd1;
        end
        if (take || along_valid) go_q <= 1'b1;
        else if (end_facet || end_turns || end_sphere) go_q <= 1'b0;
        if (take) busy_q <= 1'b1;
        else if (out_valid_o && out_ready_i) busy_q <= 1'b0;
        if (rst) begin go_q <= 1'b0; busy_q <= 1'b0; end
    end

    // ---- operands ----
    wire signed [17:0] first  = map_q[`RT_MAP_S_X_LSB + 18*part_q +: 18];
    wire signed [17:0] second = map_q[`RT_MAP_T_X_LSB + 18*part_q +: 18];
    wire signed [15:0] turn   = map_q[`RT_MAP_TURN_LSB + 16*step_q +: 16];
    wire signed [15:0] scale  = step_q[0] ? map_q[`RT_MAP_SCALE_S_LSB +: 16]
                                          : map_q[`RT_MAP_SCALE_T_LSB +: 16];
    wire signed [GW-1:0] point = point_q[GW*part_q +: GW];
    wire signed [17:0] unit   = unit_q[18*part_q +: 18];
    wire signed [18:0] along  = $signed({1'b0, step_q[0] ? around_q : down_q});
    wire               scaled = step_q == 4'd9 || step_q == 4'd10;
    reg                s0_go_q, s1_go_q, s2_go_q;        // last product of a sum
    reg                s0_first_q, s1_first_q;
    reg  [3:0]         s0_step_q, s1_step_q, s2_step_q;
    reg  signed [17:0] s0_a_q;
    reg  signed [BW-1:0] s0_b_q;
    reg  signed [PW-3:0] s1_prod_q;
    reg  signed [PW-1:0] s2_sum_q;
    always @(posedge clk) begin
        s0_go_q    <= go_q && (part_q == 2'd2 || scaled);
        s0_first_q <= part_q == 2'd0 || scaled;
        s0_step_q  <= step_q;
        s0_a_q     <= sphere ? (scaled ? {{2{scale[15]}}, scale} : {{2{turn[15]}}, turn})
                             : step_q < 4'd3 ? first : second;
        s0_b_q     <= sphere ? (scaled ? {{(BW-19){along[18]}}, along}
                                       : {{(BW-18){unit[17]}}, unit})
                             : {{(BW-GW){point[GW-1]}}, point};
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

    // ---- sphere: the turned normal, then its longitude and latitude ----
    wire               s2_turned = s2_go_q && sphere && s2_step_q <= 4'd8;
    wire               s2_scaled = s2_go_q && sphere && s2_step_q > 4'd8;
    wire signed [PW-1:0] out_sum = far_q ? -s2_sum_q : s2_sum_q;          // outward
    wire [18:0]        turned = out_sum[33:15] + {18'd0, out_sum[14]};
    reg  signed [18:0] x_q, y_q, z_q;
    reg                turned_q;
    always @(posedge clk) begin
        if (s2_turned) {x_q, y_q, z_q} <= {y_q, z_q, turned};
        turned_q <= s2_turned && s2_step_q == 4'd8;
        if (rst) turned_q <= 1'b0;
    end
    wire               along_ready, along_tag;
    rt_longitude #(.TAG(1)) u_longitude (
        .clk(clk), .rst(rst), .in_valid_i(turned_q), .in_ready_o(along_ready), .in_tag_i(1'b0),
        .in_x_i(x_q), .in_y_i(y_q), .in_z_i(z_q),
        .out_valid_o(along_valid), .out_tag_o(along_tag), .out_around_o(around),
        .out_down_o(down)
    );
    wire [15:0]        plus_s = map_q[`RT_MAP_PLUS_S_LSB +: 16];
    wire [15:0]        plus_t = map_q[`RT_MAP_PLUS_T_LSB +: 16];
    wire signed [35:0] s2_sum = s2_sum_q[35:0];
    wire signed [35:0] by_s   = s2_sum >>> 6;
    wire signed [35:0] by_t   = s2_sum >>> 5;
    wire [39:0]        sphere_s = {{16{plus_s[15]}}, plus_s, 8'd0} + {{4{by_s[35]}}, by_s} +
                                  {39'd0, s2_sum[5]};
    wire [39:0]        sphere_t = {{16{plus_t[15]}}, plus_t, 8'd0} + {{4{by_t[35]}}, by_t} +
                                  {39'd0, s2_sum[4]};

    // ---- result ----
    always @(posedge clk) begin
        if (s4_go_q && !s4_t_q) out_s_o <= s4_round[40:1] + at_s;
        if (s4_go_q && s4_t_q)  out_t_o <= s4_round[40:1] + at_t;
        if (s2_scaled && s2_step_q == 4'd9)  out_s_o <= sphere_s;
        if (s2_scaled && s2_step_q == 4'd10) out_t_o <= sphere_t;
        if ((s4_go_q && s4_t_q) || (s2_scaled && s2_step_q == 4'd10)) out_valid_o <= 1'b1;
        else if (out_ready_i) out_valid_o <= 1'b0;
        if (rst) out_valid_o <= 1'b0;
    end
    wire unused = &{1'b0, along_ready, along_tag, map_q, out_sum, s3_wide, s4_round[0]};
endmodule
`default_nettype wire
