// f_leaf.v - proof that rt_leaf computes sph_leaf_test(), every input of a small width
// SPDX-License-Identifier: Apache-2.0
// A leaf is taken in the first clock, with anything inside: others before and behind it come at any
// time. T clocks later the result is that of cmodel/prim/sphere.c in words that hold every value,
// so disc fits its 2W+2WD+2 bits and the sums modulo that are exact.
`timescale 1ns / 1ps
`default_nettype none
module f_leaf #(
    parameter W      = 2,
    parameter WD     = 3,
    parameter SHADOW = 1,
    parameter INSIDE = 1,
    parameter INTERVAL = 2,
    parameter T      = INTERVAL == 4 ? 16 : 10   // latency
) (
    input wire                 clk,
    input wire                 in_valid,
    input wire                 on,
    input wire [1:0]           tag,
    input wire signed [W-1:0]  ctr_x, ctr_y, ctr_z, org_x, org_y, org_z,
    input wire [W-1:0]         rad,
    input wire [23:0]          id, skip_id,
    input wire signed [WD-1:0] dir_x, dir_y, dir_z,
    input wire                 shadow, skip_inside
);
    localparam X = 4*W + 4*WD;           // bits of the model's words
    wire signed [X-1:0] d_x = dir_x, d_y = dir_y, d_z = dir_z;
    wire signed [X-1:0] a   = d_x*d_x + d_y*d_y + d_z*d_z;
    wire in_ready, out_valid, out_hit, out_far, out_exit;
    wire [1:0] out_tag;
    wire [23:0] out_id;
    wire [2*W+2*WD-1:0] out_disc;
    wire signed [W+WD+1:0] out_b;
    rt_leaf #(.W(W), .WD(WD), .TAG(2), .SHADOW(SHADOW), .INSIDE(INSIDE),
              .INTERVAL(INTERVAL)) u_dut (
        .clk(clk), .rst(1'b0), .inside_on_i(on), .in_valid_i(in_valid), .in_ready_o(in_ready),
        .in_tag_i(tag), .in_ctr_x_i(ctr_x), .in_ctr_y_i(ctr_y), .in_ctr_z_i(ctr_z),
        .in_rad_i(rad), .in_id_i(id), .in_org_x_i(org_x), .in_org_y_i(org_y), .in_org_z_i(org_z),
        .in_dir_x_i(dir_x), .in_dir_y_i(dir_y), .in_dir_z_i(dir_z), .in_a_i(a[2*WD-1:0]),
        .in_shadow_i(shadow), .in_skip_id_i(skip_id), .in_skip_inside_i(skip_inside),
        .out_valid_o(out_valid), .out_tag_o(out_tag), .out_id_o(out_id), .out_hit_o(out_hit),
        .out_far_o(out_far), .out_exit_o(out_exit), .out_disc_o(out_disc), .out_b_o(out_b)
    );
    (* hierconn *) wire [T-1:0] \u_dut.valid_q ;

    // ---- sph_leaf_test() ----
    wire signed [X-1:0] oc_x = ctr_x - org_x, oc_y = ctr_y - org_y, oc_z = ctr_z - org_z;
    wire signed [X-1:0] r    = $signed({1'b0, rad});
    wire signed [X-1:0] b    = oc_x*d_x + oc_y*d_y + oc_z*d_z;
    wire signed [X-1:0] k    = r*r - (oc_x*oc_x + oc_y*oc_y + oc_z*oc_z);
    wire signed [X-1:0] disc = k*a + b*b;
    wire signed [X-1:0] light = k + 2*b - a;
    wire own    = id == skip_id;
    wire inner  = INSIDE != 0 && on;
    wire skip   = inner ? own && !skip_inside : own || k >= 0;
    wire ahead  = disc > 0 && (b > 0 || k > 0);
    wire far    = !skip && (k >= 0 || own);
    wire ends   = SHADOW != 0 && shadow;
    wire exit   = !skip && !ends && own && !ahead;
    wire hit    = !skip && (!ends ? ahead || own
                            : own   ? light < 0
                            : k < 0 ? disc > 0 && b > 0 && (b < a || light > 0)
                                    : (k > 0 || b > 0) && light < 0);

    // ---- first clock: any state in which leaves are INTERVAL clocks apart ----
    reg [4:0] age_q = 5'd0;
    wire [T-1:0] v = \u_dut.valid_q ;
    wire apart = !(v & (v << 1)) && (INTERVAL == 2 || !(v & (v << 2 | v << 3)));
    reg signed [X-1:0] disc_q, b_q;
    reg [1:0]  tag_q;
    reg [23:0] id_q;
    reg        on_q, hit_q, far_q, exit_q, ends_q;
    always @(posedge clk) begin
        if (age_q != T) age_q <= age_q + 1'b1;
        on_q <= on;
        if (age_q == 0) begin
            disc_q <= disc;
            b_q    <= b;
            tag_q  <= tag;
            id_q   <= id;
            hit_q  <= hit;
            far_q  <= far;
            exit_q <= exit;
            ends_q <= ends;
        end
    end
    always @* begin
        if (age_q == 0) assume (in_valid && in_ready && apart);
        if (age_q != 0) assume (on == on_q);             // changes only while no leaf is inside
    end

    // ---- T clocks later ----
    always @* if (age_q == T) begin
        assert (out_valid && out_tag == tag_q && out_id == id_q);
        assert (out_hit == hit_q);
        if (out_hit) assert (out_b == b_q && out_far == far_q);
        if (out_hit && !ends_q) assert (out_exit == exit_q);
        if (out_hit && !ends_q && !out_exit) assert (out_disc == disc_q);
    end
endmodule
`default_nettype wire
