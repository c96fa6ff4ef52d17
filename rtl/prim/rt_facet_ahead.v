// rt_facet_ahead.v - what tells whether a facet lies ahead of where a ray's origin was rounded from
// SPDX-License-Identifier: Apache-2.0
//   along = N.lift, without CARRY     size = |N_x| + |N_y| + |N_z|
// N times a component of lift in digits of two bits, -2 to 1, the top one -1 to 1: no multiplier.
//   products, magnitudes | two of three | sums | WAIT clocks
// A facet a clock; latency 3 + WAIT clocks. Model: ahead() in cmodel/prim/facet.c
`timescale 1ns / 1ps
`default_nettype none
module rt_facet_ahead #(
    parameter CW   = 34,                     // component of N, bits
    parameter NG   = 2,                      // guard bits of a hit point
    parameter WAIT = 1                       // at least 1
) (
    input  wire                 clk,
    input  wire [3*CW-1:0]      n_i,         // 3 x sCW, not the least number
    input  wire [3*(NG+2)-1:0]  lift_i,      // 3 x s(NG+2), at most 2^NG either way
    output wire [CW+NG+1:0]     along_o,     // s(CW+NG+2), to which carry_o has to be added
    output wire                 carry_o,
    output wire [CW:0]          size_o       // u(CW+1)
);
    localparam DIGITS = (NG + 3)/2;
    localparam PW = CW + NG + 2;

    // ---- stage 1: products but for the last digit's carry; magnitudes but for the sign's ----
    reg  [3*PW-1:0] s1_p_q;
    reg  [3*CW-1:0] s1_m_q;
    reg  [2:0]      s1_neg_q, s1_turn_q;     // carries of the products, of the magnitudes
    genvar i, k;
    generate
        for (i = 0; i < 3; i = i + 1) begin : g_axis
            wire [CW-1:0]     n = n_i[CW*i +: CW];
            wire [NG+1:0]     l = lift_i[(NG+2)*i +: NG+2];
            wire [2*DIGITS:0] bits = {{(2*DIGITS-NG-1){l[NG+1]}}, l[NG:0], 1'b0};
            for (k = 0; k < DIGITS; k = k + 1) begin : g_digit
                wire          neg = bits[2*k+2];
                wire          one = bits[2*k+1] != bits[2*k];
                wire          two = k < DIGITS - 1 && bits[2*k+1] == bits[2*k] && neg != bits[2*k];
                wire [CW:0]   term = (one ? {n[CW-1], n} : two ? {n, 1'b0} : {(CW+1){1'b0}})
                                     ^ {(CW+1){neg}};
                wire [PW-1:0] sum;           // of the digits so far
                if (k == 0) begin : g_first
                    assign sum = {{(PW-CW-1){term[CW]}}, term};
                end else begin : g_more
                    wire [PW+2*k:0] high = {{(PW-CW){term[CW]}}, term, {(2*k){neg}}};
                    wire [PW:0]     s = {g_digit[k-1].sum, 1'b1} + {high[PW-1:0], bits[2*k]};
                    assign sum = s[PW:1];
                    wire unused = &{1'b0, s[0], high};
                end
            end
            always @(posedge clk) begin
                s1_p_q[PW*i +: PW] <= g_digit[DIGITS-1].sum;
                s1_m_q[CW*i +: CW] <= n ^ {CW{n[CW-1]}};
                s1_neg_q[i]        <= l[NG+1];
                s1_turn_q[i]       <= n[CW-1];
            end
        end
    endgenerate

    // ---- stages 2 and 3: sums ----
    reg  [PW-1:0] s2_p_q, s2_two_q, s3_along_q;
    reg  [CW:0]   s2_m_q, s2_size_q, s3_size_q;
    reg  [1:0]    s2_neg_q;
    reg           s3_neg_q;
    wire [PW:0]   s1_two = {s1_p_q[0 +: PW], 1'b1} + {s1_p_q[PW +: PW], s1_neg_q[0]};
    wire [CW+1:0] s1_size = {1'b0, s1_m_q[0 +: CW], 1'b1} + {1'b0, s1_m_q[CW +: CW], s1_turn_q[0]};
    wire [PW:0]   s2_all = {s2_two_q, 1'b1} + {s2_p_q, s2_neg_q[0]};
    wire [CW:0]   s1_last = {1'b0, s1_m_q[2*CW +: CW]} + {{CW{1'b0}}, s1_turn_q[2]};
    reg           s2_turn_q;
    wire [CW+1:0] s2_sum = {s2_size_q, 1'b1} + {s2_m_q, s2_turn_q};
    always @(posedge clk) begin
        s2_two_q   <= s1_two[PW:1];
        s2_p_q     <= s1_p_q[2*PW +: PW];
        s2_neg_q   <= s1_neg_q[2:1];
        s2_size_q  <= s1_size[CW+1:1];
        s2_m_q     <= s1_last;
        s2_turn_q  <= s1_turn_q[1];
        s3_along_q <= s2_all[PW:1];
        s3_neg_q   <= s2_neg_q[1];
        s3_size_q  <= s2_sum[CW+1:1];
    end
    rt_delay #(.WIDTH(PW+CW+2), .CYCLES(WAIT)) u_wait (
        .clk(clk), .in_i({s3_neg_q, s3_along_q, s3_size_q}), .out_o({carry_o, along_o, size_o})
    );
    wire unused = &{1'b0, s1_two[0], s1_size[0], s2_all[0], s2_sum[0]};
endmodule
`default_nettype wire
