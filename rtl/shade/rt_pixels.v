// rt_pixels.v - slots of an engine: a pixel comes in, its colours go out
// SPDX-License-Identifier: Apache-2.0
// Gives each traced pixel a free slot, sorts the rays that are done (shadow, hit, miss), blends
// surfaces and background over the reflection depths, sends mirror rays off, and delivers. With
// REFRACT or SUM rt_shares blends, and sends refracted rays off too.
// Model: sph_render_pixel() in cmodel/engine/render_pixel.c
`default_nettype none
`include "rt_layout.vh"
module rt_pixels #(
    parameter W       = 16,  // coordinate, bits
    parameter WD      = 17,  // direction component, bits
    parameter SHADOW  = 1,   // effects elaborated, see rt_core
    parameter REFLECT = 5,
    parameter LIGHTS  = 8,
    parameter INSIDE  = 1,
    parameter FACETS  = 0,
    parameter TEXTURE = 0,
    parameter INTERPENETRATE = 1,
    parameter REFRACT = 0,
    parameter SPECULAR = 0,
    parameter SUM     = 0,
    parameter PR      = 0,   // significant bits of the root, 0: all
    parameter SLOTS   = 32,  // power of two
    parameter SLOTW   = 5    // log2 of SLOTS
) (
    input  wire              clk,
    input  wire              rst,
    output wire              busy_o,          // slots are in use
    // registers
    input  wire [3:0]        shares_on_i,     // run-time: {SUM, SPECULAR, REFRACT, REFLECT}
    input  wire              probe_on_i,      // that of INTERPENETRATE
    input  wire [2:0]        max_depth_i,
    input  wire [23:0]       background_i,    // 0xBBGGRR
    input  wire [47:0]       ambient_i,       // 3 x u1.15, red low
    input  wire [25:0]       prim_base_i,
    input  wire [25:0]       mem_lines_i,
    // from rt_walk: a pixel to trace
    input  wire              in_valid_i,
    output wire              in_ready_o,
    input  wire [13:0]       in_x_i,
    input  wire [13:0]       in_y_i,
    input  wire [3*WD-1:0]   in_dir_i,
    // to rt_setup: primary and mirror rays
    output wire              primary_valid_o,
    input  wire              primary_ready_i,
    output wire [SLOTW-1:0]  primary_slot_o,
    output wire [3*WD-1:0]   primary_vec_o,
    output wire              bounce_valid_o,
    output wire [SLOTW-1:0]  bounce_slot_o,
    output wire [3*WD-1:0]   bounce_vec_o,
    // from rt_setup: what a mirror ray will need
    input  wire              ray_valid_i,     // primary or reflected ray
    input  wire [SLOTW-1:0]  ray_slot_i,
    input  wire [3*WD-1:0]   ray_dir_i,
    input  wire [2*WD-1:0]   ray_a_i,
    output wire              ray_again_o,     // it is the repeated primary ray of its pixel
    input  wire              normal_valid_i,
    input  wire [SLOTW-1:0]  normal_slot_i,
    input  wire [3*WD-1:0]   normal_vec_i,
    input  wire [2*WD-1:0]   normal_nn_i,
    // from rt_next and rt_collect: a ray will be done in the next cycle, is done
    input  wire              ask_valid_i,
    input  wire [SLOTW-1:0]  ask_slot_i,
    input  wire              done_valid_i,
    input  wire [SLOTW-1:0]  done_slot_i,
    input  wire              done_found_i,
    input  wire              done_shadow_i,
    input  wire              done_primary_i,
    input  wire              done_first_i,    // a primary ray that ended with its first hit
    input  wire              done_far_i,
    input  wire [23:0]       done_id_i,
    input  wire [W+WD+1:0]   done_key_i,
    // to rt_lights
    output reg               shadow_valid_o,
    output reg [SLOTW-1:0]   shadow_slot_o,
    output reg               shadow_lit_o,
    // to rt_surface
    output reg               hit_valid_o,
    output reg [SLOTW-1:0]   hit_slot_o,
    output reg               hit_far_o,
    output reg [23:0]        hit_id_o,
    output reg [W+WD+1:0]    hit_key_o,
    // from rt_surface and rt_lights
    input  wire              material_valid_i,
    input  wire [SLOTW-1:0]  material_slot_i,
    input  wire [32:0]       material_i,      // {kr u1.8, 0xBBGGRR}
    input  wire              sum_valid_i,
    input  wire [SLOTW-1:0]  sum_slot_i,
    input  wire [50:0]       sum_i,           // 3 x u2.15
    // with REFRACT or SUM: the rest of the material, highlights, hit points, paths
    input  wire              look_valid_i,
    input  wire [SLOTW-1:0]  look_slot_i,
    input  wire [59:0]       look_i,          // {index, power, ks, kd, ka, sum, kt}
    input  wire [50:0]       gloss_i,         // 3 x u2.15, with sum_valid_i
    input  wire              point_valid_i,
    input  wire [SLOTW-1:0]  point_slot_i,
    input  wire [3*W-1:0]    point_i,
    input  wire              path_valid_i,
    input  wire [SLOTW-1:0]  path_slot_i,
    input  wire [W+7:0]      path_i,          // u(W+4).4
    // where a refracted ray starts, with bounce_valid_o, to where that is kept
    output wire              back_valid_o,
    input  wire              back_ready_i,
    output wire [3*W-1:0]    back_point_o,
    output wire [24:0]       back_skip_o,     // {inside, id}
    output wire [W+7:0]      back_path_o,
    output wire [1:0]        count_o,         // {refracted, reflected}: one starts
    // finished pixels
    output wire              visits_read_o,   // to rt_traverse, rt_texture
    output wire [SLOTW-1:0]  visits_slot_o,
    input  wire [23:0]       visits_i,
    input  wire [31:0]       texture_i,
    output wire              pix_valid_o,
    input  wire              pix_ready_i,
    output wire [13:0]       pix_x_o,
    output wire [13:0]       pix_y_o,
    output wire [71:0]       pix_colour_o,
    output wire [23:0]       pix_id_o,
    output wire [W+WD+1:0]   pix_key_o,
    output wire [23:0]       pix_visits_o,
    output wire [31:0]       pix_texture_o,   // {lod u4.8, sum of texel addresses}
    // errors
    output reg               bad_node_o       // a record lies outside memory
);
    localparam KW = W + WD + 2;
    localparam SHARES = REFRACT != 0 || SUM != 0 ? 1 : 0;  // blends by shares
    localparam DEEP = REFLECT != 0 || REFRACT != 0 ? 1 : 0; // surfaces behind the first one
    localparam MIRRORS = DEEP != 0 || INTERPENETRATE != 0 ? 1 : 0;
    localparam PB = INTERPENETRATE != 0 ? 1 : 0;     // bits of a flag about probes
    wire             again_valid;                    // a primary ray is to be repeated
    wire [SLOTW-1:0] again_slot;
    wire [3*WD-1:0]  again_dir;

    // ---- free slots: all of them after reset, then those that were delivered ----
    reg [SLOTW:0]    fill_q;                         // slots put into the queue after reset
    wire             filling = !fill_q[SLOTW];
    wire             free_valid, free_in, out_done;
    wire [SLOTW-1:0] free_slot, out_slot;
    reg [SLOTW:0]    used_q;
    wire             taken = in_valid_i && in_ready_o;
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_free (
        .clk(clk), .rst(rst), .in_valid_i(filling || out_done), .in_ready_o(free_in),
        .in_data_i(filling ? fill_q[SLOTW-1:0] : out_slot),
        .out_valid_o(free_valid), .out_ready_i(taken), .out_data_o(free_slot)
    );
    assign in_ready_o      = free_valid && !filling && primary_ready_i && !again_valid;
    assign primary_valid_o = (in_valid_i && free_valid && !filling) || again_valid;
    assign primary_slot_o  = again_valid ? again_slot : free_slot;
    assign primary_vec_o   = again_valid ? again_dir : in_dir_i;
    assign busy_o          = used_q != 0;
    always @(posedge clk) begin
        if (filling) fill_q <= fill_q + 1'b1;
        used_q <= used_q + {{SLOTW{1'b0}}, taken} - {{SLOTW{1'b0}}, out_done};
        if (rst) begin fill_q <= 0; used_q <= 0; end
    end

    // ---- rays that are done ----
    wire [26:0] d_line    = {1'b0, prim_base_i} + {3'b0, done_id_i};
    wire        d_outside = d_line >= {1'b0, mem_lines_i};
    wire        d_found   = done_found_i && !d_outside;
    wire        d_first   = done_primary_i;
    wire        d_shadow  = SHADOW != 0 && done_shadow_i;
    wire        d_valid   = done_valid_i && !d_shadow;
    wire        d_void, d_end;                       // a probe: the pixel starts again; is complete
    wire        d_on      = d_valid && !d_void && !d_end;
    reg         miss_valid_q, sky_valid_q, end_q;    // behind a mirror; to be delivered, blended
    always @(posedge clk) begin
        shadow_valid_o <= done_valid_i && d_shadow;
        shadow_slot_o  <= done_slot_i;
        shadow_lit_o   <= !done_found_i;
        hit_valid_o    <= d_on && d_found;
        hit_slot_o     <= done_slot_i;
        hit_far_o      <= (INSIDE != 0 || FACETS != 0) && done_far_i;
        hit_id_o       <= done_id_i;
        hit_key_o      <= done_key_i;
        sky_valid_q    <= (d_on && !d_found && d_first) || (d_valid && d_end);
        end_q          <= d_end;
        miss_valid_q   <= d_on && !d_found && !d_first;
        bad_node_o     <= d_valid && done_found_i && d_outside;
        if (rst) begin
            shadow_valid_o <= 1'b0; hit_valid_o <= 1'b0; sky_valid_q <= 1'b0;
            miss_valid_q <= 1'b0; bad_node_o <= 1'b0;
        end
    end

    // ---- queues of surfaces and of background behind mirrors ----
    wire             q_hit, q_miss, q_hit_in, q_miss_in, blend_ready;
    wire [SLOTW-1:0] q_hit_slot, q_miss_slot;
    reg              e_valid_q, e_miss_q;
    reg [SLOTW-1:0]  e_slot_q;
    wire [50:0]      e_light;
    wire             e_load = !e_valid_q || blend_ready;
    wire [SLOTW-1:0] e_slot = q_hit ? q_hit_slot : q_miss_slot;
    wire             e_read = e_load && (q_hit || q_miss);
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_sums (
        .clk(clk), .rst(rst), .in_valid_i(sum_valid_i), .in_ready_o(q_hit_in),
        .in_data_i(sum_slot_i),
        .out_valid_o(q_hit), .out_ready_i(e_load), .out_data_o(q_hit_slot)
    );
    generate
        if (LIGHTS != 0) begin : g_light
            rt_slot_ram #(.WIDTH(51), .SLOTS(SLOTS), .OLD(0)) u_light (
                .clk(clk), .wr_en_i(sum_valid_i), .wr_addr_i(sum_slot_i), .wr_data_i(sum_i),
                .rd_en_i(e_read), .rd_addr_i(e_slot), .rd_data_o(e_light)
            );
        end else begin : g_ambient                   // the same for every surface
            assign e_light = sum_i;
        end
        if (DEEP != 0) begin : g_miss
            rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_misses (
                .clk(clk), .rst(rst), .in_valid_i(miss_valid_q), .in_ready_o(q_miss_in),
                .in_data_i(hit_slot_o),
                .out_valid_o(q_miss), .out_ready_i(e_load && !q_hit), .out_data_o(q_miss_slot)
            );
        end else begin : g_no_miss
            assign {q_miss, q_miss_in, q_miss_slot} = {(SLOTW+2){1'b0}};
            wire unused = miss_valid_q;
        end
    endgenerate
    always @(posedge clk) begin
        if (e_load) begin
            e_valid_q <= q_hit || q_miss;
            e_miss_q  <= DEEP != 0 && !q_hit;
            e_slot_q  <= e_slot;
        end
        if (rst) e_valid_q <= 1'b0;
    end
    wire             b_valid, b_last, b_probe, o_read;
    wire [SLOTW-1:0] b_slot, o_slot;                 // a surface is blended; a pixel is delivered
    wire [71:0]      p_colour;

    // ---- which surface of its pixel it is; its material ----
    localparam FB = DEEP;                           // more than the first one is blended
    localparam MW = REFLECT != 0 ? 33 : 24;          // without a mirror's share
    wire         e_first, e_probe;                   // what the pixel sees itself; to be probed
    wire [MW-1:0] e_material;
    wire [8:0]   e_kr;
    wire [2:0]   e_depth;
    generate
        if (FB + PB != 0) begin : g_surface
            wire [1:0]       d_surface = {done_first_i && probe_on_i, d_first};
            wire [FB+PB-1:0] e_surface;
            rt_slot_ram #(.WIDTH(FB+PB), .SLOTS(SLOTS), .OLD(0)) u_surface (
                .clk(clk), .wr_en_i(d_valid), .wr_addr_i(done_slot_i),
                .wr_data_i(d_surface[PB -: FB+PB]),
                .rd_en_i(e_read), .rd_addr_i(e_slot), .rd_data_o(e_surface)
            );
            assign e_first = FB == 0 || e_surface[0];
            assign e_probe = PB != 0 && e_surface[FB+PB-1];
            wire unused = &{1'b0, d_surface};
        end else begin : g_only
            assign {e_first, e_probe} = 2'b10;
            wire unused = &{1'b0, done_first_i, probe_on_i};
        end
        if (REFLECT != 0) begin : g_kr
            assign e_kr = e_miss_q ? 9'd0 : e_material[MW-1:24];
        end else begin : g_matt
            assign e_kr = 9'd0;
        end
    endgenerate
    rt_slot_ram #(.WIDTH(MW), .SLOTS(SLOTS), .OLD(0)) u_material (
        .clk(clk), .wr_en_i(material_valid_i), .wr_addr_i(material_slot_i),
        .wr_data_i(material_i[MW-1:0]),
        .rd_en_i(e_read), .rd_addr_i(e_slot), .rd_data_o(e_material)
    );

    // ---- blend; mirrored and refracted rays ----
    wire             e_reflect = REFLECT != 0 && shares_on_i[0];
    wire             end_valid;                      // a pixel is complete
    wire [SLOTW-1:0] end_slot;
    generate
        if (SHARES != 0) begin : g_shares
            rt_shares #(.W(W), .WD(WD), .PR(PR), .REFLECT(REFLECT), .REFRACT(REFRACT),
                        .SPECULAR(SPECULAR), .SUM(SUM), .MIRRORS(MIRRORS), .PROBE(PB),
                        .PATHS(TEXTURE), .SLOTS(SLOTS), .SLOTW(SLOTW)) u_shares (
                .clk(clk), .rst(rst), .on_i(shares_on_i), .max_depth_i(max_depth_i),
                .ambient_i(ambient_i),
                .ray_valid_i(ray_valid_i), .ray_slot_i(ray_slot_i), .ray_dir_i(ray_dir_i),
                .ray_a_i(ray_a_i),
                .normal_valid_i(normal_valid_i), .normal_slot_i(normal_slot_i),
                .normal_vec_i(normal_vec_i), .normal_nn_i(normal_nn_i),
                .hit_valid_i(hit_valid_o), .hit_slot_i(hit_slot_o), .hit_far_i(hit_far_o),
                .hit_id_i(hit_id_o),
                .point_valid_i(point_valid_i), .point_slot_i(point_slot_i), .point_i(point_i),
                .path_valid_i(path_valid_i), .path_slot_i(path_slot_i), .path_i(path_i),
                .look_valid_i(look_valid_i), .look_slot_i(look_slot_i), .look_i(look_i),
                .gloss_valid_i(sum_valid_i), .gloss_slot_i(sum_slot_i), .gloss_i(gloss_i),
                .read_i(e_read), .read_slot_i(e_slot), .in_first_i(e_first),
                .in_valid_i(e_valid_q), .in_ready_o(blend_ready), .in_slot_i(e_slot_q),
                .in_light_i(e_light), .in_albedo_i(e_miss_q ? background_i : e_material[23:0]),
                .in_background_i(e_miss_q), .in_kr_i(e_kr), .in_probe_i(e_probe && !e_miss_q),
                .out_valid_o(b_valid), .out_slot_o(b_slot), .out_last_o(b_last),
                .out_probe_o(b_probe), .end_valid_o(end_valid), .end_slot_o(end_slot),
                .ray_valid_o(bounce_valid_o), .ray_slot_o(bounce_slot_o),
                .ray_vec_o(bounce_vec_o), .count_o(count_o),
                .back_valid_o(back_valid_o), .back_ready_i(back_ready_i),
                .back_point_o(back_point_o), .back_skip_o(back_skip_o),
                .back_path_o(back_path_o),
                .frames_read_i(o_read), .frames_slot_i(o_slot), .frames_o(p_colour)
            );
            wire unused = &{1'b0, e_depth, e_reflect};
            assign e_depth = 3'd0;
        end else begin : g_blends
            wire e_last = e_kr == 9'd0 ||            // background has no share either
                          !e_reflect || e_depth == max_depth_i;
            rt_blends #(.REFLECT(REFLECT), .PROBE(PB), .SLOTS(SLOTS), .SLOTW(SLOTW)) u_blends (
                .clk(clk), .rst(rst),
                .read_i(e_read), .read_slot_i(e_slot), .in_first_i(e_first), .depth_o(e_depth),
                .in_valid_i(e_valid_q), .in_ready_o(blend_ready), .in_slot_i(e_slot_q),
                .in_light_i(e_light), .in_albedo_i(e_miss_q ? background_i : e_material[23:0]),
                .in_background_i(e_miss_q), .in_kr_i(e_kr), .in_last_i(e_last),
                .in_probe_i(e_probe),
                .out_valid_o(b_valid), .out_slot_o(b_slot), .out_last_o(b_last),
                .out_probe_o(b_probe),
                .frames_read_i(o_read), .frames_slot_i(o_slot), .frames_o(p_colour)
            );
            assign end_valid    = b_valid && b_last && !b_probe;
            assign end_slot     = b_slot;
            assign back_valid_o = 1'b0;
            assign back_point_o = {3*W{1'b0}};
            assign back_skip_o  = 25'd0;
            assign back_path_o  = {(W+8){1'b0}};
            assign count_o      = 2'b00;
            wire unused = &{1'b0, ray_a_i, shares_on_i, ambient_i, look_valid_i, look_slot_i,
                            look_i, gloss_i, point_valid_i, point_slot_i, point_i, path_valid_i,
                            path_slot_i, path_i, back_ready_i};
        end
        if (SHARES != 0) begin : g_rays
        end else if (MIRRORS != 0) begin : g_mirrors
            rt_mirrors #(.WD(WD), .SLOTS(SLOTS), .SLOTW(SLOTW)) u_mirrors (
                .clk(clk), .rst(rst),
                .ray_valid_i(ray_valid_i), .ray_slot_i(ray_slot_i), .ray_dir_i(ray_dir_i),
                .normal_valid_i(normal_valid_i), .normal_slot_i(normal_slot_i),
                .normal_vec_i(normal_vec_i), .normal_nn_i(normal_nn_i),
                .in_valid_i(b_valid && (!b_last || b_probe)), .in_slot_i(b_slot),
                .out_valid_o(bounce_valid_o), .out_slot_o(bounce_slot_o),
                .out_vec_o(bounce_vec_o)
            );
        end else begin : g_no_mirror
            assign bounce_valid_o = 1'b0;
            assign bounce_slot_o  = {SLOTW{1'b0}};
            assign bounce_vec_o   = {3*WD{1'b0}};
            wire unused = &{1'b0, ray_valid_i, ray_slot_i, ray_dir_i, normal_valid_i,
                            normal_slot_i, normal_vec_i, normal_nn_i};
        end
    endgenerate

    // ---- first hits that may lie in another sphere ----
    generate
        if (INTERPENETRATE != 0) begin : g_probe
            rt_probe #(.WD(WD), .SLOTS(SLOTS), .SLOTW(SLOTW)) u_probe (
                .clk(clk), .rst(rst),
                .pixel_valid_i(taken), .pixel_slot_i(free_slot), .pixel_dir_i(in_dir_i),
                .blend_valid_i(b_valid), .blend_slot_i(b_slot), .blend_probe_i(b_probe),
                .blend_last_i(b_last),
                .ask_valid_i(ask_valid_i), .ask_slot_i(ask_slot_i),
                .done_valid_i(d_valid), .done_slot_i(done_slot_i), .done_primary_i(d_first),
                .done_found_i(d_found), .done_far_i(done_far_i), .done_id_i(done_id_i),
                .done_void_o(d_void), .done_end_o(d_end),
                .again_valid_o(again_valid), .again_ready_i(primary_ready_i),
                .again_slot_o(again_slot), .again_dir_o(again_dir),
                .ray_slot_i(ray_slot_i), .ray_again_o(ray_again_o)
            );
        end else begin : g_no_probe
            assign {d_void, d_end, again_valid, ray_again_o} = 4'd0;
            assign again_slot = {SLOTW{1'b0}};
            assign again_dir  = {3*WD{1'b0}};
            wire unused = &{1'b0, ask_valid_i, ask_slot_i, b_valid, b_slot, b_last, b_probe};
        end
    endgenerate

    // ---- delivery ----
    wire             o_blend, o_sky, o_blend_in, o_sky_in;
    wire [SLOTW:0]   o_end = {end_q, hit_slot_o};
    wire [SLOTW+PB-1:0] o_next;
    wire [SLOTW-1:0] o_blend_slot, o_sky_slot;
    reg              p_valid_q, p_sky_q;
    reg [SLOTW-1:0]  p_slot_q;
    wire             o_load = !p_valid_q || pix_ready_i;
    assign           o_slot = o_blend ? o_blend_slot : o_sky_slot;
    assign           o_read = o_load && (o_blend || o_sky);
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_blended (
        .clk(clk), .rst(rst), .in_valid_i(end_valid), .in_ready_o(o_blend_in),
        .in_data_i(end_slot),
        .out_valid_o(o_blend), .out_ready_i(o_load), .out_data_o(o_blend_slot)
    );
    rt_fifo #(.WIDTH(SLOTW+PB), .DEPTH(SLOTS)) u_skies (
        .clk(clk), .rst(rst), .in_valid_i(sky_valid_q), .in_ready_o(o_sky_in),
        .in_data_i(o_end[SLOTW+PB-1:0]),
        .out_valid_o(o_sky), .out_ready_i(o_load && !o_blend), .out_data_o(o_next)
    );
    assign o_sky_slot = o_next[SLOTW-1:0];
    wire             o_sky_end = INTERPENETRATE != 0 && o_next[SLOTW+PB-1];
    wire [KW+23:0] p_first;                          // {id, key} of the primary hit
    rt_slot_ram #(.WIDTH(28), .SLOTS(SLOTS), .OLD(0)) u_pixel (
        .clk(clk), .wr_en_i(taken), .wr_addr_i(free_slot), .wr_data_i({in_y_i, in_x_i}),
        .rd_en_i(o_read), .rd_addr_i(o_slot), .rd_data_o({pix_y_o, pix_x_o})
    );
    rt_slot_ram #(.WIDTH(KW+24), .SLOTS(SLOTS), .OLD(0)) u_first (
        .clk(clk), .wr_en_i(d_valid && d_first && d_found),
        .wr_addr_i(done_slot_i), .wr_data_i({done_id_i, done_key_i}),
        .rd_en_i(o_read), .rd_addr_i(o_slot), .rd_data_o(p_first)
    );
    always @(posedge clk) begin
        if (o_load) begin
            p_valid_q  <= o_blend || o_sky;
            p_sky_q    <= !o_blend && !o_sky_end;
            p_slot_q   <= o_slot;
        end
        if (rst) p_valid_q <= 1'b0;
    end
    assign visits_read_o = o_read;
    assign visits_slot_o = o_slot;
    assign pix_valid_o   = p_valid_q;
    assign pix_colour_o  = p_sky_q ? {3{background_i}} : p_colour;
    assign pix_id_o      = p_sky_q ? 24'hffffff : p_first[KW +: 24];
    assign pix_key_o     = p_sky_q ? {KW{1'b0}} : p_first[KW-1:0];
    assign pix_visits_o  = visits_i;
    assign pix_texture_o = TEXTURE == 0 || p_sky_q ? {12'd`RT_LOD_NONE, 20'd0} : texture_i;
    assign out_done      = pix_valid_o && pix_ready_i;
    assign out_slot      = p_slot_q;
    wire unused = &{1'b0, free_in, q_hit_in, q_miss_in, o_blend_in, o_sky_in, o_end,
                    material_i, texture_i};
endmodule
`default_nettype wire
