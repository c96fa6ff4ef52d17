// rt_divide.v - products divided and rounded up, 17 bits of the quotient a round
// SPDX-License-Identifier: Apache-2.0
// key = ceil(a * b / d) in N = ceil(BW/17) rounds. What is left after a round, R, is below 2d, and
//   R' = S - q * d      S = R * 2^17 + the next 17 bits of a * b      q = floor(T * y / 2^23), u18
// T = floor(8 * S / 2^L) with d of L bits, and y is 2^(20+L) / d or a little less, u21.
//   product | d shifted up | reciprocal | N rounds: 1, 2 T | 3 products | 4 q | 5 q*d | 6, 7 R' |
//   key
// Up to 7 are in the ring of rounds at once, and a place is free again when an operand needs it:
// in_ready_o is high every N clocks, which have no factor with 7. Latency 8*N + 5.
// Why 0 <= R < 2d: docs/design/primitives.md. Model: sph_facet_key() in cmodel/prim/facet.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
module rt_divide #(
    parameter AW  = 50,                      // long factor, bits
    parameter BW  = 34,                      // other factor, bits
    parameter DW  = 50,                      // divisor, bits
    parameter TAG = 8                        // tag, bits
) (
    input  wire             clk,
    input  wire             rst,             // synchronous, active high
    input  wire             in_valid_i,
    output wire             in_ready_o,      // every N clocks
    input  wire [TAG-1:0]   in_tag_i,
    input  wire [AW-1:0]    in_a_i,          // a * b < d * 2^BW
    input  wire [BW-1:0]    in_b_i,
    input  wire [DW-1:0]    in_d_i,          // > 0
    output reg              out_valid_o,     // taken at once
    output reg  [TAG-1:0]   out_tag_o,
    output reg  [BW:0]      out_key_o
);
    localparam N  = BW > 17 ? (BW + 16) / 17 : 2;
    `RT_CHECK(N <= 6, rt_divide_BW_must_be_at_most_102)
    `RT_CHECK(DW >= 22 && DW <= 128, rt_divide_DW_must_be_22_to_128)
    localparam BN = 17*N;                    // bits of a quotient
    localparam XW = (AW > DW ? AW : DW) + BN + 1;  // of a product
    localparam RW = DW + 18;                 // R and 17 bits below it
    localparam CB = $clog2(N);
    localparam LAST = N - 1;

    // ---- a start every N clocks ----
    reg  [CB-1:0] turn_q;
    wire          take = in_valid_i && in_ready_o;
    assign in_ready_o = turn_q == {CB{1'b0}};
    always @(posedge clk) begin
        turn_q <= turn_q == LAST[CB-1:0] ? {CB{1'b0}} : turn_q + 1'b1;
        if (rst) turn_q <= {CB{1'b0}};
    end

    // ---- product ----
    wire             p_valid;
    wire [AW+BN-1:0] p;
    wire [XW-1:0]    x = {{(XW-AW-BN){1'b0}}, p};
    rt_long_product #(.AW(AW), .BW(BN)) u_product (
        .clk(clk), .rst(rst), .start_i(take), .a_i(in_a_i), .b_i({{(BN-BW){1'b0}}, in_b_i}),
        .done_o(p_valid), .p_o(p)
    );

    // ---- meanwhile: d up until its first bit is 1, by z bits, and its reciprocal ----
    localparam UP = 128;
    reg  [DW-1:0]  n0_d_q;
    reg  [UP-1:0]  n1_q, n2_q;
    reg  [21:0]    n3_q;
    reg  [2:0]     n1_z_q;
    reg  [4:0]     n2_z_q;
    reg  [6:0]     n3_z_q;
    wire [UP-1:0]  n0 = {n0_d_q, {(UP-DW){1'b0}}};
    wire           z_64 = DW > 64 && n0[UP-1 -: 64] == 64'd0;
    wire [UP-1:0]  a_64 = z_64 ? n0 << 64 : n0;
    wire           z_32 = DW > 32 && a_64[UP-1 -: 32] == 32'd0;
    wire [UP-1:0]  a_32 = z_32 ? a_64 << 32 : a_64;
    wire           z_16 = a_32[UP-1 -: 16] == 16'd0;
    wire           z_8  = n1_q[UP-1 -: 8] == 8'd0;
    wire [UP-1:0]  a_8  = z_8 ? n1_q << 8 : n1_q;
    wire           z_4  = a_8[UP-1 -: 4] == 4'd0;
    wire           z_2  = n2_q[UP-1 -: 2] == 2'd0;
    wire [UP-1:0]  a_2  = z_2 ? n2_q << 2 : n2_q;
    wire           z_1  = !a_2[UP-1];
    wire [21:0]    n6_y;
    always @(posedge clk) begin
        if (take) n0_d_q <= in_d_i;
        n1_q   <= z_16 ? a_32 << 16 : a_32;
        n1_z_q <= {z_64, z_32, z_16};
        n2_q   <= z_4 ? a_8 << 4 : a_8;
        n2_z_q <= {n1_z_q, z_8, z_4};
        n3_q   <= z_1 ? a_2[UP-2 -: 22] : a_2[UP-1 -: 22];
        n3_z_q <= {n2_z_q, z_2, z_1};
    end
    rt_reciprocal u_reciprocal (.clk(clk), .top_i(n3_q), .more_i(1'b1), .y_o(n6_y));

    // ---- what enters the ring: in clock N + 3, y at its stage 2 ----
    localparam HELD = TAG + DW;
    wire [TAG-1:0] e_tag;
    wire [DW-1:0]  e_d;
    wire [6:0]     e_z;
    wire [20:0]    e_y;
    reg  [TAG-1:0] n0_tag_q;
    always @(posedge clk) if (take) n0_tag_q <= in_tag_i;
    rt_delay #(.WIDTH(HELD), .CYCLES(N+2)) u_held (
        .clk(clk), .in_i({n0_tag_q, n0_d_q}), .out_o({e_tag, e_d})
    );
    rt_delay #(.WIDTH(7), .CYCLES(N-1)) u_z (.clk(clk), .in_i(n3_z_q), .out_o(e_z));
    generate
        if (N > 2) begin : g_late
            rt_delay #(.WIDTH(21), .CYCLES(N-2)) u_y (.clk(clk), .in_i(n6_y[21:1]), .out_o(e_y));
        end else begin : g_now
            assign e_y = n6_y[21:1];
        end
    endgenerate

    // ---- ring, stage 0: what enters, or what goes round; its rounds, one hot ----
    reg  [N-1:0]   s7_round_q;
    reg  [DW:0]    s7_left_q;                // R
    reg  [BN-1:0]  s7_low_q;                 // what of the product is left; the quotient so far
    wire [TAG-1:0] s7_tag;
    wire [DW-1:0]  s7_d;
    wire [6:0]     s7_z;
    wire [20:0]    s9_y;                     // of stage 2, a round later
    wire           s2_new;                   // has entered in this round
    wire [N-1:0]   s0_round = p_valid ? {{(N-1){1'b0}}, 1'b1} : s7_round_q << 1;
    wire [RW-1:0]  s0_r     = p_valid ? x[BN-17 +: RW] : {s7_left_q, s7_low_q[BN-1 -: 17]};
    wire [BN-1:0]  s0_low   = p_valid ? {x[0 +: BN-17], 17'd0} : s7_low_q << 17;
    wire [TAG-1:0] s0_tag   = p_valid ? e_tag : s7_tag;
    wire [DW-1:0]  s0_d     = p_valid ? e_d : s7_d;
    wire [6:0]     s0_z     = p_valid ? e_z : s7_z;

    // ---- stages 1 and 2: T, R up by z bits: 8 at once, then single ones ----
    function [27:0] bytes(input [RW-1:0] r, input [3:0] n);
        reg [RW+130:0] all;
        integer k;
        begin
            all   = {r, 131'd0};
            bytes = 28'd0;
            for (k = 0; k < 16; k = k + 1)
                if (n == k[3:0]) bytes = all[RW+130-8*k -: 28];
        end
    endfunction
    reg  [27:0]    s1_t_q;
    reg  [2:0]     s1_z_q;
    reg  [20:0]    s2_t_q;
    wire [27:0]    s1_t = s1_t_q << s1_z_q;
    always @(posedge clk) begin
        s1_t_q <= bytes(s0_r, s0_z[6:3]);
        s1_z_q <= s0_z[2:0];
        s2_t_q <= s1_t[27 -: 21];
    end

    // ---- stages 3 and 4: T * y, but for the product of their last 3 bits ----
    reg  [35:0]    s3_high_q;
    reg  [20:0]    s3_left_q, s3_right_q;
    reg  [17:0]    s4_q_q;
    wire [20:0]    s2_y  = s2_new ? e_y : s9_y;
    wire [21:0]    s3_low = {1'b0, s3_left_q} + {1'b0, s3_right_q};
    wire [38:0]    s3_ty = {s3_high_q, 3'd0} + {17'd0, s3_low};   // T * y / 8, y of 21 bits
    always @(posedge clk) begin
        s3_high_q  <= s2_t_q[20:3] * s2_y[20:3];
        s3_left_q  <= s2_t_q[20:3] * s2_y[2:0];
        s3_right_q <= s2_t_q[2:0] * s2_y[20:3];
        s4_q_q     <= s3_ty[37:20];
    end

    // ---- what waits in the ring ----
    wire [DW:0]    s5_r;
    wire [BN-1:0]  s4_low;
    wire [DW-1:0]  s4_d;
    wire [N-1:0]   s6_round;
    rt_delay #(.WIDTH(DW+1), .CYCLES(5)) u_r (.clk(clk), .in_i(s0_r[DW:0]), .out_o(s5_r));
    rt_delay #(.WIDTH(BN), .CYCLES(4)) u_low (.clk(clk), .in_i(s0_low), .out_o(s4_low));
    rt_delay #(.WIDTH(DW), .CYCLES(4)) u_d (.clk(clk), .in_i(s0_d), .out_o(s4_d));
    rt_delay #(.WIDTH(DW), .CYCLES(3)) u_d_on (.clk(clk), .in_i(s4_d), .out_o(s7_d));
    rt_delay #(.WIDTH(TAG+7), .CYCLES(7)) u_tag (
        .clk(clk), .in_i({s0_tag, s0_z}), .out_o({s7_tag, s7_z})
    );
    rt_delay #(.WIDTH(21), .CYCLES(7)) u_y_on (.clk(clk), .in_i(s2_y), .out_o(s9_y));
    rt_delay_valid #(.CYCLES(2)) u_new (.clk(clk), .rst(rst), .in_i(p_valid), .out_o(s2_new));
    genvar i;
    generate
        for (i = 0; i < N; i = i + 1) begin : g_round
            rt_delay_valid #(.CYCLES(6)) u_round (
                .clk(clk), .rst(rst), .in_i(s0_round[i]), .out_o(s6_round[i])
            );
        end
    endgenerate

    // ---- stages 5 to 7: R - q * d, of which DW+1 bits say all; pieces of q * d have 35 bits ----
    localparam D = (DW + 16) / 17, PW = 17*D + 35;
    wire [17*D-1:0] d_pieces = {{(17*D-DW){1'b0}}, s4_d};
    wire [PW-1:0]  even, odd, over;
    reg  [DW:0]    s6_u_q, s6_v_q;
    reg  [BN-1:0]  s5_low_q, s6_low_q;
    generate
        for (i = 0; i < D; i = i + 1) begin : g_piece
            reg [34:0] s5_p_q;
            always @(posedge clk) s5_p_q <= s4_q_q * d_pieces[17*i +: 17];
            if (i % 2 == 0) assign even[17*i +: 34] = s5_p_q[33:0];
            else            assign odd[17*i +: 34]  = s5_p_q[33:0];
            assign over[17*i +: 17] = {16'd0, s5_p_q[34]};           // 34 bits above
        end
        assign odd[16:0] = 17'd0;
        assign over[PW-1:17*D] = 35'd0;
        if (D % 2 == 0) begin : g_even
            assign even[PW-1:17*D] = 35'd0;
            assign odd[PW-1:17*D+17] = 18'd0;
        end else begin : g_odd
            assign even[PW-1:17*D+17] = 18'd0;
            assign odd[PW-1:17*D] = 35'd0;
        end
    endgenerate
    wire [PW-1:0]  over_up = over << 34;
    always @(posedge clk) begin
        s5_low_q   <= s4_low + {{(BN-18){1'b0}}, s4_q_q};
        s6_u_q     <= s5_r - even[DW:0];
        s6_v_q     <= odd[DW:0] + over_up[DW:0];
        s6_low_q   <= s5_low_q;
        s7_left_q  <= s6_u_q - s6_v_q;
        s7_low_q   <= s6_low_q;
        s7_round_q <= s6_round;
        if (rst) s7_round_q <= {N{1'b0}};
    end

    // ---- key: R / d is 0, at most 1, or below 2 ----
    reg              k_valid_q, k_some_q, k_more_q;
    reg  [TAG-1:0]   k_tag_q;
    reg  [BW:0]      k_key_q;
    always @(posedge clk) begin
        k_valid_q   <= s7_round_q[N-1];
        k_some_q    <= s7_left_q != {(DW+1){1'b0}};
        k_more_q    <= s7_left_q > {1'b0, s7_d};
        k_tag_q     <= s7_tag;
        k_key_q     <= {1'b0, s7_low_q[BW-1:0]};
        out_valid_o <= k_valid_q;
        out_tag_o   <= k_tag_q;
        out_key_o   <= k_key_q + {{(BW-1){1'b0}}, k_more_q, k_some_q && !k_more_q};
        if (rst) {k_valid_q, out_valid_o} <= 2'd0;
    end
    wire unused = &{1'b0, x, n3_q, n6_y[0], s1_t[6:0], s3_ty[38], s3_ty[19:0], even, odd, over_up,
                    s7_low_q};
endmodule
`default_nettype wire
