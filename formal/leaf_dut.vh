// leaf_dut.vh - the leaf that f_leaf_wide.v and f_leaf_slow.v try, and its first clock
// SPDX-License-Identifier: Apache-2.0
// Parameters W, WD, SHADOW, INSIDE, INTERVAL, T of the module around it, and its inputs.
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
              .INTERVAL(INTERVAL)) u_dut (
        .clk(clk), .rst(1'b0), .inside_on_i(on), .in_valid_i(in_valid), .in_ready_o(in_ready),
        .in_tag_i(tag), .in_ctr_x_i(ctr_x), .in_ctr_y_i(ctr_y), .in_ctr_z_i(ctr_z),
        .in_rad_i(rad), .in_id_i(id), .in_org_x_i(org_x), .in_org_y_i(org_y), .in_org_z_i(org_z),
        .in_dir_x_i(dir_x), .in_dir_y_i(dir_y), .in_dir_z_i(dir_z), .in_a_i(dir_dir),
        .in_shadow_i(shadow), .in_skip_id_i(skip_id), .in_skip_inside_i(skip_inside),
        .out_valid_o(out_valid), .out_tag_o(out_tag), .out_id_o(out_id), .out_hit_o(out_hit),
        .out_far_o(out_far), .out_exit_o(out_exit), .out_disc_o(out_disc), .out_b_o(out_b)
    );
    (* hierconn *) wire [T-1:0] \u_dut.valid_q ;

    // ---- first clock: any state in which leaves are INTERVAL clocks apart ----
    reg [4:0]      age_q = 5'd0;
    wire [T-1:0]   v = \u_dut.valid_q ;
    wire           apart = INTERVAL == 4 ? !(v & (v << 1 | v << 2 | v << 3)) : !(v & (v << 1));
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
        if (age_q == 0) assume (in_valid && in_ready && apart);
        if (age_q != 0) assume (on == on_q);             // changes only while no leaf is inside
    end
