// f_root_pool.v - proof of rt_root_pool: each leaf hit leaves once, with the key of its own root
// SPDX-License-Identifier: Apache-2.0
// Any hit may be marked. Roots may take any time (f_any_root.v): what stands for the root is the
// hit's own. Stalls and resets at any time.
`timescale 1ns / 1ps
`default_nettype none
module f_root_pool #(
    parameter W      = 4,
    parameter WD     = 5,
    parameter TAG    = 4,
    parameter PR     = 0,
    parameter INSIDE = 1
) (
    input wire                   clk,
    input wire                   rst,
    input wire                   in_valid, in_far, out_ready, pick,
    input wire [TAG-1:0]         in_tag,
    input wire [2*W+2*WD-1:0]    in_disc,
    input wire signed [W+WD+1:0] in_b
);
    localparam UNITS = 3;
    localparam XW = 2*W + 2*WD;
    localparam KW = W + WD + 2;
    wire in_ready, out_valid, out_far;
    wire [TAG-1:0] out_tag;
    wire [KW-1:0]  out_key;
    rt_root_pool #(.W(W), .WD(WD), .PR(PR), .UNITS(UNITS), .TAG(TAG), .INSIDE(INSIDE)) u_dut (
        .clk(clk), .rst(rst), .in_valid_i(in_valid), .in_ready_o(in_ready), .in_tag_i(in_tag),
        .in_far_i(in_far), .in_disc_i(in_disc), .in_b_i(in_b), .out_valid_o(out_valid),
        .out_ready_i(out_ready), .out_tag_o(out_tag), .out_far_o(out_far), .out_key_o(out_key)
    );
    (* hierconn *) wire [UNITS-1:0] \u_dut.take , \u_dut.u_pool.turn , \u_dut.done ;
    (* hierconn *) wire \u_dut.g_unit[0].u_isqrt.full_q , \u_dut.g_unit[1].u_isqrt.full_q ;
    (* hierconn *) wire \u_dut.g_unit[2].u_isqrt.full_q ;
    (* hierconn *) wire [TAG-1:0] \u_dut.u_pool.g_unit[0].tag_q , \u_dut.u_pool.g_unit[1].tag_q ;
    (* hierconn *) wire [TAG-1:0] \u_dut.u_pool.g_unit[2].tag_q ;
    (* hierconn *) wire \u_dut.g_unit[0].far_q , \u_dut.g_unit[1].far_q , \u_dut.g_unit[2].far_q ;
    (* hierconn *) wire [KW-1:0] \u_dut.g_unit[0].b_q , \u_dut.g_unit[1].b_q ;
    (* hierconn *) wire [KW-1:0] \u_dut.g_unit[2].b_q ;
    (* hierconn *) wire [XW-1:0] \u_dut.g_unit[0].u_isqrt.x_q , \u_dut.g_unit[1].u_isqrt.x_q ;
    (* hierconn *) wire [XW-1:0] \u_dut.g_unit[2].u_isqrt.x_q ;
    wire [UNITS-1:0] full = {\u_dut.g_unit[2].u_isqrt.full_q , \u_dut.g_unit[1].u_isqrt.full_q ,
                             \u_dut.g_unit[0].u_isqrt.full_q };
    localparam HW = TAG + 1 + KW + XW;
    wire [HW-1:0] hit_0 = {\u_dut.u_pool.g_unit[0].tag_q , \u_dut.g_unit[0].far_q ,
                           \u_dut.g_unit[0].b_q , \u_dut.g_unit[0].u_isqrt.x_q };
    wire [HW-1:0] hit_1 = {\u_dut.u_pool.g_unit[1].tag_q , \u_dut.g_unit[1].far_q ,
                           \u_dut.g_unit[1].b_q , \u_dut.g_unit[1].u_isqrt.x_q };
    wire [HW-1:0] hit_2 = {\u_dut.u_pool.g_unit[2].tag_q , \u_dut.g_unit[2].far_q ,
                           \u_dut.g_unit[2].b_q , \u_dut.g_unit[2].u_isqrt.x_q };

    // ---- model: how many are inside; of the marked one what it is, and in which unit ----
    reg             old_q = 1'b0, marked_q;
    reg [2:0]       count_q;
    reg [UNITS-1:0] unit_q;
    reg [TAG-1:0]   tag_q;
    reg             far_q;
    reg [KW-1:0]    b_q;
    reg [XW-1:0]    x_q;
    wire take = in_valid && in_ready;
    wire give = out_valid && out_ready;
    wire mine = marked_q && \u_dut.u_pool.turn == unit_q;         // stands at the output
    localparam RW = PR != 0 ? PR : XW/2;
    wire [KW-1:0] root = x_q[RW-1:0] << (PR != 0 ? x_q[XW-2 -: 2] : 0);
    wire [KW-1:0] sum  = far_q ? b_q + root + x_q[XW-1] : b_q - root;
    // the bits that PR cuts off may outweigh the rest: b < 0, and the sum not above 0
    wire          none = PR != 0 && far_q && b_q[KW-1] && (sum[KW-1] || sum == 0);
    wire [KW-1:0] key  = none ? 1 : sum;
    always @(posedge clk) begin
        old_q   <= 1'b1;
        count_q <= count_q + {2'd0, take} - {2'd0, give};
        if (mine && give) marked_q <= 1'b0;
        if (take && pick && (!marked_q || (mine && give))) begin
            marked_q <= 1'b1;
            unit_q   <= \u_dut.take ;
            tag_q    <= in_tag;
            far_q    <= in_far && INSIDE != 0;
            b_q      <= in_b;
            x_q      <= in_disc;
        end
        if (rst) begin count_q <= 3'd0; marked_q <= 1'b0; end
    end
    always @* if (!old_q) assume (rst);

    always @* if (old_q) begin
        assert (count_q <= UNITS);
        assert (in_ready == (count_q != UNITS));           // a unit is free
        assert (out_valid == |\u_dut.done );
        if (out_valid) assert (count_q != 0);
        if (mine) assert (out_valid && out_tag == tag_q && out_far == far_q && out_key == key);
        // what is done leaves, or one of another unit does
        if (marked_q && (\u_dut.done & unit_q) != 0)
            assert (out_valid && \u_dut.u_pool.turn != 0);
        // invariant
        assert (count_q == {2'd0, full[0]} + {2'd0, full[1]} + {2'd0, full[2]});
        if (marked_q) begin
            assert (unit_q == 1 || unit_q == 2 || unit_q == 4);
            assert ((full & unit_q) != 0);
            assert ({tag_q, far_q, b_q, x_q} == (unit_q[0] ? hit_0 : unit_q[1] ? hit_1 : hit_2));
        end
    end
endmodule
`default_nettype wire
