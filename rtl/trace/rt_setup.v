// rt_setup.v - ray set-up: unit vectors, depth scale and Lambert's cosine
// SPDX-License-Identifier: Apache-2.0
// Takes directions from four sources (surface normals first, primary rays last), makes each a unit
// vector, and from that all a ray carries. Rays towards a light meet the surface's unit normal:
// those that face away never start. One vector a cycle, a light every second cycle; where only
// primary rays come, one every second cycle.
// Model: sph_ray_setup() in cmodel/trace/setup.c, sph_lambert() in cmodel/shade/colour.c
`default_nettype none
`include "rt_layout.vh"
module rt_setup #(
    parameter W       = 16, // coordinate, bits
    parameter WD      = 17, // direction component, bits
    parameter FW      = 14, // filter coordinate, bits
    parameter SHADOW  = 1, // 1: shadow rays are traced, 0: every light that is faced shines
    parameter LIGHTS  = 8, // 0: no vectors to lights and no cosines
    parameter BOUNCES = 1, // 0: no mirrored directions
    parameter TEXTURE = 0, // 1: textures need unit normals and the length of rays
    parameter SLOTS   = 32, // power of two
    parameter SLOTW   = 5   // log2 of SLOTS
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
    output wire [3*W-1:0]     ray_org_o,
    output reg [3*WD-1:0]     ray_dir_o,
    output reg [2*WD-1:0]     ray_a_o,
    output wire [24:0]        ray_skip_o,
    output wire [3*FW-1:0]    ray_forg_o,       // origin in filter units
    output reg [53:0]         ray_unit_o,
    output reg [1:0]          ray_axis_o,
    output reg                ray_negative_o,
    output reg [16:0]         ray_scale_o,      // u1.15
    output reg [5:0]          ray_shift_o,      // 63: no bound
    output wire [FW:0]        ray_depth_o,
    output wire [16:0]        ray_y_o,          // u1.16, of ray_unit_o: with TEXTURE
    output wire [5:0]         ray_h_o,
    // tokens; a ray that is no shadow ray starts with ray_valid_o
    output wire               lamp_valid_o,     // the light of cosine_slot_o needs no shadow ray
    output wire               lamp_lit_o,
    output wire               shadow_go_o,      // the shadow ray of cosine_slot_o starts
    output reg                normal_valid_o,   // a surface is ready for its lights
    output reg [SLOTW-1:0]    normal_slot_o,
    output reg [3*WD-1:0]     normal_vec_o,
    output reg [2*WD-1:0]     normal_nn_o,
    output wire               light_valid_o,    // ray_unit_o is that to a light
    // cosine of a light, with lamp_valid_o or shadow_go_o
    output wire               cosine_valid_o,
    output wire [SLOTW-1:0]   cosine_slot_o,
    output wire [15:0]        cosine_o
);
    localparam PRIMARY = 2'd0, LIGHT = 2'd1, BOUNCE = 2'd2, NORMAL = 2'd3;
    localparam SHADOWS   = LIGHTS != 0 && SHADOW != 0 ? 1 : 0;
    localparam NORMALS   = LIGHTS != 0 || BOUNCES != 0 || TEXTURE != 0 ? 1 : 0;
    localparam SECONDARY = SHADOWS != 0 || BOUNCES != 0 ? 1 : 0;  // not from the eye

    // ---- choose a vector ----
    wire             v_valid, v_ready, v_normal, v_light, v_bounce;
    wire [SLOTW-1:0] v_slot;
    wire [3*WD-1:0]  v_vec;
    wire [1:0]       v_kind  = v_normal ? NORMAL : v_light ? LIGHT : v_bounce ? BOUNCE : PRIMARY;
    rt_vectors #(.WD(WD), .NORMALS(NORMALS), .LIGHTS(LIGHTS), .BOUNCES(BOUNCES), .SLOTS(SLOTS),
                 .SLOTW(SLOTW)) u_vectors (
        .clk(clk), .rst(rst),
        .normal_valid_i(normal_valid_i), .normal_slot_i(normal_slot_i),
        .normal_vec_i(normal_vec_i),
        .light_valid_i(light_valid_i), .light_slot_i(light_slot_i), .light_vec_i(light_vec_i),
        .bounce_valid_i(bounce_valid_i), .bounce_slot_i(bounce_slot_i),
        .bounce_vec_i(bounce_vec_i),
        .primary_valid_i(primary_valid_i), .primary_ready_o(primary_ready_o),
        .primary_slot_i(primary_slot_i), .primary_vec_i(primary_vec_i),
        .out_valid_o(v_valid), .out_ready_i(v_ready),
        .out_normal_o(v_normal), .out_light_o(v_light), .out_bounce_o(v_bounce),
        .out_slot_o(v_slot), .out_vec_o(v_vec)
    );

    // ---- unit vector ----
    // Two units, a vector a cycle. Lights go to the first only, so that they leave at the pace of
    // rt_lambert. Primary rays alone, of one kind, do with one unit.
    localparam UNITS = NORMALS != 0 ? 2 : 1;
    localparam KB    = NORMALS != 0 ? 2 : 0;         // bits of a kind
    wire [SLOTW+1:0]  v_tag = {v_slot, v_kind};
    wire              u_valid;
    wire [SLOTW+1:0]  u_tag;
    wire [SLOTW-1:0]  u_slot = u_tag[SLOTW+1:2];
    wire [1:0]        u_kind = u_tag[1:0];
    wire [2*WD-1:0]   u_vv;
    wire [53:0]       u_unit;
    wire [17:0]       u_x = u_unit[17:0], u_y = u_unit[35:18], u_z = u_unit[53:36];
    wire [16:0]       u_rsqrt;
    wire [5:0]        u_shift;
    rt_units #(.BITS(WD), .TAG(SLOTW+KB), .UNITS(UNITS)) u_units (
        .clk(clk), .rst(rst),
        .in_valid_i(v_valid), .in_first_i(v_light), .in_ready_o(v_ready),
        .in_tag_i(v_tag[SLOTW+1 -: SLOTW+KB]), .in_vec_i(v_vec),
        .out_valid_o(u_valid), .out_tag_o(u_tag[SLOTW+1 -: SLOTW+KB]), .out_vv_o(u_vv),
        .out_u_o(u_unit), .out_y_o(u_rsqrt), .out_h_o(u_shift)
    );
    generate if (KB == 0) begin : g_kind assign u_tag[1:0] = PRIMARY; end endgenerate
    wire [3*WD-1:0] s1_vec;
    rt_slot_ram #(.WIDTH(3*WD), .SLOTS(SLOTS), .OLD(0)) u_vec (
        .clk(clk), .wr_en_i(v_valid && v_ready), .wr_addr_i(v_slot), .wr_data_i(v_vec),
        .rd_en_i(u_valid), .rd_addr_i(u_slot), .rd_data_o(s1_vec)
    );

    // ---- stage 1: magnitudes ----
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

    // ---- stage 2: factors of the depth scale ----
    reg [3*WD-1:0]  s2_vec_q, s3_vec_q;
    reg [1:0]       s2_axis_q, s3_axis_q;
    reg             s2_negative_q, s3_negative_q;
    reg [16:0]      s2_mag_q, s2_recip_q;                // u1.16, u1.15
    reg [5:0]       s2_shift_q, s3_shift_q;
    reg [33:0]      s3_prod_q;
    localparam [31:0] FLAT = 30 - FW;                    // depth shift of an unshifted vector
    always @(posedge clk) begin
        s2_valid_q    <= s1_valid_q;
        s2_slot_q     <= s1_slot_q;
        s2_kind_q     <= s1_kind_q;
        s2_vv_q       <= s1_vv_q;
        s2_unit_q     <= s1_unit_q;
        s2_vec_q      <= s1_vec;
        s2_axis_q     <= s1_axis;
        s2_negative_q <= s1_axis == 2'd0 ? s1_unit_q[17] : s1_axis == 2'd1 ? s1_unit_q[35]
                         : s1_unit_q[53];
        s2_mag_q      <= (s1_axis == 2'd0 ? s1_mag_x_q : s1_axis == 2'd1 ? s1_mag_y_q
                          : s1_mag_z_q) + 17'd1;
        s2_recip_q    <= {1'b0, s1_rsqrt_q[16:1]} + `RT_RSQRT_ERROR + 17'd2;
        s2_shift_q    <= {26'd0, s1_h_q} > FLAT ? 6'd63 : FLAT[5:0] - s1_h_q;
        if (rst) s2_valid_q <= 1'b0;

        // ---- stage 3: product ----
        s3_valid_q    <= s2_valid_q;
        s3_slot_q     <= s2_slot_q;
        s3_kind_q     <= s2_kind_q;
        s3_vv_q       <= s2_vv_q;
        s3_unit_q     <= s2_unit_q;
        s3_vec_q      <= s2_vec_q;
        s3_axis_q     <= s2_axis_q;
        s3_negative_q <= s2_negative_q;
        s3_shift_q    <= s2_shift_q;
        s3_prod_q     <= s2_mag_q * s2_recip_q;
        if (rst) s3_valid_q <= 1'b0;

        // ---- stage 4: ray or normal ----
        ray_valid_o    <= s3_valid_q && s3_kind_q != NORMAL &&
                          (SHADOWS != 0 || s3_kind_q != LIGHT);
        ray_slot_o     <= s3_slot_q;
        ray_shadow_o   <= SHADOWS != 0 && s3_kind_q == LIGHT;
        ray_primary_o  <= s3_kind_q == PRIMARY;
        ray_dir_o      <= s3_vec_q;
        ray_a_o        <= s3_vv_q;
        ray_unit_o     <= s3_unit_q;
        ray_axis_o     <= s3_axis_q;
        ray_negative_o <= s3_negative_q;
        ray_scale_o    <= s3_prod_q[32:16] + 17'd1;
        ray_shift_o    <= s3_shift_q;
        normal_valid_o <= s3_valid_q && s3_kind_q == NORMAL;
        normal_slot_o  <= s3_slot_q;
        normal_vec_o   <= s3_vec_q;
        normal_nn_o    <= s3_vv_q;
        if (rst) begin ray_valid_o <= 1'b0; normal_valid_o <= 1'b0; end
    end

    // ---- origin: read so that it is there with the ray ----
    rt_origin #(.W(W), .FW(FW), .SECONDARY(SECONDARY), .SLOTS(SLOTS), .SLOTW(SLOTW)) u_origin (
        .clk(clk), .eye_i(eye_i),
        .point_valid_i(point_valid_i), .point_slot_i(point_slot_i), .point_i(point_i),
        .skip_valid_i(skip_valid_i), .skip_slot_i(skip_slot_i), .skip_i(skip_i),
        .read_i(s2_valid_q && s2_kind_q != NORMAL), .slot_i(s2_slot_q),
        .primary_i(s2_kind_q == PRIMARY),
        .org_o(ray_org_o), .skip_o(ray_skip_o), .forg_o(ray_forg_o)
    );

    // ---- depth at the start: a shadow ray ends at its light ----
    localparam [FW:0] LIM = {(FW+1){1'b1}};
    generate
        if (SHADOWS != 0) begin : g_depth
            reg [WD-1:0]  s2_span_q;                     // |dir| along the axis
            reg [FW:0]    s3_depth_q, depth_q;
            wire signed [WD-1:0] s1_along = $signed(
                s1_axis == 2'd0 ? s1_vec[0 +: WD] : s1_axis == 2'd1 ? s1_vec[WD +: WD]
                : s1_vec[2*WD +: WD]);
            wire [WD-1:0] s2_units = s2_span_q >> (W - FW);
            always @(posedge clk) begin
                s2_span_q  <= s1_along[WD-1] ? ~s1_along + 1'b1 : s1_along;
                s3_depth_q <= s2_kind_q == LIGHT && s2_units < {{(WD-FW-1){1'b0}}, LIM}
                              ? s2_units[FW:0] + 1'b1 : LIM;
                depth_q    <= s3_depth_q;
            end
            assign ray_depth_o = depth_q;
        end else begin : g_unbounded
            assign ray_depth_o = LIM;
        end
    endgenerate

    // ---- 1 / |dir|, from which a texture learns how long the ray is ----
    generate
        if (TEXTURE != 0) begin : g_length
            rt_delay #(.WIDTH(23), .CYCLES(3)) u_length (
                .clk(clk), .in_i({s1_h_q, s1_rsqrt_q}), .out_o({ray_h_o, ray_y_o})
            );
        end else begin : g_no_length
            assign {ray_h_o, ray_y_o} = 23'd0;
        end
    endgenerate

    // ---- Lambert's cosine with the surface's unit normal ----
    generate
        if (LIGHTS != 0) begin : g_cosine
            wire [53:0] s4_normal;
            reg         s4_light_q;
            wire        c_valid, c_ready;
            wire        c_dark  = cosine_o == 16'd0;
            wire        c_trace = SHADOW != 0 && shadow_on_i && !c_dark;  // needs a shadow ray
            rt_slot_ram #(.WIDTH(54), .SLOTS(SLOTS), .OLD(0)) u_normal (
                .clk(clk), .wr_en_i(s3_valid_q && s3_kind_q == NORMAL), .wr_addr_i(s3_slot_q),
                .wr_data_i(s3_unit_q),
                .rd_en_i(s3_valid_q && s3_kind_q == LIGHT), .rd_addr_i(s3_slot_q),
                .rd_data_o(s4_normal)
            );
            always @(posedge clk) begin
                s4_light_q <= s3_valid_q && s3_kind_q == LIGHT;
                if (rst) s4_light_q <= 1'b0;
            end
            rt_lambert #(.TAG(SLOTW)) u_lambert (
                .clk(clk), .rst(rst),
                .in_valid_i(s4_light_q), .in_ready_o(c_ready), .in_tag_i(ray_slot_o),
                .in_normal_x_i($signed(s4_normal[17:0])),
                .in_normal_y_i($signed(s4_normal[35:18])),
                .in_normal_z_i($signed(s4_normal[53:36])),
                .in_light_x_i($signed(ray_unit_o[17:0])),
                .in_light_y_i($signed(ray_unit_o[35:18])),
                .in_light_z_i($signed(ray_unit_o[53:36])),
                .out_valid_o(c_valid), .out_tag_o(cosine_slot_o), .out_cosine_o(cosine_o)
            );
            assign light_valid_o  = s4_light_q;
            assign cosine_valid_o = c_valid;
            assign shadow_go_o    = c_valid && c_trace;
            assign lamp_valid_o   = c_valid && !c_trace;
            assign lamp_lit_o     = !c_dark;
            wire unused = c_ready;
        end else begin : g_dark
            assign {cosine_valid_o, shadow_go_o, lamp_valid_o, lamp_lit_o} = 4'b0000;
            assign light_valid_o  = 1'b0;
            assign cosine_slot_o = {SLOTW{1'b0}};
            assign cosine_o      = 16'd0;
            wire unused = shadow_on_i;
        end
    endgenerate
    wire unused = &{1'b0, v_tag, s1_vec, s3_prod_q[33], s3_prod_q[15:0], s1_rsqrt_q[0]};
endmodule
`default_nettype wire
