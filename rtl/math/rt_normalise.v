// rt_normalise.v - one shift that fits a vector into a width
// SPDX-License-Identifier: Apache-2.0
// The largest component gets its top magnitude bit at BITS-2: the vector is shifted left until that
// bit is below the sign, then the top BITS are taken, rounded half up and limited.
//   in x y z --> [v 3x, any] --> coarse, any --> [<< 8*coarse] --> [<< fine] --> [round] --> out
// One component at a time: x, y, z enter in three cycles, gaps allowed; the result comes 7 cycles
// after z. The next x may enter 5 cycles after z or later.
// Model: sph_normalise() in cmodel/math/arith.c
`timescale 1ns / 1ps
`default_nettype none
module rt_normalise #(
    parameter VW   = 19,  // component at the input, bits, at least 2
    parameter BITS = 17   // component at the output, bits, at least 3
) (
    input  wire                   clk,
    input  wire                   rst,
    input  wire                   in_valid_i,   // one component
    input  wire signed [VW-1:0]   in_v_i,       // x, then y, then z
    output reg                    out_valid_o,  // one cycle, all three
    output reg  signed [BITS-1:0] out_x_o,
    output reg  signed [BITS-1:0] out_y_o,
    output reg  signed [BITS-1:0] out_z_o
);
    localparam BYTES = (VW + 6) / 8;            // of the magnitude's VW-1 bits
    localparam CB    = BYTES > 1 ? $clog2(BYTES) : 1;
    localparam AW    = BITS + 8;                // kept after the coarse shift: fine takes 7 more
    localparam SPARE = VW < AW ? AW - VW + 1 : 1;
    localparam LW    = VW + SPARE;              // vector with room below

    function [CB-1:0] first_byte(input [8*BYTES-1:0] word);  // zero bytes on top
        integer i;
        begin
            first_byte = {CB{1'b0}};
            for (i = BYTES - 1; i >= 0; i = i - 1)
                if (|word[8*(BYTES-1-i) +: 8]) first_byte = i[CB-1:0];
        end
    endfunction
    function [2:0] first_bit(input [7:0] word);              // zero bits on top
        integer i;
        begin
            first_bit = 3'd0;
            for (i = 7; i >= 0; i = i - 1)
                if (word[7-i]) first_bit = i[2:0];
        end
    endfunction

    // ---- stage 1: collect, x at the head; OR of the magnitudes, top bit first ----
    reg  [VW-1:0]      s1_x_q, s1_y_q, s1_z_q;
    reg  [8*BYTES-1:0] s1_any_q;
    reg  [2:0]         s1_next_q;               // one-hot: the component that enters next
    reg  [5:1]         step_q;                  // step_q[n]: n cycles after z
    wire [VW-2:0]      mag    = in_v_i[VW-2:0] ^ {(VW-1){in_v_i[VW-1]}};
    wire [8*BYTES-1:0] old    = s1_any_q & {(8*BYTES){!s1_next_q[0]}};
    wire               leave  = |step_q[4:2];
    always @(posedge clk) begin
        if (in_valid_i || leave) begin
            s1_z_q <= in_v_i;
            s1_y_q <= s1_z_q;
            s1_x_q <= s1_y_q;
        end
        if (in_valid_i) begin
            s1_any_q  <= old;
            s1_any_q[8*BYTES-1 -: VW-1] <= old[8*BYTES-1 -: VW-1] | mag;
            s1_next_q <= {s1_next_q[1:0], s1_next_q[2]};
        end
        step_q <= {step_q[4:1], in_valid_i && s1_next_q[2]};
        if (rst) begin
            s1_next_q <= 3'b001;
            step_q    <= 5'd0;
        end
    end

    // ---- stage 2: zero bytes of all three; stage 3: zero bits of their first byte ----
    reg  [CB-1:0]      s2_coarse_q;
    reg  [2:0]         s3_fine_q;
    reg                s3_half_q;               // 0: all are 0 or -1 and stay so
    wire [8*BYTES-1:0] s2_any = s1_any_q << {s2_coarse_q, 3'd0};
    always @(posedge clk) begin
        if (step_q[1]) s2_coarse_q <= first_byte(s1_any_q);
        if (step_q[2]) s3_fine_q   <= first_bit(s2_any[8*BYTES-1 -: 8]);
        if (step_q[2]) s3_half_q   <= |s2_any[8*BYTES-1 -: 8];
    end

    // ---- stages 3 and 4: shift each component ----
    reg  [AW-1:0]      s3_v_q;
    reg  [BITS:0]      s4_v_q;                  // BITS and one to round
    wire [LW-1:0]      s3_v = {s1_x_q, {SPARE{1'b0}}} << {s2_coarse_q, 3'd0};
    wire [AW-1:0]      s4_v = s3_v_q << s3_fine_q;
    always @(posedge clk) begin
        if (leave)       s3_v_q <= s3_v[LW-1 -: AW];
        if (|step_q[5:3]) s4_v_q <= s4_v[AW-1 -: BITS+1];
    end

    // ---- stage 5: round half up; only the largest positive value can overflow ----
    wire [BITS:0]      s5_sum  = s4_v_q + {{BITS{1'b0}}, s3_half_q};
    wire               s5_over = s5_sum[BITS] && !s4_v_q[BITS];
    wire [BITS-1:0]    s5_v    = s5_over ? {1'b0, {(BITS-1){1'b1}}} : s5_sum[BITS:1];
    reg                s5_last_q;
    always @(posedge clk) begin
        if (|step_q[5:4] || s5_last_q) begin
            out_z_o <= s5_v;
            out_y_o <= out_z_o;
            out_x_o <= out_y_o;
        end
        s5_last_q   <= step_q[5];
        out_valid_o <= s5_last_q;
        if (rst) begin
            s5_last_q   <= 1'b0;
            out_valid_o <= 1'b0;
        end
    end
    wire unused = &{1'b0, s2_any[8*BYTES-9:0], s3_v[LW-AW-1:0], s4_v[AW-BITS-2:0], s5_sum[0]};
endmodule
`default_nettype wire
