// rt_facet_feed.v - the operands of a facet and its ray, and which of them the lanes get
// SPDX-License-Identifier: Apache-2.0
// Takes differences of corners and origin, keeps them and the vector of the moment (N, then m), and
// gives three pairs of factors for each operation. A long operand (det', num') goes to the three
// lanes in pieces; its partner stands in a register a clock ahead.
//   room: from org to one unit beyond the grid, along the longest axis of dir; size: |dir| along it
// Model: sph_facet_test() in cmodel/prim/facet.c, its operands
`timescale 1ns / 1ps
`default_nettype none
`include "rt_facet.vh"
module rt_facet_feed #(
    parameter W   = 16,                    // coordinate, bits
    parameter WD  = 17,                    // direction component, bits
    parameter NW  = 17,                    // narrow operand: the wider of W+1 and WD
    parameter CUT = 17,                    // piece of a long operand
    parameter CW  = 34,                    // component of N or m
    parameter AW  = 35,                    // wide operand
    parameter DW  = 50,                    // det'
    parameter MW  = 49,                    // num'
    parameter [3:0] P = 6                  // slot of the first dot product
) (
    input  wire              clk,
    // a facet is taken
    input  wire              take_i,
    input  wire              plane_i,
    input  wire [71:0]       v0_i,         // 3 x s24
    input  wire [71:0]       v1_i,
    input  wire [71:0]       v2_i,
    input  wire [3*W-1:0]    org_i,        // 3 x sW
    input  wire [3*WD-1:0]   dir_i,        // 3 x sWD
    input  wire [2*WD-1:0]   a_i,          // u(2WD)
    // where it is
    input  wire              step_i,       // this slot passes
    input  wire [3:0]        slot_i,
    input  wire [3:0]        op_i,
    input  wire              vector_i,     // the cross product is the vector from the next slot on
    input  wire              back_i,       // the facet ends: a is kept for its key
    input  wire              key_i,        // the key comes in the next slot
    // from the lanes
    input  wire [3*CW-1:0]   c_i,          // 3 x sCW
    input  wire [DW-1:0]     det_i,        // det'
    input  wire [MW-1:0]     num_i,        // num'
    output wire [AW-1:0]     w_o,          // in slot P room, u(W+1), then size, u(WD)
    // to the lanes
    output wire [3*AW-1:0]   a_o,          // 3 x sAW
    output wire [3*(CUT+1)-1:0] b_o        // 3 x s(CUT+1)
);
    localparam BW = CUT + 1;
    reg  [3*(W+1)-1:0] a0_q, e1_q, e2_q;   // 3 x s(W+1)
    reg  [3*W-1:0]     org_q;
    reg  [3*WD-1:0]    dir_q;
    reg  [2*WD-1:0]    a_q, back_a_q;
    always @(posedge clk) begin
        if (take_i) begin
            org_q <= org_i;
            dir_q <= dir_i;
            a_q   <= a_i;
        end
        if (back_i) back_a_q <= a_q;
    end
    function [NW-1:0] of_difference(input [W:0] v);
        of_difference = {{(NW-W){v[W]}}, v[W-1:0]};
    endfunction
    function [NW-1:0] of_direction(input [WD-1:0] v);
        of_direction = {{(NW-WD+1){v[WD-1]}}, v[WD-2:0]};
    endfunction

    // ---- partner of a long operand: a; room and size along the longest axis of dir ----
    function [WD-1:0] size_of(input [WD-1:0] v);
        size_of = (v ^ {WD{v[WD-1]}}) + {{(WD-1){1'b0}}, v[WD-1]};
    endfunction
    wire [WD-1:0] size_x = size_of(dir_q[0 +: WD]);
    wire [WD-1:0] size_y = size_of(dir_q[WD +: WD]);
    wire [WD-1:0] size_z = size_of(dir_q[2*WD +: WD]);
    wire          y_wins = size_y > size_x;
    reg           y_q, z_q;                // the longest axis
    reg  [AW-1:0] w_q;
    wire [W-1:0]  w_org  = z_q ? org_q[2*W +: W] : y_q ? org_q[W +: W] : org_q[0 +: W];
    wire          w_neg  = z_q ? dir_q[3*WD-1] : y_q ? dir_q[2*WD-1] : dir_q[WD-1];
    wire [WD-1:0] w_size = z_q ? size_z : y_q ? size_y : size_x;
    wire [W:0]    w_room = {1'b0, {!w_org[W-1], w_org[W-2:0]} ^ {W{!w_neg}}} + {{W{1'b0}}, 1'b1};
    always @(posedge clk) begin
        y_q <= y_wins;
        z_q <= size_z > (y_wins ? size_y : size_x);
        if (step_i) w_q <= key_i ? {{(AW-2*WD){1'b0}}, back_a_q}
                           : slot_i == P ? {{(AW-WD){1'b0}}, w_size} : {{(AW-W-1){1'b0}}, w_room};
    end
    assign w_o = w_q;

    // ---- lanes ----
    wire wide     = op_i == `RT_FACET_BDET || op_i == `RT_FACET_BNUM || op_i == `RT_FACET_KEY;
    wire cross_op = op_i == `RT_FACET_X0 || op_i == `RT_FACET_X1;
    wire [3*CUT-1:0] pieces = op_i == `RT_FACET_BDET ? {{(3*CUT-DW){1'b0}}, det_i}
                              : {{(3*CUT-MW){1'b0}}, num_i};
    genvar j;
    generate
        for (j = 0; j < 3; j = j + 1) begin : g_lane
            localparam Y = (j + 1) % 3, Z = (j + 2) % 3;
            // N, slots 0 and 1: e1 x e2; m, slots 2 and 3: dir x A0
            wire [W:0]    e1 = slot_i[0] ? e1_q[(W+1)*Y +: W+1] : e1_q[(W+1)*Z +: W+1];
            wire [WD-1:0] d  = slot_i[0] ? dir_q[WD*Y +: WD] : dir_q[WD*Z +: WD];
            wire [W:0]    e2 = slot_i[0] ? e2_q[(W+1)*Z +: W+1] : e2_q[(W+1)*Y +: W+1];
            wire [W:0]    a0 = slot_i[0] ? a0_q[(W+1)*Z +: W+1] : a0_q[(W+1)*Y +: W+1];
            wire [NW-1:0] x  = slot_i[1] ? of_direction(d) : of_difference(e1);
            wire [W:0]    y  = slot_i[1] ? a0 : e2;
            reg  [CW-1:0] v_q;                       // N, then m
            reg  [NW-1:0] b;
            always @*
                case (op_i)
                    `RT_FACET_DET: b = of_direction(dir_q[WD*j +: WD]);
                    `RT_FACET_NUM: b = of_difference(a0_q[(W+1)*j +: W+1]);
                    `RT_FACET_U2:  b = of_difference(e1_q[(W+1)*j +: W+1]);
                    `RT_FACET_U1:  b = of_difference(e2_q[(W+1)*j +: W+1]);
                    default:       b = of_difference(y);
                endcase
            assign a_o[AW*j +: AW] = wide ? w_q : cross_op ? {{(AW-NW){x[NW-1]}}, x}
                                     : {{(AW-CW){v_q[CW-1]}}, v_q};
            assign b_o[BW*j +: BW] = wide ? {1'b0, pieces[CUT*j +: CUT]}
                                     : {{(BW-NW){b[NW-1]}}, b};

            // differences as the facet comes
            wire signed [W-1:0] v0 = $signed(v0_i[24*j +: W]);
            wire signed [W-1:0] v1 = $signed(v1_i[24*j +: W]);
            wire signed [W-1:0] v2 = $signed(v2_i[24*j +: W]);
            wire signed [W-1:0] o  = $signed(org_i[W*j +: W]);
            always @(posedge clk) begin
                if (take_i) begin
                    a0_q[(W+1)*j +: W+1] <= $signed({v0[W-1], v0}) - $signed({o[W-1], o});
                    e1_q[(W+1)*j +: W+1] <= $signed({v1[W-1], v1}) - $signed({v0[W-1], v0});
                    e2_q[(W+1)*j +: W+1] <= $signed({v2[W-1], v2}) - $signed({v0[W-1], v0});
                end
                if (take_i && plane_i)
                    v_q <= {{(CW-23){v1_i[24*j+23]}}, v1_i[24*j +: 23]};
                else if (vector_i)
                    v_q <= c_i[CW*j +: CW];
            end
        end
    endgenerate
    wire unused = &{1'b0, v0_i, v1_i, v2_i};
endmodule
`default_nettype wire
