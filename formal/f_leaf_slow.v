// f_leaf_slow.v - proof that rt_leaf with INTERVAL 4 computes sph_leaf_test(), widths of profiles
// SPDX-License-Identifier: Apache-2.0
// As f_leaf_wide.v without SUMS: what is made of any b, k and their disc (f_leaf_sums.v,
// f_leaf_disc.v); that they keep their bounds (products.smt2, disc.smt2), is assumed.
`timescale 1ns / 1ps
`default_nettype none
module f_leaf_slow #(
    parameter W      = 16,
    parameter WD     = 17,
    parameter SHADOW = 1,
    parameter INSIDE = 1,
    parameter T_B    = 7,       // clock of b and k
    parameter T      = 16       // latency
) (
    input wire                 clk,
    input wire                 in_valid,
    input wire                 on,
    input wire [1:0]           tag,
    input wire signed [W-1:0]  ctr_x, ctr_y, ctr_z, org_x, org_y, org_z,
    input wire [W-1:0]         rad,
    input wire [23:0]          id, skip_id,
    input wire signed [WD-1:0] dir_x, dir_y, dir_z,
    input wire [2*WD-1:0]      dir_dir,
    input wire                 shadow, skip_inside
);
    localparam X  = 2*W + 2*WD + 8;      // bits of the model's words
    localparam BW = W + WD + 2, KW = 2*W + 3;
    localparam VW = KW > BW ? KW : BW;
    localparam NW = VW > 2*WD + 1 ? VW : 2*WD + 1;
    localparam DW = 2*W + 2*WD + 2;
    wire in_ready, out_valid, out_hit, out_far, out_exit;
    wire [1:0] out_tag;
    wire [23:0] out_id;
    wire [2*W+2*WD-1:0] out_disc;
    wire signed [W+WD+1:0] out_b;
    rt_leaf #(.W(W), .WD(WD), .TAG(2), .SHADOW(SHADOW), .INSIDE(INSIDE),
              .INTERVAL(4)) u_dut (
        .clk(clk), .rst(1'b0), .inside_on_i(on), .in_valid_i(in_valid), .in_ready_o(in_ready),
        .in_tag_i(tag), .in_ctr_x_i(ctr_x), .in_ctr_y_i(ctr_y), .in_ctr_z_i(ctr_z),
        .in_rad_i(rad), .in_id_i(id), .in_org_x_i(org_x), .in_org_y_i(org_y), .in_org_z_i(org_z),
        .in_dir_x_i(dir_x), .in_dir_y_i(dir_y), .in_dir_z_i(dir_z), .in_a_i(dir_dir),
        .in_shadow_i(shadow), .in_skip_id_i(skip_id), .in_skip_inside_i(skip_inside),
        .out_valid_o(out_valid), .out_tag_o(out_tag), .out_id_o(out_id), .out_hit_o(out_hit),
        .out_far_o(out_far), .out_exit_o(out_exit), .out_disc_o(out_disc), .out_b_o(out_b)
    );
    (* hierconn *) wire [T-1:0] \u_dut.valid_q ;

    // ---- sph_leaf_test() ----
    function signed [2*NW-1:0] times_wide(input signed [NW-1:0] x, input signed [NW-1:0] y);
        times_wide = x * y;
    endfunction
    (* hierconn *) wire signed [BW-1:0] \u_dut.g_four.u_four.b_q ;
    (* hierconn *) wire signed [KW-1:0] \u_dut.g_four.u_four.k_q ;
    reg signed [BW-1:0]  b_q;
    reg signed [KW-1:0]  k_q;
    always @(posedge clk) if (age_q == T_B)
        {b_q, k_q} <= {\u_dut.g_four.u_four.b_q , \u_dut.g_four.u_four.k_q };
    wire signed [X-1:0]  b = b_q, k = k_q, a = $signed({1'b0, a_q});
    wire signed [X-1:0]  ka   = times_wide(k[NW-1:0], a[NW-1:0]);
    wire signed [X-1:0]  bb   = times_wide(b[NW-1:0], b[NW-1:0]);
    wire signed [X-1:0]  disc = ka + bb;
    wire signed [X-1:0]  light = k + (2*b - a);
    localparam signed [X-1:0] ONE = 1;
    localparam signed [X-1:0] LONG = (ONE <<< W) - 1, D = ONE <<< (WD - 1);   // factors at most
    function fits(input signed [X-1:0] x, input signed [X-1:0] most);
        fits = x <= most && x >= -most;
    endfunction
    wire fit = fits(b, 3*LONG*D) && k <= LONG*LONG && k >= -3*LONG*LONG && a <= 3*D*D &&
                    fits(ka, ONE <<< (X-3)) && fits(bb, ONE <<< (X-3)) &&
                    disc < ONE <<< (DW-2) && disc >= -(ONE <<< (DW-1));
    wire own    = own_q;
    wire inner  = INSIDE != 0 && on_q;
    wire skip   = inner ? own && !skip_inside_q : own || k >= 0;
    wire ahead  = disc > 0 && (b > 0 || k > 0);
    wire far    = !skip && (k >= 0 || own);
    wire ends   = SHADOW != 0 && shadow_q;
    wire exit   = !skip && !ends && own && !ahead;
    wire hit    = !skip && (!ends ? ahead || own
                            : own   ? light < 0
                            : k < 0 ? disc > 0 && b > 0 && (b < a || light > 0)
                                    : (k > 0 || b > 0) && light < 0);

    // ---- first clock: any state in which leaves are 4 clocks apart ----
    reg [4:0]      age_q = 5'd0;
    wire [T-1:0]   v = \u_dut.valid_q ;
    reg [1:0]      tag_q;
    reg [23:0]     id_q;
    reg [2*WD-1:0] a_q;
    reg            on_q, own_q, skip_inside_q, shadow_q;
    always @(posedge clk) begin
        if (age_q != T) age_q <= age_q + 1'b1;
        on_q <= on;
        if (age_q == 0) begin
            {tag_q, id_q, a_q} <= {tag, id, dir_dir};
            {own_q, skip_inside_q, shadow_q} <= {id == skip_id, skip_inside, shadow};
        end
    end
    always @* begin
        if (age_q == 0) assume (in_valid && in_ready && !(v & (v << 1 | v << 2 | v << 3)));
        if (age_q != 0) assume (on == on_q);             // changes only while no leaf is inside
        if (age_q == T) assume (fit);
    end

    // ---- T clocks later ----
    always @* if (age_q == T) begin
        assert (out_valid && out_tag == tag_q && out_id == id_q);
        assert (out_hit == hit);
        if (hit) assert (out_b == b && out_far == far);
        if (hit && !ends) assert (out_exit == exit);
        if (hit && !ends && !exit) assert (out_disc == disc);
    end
endmodule
`default_nettype wire
