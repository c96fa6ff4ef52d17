// rt_specular.v - highlight of a light: Phong's cosine and its power
// SPDX-License-Identifier: Apache-2.0
//   c = limit(round(L.D - 2 * round(N.L) * round(N.D)), 0, 1)    highlight = 2^-(power * -log2(c))
// One multiplier, one product a clock, each two clocks before what is made of it:
//   1..3 N.L | 4..6 N.D | 7..9 L.D | 10 NL*ND | 12 leading zeros | 13 table | 14 slope | 15 -log2
//   16, 17 times power | 19 table | 20 slope | 21 2^-fraction | 22 shift, round
// Latency 23 cycles, one every 24.
// Model: sph_specular_cosine(), sph_power() in cmodel/shade/colour.c
`timescale 1ns / 1ps
`default_nettype none
module rt_specular #(
    parameter TAG = 8  // tag, bits
) (
    input  wire           clk,
    input  wire           rst,
    input  wire           in_valid_i,
    output wire           in_ready_o,
    input  wire [TAG-1:0] in_tag_i,
    input  wire [53:0]    in_normal_i,    // {z, y, x} s1.16, unit vectors: of the surface
    input  wire [53:0]    in_light_i,     // to the light
    input  wire [53:0]    in_dir_i,       // of the ray
    input  wire [11:0]    in_power_i,     // u8.4
    output wire           out_valid_o,    // one cycle
    output wire [TAG-1:0] out_tag_o,
    output reg  [15:0]    out_highlight_o // u1.15, 0..32768
);
    // ---- control: ph_q[n] n cycles after the vectors were taken ----
    reg  [23:1]    ph_q;
    wire           take = in_valid_i && in_ready_o;
    assign in_ready_o  = ph_q == 23'd0;
    assign out_valid_o = ph_q[23];
    always @(posedge clk) begin
        ph_q <= {ph_q[22:1], take};
        if (rst) ph_q <= 23'd0;
    end

    // ---- vectors rotate: x is the one in turn ----
    reg  [TAG-1:0] tag_q;
    reg  [53:0]    normal_q, light_q, dir_q;
    reg  [11:0]    power_q;
    assign out_tag_o = tag_q;
    always @(posedge clk)
        if (take) begin
            tag_q    <= in_tag_i;
            normal_q <= in_normal_i;
            light_q  <= in_light_i;
            dir_q    <= in_dir_i;
            power_q  <= in_power_i;
        end else if (|ph_q[9:1]) begin
            normal_q <= {normal_q[17:0], normal_q[53:18]};
            light_q  <= {light_q[17:0], light_q[53:18]};
            dir_q    <= {dir_q[17:0], dir_q[53:18]};
        end

    // ---- operands ----
    reg  signed [17:0] nl_q, nd_q;         // s1.16
    reg  [16:0]        x_q;                // u1.16, 1 or more
    reg  [20:0]        m_q;                // u5.16
    reg  [28:0]        e_q;                // u13.16
    wire [25:0]        line;               // {start, slope}
    // which, one-hot, told a clock ahead: cycles 7 to 9, 10, 14 or 20, 16 or 17; 4 to 6, 10, 14, 20,
    // 16, 17
    reg  [3:0]         of_a_q;
    reg  [5:0]         of_b_q;
    reg                normal_turn_q, light_turn_q;
    wire [3:0]         of_a = {|ph_q[8:6], ph_q[9], ph_q[13] || ph_q[19], ph_q[15] || ph_q[16]};
    wire [5:0]         of_b = {|ph_q[5:3], ph_q[9], ph_q[13], ph_q[19], ph_q[15], ph_q[16]};
    always @(posedge clk) begin
        {of_a_q, normal_turn_q} <= {of_a, ~|of_a};
        {of_b_q, light_turn_q}  <= {of_b, ~|of_b};
    end
    wire signed [17:0] a = $signed(({18{normal_turn_q}} & normal_q[17:0]) |
                                   ({18{of_a_q[3]}} & dir_q[17:0]) | ({18{of_a_q[2]}} & nl_q) |
                                   ({18{of_a_q[1]}} & {9'd0, line[8:0]}) |
                                   ({18{of_a_q[0]}} & {6'd0, power_q}));
    wire signed [17:0] b = $signed(({18{light_turn_q}} & light_q[17:0]) |
                                   ({18{of_b_q[5]}} & dir_q[17:0]) | ({18{of_b_q[4]}} & nd_q) |
                                   ({18{of_b_q[3]}} & {10'd0, x_q[7:0]}) |
                                   ({18{of_b_q[2]}} & {10'd0, e_q[7:0]}) |
                                   ({18{of_b_q[1]}} & {2'd0, m_q[15:0]}) |
                                   ({18{of_b_q[0]}} & {13'd0, m_q[20:16]}));
    reg  signed [35:0] prod_q;
    always @(posedge clk) prod_q <= a * b;

    // ---- dot products, cosine ----
    reg  signed [37:0] dot_q;              // s5.32
    wire signed [37:0] prod  = $signed({{2{prod_q[35]}}, prod_q});
    wire               fresh = ph_q[2] || ph_q[5] || ph_q[8];
    wire [20:0]        unit  = dot_q[36:16] + {20'd0, dot_q[15]};  // half up, s1.16 if of units
    wire signed [37:0] full  = dot_q - (prod <<< 1);
    wire [21:0]        round = full[37:16] + {21'd0, full[15]};
    reg  [16:0]        c_q;                // u1.16
    always @(posedge clk) begin
        if (|ph_q[10:2]) dot_q <= fresh ? prod : dot_q + prod;
        if (ph_q[5])  nl_q <= $signed(unit[17:0]);
        if (ph_q[8])  nd_q <= $signed(unit[17:0]);
        if (ph_q[11]) c_q  <= round[21] ? 17'd0 : |round[20:16] ? 17'h10000 : round[16:0];
    end

    // ---- -log2 ----
    wire [16:0]    x_8 = c_q[16:9] == 8'd0 ? c_q << 8 : c_q;
    wire [16:0]    x_4 = x_8[16:13] == 4'd0 ? x_8 << 4 : x_8;
    wire [16:0]    x_2 = x_4[16:15] == 2'd0 ? x_4 << 2 : x_4;
    wire [16:0]    x_1 = !x_2[16] ? x_2 << 1 : x_2;
    wire           last = !x_1[16];        // of 17 bits all but the lowest are 0
    reg  [4:0]     z_q;
    reg            none_q;                 // c is 0
    wire [16:0]    bend = prod_q[24:8];    // floor(slope * f / 256)
    always @(posedge clk) begin
        if (ph_q[12]) begin
            x_q    <= last ? x_1 << 1 : x_1;
            z_q    <= {1'b0, c_q[16:9] == 8'd0, x_8[16:13] == 4'd0, x_4[16:15] == 2'd0, !x_2[16]} +
                      {4'd0, last};
            none_q <= c_q == 17'd0;
        end
        if (ph_q[15]) m_q <= {z_q, 16'd0} - {4'd0, line[25:9]} - {4'd0, bend};
    end

    // ---- times power ----
    reg  [27:0]    low_q;
    wire [32:0]    e = {5'd0, low_q} + {prod_q[16:0], 16'd0};
    always @(posedge clk) begin
        low_q <= prod_q[27:0];
        if (ph_q[18]) e_q <= e[32:4];
    end

    // ---- 2^- ----
    rt_power_rom u_rom (
        .clk(clk), .index_i(|ph_q[22:19] ? {1'b1, e_q[15:8]} : {1'b0, x_q[15:8]}), .line_q(line)
    );
    reg  [16:0]    y_q;                    // u1.16, 32768..65536
    wire [16:0]    y_half = y_q >> e_q[20:16];       // one bit more than counts
    wire [16:0]    y_up   = y_half + 17'd1;
    always @(posedge clk) begin
        y_q <= line[25:9] - bend;
        if (ph_q[22]) out_highlight_o <= none_q || e_q[28:16] > 13'd16 ? 16'd0 : y_up[16:1];
    end
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_highlights /* verilator public_flat_rd */ =
        {in_valid_i && !in_ready_o, take, 5'd0, take || !in_ready_o};
    wire unused = &{1'b0, x_q[16], y_up[0], unit[20:18], e[3:0], prod_q[35:28], full[14:0]};
endmodule
`default_nettype wire
