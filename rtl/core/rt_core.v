// rt_core.v - the ray tracer: registers, pixel walk, engines, memory port, counters
// SPDX-License-Identifier: Apache-2.0
// Ports and their order of use: docs/reference/core.md. Borodavka et al. VII: Rendering, L1
// and L2 come out of one pass as the colours at reflection depth 0, 1 and the deepest.
// Model: sph_render() in cmodel/render/render.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_core #(
    `include "rt_core_parameters.vh"
) (
    input  wire              clk,
    input  wire              rst,
    // registers, written while the core is idle; a write while it is busy is ignored
    input  wire              cfg_valid_i,
    input  wire [6:0]        cfg_addr_i,
    input  wire [31:0]       cfg_data_i,
    // a frame
    input  wire              start_i,          // one cycle: clear counters, render the window
    input  wire              keep_cache_i,     // with start_i: memory did not change, caches stay
    output wire              busy_o,           // until the last pixel has left and counters stand
    output wire              active_o,         // 0: clk may stand still in this cycle
    // memory: 256-bit lines, asked for by number; beats of MEM_DATA, low bits first; lines of a tag
    // in order, several tags in any, their beats too
    output wire              mem_req_valid_o,
    input  wire              mem_req_ready_i,
    output wire [`RT_LINE_BITS-1:0] mem_req_line_o,
    output wire [`RT_TAG_BITS-1:0] mem_req_tag_o,
    input  wire              mem_rsp_valid_i,
    output wire              mem_rsp_ready_o,
    input  wire [`RT_TAG_BITS-1:0] mem_rsp_tag_i,
    input  wire [MEM_DATA-1:0] mem_rsp_data_i,
    input  wire              mem_rsp_error_i,
    // finished pixels, in any order
    output wire              pix_valid_o,
    input  wire              pix_ready_i,
    output wire [13:0]       pix_x_o,
    output wire [13:0]       pix_y_o,
    output wire [71:0]       pix_colour_o,     // {L2, L1, Rendering}, each 0xBBGGRR
    output wire [`RT_RGB_BITS-1:0] pix_frame_o,      // the one of them that register FRAME selects
    output wire [`RT_ID_BITS-1:0] pix_id_o,         // primitive of the primary hit, all ones: none
    output wire [W+WD+1:0]   pix_key_o,        // key of that hit, 0: none
    output wire [`RT_VISITS_BITS-1:0] pix_visits_o,     // node visits of all rays of the pixel
    output wire [31:0]       pix_texture_o,    // {lod u4.8 of its first texture, sum of addresses}
    // counters and sticky errors
    input  wire [4:0]        count_addr_i,     // number of a counter
    output wire [47:0]       count_data_o,     // the counter, a cycle later
    output reg  [`RT_ERRORS-1:0] errors_o      // a bit an error, until the next start_i
);
    localparam KW = W + WD + 2;
    localparam CB = `RT_RGB_BITS, IB = `RT_ID_BITS, LB = `RT_LINE_BITS, VB = `RT_VISITS_BITS;
    localparam PV = 28 + 3*CB + IB + KW + VB;        // a finished pixel
    localparam PW = PV + (TEXTURE != 0 ? 32 : 0);    // and its word of texture
    localparam PLACES = `RT_COUNTERS_USED > 16 ? 32 : 16;  // counters
    localparam EW = 8*PLACES;                        // their events of a cycle
    localparam SEPARATED = RECT != 0 || SPANS != 0 || CONES != 0;  // background goes by itself

    // ---- registers, start ----
    wire [31:0]      effects, profile;
    wire [1:0]       frame;
    wire [3:0]       coarse;
    wire [55:0]      window, rect;
    wire [1:0]       bg_mode;
    wire [`RT_LINE_BITS-1:0] bg_base;
    wire [4:0]       bg_count;
    wire [3*WD-1:0]  dir;
    wire [WD-1:0]    pitch;
    wire [95:0]      dir_first, dir_across, dir_down;    // with TURNED
    wire [`RT_REGS_BITS-1:0] regs;                      // what an engine looks at
    wire             light_valid;
    wire [2:0]       light_number, light_part;
    wire             bih, boxes, strayed;
    // A write and a start are registered: a write takes a clock more, a start two, so that the
    // look at what the machine asks for takes a clock of its own.
    reg              cfg_valid_q, start_q, start_two_q, keep_q, keep_two_q, missing_q, foreign_q;
    reg              strayed_q;
    reg  [6:0]       cfg_addr_q;
    reg  [31:0]      cfg_data_q;
    rt_registers #(.W(W), .WD(WD), .TEXTURE(TEXTURE), .SMOOTH(SMOOTH), .ACCEL(ACCEL),
                   .TURNED(TURNED), .CAMERA(CAMERA)) u_registers (
        .clk(clk), .valid_i(cfg_valid_q), .addr_i(cfg_addr_q), .data_i(cfg_data_q),
        .effects_o(effects), .regs_o(regs), .window_o(window), .bg_mode_o(bg_mode),
        .rect_o(rect), .bg_base_o(bg_base), .bg_count_o(bg_count), .dir_o(dir), .pitch_o(pitch),
        .first_o(dir_first), .across_o(dir_across), .down_o(dir_down), .profile_o(profile),
        .frame_o(frame), .coarse_o(coarse), .bih_o(bih), .boxes_o(boxes),
        .strayed_o(strayed), .light_valid_o(light_valid), .light_number_o(light_number),
        .light_part_o(light_part)
    );
    wire [`RT_LIGHT_BITS-1:0] light;
    assign light[`RT_LIGHT_VALID]     = light_valid;
    assign light[`RT_LIGHT_NUMBER]    = light_number;
    assign light[`RT_LIGHT_PART]      = light_part;
    assign light[`RT_LIGHT_DATA]      = cfg_data_q;
    wire [31:0] built = `RT_EFFECTS_BUILT;
    wire [3:0]  ways  = {CONES != 0, SPANS != 0, RECT != 0, 1'b1};
    wire missing = (effects & ~built) != 32'd0 ||    // the machine asks for what is not here
                   bih != (ACCEL != 0) || boxes != (BOXES != 0) ||
                   coarse != (TEXTURE != 0 ? COARSE[3:0] : 4'd0) ||
                   {28'd0, regs[`RT_REGS_MAX_DEPTH]} > `RT_DEEPEST ||
                   {28'd0, regs[`RT_REGS_N_LIGHTS]} > LIGHTS ||
                   regs[`RT_REGS_MEM_LINES] >> LINE_BITS != 0 ||
                   !ways[bg_mode] || (bg_mode == 2'd3 && {27'd0, bg_count} > CONES);
    localparam [31:0] PROFILE = W << `RT_WIDTH_W_LSB | WD << `RT_WIDTH_WD_LSB |
                                PQ << `RT_WIDTH_PQ_LSB | NG << `RT_WIDTH_NG_LSB |
                                FW << `RT_WIDTH_FW_LSB | PR << `RT_WIDTH_PR_LSB;
    wire foreign = profile != PROFILE;               // built for other widths
    wire start   = start_two_q;
    wire go      = start && !missing_q && !foreign_q && !strayed_q;
    always @(posedge clk) begin
        cfg_valid_q <= cfg_valid_i && !busy_o;
        cfg_addr_q  <= cfg_addr_i;
        cfg_data_q  <= cfg_data_i;
        start_q     <= start_i && !busy_o;
        start_two_q <= start_q;
        keep_q      <= keep_cache_i;
        keep_two_q  <= keep_q;
        missing_q   <= missing;
        foreign_q   <= foreign;
        strayed_q   <= strayed;
        if (rst) begin cfg_valid_q <= 1'b0; start_q <= 1'b0; start_two_q <= 1'b0; end
    end

    // ---- units of an engine; numbers of its slots, {pipe, slot of its own} ----
    `include "rt_core_rules.vh"  // how many; legal values, alone and together
    // What a block RAM is worth in LUTs: four pipes ask for more than there are, as they do of
    // multipliers; three leave enough of these for the squares of their filters.
    localparam SPARE_LUTS = SPILLS == 2 || (SPILLS == 0 && PIPES > 2) ? (PIPES == 4 ? 24 : 16) : 0;
    localparam LUT_SQUARES = SQUARES == 2 || (SQUARES == 0 && PIPES == 4) ? 1 : 0;
    // Behind boxes are triangles: tests keep up with a visit a clock. Elsewhere a wide
    // facet, whose operands exceed a multiplier of 18 bits, takes its time.
    localparam FACET_CLOCKS = FACET_INTERVAL != 0 ? FACET_INTERVAL
                              : BOXES != 0 || W < 18 ? 2 : 4;
    localparam ROOT_STAGES = ROOTS != 0 ? ROOTS : PIPES > 1 ? 12 : 6;
    // Beside others a pipe sees fewer neighbours; block RAM has the room in any case.
    localparam LEAF_UNIT = PIPES > 1 ? 4*LEAF_LINES : LEAF_LINES;
    localparam ALL_SLOTS = SLOTS << $clog2(PIPES);

    // ---- memory: READS readers an engine, and the walks above them if they have tables ----
    localparam ALL_WALKS = WALKS != 0 ? WALKS : PIPES > 1 ? 2 : 1;
    localparam READS   = PIPES + LEAF_COUNT + (TEXTURE != 0 ? SHADE_UNITS : 0);
    localparam WALK    = READS*ENGINES;
    localparam ALL     = WALK + ALL_WALKS;
    localparam READERS = SPANS != 0 || CONES != 0 ? ALL : WALK;
    wire [ALL-1:0]           m_req_valid, m_req_ready, m_rsp_valid, m_rsp_ready;
    wire [LB*ALL-1:0]        m_req_line;
    wire [255:0]             m_rsp_data;
    wire                     m_rsp_error, bad_table, table_error, m_busy;
    generate
        if (READERS < ALL) begin : g_no_tables
            assign m_req_ready[ALL-1:WALK] = {ALL_WALKS{1'b0}};
            assign m_rsp_valid[ALL-1:WALK] = {ALL_WALKS{1'b0}};
            wire unused = &{1'b0, m_req_valid, m_rsp_ready, m_req_line};
        end
    endgenerate
    rt_mem_arbiter #(.CLIENTS(READERS), .PENDING(LINES_COMING), .DATA(MEM_DATA)) u_arbiter (
        .clk(clk), .rst(rst),
        .req_valid_i(m_req_valid[READERS-1:0]), .req_ready_o(m_req_ready[READERS-1:0]),
        .req_line_i(m_req_line[LB*READERS-1:0]),
        .rsp_valid_o(m_rsp_valid[READERS-1:0]), .rsp_ready_i(m_rsp_ready[READERS-1:0]),
        .rsp_data_o(m_rsp_data), .rsp_error_o(m_rsp_error), .busy_o(m_busy),
        .mem_req_valid_o(mem_req_valid_o), .mem_req_ready_i(mem_req_ready_i),
        .mem_req_line_o(mem_req_line_o), .mem_req_tag_o(mem_req_tag_o),
        .mem_rsp_valid_i(mem_rsp_valid_i), .mem_rsp_ready_o(mem_rsp_ready_o),
        .mem_rsp_tag_i(mem_rsp_tag_i), .mem_rsp_data_i(mem_rsp_data_i),
        .mem_rsp_error_i(mem_rsp_error_i)
    );

    // ---- pixels of the window ----
    wire             walk_busy, ray_valid, bg_valid, bg_ready;
    wire [27:0]      bg_place;
    wire [`RT_START_BITS-1:0] pixel;                 // the next one to trace
    wire [ENGINES-1:0] e_ready, e_take, e_busy;
    rt_pixel_scans #(.W(W), .WD(WD), .RECT(RECT), .SPANS(SPANS), .CONES(CONES),
               .TURNED(TURNED), .WALKS(ALL_WALKS)) u_walks (
        .clk(clk), .rst(rst), .start_i(go), .busy_o(walk_busy),
        .window_i(window), .dir_i(dir), .pitch_i(pitch),
        .first_i(dir_first), .across_i(dir_across), .down_i(dir_down),
        .bg_mode_i(bg_mode), .rect_i(rect), .bg_base_i(bg_base),
        .bg_count_i(bg_count), .mem_lines_i(regs[`RT_REGS_MEM_LINES]),
        .ray_valid_o(ray_valid), .ray_ready_i(|e_ready), .ray_o(pixel),
        .bg_valid_o(bg_valid), .bg_ready_i(bg_ready), .bg_place_o(bg_place),
        .mem_req_valid_o(m_req_valid[ALL-1:WALK]), .mem_req_ready_i(m_req_ready[ALL-1:WALK]),
        .mem_req_line_o(m_req_line[LB*WALK +: LB*ALL_WALKS]),
        .mem_rsp_valid_i(m_rsp_valid[ALL-1:WALK]), .mem_rsp_ready_o(m_rsp_ready[ALL-1:WALK]),
        .mem_rsp_data_i(m_rsp_data), .mem_rsp_error_i(m_rsp_error),
        .bad_table_o(bad_table), .bus_error_o(table_error)
    );
    assign e_take = e_ready & (~e_ready + 1'b1);     // the lowest engine with a free slot
    reg              mux_valid_q;                    // a pixel is at the port
    wire             mux_ready = !mux_valid_q || pix_ready_i;
    wire             working = walk_busy || e_busy != 0 || mux_valid_q;
    localparam SB = $clog2(PLACES + 6);
    localparam [31:0] WAIT = PLACES + 5;
    // cycles until the counters are complete: from the clock of go on, before any work begins
    reg [SB-1:0]     settle_q;
    assign busy_o = settle_q != {SB{1'b0}} || start_q || start_two_q;
    always @(posedge clk) begin
        if (working || go) settle_q <= WAIT[SB-1:0];
        else if (settle_q != {SB{1'b0}}) settle_q <= settle_q - 1'b1;
        if (rst) settle_q <= {SB{1'b0}};
    end

    // ---- what an idle core still looks at ----
    reg [4:0]        count_addr_q;
    assign active_o = rst || busy_o || m_busy || start_i || cfg_valid_i || cfg_valid_q ||
                      count_addr_i != count_addr_q;
    always @(posedge clk) count_addr_q <= count_addr_i;

    // ---- engines ----
    wire [ENGINES-1:0]     p_valid, p_take;
    wire [ENGINES*PW-1:0]  p_data;
    wire [ENGINES*EW-1:0]  events;
    wire [ENGINES-1:0]     issued;
    wire [ENGINES*16-1:0]  faults;
    genvar e;
    generate
        for (e = 0; e < ENGINES; e = e + 1) begin : g_engine
            localparam TB = PIPES*`RT_TRACE_EVENT_BITS, XB = LEAF_COUNT*`RT_EXACT_EVENT_BITS;
            localparam HB = SHADE_UNITS*`RT_SHADE_EVENT_BITS;
            localparam TE = `RT_TRACE_EVENT_BITS, XE = `RT_EXACT_EVENT_BITS;
            localparam HE = `RT_SHADE_EVENT_BITS;
            wire [TB+XB+HB-1:0]       event_e;
            wire [`RT_PIXEL_BITS-1:0] pix;
            rt_engine #(
                `include "rt_effects_pass.vh"
                `include "rt_shade_pass.vh"
                .ACCEL(BOXES != 0 ? 2 : ACCEL), .PIPES(PIPES),
                .LEAF_UNITS(LEAF_COUNT), .SHADES(SHADE_UNITS), .SETUPS(SETUP_UNITS),
                .SLOTS(ALL_SLOTS), .SQUARES(LUT_SQUARES), .LUTS(SPARE_LUTS),
                .STACK(`RT_STACK_DEPTH), .NODE_LINES(NODE_LINES), .LEAF_LINES(LEAF_UNIT),
                .ROOTS(ROOT_STAGES), .ROOT_STEP(ROOT_STEP), .LEAF_INTERVAL(LEAF_INTERVAL),
                .FACET_INTERVAL(FACET_CLOCKS), .UNITS(UNITS), .UNIT_INTERVAL(UNIT_INTERVAL)
            ) u_engine (
                .clk(clk), .rst(rst), .flush_i(go && !keep_two_q), .busy_o(e_busy[e]),
                .regs_i(regs), .light_i(light),
                .in_valid_i(ray_valid && e_take[e]), .in_ready_o(e_ready[e]), .start_i(pixel),
                .pix_valid_o(p_valid[e]), .pix_ready_i(p_take[e] && mux_ready), .pix_o(pix),
                .mem_req_valid_o(m_req_valid[READS*e +: READS]),
                .mem_req_ready_i(m_req_ready[READS*e +: READS]),
                .mem_req_line_o(m_req_line[LB*READS*e +: LB*READS]),
                .mem_rsp_valid_i(m_rsp_valid[READS*e +: READS]),
                .mem_rsp_ready_o(m_rsp_ready[READS*e +: READS]),
                .mem_rsp_data_i(m_rsp_data), .mem_rsp_error_i(m_rsp_error),
                .trace_event_o(event_e[0 +: TB]), .exact_event_o(event_e[TB +: XB]),
                .shade_event_o(event_e[TB+XB +: HB]), .fault_o(faults[16*e +: 16])
            );
            assign p_data[PW*e +: PW] = pix[PW-1:0];
            // ---- events of its units, summed up ----
            reg                           issued_e;
            reg [255:0]                   add_e;     // as if PLACES were 32
            reg [`RT_TRACE_EVENT_BITS-1:0] trace;
            reg [`RT_EXACT_EVENT_BITS-1:0] exact;
            reg [`RT_PRIM_EVENT_BITS-1:0] prim;
            reg [`RT_SHADE_EVENT_BITS-1:0] shade;
            integer                         u;
            always @* begin
                add_e    = 256'd0;
                issued_e = 1'b0;
                trace    = event_e[0 +: TE];
                exact    = event_e[TB +: XE];
                prim     = exact[`RT_EXACT_EVENT_PRIM];
                shade    = event_e[TB + XB +: HE];
                for (u = 0; u < PIPES; u = u + 1) begin
                    trace = event_e[TE*u +: TE];
                    issued_e = issued_e || trace[`RT_TRACE_EVENT_ISSUED];
                    `RT_TRACE_EVENT_ADDS
                end
                for (u = 0; u < LEAF_COUNT; u = u + 1) begin
                    exact = event_e[TB + XE*u +: XE];
                    prim  = exact[`RT_EXACT_EVENT_PRIM];
                    `RT_EXACT_EVENT_ADDS
                    `RT_PRIM_EVENT_ADDS
                end
                for (u = 0; u < SHADE_UNITS; u = u + 1) begin
                    shade = event_e[TB + XB + HE*u +: HE];
                    `RT_SHADE_EVENT_ADDS
                end
            end
            assign events[EW*e +: EW] = add_e[EW-1:0];
            assign issued[e] = issued_e;
`ifndef SYNTHESIS
            // what active_o relies on: formal/f_engine.v
            reg [READS-1:0] asked_q;
            always @(posedge clk) begin
                asked_q <= m_req_valid[READS*e +: READS];
                if (!rst && !e_busy[e] && (p_valid[e] || issued_e || add_e != 256'd0 ||
                                           faults[16*e +: 16] != 16'd0 ||
                                           (m_req_valid[READS*e +: READS] & ~asked_q) != 0)) begin
                    $display("%m: an idle engine works");
                    $finish;
                end
            end
`endif
            wire unused_e = &{1'b0, pix, add_e, trace, exact, prim, shade};
        end
    endgenerate
    // ---- pixel port: engines first, then background ----
    reg [PW-1:0]  mux_q, mux_next;
    assign p_take   = p_valid & (~p_valid + 1'b1);
    assign bg_ready = SEPARATED && mux_ready && p_valid == 0;
    wire [31:0]   untextured = {12'd`RT_LOD_NONE, 20'd0};
    wire [PV+31:0] sky = {untextured, {KW{1'b0}}, {VB{1'b0}}, `RT_ID_BITS'd`RT_ID_NONE,
                           {3{regs[`RT_REGS_BACKGROUND]}}, bg_place};
    wire unused_sky = &{1'b0, sky};
    integer i;
    always @* begin
        mux_next = SEPARATED ? sky[PW-1:0] : p_data[PW-1:0];
        for (i = 0; i < ENGINES; i = i + 1)
            if (p_take[i]) mux_next = p_data[PW*i +: PW];
    end
    always @(posedge clk) begin
        if (mux_ready) begin
            mux_valid_q <= (SEPARATED && bg_valid) || p_valid != 0;
            mux_q       <= mux_next;
        end
        if (rst) mux_valid_q <= 1'b0;
    end
    assign pix_valid_o = mux_valid_q;
    assign {pix_key_o, pix_visits_o, pix_id_o, pix_colour_o, pix_y_o, pix_x_o} = mux_q[PV-1:0];
    assign pix_texture_o = TEXTURE != 0 ? mux_q[PW-1 -: 32] : untextured;

    assign pix_frame_o = frame == 2'd0 ? pix_colour_o[0 +: CB]
                         : frame == 2'd1 ? pix_colour_o[CB +: CB] : pix_colour_o[2*CB +: CB];

    // ---- counters: sums over the engines ----
    wire [EW-1:0] shell_events;
    wire          issue_idle  /* verilator public_flat_rd */ = ray_valid && issued == 0;
    assign shell_events[8*`RT_COUNT_RAYS_PRIMARY   +: 64] = 64'd0;  // up to QUOTIENTS
    assign shell_events[8*`RT_COUNT_BACKGROUND     +: 8] = {7'd0, bg_valid && bg_ready};
    assign shell_events[8*`RT_COUNT_SATURATIONS    +: 8] = 8'd0;
    assign shell_events[8*`RT_COUNT_CYCLES         +: 8] = {6'd0, go, working};  // 2: from start_i
    assign shell_events[8*`RT_COUNT_ISSUE_WAIT     +: 8] = {7'd0, issue_idle};
    assign shell_events[8*`RT_COUNT_NODE_MISSES    +: 8] = 8'd0;
    assign shell_events[8*`RT_COUNT_LEAF_MISSES    +: 8] = 8'd0;
    assign shell_events[8*`RT_COUNT_RAYS_WAITING   +: 8] = {7'd0, ray_valid};
    assign shell_events[8*`RT_COUNT_POP_BUBBLES    +: 8] = 8'd0;
    generate
        if (PLACES > 16) begin : g_more
            assign shell_events[EW-1:128] = {(EW-128){1'b0}};
        end
    endgenerate
    reg [EW-1:0] add;
    integer n, k;
    always @* begin
        add = shell_events;
        for (n = 0; n < ENGINES; n = n + 1)
            for (k = 0; k < PLACES; k = k + 1)
                add[8*k +: 8] = add[8*k +: 8] + events[EW*n + 8*k +: 8];
    end
    reg [EW-1:0] add_q;
    always @(posedge clk) add_q <= add;
    localparam MOST = PLACES == 16 && ENGINES*PIPES == 1 ? 7 : 63;  // four children a visit
    rt_counters #(.PLACES(PLACES), .MOST(MOST), .USED(`RT_COUNTERS_USED)) u_counters (
        .clk(clk), .rst(rst), .clear_i(go), .add_i(add_q),
        .addr_i(count_addr_i), .data_o(count_data_o)
    );

    // ---- sticky errors ----
    reg [3:0] fault;
    integer m;
    always @* begin
        fault = {table_error, 2'd0, bad_table};
        for (m = 0; m < 4*ENGINES; m = m + 1) fault = fault | faults[4*m +: 4];
    end
    always @(posedge clk) begin
        if (start) errors_o <= 0;
        if (fault[0]) errors_o[`RT_ERROR_BAD_NODE]       <= 1'b1;
        if (fault[1]) errors_o[`RT_ERROR_STACK_OVERFLOW] <= 1'b1;
        if (fault[2]) errors_o[`RT_ERROR_VISIT_LIMIT]    <= 1'b1;
        if (fault[3]) errors_o[`RT_ERROR_BUS_ERROR]      <= 1'b1;
        if (start && missing_q) errors_o[`RT_ERROR_MISSING_EFFECT] <= 1'b1;
        if (start && foreign_q) errors_o[`RT_ERROR_WRONG_PROFILE]  <= 1'b1;
        if (start && strayed_q) errors_o[`RT_ERROR_LEFT_OUT]       <= 1'b1;
        if (rst) errors_o <= 0;
    end
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_pixel_port /* verilator public_flat_rd */ =
        {mux_valid_q && !pix_ready_i, mux_valid_q && pix_ready_i, 5'd0, mux_valid_q};
endmodule
`default_nettype wire
