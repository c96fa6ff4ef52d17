// rt_light_add.v - adds one light to the light that a surface receives
// SPDX-License-Identifier: Apache-2.0
//   sum = min(sum + round(cosine * intensity / 2^15), 2^17-1) for each of three channels
// Channels follow one another through one multiplier: product | round, add, limit.
// Latency 5 cycles, a new one every 3 cycles.
// Model: sph_light_add() in cmodel/shade/colour.c
`timescale 1ns / 1ps
`default_nettype none
module rt_light_add #(
    parameter TAG = 8  // tag, bits
) (
    input  wire           clk,
    input  wire           rst,
    input  wire           in_valid_i,
    output wire           in_ready_o,
    input  wire [TAG-1:0] in_tag_i,
    input  wire [50:0]    in_sum_i,        // 3 x u2.15, red low
    input  wire [15:0]    in_cosine_i,     // u1.15
    input  wire [47:0]    in_intensity_i,  // 3 x u1.15, red low
    output wire           out_valid_o,     // one cycle
    output reg  [TAG-1:0] out_tag_o,
    output reg  [50:0]    out_sum_o        // 3 x u2.15, red low
);
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
    reg  [15:0]    cosine_q;
    reg  [50:0]    sum_q;
    reg  [47:0]    intensity_q;
    always @(posedge clk)
        if (take) begin
            in_tag_q    <= in_tag_i;
            cosine_q    <= in_cosine_i;
            sum_q       <= in_sum_i;
            intensity_q <= in_intensity_i;
        end else if (|ph_q[2:1]) begin
            sum_q[33:0]       <= sum_q[50:17];
            intensity_q[31:0] <= intensity_q[47:16];
        end

    // ---- stage 1, cycles 1 to 3: product ----
    reg  [31:0]    s1_prod_q;              // u2.30
    reg  [16:0]    s1_sum_q;               // u2.15
    always @(posedge clk) if (|ph_q[3:1]) begin
        s1_prod_q <= cosine_q * intensity_q[15:0];
        s1_sum_q  <= sum_q[16:0];
    end

    // ---- stage 2, cycles 2 to 4: (2*sum + 1 + product) / 2 rounds half up ----
    wire [18:0]    s2_sum = {1'b0, s1_sum_q, 1'b1} + {1'b0, s1_prod_q[31:14]};
    always @(posedge clk) begin
        if (|ph_q[4:2]) out_sum_o <= {s2_sum[18] ? 17'h1ffff : s2_sum[17:1], out_sum_o[50:17]};
        if (ph_q[3]) out_tag_o <= in_tag_q;
    end
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_lights_added /* verilator public_flat_rd */ =
        {in_valid_i && !in_ready_o, take, 5'd0, take || !in_ready_o};
    wire unused = &{1'b0, s1_prod_q[13:0], s2_sum[0]};
endmodule
`default_nettype wire
