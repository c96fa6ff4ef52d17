// f_divide.v - proof of a round of rt_divide, and of the key behind the last one
// SPDX-License-Identifier: Apache-2.0
// From any state, with any operands before and behind: of what is there at the start of a round it
// makes what digits.smt2 says of integers. Products are any function.
`timescale 1ns / 1ps
`default_nettype none
module f_divide #(
    parameter BW = 34,
    parameter DW = 50
) (
    input wire          clk,
    input wire          in_valid,
    input wire [3:0]    tag,
    input wire [DW-1:0] a,
    input wire [BW-1:0] b,
    input wire [DW-1:0] d
);
    localparam N = BW > 17 ? (BW + 16) / 17 : 2, BN = 17*N, RW = DW + 18, D = (DW + 16) / 17;
    wire in_ready, out_valid;
    wire [3:0]  out_tag;
    wire [BW:0] key;
    rt_divide #(.AW(DW), .BW(BW), .DW(DW), .TAG(4)) u_dut (
        .clk(clk), .rst(1'b0), .in_valid_i(in_valid), .in_ready_o(in_ready), .in_tag_i(tag),
        .in_a_i(a), .in_b_i(b), .in_d_i(d), .out_valid_o(out_valid), .out_tag_o(out_tag),
        .out_key_o(key)
    );
    (* hierconn *) wire [RW-1:0] \u_dut.s0_r ;
    (* hierconn *) wire [BN-1:0] \u_dut.s0_low , \u_dut.s7_low_q ;
    (* hierconn *) wire [DW-1:0] \u_dut.s0_d , \u_dut.s7_d ;
    (* hierconn *) wire [6:0]    \u_dut.s0_z , \u_dut.s7_z ;
    (* hierconn *) wire [3:0]    \u_dut.s0_tag , \u_dut.s7_tag ;
    (* hierconn *) wire [N-1:0]  \u_dut.s0_round , \u_dut.s7_round_q ;
    (* hierconn *) wire [20:0]   \u_dut.s2_y ;
    (* hierconn *) wire [DW:0]   \u_dut.s7_left_q ;

    // ---- what a round makes ----
    reg  [3:0]    age_q = 4'd0;
    reg  [RW-1:0] r_q;
    reg  [BN-1:0] low_q;
    reg  [DW-1:0] d_q;
    reg  [6:0]    z_q;
    reg  [3:0]    tag_q;
    reg  [N-1:0]  round_q;
    reg  [20:0]   y_q;
    (* anyseq *) wire [17:0]     t_high, y_high, q_any;   // constants would leave their products
    (* anyseq *) wire [2:0]      t_low, y_low;
    (* anyseq *) wire [17*D-1:0] d_any;
    function [35:0] high(input [17:0] x, input [17:0] y); high = x * y;
    endfunction
    function [20:0] low(input [17:0] x, input [2:0] y); low = x * y;
    endfunction
    function [20:0] mirrored(input [2:0] x, input [17:0] y); mirrored = x * y;
    endfunction
    function [34:0] piece(input [17:0] x, input [16:0] y); piece = x * y;
    endfunction
    wire [DW+20:0] up  = {r_q, 3'd0} << z_q;
    wire [20:0]    t   = up[DW+20 -: 21];
    wire [38:0]    ty  = {high(t_high, y_high), 3'd0} + low(t_high, y_low) +
                         mirrored(t_low, y_high);
    wire [17:0]    q   = ty[37:20];
    wire [DW:0]    qd [0:D];
    assign qd[0] = 0;
    genvar i;
    generate
        for (i = 0; i < D; i = i + 1) begin : g_piece
            wire [DW+35:0] one = piece(q_any, d_any[17*i +: 17]);
            assign qd[i+1] = qd[i] + (one << 17*i);
        end
    endgenerate
    wire [DW:0]    left = r_q[DW:0] - qd[D];
    wire [BN-1:0]  sum  = low_q + q;
    reg  [DW:0]    left_q;
    reg  [BN-1:0]  quotient_q;
    reg  [DW-1:0]  by_q;
    reg            last_q;
    always @(posedge clk) begin
        if (!(&age_q)) age_q <= age_q + 1'b1;
        if (age_q == 0)
            {r_q, low_q, d_q, z_q, tag_q, round_q} <=
                {\u_dut.s0_r , \u_dut.s0_low , \u_dut.s0_d , \u_dut.s0_z , \u_dut.s0_tag ,
                 \u_dut.s0_round };
        if (age_q == 2) y_q <= \u_dut.s2_y ;
        if (age_q == 7)
            {left_q, quotient_q, by_q, last_q} <=
                {\u_dut.s7_left_q , \u_dut.s7_low_q , \u_dut.s7_d , \u_dut.s7_round_q [N-1]};
    end
    wire [1:0] more = left_q > by_q ? 2 : left_q != 0;
    always @* begin
        if (age_q == 7) begin
            assume ({t_high, t_low} == t && {y_high, y_low} == y_q && q_any == q && d_any == d_q);
            assert (\u_dut.s7_left_q == left && \u_dut.s7_low_q == sum);
            assert (\u_dut.s7_d == d_q && \u_dut.s7_z == z_q && \u_dut.s7_tag == tag_q);
            assert (\u_dut.s7_round_q == round_q);
        end
        if (age_q == 9) begin
            assert (out_valid == last_q);
            if (out_valid) assert (out_tag == tag_q && key == quotient_q[BW-1:0] + more);
        end
    end
endmodule
`default_nettype wire
