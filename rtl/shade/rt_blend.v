// rt_blend.v - colour of a surface, blended into the pixel; frames of each reflection depth
// SPDX-License-Identifier: Apache-2.0
//   colour = min(round(albedo*light / 2^7), 255.0)        front = weight * (1-kr)
//   frame  = byte(sum + weight*colour)    sum += front*colour    weight *= kr    depth += 1
// A frame is that of its own depth and, so far, of the deepest; frames 0 and 1 stay as they are
// when deeper surfaces come.
// Two multipliers, channels one after another:
//   operands in cycle 1, 2, 3: albedo, light | weight, kr  4, 5, 6: colour, weight | colour, front
//   products follow by 1 cycle, what is made of them by 2. Latency 9 cycles, one every 8 cycles.
// Model: sph_surface_colour(), sph_blend_add() in cmodel/shade/colour.c
`timescale 1ns / 1ps
`default_nettype none
module rt_blend #(
    parameter REFLECT = 5,                  // reflections, 1..10
    parameter TAG     = 8,                  // tag, bits
    parameter DW = $clog2(REFLECT + 1),     // depth, bits, derived: leave alone
    parameter KEPT = REFLECT > 1 ? 48 : 24  // frames 0 and 1, or 0 alone, derived: leave alone
) (
    input  wire           clk,
    input  wire           rst,
    input  wire           in_valid_i,
    output wire           in_ready_o,
    input  wire [TAG-1:0] in_tag_i,
    input  wire [50:0]    in_light_i,       // 3 x u2.15, red low
    input  wire [23:0]    in_albedo_i,      // 0xBBGGRR
    input  wire           in_background_i,  // nothing hit: albedo is the colour
    input  wire [8:0]     in_kr_i,          // u1.8, share of the reflection, above 256 as 256
    // state of the pixel so far
    input  wire [47:0]    in_sum_i,         // 3 x u8.8, red low
    input  wire [16:0]    in_weight_i,      // u1.16, of what lies behind
    input  wire [DW-1:0]  in_depth_i,       // reflections so far, at most REFLECT
    input  wire [KEPT-1:0] in_colour_i,     // frames 0xBBGGRR, Rendering low
    // and after this depth
    output wire           out_valid_o,      // one cycle
    output reg  [TAG-1:0] out_tag_o,
    output reg  [47:0]    out_sum_o,
    output reg  [16:0]    out_weight_o,
    output reg  [DW-1:0]  out_depth_o,
    output reg  [KEPT+23:0] out_colour_o    // the deepest frame above those that are kept
);
    // ---- control: ph_q[n] n cycles after the input was taken ----
    reg  [9:1]     ph_q;
    reg            ready_q;                 // none of ph_q[7:1]
    wire           take = in_valid_i && in_ready_o;
    assign in_ready_o  = ready_q;
    assign out_valid_o = ph_q[9];
    always @(posedge clk) begin
        ph_q    <= {ph_q[8:1], take};
        ready_q <= ~|ph_q[6:1] && !take;
        if (rst) {ready_q, ph_q} <= {1'b1, 9'd0};
    end

    // ---- input: channels move down ----
    reg  [TAG-1:0] in_tag_q;
    reg  [50:0]    light_q;
    reg  [23:0]    albedo_q;
    reg  [8:0]     kr_q;
    reg  [47:0]    sum_q;
    reg  [16:0]    weight_q;
    reg  [DW-1:0]  depth_q;
    reg  [KEPT-1:0] colour_q;
    always @(posedge clk)
        if (take) begin
            in_tag_q <= in_tag_i;
            albedo_q <= in_albedo_i;
            light_q  <= in_background_i ? {3{17'h08000}} : in_light_i;  // background: light of 1
            kr_q     <= in_kr_i;
            sum_q    <= in_sum_i;
            weight_q <= in_weight_i;
            depth_q  <= in_depth_i;
            colour_q <= in_colour_i;
        end else begin
            if (|ph_q[2:1]) albedo_q[15:0] <= albedo_q[23:8];
            if (|ph_q[2:1]) light_q[33:0]  <= light_q[50:17];
            if (|ph_q[7:6]) sum_q[31:0] <= sum_q[47:16];
        end

    // ---- stage 1: operands ----
    reg  [15:0]    s1_a_q, s1_b_q;
    reg  [16:0]    s1_x_q, s1_y_q;
    reg  [15:0]    s3_colour_q;             // u8.8
    reg  [16:0]    s3_front_q, s3_weight_q; // u1.16
    wire           s1_blend = |ph_q[6:4];
    always @(posedge clk) if (|ph_q[6:1]) begin
        s1_a_q <= s1_blend ? s3_colour_q : {8'd0, albedo_q[7:0]};
        s1_x_q <= s1_blend ? weight_q    : light_q[16:0];
        s1_b_q <= s1_blend ? s3_colour_q : {7'd0, kr_q};
        s1_y_q <= s1_blend ? s3_front_q  : weight_q;
        if (!s1_blend && kr_q[8]) s1_b_q[7:0] <= 8'd0;
    end

    // ---- stage 2: products ----
    reg  [32:0]    s2_ax_q, s2_by_q;
    always @(posedge clk) if (|ph_q[7:2]) begin
        s2_ax_q <= s1_a_q * s1_x_q;
        s2_by_q <= s1_b_q * s1_y_q;
    end

    // ---- stage 3, cycles 3 to 5: colour of the surface; cycle 3: weights, from weight*kr ----
    wire [18:0]    s3_light  = s2_ax_q[24:6] + 19'd1;
    wire [25:0]    s3_front  = {1'b0, weight_q, 8'd128} - s2_by_q[25:0];
    wire [17:0]    s3_behind = s2_by_q[24:7] + 18'd1;
    always @(posedge clk) begin
        if (|ph_q[5:3])
            s3_colour_q <= s3_light[18:1] > 18'd65280 ? 16'd65280 : s3_light[16:1];
        if (ph_q[3]) s3_front_q  <= s3_front[24:8];
        if (ph_q[3]) s3_weight_q <= s3_behind[17:1];
    end

    // ---- stage 3, cycles 6 to 8: channel of the pixel, channel of the sum ----
    wire [17:0]    s3_all  = {1'b0, sum_q[15:0], 1'b1} + s2_ax_q[32:15];
    wire [17:0]    s3_sum  = {1'b0, sum_q[15:0], 1'b1} + s2_by_q[32:15];
    wire [9:0]     s3_half = s3_all[17:8] + 10'd1;  // no carry: all <= 65535 + 65280
    wire [7:0]     s3_byte = s3_half[9] ? 8'd255 : s3_half[8:1];
    reg  [15:0]    s3_pixel_q;              // red and green
    wire [23:0]    s3_pixel = {s3_byte, s3_pixel_q};
    always @(posedge clk) if (|ph_q[8:6]) begin
        s3_pixel_q <= s3_pixel[23:8];
        out_sum_o  <= {s3_sum[16:1], out_sum_o[47:16]};
    end

    // ---- cycle 8: frames ----
    wire [KEPT-1:0] kept;
    assign kept[23:0] = depth_q == 0 ? s3_pixel : colour_q[23:0];
    generate
        if (REFLECT > 1) begin : g_l1               // depth 0 leaves what depth 1 will change
            assign kept[KEPT-1:24] = depth_q <= 1 ? s3_pixel : colour_q[KEPT-1:24];
        end
    endgenerate
    always @(posedge clk)
        if (ph_q[8]) begin
            out_tag_o    <= in_tag_q;
            out_weight_o <= s3_weight_q;
            out_depth_o  <= depth_q + 1'b1;
            out_colour_o <= {s3_pixel, kept};
        end
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_surfaces_blended /* verilator public_flat_rd */ =
        {in_valid_i && !in_ready_o, take, 5'd0, take || !in_ready_o};
    wire unused = &{1'b0, s2_ax_q[5:0], s3_light[0], s3_front[25], s3_front[7:0], s3_behind[0],
                    s3_all[7:0], s3_sum[17], s3_sum[0], s3_half[0]};
endmodule
`default_nettype wire
