// f_leaf_wide.v - proof that rt_leaf computes sph_leaf_test(), at the widths of profiles
// SPDX-License-Identifier: Apache-2.0
// As f_leaf.v, but products are a function of their factors, and rt_multiply makes them at once.
// SUMS: b and k, modulo 2^VW, which holds them, a stage at a time. Without: what is made of any b
// and k; that they, a and disc keep their bounds (products.smt2, disc.smt2), is assumed.
`timescale 1ns / 1ps
`default_nettype none
module f_leaf_wide #(
    parameter W      = 16,
    parameter WD     = 17,
    parameter SHADOW = 1,
    parameter INSIDE = 1,
    parameter SUMS   = 0,
    parameter T_B    = 4,       // clock of b; k comes in the next
    parameter T      = 12       // latency
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
    localparam OW = 18;                  // factors of narrow products, and of wide ones
    localparam BW = W + WD + 2, KW = 2*W + 3;
    localparam VW = KW > BW ? KW : BW;
    localparam NW = VW > 2*WD + 1 ? VW : 2*WD + 1;
    localparam DW = 2*W + 2*WD + 2;
    wire in_ready, out_valid, out_hit, out_far, out_exit;
    wire [1:0] out_tag;
    wire [23:0] out_id;
    wire [2*W+2*WD-1:0] out_disc;
    wire signed [W+WD+1:0] out_b;
    rt_leaf #(.W(W), .WD(WD), .TAG(2), .SHADOW(SHADOW), .INSIDE(INSIDE)) u_dut (
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
    function signed [2*OW-1:0] times(input signed [OW-1:0] x, input signed [OW-1:0] y);
        times = x * y;
    endfunction
    function signed [2*NW-1:0] times_wide(input signed [NW-1:0] x, input signed [NW-1:0] y);
        times_wide = x * y;
    endfunction
    wire signed [OW-1:0] oc_x = ctr_x - org_x, oc_y = ctr_y - org_y, oc_z = ctr_z - org_z;
    wire signed [OW-1:0] d_x  = dir_x, d_y = dir_y, d_z = dir_z, r = $signed({1'b0, rad});
    (* hierconn *) wire [VW-1:0] \u_dut.g_two.u_two.val_q ;
    wire signed [VW-1:0] val = \u_dut.g_two.u_two.val_q ;
    reg  signed [VW-1:0] val_b_q, val_k_q;
    always @(posedge clk) begin
        if (age_q == T_B)     val_b_q <= val;
        if (age_q == T_B + 1) val_k_q <= val;
    end
    wire signed [X-1:0]  b = val_b_q, k = val_k_q, a = $signed({1'b0, a_q});
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

    // ---- first clock: any state in which leaves are 2 clocks apart ----
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
        if (age_q == 0) assume (in_valid && in_ready && !(v & (v << 1)));
        if (age_q != 0) assume (on == on_q);             // changes only while no leaf is inside
        if (age_q == T && SUMS == 0) assume (fit);
    end

    // ---- the sums: what each stage must hold, from the stage before; T clocks later ----
    (* hierconn *) wire [VW-1:0]   \u_dut.g_two.u_two.xy_q , \u_dut.g_two.u_two.z_q ;
    (* hierconn *) wire [2*OW-1:0] \u_dut.g_two.u_two.p_x , \u_dut.g_two.u_two.p_y ,
        \u_dut.g_two.u_two.p_z , \u_dut.g_two.u_two.p_rad ;
    wire [2*OW-1:0] p_x = \u_dut.g_two.u_two.p_x , p_y = \u_dut.g_two.u_two.p_y ,
                    p_z = \u_dut.g_two.u_two.p_z , p_r = \u_dut.g_two.u_two.p_rad ;
    wire [VW-1:0]   xy = \u_dut.g_two.u_two.xy_q , z = \u_dut.g_two.u_two.z_q ;
    reg  [2*OW-1:0] b_x, b_y, b_z, k_x, k_y, k_z, k_r;   // the model's products
    reg  [VW-1:0]   xy_1, z_1, val_1;
    reg             good_q = 1'b1;                       // until now
    always @(posedge clk) begin
        if (age_q == 0 && SUMS != 0) begin
            {b_x, b_y, b_z} <= {times(oc_x, d_x), times(oc_y, d_y), times(oc_z, d_z)};
            {k_x, k_y, k_z} <= {times(oc_x, oc_x), times(oc_y, oc_y), times(oc_z, oc_z)};
            k_r <= times(r, r);
        end
        xy_1  <= p_x[VW-1:0] + p_y[VW-1:0];
        z_1   <= age_q == 2 ? p_z[VW-1:0] : p_r[VW-1:0] - p_z[VW-1:0];
        val_1 <= age_q == 3 ? z + xy : z - xy;
        if (age_q == 2 && !(p_x == b_x && p_y == b_y && p_z == b_z)) good_q <= 1'b0;
        if (age_q == 3 && !(p_x == k_x && p_y == k_y && p_z == k_z && p_r == k_r)) good_q <= 1'b0;
        if ((age_q == 3 || age_q == 4) && !(xy == xy_1 && z == z_1)) good_q <= 1'b0;
        if (age_q == 4 && val != val_1) good_q <= 1'b0;
    end
    always @* if (SUMS != 0) begin
        if (age_q == 5) assert (good_q && val == val_1);
    end else if (age_q == T) begin
        assert (out_valid && out_tag == tag_q && out_id == id_q);
        assert (out_hit == hit);
        if (hit) assert (out_b == b && out_far == far);
        if (hit && !ends) assert (out_exit == exit);
        if (hit && !ends && !exit) assert (out_disc == disc);
    end
endmodule
`default_nettype wire
