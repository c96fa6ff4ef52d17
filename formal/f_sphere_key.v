// f_sphere_key.v - proof of rt_sphere_key: each leaf hit leaves once, in order, with its own key
// SPDX-License-Identifier: Apache-2.0
// Any hit may be marked. What stands for the root (f_any_root.v) is the hit's own. Resets at any
// time.
`timescale 1ns / 1ps
`default_nettype none
module f_sphere_key #(
    parameter W      = 4,
    parameter WD     = 5,
    parameter TAG    = 4,
    parameter PR     = 0,
    parameter INSIDE = 1
) (
    input wire                   clk,
    input wire                   rst,
    input wire                   in_valid, in_far, pick,
    input wire [TAG-1:0]         in_tag,
    input wire [2*W+2*WD-1:0]    in_disc,
    input wire signed [W+WD+1:0] in_b
);
    localparam XW = 2*W + 2*WD;
    localparam KW = W + WD + 2;
    wire in_ready, out_valid, out_far;
    wire [TAG-1:0] out_tag;
    wire [KW-1:0]  out_key;
    rt_sphere_key #(.W(W), .WD(WD), .PR(PR), .TAG(TAG), .INSIDE(INSIDE)) u_dut (
        .clk(clk), .rst(rst), .in_valid_i(in_valid), .in_ready_o(in_ready), .in_tag_i(in_tag),
        .in_far_i(in_far), .in_disc_i(in_disc), .in_b_i(in_b), .out_valid_o(out_valid),
        .out_tag_o(out_tag), .out_far_o(out_far), .out_key_o(out_key)
    );
    localparam AW = XW + TAG + KW + (INSIDE != 0 ? 1 : 0);
    (* hierconn *) wire          \u_dut.u_isqrt.full_q ;
    (* hierconn *) wire [AW-1:0] \u_dut.u_isqrt.held_q ;

    // ---- model: the marked hit ----
    reg             old_q = 1'b0, marked_q;
    reg [TAG-1:0]   tag_q;
    reg             far_q;
    reg [KW-1:0]    b_q;
    reg [XW-1:0]    x_q;
    wire take = in_valid && in_ready;
    localparam RW = PR != 0 ? PR : XW/2;
    wire [KW-1:0] root = x_q[RW-1:0] << (PR != 0 ? x_q[XW-2 -: 2] : 0);
    wire [KW-1:0] sum  = far_q ? b_q + root + x_q[XW-1] : b_q - root;
    // the bits that PR cuts off may outweigh the rest: b < 0, and the sum not above 0
    wire          none = PR != 0 && far_q && b_q[KW-1] && (sum[KW-1] || sum == 0);
    wire [KW-1:0] key  = none ? 1 : sum;
    wire [AW:0]   all  = {far_q, tag_q, b_q, x_q};
    always @(posedge clk) begin
        old_q <= 1'b1;
        if (out_valid) marked_q <= 1'b0;
        if (take && pick) begin
            marked_q <= 1'b1;
            tag_q    <= in_tag;
            far_q    <= in_far && INSIDE != 0;
            b_q      <= in_b;
            x_q      <= in_disc;
        end
        if (rst) marked_q <= 1'b0;
    end
    always @* if (!old_q) assume (rst);
    always @* if (old_q) begin
        if (marked_q && out_valid) assert (out_tag == tag_q && out_far == far_q && out_key == key);
        if (INSIDE == 0) assert (!out_far);
        // invariant
        if (marked_q) assert (\u_dut.u_isqrt.full_q && \u_dut.u_isqrt.held_q == all[AW-1:0]);
    end
endmodule
`default_nettype wire
