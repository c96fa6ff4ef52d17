// f_facet.v - proof that rt_facet decides as sph_facet_test(), at its real widths
// SPDX-License-Identifier: Apache-2.0
// From det, num, U2, V (f_facet_sums.v), N.lift and |N_x| + |N_y| + |N_z| a clock later, and from
// the queues another clock later whether the facet is the ray's own, a plane, the ray one to a
// light: hit, det', num' and the sign are those of the model in words that hold every value. That
// all keep their bounds (docs/design/primitives.md) is assumed. Queues, sums and keys say anything.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
`include "rt_facet.vh"
module f_facet #(
    parameter W  = 16,
    parameter WD = 17
) (
    input wire clk,
    input wire [`RT_ID_BITS+600:0] test,
    input wire result_ready
);
    localparam NG = 2, SLOTS = 16;
    localparam DW = (2*W > 24 ? 2*W : 24) + WD + 1;
    localparam MW = 3*W + 1 > W + 25 ? 3*W + 1 : W + 25;
    localparam VW = (DW > MW ? DW : MW) + 1;
    localparam CW = `RT_FACET_WIDE(W, WD);
    localparam X  = VW + 6;                          // bits of the model's words
    rt_facet #(.W(W), .WD(WD), .SLOTS(SLOTS), .NG(NG)) u_dut (
        .clk(clk), .rst(1'b0), .in_valid_i(test[0]), .test_i(test[`RT_TEST_BITS:1]),
        .result_ready_i(result_ready)
    );
    (* hierconn *) wire signed [VW-1:0] \u_dut.det , \u_dut.num , \u_dut.u2 , \u_dut.v ;
    (* hierconn *) wire signed [CW+NG+1:0] \u_dut.g_ahead.s1_along ;
    (* hierconn *) wire            \u_dut.g_ahead.s1_carry ;
    (* hierconn *) wire [CW:0]     \u_dut.g_ahead.s1_size ;
    (* hierconn *) wire            \u_dut.is_own , \u_dut.is_plane , \u_dut.is_shadow ;
    (* hierconn *) wire            \u_dut.hit , \u_dut.s2_neg_q ;
    (* hierconn *) wire [DW-1:0]   \u_dut.s2_det_q ;
    (* hierconn *) wire [MW-1:0]   \u_dut.s2_num_q ;
    reg [1:0] age_q = 2'd0;
    reg signed [VW-1:0] det_q, num_q, u2_q, v_q;
    reg signed [X-1:0]  lift_q, all_q;
    wire signed [X-1:0] lift = \u_dut.g_ahead.s1_along + $signed({1'b0, \u_dut.g_ahead.s1_carry });
    wire signed [X-1:0] all  = $signed({1'b0, \u_dut.g_ahead.s1_size });
    always @(posedge clk) begin
        if (age_q != 3) age_q <= age_q + 1'b1;
        if (age_q == 0)
            {det_q, num_q, u2_q, v_q} <= {\u_dut.det , \u_dut.num , \u_dut.u2 , \u_dut.v };
        if (age_q == 1) {lift_q, all_q} <= {lift, all};
    end

    // ---- sph_facet_test(), behind its sums ----
    wire signed [X-1:0] det = det_q, u2 = u2_q, u1 = -v_q, u0 = det - u2 - u1;
    wire signed [X-1:0] det1 = det < 0 ? -det : det;
    wire signed [X-1:0] all_num = num_q, num1 = det < 0 ? -all_num : all_num;
    wire ahead  = (num1 <<< NG) + (det < 0 ? -lift_q : lift_q) > all_q;
    wire meets = det > 0 ? u0 >= 0 && u1 >= 0 && u2 >= 0 : u0 <= 0 && u1 <= 0 && u2 <= 0;
    wire hit    = !\u_dut.is_own && det != 0 && num1 > 0 &&
                  !(\u_dut.is_shadow && (num1 >= det1 || !ahead)) && (\u_dut.is_plane || meets);
    localparam signed [X-1:0] ONE = 1;
    function fits(input signed [X-1:0] x, input signed [X-1:0] most);
        fits = x < most && x > -most;
    endfunction
    always @* if (age_q == 2) begin
        assume (fits(det, ONE <<< DW) && fits(all_num, ONE <<< MW) && fits(u0, ONE <<< (VW-1)));
        assume (fits(u1, ONE <<< (VW-1)) && fits(u2, ONE <<< (VW-1)));
        assume (lift_q <= all_q <<< NG && lift_q >= -(all_q <<< NG));
        assert (\u_dut.hit == hit);
        if (hit) assert (\u_dut.s2_det_q == det1 && \u_dut.s2_num_q == num1);
        if (hit) assert (\u_dut.s2_neg_q == (det < 0));
    end
endmodule
`default_nettype wire
