// f_facet_way.v - proof of what waits for a facet's sums: its group, the room and size of its ray
// SPDX-License-Identifier: Apache-2.0
// From any state: a facet is taken in clock 0, and in clock 3 the queue is given what
// sph_facet_own() and end() of cmodel/prim/facet.c have: whether the ray's skip is of its group,
// the longest axis of dir, of equal ones the first, and along it the room to one unit beyond the
// grid, and |dir|.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module f_facet_way #(
    parameter W  = 16,
    parameter WD = 17
) (
    input wire clk,
    input wire [`RT_ID_BITS+600:0] test,
    input wire result_ready
);
    localparam NG = 2, SLOTS = 16;
    localparam X = 32;                               // bits of the model's words
    wire ready;
    rt_facet #(.W(W), .WD(WD), .SLOTS(SLOTS), .NG(NG)) u_dut (
        .clk(clk), .rst(1'b0), .in_valid_i(test[0]), .in_ready_o(ready),
        .test_i(test[`RT_TEST_BITS:1]), .result_ready_i(result_ready)
    );
    (* hierconn *) wire          \u_dut.t3_q , \u_dut.t3_own_q ;
    (* hierconn *) wire [W:0]    \u_dut.w_room ;
    (* hierconn *) wire [WD-1:0] \u_dut.w_size ;
    wire [`RT_TEST_BITS-1:0] test_in = test[`RT_TEST_BITS:1];
    reg  [2:0] age_q = 3'd0;
    reg  [`RT_TEST_BITS-1:0] test_q;
    always @(posedge clk) begin
        if (age_q != 7) age_q <= age_q + 1'b1;
        if (age_q == 0) test_q <= test_in;
    end

    // ---- sph_facet_own(), end() ----
    wire [255:0] record = test_q[`RT_TEST_RECORD];
    wire [X-1:0] id     = record[`RT_FACET_ID_LSB +: `RT_FACET_ID_BITS];
    wire [X-1:0] skip   = test_q[`RT_TEST_SKIP];
    wire own = skip + record[`RT_FACET_BEFORE_LSB +: `RT_FACET_BEFORE_BITS] >= id &&
               skip <= id + record[`RT_FACET_AFTER_LSB +: `RT_FACET_AFTER_BITS];
    wire [3*W-1:0]  org = test_q[`RT_TEST_ORG];
    wire [3*WD-1:0] dir = test_q[`RT_TEST_DIR];
    wire signed [W-1:0]  org_0 = org[0 +: W],  org_1 = org[W +: W],   org_2 = org[2*W +: W];
    wire signed [WD-1:0] dir_0 = dir[0 +: WD], dir_1 = dir[WD +: WD], dir_2 = dir[2*WD +: WD];
    function signed [X-1:0] size_of(input signed [X-1:0] d); size_of = d < 0 ? -d : d; endfunction
    function signed [X-1:0] room_of(input signed [X-1:0] d, input signed [X-1:0] o);
        room_of = d < 0 ? o + (1 << (W-1)) + 1 : (1 << (W-1)) - o;
    endfunction
    wire signed [X-1:0] size_0 = size_of(dir_0), size_1 = size_of(dir_1), size_2 = size_of(dir_2);
    wire k_1 = size_1 > size_0, k_2 = size_2 > (k_1 ? size_1 : size_0);
    wire signed [X-1:0] size = k_2 ? size_2 : k_1 ? size_1 : size_0;
    wire signed [X-1:0] room = k_2 ? room_of(dir_2, org_2) : k_1 ? room_of(dir_1, org_1)
                                                                 : room_of(dir_0, org_0);
    always @* begin
        if (age_q == 0) assume (test[0] && ready);
        if (age_q == 3) begin
            assert (\u_dut.t3_q && \u_dut.t3_own_q == own);
            assert (\u_dut.w_room == room && \u_dut.w_size == size);
        end
    end
endmodule
`default_nettype wire
