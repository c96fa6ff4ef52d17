// f_quotient_pool.v - proof of rt_quotient_pool: each hit leaves once, with its own quotient
// SPDX-License-Identifier: Apache-2.0
// Any hit may be marked. Quotients may take any time (f_any_quotient.v): what stands for the
// quotient is the hit's own. Stalls and resets at any time.
`timescale 1ns / 1ps
`default_nettype none
module f_quotient_pool #(
    parameter KW  = 11,
    parameter AW  = 10,
    parameter PQ  = 5,
    parameter TAG = 4
) (
    input wire           clk,
    input wire           rst,
    input wire           in_valid, out_ready, pick,
    input wire [TAG-1:0] in_tag,
    input wire [KW-1:0]  in_key,
    input wire [AW-1:0]  in_a
);
    localparam UNITS = 3;
    wire in_ready, out_valid;
    wire [TAG-1:0] out_tag;
    wire [PQ-1:0]  out_mant;
    wire [7:0]     out_exp;
    rt_quotient_pool #(.KW(KW), .AW(AW), .PQ(PQ), .UNITS(UNITS), .TAG(TAG)) u_dut (
        .clk(clk), .rst(rst), .in_valid_i(in_valid), .in_ready_o(in_ready), .in_tag_i(in_tag),
        .in_key_i(in_key), .in_a_i(in_a), .out_valid_o(out_valid), .out_ready_i(out_ready),
        .out_tag_o(out_tag), .out_mant_o(out_mant), .out_exp_o(out_exp)
    );
    (* hierconn *) wire [UNITS-1:0] \u_dut.take , \u_dut.u_pool.turn , \u_dut.done ;
    (* hierconn *) wire \u_dut.g_unit[0].u_quotient.full_q , \u_dut.g_unit[1].u_quotient.full_q ;
    (* hierconn *) wire \u_dut.g_unit[2].u_quotient.full_q ;
    (* hierconn *) wire [TAG-1:0] \u_dut.u_pool.g_unit[0].tag_q , \u_dut.u_pool.g_unit[1].tag_q ;
    (* hierconn *) wire [TAG-1:0] \u_dut.u_pool.g_unit[2].tag_q ;
    (* hierconn *) wire [KW-1:0] \u_dut.g_unit[0].u_quotient.key_q ;
    (* hierconn *) wire [KW-1:0] \u_dut.g_unit[1].u_quotient.key_q ;
    (* hierconn *) wire [KW-1:0] \u_dut.g_unit[2].u_quotient.key_q ;
    (* hierconn *) wire [AW-1:0] \u_dut.g_unit[0].u_quotient.a_q ;
    (* hierconn *) wire [AW-1:0] \u_dut.g_unit[1].u_quotient.a_q ;
    (* hierconn *) wire [AW-1:0] \u_dut.g_unit[2].u_quotient.a_q ;
    wire [UNITS-1:0] full = {\u_dut.g_unit[2].u_quotient.full_q ,
                             \u_dut.g_unit[1].u_quotient.full_q ,
                             \u_dut.g_unit[0].u_quotient.full_q };
    localparam HW = TAG + KW + AW;
    wire [HW-1:0] hit_0 = {\u_dut.u_pool.g_unit[0].tag_q , \u_dut.g_unit[0].u_quotient.key_q ,
                           \u_dut.g_unit[0].u_quotient.a_q };
    wire [HW-1:0] hit_1 = {\u_dut.u_pool.g_unit[1].tag_q , \u_dut.g_unit[1].u_quotient.key_q ,
                           \u_dut.g_unit[1].u_quotient.a_q };
    wire [HW-1:0] hit_2 = {\u_dut.u_pool.g_unit[2].tag_q , \u_dut.g_unit[2].u_quotient.key_q ,
                           \u_dut.g_unit[2].u_quotient.a_q };

    // ---- model: how many are inside; of the marked one what it is, and in which unit ----
    reg             old_q = 1'b0, marked_q;
    reg [2:0]       count_q;
    reg [UNITS-1:0] unit_q;
    reg [TAG-1:0]   tag_q;
    reg [KW-1:0]    key_q;
    reg [AW-1:0]    a_q;
    wire take = in_valid && in_ready;
    wire give = out_valid && out_ready;
    wire mine = marked_q && \u_dut.u_pool.turn == unit_q;         // stands at the output
    always @(posedge clk) begin
        old_q   <= 1'b1;
        count_q <= count_q + {2'd0, take} - {2'd0, give};
        if (mine && give) marked_q <= 1'b0;
        if (take && pick && (!marked_q || (mine && give))) begin
            marked_q <= 1'b1;
            unit_q   <= \u_dut.take ;
            tag_q    <= in_tag;
            key_q    <= in_key;
            a_q      <= in_a;
        end
        if (rst) begin count_q <= 3'd0; marked_q <= 1'b0; end
    end
    always @* if (!old_q) assume (rst);

    always @* if (old_q) begin
        assert (count_q <= UNITS);
        assert (in_ready == (count_q != UNITS));           // a unit is free
        assert (out_valid == |\u_dut.done );
        if (out_valid) assert (count_q != 0);
        if (mine) assert (out_valid && out_tag == tag_q && out_mant == key_q[PQ-1:0] &&
                          out_exp == a_q[7:0]);
        // what is done leaves, or one of another unit does
        if (marked_q && (\u_dut.done & unit_q) != 0)
            assert (out_valid && \u_dut.u_pool.turn != 0);
        // invariant
        assert (count_q == {2'd0, full[0]} + {2'd0, full[1]} + {2'd0, full[2]});
        if (marked_q) begin
            assert (unit_q == 1 || unit_q == 2 || unit_q == 4);
            assert ((full & unit_q) != 0);
            assert ({tag_q, key_q, a_q} == (unit_q[0] ? hit_0 : unit_q[1] ? hit_1 : hit_2));
        end
    end
endmodule
`default_nettype wire
