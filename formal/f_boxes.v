// f_boxes.v - proof that rt_boxes reads the boxes of a node as sph_box_read(), and joins its parts
// SPDX-License-Identifier: Apache-2.0
// A node comes in the first clock, beside a ray that memory holds, with any other nodes before and
// behind it. A clock later the four rt_box have its ray and its boxes, 9 clocks later its limit,
// and what they say in the next leaves as its result.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module f_boxes #(
    parameter W = 16
) (
    input wire         clk,
    input wire [3:0]   slot,
    input wire         read,
    input wire [255:0] node,
    input wire [14:0]  limit
);
    localparam WD = W + 1, SLOTS = 16, NG = 2;       // of the bundles
    localparam GW = `RT_BIH_G;
    localparam CW = W + 2;
    localparam PW = GW + 7;
    localparam X  = CW + 8;                          // bits of the model's words
    wire [3:0]  pass;
    wire [63:0] near;
    wire        order;
    rt_boxes #(.W(W), .WD(WD), .SLOTS(SLOTS)) u_dut (
        .clk(clk), .rst(1'b0), .ray_i({`RT_RAY_BITS{1'b0}}), .pixel_i(1'b0), .shadow_go_i(1'b0),
        .shadow_slot_i(4'd0), .start_ready_i(1'b0), .read_i(read), .slot_i(slot), .node_i(node),
        .limit_i(limit), .pass_o(pass), .near_o(near), .order_o(order)
    );
    (* hierconn *) wire [3*CW-1:0] \u_dut.t1_places ;
    (* hierconn *) wire [3*PW-1:0] \u_dut.t1_paces ;
    (* hierconn *) wire            \u_dut.g_order.t1_order ;
    reg [3:0]      age_q = 4'd0;
    reg [255:0]    node_q;
    reg [14:0]     limit_q;
    reg [3*CW-1:0] places_q;
    reg [3*PW-1:0] paces_q;
    reg            order_q;
    always @(posedge clk) begin
        if (age_q != 15) age_q <= age_q + 1'b1;
        if (age_q == 0) begin
            {node_q, limit_q, order_q} <= {node, limit, \u_dut.g_order.t1_order };
            {places_q, paces_q} <= {\u_dut.t1_places , \u_dut.t1_paces };
        end
    end
    // ---- what the four rt_box have, and say ----
    (* hierconn *) wire [3*CW-1:0] \u_dut.g_child[0].u_box.in_places_i ,
        \u_dut.g_child[1].u_box.in_places_i ,
        \u_dut.g_child[2].u_box.in_places_i , \u_dut.g_child[3].u_box.in_places_i ;
    (* hierconn *) wire [3*PW-1:0] \u_dut.g_child[0].u_box.in_paces_i ,
        \u_dut.g_child[1].u_box.in_paces_i ,
        \u_dut.g_child[2].u_box.in_paces_i , \u_dut.g_child[3].u_box.in_paces_i ;
    (* hierconn *) wire [3*CW-1:0] \u_dut.g_child[0].u_box.in_lo_i ,
        \u_dut.g_child[1].u_box.in_lo_i ,
        \u_dut.g_child[2].u_box.in_lo_i , \u_dut.g_child[3].u_box.in_lo_i ;
    (* hierconn *) wire [3*CW-1:0] \u_dut.g_child[0].u_box.in_hi_i ,
        \u_dut.g_child[1].u_box.in_hi_i ,
        \u_dut.g_child[2].u_box.in_hi_i , \u_dut.g_child[3].u_box.in_hi_i ;
    (* hierconn *) wire [14:0] \u_dut.g_child[0].u_box.in_limit_i ,
        \u_dut.g_child[1].u_box.in_limit_i ,
        \u_dut.g_child[2].u_box.in_limit_i , \u_dut.g_child[3].u_box.in_limit_i ;
    (* hierconn *) wire [14:0] \u_dut.g_child[0].u_box.out_near_o ,
        \u_dut.g_child[1].u_box.out_near_o ,
        \u_dut.g_child[2].u_box.out_near_o , \u_dut.g_child[3].u_box.out_near_o ;
    (* hierconn *) wire \u_dut.g_child[0].u_box.out_pass_o , \u_dut.g_child[1].u_box.out_pass_o ,
        \u_dut.g_child[2].u_box.out_pass_o , \u_dut.g_child[3].u_box.out_pass_o ;
    wire [4*3*CW-1:0] in_places =
        {\u_dut.g_child[3].u_box.in_places_i , \u_dut.g_child[2].u_box.in_places_i ,
         \u_dut.g_child[1].u_box.in_places_i , \u_dut.g_child[0].u_box.in_places_i };
    wire [4*3*PW-1:0] in_paces =
        {\u_dut.g_child[3].u_box.in_paces_i , \u_dut.g_child[2].u_box.in_paces_i ,
         \u_dut.g_child[1].u_box.in_paces_i , \u_dut.g_child[0].u_box.in_paces_i };
    wire [4*3*CW-1:0] in_lo =
        {\u_dut.g_child[3].u_box.in_lo_i , \u_dut.g_child[2].u_box.in_lo_i ,
         \u_dut.g_child[1].u_box.in_lo_i , \u_dut.g_child[0].u_box.in_lo_i };
    wire [4*3*CW-1:0] in_hi =
        {\u_dut.g_child[3].u_box.in_hi_i , \u_dut.g_child[2].u_box.in_hi_i ,
         \u_dut.g_child[1].u_box.in_hi_i , \u_dut.g_child[0].u_box.in_hi_i };
    wire [59:0] in_limit =
        {\u_dut.g_child[3].u_box.in_limit_i , \u_dut.g_child[2].u_box.in_limit_i ,
         \u_dut.g_child[1].u_box.in_limit_i , \u_dut.g_child[0].u_box.in_limit_i };
    wire [59:0] said_near =
        {\u_dut.g_child[3].u_box.out_near_o , \u_dut.g_child[2].u_box.out_near_o ,
         \u_dut.g_child[1].u_box.out_near_o , \u_dut.g_child[0].u_box.out_near_o };
    wire [3:0] said_pass =
        {\u_dut.g_child[3].u_box.out_pass_o , \u_dut.g_child[2].u_box.out_pass_o ,
         \u_dut.g_child[1].u_box.out_pass_o , \u_dut.g_child[0].u_box.out_pass_o };

    // ---- sph_box_read(): coordinates that leave W+2 bits lose what is above ----
    localparam ORG_SHIFT  = W > 14 ? W - 14 : 0;     // sph_frame_org_shift()
    localparam STEP_SHIFT = W > 22 ? W - 22 : 0;     // sph_frame_step_shift()
    wire [12*CW-1:0] lo, hi;
    genvar c, i;
    generate
        for (c = 0; c < 4; c = c + 1) begin : g_box
            for (i = 0; i < 3; i = i + 1) begin : g_axis
                wire signed [13:0]  org  = node_q[168 + 14*i +: 14];
                wire signed [X-1:0] from = {{CW{org[13]}}, org} << ORG_SHIFT;
                wire [X-1:0] low  = node_q[42*c + 7*i +: 7], high = node_q[42*c + 21 + 7*i +: 7];
                wire [3:0]   step = node_q[210 + 4*i +: 4];
                wire [X-1:0] lo_all = low << step << STEP_SHIFT;
                wire [X-1:0] hi_all = (high + 1'b1) << step << STEP_SHIFT;
                assign lo[CW*(3*c+i) +: CW] = from[CW-1:0] + lo_all[CW-1:0];
                assign hi[CW*(3*c+i) +: CW] = from[CW-1:0] + hi_all[CW-1:0];
            end
        end
    endgenerate
    reg has_q;                                       // in the second clock
    always @(posedge clk)
        if (age_q == 1)
            has_q <= in_lo == lo && in_hi == hi && in_places == {4{places_q}} &&
                     in_paces == {4{paces_q}};
    always @* begin
        if (age_q == 9) assert (has_q && in_limit == {4{limit_q}});
        if (age_q == 10) begin
            assert (has_q && pass == said_pass && order == order_q);
            assert (near == {1'b0, said_near[59:45], 1'b0, said_near[44:30],
                             1'b0, said_near[29:15], 1'b0, said_near[14:0]});
        end
    end
endmodule
`default_nettype wire
