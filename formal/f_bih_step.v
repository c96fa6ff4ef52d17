// f_bih_step.v - proof that rt_bih_step never cuts off what lies in a child, at a small width
// SPDX-License-Identifier: Apache-2.0
// Inputs are anything; LATENCY clocks later, with v the exact distances along the ray to the near
// plane and to the far one, and any a/|dir| * 2^shift = q in [g, g + 2): a point before the near
// plane has key v*q / 2^shift < upper, one behind the far plane at least lower.
`default_nettype none
`include "rt_layout.vh"
`include "rt_latency.vh"
module f_bih_step #(
    parameter W = 4
) (
    input wire                 clk,
    input wire signed [W-1:0]  org,
    input wire                 back, flat, open,
    input wire [5:0]           shift,
    input wire [`RT_BIH_G-1:0] g,
    input wire signed [W+1:0]  clip_l, clip_r
);
    localparam T  = `RT_BIH_STEP_LATENCY;
    localparam IN = 3*W + 13 + `RT_BIH_G;
    localparam X  = `RT_BIH_T + 64;                  // bits of the exact words
    wire out_back, out_near, out_far;
    wire [`RT_BIH_T-1:0] upper, lower;
    rt_bih_step #(.W(W)) u_dut (
        .clk(clk), .in_org_i(org), .in_back_i(back), .in_flat_i(flat), .in_open_i(open),
        .in_shift_i(shift), .in_g_i(g), .in_clip_l_i(clip_l), .in_clip_r_i(clip_r),
        .out_back_o(out_back), .out_near_o(out_near), .out_far_o(out_far),
        .out_upper_o(upper), .out_lower_o(lower)
    );

    // ---- what came in LATENCY clocks before ----
    reg [T*IN-1:0] line_q;
    always @(posedge clk)
        line_q <= {line_q[(T-1)*IN-1:0], clip_r, clip_l, org, back, flat, open, shift, g};
    wire signed [W+1:0] t_r, t_l;
    wire signed [W-1:0] t_org;
    wire                t_back, t_flat, t_open;
    wire [5:0]          t_shift;
    wire [`RT_BIH_G-1:0] t_g;
    assign {t_r, t_l, t_org, t_back, t_flat, t_open, t_shift, t_g} = line_q[T*IN-1 -: IN];

    wire signed [W+2:0] near = t_back ? t_org - t_r : t_l - t_org;
    wire signed [W+2:0] far  = t_back ? t_org - t_l : t_r - t_org;
    wire [X-1:0] near_v = near, far_v = far;         // for those that are not negative
    wire [X-1:0] end_key   = near_v * (t_g + {{(X-2){1'b0}}, 2'd2});
    wire [X-1:0] begin_key = far_v * t_g;
    reg [2:0] age_q = 3'd0;
    always @(posedge clk) age_q <= age_q + (age_q != T);
    always @* if (age_q == T) begin
        assert (out_back == t_back);
        assert (out_near == (near >= 0));
        assert (out_far == (!t_flat || far <= 0));
        if (near >= 0 && upper != {`RT_BIH_T{1'b1}})
            assert (!t_flat && !t_open &&
                    end_key < ({{(X-`RT_BIH_T){1'b0}}, upper} << t_shift));
        if (far <= 0 || t_flat) assert (lower == 0);
        else assert (({{(X-`RT_BIH_T){1'b0}}, lower} << t_shift) <= begin_key);
    end
endmodule
`default_nettype wire
