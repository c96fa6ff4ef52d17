// f_closest_hit_depth.v - proof that rt_closest_hit bounds a ray by its hit as the model does
// SPDX-License-Identifier: Apache-2.0
// From any state: a hit comes in clock 0; if it wins, s3_depth is its depth three clocks later: of
// sph_ray_depth() from its key and the ray's scale and shift, or with KEYS of sph_bih_time(), which
// KEYS = 2 makes one of sph_box_depth().
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module f_closest_hit_depth #(
    parameter W    = 16,
    parameter WD   = 17,
    parameter FW   = 14,
    parameter KEYS = 0
) (
    input wire            clk,
    input wire [1:0]      in_slot,
    input wire [W+WD+1:0] in_key
);
    localparam KW = W + WD + 2;
    localparam TW = `RT_BIH_T;
    localparam T  = KW > TW ? KW - TW : 0;            // sph_bih_time(): bits that are dropped
    localparam [FW:0] LIM = {(FW+1){1'b1}};
    (* hierconn *) wire [(KEYS != 0 ? 0 : 23):0] \u_dut.in_scale ;
    (* hierconn *) wire [FW:0] \u_dut.s3_depth ;
    (* hierconn *) wire        \u_dut.s3_win_q ;
    rt_closest_hit #(.W(W), .WD(WD), .FW(FW), .SLOTS(4), .KEYS(KEYS)) u_dut (
        .clk(clk), .rst(1'b0), .in_valid_i(1'b1), .in_slot_i(in_slot), .in_hit_i(1'b1),
        .in_key_i(in_key), .in_far_i(1'b0), .in_id_i(`RT_ID_BITS'd0), .want_valid_i(1'b0),
        .want_slot_i(2'd0), .want_count_i(3'd0), .new_valid_i(1'b0), .new_slot_i(2'd0),
        .new_scale_i(17'd0), .new_shift_i(6'd0), .new_shadow_i(1'b0), .new_primary_i(1'b0),
        .new_first_i(1'b0), .new_depth_i({(FW+1){1'b0}}), .filter_valid_i(1'b0),
        .filter_slot_i(2'd0), .next_valid_i(1'b0), .next_slot_i(2'd0), .done_valid_i(1'b0),
        .done_slot_i(2'd0)
    );
    reg  [1:0]    age_q = 2'd0;
    reg  [KW-1:0] key_q;
    reg  [22:0]   scale_q;
    wire [22:0]   scale = KEYS != 0 ? 23'd0 : \u_dut.in_scale ;
    wire [16:0]   top = key_q[KW-1 -: 17] + 17'd1;
    wire [33:0]   product = top * scale_q[16:0];
    wire [34:0]   far = {1'b0, product >> scale_q[22:17]} + 1;
    wire [KW+TW-1:0] part = {{TW{1'b0}}, key_q} >> T;
    reg  [4:0]    length;                             // of the T-word
    integer       i;
    always @* begin
        length = 0;
        for (i = 0; i < TW; i = i + 1) if (part[i]) length = i + 1;
    end
    wire [4:0]    n = length > 12 ? length - 12 : 0;
    wire [31:0]   near = ({27'd0, n} << 11) + ({10'd0, part[TW-1:0]} >> n);
    always @(posedge clk) begin
        if (age_q != 3) age_q <= age_q + 1'b1;
        if (age_q == 0) {key_q, scale_q} <= {in_key, scale};
    end
    always @* begin
        if (age_q == 0) assume (!(&in_key[KW-1 -: 17]));   // below 2.4 * 2^(W + WD)
        if (age_q == 3 && \u_dut.s3_win_q ) begin
            if (KEYS == 2)      assert (\u_dut.s3_depth == near);
            else if (KEYS == 1) assert (\u_dut.s3_depth == part[TW-1:0]);
            else assert (\u_dut.s3_depth == (scale_q[22:17] == 63 || far > LIM ? LIM : far));
        end
    end
endmodule
`default_nettype wire
