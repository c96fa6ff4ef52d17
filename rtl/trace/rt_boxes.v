// rt_boxes.v - rays set up for planes, and the boxes of a node's four children against one of them
// SPDX-License-Identifier: Apache-2.0
// Stands in rt_traverse where rt_filter stands for spheres (BOXES of rt_core).
// Shifts are those of a frame, once an axis; a plane of a child is a product and a sum.
//   1 node beside its ray | 2..9 frame: rt_box_axis, three | 9..14 four times rt_box
// `RT_BOXES_LATENCY clocks from node to result, a node a clock.
// Model: sph_box_axes(), sph_box_meets() in cmodel/trace/bih.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
`include "rt_latency.vh"
module rt_boxes #(
    parameter W     = 16,   // coordinate, bits
    parameter WD    = 17,   // direction component, bits
    parameter SLOTS = 32,   // power of two
    parameter SHADOW = 1    // 1: shadow rays
) (
    input  wire                     clk,
    input  wire                     rst,
    // from rt_setup: a new ray, with its token unless it is a shadow ray
    input  wire [`RT_RAY_BITS-1:0]  ray_i,
    //: {SLOT[SLOTW], H[6], Y[17], UNIT[54], INSIDE, SKIP[24], A[2*WD], DIR[3*WD], ORG[3*W], SHADOW,
    //: PRIMARY, LIGHT, NORMAL, VALID}
    input  wire                     pixel_i,       // the pixel's visits start at 0
    // from rt_shade: a shadow ray starts
    input  wire                     shadow_go_i,
    input  wire [$clog2(SLOTS)-1:0] shadow_slot_i,
    // token: the ray may visit the root
    output wire                     start_valid_o,
    input  wire                     start_ready_i,
    output wire [$clog2(SLOTS)-1:0] start_slot_o,
    output wire                     start_pixel_o,
    // a node, a clock after its slot; the limit of its ray with the node
    input  wire                     read_i,
    input  wire [$clog2(SLOTS)-1:0] slot_i,
    input  wire [255:0]             node_i,
    input  wire [14:0]              limit_i,
    // children that the ray meets, and how deep
    output wire [3:0]               pass_o,
    output wire [63:0]              near_o,        // 4 x s16
    output wire                     order_o        // any hit ends the ray: children as they stand
);
    localparam SLOTW = $clog2(SLOTS);
    localparam GW = `RT_BIH_G;
    localparam CW = W + 2;                          // coordinate of a plane
    localparam PW = GW + 7;                         // pace
    localparam XW = `RT_BOX_CROSS;
    localparam SW = XW + 9;                         // T-words of a frame

    // ---- rays ----
    wire             place_valid, pace_valid;
    wire [SLOTW-1:0] place_slot, pace_slot;
    wire [1:0]       place_axis, pace_axis;
    wire [CW-1:0]    place;
    wire [PW-1:0]    pace;
    rt_bih_ray #(.W(W), .WD(WD), .SLOTS(SLOTS), .SHADOW(SHADOW)) u_rays (
        .clk(clk), .rst(rst),
        .new_valid_i(ray_i[`RT_RAY_VALID]), .new_slot_i(ray_i[`RT_RAY_SLOT]),
        .new_org_i(ray_i[`RT_RAY_ORG]), .new_dir_i(ray_i[`RT_RAY_DIR]),
        .new_a_i(ray_i[`RT_RAY_A]),
        .go_valid_i(ray_i[`RT_RAY_VALID] && !ray_i[`RT_RAY_SHADOW]),
        .go_slot_i(ray_i[`RT_RAY_SLOT]), .go_pixel_i(pixel_i),
        .shadow_go_i(shadow_go_i), .shadow_slot_i(shadow_slot_i),
        .place_valid_o(place_valid), .place_slot_o(place_slot), .place_axis_o(place_axis),
        .place_o(place),
        .pace_valid_o(pace_valid), .pace_slot_o(pace_slot), .pace_axis_o(pace_axis),
        .pace_o(pace),
        .start_valid_o(start_valid_o), .start_ready_i(start_ready_i),
        .start_slot_o(start_slot_o), .start_pixel_o(start_pixel_o)
    );
    wire [3*CW-1:0]  t1_places;
    wire [3*PW-1:0]  t1_paces;
    genvar k, c;
    generate
        for (k = 0; k < 3; k = k + 1) begin : g_ray
            rt_slot_ram #(.WIDTH(CW), .SLOTS(SLOTS), .OLD(0)) u_place (
                .clk(clk), .wr_en_i(place_valid && place_axis == k[1:0]), .wr_addr_i(place_slot),
                .wr_data_i(place),
                .rd_en_i(read_i), .rd_addr_i(slot_i), .rd_data_o(t1_places[CW*k +: CW])
            );
            rt_slot_ram #(.WIDTH(PW), .SLOTS(SLOTS), .OLD(0)) u_pace (
                .clk(clk), .wr_en_i(pace_valid && pace_axis == k[1:0]), .wr_addr_i(pace_slot),
                .wr_data_i(pace),
                .rd_en_i(read_i), .rd_addr_i(slot_i), .rd_data_o(t1_paces[PW*k +: PW])
            );
        end
        if (SHADOW != 0) begin : g_order
            wire t1_order;
            rt_slot_ram #(.WIDTH(1), .SLOTS(SLOTS), .OLD(0)) u_order (
                .clk(clk), .wr_en_i(ray_i[`RT_RAY_VALID]), .wr_addr_i(ray_i[`RT_RAY_SLOT]),
                .wr_data_i(ray_i[`RT_RAY_SHADOW]),
                .rd_en_i(read_i), .rd_addr_i(slot_i), .rd_data_o(t1_order)
            );
            rt_delay #(.WIDTH(1), .CYCLES(`RT_BOXES_LATENCY)) u_order_side (
                .clk(clk), .in_i(t1_order), .out_o(order_o)
            );
        end else begin : g_nearest
            assign order_o = 1'b0;
        end
    endgenerate
    wire [14:0]      limit;
    rt_delay #(.WIDTH(15), .CYCLES(`RT_BOXES_LATENCY-1)) u_limit (
        .clk(clk), .in_i(limit_i), .out_o(limit)
    );

    // ---- the frame along the ray ----
    wire [3*SW-1:0]  enter, leave;
    wire [2:0]       back, fine, flat, open;
    wire [3*XW-1:0]  step;
    wire [3*XW+2:0]  more;
    generate
        for (k = 0; k < 3; k = k + 1) begin : g_axis
            rt_box_axis #(.W(W)) u_axis (
                .clk(clk),
                .in_org_i(node_i[`RT_FRAME_ORG_X_LSB + 14*k +: 14]),
                .in_step_i(node_i[`RT_FRAME_STEP_X_LSB + 4*k +: 4]),
                .in_place_i(t1_places[CW*k +: CW]), .in_pace_i(t1_paces[PW*k +: PW]),
                .out_enter_o(enter[SW*k +: SW]), .out_leave_o(leave[SW*k +: SW]),
                .out_fine_o(fine[k]), .out_flat_o(flat[k]), .out_open_o(open[k]),
                .step_o(step[XW*k +: XW]), .more_o(more[(XW+1)*k +: XW+1]), .back_o(back[k])
            );
        end
    endgenerate

    // ---- planes, counted from where the ray comes from ----
    localparam BW = 4*`RT_BOX_STRIDE;
    wire [BW-1:0]    t7_boxes;
    rt_delay #(.WIDTH(BW), .CYCLES(6)) u_boxes (
        .clk(clk), .in_i(node_i[BW-1:0]), .out_o(t7_boxes)
    );
    generate
        for (c = 0; c < 4; c = c + 1) begin : g_child
            wire [`RT_BOX_STRIDE-1:0] box = t7_boxes[`RT_BOX_STRIDE*c +: `RT_BOX_STRIDE];
            reg [20:0] t8_near_q, t8_far_q;
            for (k = 0; k < 3; k = k + 1) begin : g_axis
                wire [6:0] low  = box[`RT_BOX_LO_X_LSB + 7*k +: 7];
                wire [6:0] high = box[`RT_BOX_HI_X_LSB + 7*k +: 7];
                always @(posedge clk) begin
                    t8_near_q[7*k +: 7] <= back[k] ? ~high : low;
                    t8_far_q[7*k +: 7]  <= back[k] ? ~low : high;
                end
            end
            rt_box u_box (
                .clk(clk), .in_near_i(t8_near_q), .in_far_i(t8_far_q),
                .in_step_i(step), .in_more_i(more), .late_enter_i(enter), .late_leave_i(leave),
                .late_fine_i(fine), .late_flat_i(flat), .late_open_i(open), .in_limit_i(limit),
                .out_pass_o(pass_o[c]), .out_near_o(near_o[16*c +: 15])
            );
            assign near_o[16*c + 15] = 1'b0;
        end
    endgenerate
    wire unused = &{1'b0, node_i[255:222], ray_i};
endmodule
`default_nettype wire
