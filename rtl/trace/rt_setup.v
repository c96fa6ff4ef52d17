// rt_setup.v - ray set-up: unit vectors, depth scale and Lambert's cosine
// SPDX-License-Identifier: Apache-2.0
// Takes directions from four sources (surface normals first, primary rays last), makes each a unit
// vector, and from that all a ray carries. Rays towards a light meet the surface's unit normal:
// those that face away never start. One vector a cycle, a light every second cycle.
// Model: sph_ray_setup() in cmodel/trace/setup.c, sph_lambert() in cmodel/shade/colour.c
`default_nettype none
`include "rt_layout.vh"
module rt_setup #(
    parameter W      = 16,  // coordinate, bits
    parameter WD     = 17,  // direction component, bits
    parameter FW     = 14,  // filter coordinate, bits
    parameter SHADOW = 1,   // 1: shadow rays are traced, 0: every light that is faced shines
    parameter SLOTS  = 32,  // power of two
    parameter SLOTW  = 5    // log2 of SLOTS
) (
    input  wire               clk,
    input  wire               rst,
    input  wire [3*W-1:0]     eye_i,            // {z, y, x} register
    input  wire               shadow_on_i,      // run-time switch of SHADOW
    // sources of vectors {z, y, x}
    input  wire               normal_valid_i,
    input  wire [SLOTW-1:0]   normal_slot_i,
    input  wire [3*WD-1:0]    normal_vec_i,
    input  wire               light_valid_i,
    input  wire [SLOTW-1:0]   light_slot_i,
    input  wire [3*WD-1:0]    light_vec_i,
    input  wire               bounce_valid_i,
    input  wire [SLOTW-1:0]   bounce_slot_i,
    input  wire [3*WD-1:0]    bounce_vec_i,
    input  wire               primary_valid_i,
    output wire               primary_ready_o,
    input  wire [SLOTW-1:0]   primary_slot_i,
    input  wire [3*WD-1:0]    primary_vec_i,
    // from rt_surface: where secondary rays start, and on what
    input  wire               point_valid_i,
    input  wire [SLOTW-1:0]   point_slot_i,
    input  wire [3*W-1:0]     point_i,
    input  wire               skip_valid_i,
    input  wire [SLOTW-1:0]   skip_slot_i,
    input  wire [24:0]        skip_i,           // {inside, id}
    // a ray, to everyone who keeps a part of it
    output reg                ray_valid_o,
    output reg [SLOTW-1:0]    ray_slot_o,
    output reg                ray_shadow_o,
    output reg                ray_primary_o,
    output reg [3*W-1:0]      ray_org_o,
    output reg [3*WD-1:0]     ray_dir_o,
    output reg [2*WD-1:0]     ray_a_o,
    output reg [24:0]         ray_skip_o,
    output reg [3*FW-1:0]     ray_forg_o,       // origin in filter units
    output reg [53:0]         ray_unit_o,
    output reg [1:0]          ray_axis_o,
    output reg                ray_negative_o,
    output reg [16:0]         ray_scale_o,      // u1.15
    output reg [5:0]          ray_shift_o,      // 63: no bound
    output reg [FW:0]         ray_depth_o,
    // tokens; a ray that is no shadow ray starts with ray_valid_o
    output wire               lamp_valid_o,     // the light of cosine_slot_o needs no shadow ray
    output wire               lamp_lit_o,
    output wire               shadow_go_o,      // the shadow ray of cosine_slot_o starts
    output reg                normal_valid_o,   // a surface is ready for its lights
    output reg [SLOTW-1:0]    normal_slot_o,
    output reg [3*WD-1:0]     normal_vec_o,
    output reg [2*WD-1:0]     normal_nn_o,
    // cosine of a light, with lamp_valid_o or shadow_go_o
    output wire               cosine_valid_o,
    output wire [SLOTW-1:0]   cosine_slot_o,
    output wire [15:0]        cosine_o
);
    localparam PRIMARY = 2'd0, LIGHT = 2'd1, BOUNCE = 2'd2, NORMAL = 2'd3;
    localparam K  = W - FW;

    // ---- choose a slot: queues of slots, their vectors in block RAM ----
    // Two units take a vector every second cycle each, in turn: a vector a cycle. Lights go to the
    // first only, so that they leave at the pace of rt_lambert.
    wire             nq_valid, lq_valid, bq_valid, nq_in, lq_in, bq_in;
    wire [1:0]       unit_ready;                     // never both
    wire [SLOTW-1:0] nq, lq, bq;
    reg              v_valid_q;
    reg [1:0]        v_kind_q;
    wire v_taken = v_valid_q && (unit_ready[0] || (unit_ready[1] && v_kind_q != LIGHT));
    wire v_load  = !v_valid_q || v_taken;
    wire take_n = v_load && nq_valid;
    wire take_l = v_load && !nq_valid && lq_valid;
    wire take_b = v_load && !nq_valid && !lq_valid && bq_valid;
    wire take_p = v_load && !nq_valid && !lq_valid && !bq_valid && primary_valid_i;
    assign primary_ready_o = v_load && !nq_valid && !lq_valid && !bq_valid;
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_normals (
        .clk(clk), .rst(rst), .in_valid_i(normal_valid_i), .in_ready_o(nq_in),
        .in_data_i(normal_slot_i),
        .out_valid_o(nq_valid), .out_ready_i(take_n), .out_data_o(nq)
    );
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_lights (
        .clk(clk), .rst(rst), .in_valid_i(light_valid_i), .in_ready_o(lq_in),
        .in_data_i(light_slot_i),
        .out_valid_o(lq_valid), .out_ready_i(take_l), .out_data_o(lq)
    );
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_bounces (
        .clk(clk), .rst(rst), .in_valid_i(bounce_valid_i), .in_ready_o(bq_in),
        .in_data_i(bounce_slot_i),
        .out_valid_o(bq_valid), .out_ready_i(take_b), .out_data_o(bq)
    );
    wire [3*WD-1:0] v_normal, v_light, v_bounce;
    rt_slot_ram #(.WIDTH(3*WD), .SLOTS(SLOTS), .OLD(0)) u_normal_vec (
        .clk(clk), .wr_en_i(normal_valid_i), .wr_addr_i(normal_slot_i),
        .wr_data_i(normal_vec_i),
        .rd_en_i(take_n), .rd_addr_i(nq), .rd_data_o(v_normal)
    );
    rt_slot_ram #(.WIDTH(3*WD), .SLOTS(SLOTS), .OLD(0)) u_light_vec (
        .clk(clk), .wr_en_i(light_valid_i), .wr_addr_i(light_slot_i), .wr_data_i(light_vec_i),
        .rd_en_i(take_l), .rd_addr_i(lq), .rd_data_o(v_light)
    );
    rt_slot_ram #(.WIDTH(3*WD), .SLOTS(SLOTS), .OLD(0)) u_bounce_vec (
        .clk(clk), .wr_en_i(bounce_valid_i), .wr_addr_i(bounce_slot_i),
        .wr_data_i(bounce_vec_i),
        .rd_en_i(take_b), .rd_addr_i(bq), .rd_data_o(v_bounce)
    );
    reg [SLOTW-1:0]  v_slot_q;
    reg [3*WD-1:0]   v_primary_q;
    always @(posedge clk) begin
        if (v_load) begin
            v_valid_q   <= take_n || take_l || take_b || take_p;
            v_kind_q    <= take_n ? NORMAL : take_l ? LIGHT : take_b ? BOUNCE : PRIMARY;
            v_slot_q    <= take_n ? nq : take_l ? lq : take_b ? bq : primary_slot_i;
            v_primary_q <= primary_vec_i;
        end
        if (rst) v_valid_q <= 1'b0;
    end
    wire [3*WD-1:0]  v_vec = v_kind_q == NORMAL ? v_normal : v_kind_q == LIGHT ? v_light
                             : v_kind_q == BOUNCE ? v_bounce : v_primary_q;

    // ---- unit vector ----
    localparam UW = SLOTW + 2 + 2*WD + 54 + 17 + 6;
    wire [1:0]       units_valid;
    wire [2*UW-1:0]  units;
    reg              rst_q;                          // puts the second unit one cycle behind
    always @(posedge clk) rst_q <= rst;
    genvar g;
    generate
        for (g = 0; g < 2; g = g + 1) begin : g_unit
            wire signed [17:0] x, y, z;
            rt_unit #(.BITS(WD), .TAG(SLOTW+2)) u_unit (
                .clk(clk), .rst(g == 0 ? rst : rst_q),
                .in_valid_i(v_valid_q && (g == 0 || v_kind_q != LIGHT)),
                .in_ready_o(unit_ready[g]), .in_tag_i({v_slot_q, v_kind_q}),
                .in_x_i($signed(v_vec[0 +: WD])), .in_y_i($signed(v_vec[WD +: WD])),
                .in_z_i($signed(v_vec[2*WD +: WD])),
                .out_valid_o(units_valid[g]), .out_tag_o(units[UW*g +: SLOTW+2]),
                .out_vv_o(units[UW*g + SLOTW+2 +: 2*WD]),
                .out_u_x_o(x), .out_u_y_o(y), .out_u_z_o(z),
                .out_y_o(units[UW*g + SLOTW+2+2*WD+54 +: 17]),
                .out_h_o(units[UW*g + SLOTW+2+2*WD+71 +: 6])
            );
            assign units[UW*g + SLOTW+2+2*WD +: 54] = {z, y, x};
        end
    endgenerate
    wire             u_valid = |units_valid;         // never both
    wire [SLOTW-1:0] u_slot;
    wire [1:0]       u_kind;
    wire [2*WD-1:0]  u_vv;
    wire signed [17:0] u_x, u_y, u_z;
    wire [16:0]      u_rsqrt;
    wire [5:0]       u_shift;
    assign {u_shift, u_rsqrt, u_z, u_y, u_x, u_vv, u_slot, u_kind} =
        units_valid[0] ? units[UW-1:0] : units[2*UW-1:UW];
    wire [3*WD-1:0] s1_vec;
    wire [3*W-1:0]  s1_point;
    wire [24:0]     s1_skip;
    rt_slot_ram #(.WIDTH(3*WD), .SLOTS(SLOTS), .OLD(0)) u_vec (
        .clk(clk), .wr_en_i(v_taken), .wr_addr_i(v_slot_q), .wr_data_i(v_vec),
        .rd_en_i(u_valid), .rd_addr_i(u_slot), .rd_data_o(s1_vec)
    );
    rt_slot_ram #(.WIDTH(3*W), .SLOTS(SLOTS), .OLD(0)) u_point (
        .clk(clk), .wr_en_i(point_valid_i), .wr_addr_i(point_slot_i), .wr_data_i(point_i),
        .rd_en_i(u_valid), .rd_addr_i(u_slot), .rd_data_o(s1_point)
    );
    rt_slot_ram #(.WIDTH(25), .SLOTS(SLOTS), .OLD(0)) u_skip (
        .clk(clk), .wr_en_i(skip_valid_i), .wr_addr_i(skip_slot_i), .wr_data_i(skip_i),
        .rd_en_i(u_valid), .rd_addr_i(u_slot), .rd_data_o(s1_skip)
    );

    // ---- stage 1: magnitudes, origin ----
    reg              s1_valid_q, s2_valid_q, s3_valid_q;
    reg [SLOTW-1:0]  s1_slot_q, s2_slot_q, s3_slot_q;
    reg [1:0]        s1_kind_q, s2_kind_q, s3_kind_q;
    reg [2*WD-1:0]   s1_vv_q, s2_vv_q, s3_vv_q;
    reg [53:0]       s1_unit_q, s2_unit_q, s3_unit_q;
    reg [16:0]       s1_mag_x_q, s1_mag_y_q, s1_mag_z_q, s1_rsqrt_q;   // u1.16
    reg [5:0]        s1_h_q;
    always @(posedge clk) begin
        s1_valid_q <= u_valid;
        s1_slot_q  <= u_slot;
        s1_kind_q  <= u_kind;
        s1_vv_q    <= u_vv;
        s1_unit_q  <= {u_z, u_y, u_x};
        s1_mag_x_q <= u_x[17] ? ~u_x[16:0] + 17'd1 : u_x[16:0];
        s1_mag_y_q <= u_y[17] ? ~u_y[16:0] + 17'd1 : u_y[16:0];
        s1_mag_z_q <= u_z[17] ? ~u_z[16:0] + 17'd1 : u_z[16:0];
        s1_rsqrt_q <= u_rsqrt;
        s1_h_q     <= u_shift;
        if (rst) s1_valid_q <= 1'b0;
    end
    wire [1:0] s1_axis = s1_mag_x_q >= s1_mag_y_q && s1_mag_x_q >= s1_mag_z_q ? 2'd0
                         : s1_mag_y_q >= s1_mag_z_q ? 2'd1 : 2'd2;
    wire [3*W-1:0] s1_org = s1_kind_q == PRIMARY ? eye_i : s1_point;

    // ---- stage 2: factors of the depth scale, filter origin ----
    reg [3*W-1:0]   s2_org_q, s3_org_q;
    reg [3*WD-1:0]  s2_vec_q, s3_vec_q;
    reg [24:0]      s2_skip_q, s3_skip_q;
    reg [3*FW-1:0]  s2_forg_q, s3_forg_q;
    reg [1:0]       s2_axis_q, s3_axis_q;
    reg             s2_negative_q, s3_negative_q;
    reg [16:0]      s2_mag_q, s2_recip_q;                // u1.16, u1.15
    reg [5:0]       s2_shift_q, s3_shift_q;
    reg [WD-1:0]    s2_span_q;                           // |dir| along the axis
    reg [33:0]      s3_prod_q;
    reg [FW:0]      s3_depth_q;
    localparam [31:0] FLAT = 30 - FW;                    // depth shift of an unshifted vector
    wire signed [WD-1:0] s1_along = $signed(
        s1_axis == 2'd0 ? s1_vec[0 +: WD] : s1_axis == 2'd1 ? s1_vec[WD +: WD]
        : s1_vec[2*WD +: WD]);
    wire [WD-1:0]   s2_units = s2_span_q >> K;
    localparam [FW:0] LIM = {(FW+1){1'b1}};
    genvar i;
    generate
        for (i = 0; i < 3; i = i + 1) begin : g_forg
            if (K == 0) begin : g_same
                always @(posedge clk) s2_forg_q[FW*i +: FW] <= s1_org[W*i +: W];
            end else begin : g_round
                wire [FW:0] up = {s1_org[W*i + W-1], s1_org[W*i + K +: FW]} +
                                 {{FW{1'b0}}, s1_org[W*i + K-1]};  // one bit more than fits
                always @(posedge clk)
                    s2_forg_q[FW*i +: FW] <= up[FW] != up[FW-1] ? {1'b0, {(FW-1){1'b1}}}
                                                               : up[FW-1:0];
            end
        end
    endgenerate
    always @(posedge clk) begin
        s2_valid_q    <= s1_valid_q;
        s2_slot_q     <= s1_slot_q;
        s2_kind_q     <= s1_kind_q;
        s2_vv_q       <= s1_vv_q;
        s2_unit_q     <= s1_unit_q;
        s2_org_q      <= s1_org;
        s2_vec_q      <= s1_vec;
        s2_skip_q     <= s1_kind_q == PRIMARY ? {1'b0, 24'hffffff} : s1_skip;
        s2_axis_q     <= s1_axis;
        s2_negative_q <= s1_axis == 2'd0 ? s1_unit_q[17] : s1_axis == 2'd1 ? s1_unit_q[35]
                         : s1_unit_q[53];
        s2_mag_q      <= (s1_axis == 2'd0 ? s1_mag_x_q : s1_axis == 2'd1 ? s1_mag_y_q
                          : s1_mag_z_q) + 17'd1;
        s2_recip_q    <= {1'b0, s1_rsqrt_q[16:1]} + `RT_RSQRT_ERROR + 17'd2;
        s2_shift_q    <= {26'd0, s1_h_q} > FLAT ? 6'd63 : FLAT[5:0] - s1_h_q;
        s2_span_q     <= s1_along[WD-1] ? ~s1_along + 1'b1 : s1_along;
        if (rst) s2_valid_q <= 1'b0;

        // ---- stage 3: product ----
        s3_valid_q    <= s2_valid_q;
        s3_slot_q     <= s2_slot_q;
        s3_kind_q     <= s2_kind_q;
        s3_vv_q       <= s2_vv_q;
        s3_unit_q     <= s2_unit_q;
        s3_org_q      <= s2_org_q;
        s3_vec_q      <= s2_vec_q;
        s3_skip_q     <= s2_skip_q;
        s3_forg_q     <= s2_forg_q;
        s3_axis_q     <= s2_axis_q;
        s3_negative_q <= s2_negative_q;
        s3_shift_q    <= s2_shift_q;
        s3_prod_q     <= s2_mag_q * s2_recip_q;
        s3_depth_q    <= s2_kind_q == LIGHT && s2_units < {{(WD-FW-1){1'b0}}, LIM}
                         ? s2_units[FW:0] + 1'b1 : LIM;
        if (rst) s3_valid_q <= 1'b0;

        // ---- stage 4: ray or normal ----
        ray_valid_o    <= s3_valid_q && s3_kind_q != NORMAL;
        ray_slot_o     <= s3_slot_q;
        ray_shadow_o   <= s3_kind_q == LIGHT;
        ray_primary_o  <= s3_kind_q == PRIMARY;
        ray_org_o      <= s3_org_q;
        ray_dir_o      <= s3_vec_q;
        ray_a_o        <= s3_vv_q;
        ray_skip_o     <= s3_skip_q;
        ray_forg_o     <= s3_forg_q;
        ray_unit_o     <= s3_unit_q;
        ray_axis_o     <= s3_axis_q;
        ray_negative_o <= s3_negative_q;
        ray_scale_o    <= s3_prod_q[32:16] + 17'd1;
        ray_shift_o    <= s3_shift_q;
        ray_depth_o    <= s3_depth_q;
        normal_valid_o <= s3_valid_q && s3_kind_q == NORMAL;
        normal_slot_o  <= s3_slot_q;
        normal_vec_o   <= s3_vec_q;
        normal_nn_o    <= s3_vv_q;
        if (rst) begin ray_valid_o <= 1'b0; normal_valid_o <= 1'b0; end
    end

    // ---- Lambert's cosine with the surface's unit normal; every ray passes, lights use it ----
    wire [53:0]      s4_normal;
    rt_slot_ram #(.WIDTH(54), .SLOTS(SLOTS), .OLD(0)) u_normal (
        .clk(clk), .wr_en_i(s3_valid_q && s3_kind_q == NORMAL), .wr_addr_i(s3_slot_q),
        .wr_data_i(s3_unit_q),
        .rd_en_i(s3_valid_q && s3_kind_q != NORMAL), .rd_addr_i(s3_slot_q), .rd_data_o(s4_normal)
    );
    wire             c_valid, c_ready;
    rt_lambert #(.TAG(SLOTW)) u_lambert (
        .clk(clk), .rst(rst),
        .in_valid_i(ray_valid_o && ray_shadow_o), .in_ready_o(c_ready), .in_tag_i(ray_slot_o),
        .in_normal_x_i($signed(s4_normal[17:0])), .in_normal_y_i($signed(s4_normal[35:18])),
        .in_normal_z_i($signed(s4_normal[53:36])),
        .in_light_x_i($signed(ray_unit_o[17:0])), .in_light_y_i($signed(ray_unit_o[35:18])),
        .in_light_z_i($signed(ray_unit_o[53:36])),
        .out_valid_o(c_valid), .out_tag_o(cosine_slot_o), .out_cosine_o(cosine_o)
    );
    wire c_dark  = cosine_o == 16'd0;
    wire c_trace = SHADOW != 0 && shadow_on_i && !c_dark;    // needs a shadow ray
    assign cosine_valid_o = c_valid;
    assign shadow_go_o    = c_valid && c_trace;
    assign lamp_valid_o   = c_valid && !c_trace;
    assign lamp_lit_o     = !c_dark;
    wire unused = &{1'b0, nq_in, lq_in, bq_in, c_ready, s3_prod_q[33], s3_prod_q[15:0],
                     s1_rsqrt_q[0]};
endmodule
`default_nettype wire
