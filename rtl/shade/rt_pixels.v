// rt_pixels.v - slots of an engine: a pixel comes in, its colours go out
// SPDX-License-Identifier: Apache-2.0
// Gives each traced pixel a free slot, sorts the rays that are done (shadow, hit, miss), blends
// surfaces and background over the reflection depths, sends mirror rays off, and delivers.
// Model: sph_render_pixel() in cmodel/render_pixel.c
`default_nettype none
module rt_pixels #(
    parameter W       = 16,  // coordinate, bits
    parameter WD      = 17,  // direction component, bits
    parameter SHADOW  = 1,   // effects elaborated, see rt_core
    parameter REFLECT = 5,
    parameter INSIDE  = 1,
    parameter INTERPENETRATE = 1,
    parameter SLOTS   = 32,  // power of two
    parameter SLOTW   = 5    // log2 of SLOTS
) (
    input  wire              clk,
    input  wire              rst,
    output wire              busy_o,          // slots are in use
    // registers
    input  wire              reflect_on_i,
    input  wire              probe_on_i,      // run-time switch of INTERPENETRATE
    input  wire [2:0]        max_depth_i,
    input  wire [23:0]       background_i,    // 0xBBGGRR
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
    // finished pixels
    output wire              visits_read_o,   // to rt_traverse
    output wire [SLOTW-1:0]  visits_slot_o,
    input  wire [23:0]       visits_i,
    output wire              pix_valid_o,
    input  wire              pix_ready_i,
    output wire [13:0]       pix_x_o,
    output wire [13:0]       pix_y_o,
    output wire [71:0]       pix_colour_o,
    output wire [23:0]       pix_id_o,
    output wire [W+WD+1:0]   pix_key_o,
    output wire [23:0]       pix_visits_o,
    // errors
    output reg               bad_node_o       // a record lies outside memory
);
    localparam KW = W + WD + 2;
    localparam MIRRORS = REFLECT != 0 || INTERPENETRATE != 0 ? 1 : 0;
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
        hit_far_o      <= INSIDE != 0 && done_far_i;
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
    rt_slot_ram #(.WIDTH(51), .SLOTS(SLOTS), .OLD(0)) u_light (
        .clk(clk), .wr_en_i(sum_valid_i), .wr_addr_i(sum_slot_i), .wr_data_i(sum_i),
        .rd_en_i(e_read), .rd_addr_i(e_slot), .rd_data_o(e_light)
    );
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_misses (
        .clk(clk), .rst(rst), .in_valid_i(miss_valid_q), .in_ready_o(q_miss_in),
        .in_data_i(hit_slot_o),
        .out_valid_o(q_miss), .out_ready_i(e_load && !q_hit), .out_data_o(q_miss_slot)
    );
    always @(posedge clk) begin
        if (e_load) begin
            e_valid_q <= q_hit || q_miss;
            e_miss_q  <= !q_hit;
            e_slot_q  <= e_slot;
        end
        if (rst) e_valid_q <= 1'b0;
    end
    wire [32:0]  e_material;
    wire [139:0] e_state, b_state;                   // {depth, frames, weight, sum}
    wire         b_valid, b_last, b_probe;
    wire [SLOTW-1:0] b_slot;
    wire [1:0]   d_surface = {done_first_i && probe_on_i, d_first};
    wire [PB:0]  e_surface;
    wire         e_first = e_surface[0];             // the surface that the pixel sees itself
    wire         e_probe = INTERPENETRATE != 0 && e_surface[PB];  // it may not be the nearest
    rt_slot_ram #(.WIDTH(PB+1), .SLOTS(SLOTS), .OLD(0)) u_first_surface (
        .clk(clk), .wr_en_i(d_valid), .wr_addr_i(done_slot_i), .wr_data_i(d_surface[PB:0]),
        .rd_en_i(e_read), .rd_addr_i(e_slot), .rd_data_o(e_surface)
    );
    rt_slot_ram #(.WIDTH(33), .SLOTS(SLOTS), .OLD(0)) u_material (
        .clk(clk), .wr_en_i(material_valid_i), .wr_addr_i(material_slot_i),
        .wr_data_i(material_i),
        .rd_en_i(e_read), .rd_addr_i(e_slot), .rd_data_o(e_material)
    );
    rt_slot_ram #(.WIDTH(140), .SLOTS(SLOTS), .OLD(0)) u_state (
        .clk(clk), .wr_en_i(b_valid), .wr_addr_i(b_slot), .wr_data_i(b_state),
        .rd_en_i(e_read), .rd_addr_i(e_slot), .rd_data_o(e_state)
    );

    // ---- blend: two units take turns ----
    wire [2:0]   e_depth = e_first ? 3'd0 : e_state[139:137];
    wire         e_last  = e_miss_q || e_material[32:24] == 9'd0 || REFLECT == 0 ||
                           !reflect_on_i || e_depth == max_depth_i;
    wire [1:0]   u_ready, u_valid;
    localparam TAG = SLOTW + 1 + PB;
    wire [SLOTW+1:0]    e_tag = {e_probe, e_last, e_slot_q};
    wire [2*TAG-1:0]    u_tag;
    wire [279:0] u_state_out;
    assign blend_ready = |u_ready;
    genvar u;
    generate
        for (u = 0; u < 2; u = u + 1) begin : g_blend
            rt_blend #(.TAG(TAG)) u_blend (
                .clk(clk), .rst(rst),
                .in_valid_i(e_valid_q && (u == 0 || !u_ready[0])), .in_ready_o(u_ready[u]),
                .in_tag_i(e_tag[TAG-1:0]), .in_light_i(e_light),
                .in_albedo_i(e_miss_q ? background_i : e_material[23:0]),
                .in_background_i(e_miss_q), .in_kr_i(e_miss_q ? 9'd0 : e_material[32:24]),
                .in_last_i(e_last),
                .in_sum_i(e_first ? 48'd0 : e_state[47:0]),
                .in_weight_i(e_first ? 17'h10000 : e_state[64:48]),
                .in_depth_i(e_depth), .in_colour_i(e_first ? 72'd0 : e_state[136:65]),
                .out_valid_o(u_valid[u]), .out_tag_o(u_tag[TAG*u +: TAG]),
                .out_sum_o(u_state_out[140*u +: 48]), .out_weight_o(u_state_out[140*u+48 +: 17]),
                .out_depth_o(u_state_out[140*u+137 +: 3]),
                .out_colour_o(u_state_out[140*u+65 +: 72])
            );
        end
    endgenerate
    assign b_valid = |u_valid;                       // never both: one enters a cycle
    wire [TAG-1:0] b_tag = u_valid[0] ? u_tag[TAG-1:0] : u_tag[2*TAG-1:TAG];
    assign b_slot  = b_tag[SLOTW-1:0];
    assign b_last  = b_tag[SLOTW];
    assign b_probe = INTERPENETRATE != 0 && b_tag[SLOTW+PB];
    assign b_state = u_valid[0] ? u_state_out[139:0] : u_state_out[279:140];

    // ---- mirror rays ----
    generate
        if (MIRRORS != 0) begin : g_reflect
            wire             m_valid, m_in, bounce_ready;
            wire [SLOTW-1:0] m_slot;
            reg              n_valid_q;
            reg [SLOTW-1:0]  n_slot_q;
            wire             m_load = !n_valid_q || bounce_ready;
            wire [3*WD-1:0]  n_dir, n_normal;
            wire [2*WD-1:0]  n_nn;
            rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_mirrors (
                .clk(clk), .rst(rst), .in_valid_i(b_valid && (!b_last || b_probe)),
                .in_ready_o(m_in),
                .in_data_i(b_slot),
                .out_valid_o(m_valid), .out_ready_i(m_load), .out_data_o(m_slot)
            );
            rt_slot_ram #(.WIDTH(3*WD), .SLOTS(SLOTS), .OLD(0)) u_dir (
                .clk(clk), .wr_en_i(ray_valid_i), .wr_addr_i(ray_slot_i), .wr_data_i(ray_dir_i),
                .rd_en_i(m_load && m_valid), .rd_addr_i(m_slot), .rd_data_o(n_dir)
            );
            rt_slot_ram #(.WIDTH(5*WD), .SLOTS(SLOTS), .OLD(0)) u_normal (
                .clk(clk), .wr_en_i(normal_valid_i), .wr_addr_i(normal_slot_i),
                .wr_data_i({normal_nn_i, normal_vec_i}),
                .rd_en_i(m_load && m_valid), .rd_addr_i(m_slot), .rd_data_o({n_nn, n_normal})
            );
            always @(posedge clk) begin
                if (m_load) begin
                    n_valid_q <= m_valid;
                    n_slot_q  <= m_slot;
                end
                if (rst) n_valid_q <= 1'b0;
            end
            rt_bounce #(.WD(WD), .TAG(SLOTW)) u_bounce (
                .clk(clk), .rst(rst), .in_valid_i(n_valid_q), .in_ready_o(bounce_ready),
                .in_tag_i(n_slot_q),
                .in_dir_x_i($signed(n_dir[0 +: WD])), .in_dir_y_i($signed(n_dir[WD +: WD])),
                .in_dir_z_i($signed(n_dir[2*WD +: WD])),
                .in_normal_x_i($signed(n_normal[0 +: WD])),
                .in_normal_y_i($signed(n_normal[WD +: WD])),
                .in_normal_z_i($signed(n_normal[2*WD +: WD])), .in_nn_i(n_nn),
                .out_valid_o(bounce_valid_o), .out_tag_o(bounce_slot_o),
                .out_dir_x_o(bounce_vec_o[0 +: WD]), .out_dir_y_o(bounce_vec_o[WD +: WD]),
                .out_dir_z_o(bounce_vec_o[2*WD +: WD])
            );
            wire unused = &{1'b0, m_in};
        end else begin : g_matt
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
            wire unused = &{1'b0, ask_valid_i, ask_slot_i};
        end
    endgenerate

    // ---- delivery ----
    wire             o_blend, o_sky, o_blend_in, o_sky_in;
    wire [SLOTW:0]   o_end = {end_q, hit_slot_o};
    wire [SLOTW+PB-1:0] o_next;
    wire [SLOTW-1:0] o_blend_slot, o_sky_slot;
    wire [71:0]      p_colour;
    reg              p_valid_q, p_sky_q;
    reg [SLOTW-1:0]  p_slot_q;
    wire             o_load = !p_valid_q || pix_ready_i;
    wire [SLOTW-1:0] o_slot = o_blend ? o_blend_slot : o_sky_slot;
    wire             o_read = o_load && (o_blend || o_sky);
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_blended (
        .clk(clk), .rst(rst), .in_valid_i(b_valid && b_last && !b_probe),
        .in_ready_o(o_blend_in),
        .in_data_i(b_slot),
        .out_valid_o(o_blend), .out_ready_i(o_load), .out_data_o(o_blend_slot)
    );
    rt_slot_ram #(.WIDTH(72), .SLOTS(SLOTS), .OLD(0)) u_frames (
        .clk(clk), .wr_en_i(b_valid && b_last), .wr_addr_i(b_slot),
        .wr_data_i(b_state[136:65]),
        .rd_en_i(o_read), .rd_addr_i(o_slot), .rd_data_o(p_colour)
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
    assign out_done      = pix_valid_o && pix_ready_i;
    assign out_slot      = p_slot_q;
    wire unused = &{1'b0, free_in, q_hit_in, q_miss_in, o_blend_in, o_sky_in, o_end, d_surface,
                    e_tag};
endmodule
`default_nettype wire
