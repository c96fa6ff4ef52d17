// rt_lambert.v - Lambert's cosine of two unit vectors
// SPDX-License-Identifier: Apache-2.0
//   cosine = limit(round(normal . light / 2^17), 0, 2^15)
//   nx*lx, ny*ly | nz*lz, add | add | round, limit        two multipliers
// Latency 5 cycles, a new pair every 2 cycles.
// Model: sph_lambert() in cmodel/shade/colour.c
`timescale 1ns / 1ps
`default_nettype none
module rt_lambert #(
    parameter TAG = 8  // tag, bits
) (
    input  wire               clk,
    input  wire               rst,
    input  wire               in_valid_i,
    output wire               in_ready_o,
    input  wire [TAG-1:0]     in_tag_i,
    input  wire signed [17:0] in_normal_x_i,  // s1.16
    input  wire signed [17:0] in_normal_y_i,
    input  wire signed [17:0] in_normal_z_i,
    input  wire signed [17:0] in_light_x_i,   // s1.16, to the light
    input  wire signed [17:0] in_light_y_i,
    input  wire signed [17:0] in_light_z_i,
    output wire               out_valid_o,    // one cycle
    output reg  [TAG-1:0]     out_tag_o,
    output reg  [15:0]        out_cosine_o    // u1.15, 0..32768; 0: faces away
);
    // ---- control: ph_q[n] n cycles after the pair was taken ----
    reg  [5:1]         ph_q;
    wire               take = in_valid_i && in_ready_o;
    assign in_ready_o  = !ph_q[1];
    assign out_valid_o = ph_q[5];
    always @(posedge clk) begin
        ph_q <= {ph_q[4:1], take};
        if (rst) ph_q <= 5'd0;
    end

    // ---- input: z follows x ----
    reg  signed [17:0] nx_q, ny_q, nz_q, lx_q, ly_q, lz_q;
    always @(posedge clk) begin
        if (take) begin
            {nx_q, ny_q, nz_q} <= {in_normal_x_i, in_normal_y_i, in_normal_z_i};
            {lx_q, ly_q, lz_q} <= {in_light_x_i, in_light_y_i, in_light_z_i};
        end else if (ph_q[1]) begin
            nx_q <= nz_q;
            lx_q <= lz_q;
        end
    end

    // ---- stage 1, cycles 1 and 2: products ----
    reg  signed [35:0] s1_xz_q, s1_y_q;       // s3.32
    always @(posedge clk) if (|ph_q[2:1]) begin
        s1_xz_q <= nx_q * lx_q;
        s1_y_q  <= ny_q * ly_q;
    end

    // ---- stage 2, cycles 2 and 3: sum; at most 3 * 2^34 ----
    reg  signed [36:0] s2_dot_q;              // s4.32
    wire signed [36:0] s2_xz = $signed({s1_xz_q[35], s1_xz_q});
    wire signed [36:0] s2_y  = $signed({s1_y_q[35], s1_y_q});
    always @(posedge clk) if (|ph_q[3:2]) s2_dot_q <= s2_xz + (ph_q[2] ? s2_y : s2_dot_q);

    // ---- stage 3, cycle 4: round half up, limit ----
    reg  [TAG-1:0]     s1_tag_q, s2_tag_q;
    wire signed [20:0] s3_sum  = $signed(s2_dot_q[36:16]) + 21'sd1;
    wire signed [19:0] s3_cos  = $signed(s3_sum[20:1]);  // s4.15
    wire               s3_over = |s3_cos[18:15];
    always @(posedge clk) begin
        if (ph_q[4]) out_cosine_o <= s3_cos[19] ? 16'd0 : s3_over ? 16'd32768 : s3_cos[15:0];
        if (take)    s1_tag_q  <= in_tag_i;
        if (ph_q[2]) s2_tag_q  <= s1_tag_q;
        if (ph_q[4]) out_tag_o <= s2_tag_q;
    end
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_cosines /* verilator public_flat_rd */ =
        {in_valid_i && !in_ready_o, take, 5'd0, take || !in_ready_o};
    wire unused = &{1'b0, s2_dot_q[15:0], s3_sum[0]};
endmodule
`default_nettype wire
