// rt_specular_lights.v - gives lights that settle their highlight, between rt_cosine and rt_lights
// SPDX-License-Identifier: Apache-2.0
// The unit vectors of each slot's ray, surface and light are kept here. A light that shines on a
// material with a highlight waits for rt_specular; any other passes at once, even while one waits.
// Model: add() in cmodel/engine/render_light.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_bundles.vh"
module rt_specular_lights #(
    parameter W      = 16, // coordinate, bits
    parameter WD     = 17, // direction component, bits
    parameter SHADOW = 1,  // 0: no shadow rays
    parameter SLOTS  = 32  // power of two
) (
    input  wire                         clk,
    input  wire                         rst,
    input  wire                         on_i,          // run-time switch: effects SUM and SPECULAR
    // from rt_setup: unit vectors of primary, mirrored and refracted rays, of normals, to lights
    input  wire [`RT_RAY_BITS-1:0]      ray_i,
    //: {SLOT[SLOTW], H[6], Y[17], UNIT[54], INSIDE, SKIP[24], A[2*WD], DIR[3*WD], ORG[3*W], SHADOW,
    //: PRIMARY, LIGHT, NORMAL, VALID}
    input  wire [`RT_MATERIAL_BITS-1:0] material_i,    // from rt_surface
    //: {SLOT[SLOTW], SMOOTH[24], BEND[6], TEX[26], INDEX[12], POWER[12], KS[8], KD[9], KA[9], SUM,
    //: KT[9], KR[9], RGB[24], VALID}
    // tokens: a light is decided, a shadow ray is done
    input  wire                         unshadowed_valid_i,
    input  wire [$clog2(SLOTS)-1:0]     unshadowed_slot_i,
    input  wire                         unshadowed_lit_i,
    input  wire                         shadow_valid_i,
    input  wire [$clog2(SLOTS)-1:0]     shadow_slot_i,
    input  wire                         shadow_lit_i,
    // the same, to rt_lights
    output wire                         out_valid_o,
    output wire [$clog2(SLOTS)-1:0]     out_slot_o,
    output wire                         out_lit_o,
    output wire [15:0]                  out_highlight_o, // u1.15
    output wire                         power_o          // event: a highlight is begun
);
    localparam SLOTW = $clog2(SLOTS);
    // ---- queues of events, shadow rays first ----
    wire             l_valid, t_valid, l_in, t_in;
    wire [SLOTW:0]   l_event, t_event;
    reg              e_valid_q, e_lit_q;
    reg  [SLOTW-1:0] e_slot_q;
    wire             e_go;
    wire             e_load = !e_valid_q || e_go;
    wire [SLOTW:0]   event_d = t_valid ? t_event : l_event;
    wire             read   = e_load && (t_valid || l_valid);
    rt_fifo #(.WIDTH(SLOTW+1), .DEPTH(SLOTS)) u_unshadowed (
        .clk(clk), .rst(rst), .in_valid_i(unshadowed_valid_i), .in_ready_o(l_in),
        .in_data_i({unshadowed_slot_i, unshadowed_lit_i}),
        .out_valid_o(l_valid), .out_ready_i(e_load && !t_valid), .out_data_o(l_event)
    );
    generate
        if (SHADOW != 0) begin : g_shadow
            rt_fifo #(.WIDTH(SLOTW+1), .DEPTH(SLOTS)) u_shadows (
                .clk(clk), .rst(rst), .in_valid_i(shadow_valid_i), .in_ready_o(t_in),
                .in_data_i({shadow_slot_i, shadow_lit_i}),
                .out_valid_o(t_valid), .out_ready_i(e_load), .out_data_o(t_event)
            );
        end else begin : g_decided
            assign {t_valid, t_in, t_event} = {(SLOTW+3){1'b0}};
            wire unused = &{1'b0, shadow_valid_i, shadow_slot_i, shadow_lit_i};
        end
    endgenerate
    always @(posedge clk) begin
        if (e_load) begin
            e_valid_q <= t_valid || l_valid;
            {e_slot_q, e_lit_q} <= event_d;
        end
        if (rst) e_valid_q <= 1'b0;
    end

    // ---- what belongs to its slot ----
    wire [SLOTW-1:0] slot = event_d[SLOTW:1];
    wire [53:0]      dir, normal, light;
    wire             e_shines;               // the material has a highlight
    wire [11:0]      e_power;
    wire [SLOTW-1:0] unit_slot = ray_i[`RT_RAY_SLOT];
    wire [53:0]      unit      = ray_i[`RT_RAY_UNIT];
    wire             shines    = material_i[`RT_MATERIAL_SUM] &&
                                 material_i[`RT_MATERIAL_KS] != 8'd0;
    rt_slot_ram #(.WIDTH(54), .SLOTS(SLOTS), .OLD(0)) u_dir (
        .clk(clk), .wr_en_i(ray_i[`RT_RAY_VALID] && !ray_i[`RT_RAY_SHADOW]),
        .wr_addr_i(unit_slot), .wr_data_i(unit),
        .rd_en_i(read), .rd_addr_i(slot), .rd_data_o(dir)
    );
    rt_slot_ram #(.WIDTH(54), .SLOTS(SLOTS), .OLD(0)) u_normal (
        .clk(clk), .wr_en_i(ray_i[`RT_RAY_NORMAL]), .wr_addr_i(unit_slot), .wr_data_i(unit),
        .rd_en_i(read), .rd_addr_i(slot), .rd_data_o(normal)
    );
    rt_slot_ram #(.WIDTH(54), .SLOTS(SLOTS), .OLD(0)) u_light (
        .clk(clk), .wr_en_i(ray_i[`RT_RAY_LIGHT]), .wr_addr_i(unit_slot), .wr_data_i(unit),
        .rd_en_i(read), .rd_addr_i(slot), .rd_data_o(light)
    );
    rt_slot_ram #(.WIDTH(13), .SLOTS(SLOTS), .OLD(0)) u_material (
        .clk(clk), .wr_en_i(material_i[`RT_MATERIAL_VALID]),
        .wr_addr_i(material_i[`RT_MATERIAL_SLOT]),
        .wr_data_i({shines, material_i[`RT_MATERIAL_POWER]}),
        .rd_en_i(read), .rd_addr_i(slot), .rd_data_o({e_shines, e_power})
    );

    // ---- highlight, or none ----
    wire             need = on_i && e_lit_q && e_shines;
    wire             g_ready, g_valid;
    wire [SLOTW-1:0] g_slot;
    wire [15:0]      highlight;
    rt_specular #(.TAG(SLOTW)) u_gloss (
        .clk(clk), .rst(rst), .in_valid_i(e_valid_q && need), .in_ready_o(g_ready),
        .in_tag_i(e_slot_q), .in_normal_i(normal), .in_light_i(light), .in_dir_i(dir),
        .in_power_i(e_power),
        .out_valid_o(g_valid), .out_tag_o(g_slot), .out_highlight_o(highlight)
    );
    assign e_go            = need ? g_ready : !g_valid;
    assign power_o         = e_valid_q && need && g_ready;
    assign out_valid_o     = g_valid || (e_valid_q && !need);
    assign out_slot_o      = g_valid ? g_slot : e_slot_q;
    assign out_lit_o       = g_valid || e_lit_q;
    assign out_highlight_o = g_valid ? highlight : 16'd0;
    wire unused = &{1'b0, l_in, t_in, ray_i, material_i};
endmodule
`default_nettype wire
