// units_tb.sv - six units of ours, each against the golden model; put yours in their place
// SPDX-License-Identifier: Apache-2.0
//
// Operands that are asked for are kept in queues until their result comes. Ends with 1 if anything
// differs.
`timescale 1ns / 1ps
module units_tb;
    import sphaera_pkg::*;
    localparam RUNS = 2000, W = 16, WD = 17, PQ = 17, FW = 14;
    localparam KW = W + WD + 2, AW = 2 * WD, XW = 2 * (W + WD);
    logic clk = 0, rst = 1;
    units model = new;
    int   done[6];
    always #5 clk = !clk;

    function automatic longint some(int bits);   // of so many bits, often fewer
        longint v = {$urandom, $urandom};
        return v << (64 - bits) >>> (64 - bits + $urandom_range(bits - 1));
    endfunction

    // ---- unit vector ----
    typedef longint vector_t [3];
    logic           v_ready, v_valid;
    logic [WD-1:0]  v[3];
    logic signed [17:0] u[3];
    logic [16:0]    u_scale;
    logic [5:0]     u_shift;
    vector_t        v_asked[$];
    rt_unit #(.BITS(WD)) u_unit (
        .clk(clk), .rst(rst), .in_valid_i(1'b1), .in_ready_o(v_ready), .in_tag_i(8'b0),
        .in_x_i(v[0]), .in_y_i(v[1]), .in_z_i(v[2]), .out_valid_o(v_valid), .out_tag_o(),
        .out_vv_o(), .out_u_x_o(u[0]), .out_u_y_o(u[1]), .out_u_z_o(u[2]), .out_y_o(u_scale),
        .out_h_o(u_shift));
    always @(posedge clk) begin
        if (v_ready && !rst) begin
            vector_t asked;
            for (int i = 0; i < 3; i++) begin
                asked[i] = longint'($signed(v[i]));
                v[i] <= WD'(some(WD));
            end
            v_asked.push_back(asked);
        end
        if (v_valid && !rst) begin
            int got[3];
            for (int i = 0; i < 3; i++) got[i] = 32'(u[i]);
            void'(model.unit_vector(WD, v_asked.pop_front(), got, 32'(u_scale), 32'(u_shift)));
            done[0]++;
        end
    end

    // ---- root ----
    logic            x_ready, root_valid, inexact;
    logic [XW-1:0]   x, x_asked;
    logic [XW/2-1:0] root;
    rt_isqrt #(.XW(XW)) u_isqrt (
        .clk(clk), .rst(rst), .in_valid_i(1'b1), .in_ready_o(x_ready), .in_x_i(x),
        .in_tag_i(1'b0), .out_valid_o(root_valid), .out_root_o(root), .out_shift_o(),
        .out_inexact_o(inexact), .out_tag_o());
    always @(posedge clk) if (!rst) begin
        if (root_valid) begin
            void'(model.root(128'(x_asked), 0, 64'(root), inexact));
            done[1]++;
        end
        if (x_ready) begin
            x_asked <= x;
            x <= XW'({$urandom, $urandom, $urandom}) >> $urandom_range(XW - 1);
        end
    end

    // ---- quotient ----
    logic           q_ready, q_valid;
    logic [KW-1:0]  key, key_asked;
    logic [AW-1:0]  a, a_asked;
    logic [PQ-1:0]  mant;
    logic signed [7:0] exp;
    rt_quotient #(.KW(KW), .AW(AW), .PQ(PQ)) u_quotient (
        .clk(clk), .rst(rst), .in_valid_i(1'b1), .in_ready_o(q_ready), .in_key_i(key), .in_a_i(a),
        .out_valid_o(q_valid), .out_ready_i(1'b1), .out_mant_o(mant), .out_exp_o(exp));
    always @(posedge clk) if (!rst) begin
        if (q_valid) begin
            void'(model.quotient(64'(key_asked), KW, 64'(a_asked), AW, PQ, 32'(mant), 32'(exp)));
            done[2]++;
        end
        if (q_ready) begin
            key_asked <= key;
            a_asked   <= a;
            key <= KW'({$urandom, $urandom}) >> $urandom_range(KW - 1) | 1'b1;
            a   <= AW'({$urandom, $urandom}) >> $urandom_range(AW - 1) | 1'b1;
        end
    end

    // ---- leaf test ----
    typedef struct packed {
        bit [2:0][63:0] origin, direction, centre;
        bit [63:0] radius;
        bit [23:0] id, skip;
        bit        skip_inside, shadow;
    } leaf_t;
    logic             l_ready, l_valid, hit, far_root, leaves;
    logic [2*W+2*WD-1:0] disc;
    logic signed [W+WD+1:0] b;
    leaf_t            l, l_asked[$];
    function automatic leaf_t some_leaf();
        leaf_t n;
        for (int i = 0; i < 3; i++) begin
            n.origin[i] = some(W);
            n.direction[i] = some(WD);
            n.centre[i] = some(W);
        end
        n.radius = some(W) & 16'hffff;
        n.id = 24'($urandom_range(1));
        n.skip = 24'($urandom_range(2));
        n.skip_inside = 1'($urandom);
        n.shadow = 1'($urandom);
        return n;
    endfunction
    bit [63:0] square;   // its low bits are those of signed factors too
    assign square = l.direction[0] * l.direction[0] + l.direction[1] * l.direction[1] +
                    l.direction[2] * l.direction[2];
    rt_leaf #(.W(W), .WD(WD)) u_leaf (
        .clk(clk), .rst(rst), .inside_on_i(1'b1), .in_valid_i(1'b1), .in_ready_o(l_ready),
        .in_tag_i(8'b0), .in_ctr_x_i(W'(l.centre[0])), .in_ctr_y_i(W'(l.centre[1])),
        .in_ctr_z_i(W'(l.centre[2])), .in_rad_i(W'(l.radius)), .in_id_i(l.id),
        .in_org_x_i(W'(l.origin[0])), .in_org_y_i(W'(l.origin[1])), .in_org_z_i(W'(l.origin[2])),
        .in_dir_x_i(WD'(l.direction[0])), .in_dir_y_i(WD'(l.direction[1])),
        .in_dir_z_i(WD'(l.direction[2])), .in_a_i(AW'(square)), .in_shadow_i(l.shadow),
        .in_skip_id_i(l.skip), .in_skip_inside_i(l.skip_inside), .out_valid_o(l_valid),
        .out_tag_o(), .out_id_o(), .out_hit_o(hit), .out_far_o(far_root), .out_exit_o(leaves),
        .out_disc_o(disc), .out_b_o(b));
    always @(posedge clk) begin
        if (rst || l_ready) l <= some_leaf();
        if (l_ready && !rst) l_asked.push_back(l);
        if (l_valid && !rst) begin
            leaf_t   n = l_asked.pop_front();
            vector_t origin, direction, centre;
            for (int i = 0; i < 3; i++) begin
                origin[i] = n.origin[i];
                direction[i] = n.direction[i];
                centre[i] = n.centre[i];
            end
            void'(model.leaf(W, WD, origin, direction, centre, n.radius, n.id, n.skip,
                             n.skip_inside, n.shadow, 1'b1, hit, far_root, leaves, 128'(disc),
                             longint'(b)));
            done[3]++;
        end
    end

    // ---- filter: a child a clock, its result so many clocks later ----
    localparam LATENCY = 9;   // RT_FILTER_LATENCY
    typedef struct packed {
        bit [2:0][31:0] origin, q, centre;
        bit [31:0] p_a, p_b, least, axis, depth_max, radius;
        bit negative;
    } child_t;
    logic               pass;
    logic signed [15:0] near_depth;
    child_t             c, s1, c_asked[$];             // s1: c a clock later
    function automatic child_t some_child();
        child_t n;
        for (int i = 0; i < 3; i++) begin
            n.origin[i] = 32'(some(FW));
            n.q[i] = 32'(some(18));
            n.centre[i] = 32'(some(FW));
        end
        n.p_a = 32'(some(18));
        n.p_b = 32'(some(18));
        n.least = $urandom_range(2);
        n.axis = $urandom_range(2);
        n.negative = 1'($urandom);
        n.depth_max = $urandom_range((2 << FW) - 1);
        n.radius = 32'(some(15)) & 16383;
        return n;
    endfunction
    rt_filter #(.FW(FW)) u_filter (
        .clk(clk), .in_valid_i(!rst), .in_org_x_i(FW'(c.origin[0])), .in_org_y_i(FW'(c.origin[1])),
        .in_org_z_i(FW'(c.origin[2])), .in_least_i(2'(c.least)), .s1_p_a_i(18'(s1.p_a)),
        .s1_p_b_i(18'(s1.p_b)), .s1_q_x_i(18'(s1.q[0])), .s1_q_y_i(18'(s1.q[1])),
        .s1_q_z_i(18'(s1.q[2])), .in_axis_i(2'(c.axis)), .in_negative_i(c.negative),
        .in_depth_max_i((FW+1)'(c.depth_max)), .in_ctr_x_i(14'(c.centre[0])),
        .in_ctr_y_i(14'(c.centre[1])), .in_ctr_z_i(14'(c.centre[2])), .in_rad_i(14'(c.radius)),
        .out_pass_o(pass), .out_near_o(near_depth));
    always @(posedge clk) begin
        c <= some_child();
        s1 <= c;
        if (!rst) c_asked.push_back(c);
        if (!rst && c_asked.size() > LATENCY) begin
            child_t n = c_asked.pop_front();
            int     origin[3], q[3], centre[3];
            for (int i = 0; i < 3; i++) begin
                origin[i] = n.origin[i];
                q[i] = n.q[i];
                centre[i] = n.centre[i];
            end
            void'(model.node_filter(origin, n.least, n.p_a, n.p_b, q, n.axis, n.negative,
                                    n.depth_max, centre, n.radius, pass, 32'(near_depth)));
            done[4]++;
        end
    end

    // ---- texel ----
    typedef struct packed {
        bit [3:0][23:0] near_texels, far_texels;
        bit [1:0][7:0]  near_weights, far_weights;
        bit [7:0]       level;
    } texel_t;
    logic        t_ready, t_valid;
    logic [23:0] texel;
    texel_t      t, t_asked[$];
    function automatic texel_t some_texels();
        return texel_t'({$urandom, $urandom, $urandom, $urandom, $urandom, $urandom, $urandom,
                         $urandom});
    endfunction
    rt_texel_filter u_texel (
        .clk(clk), .rst(rst), .in_valid_i(1'b1), .in_ready_o(t_ready), .in_tag_i(8'b0),
        .in_near_i(t.near_texels), .in_far_i(t.far_texels), .in_near_weight_i(t.near_weights),
        .in_far_weight_i(t.far_weights), .in_level_i(t.level),
        .out_valid_o(t_valid), .out_tag_o(), .out_texel_o(texel));
    always @(posedge clk) begin
        if (rst || t_ready) t <= some_texels();
        if (t_ready && !rst) t_asked.push_back(t);
        if (t_valid && !rst) begin
            texel_t      n = t_asked.pop_front();
            int unsigned near_texels[4], far_texels[4];
            int          near_weights[2], far_weights[2];
            for (int i = 0; i < 4; i++) begin
                near_texels[i] = 32'(n.near_texels[i]);
                far_texels[i] = 32'(n.far_texels[i]);
            end
            for (int i = 0; i < 2; i++) begin
                near_weights[i] = 32'(n.near_weights[i]);
                far_weights[i] = 32'(n.far_weights[i]);
            end
            void'(model.texel(near_texels, far_texels, near_weights, far_weights, 32'(n.level),
                              32'(texel)));
            done[5]++;
        end
    end

    initial begin
        string names[6] = '{"unit vector", "root", "quotient", "leaf", "filter", "texel"};
        key = 1;
        a = 1;
        x = 0;
        for (int i = 0; i < 3; i++) v[i] = 0;
        repeat (16) @(negedge clk);
        rst = 0;
        while (done[0] < RUNS || done[1] < RUNS || done[2] < RUNS || done[3] < RUNS ||
               done[4] < RUNS || done[5] < RUNS) @(negedge clk);
        for (int i = 0; i < 6; i++) $display("%s: %0d", names[i], done[i]);
        if (model.differ != 0) $fatal(1, "not ok: %0d of %0d differ", model.differ, model.checks);
        $display("ok: all as the model has them");
        $finish;
    end
endmodule
