// rt_colour.v - colour of a surface where nothing is reflected: albedo times light, as bytes
// SPDX-License-Identifier: Apache-2.0
//   byte = min(round(round(albedo*light / 2^7) / 2^8), 255)
// Both roundings are half up and floors nest: that is (albedo*light + 2^6 + 2^14) / 2^15.
// Channels follow one another through one multiplier: product | add, limit.
// Latency 5 cycles, a new one every 3 cycles.
// Model: sph_surface_colour(), then sph_blend_add() of the only surface, in cmodel/shade/colour.c
`timescale 1ns / 1ps
`default_nettype none
module rt_colour #(
    parameter TAG = 8  // tag, bits
) (
    input  wire           clk,
    input  wire           rst,
    input  wire           in_valid_i,
    output wire           in_ready_o,
    input  wire [TAG-1:0] in_tag_i,
    input  wire [50:0]    in_light_i,   // 3 x u2.15, red low
    input  wire [23:0]    in_albedo_i,  // 0xBBGGRR
    output wire           out_valid_o,  // one cycle
    output reg  [TAG-1:0] out_tag_o,
    output reg  [23:0]    out_colour_o  // 0xBBGGRR
);
    localparam [24:0] HALVES = 25'd64 + 25'd16384;  // of 2^7, and of 2^8 on top of it

    // ---- control: ph_q[n] n cycles after the input was taken ----
    reg  [5:1]     ph_q;
    wire           take = in_valid_i && in_ready_o;
    assign in_ready_o  = ~|ph_q[2:1];
    assign out_valid_o = ph_q[5];
    always @(posedge clk) begin
        ph_q <= {ph_q[4:1], take};
        if (rst) ph_q <= 5'd0;
    end

    // ---- input: channels move down ----
    reg  [TAG-1:0] in_tag_q;
    reg  [50:0]    light_q;
    reg  [23:0]    albedo_q;
    always @(posedge clk)
        if (take) begin
            in_tag_q <= in_tag_i;
            light_q  <= in_light_i;
            albedo_q <= in_albedo_i;
        end else begin
            light_q[33:0]  <= light_q[50:17];
            albedo_q[15:0] <= albedo_q[23:8];
        end

    // ---- stage 1, cycles 1 to 3: product ----
    reg  [24:0]    s1_prod_q;           // u10.15
    always @(posedge clk) s1_prod_q <= {17'd0, albedo_q[7:0]} * {8'd0, light_q[16:0]};

    // ---- stage 2, cycles 2 to 4: round, limit; above 255.0 is 255 too ----
    wire [25:0]    s2_sum  = {1'b0, s1_prod_q} + {1'b0, HALVES};
    wire [7:0]     s2_byte = |s2_sum[25:23] ? 8'd255 : s2_sum[22:15];
    always @(posedge clk) begin
        out_colour_o <= {s2_byte, out_colour_o[23:8]};
        if (ph_q[3]) out_tag_o <= in_tag_q;
    end
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_surfaces_blended /* verilator public_flat_rd */ =
        {in_valid_i && !in_ready_o, take, 5'd0, take || !in_ready_o};
    wire unused = &{1'b0, s2_sum[14:0]};
endmodule
`default_nettype wire
