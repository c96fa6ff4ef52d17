// rt_shares.v - blends by shares: what of a pixel each of its rays decides, and its three frames
// SPDX-License-Identifier: Apache-2.0
// Takes the place of rt_blends in a core that refracts or has materials with sum. The ray of a slot
// has a weight and a depth; frames are sums, so that rays may come in any order.
// read_i reads what belongs to the surface that enters one cycle later.
// Model: path(), shade() in cmodel/engine/render_pixel.c, sph_shares_add() in cmodel/shade/colour.c
`default_nettype none
module rt_shares #(
    parameter W        = 16,  // coordinate, bits
    parameter WD       = 17,  // direction component, bits
    parameter PR       = 0,   // significant bits of the root, 0: all
    parameter REFLECT  = 5,   // effects elaborated, see rt_core
    parameter REFRACT  = 1,
    parameter SPECULAR = 1,
    parameter SUM      = 1,
    parameter MIRRORS  = 1,   // 0: no mirror rays
    parameter PROBE    = 0,   // 1: some surfaces are probed (INTERPENETRATE)
    parameter PATHS    = 0,   // 1: waiting rays keep the length of their path (TEXTURE)
    parameter SLOTS    = 32,  // power of two
    parameter SLOTW    = 5    // log2 of SLOTS
) (
    input  wire             clk,
    input  wire             rst,
    // registers
    input  wire [3:0]       on_i,             // run-time: {SUM, SPECULAR, REFRACT, REFLECT}
    input  wire [2:0]       max_depth_i,
    input  wire [47:0]      ambient_i,        // 3 x u1.15, red low
    // what rays need: from rt_setup, rt_surface, rt_texture
    input  wire             ray_valid_i,
    input  wire [SLOTW-1:0] ray_slot_i,
    input  wire [3*WD-1:0]  ray_dir_i,
    input  wire [2*WD-1:0]  ray_a_i,
    input  wire             normal_valid_i,
    input  wire [SLOTW-1:0] normal_slot_i,
    input  wire [3*WD-1:0]  normal_vec_i,
    input  wire [2*WD-1:0]  normal_nn_i,
    input  wire             hit_valid_i,
    input  wire [SLOTW-1:0] hit_slot_i,
    input  wire             hit_far_i,
    input  wire [23:0]      hit_id_i,
    input  wire             point_valid_i,
    input  wire [SLOTW-1:0] point_slot_i,
    input  wire [3*W-1:0]   point_i,
    input  wire             path_valid_i,
    input  wire [SLOTW-1:0] path_slot_i,
    input  wire [W+7:0]     path_i,
    // the rest of the material; light, as highlights
    input  wire             look_valid_i,
    input  wire [SLOTW-1:0] look_slot_i,
    input  wire [59:0]      look_i,           // {index, power, ks, kd, ka, sum, kt}
    input  wire             gloss_valid_i,
    input  wire [SLOTW-1:0] gloss_slot_i,
    input  wire [50:0]      gloss_i,          // 3 x u2.15
    // a surface, or the background behind a ray
    input  wire             read_i,
    input  wire [SLOTW-1:0] read_slot_i,
    input  wire             in_first_i,       // what the pixel sees itself; one cycle after read_i
    input  wire             in_valid_i,
    output wire             in_ready_o,
    input  wire [SLOTW-1:0] in_slot_i,
    input  wire [50:0]      in_light_i,       // 3 x u2.15, red low
    input  wire [23:0]      in_albedo_i,      // 0xBBGGRR
    input  wire             in_background_i,  // nothing hit: albedo is the colour
    input  wire [8:0]       in_kr_i,          // u1.8, 0..256, share of the reflection
    input  wire             in_probe_i,       // to be probed
    // it is blended; its pixel is complete
    output wire             out_valid_o,      // one cycle
    output wire [SLOTW-1:0] out_slot_o,
    output wire             out_last_o,       // no ray leaves it
    output wire             out_probe_o,
    output wire             end_valid_o,
    output wire [SLOTW-1:0] end_slot_o,
    // mirrored and refracted rays, to rt_setup
    output wire             ray_valid_o,
    output wire [SLOTW-1:0] ray_slot_o,
    output wire [3*WD-1:0]  ray_vec_o,
    output wire [1:0]       count_o,          // {refracted, reflected}: one goes
    // where a refracted ray starts, with ray_valid_o, to where that is kept
    output wire             back_valid_o,
    input  wire             back_ready_i,
    output wire [3*W-1:0]   back_point_o,
    output wire [24:0]      back_skip_o,      // {inside, id}
    output wire [W+7:0]     back_path_o,
    // frames of a slot, one cycle after
    input  wire             frames_read_i,
    input  wire [SLOTW-1:0] frames_slot_i,
    output wire [71:0]      frames_o          // L2, L1, Rendering
);
    localparam TAG = SLOTW + 6;               // {refract, mirror, probe, depth, slot}

    // ---- the ray that found it, the pixel so far, the material ----
    wire [143:0]     frames, sums;
    wire [19:0]      state;                   // {depth, weight}
    wire [35:0]      look;                    // {ks, kd, ka, sum, kt}
    wire [50:0]      gloss;
    wire             next_valid;
    wire [SLOTW-1:0] next_slot;
    wire [19:0]      next_state;
    rt_slot_ram #(.WIDTH(144), .SLOTS(SLOTS), .OLD(0)) u_sums (
        .clk(clk), .wr_en_i(out_valid_o), .wr_addr_i(out_slot_o), .wr_data_i(sums),
        .rd_en_i(read_i), .rd_addr_i(read_slot_i), .rd_data_o(frames)
    );
    rt_slot_ram #(.WIDTH(20), .SLOTS(SLOTS), .OLD(0)) u_state (
        .clk(clk), .wr_en_i(next_valid), .wr_addr_i(next_slot), .wr_data_i(next_state),
        .rd_en_i(read_i), .rd_addr_i(read_slot_i), .rd_data_o(state)
    );
    rt_slot_ram #(.WIDTH(36), .SLOTS(SLOTS), .OLD(0)) u_look (
        .clk(clk), .wr_en_i(look_valid_i), .wr_addr_i(look_slot_i), .wr_data_i(look_i[35:0]),
        .rd_en_i(read_i), .rd_addr_i(read_slot_i), .rd_data_o(look)
    );
    generate
        if (SPECULAR != 0) begin : g_gloss
            rt_slot_ram #(.WIDTH(51), .SLOTS(SLOTS), .OLD(0)) u_gloss (
                .clk(clk), .wr_en_i(gloss_valid_i), .wr_addr_i(gloss_slot_i), .wr_data_i(gloss_i),
                .rd_en_i(read_i), .rd_addr_i(read_slot_i), .rd_data_o(gloss)
            );
        end else begin : g_matt
            assign gloss = 51'd0;
            wire unused = &{1'b0, gloss_valid_i, gloss_slot_i, gloss_i};
        end
    endgenerate

    // ---- shares ----
    wire [2:0]       depth  = in_first_i ? 3'd0 : state[19:17];
    wire [16:0]      weight = in_first_i ? 17'h10000 : state[16:0];
    wire             rays   = !in_background_i && depth != max_depth_i;
    wire [8:0]       kr     = REFLECT != 0 && on_i[0] && rays ? in_kr_i : 9'd0;
    wire [8:0]       kt     = REFRACT != 0 && on_i[1] && rays ? look[8:0] : 9'd0;
    wire [TAG-1:0]   tag;
    wire [16:0]      w_mirror, w_refract, w_total;
    rt_share #(.SUM(SUM), .SPECULAR(SPECULAR), .TAG(TAG)) u_share (
        .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .in_ready_o(in_ready_o),
        .in_tag_i({kt != 9'd0, kr != 9'd0, in_probe_i, depth, in_slot_i}),
        .in_background_i(in_background_i), .in_ambient_i(ambient_i), .in_lights_i(in_light_i),
        .in_gloss_i(gloss), .in_albedo_i(in_albedo_i), .in_sum_i(on_i[3] && look[9]),
        .in_ka_i(look[18:10]), .in_kd_i(look[27:19]), .in_ks_i(on_i[2] ? look[35:28] : 8'd0),
        .in_kr_i(kr), .in_kt_i(kt), .in_weight_i(weight),
        .in_depth_i(depth[2:1] != 2'd0 ? 2'd2 : depth[1:0]),
        .in_frames_i(in_first_i ? 144'd0 : frames),
        .out_valid_o(out_valid_o), .out_tag_o(tag), .out_frames_o(sums),
        .out_mirror_o(w_mirror), .out_refract_o(w_refract), .out_total_o(w_total)
    );
    wire             t_refract = REFRACT != 0 && tag[TAG-1];
    wire             t_mirror  = MIRRORS != 0 && tag[TAG-2];
    wire [2:0]       t_depth   = tag[SLOTW +: 3];
    assign out_slot_o  = tag[SLOTW-1:0];
    assign out_probe_o = PROBE != 0 && tag[TAG-3];
    assign out_last_o  = !t_mirror && !t_refract;

    // ---- bytes of the frames: half up, limited ----
    wire [71:0]      bytes;
    genvar i;
    generate
        for (i = 0; i < 9; i = i + 1) begin : g_byte
            wire [8:0] up = {1'b0, sums[16*i+8 +: 8]} + {8'd0, sums[16*i+7]};
            assign bytes[8*i +: 8] = up[8] ? 8'd255 : up[7:0];
        end
    endgenerate
    rt_slot_ram #(.WIDTH(72), .SLOTS(SLOTS), .OLD(0)) u_frames (
        .clk(clk), .wr_en_i(out_valid_o), .wr_addr_i(out_slot_o), .wr_data_i(bytes),
        .rd_en_i(frames_read_i), .rd_addr_i(frames_slot_i), .rd_data_o(frames_o)
    );

    // ---- the next ray ----
    wire             m_valid, m_out;          // a surface to mirror at; its mirrored direction
    wire [SLOTW-1:0] m_slot, m_out_slot;
    wire [3*WD-1:0]  m_vec;
    generate
        if (REFRACT != 0) begin : g_rays
            wire             go, go_ready;
            wire [3*WD-1:0]  vec;
            wire [2:0]       next_depth;
            wire [16:0]      next_weight;
            rt_rays #(.W(W), .WD(WD), .PR(PR), .PATHS(PATHS), .SLOTS(SLOTS),
                      .SLOTW(SLOTW)) u_rays (
                .clk(clk), .rst(rst),
                .ray_valid_i(ray_valid_i), .ray_slot_i(ray_slot_i), .ray_dir_i(ray_dir_i),
                .ray_a_i(ray_a_i),
                .normal_valid_i(normal_valid_i), .normal_slot_i(normal_slot_i),
                .normal_vec_i(normal_vec_i), .normal_nn_i(normal_nn_i),
                .hit_valid_i(hit_valid_i), .hit_slot_i(hit_slot_i), .hit_far_i(hit_far_i),
                .hit_id_i(hit_id_i),
                .point_valid_i(point_valid_i), .point_slot_i(point_slot_i), .point_i(point_i),
                .index_valid_i(look_valid_i), .index_slot_i(look_slot_i),
                .index_i(look_i[59:48]),
                .path_valid_i(path_valid_i), .path_slot_i(path_slot_i), .path_i(path_i),
                .in_valid_i(out_valid_o), .in_slot_i(out_slot_o), .in_depth_i(t_depth),
                .in_mirror_i(t_mirror || out_probe_o), .in_refract_i(t_refract),
                .in_weights_i({w_total, w_refract, w_mirror}),
                .mirror_valid_o(m_valid), .slot_o(m_slot), .end_valid_o(end_valid_o),
                .next_valid_o(next_valid), .next_weight_o(next_weight),
                .next_depth_o(next_depth),
                .out_valid_o(go), .out_ready_i(go_ready), .out_vec_o(vec),
                .out_point_o(back_point_o), .out_skip_o(back_skip_o), .out_path_o(back_path_o)
            );
            assign go_ready     = back_ready_i && !m_out;
            assign back_valid_o = go && go_ready;
            assign ray_valid_o  = m_out || back_valid_o;
            assign ray_slot_o   = m_out ? m_out_slot : m_slot;
            assign ray_vec_o    = m_out ? m_vec : vec;
            assign next_slot    = m_slot;
            assign next_state   = {next_depth, next_weight};
        end else begin : g_mirror
            assign m_valid      = out_valid_o && (t_mirror || out_probe_o);
            assign m_slot       = out_slot_o;
            assign end_valid_o  = out_valid_o && !t_mirror && !out_probe_o;
            assign next_valid   = m_valid;
            assign next_slot    = m_slot;
            assign next_state   = {t_depth + 3'd1, w_mirror};
            assign back_valid_o = 1'b0;
            assign back_point_o = {3*W{1'b0}};
            assign back_skip_o  = 25'd0;
            assign back_path_o  = {(W+8){1'b0}};
            assign {ray_valid_o, ray_slot_o, ray_vec_o} = {m_out, m_out_slot, m_vec};
            wire unused = &{1'b0, hit_valid_i, hit_slot_i, hit_far_i, hit_id_i, point_valid_i,
                            point_slot_i, point_i, path_valid_i, path_slot_i, path_i, ray_a_i,
                            back_ready_i, w_refract, w_total, on_i[1]};
        end
        if (MIRRORS != 0) begin : g_mirrors
            rt_mirrors #(.WD(WD), .SLOTS(SLOTS), .SLOTW(SLOTW)) u_mirrors (
                .clk(clk), .rst(rst),
                .ray_valid_i(ray_valid_i), .ray_slot_i(ray_slot_i), .ray_dir_i(ray_dir_i),
                .normal_valid_i(normal_valid_i), .normal_slot_i(normal_slot_i),
                .normal_vec_i(normal_vec_i), .normal_nn_i(normal_nn_i),
                .in_valid_i(m_valid), .in_slot_i(m_slot),
                .out_valid_o(m_out), .out_slot_o(m_out_slot), .out_vec_o(m_vec)
            );
        end else begin : g_no_mirror
            assign {m_out, m_out_slot, m_vec} = {(SLOTW+3*WD+1){1'b0}};
            wire unused = &{1'b0, ray_valid_i, ray_slot_i, ray_dir_i, normal_valid_i,
                            normal_slot_i, normal_vec_i, normal_nn_i, m_valid};
        end
    endgenerate
    assign end_slot_o = m_slot;
    assign count_o    = {back_valid_o, m_valid && MIRRORS != 0};
    wire unused = &{1'b0, look_i, on_i, in_kr_i, tag};
endmodule
`default_nettype wire
