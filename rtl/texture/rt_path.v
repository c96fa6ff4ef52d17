// rt_path.v - length of the way from the eye to a hit: path + key / |dir| * 2^spread
// SPDX-License-Identifier: Apache-2.0
// |t*dir| = key / |dir| = key * y * 2^(h - WD - 16), with y and h of the ray's unit vector: no
// root, no quotient. Park et al. 2011, Figure 1: the adder beside the ray stack.
//   CHUNKS products of 17 bits, highest first | shift | shift | round, add | limit
// Beside the products, with SPREAD, what the surface where the ray started makes of its spread:
//   1..3 log2(path) | 4 less bend / 2, the larger of that and the spread before
// A new hit every CHUNKS clocks; a result CHUNKS + 6 clocks after its hit.
// Model: sph_path_add(), sph_spread() in cmodel/texture/lod.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_path #(
    parameter W   = 16,                      // coordinate, bits
    parameter WD  = 17,                      // direction component, bits
    parameter SPREAD = 0,                    // 1: spheres spread rays
    parameter TAG = 6                        // what travels along, bits
) (
    input  wire            clk,
    input  wire            rst,              // synchronous, active high
    input  wire            in_valid_i,
    output wire            in_ready_o,
    input  wire [TAG-1:0]  in_tag_i,
    input  wire [W+WD+1:0] in_key_i,         // u(W+WD+2)
    input  wire [16:0]     in_y_i,           // u1.16 of the ray's unit vector
    input  wire [5:0]      in_h_i,           // its shift, below WD
    input  wire [W+7:0]    in_path_i,        // u(W+4).4, where the ray starts
    input  wire [3:0]      in_spread_i,      // of the ray before, log2, 0 to 12
    input  wire [`RT_PRIM_BEND_BITS-1:0] in_bend_i, // of the surface where it starts, 0: flat
    output reg             out_valid_o,      // free-running
    output reg  [TAG-1:0]  out_tag_o,
    output reg  [W+7:0]    out_path_o,       // u(W+4).4, limited to all ones
    output wire [3:0]      out_spread_o      // of this ray
);
    localparam KW     = W + WD + 2;
    localparam PW     = W + 8;               // path
    localparam CHUNKS = (KW + 16) / 17;
    localparam AW     = 17*CHUNKS + 17;      // product
    localparam [31:0] SHIFT = WD + 11;       // right shift for h = 0, one bit kept to round

    // ---- chunks of the key, highest first ----
    reg  [CHUNKS-1:0]   at_q;                // one bit: the chunk whose turn it is
    reg  [17*CHUNKS-1:0] key_q;
    reg  [16:0]         y_q;
    reg  [5:0]          h_q;
    reg  [TAG-1:0]      tag_q;
    reg  [PW-1:0]       path_q;
    wire                take = in_valid_i && in_ready_o;
    assign in_ready_o = at_q == {CHUNKS{1'b0}} || at_q[CHUNKS-1];
    always @(posedge clk) begin
        at_q  <= {at_q[CHUNKS-2:0], take};
        key_q <= key_q << 17;
        if (take) begin
            key_q  <= {{(17*CHUNKS-KW){1'b0}}, in_key_i};
            y_q    <= in_y_i;
            h_q    <= in_h_i;
            tag_q  <= in_tag_i;
            path_q <= in_path_i;
        end
        if (rst) at_q <= {CHUNKS{1'b0}};
    end

    // ---- spread, in time for the last product: CHUNKS is 2 or more ----
    wire [3:0]          spread;              // from 4 clocks after its hit, until the next one's
    generate
        if (SPREAD != 0) begin : g_spread
            localparam [3:0] MOST = `RT_SPREAD_MOST;
            wire [13:0]      log2;           // u6.8 of the path
            wire             l_valid, l_curved;
            wire [3:0]       l_spread;
            wire [`RT_PRIM_BEND_BITS-1:0] l_bend;
            wire signed [14:0] l_rise = $signed({1'b0, log2}) - $signed({2'd0, l_bend, 7'd0});
            wire signed [6:0] l_log2 = l_rise[14:8];    // of 4 path / radius, to nearest
            wire [3:0]       l_more = l_log2 >= $signed({3'd0, MOST}) ? MOST : l_log2[3:0];
            wire             l_turn = l_curved && !l_log2[6] && l_more >= l_spread;
            reg  [3:0]       s4_spread_q, s5_spread_q, s6_spread_q, s7_spread_q, out_spread_q;
            rt_log2 #(.XB(PW)) u_log2 (.clk(clk), .in_x_i(in_path_i), .out_log2_o(log2));
            rt_delay #(.WIDTH(5 + `RT_PRIM_BEND_BITS), .CYCLES(3)) u_wait (
                .clk(clk), .in_i({in_path_i != {PW{1'b0}} && in_bend_i != 0, in_spread_i,
                                  in_bend_i}),
                .out_o({l_curved, l_spread, l_bend})
            );
            rt_delay_valid #(.CYCLES(3)) u_valid (.clk(clk), .rst(rst), .in_i(take),
                                                  .out_o(l_valid));
            always @(posedge clk) begin
                if (l_valid)
                    s4_spread_q <= !l_turn ? l_spread
                                   : l_more == l_spread && l_spread != MOST ? l_spread + 4'd1
                                   : l_more;
                s5_spread_q  <= s4_spread_q;
                s6_spread_q  <= s5_spread_q;
                s7_spread_q  <= s6_spread_q;
                out_spread_q <= s7_spread_q;
            end
            assign spread       = s4_spread_q;
            assign out_spread_o = out_spread_q;
            wire unused = &{1'b0, l_rise[7:0]};
        end else begin : g_even
            assign spread       = 4'd0;
            assign out_spread_o = 4'd0;
            wire unused = &{1'b0, in_spread_i, in_bend_i};
        end
    endgenerate

    // ---- product ----
    reg                 s1_first_q, s1_last_q, s2_last_q;
    reg  [33:0]         s1_prod_q;
    reg  [AW-1:0]       s2_acc_q;
    reg  [5:0]          s1_h_q, s2_h_q;
    reg  [TAG-1:0]      s1_tag_q, s2_tag_q;
    reg  [PW-1:0]       s1_path_q, s2_path_q;
    wire [AW-1:0]       s1_more = {s2_acc_q[AW-18:0], 17'd0};
    always @(posedge clk) begin
        s1_prod_q  <= key_q[17*CHUNKS-1 -: 17] * y_q;
        s1_first_q <= at_q[0];
        s1_last_q  <= at_q[CHUNKS-1];
        {s1_h_q, s1_tag_q, s1_path_q} <= {h_q, tag_q, path_q};
        s2_acc_q   <= (s1_first_q ? {AW{1'b0}} : s1_more) + {{(AW-34){1'b0}}, s1_prod_q};
        s2_last_q  <= s1_last_q;
        {s2_h_q, s2_tag_q, s2_path_q} <= {s1_h_q, s1_tag_q, s1_path_q};
        if (rst) begin s1_last_q <= 1'b0; s2_last_q <= 1'b0; end
    end

    // ---- shift right by WD + 12 - h - spread, one bit kept to round ----
    reg                 s3_valid_q, s4_valid_q, s5_valid_q;
    reg  [AW-1:0]       s3_q, s4_q;
    reg  [5:0]          s3_shift_q;
    reg  [TAG-1:0]      s3_tag_q, s4_tag_q, s5_tag_q;
    reg  [PW-1:0]       s3_path_q, s4_path_q;
    reg  [AW-1:0]       s5_sum_q;
    wire [5:0]          s2_shift = SHIFT[5:0] - s2_h_q - {2'd0, spread};
    always @(posedge clk) begin
        s3_valid_q <= s2_last_q;
        s3_q       <= s2_acc_q >> {s2_shift[5:3], 3'd0};
        s3_shift_q <= s2_shift;
        {s3_tag_q, s3_path_q} <= {s2_tag_q, s2_path_q};
        s4_valid_q <= s3_valid_q;
        s4_q       <= s3_q >> s3_shift_q[2:0];
        {s4_tag_q, s4_path_q} <= {s3_tag_q, s3_path_q};

        // ---- round half up, add, limit ----
        s5_valid_q <= s4_valid_q;
        s5_tag_q   <= s4_tag_q;
        s5_sum_q   <= {1'b0, s4_q[AW-1:1]} + {{(AW-1){1'b0}}, s4_q[0]} +
                      {{(AW-PW){1'b0}}, s4_path_q};
        out_valid_o <= s5_valid_q;
        out_tag_o   <= s5_tag_q;
        out_path_o  <= |s5_sum_q[AW-1:PW] ? {PW{1'b1}} : s5_sum_q[PW-1:0];
        if (rst) {s3_valid_q, s4_valid_q, s5_valid_q, out_valid_o} <= 4'd0;
    end
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_path_lengths /* verilator public_flat_rd */ =
        {in_valid_i && !in_ready_o, take, 5'd0, take || !in_ready_o};
    wire unused = &{1'b0, s3_shift_q[5:3]};
endmodule
`default_nettype wire
