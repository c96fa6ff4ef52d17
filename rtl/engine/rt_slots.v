// rt_slots.v - slots of an engine: a pixel comes in, its colours go out
// SPDX-License-Identifier: Apache-2.0
// A pixel to trace gets a free slot. Rays that are done are told apart (shadow, hit, miss), primary
// rays that rt_interpenetrate asks for start again, and pixels that are complete are delivered.
// Model: sph_render_pixel() in cmodel/engine/render_pixel.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_slots #(
    parameter W       = 16,  // coordinate, bits
    parameter WD      = 17,  // direction component, bits
    parameter SHADOW  = 1,   // 1: shadow rays
    parameter FARS    = 1,   // 1: hits that are far
    parameter TEXTURE = 0,   // 1: pixels have a word of texture
    parameter INTERPENETRATE = 1, // 1: first hits may lie in another sphere
    parameter PIPES   = 1,   // of which each has its share of the slots, 1..4
    parameter SETUPS  = 1,   // set-up units, power of two; 1 with INTERPENETRATE
    parameter SLOTS   = 32   // numbers of slots, power of two: {pipe, slot of its own}
) (
    input  wire                       clk,
    input  wire                       rst,
    output wire                       busy_o,          // slots are in use
    input  wire [`RT_REGS_BITS-1:0]   regs_i,
    //: {BOX[6*(W+2)], N_LOOSE[24], LEAF_BASE[26], N_PRIMS[24], VISIT_LIMIT[24], MEM_LINES[26],
    //: SMOOTH_BASE[26], PRIM_BASE[26], ROOT[26], EYE[3*W], AMBIENT[48], BACKGROUND[24],
    //: N_LIGHTS[4], LEAST[9], MAX_DEPTH[4], TEX_FILTER[2], EFFECTS[EFFECT_BITS]}
    // from rt_pixel_scan: a pixel to trace
    input  wire                       in_valid_i,
    output wire                       in_ready_o,
    input  wire [`RT_START_BITS-1:0]  start_i,
    //: {DIR[3*WD], Y[14], X[14]}
    // to each rt_setup: primary rays of its slots
    output wire [SETUPS*(`RT_VECTOR_BITS-$clog2(SETUPS))-1:0] primary_o,
    //: {SLOT[SLOTW], VEC[3*WD], VALID}
    input  wire [SETUPS-1:0]          primary_ready_i,
    // from rt_setup, to rt_trace: the ray of this slot is the repeated primary ray of its pixel
    input  wire [$clog2(SLOTS)-1:0]   ray_slot_i,
    output wire                       ray_again_o,
    // from rt_trace: a ray is done, a clock later how
    input  wire                       done_valid_i,
    input  wire [$clog2(SLOTS)-1:0]   done_slot_i,
    input  wire [`RT_DONE_BITS-1:0]   done_i,
    //: {KEY[W+WD+2], ID[24], FARS[2], FAR, FIRST, PRIMARY, SHADOW, FOUND}
    // to and from rt_shade: what becomes of it; a surface is blended; a pixel is complete
    output wire [`RT_HIT_BITS-1:0]    hit_o,
    //: {SLOT[SLOTW], KEY[W+WD+2], ID[24], FAR, PROBE, FIRST, LIT, SHADOW, MISS, HIT}
    input  wire [`RT_BLEND_BITS-1:0]  blend_i,
    //: {SLOT[SLOTW], W_TOTAL[17], W_REFRACT[17], W_MIRROR[17], DEPTH[4], REFRACT, MIRROR, PROBE,
    //: LAST, VALID}
    input  wire                       end_valid_i,
    input  wire [$clog2(SLOTS)-1:0]   end_slot_i,
    // of a pixel that leaves, a clock after its slot: from rt_trace and rt_shade
    output wire                       read_o,
    output wire [$clog2(SLOTS)-1:0]   read_slot_o,
    input  wire [`RT_VISITS_BITS-1:0]  visits_i,
    input  wire [71:0]                colour_i,
    input  wire [31:0]                texture_i,
    // finished pixels
    output wire                       pix_valid_o,
    input  wire                       pix_ready_i,
    output wire [`RT_PIXEL_BITS-1:0]  pix_o,
    //: {TEXTURE[32], KEY[W+WD+2], VISITS[24], ID[24], COLOUR[72], Y[14], X[14]}
    output wire [3:0]                 fault_o          // by number of the error, machine.def
);
    localparam SLOTW = $clog2(SLOTS);
    localparam KW = W + WD + 2;
    localparam PB = INTERPENETRATE != 0 ? 1 : 0;     // bits of a flag about probes
    wire [`RT_EFFECT_BITS-1:0] effects    = regs_i[`RT_REGS_EFFECTS];
    wire [`RT_RGB_BITS-1:0] background = regs_i[`RT_REGS_BACKGROUND];
    wire             again_valid;                    // a primary ray is to be repeated
    wire [SLOTW-1:0] again_slot;
    wire [3*WD-1:0]  again_dir;

    // ---- free slots: all of them after reset, then those that were delivered; a queue for each
    // set-up unit; those that take a ray take turns ----
    localparam UB = $clog2(SETUPS), OWNW = SLOTW - UB;    // slot of a set-up unit
    localparam VB = `RT_VECTOR_BITS - UB;
    reg [SLOTW:0]    fill_q;                         // slots put into the queue after reset
    wire             filling = !fill_q[SLOTW];
    // A slot of each pipe in turn; of numbers for four pipes three may have slots.
    localparam NB = $clog2(PIPES);
    localparam [31:0] PIPE_MASK = (1 << NB) - 1;
    localparam UP = NB == 0 ? 0 : SLOTW - NB;             // bits that turn
    wire [SLOTW-1:0] fill_slot = fill_q[SLOTW-1:0] << UP | fill_q[SLOTW-1:0] >> NB;
    wire             fill_there = PIPES == 1 << NB ||
                                  ({{(31-SLOTW){1'b0}}, fill_q} & PIPE_MASK) < PIPES;
    wire             out_done;
    wire [SLOTW-1:0] free_slot, out_slot;
    wire [SLOTW-1:0] back = filling ? fill_slot : out_slot;       // a slot that becomes free
    wire             back_valid = filling ? fill_there : out_done;
    wire [SETUPS-1:0] free_valid, free_in;
    wire [SETUPS-1:0] free_may = filling || again_valid ? {SETUPS{1'b0}}
                                 : free_valid & primary_ready_i;
    wire [SETUPS-1:0] free_take;
    wire [SETUPS*OWNW-1:0] free_own;
    reg [SLOTW:0]    used_q;
    wire             taken = in_valid_i && in_ready_o;
    genvar u;
    generate
        for (u = 0; u < SETUPS; u = u + 1) begin : g_setup
            localparam [SLOTW:0] OWN = u;
            wire [VB-1:0] vector;
            rt_fifo #(.WIDTH(OWNW), .DEPTH(SLOTS >> UB)) u_free (
                .clk(clk), .rst(rst),
                .in_valid_i(back_valid && {1'b0, back} >> OWNW == OWN),
                .in_ready_o(free_in[u]), .in_data_i(back[OWNW-1:0]),
                .out_valid_o(free_valid[u]), .out_ready_i(in_valid_i && free_take[u]),
                .out_data_o(free_own[OWNW*u +: OWNW])
            );
            // with one set-up unit its ready is not looked at, which comes late
            assign vector[`RT_VECTOR_VALID] = again_valid || (in_valid_i &&
                (SETUPS > 1 ? free_take[u] : free_valid[u] && !filling));
            assign vector[`RT_VECTOR_VEC] = again_valid ? again_dir : start_i[`RT_START_DIR];
            assign vector[VB-1 -: OWNW] = again_valid ? again_slot[OWNW-1:0]
                                                      : free_own[OWNW*u +: OWNW];
            assign primary_o[VB*u +: VB] = vector;
        end
        if (SETUPS > 1) begin : g_choose
            wire [UB-1:0] one;                       // the set-up unit in turn
            rt_rr_arbiter #(.N(SETUPS)) u_turns (
                .clk(clk), .rst(rst), .asks_i(free_may), .served_i(taken),
                .turn_o(free_take), .index_o(one)
            );
            assign free_slot = {one, free_own[OWNW*one +: OWNW]};
        end else begin : g_only
            assign free_slot = free_own;
            assign free_take = free_may;
        end
    endgenerate
    assign in_ready_o      = |free_may;
    assign busy_o          = used_q != 0;
    always @(posedge clk) begin
        if (filling) fill_q <= fill_q + 1'b1;
        used_q <= used_q + {{SLOTW{1'b0}}, taken} - {{SLOTW{1'b0}}, out_done};
        if (rst) begin fill_q <= 0; used_q <= 0; end
    end

    // ---- rays that are done ----
    reg              t_valid_q, d_valid_q;           // rt_trace tells how; d_q is what it told
    reg [SLOTW-1:0]  t_slot_q, d_slot_q;
    reg [`RT_DONE_BITS-1:0] d_q;
    always @(posedge clk) begin
        t_valid_q <= done_valid_i;
        t_slot_q  <= done_slot_i;
        d_valid_q <= t_valid_q;
        d_slot_q  <= t_slot_q;
        if (t_valid_q) d_q <= done_i;
        if (rst) begin t_valid_q <= 1'b0; d_valid_q <= 1'b0; end
    end
    wire [`RT_ID_BITS-1:0] d_id      = d_q[`RT_DONE_ID];
    wire [`RT_LINE_BITS:0] d_line = {1'b0, regs_i[`RT_REGS_PRIM_BASE]} +
                                    {{(`RT_LINE_BITS+1-`RT_ID_BITS){1'b0}}, d_id};
    wire        d_outside = d_line >= {1'b0, regs_i[`RT_REGS_MEM_LINES]};
    wire        d_found   = d_q[`RT_DONE_FOUND] && !d_outside;
    wire        d_first   = d_q[`RT_DONE_PRIMARY];
    wire        d_shadow  = SHADOW != 0 && d_q[`RT_DONE_SHADOW];
    wire        d_valid   = d_valid_q && !d_shadow;
    wire        d_void, d_end;                       // a probe: the pixel starts again; is complete
    wire        d_on      = d_valid && !d_void && !d_end;
    reg              shadow_q, lit_q, hit_q, far_q, first_q, probe_q;
    reg              seen_q;                         // the first hit of a pixel
    reg              miss_q, sky_q, end_q;           // behind a mirror; to be delivered, blended
    reg              outside_q;
    reg [SLOTW-1:0]  slot_q;
    reg [`RT_ID_BITS-1:0] id_q;
    reg [KW-1:0]     key_q;
    always @(posedge clk) begin
        shadow_q  <= d_valid_q && d_shadow;
        slot_q    <= d_slot_q;
        lit_q     <= !d_q[`RT_DONE_FOUND];
        hit_q     <= d_on && d_found;
        miss_q    <= d_on && !d_found && !d_first;
        first_q   <= d_first;
        seen_q    <= d_valid && d_first && d_found;
        probe_q   <= d_q[`RT_DONE_FIRST] && effects[`RT_EFFECT_INTERPENETRATE];
        far_q     <= FARS != 0 && d_q[`RT_DONE_FAR];
        if (d_valid_q) {id_q, key_q} <= {d_id, d_q[`RT_DONE_KEY]};
        sky_q     <= (d_on && !d_found && d_first) || (d_valid && d_end);
        end_q     <= d_end;
        outside_q <= d_valid && d_q[`RT_DONE_FOUND] && d_outside;
        if (rst) begin
            shadow_q <= 1'b0; hit_q <= 1'b0; sky_q <= 1'b0; miss_q <= 1'b0; outside_q <= 1'b0;
        end
    end
    assign hit_o[`RT_HIT_HIT]    = hit_q;
    assign hit_o[`RT_HIT_MISS]   = miss_q;
    assign hit_o[`RT_HIT_SHADOW] = shadow_q;
    assign hit_o[`RT_HIT_SLOT]   = slot_q;
    assign hit_o[`RT_HIT_LIT]    = lit_q;
    assign hit_o[`RT_HIT_FIRST]  = first_q;
    assign hit_o[`RT_HIT_PROBE]  = PB != 0 && probe_q;
    assign hit_o[`RT_HIT_FAR]    = far_q;
    assign hit_o[`RT_HIT_ID]     = id_q;
    assign hit_o[`RT_HIT_KEY]    = key_q;
    assign fault_o[`RT_ERROR_BAD_NODE]       = outside_q;
    assign fault_o[`RT_ERROR_STACK_OVERFLOW] = 1'b0;
    assign fault_o[`RT_ERROR_VISIT_LIMIT]    = 1'b0;
    assign fault_o[`RT_ERROR_BUS_ERROR]      = 1'b0;

    // ---- first hits that may lie in another sphere ----
    generate
        if (INTERPENETRATE != 0) begin : g_probe
            rt_interpenetrate #(.WD(WD), .SLOTS(SLOTS)) u_probe (
                .clk(clk), .rst(rst),
                .pixel_valid_i(taken), .pixel_slot_i(free_slot),
                .pixel_dir_i(start_i[`RT_START_DIR]),
                .blend_valid_i(blend_i[`RT_BLEND_VALID]), .blend_slot_i(blend_i[`RT_BLEND_SLOT]),
                .blend_probe_i(blend_i[`RT_BLEND_PROBE]), .blend_last_i(blend_i[`RT_BLEND_LAST]),
                .ask_valid_i(t_valid_q), .ask_slot_i(t_slot_q),
                .done_valid_i(d_valid), .done_slot_i(d_slot_q), .done_primary_i(d_first),
                .done_found_i(d_found), .done_far_i(d_q[`RT_DONE_FAR]),
                .done_fars_i(d_q[`RT_DONE_FARS]),
                .done_void_o(d_void), .done_end_o(d_end),
                .again_valid_o(again_valid), .again_ready_i(primary_ready_i[0]),
                .again_slot_o(again_slot), .again_dir_o(again_dir),
                .ray_slot_i(ray_slot_i), .ray_again_o(ray_again_o)
            );
        end else begin : g_no_probe
            assign {d_void, d_end, again_valid, ray_again_o} = 4'd0;
            assign again_slot = {SLOTW{1'b0}};
            assign again_dir  = {3*WD{1'b0}};
            wire unused = &{1'b0, ray_slot_i, probe_q, d_q[`RT_DONE_FARS]};
        end
    endgenerate

    // ---- delivery: choose a slot | read what it leaves with | the pixel ----
    wire             o_blend, o_sky, o_blend_in, o_sky_in;
    wire [SLOTW:0]   o_end = {end_q, slot_q};
    wire [SLOTW+PB-1:0] o_next;
    wire [SLOTW-1:0] o_blend_slot, o_sky_slot, o_slot;
    reg              r_valid_q, r_sky_q, p_valid_q, p_sky_q;
    reg [SLOTW-1:0]  r_slot_q, p_slot_q;
    wire             p_load = !p_valid_q || pix_ready_i;
    wire             o_load = !r_valid_q || p_load;
    wire             r_read = r_valid_q && p_load;
    wire             o_turn_blend, o_turn_sky, o_one;      // both wait: in turn
    rt_rr_arbiter #(.N(2)) u_delivery (
        .clk(clk), .rst(rst), .asks_i({o_sky, o_blend}), .served_i(o_load && (o_blend || o_sky)),
        .turn_o({o_turn_sky, o_turn_blend}), .index_o(o_one)
    );
    assign           o_slot = o_turn_sky ? o_sky_slot : o_blend_slot;
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_blended (
        .clk(clk), .rst(rst), .in_valid_i(end_valid_i), .in_ready_o(o_blend_in),
        .in_data_i(end_slot_i),
        .out_valid_o(o_blend), .out_ready_i(o_load && o_turn_blend), .out_data_o(o_blend_slot)
    );
    rt_fifo #(.WIDTH(SLOTW+PB), .DEPTH(SLOTS)) u_skies (
        .clk(clk), .rst(rst), .in_valid_i(sky_q), .in_ready_o(o_sky_in),
        .in_data_i(o_end[SLOTW+PB-1:0]),
        .out_valid_o(o_sky), .out_ready_i(o_load && o_turn_sky), .out_data_o(o_next)
    );
    assign o_sky_slot = o_next[SLOTW-1:0];
    wire             o_sky_end = PB != 0 && o_next[SLOTW+PB-1];
    wire [`RT_ID_BITS-1:0] p_id;                           // of the primary hit
    wire [KW-1:0]    p_key;
    rt_slot_ram #(.WIDTH(28), .SLOTS(SLOTS), .OLD(0)) u_pixel (
        .clk(clk), .wr_en_i(taken), .wr_addr_i(free_slot),
        .wr_data_i({start_i[`RT_START_Y], start_i[`RT_START_X]}),
        .rd_en_i(r_read), .rd_addr_i(r_slot_q),
        .rd_data_o({pix_o[`RT_PIXEL_Y], pix_o[`RT_PIXEL_X]})
    );
    rt_slot_ram #(.WIDTH(KW+`RT_ID_BITS), .SLOTS(SLOTS), .OLD(0)) u_first (
        .clk(clk), .wr_en_i(seen_q), .wr_addr_i(slot_q), .wr_data_i({id_q, key_q}),
        .rd_en_i(r_read), .rd_addr_i(r_slot_q), .rd_data_o({p_id, p_key})
    );
    always @(posedge clk) begin
        if (o_load) begin
            r_valid_q  <= o_blend || o_sky;
            r_sky_q    <= o_turn_sky && !o_sky_end;
            r_slot_q   <= o_slot;
        end
        if (p_load) begin
            p_valid_q  <= r_valid_q;
            p_sky_q    <= r_sky_q;
            p_slot_q   <= r_slot_q;
        end
        if (rst) begin r_valid_q <= 1'b0; p_valid_q <= 1'b0; end
    end
    assign read_o      = r_read;
    assign read_slot_o = r_slot_q;
    assign pix_valid_o = p_valid_q;
    assign pix_o[`RT_PIXEL_COLOUR]  = p_sky_q ? {3{background}} : colour_i;
    assign pix_o[`RT_PIXEL_ID]      = p_sky_q ? `RT_ID_BITS'd`RT_ID_NONE : p_id;
    assign pix_o[`RT_PIXEL_KEY]     = p_sky_q ? {KW{1'b0}} : p_key;
    assign pix_o[`RT_PIXEL_VISITS]  = visits_i;
    assign pix_o[`RT_PIXEL_TEXTURE] = TEXTURE == 0 || p_sky_q ? {12'd`RT_LOD_NONE, 20'd0}
                                                              : texture_i;
    assign out_done    = pix_valid_o && pix_ready_i;
    assign out_slot    = p_slot_q;
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_rays_done /* verilator public_flat_rd */ =
        {1'b0, done_valid_i, 5'd0, done_valid_i};
    wire [7:0] work_pixels_delivered /* verilator public_flat_rd */ =
        {p_valid_q && !pix_ready_i, out_done, 5'd0, out_done};
    wire unused = &{1'b0, regs_i, effects, blend_i, free_in, again_slot, o_blend_in, o_sky_in,
                    o_one, o_end, texture_i};
endmodule
`default_nettype wire
