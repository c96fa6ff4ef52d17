// f_boxes.v - proof that rt_boxes gives rt_box_axis and rt_box what sph_visit() gives their model
// SPDX-License-Identifier: Apache-2.0
// A node comes in the first clock, beside a ray that memory holds, with any other nodes before and
// behind it. At once the three rt_box_axis have its ray and its frame; the four rt_box have its
// planes and what these say of a step 7 clocks later, the rest of it in the next, the limit in the
// thirteenth; what they say behind that leaves as its result.
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
    localparam CW = W + 2, PW = `RT_BIH_G + 7, XW = `RT_BOX_CROSS, SW = XW + 9;
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
    // ---- the axes: what they have, and say ----
    (* hierconn *) wire [13:0] \u_dut.g_axis[0].u_axis.in_org_i ,
        \u_dut.g_axis[1].u_axis.in_org_i , \u_dut.g_axis[2].u_axis.in_org_i ;
    (* hierconn *) wire [3:0] \u_dut.g_axis[0].u_axis.in_step_i ,
        \u_dut.g_axis[1].u_axis.in_step_i , \u_dut.g_axis[2].u_axis.in_step_i ;
    (* hierconn *) wire [CW-1:0] \u_dut.g_axis[0].u_axis.in_place_i ,
        \u_dut.g_axis[1].u_axis.in_place_i , \u_dut.g_axis[2].u_axis.in_place_i ;
    (* hierconn *) wire [PW-1:0] \u_dut.g_axis[0].u_axis.in_pace_i ,
        \u_dut.g_axis[1].u_axis.in_pace_i , \u_dut.g_axis[2].u_axis.in_pace_i ;
    (* hierconn *) wire [SW-1:0] \u_dut.g_axis[0].u_axis.out_enter_o ,
        \u_dut.g_axis[1].u_axis.out_enter_o , \u_dut.g_axis[2].u_axis.out_enter_o ;
    (* hierconn *) wire [SW-1:0] \u_dut.g_axis[0].u_axis.out_leave_o ,
        \u_dut.g_axis[1].u_axis.out_leave_o , \u_dut.g_axis[2].u_axis.out_leave_o ;
    (* hierconn *) wire \u_dut.g_axis[0].u_axis.out_fine_o ,
        \u_dut.g_axis[1].u_axis.out_fine_o , \u_dut.g_axis[2].u_axis.out_fine_o ;
    (* hierconn *) wire \u_dut.g_axis[0].u_axis.out_flat_o ,
        \u_dut.g_axis[1].u_axis.out_flat_o , \u_dut.g_axis[2].u_axis.out_flat_o ;
    (* hierconn *) wire \u_dut.g_axis[0].u_axis.out_open_o ,
        \u_dut.g_axis[1].u_axis.out_open_o , \u_dut.g_axis[2].u_axis.out_open_o ;
    (* hierconn *) wire [XW-1:0] \u_dut.g_axis[0].u_axis.step_o ,
        \u_dut.g_axis[1].u_axis.step_o , \u_dut.g_axis[2].u_axis.step_o ;
    (* hierconn *) wire [XW:0] \u_dut.g_axis[0].u_axis.more_o ,
        \u_dut.g_axis[1].u_axis.more_o , \u_dut.g_axis[2].u_axis.more_o ;
    (* hierconn *) wire \u_dut.g_axis[0].u_axis.back_o ,
        \u_dut.g_axis[1].u_axis.back_o , \u_dut.g_axis[2].u_axis.back_o ;
    // ---- the children ----
    (* hierconn *) wire [20:0] \u_dut.g_child[0].u_box.in_near_i ,
        \u_dut.g_child[1].u_box.in_near_i ,
        \u_dut.g_child[2].u_box.in_near_i , \u_dut.g_child[3].u_box.in_near_i ;
    (* hierconn *) wire [20:0] \u_dut.g_child[0].u_box.in_far_i ,
        \u_dut.g_child[1].u_box.in_far_i ,
        \u_dut.g_child[2].u_box.in_far_i , \u_dut.g_child[3].u_box.in_far_i ;
    (* hierconn *) wire [3*XW-1:0] \u_dut.g_child[0].u_box.in_step_i ,
        \u_dut.g_child[1].u_box.in_step_i ,
        \u_dut.g_child[2].u_box.in_step_i , \u_dut.g_child[3].u_box.in_step_i ;
    (* hierconn *) wire [3*XW+2:0] \u_dut.g_child[0].u_box.in_more_i ,
        \u_dut.g_child[1].u_box.in_more_i ,
        \u_dut.g_child[2].u_box.in_more_i , \u_dut.g_child[3].u_box.in_more_i ;
    (* hierconn *) wire [3*SW-1:0] \u_dut.g_child[0].u_box.late_enter_i ,
        \u_dut.g_child[1].u_box.late_enter_i ,
        \u_dut.g_child[2].u_box.late_enter_i , \u_dut.g_child[3].u_box.late_enter_i ;
    (* hierconn *) wire [3*SW-1:0] \u_dut.g_child[0].u_box.late_leave_i ,
        \u_dut.g_child[1].u_box.late_leave_i ,
        \u_dut.g_child[2].u_box.late_leave_i , \u_dut.g_child[3].u_box.late_leave_i ;
    (* hierconn *) wire [2:0] \u_dut.g_child[0].u_box.late_fine_i ,
        \u_dut.g_child[1].u_box.late_fine_i ,
        \u_dut.g_child[2].u_box.late_fine_i , \u_dut.g_child[3].u_box.late_fine_i ;
    (* hierconn *) wire [2:0] \u_dut.g_child[0].u_box.late_flat_i ,
        \u_dut.g_child[1].u_box.late_flat_i ,
        \u_dut.g_child[2].u_box.late_flat_i , \u_dut.g_child[3].u_box.late_flat_i ;
    (* hierconn *) wire [2:0] \u_dut.g_child[0].u_box.late_open_i ,
        \u_dut.g_child[1].u_box.late_open_i ,
        \u_dut.g_child[2].u_box.late_open_i , \u_dut.g_child[3].u_box.late_open_i ;
    (* hierconn *) wire [14:0] \u_dut.g_child[0].u_box.in_limit_i ,
        \u_dut.g_child[1].u_box.in_limit_i ,
        \u_dut.g_child[2].u_box.in_limit_i , \u_dut.g_child[3].u_box.in_limit_i ;
    (* hierconn *) wire [14:0] \u_dut.g_child[0].u_box.out_near_o ,
        \u_dut.g_child[1].u_box.out_near_o ,
        \u_dut.g_child[2].u_box.out_near_o , \u_dut.g_child[3].u_box.out_near_o ;
    (* hierconn *) wire \u_dut.g_child[0].u_box.out_pass_o ,
        \u_dut.g_child[1].u_box.out_pass_o ,
        \u_dut.g_child[2].u_box.out_pass_o , \u_dut.g_child[3].u_box.out_pass_o ;

    // ---- a node, its ray and what is said of them, kept ----
    reg [3:0]      age_q = 4'd0;
    reg [255:0]    node_q;
    reg [14:0]     limit_q;
    reg            order_q;
    reg [2:0]      back_q;
    reg            begins_q, has_q, ends_q, limit_is_q;          // only the last clock asserts
    wire [41:0]    orgs = {\u_dut.g_axis[2].u_axis.in_org_i , \u_dut.g_axis[1].u_axis.in_org_i ,
            \u_dut.g_axis[0].u_axis.in_org_i };
    wire [11:0]    steps = {\u_dut.g_axis[2].u_axis.in_step_i , \u_dut.g_axis[1].u_axis.in_step_i ,
            \u_dut.g_axis[0].u_axis.in_step_i };
    wire           begins = orgs == node[209:168] && steps == node[221:210] &&
        {\u_dut.g_axis[2].u_axis.in_place_i , \u_dut.g_axis[1].u_axis.in_place_i ,
            \u_dut.g_axis[0].u_axis.in_place_i } == \u_dut.t1_places  &&
        {\u_dut.g_axis[2].u_axis.in_pace_i , \u_dut.g_axis[1].u_axis.in_pace_i ,
            \u_dut.g_axis[0].u_axis.in_pace_i } == \u_dut.t1_paces ;
    wire [83:0]    near_codes, far_codes;
    genvar c, i;
    generate
        for (c = 0; c < 4; c = c + 1) begin : g_box
            for (i = 0; i < 3; i = i + 1) begin : g_axis
                wire [6:0] low = node_q[42*c + 7*i +: 7], high = node_q[42*c + 21 + 7*i +: 7];
                assign near_codes[21*c + 7*i +: 7] = back_q[i] ? 127 - high : low;
                assign far_codes[21*c + 7*i +: 7] = back_q[i] ? 127 - low : high;
            end
        end
    endgenerate
    wire           has = near_codes ==
            {\u_dut.g_child[3].u_box.in_near_i , \u_dut.g_child[2].u_box.in_near_i ,
            \u_dut.g_child[1].u_box.in_near_i , \u_dut.g_child[0].u_box.in_near_i } &&
        far_codes == {\u_dut.g_child[3].u_box.in_far_i , \u_dut.g_child[2].u_box.in_far_i ,
            \u_dut.g_child[1].u_box.in_far_i , \u_dut.g_child[0].u_box.in_far_i } &&
        {4{{\u_dut.g_axis[2].u_axis.step_o , \u_dut.g_axis[1].u_axis.step_o ,
            \u_dut.g_axis[0].u_axis.step_o }}} ==
            {\u_dut.g_child[3].u_box.in_step_i , \u_dut.g_child[2].u_box.in_step_i ,
            \u_dut.g_child[1].u_box.in_step_i , \u_dut.g_child[0].u_box.in_step_i } &&
        {4{{\u_dut.g_axis[2].u_axis.more_o , \u_dut.g_axis[1].u_axis.more_o ,
            \u_dut.g_axis[0].u_axis.more_o }}} ==
            {\u_dut.g_child[3].u_box.in_more_i , \u_dut.g_child[2].u_box.in_more_i ,
            \u_dut.g_child[1].u_box.in_more_i , \u_dut.g_child[0].u_box.in_more_i };
    wire           late =
        {4{{\u_dut.g_axis[2].u_axis.out_enter_o , \u_dut.g_axis[1].u_axis.out_enter_o ,
            \u_dut.g_axis[0].u_axis.out_enter_o }}} ==
            {\u_dut.g_child[3].u_box.late_enter_i , \u_dut.g_child[2].u_box.late_enter_i ,
            \u_dut.g_child[1].u_box.late_enter_i , \u_dut.g_child[0].u_box.late_enter_i } &&
        {4{{\u_dut.g_axis[2].u_axis.out_leave_o , \u_dut.g_axis[1].u_axis.out_leave_o ,
            \u_dut.g_axis[0].u_axis.out_leave_o }}} ==
            {\u_dut.g_child[3].u_box.late_leave_i , \u_dut.g_child[2].u_box.late_leave_i ,
            \u_dut.g_child[1].u_box.late_leave_i , \u_dut.g_child[0].u_box.late_leave_i } &&
        {4{{\u_dut.g_axis[2].u_axis.out_fine_o , \u_dut.g_axis[1].u_axis.out_fine_o ,
            \u_dut.g_axis[0].u_axis.out_fine_o }}} ==
            {\u_dut.g_child[3].u_box.late_fine_i , \u_dut.g_child[2].u_box.late_fine_i ,
            \u_dut.g_child[1].u_box.late_fine_i , \u_dut.g_child[0].u_box.late_fine_i } &&
        {4{{\u_dut.g_axis[2].u_axis.out_flat_o , \u_dut.g_axis[1].u_axis.out_flat_o ,
            \u_dut.g_axis[0].u_axis.out_flat_o }}} ==
            {\u_dut.g_child[3].u_box.late_flat_i , \u_dut.g_child[2].u_box.late_flat_i ,
            \u_dut.g_child[1].u_box.late_flat_i , \u_dut.g_child[0].u_box.late_flat_i } &&
        {4{{\u_dut.g_axis[2].u_axis.out_open_o , \u_dut.g_axis[1].u_axis.out_open_o ,
            \u_dut.g_axis[0].u_axis.out_open_o }}} ==
            {\u_dut.g_child[3].u_box.late_open_i , \u_dut.g_child[2].u_box.late_open_i ,
            \u_dut.g_child[1].u_box.late_open_i , \u_dut.g_child[0].u_box.late_open_i };
    always @(posedge clk) begin
        if (age_q != 15) age_q <= age_q + 1'b1;
        if (age_q == 0) begin
            {node_q, limit_q, order_q} <= {node, limit, \u_dut.g_order.t1_order };
            begins_q <= begins;
        end
        if (age_q == 6) back_q <= {\u_dut.g_axis[2].u_axis.back_o , \u_dut.g_axis[1].u_axis.back_o ,
            \u_dut.g_axis[0].u_axis.back_o };
        if (age_q == 7) has_q <= has;
        if (age_q == 8) ends_q <= late;
        if (age_q == 12) limit_is_q <= {4{limit_q}} ==
            {\u_dut.g_child[3].u_box.in_limit_i , \u_dut.g_child[2].u_box.in_limit_i ,
            \u_dut.g_child[1].u_box.in_limit_i , \u_dut.g_child[0].u_box.in_limit_i };
    end
    wire [59:0]    said = {\u_dut.g_child[3].u_box.out_near_o , \u_dut.g_child[2].u_box.out_near_o ,
            \u_dut.g_child[1].u_box.out_near_o , \u_dut.g_child[0].u_box.out_near_o };
    always @* begin
        if (age_q == 13) begin
            assert (begins_q && has_q && ends_q && limit_is_q && order == order_q);
            assert (pass ==
            {\u_dut.g_child[3].u_box.out_pass_o , \u_dut.g_child[2].u_box.out_pass_o ,
            \u_dut.g_child[1].u_box.out_pass_o , \u_dut.g_child[0].u_box.out_pass_o });
            assert (near == {1'b0, said[59:45], 1'b0, said[44:30], 1'b0, said[29:15],
                             1'b0, said[14:0]});
        end
    end
endmodule
`default_nettype wire
