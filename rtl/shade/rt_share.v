// rt_share.v - colour of a surface, its shares in the pixel's frames, weights of the rays behind it
// SPDX-License-Identifier: Apache-2.0
//   light  = min(round(ka*ambient / 2^8) + round(kd*lights / 2^8), 2^17-1)   no sum: ka = kd = 1
//   colour = min(surface(rgb, light) + surface(ks, gloss), 255.0)
//   own    = sum ? 256 : max(0, 256 - kr - kt)
//   frame += share * colour: whole weight at the frame's own depth, own share below, deepest frame
// A multiplier a channel; operands in cycle
//   1 ka  2 kd  3 ks  4 weight * kr, kt  5 rgb  7 weight * own, kr + kt  8, 9 colour
// A share whose ray would weigh less than in_least_i counts as 0.
// products follow by 1 cycle, what is made of them by 2. Latency 12 cycles, one every 12 cycles.
// Model: sph_shading_light(), sph_shading_own() in cmodel/shade/material.c, sph_shares_add() in
// colour.c
`timescale 1ns / 1ps
`default_nettype none
module rt_share #(
    parameter SUM      = 1,  // 0: in_lights_i has the ambient light already, no ka, kd
    parameter SPECULAR = 1,  // 0: no highlights
    parameter TAG      = 8   // tag, bits
) (
    input  wire           clk,
    input  wire           rst,
    input  wire           in_valid_i,
    output wire           in_ready_o,
    input  wire [TAG-1:0] in_tag_i,
    // the surface
    input  wire           in_background_i, // nothing hit: albedo is the colour, no shares
    input  wire [47:0]    in_ambient_i,    // 3 x u1.15, red low
    input  wire [50:0]    in_lights_i,     // 3 x u2.15
    input  wire [50:0]    in_gloss_i,      // 3 x u2.15
    input  wire [23:0]    in_albedo_i,     // 0xBBGGRR
    input  wire           in_sum_i,        // the colour counts whole
    input  wire [8:0]     in_ka_i,         // u1.8, above 256 as 256; with in_sum_i
    input  wire [8:0]     in_kd_i,
    input  wire [7:0]     in_ks_i,
    input  wire [8:0]     in_kr_i,         // u1.8, as ka; 0: no such ray
    input  wire [8:0]     in_kt_i,
    // the ray that found it, and its pixel so far
    input  wire [16:0]    in_weight_i,     // u1.16
    input  wire [8:0]     in_least_i,      // u1.8
    input  wire [1:0]     in_depth_i,      // 0, 1, 2: 2 or more
    input  wire [143:0]   in_frames_i,     // 3 x 3 x u8.8, Rendering low, red low
    output wire           out_valid_o,     // one cycle
    output wire [TAG-1:0] out_tag_o,
    output wire [143:0]   out_frames_o,
    output reg  [16:0]    out_mirror_o,    // weight of a mirror ray, u1.16
    output reg  [16:0]    out_refract_o,   // of a refracted ray
    output reg  [16:0]    out_total_o,     // of a mirror ray if all is reflected
    output reg            out_light_mirror_o, // it weighs less than in_least_i
    output reg            out_light_refract_o
);
    // ---- control: ph_q[n] n cycles after the surface was taken ----
    reg  [12:1]    ph_q;
    reg            ready_q;                // none of ph_q[11:1]
    wire           take = in_valid_i && in_ready_o;
    assign in_ready_o  = ready_q;
    assign out_valid_o = ph_q[12];
    always @(posedge clk) begin
        ph_q    <= {ph_q[11:1], take};
        ready_q <= ~|ph_q[10:1] && !take;
        if (rst) {ready_q, ph_q} <= {1'b1, 12'd0};
    end

    // ---- input ----
    reg  [TAG-1:0] tag_q;
    reg  [23:0]    albedo_q;
    reg  [8:0]     ka_q, kd_q, kr_q, kt_q;
    reg  [7:0]     ks_q;
    reg            sum_q;
    reg  [16:0]    weight_q;
    reg  [8:0]     least_q;
    reg  [1:0]     depth_q;
    wire           shades = SUM != 0 && in_sum_i && !in_background_i;
    always @(posedge clk)
        if (take) begin
            tag_q    <= in_tag_i;
            albedo_q <= in_albedo_i;
            sum_q    <= shades;
            ka_q     <= in_background_i ? 9'd0 : shades ? in_ka_i : 9'd256;
            kd_q     <= shades ? in_kd_i : 9'd256;
            ks_q     <= SPECULAR != 0 && shades ? in_ks_i : 8'd0;
            kr_q     <= in_kr_i;
            kt_q     <= in_kt_i;
            weight_q <= in_weight_i;
            least_q  <= in_least_i;
            depth_q  <= in_depth_i;
        end
    assign out_tag_o = tag_q;

    // ---- shares of the weight: both rays, and own of either, are there before one is chosen ----
    wire [9:0]     both  = {1'b0, kr_q} + {1'b0, kt_q};
    reg  [8:0]     both_q, own_q, own_kr_q, own_kt_q;
    always @(posedge clk) begin
        both_q   <= both >= 10'd256 ? 9'd256 : both[8:0];
        own_q    <= sum_q ? 9'd256 : 9'd256 - both_q;
        own_kr_q <= sum_q ? 9'd256 : kr_q[8] ? 9'd0 : 9'd256 - kr_q;
        own_kt_q <= sum_q ? 9'd256 : kt_q[8] ? 9'd0 : 9'd256 - kt_q;
    end
    wire [8:0]     total = out_light_mirror_o ? out_light_refract_o ? 9'd0 : kt_q
                                              : out_light_refract_o ? kr_q : both_q;
    wire [8:0]     own   = out_light_mirror_o ? out_light_refract_o ? 9'd256 : own_kt_q
                                              : out_light_refract_o ? own_kr_q : own_q;
    wire [50:0]    product;                // round(product / 2^8) of each channel
    always @(posedge clk) begin
        if (ph_q[6]) begin
            {out_refract_o, out_mirror_o} <= product[50:17];
            out_light_mirror_o  <= product[33:25] < least_q;
            out_light_refract_o <= product[50:42] < least_q;
        end
        if (ph_q[9]) out_total_o <= product[33:17];
    end

    genvar c;
    generate
        for (c = 0; c < 3; c = c + 1) begin : g_channel
            reg  [16:0] light_q;           // u2.15; lights first, then all of the light
            wire [16:0] light = in_background_i ? 17'h08000 : in_lights_i[17*c +: 17];
            wire [16:0] ambient, gloss;
            wire [15:0] highlight;             // u8.8
            reg  [15:0] colour_q;          // u8.8
            // ---- operands, product ----
            wire [8:0]  part = c == 2 ? kt_q : kr_q;
            wire [8:0]  rest = c == 0 ? own : total;  // own share of the weight, in cycle 9
            wire        over = ph_q[1] && ka_q[8] || ph_q[2] && kd_q[8] || ph_q[4] && part[8] ||
                               ph_q[7] && rest[8];
            reg  [16:0] a_q, b_q;
            reg  [33:0] p_q;
            always @(posedge clk) begin
                if (|ph_q[9:1]) begin          // else they stand still, and the product
                    a_q <= ph_q[1] ? ambient : ph_q[2] ? light_q : ph_q[3] ? gloss
                           : ph_q[4] || ph_q[7] ? weight_q
                           : ph_q[5] ? light_q : {1'b0, colour_q};
                    b_q <= ph_q[1] ? {8'd0, ka_q} : ph_q[2] ? {8'd0, kd_q} : ph_q[3] ? {9'd0, ks_q}
                           : ph_q[4] ? {8'd0, part} : ph_q[7] ? {8'd0, rest}
                           : ph_q[5] ? {9'd0, albedo_q[8*c +: 8]} : ph_q[8] ? weight_q
                           : product[16:0];
                    if (over) b_q[7:0] <= 8'd0;
                end
                p_q <= a_q * b_q;
            end
            wire [17:0] p_8  = p_q[24:7] + 18'd1;      // twice round(p / 2^8)
            wire [18:0] p_7  = p_q[24:6] + 19'd1;      // twice round(p / 2^7)
            wire [15:0] seen = p_7[18:1] > 18'd65280 ? 16'd65280 : p_7[16:1];
            assign product[17*c +: 17] = p_8[17:1];
            // ---- light, cycle 4: ambient and lights ----
            if (SUM != 0) begin : g_light
                reg  [16:0] ambient_q, share_q;
                wire [17:0] sum = {1'b0, share_q} + {1'b0, p_8[17:1]};
                assign ambient = ambient_q;
                always @(posedge clk) begin
                    if (take) ambient_q <= {1'b0, in_ambient_i[16*c +: 16]};
                    share_q <= p_8[17:1];
                    if (take)         light_q <= light;
                    else if (ph_q[4]) light_q <= sum[17] ? 17'h1ffff : sum[16:0];
                end
            end else begin : g_given
                assign ambient = 17'd0;
                always @(posedge clk) if (take) light_q <= light;
                wire unused = &{1'b0, in_ambient_i[16*c +: 16]};
            end
            // ---- highlight, cycle 5; colour, cycle 7 ----
            if (SPECULAR != 0) begin : g_gloss
                reg [16:0] gloss_q;
                reg [15:0] highlight_q;
                assign gloss = gloss_q;
                assign highlight = highlight_q;
                always @(posedge clk) begin
                    if (take)    gloss_q <= in_gloss_i[17*c +: 17];
                    if (ph_q[5]) highlight_q <= seen;
                end
            end else begin : g_matt
                assign gloss = 17'd0;
                assign highlight = 16'd0;
                wire unused = &{1'b0, in_gloss_i[17*c +: 17]};
            end
            wire [16:0] bright = {1'b0, seen} + {1'b0, highlight};
            always @(posedge clk)
                if (ph_q[7]) colour_q <= bright > 17'd65280 ? 16'd65280 : bright[15:0];

            // ---- frames: whole weight in cycle 10, own share in cycle 11 ----
            reg  [15:0] f0_q, f1_q, f2_q;
            wire [17:0] add   = p_q[32:15];
            wire [18:0] sum_0 = {2'b0, f0_q, 1'b1} + {1'b0, add};
            wire [18:0] sum_1 = {2'b0, f1_q, 1'b1} + {1'b0, add};
            wire [18:0] sum_2 = {2'b0, f2_q, 1'b1} + {1'b0, add};
            always @(posedge clk) begin
                if (take) begin
                    f0_q <= in_frames_i[16*c +: 16];
                    f1_q <= in_frames_i[48 + 16*c +: 16];
                    f2_q <= in_frames_i[96 + 16*c +: 16];
                end
                if (ph_q[10] && depth_q == 2'd0) f0_q <= |sum_0[18:17] ? 16'hffff : sum_0[16:1];
                if (depth_q[0] ? ph_q[10] : ph_q[11] && depth_q == 2'd0)
                    f1_q <= |sum_1[18:17] ? 16'hffff : sum_1[16:1];
                if (ph_q[11]) f2_q <= |sum_2[18:17] ? 16'hffff : sum_2[16:1];
            end
            assign out_frames_o[16*c +: 16]      = f0_q;
            assign out_frames_o[48 + 16*c +: 16] = f1_q;
            assign out_frames_o[96 + 16*c +: 16] = f2_q;
            wire unused = &{1'b0, p_q, p_8[0], p_7[0], sum_0[0], sum_1[0], sum_2[0]};
        end
    endgenerate
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_surfaces_blended /* verilator public_flat_rd */ =
        {in_valid_i && !in_ready_o, take, 5'd0, take || !in_ready_o};
    wire unused = &{1'b0, in_ka_i, in_kd_i, in_ks_i, in_sum_i, ka_q, kd_q, ks_q};
endmodule
`default_nettype wire
