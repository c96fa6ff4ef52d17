// rt_setup.v - ray set-up: unit vectors, origin, depth scale
// SPDX-License-Identifier: Apache-2.0
// A vector from one of four sources (surface normals go first, primary rays last) becomes a unit
// vector, and from that comes all that a ray carries. UNITS vectors go in within UNIT_INTERVAL
// clocks, but no light in the clock behind another; with ACROSS 2 no two rays either.
// Model: sph_ray_setup() in cmodel/trace/setup.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_setup #(
    parameter W       = 16, // coordinate, bits
    parameter WD      = 17, // direction component, bits
    parameter FW      = 14, // filter coordinate, bits
    parameter NG      = 2,  // guard bits of a hit point
    parameter SHADOW  = 1,  // 1: shadow rays are traced, 0: every light that is faced shines
    parameter LIGHTS  = 8,  // 0: no vectors to lights
    parameter BOUNCES = 1,  // 0: no mirrored or refracted directions
    parameter FACETS  = 0,  // 1: triangles and planes too
    parameter TEXTURE = 0,  // 1: textures need unit normals and the length of rays
    parameter ACROSS  = 1,  // clocks a ray's axes across it, 1 or 2; 0: none are asked for
    parameter UNITS   = 2,  // units for unit vectors, 1 or 2
    parameter UNIT_INTERVAL = 2, // clocks a vector of each, 2 or 4
    parameter LUTS    = 0,  // LUT cells that a block RAM is worth, rt_slot_ram
    parameter SHADES  = 1,  // shading units, power of two
    parameter SLOTS   = 32  // power of two
) (
    input  wire                       clk,
    input  wire                       rst,
    input  wire [3*W-1:0]             eye_i,          // register
    // from each rt_shade: normals, vectors to lights, directions of rays that leave a surface
    input  wire [SHADES*(`RT_VECTOR_BITS-$clog2(SHADES))-1:0] normal_i,
    input  wire [SHADES*(`RT_VECTOR_BITS-$clog2(SHADES))-1:0] light_i,
    input  wire [SHADES*(`RT_VECTOR_BITS-$clog2(SHADES))-1:0] bounce_i,
    //: {SLOT[SLOTW], VEC[3*WD], VALID}
    // from rt_slots: primary rays, which wait
    input  wire [`RT_VECTOR_BITS-1:0] primary_i,
    output wire                       primary_ready_o,
    // from each rt_shade: where secondary rays start, and on what
    input  wire [SHADES*(`RT_ORG_BITS-$clog2(SHADES))-1:0]  org_i,
    //: {SLOT[SLOTW], LIFT[3*(NG+2)], POINT[3*W], VALID}
    input  wire [SHADES*(`RT_SKIP_BITS-$clog2(SHADES))-1:0] skip_i,
    //: {SLOT[SLOTW], INSIDE, ID[24], VALID}
    // a ray, normal or light, to everyone who keeps a part of it
    output wire [`RT_RAY_BITS-1:0]    ray_o,
    //: {SLOT[SLOTW], H[6], Y[17], UNIT[54], INSIDE, SKIP[24], A[2*WD], DIR[3*WD], ORG[3*W], SHADOW,
    //: PRIMARY, LIGHT, NORMAL, VALID}
    output wire [`RT_FILTER_BITS-1:0] filter_o,
    //: {DEPTH[FW+1], SHIFT[6], SCALE[17], NEGATIVE, AXIS[2], ORG[3*FW]}
    output wire [`RT_ACROSS_BITS-1:0] across_o,       // `RT_ACROSS_BEHIND clocks behind, at most
    //: {SLOT[SLOTW], Q[54], P_B[18], P_A[18], LEAST[2], VALID}
    output wire [3*(NG+2)-1:0]        lift_o, // of one to a light, LIFT of org; with FACETS
    output wire                       next_light_o,   // ray_o has LIGHT in the next clock
    output wire [$clog2(SLOTS)-1:0]   next_slot_o     // of this slot
);
    localparam SLOTW = $clog2(SLOTS);
    localparam PRIMARY = 2'd0, LIGHT = 2'd1, BOUNCE = 2'd2, NORMAL = 2'd3;
    localparam SHADOWS   = LIGHTS != 0 && SHADOW != 0 ? 1 : 0;
    localparam NORMALS   = LIGHTS != 0 || BOUNCES != 0 || TEXTURE != 0 ? 1 : 0;
    localparam SECONDARY = SHADOWS != 0 || BOUNCES != 0 ? 1 : 0;  // not from the eye

    // ---- choose a vector ----
    localparam PHASES = SHADES > 1 && UNITS == 2 && (UNIT_INTERVAL == 2 || WD < 18) ? 1 : 0;
    wire             v_first;                         // the first unit for unit vectors may take
    wire             v_valid, v_ready, v_normal, v_light, v_bounce;
    wire [SLOTW-1:0] v_slot;
    wire [3*WD-1:0]  v_vec;
    wire [1:0]       v_kind  = v_normal ? NORMAL : v_light ? LIGHT : v_bounce ? BOUNCE : PRIMARY;
    rt_vectors #(.WD(WD), .NORMALS(NORMALS), .LIGHTS(LIGHTS), .BOUNCES(BOUNCES),
                 .SHADES(SHADES), .PHASES(PHASES), .SLOTS(SLOTS)) u_vectors (
        .clk(clk), .rst(rst),
        .normal_i(normal_i), .light_i(light_i), .bounce_i(bounce_i), .primary_i(primary_i),
        .primary_ready_o(primary_ready_o), .first_i(v_first),
        .out_valid_o(v_valid), .out_ready_i(v_ready),
        .out_normal_o(v_normal), .out_light_o(v_light), .out_bounce_o(v_bounce),
        .out_slot_o(v_slot), .out_vec_o(v_vec)
    );

    // ---- pace of rays, as their axes are made ----
    wire             v_go, v_taken;
    generate
        if (ACROSS == 2) begin : g_pace
            reg ray_taken_q;
            assign v_go = !ray_taken_q || v_normal;
            always @(posedge clk) ray_taken_q <= v_valid && v_ready && !v_normal;
        end else begin : g_any
            assign v_go = 1'b1;
        end
    endgenerate
    assign v_ready = v_taken && v_go;

    // ---- unit vector ----
    // Lights leave at the pace of rt_cosine, every second clock at most; those of every other
    // shading unit, which has its own, in the clocks between.
    wire [SLOTW+1:0]  v_shade = {2'd0, v_slot} >> (SLOTW - $clog2(SHADES));
    localparam KB     = NORMALS != 0 ? 2 : 0;         // bits of a kind
    wire [SLOTW+1:0]  v_tag = {v_slot, v_kind};
    wire              u_valid;
    wire [SLOTW+1:0]  u_tag;
    wire [SLOTW-1:0]  u_slot = u_tag[SLOTW+1:2];
    wire [1:0]        u_kind = u_tag[1:0];
    wire [2*WD-1:0]   u_vv;
    wire [53:0]       u_unit;
    wire [17:0]       u_x = u_unit[`RT_UNIT_X], u_y = u_unit[`RT_UNIT_Y], u_z = u_unit[`RT_UNIT_Z];
    wire [16:0]       u_rsqrt;
    wire [5:0]        u_shift;
    rt_units #(.BITS(WD), .TAG(SLOTW+KB), .UNITS(UNITS), .SPREADS(SHADES),
               .INTERVAL(UNIT_INTERVAL)) u_units (
        .clk(clk), .rst(rst),
        .in_valid_i(v_valid && v_go), .in_spread_i(v_light), .in_second_i(v_shade[0]),
        .in_ready_o(v_taken), .first_o(v_first),
        .in_tag_i(v_tag[SLOTW+1 -: SLOTW+KB]), .in_vec_i(v_vec),
        .out_valid_o(u_valid), .out_tag_o(u_tag[SLOTW+1 -: SLOTW+KB]), .out_vv_o(u_vv),
        .out_u_o(u_unit), .out_y_o(u_rsqrt), .out_h_o(u_shift)
    );
    generate if (KB == 0) begin : g_kind assign u_tag[1:0] = PRIMARY; end endgenerate
    wire [3*WD-1:0] s2_vec;
    reg              s1_valid_q, s2_valid_q, s3_valid_q, s4_valid_q;
    reg [SLOTW-1:0]  s1_slot_q, s2_slot_q, s3_slot_q, s4_slot_q;
    reg              w_valid_q;                       // a vector that was taken is kept
    reg [SLOTW-1:0]  w_slot_q;
    reg [3*WD-1:0]   w_vec_q;
    always @(posedge clk) begin
        w_valid_q <= v_valid && v_ready;
        if (v_valid) {w_slot_q, w_vec_q} <= {v_slot, v_vec};
    end
    rt_slot_ram #(.WIDTH(3*WD), .SLOTS(SLOTS), .OLD(0)) u_vec (
        .clk(clk), .wr_en_i(w_valid_q), .wr_addr_i(w_slot_q), .wr_data_i(w_vec_q),
        .rd_en_i(s1_valid_q), .rd_addr_i(s1_slot_q), .rd_data_o(s2_vec)
    );

    // ---- stage 1: magnitudes ----
    reg [1:0]        s1_kind_q, s2_kind_q, s3_kind_q, s4_kind_q;
    reg [2*WD-1:0]   s1_vv_q, s2_vv_q, s3_vv_q, s4_vv_q;
    reg [53:0]       s1_unit_q, s2_unit_q, s3_unit_q, s4_unit_q;
    reg [16:0]       s1_mag_x_q, s1_mag_y_q, s1_mag_z_q, s1_rsqrt_q;   // u1.16
    reg [16:0]       s2_mag_x_q, s2_mag_y_q, s2_mag_z_q, s2_rsqrt_q;
    reg [5:0]        s1_h_q, s2_h_q;
    reg [1:0]        s2_axis_q, s2_least_q;
    always @(posedge clk) begin
        s1_valid_q <= u_valid;
        if (u_valid) begin                           // so that nothing switches for nothing
            s1_slot_q  <= u_slot;
            s1_kind_q  <= u_kind;
            s1_vv_q    <= u_vv;
            s1_unit_q  <= {u_z, u_y, u_x};
            s1_mag_x_q <= u_x[17] ? ~u_x[16:0] + 17'd1 : u_x[16:0];
            s1_mag_y_q <= u_y[17] ? ~u_y[16:0] + 17'd1 : u_y[16:0];
            s1_mag_z_q <= u_z[17] ? ~u_z[16:0] + 17'd1 : u_z[16:0];
            s1_rsqrt_q <= u_rsqrt;
            s1_h_q     <= u_shift;
        end
        if (rst) s1_valid_q <= 1'b0;

        // ---- stage 2: axes of the largest and of the smallest ----
        s2_valid_q <= s1_valid_q;
        if (s1_valid_q) begin
            s2_slot_q  <= s1_slot_q;
            s2_kind_q  <= s1_kind_q;
            s2_vv_q    <= s1_vv_q;
            s2_unit_q  <= s1_unit_q;
            s2_mag_x_q <= s1_mag_x_q;
            s2_mag_y_q <= s1_mag_y_q;
            s2_mag_z_q <= s1_mag_z_q;
            s2_rsqrt_q <= s1_rsqrt_q;
            s2_h_q     <= s1_h_q;
            s2_axis_q  <= s1_mag_x_q >= s1_mag_y_q && s1_mag_x_q >= s1_mag_z_q ? 2'd0
                          : s1_mag_y_q >= s1_mag_z_q ? 2'd1 : 2'd2;
            s2_least_q <= s1_mag_x_q <= s1_mag_y_q && s1_mag_x_q <= s1_mag_z_q ? 2'd0
                          : s1_mag_y_q <= s1_mag_z_q ? 2'd1 : 2'd2;
        end
        if (rst) s2_valid_q <= 1'b0;
    end

    // ---- stage 3: factors of the depth scale ----
    reg              ray_valid_q, ray_normal_q, ray_light_q, ray_shadow_q, ray_primary_q;
    reg [SLOTW-1:0]  ray_slot_q;
    reg [3*WD-1:0]   ray_dir_q;
    reg [2*WD-1:0]   ray_a_q;
    reg [53:0]       ray_unit_q;
    reg [1:0]        ray_axis_q;
    reg              ray_negative_q;
    reg [16:0]       ray_scale_q;                    // u1.15
    reg [5:0]        ray_shift_q;                    // 63: no bound
    reg [3*WD-1:0]  s3_vec_q, s4_vec_q;
    reg [1:0]       s3_axis_q, s4_axis_q;
    reg             s3_negative_q, s4_negative_q;
    reg [16:0]      s3_mag_q, s3_recip_q;                // u1.16, u1.15
    reg [5:0]       s3_shift_q, s4_shift_q;
    reg [33:0]      s4_prod_q;
    localparam [31:0] FLAT = 30 - FW;                    // depth shift of an unshifted vector
    always @(posedge clk) begin
        s3_valid_q    <= s2_valid_q;
        if (s2_valid_q) begin
            s3_slot_q     <= s2_slot_q;
            s3_kind_q     <= s2_kind_q;
            s3_vv_q       <= s2_vv_q;
            s3_unit_q     <= s2_unit_q;
            s3_vec_q      <= s2_vec;
            s3_axis_q     <= s2_axis_q;
            s3_negative_q <= s2_axis_q == 2'd0 ? s2_unit_q[17] : s2_axis_q == 2'd1 ? s2_unit_q[35]
                             : s2_unit_q[53];
            s3_mag_q      <= (s2_axis_q == 2'd0 ? s2_mag_x_q : s2_axis_q == 2'd1 ? s2_mag_y_q
                              : s2_mag_z_q) + 17'd1;
            s3_recip_q    <= {1'b0, s2_rsqrt_q[16:1]} + `RT_RSQRT_ERROR + 17'd2;
            s3_shift_q    <= {26'd0, s2_h_q} > FLAT ? 6'd63 : FLAT[5:0] - s2_h_q;
        end
        if (rst) s3_valid_q <= 1'b0;

        // ---- stage 4: product ----
        s4_valid_q    <= s3_valid_q;
        if (s3_valid_q) begin
            s4_slot_q     <= s3_slot_q;
            s4_kind_q     <= s3_kind_q;
            s4_vv_q       <= s3_vv_q;
            s4_unit_q     <= s3_unit_q;
            s4_vec_q      <= s3_vec_q;
            s4_axis_q     <= s3_axis_q;
            s4_negative_q <= s3_negative_q;
            s4_shift_q    <= s3_shift_q;
            s4_prod_q     <= s3_mag_q * s3_recip_q;
        end
        if (rst) s4_valid_q <= 1'b0;

        // ---- stage 5: ray, normal or light ----
        ray_valid_q    <= s4_valid_q && s4_kind_q != NORMAL &&
                          (SHADOWS != 0 || s4_kind_q != LIGHT);
        ray_normal_q   <= s4_valid_q && s4_kind_q == NORMAL;
        ray_light_q    <= next_light_o;
        if (s4_valid_q) begin
            ray_slot_q     <= s4_slot_q;
            ray_shadow_q   <= SHADOWS != 0 && s4_kind_q == LIGHT;
            ray_primary_q  <= s4_kind_q == PRIMARY;
            ray_dir_q      <= s4_vec_q;
            ray_a_q        <= s4_vv_q;
            ray_unit_q     <= s4_unit_q;
            ray_axis_q     <= s4_axis_q;
            ray_negative_q <= s4_negative_q;
            ray_scale_q    <= s4_prod_q[32:16] + 17'd1;
            ray_shift_q    <= s4_shift_q;
        end
        if (rst) begin
            ray_valid_q <= 1'b0; ray_normal_q <= 1'b0; ray_light_q <= 1'b0;
        end
    end
    assign next_light_o = LIGHTS != 0 && s4_valid_q && s4_kind_q == LIGHT;
    assign next_slot_o  = s4_slot_q;
    assign ray_o[`RT_RAY_VALID]       = ray_valid_q;
    assign ray_o[`RT_RAY_NORMAL]      = ray_normal_q;
    assign ray_o[`RT_RAY_LIGHT]       = ray_light_q;
    assign ray_o[`RT_RAY_SLOT]        = ray_slot_q;
    assign ray_o[`RT_RAY_PRIMARY]     = ray_primary_q;
    assign ray_o[`RT_RAY_SHADOW]      = ray_shadow_q;
    assign ray_o[`RT_RAY_DIR]         = ray_dir_q;
    assign ray_o[`RT_RAY_A]           = ray_a_q;
    assign ray_o[`RT_RAY_UNIT]        = ray_unit_q;
    assign filter_o[`RT_FILTER_AXIS]  = ray_axis_q;
    assign filter_o[`RT_FILTER_NEGATIVE] = ray_negative_q;
    assign filter_o[`RT_FILTER_SCALE] = ray_scale_q;
    assign filter_o[`RT_FILTER_SHIFT] = ray_shift_q;

    // ---- axes across the ray ----
    wire             s2_ray = s2_valid_q && s2_kind_q != NORMAL;
    wire             s2_at_x = s2_least_q == 2'd0, s2_at_y = s2_least_q == 2'd1;
    wire [17:0]      s2_x = s2_unit_q[`RT_UNIT_X], s2_y = s2_unit_q[`RT_UNIT_Y],
                     s2_z = s2_unit_q[`RT_UNIT_Z];
    wire [53:0]      s2_turned = {s2_at_x ? s2_x : s2_at_y ? s2_y : s2_z,
                                  s2_at_x || s2_at_y ? s2_z : s2_y, s2_at_x ? s2_y : s2_x};
    wire [15:0]      s2_mag = s2_at_x ? s2_mag_x_q[15:0] : s2_at_y ? s2_mag_y_q[15:0]
                              : s2_mag_z_q[15:0];     // below 1/sqrt(3) + 2^-16
    generate
        if (ACROSS == 1) begin : g_across_one
            rt_across_one #(.TAG(SLOTW)) u_across (
                .clk(clk), .rst(rst), .in_valid_i(s2_ray), .in_tag_i(s2_slot_q),
                .in_u_i(s2_turned), .in_mag_i(s2_mag), .in_least_i(s2_least_q),
                .out_valid_o(across_o[`RT_ACROSS_VALID]), .out_tag_o(across_o[`RT_ACROSS_SLOT]),
                .out_least_o(across_o[`RT_ACROSS_LEAST]), .out_p_a_o(across_o[`RT_ACROSS_P_A]),
                .out_p_b_o(across_o[`RT_ACROSS_P_B]), .out_q_o(across_o[`RT_ACROSS_Q])
            );
        end else if (ACROSS == 2) begin : g_across
            rt_across #(.TAG(SLOTW)) u_across (
                .clk(clk), .rst(rst), .in_valid_i(s2_ray), .in_tag_i(s2_slot_q),
                .in_u_i(s2_turned), .in_mag_i(s2_mag), .in_least_i(s2_least_q),
                .out_valid_o(across_o[`RT_ACROSS_VALID]), .out_tag_o(across_o[`RT_ACROSS_SLOT]),
                .out_least_o(across_o[`RT_ACROSS_LEAST]), .out_p_a_o(across_o[`RT_ACROSS_P_A]),
                .out_p_b_o(across_o[`RT_ACROSS_P_B]), .out_q_o(across_o[`RT_ACROSS_Q])
            );
        end else begin : g_no_across
            assign across_o = {`RT_ACROSS_BITS{1'b0}};
            wire unused = &{1'b0, s2_ray, s2_mag, s2_turned, s2_least_q};
        end
    endgenerate

    // ---- origin: read so that it is there with the ray ----
    rt_origin #(.W(W), .FW(FW), .NG(NG), .LIFTS(FACETS != 0 && SHADOWS != 0 ? 1 : 0),
                .SECONDARY(SECONDARY), .LUTS(LUTS), .SHADES(SHADES), .SLOTS(SLOTS)) u_origin (
        .clk(clk), .eye_i(eye_i), .org_i(org_i), .skip_i(skip_i),
        .read_i(s3_valid_q && s3_kind_q != NORMAL), .slot_i(s3_slot_q),
        .primary_i(s3_kind_q == PRIMARY),
        .org_o(ray_o[`RT_RAY_ORG]), .skip_o({ray_o[`RT_RAY_INSIDE], ray_o[`RT_RAY_SKIP]}),
        .lift_o(lift_o), .forg_o(filter_o[`RT_FILTER_ORG])
    );

    // ---- depth at the start: that of the light to which a ray goes (RT_RAY_SHADOW) ----
    localparam [FW:0] LIM = {(FW+1){1'b1}};
    generate
        if (SHADOWS != 0) begin : g_depth
            reg [WD-1:0]  s3_span_q;                     // |dir| along the axis
            reg [FW:0]    s4_depth_q, depth_q;
            wire signed [WD-1:0] s2_along = $signed(
                s2_axis_q == 2'd0 ? s2_vec[`RT_VEC_X] : s2_axis_q == 2'd1 ? s2_vec[`RT_VEC_Y]
                : s2_vec[`RT_VEC_Z]);
            wire [WD-1:0] s3_units = s3_span_q >> (W - FW);
            always @(posedge clk) begin
                if (s2_valid_q) s3_span_q <= s2_along[WD-1] ? ~s2_along + 1'b1 : s2_along;
                if (s3_valid_q)
                    s4_depth_q <= s3_kind_q == LIGHT && s3_units < {{(WD-FW-1){1'b0}}, LIM}
                                  ? s3_units[FW:0] + 1'b1 : LIM;
                if (s4_valid_q) depth_q <= s4_depth_q;
            end
            assign filter_o[`RT_FILTER_DEPTH] = depth_q;
        end else begin : g_unbounded
            assign filter_o[`RT_FILTER_DEPTH] = LIM;
        end
    endgenerate

    // ---- 1 / |dir|, from which a texture learns how long the ray is ----
    generate
        if (TEXTURE != 0) begin : g_length
            rt_delay #(.WIDTH(23), .CYCLES(3)) u_length (
                .clk(clk), .in_i({s2_h_q, s2_rsqrt_q}), .out_o({ray_o[`RT_RAY_H], ray_o[`RT_RAY_Y]})
            );
        end else begin : g_no_length
            assign {ray_o[`RT_RAY_H], ray_o[`RT_RAY_Y]} = 23'd0;
        end
    endgenerate

    wire unused = &{1'b0, v_tag, v_shade, s2_vec, s4_prod_q[33], s4_prod_q[15:0], s2_rsqrt_q[0]};
endmodule
`default_nettype wire
