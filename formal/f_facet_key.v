// f_facet_key.v - proof that rt_facet_key divides as end(), sph_facet_key() do, at its real widths
// SPDX-License-Identifier: Apache-2.0
// A hit is taken in the first clock, with any hit or none in the dividers, and others behind it.
// Products are known by their factors, quotients by their operands, and come at any time. If the
// hit's result is there within T clocks, it has its own tag and is made of its own quotients; the
// register behind keeps it.
`timescale 1ns / 1ps
`default_nettype none
module f_facet_key #(
    parameter W      = 16,
    parameter WD     = 17,
    parameter DW     = 50,
    parameter MW     = 49,
    parameter T      = 30
) (
    input wire            clk,
    input wire            in_valid,
    input wire [3:0]      tag,
    input wire            plane,
    input wire [DW-1:0]   det,
    input wire [MW-1:0]   num,
    input wire [2*WD-1:0] a,
    input wire [W:0]      room,
    input wire [WD-1:0]   size,
    input wire            out_ready
);
    localparam QW = W + WD + 1;
    localparam LW = DW > MW ? DW : MW;
    localparam NW = W + 1 > WD ? W + 1 : WD;
    localparam PW = LW + 2*WD, XW = DW + QW, RW = MW + WD;
    wire in_ready, out_valid;
    wire [3:0]    out_tag;
    wire [W+WD+1:0] out_key;
    rt_facet_key #(.W(W), .WD(WD), .TAG(4), .DW(DW), .MW(MW)) u_dut (
        .clk(clk), .rst(1'b0), .in_valid_i(in_valid), .in_ready_o(in_ready), .in_tag_i(tag),
        .in_plane_i(plane), .in_det_i(det), .in_num_i(num), .in_a_i(a), .in_room_i(room),
        .in_size_i(size), .out_valid_o(out_valid), .out_ready_i(out_ready), .out_tag_o(out_tag),
        .out_key_o(out_key)
    );
    (* hierconn *) wire       \u_dut.k_past_q , \u_dut.k_ready ;
    (* hierconn *) wire [3:0] \u_dut.k_tag_q ;
    (* hierconn *) wire [QW:0] \u_dut.k_key ;
    (* hierconn *) wire       \u_dut.u_product.busy_q  ;
    (* hierconn *) wire [1:0] \u_dut.u_product.come_q ;
    (* hierconn *) wire       \u_dut.u_divide.full_q ;
    (* hierconn *) wire [XW+DW-1:0] \u_dut.u_divide.all_q ;
    (* hierconn *) wire [QW:0] \u_dut.u_divide.key_q ;
    (* hierconn *) wire       \u_dut.g_rank.u_rank.full_q ;
    (* hierconn *) wire [RW+MW-1:0] \u_dut.g_rank.u_rank.all_q ;
    (* hierconn *) wire [WD:0] \u_dut.g_rank.u_rank.key_q ;
    (* hierconn *) wire       \u_dut.g_rank.u_rank.done_q ;
    (* hierconn *) wire       \u_dut.g_rank.ranked_q ;
    (* hierconn *) wire [WD-1:0] \u_dut.g_rank.add_q , \u_dut.g_rank.from_q ;
    // a rank that is there is that of the divider's
    wire [WD-1:0] rank = \u_dut.g_rank.from_q - \u_dut.g_rank.u_rank.key_q ;
    wire sane = !\u_dut.g_rank.ranked_q || (\u_dut.g_rank.u_rank.full_q &&
                \u_dut.g_rank.u_rank.done_q && \u_dut.g_rank.add_q == rank);
    // what the divider has is what the ranks have
    wire idle = in_ready && !\u_dut.u_product.busy_q && \u_dut.u_product.come_q == 0;
    wire even = \u_dut.g_rank.u_rank.full_q == (\u_dut.u_divide.full_q && \u_dut.k_past_q );

    // ---- end(), sph_facet_key() ----
    reg            plane_q;
    reg [3:0]      tag_q;
    reg [DW-1:0]   det_q;
    reg [MW-1:0]   num_q;
    reg [2*WD-1:0] a_q;
    reg [W:0]      room_q;
    reg [WD-1:0]   size_q;
    wire [LW-1:0]    det_l = det_q, num_l = num_q, room_l = room_q;
    wire [NW-1:0]    room_n = room_q, size_n = size_q;
    wire [LW+NW-1:0] face = {det_l, room_n}, next = {num_l, size_n};
    wire             past = plane_q && next > face;
    wire [XW+PW-1:0] scaled = {past ? room_l : num_l, a_q};
    wire [RW+LW+NW-1:0] faced = face;
    wire [DW-1:0]    by = past ? size_q : det_q;
    wire [WD-1:0]    add = size_q - \u_dut.g_rank.u_rank.key_q ;
    wire [QW:0]      key = \u_dut.u_divide.key_q + (past ? add : {WD{1'b0}});
    wire             own = \u_dut.u_divide.all_q == {scaled[XW-1:0], by} &&
                           (!past || \u_dut.g_rank.u_rank.all_q == {faced[RW-1:0], num_q});

    reg [5:0] age_q = 6'd0;
    reg       before_q, mine_q, good_q = 1'b1;       // a hit before it; it is inside
    wire      leaves = \u_dut.k_ready ;
    reg       kept_q = 1'b0;                         // what the register must have
    reg [QW+4:0] word_q;
    always @(posedge clk) begin
        if (age_q != 63) age_q <= age_q + 1'b1;
        kept_q <= leaves || (out_valid && !out_ready);
        word_q <= leaves ? {\u_dut.k_tag_q , \u_dut.k_key } : {out_tag, out_key};
        if (kept_q && !(out_valid && {out_tag, out_key} == word_q)) good_q <= 1'b0;
        if (age_q == 0) begin
            {plane_q, tag_q, det_q, num_q, a_q, room_q, size_q} <=
                {plane, tag, det, num, a, room, size};
            before_q <= \u_dut.u_divide.full_q && !leaves;
            mine_q   <= 1'b1;
        end else begin
            if (leaves) before_q <= 1'b0;
            if (leaves && !before_q) mine_q <= 1'b0;
            if (leaves && !before_q && mine_q &&
                !(own && \u_dut.k_tag_q == tag_q && \u_dut.k_key == key))
                good_q <= 1'b0;
            if ((idle && !in_valid && !even) || !sane) good_q <= 1'b0;
            if (mine_q && in_valid && in_ready && !\u_dut.u_divide.full_q ) good_q <= 1'b0;
        end
    end
    always @* begin
        if (age_q == 0) assume (in_valid && idle && even && sane);
        if (age_q == T) assert (good_q);
    end
endmodule
`default_nettype wire
