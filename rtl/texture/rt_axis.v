// rt_axis.v - the texels around a coordinate along one axis, and their weight
// SPDX-License-Identifier: Apache-2.0
//   size = max(1, (last + 1) >> level), place = floor(fraction * size * 2^8), u12.8
//   second = floor(place + 1/2), first = second - 1; beyond the ends: repeated, or the end's
//   1 fraction, size | 2 product | 1 texels
// Free-running, latency 4. Model: sph_axis_at() in cmodel/texture/texel.c
`default_nettype none
module rt_axis #(
    parameter TAG = 8                    // what travels along, bits
) (
    input  wire           clk,
    input  wire           rst,           // synchronous, active high
    input  wire           in_valid_i,
    input  wire [TAG-1:0] in_tag_i,
    input  wire [39:0]    in_at_i,       // s19.20 repeats
    input  wire [11:0]    in_last_i,     // size of level 0, less 1
    input  wire [3:0]     in_level_i,    // 0 to 11
    input  wire           in_clamp_i,    // 0: repeats, 1: stays at the edge
    output wire           out_valid_o,
    output wire [TAG-1:0] out_tag_o,
    output reg  [11:0]    out_first_o,
    output reg  [11:0]    out_second_o,
    output reg  [11:0]    out_nearest_o,
    output reg  [7:0]     out_weight_o   // u0.8, of the second
);
    // ---- stage 1: fraction and size ----
    wire [12:0] size = ({1'b0, in_last_i} + 13'd1) >> in_level_i;
    wire        beyond = !in_at_i[39] && |in_at_i[38:20];
    reg  [19:0] s1_inside_q;             // u0.20
    reg  [12:0] s1_size_q;
    always @(posedge clk) begin
        s1_inside_q <= !in_clamp_i ? in_at_i[19:0] : in_at_i[39] ? 20'd0 :
                       beyond ? 20'hfffff : in_at_i[19:0];
        s1_size_q   <= size == 13'd0 ? 13'd1 : size;
    end

    // ---- stages 2 and 3: product ----
    wire signed [38:0] product;
    wire [12:0]        s3_size;
    wire               s3_clamp;
    rt_product #(.AW(21), .BW(18)) u_product (
        .clk(clk), .a_i({1'b0, s1_inside_q}), .b_i({5'd0, s1_size_q}), .p_o(product)
    );
    rt_delay #(.WIDTH(13), .CYCLES(2)) u_size (.clk(clk), .in_i(s1_size_q), .out_o(s3_size));
    rt_delay #(.WIDTH(1), .CYCLES(3)) u_clamp (.clk(clk), .in_i(in_clamp_i), .out_o(s3_clamp));

    // ---- stage 4: texels ----
    wire [20:0] half = {1'b0, product[31:12]} + 21'd128;   // place + 1/2, u13.8
    wire [12:0] last = s3_size - 13'd1;
    wire [12:0] before = half[20:8] - 13'd1;
    wire        low  = half[20:8] == 13'd0;                // the first texel lies before the image
    wire        high = half[20:8] == s3_size;              // the second one behind it
    always @(posedge clk) begin
        out_first_o   <= !low ? before[11:0] : s3_clamp ? 12'd0 : last[11:0];
        out_second_o  <= !high ? half[19:8] : s3_clamp ? last[11:0] : 12'd0;
        out_nearest_o <= product[31:20];
        out_weight_o  <= half[7:0];
    end

    rt_delay #(.WIDTH(TAG), .CYCLES(4)) u_tag (.clk(clk), .in_i(in_tag_i), .out_o(out_tag_o));
    rt_delay_valid #(.CYCLES(4)) u_valid (.clk(clk), .rst(rst), .in_i(in_valid_i),
                                          .out_o(out_valid_o));
    wire unused = &{1'b0, product[38:32], product[11:0], last[12], before[12]};
endmodule
`default_nettype wire
