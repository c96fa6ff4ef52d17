// rt_lights.v - walks a surface's lights and sums what they give
// SPDX-License-Identifier: Apache-2.0
// Every event adds one light's share to the slot's sum (nothing at the start, or in shadow), then
// sends the vector to the next light to rt_setup, or the token on to rt_compose. An event goes in
// every 3 clocks, and a vector is made in 3, a component each:
//   a_valid | read the point | 1 its component | 1 the vector's | ... the third leaves 5 clocks on
// Without shadow rays there is no queue for them; a light that is the only one has no number. A
// vector is light - round(point / 2^shift).
// Model: sph_job_light() in cmodel/engine/render_light.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
`include "rt_layout.vh"
module rt_lights #(
    parameter W     = 16,  // coordinate, bits
    parameter WD    = 17,  // direction component, bits, at least W+1
    parameter LIGHTS = 8,  // lights that are kept, 1..8
    parameter SHADOW = 1,  // 1: shadow rays end here, 0: none do, or rt_specular_lights has them
    parameter AMBIENT = 1, // 0: the sum starts from nothing
    parameter GLOSS = 0,   // 1: highlights are summed too
    parameter LUTS  = 0,   // LUT cells that a block RAM is worth, rt_slot_ram
    parameter SLOTS = 32  // power of two
) (
    input  wire              clk,
    input  wire              rst,
    // registers
    input  wire [3:0]        n_lights_i,      // 0..8
    input  wire [47:0]       ambient_i,       // {blue, green, red} u1.15
    input  wire              light_valid_i,   // writes one part of one light
    input  wire [2:0]        light_number_i,
    input  wire [2:0]        light_part_i,    // 0..2: x, y, z sWD; 3..5: red, green, blue u1.15
    input  wire [31:0]       light_data_i,
    // from rt_surface
    input  wire              point_valid_i,
    input  wire [$clog2(SLOTS)-1:0] point_slot_i,
    input  wire [3*W-1:0]    point_i,
    // from rt_cosine, rt_texture, rt_specular_lights
    input  wire              cosine_valid_i,
    input  wire [$clog2(SLOTS)-1:0] cosine_slot_i,
    input  wire [15:0]       cosine_i,
    input  wire              start_valid_i,   // a surface is ready
    input  wire [$clog2(SLOTS)-1:0] start_slot_i,
    input  wire              decided_valid_i,    // a light decided without a shadow ray
    input  wire [$clog2(SLOTS)-1:0] decided_slot_i,
    input  wire              decided_lit_i,
    input  wire [15:0]       decided_highlight_i, // u1.15, with GLOSS
    // a shadow ray is done
    input  wire              shadow_valid_i,
    input  wire [$clog2(SLOTS)-1:0] shadow_slot_i,
    input  wire              shadow_lit_i,
    // to rt_setup: vector to the next light
    output reg               vec_valid_o,
    output reg [$clog2(SLOTS)-1:0] vec_slot_o,
    output wire [3*WD-1:0]   vec_o,
    // to rt_compose: all lights are summed
    output reg               sum_valid_o,
    output reg [$clog2(SLOTS)-1:0] sum_slot_o,
    output reg [50:0]        sum_o,           // 3 x u2.15
    output wire [50:0]       gloss_o          // the same of highlights
);
    localparam SLOTW = $clog2(SLOTS);
    localparam HB = GLOSS != 0 ? 16 : 0;              // bits of a highlight
    localparam NW = $clog2(LIGHTS + 1);               // number of lights
    localparam LW = LIGHTS > 1 ? $clog2(LIGHTS) : 1;  // number of a light
    localparam PB = $clog2(4*LIGHTS);                 // number of a component of a light
    localparam EW = `RT_LIGHT_SHIFT_BITS;
    `RT_CHECK(LIGHTS >= 1 && LIGHTS <= 8, rt_lights_LIGHTS_must_be_1_to_8)
    wire             a_valid;                         // an event left the adder
    wire [SLOTW-1:0] a_slot;
    wire [NW-1:0]    a_next;                          // the light to go to
    wire [50:0]      a_sum;
    reg [SLOTW-1:0]  e_slot_q;                        // an event stands before the adder
    reg              e_valid_q, e_start_q, e_lit_q;
    wire             read;                            // what belongs to slot is read for it
    wire [SLOTW-1:0] slot;

    // ---- the lights; the number of the light that a slot is at ----
    reg  [1:0]     turn_q;                            // x, y, z in the clocks 0, 1, 2 from a_valid
    wire [1:0]     turn = a_valid ? 2'd0 : turn_q;
    wire [WD-1:0]  pos;                               // of the light of a_next
    wire [EW-1:0]  shift;                             // its unit is 2^shift grid units
    wire [47:0]    colour;                            // of the light whose event enters the adder
    wire [NW-1:0]  e_next;                            // the one after it
    wire           keep = light_valid_i && {29'd0, light_number_i} < LIGHTS;
    wire [LW-1:0]  a_light;                           // the number, 0 of the only one
    wire [LW-1:0]  k_light;                           // that of the light that is kept
    wire [LW+1:0]  a_part = {a_light, turn};
    wire [LW+1:0]  k_part = {k_light, light_part_i[1:0]};
    rt_slot_file #(.WIDTH(WD), .SLOTS(4*LIGHTS)) u_pos (
        .clk(clk), .wr_en_i(keep && light_part_i < 3'd3),
        .wr_addr_i(k_part[PB-1:0]), .wr_data_i(light_data_i[WD-1:0]),
        .rd_addr_i(a_part[PB-1:0]), .rd_data_o(pos)
    );
    genvar c;
    generate
        if (LIGHTS == 1) begin : g_one
            reg [EW-1:0]  shift_q;
            reg [47:0]    colour_q;
            for (c = 0; c < 3; c = c + 1) begin : g_part
                always @(posedge clk)
                    if (keep && light_part_i == c + 3) colour_q[16*c +: 16] <= light_data_i[15:0];
            end
            always @(posedge clk)
                if (keep && light_part_i == 3'd3)
                    shift_q <= light_data_i[`RT_LIGHT_SHIFT_LSB +: EW];
            assign a_light = 1'b0;
            assign k_light = 1'b0;
            assign shift   = shift_q;
            assign colour  = colour_q;
            assign e_next  = !e_start_q;
            wire unused = read;
        end else begin : g_more
            wire [LW-1:0] e_light;                    // the light that the event is about
            wire [LW-1:0] e_next_light = e_start_q ? {LW{1'b0}} : e_light;
            wire [NW:0]   after  = {{(NW+1-LW){1'b0}}, e_next_light} + 1'b1;
            reg  [LW-1:0] a_light_q;                  // until z has left
            assign a_light = a_valid ? a_next[LW-1:0] : a_light_q;
            always @(posedge clk) a_light_q <= a_light;
            assign k_light = light_number_i[LW-1:0];
            assign e_next  = e_start_q ? {NW{1'b0}} : after[NW-1:0];
            rt_slot_ram #(.WIDTH(LW), .SLOTS(SLOTS), .OLD(0), .LUTS(LUTS)) u_light (
                .clk(clk), .wr_en_i(a_valid), .wr_addr_i(a_slot), .wr_data_i(a_light),
                .rd_en_i(read), .rd_addr_i(slot), .rd_data_o(e_light)
            );
            rt_slot_file #(.WIDTH(EW), .SLOTS(LIGHTS)) u_shift (
                .clk(clk), .wr_en_i(keep && light_part_i == 3'd3), .wr_addr_i(k_light),
                .wr_data_i(light_data_i[`RT_LIGHT_SHIFT_LSB +: EW]),
                .rd_addr_i(a_light), .rd_data_o(shift)
            );
            for (c = 0; c < 3; c = c + 1) begin : g_part
                rt_slot_file #(.WIDTH(16), .SLOTS(LIGHTS)) u_colour (
                    .clk(clk), .wr_en_i(keep && light_part_i == c + 3),
                    .wr_addr_i(k_light), .wr_data_i(light_data_i[15:0]),
                    .rd_addr_i(e_next_light), .rd_data_o(colour[16*c +: 16])
                );
            end
            wire unused = after[NW];
        end
    endgenerate

    // ---- queues of events ----
    wire             s_valid, l_valid, t_valid, s_in, l_in, t_in, add_ready;
    wire [SLOTW-1:0] s_slot;
    wire [SLOTW:0]   t_event;
    wire [SLOTW+HB:0] l_event;                        // {highlight, slot, lit}
    wire [SLOTW+16:0] l_new = {decided_highlight_i, decided_slot_i, decided_lit_i};
    wire             e_load = !e_valid_q || add_ready;
    wire             pick_t = t_valid;
    wire             pick_l = !t_valid && l_valid;
    wire             pick_s = !t_valid && !l_valid && s_valid;
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_starts (
        .clk(clk), .rst(rst), .in_valid_i(start_valid_i), .in_ready_o(s_in),
        .in_data_i(start_slot_i),
        .out_valid_o(s_valid), .out_ready_i(e_load && pick_s), .out_data_o(s_slot)
    );
    rt_fifo #(.WIDTH(SLOTW+1+HB), .DEPTH(SLOTS)) u_decided (
        .clk(clk), .rst(rst), .in_valid_i(decided_valid_i), .in_ready_o(l_in),
        .in_data_i(l_new[SLOTW+HB:0]),
        .out_valid_o(l_valid), .out_ready_i(e_load && pick_l), .out_data_o(l_event)
    );
    generate
        if (SHADOW != 0) begin : g_shadow
            rt_fifo #(.WIDTH(SLOTW+1), .DEPTH(SLOTS)) u_shadows (
                .clk(clk), .rst(rst), .in_valid_i(shadow_valid_i), .in_ready_o(t_in),
                .in_data_i({shadow_slot_i, shadow_lit_i}),
                .out_valid_o(t_valid), .out_ready_i(e_load && pick_t), .out_data_o(t_event)
            );
        end else begin : g_decided
            assign {t_valid, t_in, t_event} = {(SLOTW+3){1'b0}};
            wire unused = &{1'b0, shadow_valid_i, shadow_slot_i, shadow_lit_i};
        end
    endgenerate

    // ---- event, with the slot's sum and cosine ----
    assign slot = pick_t ? t_event[SLOTW:1] : pick_l ? l_event[SLOTW:1] : s_slot;
    assign read = e_load && (pick_t || pick_l || pick_s);
    wire [50:0]      e_sum;
    wire [15:0]      e_cosine;
    always @(posedge clk) begin
        if (e_load) begin
            e_valid_q <= pick_t || pick_l || pick_s;
            e_slot_q  <= slot;
            e_start_q <= pick_s;
            e_lit_q   <= pick_t ? t_event[0] : pick_l && l_event[0];
        end
        if (rst) e_valid_q <= 1'b0;
    end
    rt_slot_ram #(.WIDTH(51), .SLOTS(SLOTS), .OLD(0)) u_sum (
        .clk(clk), .wr_en_i(a_valid), .wr_addr_i(a_slot), .wr_data_i(a_sum),
        .rd_en_i(read), .rd_addr_i(slot), .rd_data_o(e_sum)
    );
    rt_slot_ram #(.WIDTH(16), .SLOTS(SLOTS), .OLD(0)) u_cosine (
        .clk(clk), .wr_en_i(cosine_valid_i), .wr_addr_i(cosine_slot_i), .wr_data_i(cosine_i),
        .rd_en_i(read), .rd_addr_i(slot), .rd_data_o(e_cosine)
    );

    // ---- add ----
    wire [50:0] ambient = AMBIENT == 0 ? 51'd0 :
                          {1'b0, ambient_i[47:32], 1'b0, ambient_i[31:16], 1'b0, ambient_i[15:0]};
    rt_light_add #(.TAG(SLOTW+NW)) u_add (
        .clk(clk), .rst(rst), .in_valid_i(e_valid_q), .in_ready_o(add_ready),
        .in_tag_i({e_slot_q, e_next}),
        .in_sum_i(e_start_q ? ambient : e_sum),
        .in_cosine_i(e_lit_q && !e_start_q ? e_cosine : 16'd0),
        .in_intensity_i(e_start_q ? 48'd0 : colour),
        .out_valid_o(a_valid), .out_tag_o({a_slot, a_next}), .out_sum_o(a_sum)
    );

    generate
        if (GLOSS != 0) begin : g_gloss               // in step with the other sum
            wire [50:0] e_gloss, a_gloss;
            wire        g_ready, g_valid, g_tag;
            reg  [15:0] e_highlight_q;
            reg  [50:0] gloss_q;
            rt_slot_ram #(.WIDTH(51), .SLOTS(SLOTS), .OLD(0)) u_gloss (
                .clk(clk), .wr_en_i(a_valid), .wr_addr_i(a_slot), .wr_data_i(a_gloss),
                .rd_en_i(read), .rd_addr_i(slot), .rd_data_o(e_gloss)
            );
            rt_light_add #(.TAG(1)) u_add_gloss (
                .clk(clk), .rst(rst), .in_valid_i(e_valid_q), .in_ready_o(g_ready),
                .in_tag_i(1'b0), .in_sum_i(e_start_q ? 51'd0 : e_gloss),
                .in_cosine_i(e_lit_q && !e_start_q ? e_highlight_q : 16'd0),
                .in_intensity_i(e_start_q ? 48'd0 : colour),
                .out_valid_o(g_valid), .out_tag_o(g_tag), .out_sum_o(a_gloss)
            );
            always @(posedge clk) begin
                if (e_load) e_highlight_q <= l_event[SLOTW+1 +: 16];
                if (a_valid) gloss_q <= a_gloss;
            end
            assign gloss_o = gloss_q;
            wire unused = &{1'b0, g_ready, g_valid, g_tag};
        end else begin : g_matt
            assign gloss_o = 51'd0;
        end
    endgenerate

    // ---- next light, or done ----
    wire [3*W-1:0]  v_point;
    rt_slot_ram #(.WIDTH(3*W), .SLOTS(SLOTS), .OLD(0), .LUTS(LUTS)) u_point (
        .clk(clk), .wr_en_i(point_valid_i), .wr_addr_i(point_slot_i), .wr_data_i(point_i),
        .rd_en_i(a_valid), .rd_addr_i(a_slot), .rd_data_o(v_point)
    );
    wire a_last = a_next == n_lights_i[NW-1:0];
    reg  [4:1] go_q;                                  // clocks since a vector was begun
    reg [SLOTW-1:0] vec_slot_q;
    always @(posedge clk) begin
        {vec_valid_o, go_q} <= {go_q, a_valid && !a_last};
        if (a_valid) vec_slot_q <= a_slot;
        if (go_q[3]) vec_slot_o <= vec_slot_q;
        if (turn != 2'd3) turn_q <= turn + 2'd1;  // stands still behind z
        sum_valid_o <= a_valid && a_last;
        if (a_valid) {sum_slot_o, sum_o} <= {a_slot, a_sum};
        if (rst) {vec_valid_o, go_q, sum_valid_o} <= 6'd0;
    end

    // ---- a component a clock: point / 2^shift with a bit behind it, and light minus that, half
    //      up: exact, WD > W ----
    reg  [WD-1:0]        pos_q, own_pos_q;
    reg  [EW-1:0]        shift_q, own_shift_q;
    reg  [3*WD-1:0]      vec_q;                       // {z, y, x}
    reg  signed [W-1:0]  own_q;                       // the point's component
    wire signed [W:0]    at    = $signed({own_q, 1'b0});
    wire signed [W:0]    part  = at >>> own_shift_q;
    wire [WD-1:0]        whole = {{(WD-W){part[W]}}, part[W:1]};
    wire [WD-1:0]        way   = own_pos_q + ~whole + {{(WD-1){1'b0}}, !part[0]};
    always @(posedge clk) begin
        if (a_valid || |go_q[2:1]) {pos_q, shift_q} <= {pos, shift};
        if (|go_q[3:1]) begin
            own_q       <= turn_q == 2'd1 ? v_point[0 +: W]
                           : turn_q == 2'd2 ? v_point[W +: W] : v_point[2*W +: W];
            own_pos_q   <= pos_q;
            own_shift_q <= shift_q;
        end
        if (|go_q[4:2]) vec_q <= {way, vec_q[3*WD-1:WD]};
    end
    assign vec_o = vec_q;
    wire unused = &{1'b0, s_in, l_in, t_in, a_part, k_part, light_data_i,
                    n_lights_i, l_new, ambient_i};
endmodule
`default_nettype wire
