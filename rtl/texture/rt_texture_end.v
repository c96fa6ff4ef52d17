// rt_texture_end.v - surfaces leave the texture unit, with the colour that a texture gave them
// SPDX-License-Identifier: Apache-2.0
// One surface a clock: those whose texels are mixed, which cannot wait, go first, then those
// without a texture, then those whose texture has nothing to show and is white. Latency 1 to
// albedo_o, 2 to out_valid_o, and the wait.
// Model: sph_texture_albedo() in cmodel/texture/texel.c, called where the albedo is mixed
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_texture_end #(
    parameter SLOTS = 32       // power of two
) (
    input  wire                clk,
    input  wire                rst,
    input  wire [`RT_MATERIAL_BITS-1:0] material_i, // from rt_surface, before any of the below
    //: {SLOT[SLOTW], SMOOTH[24], BEND[6], TEX[26], INDEX[12], POWER[12], KS[8], KD[9], KA[9], SUM,
    //: KT[9], KR[9], RGB[24], VALID}
    // from rt_texture_path: a surface without a texture
    input  wire                plain_valid_i,
    input  wire [$clog2(SLOTS)-1:0] plain_slot_i,
    // a record or a header was void
    input  wire                white_valid_i,
    input  wire [$clog2(SLOTS)-1:0] white_slot_i,
    // from rt_texture_mix
    input  wire                mixed_valid_i,
    input  wire [$clog2(SLOTS)-1:0] mixed_slot_i,
    input  wire [`RT_RGB_BITS-1:0] mixed_i,        // 0xBBGGRR
    // to rt_compose: the albedo as textured; to rt_lighting, a clock later: the surface
    output wire [`RT_ALBEDO_BITS-1:0] albedo_o,
    //: {SLOT[SLOTW], KR[9], RGB[24], VALID}
    output reg                 out_valid_o,
    output reg  [$clog2(SLOTS)-1:0] out_slot_o
);
    localparam SLOTW = $clog2(SLOTS);
    localparam CB = `RT_RGB_BITS;
    wire             q_plain, q_white, plain_in, white_in;
    wire [SLOTW-1:0] q_plain_slot, q_white_slot;
    wire             white_take = !mixed_valid_i && !q_plain;
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_plain (
        .clk(clk), .rst(rst), .in_valid_i(plain_valid_i), .in_ready_o(plain_in),
        .in_data_i(plain_slot_i),
        .out_valid_o(q_plain), .out_ready_i(!mixed_valid_i), .out_data_o(q_plain_slot)
    );
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_white (
        .clk(clk), .rst(rst), .in_valid_i(white_valid_i), .in_ready_o(white_in),
        .in_data_i(white_slot_i),
        .out_valid_o(q_white), .out_ready_i(white_take), .out_data_o(q_white_slot)
    );

    // ---- its record; a clock later its colour ----
    wire             e_valid = mixed_valid_i || q_plain || q_white;
    wire [SLOTW-1:0] e_slot  = mixed_valid_i ? mixed_slot_i
                               : q_plain ? q_plain_slot : q_white_slot;
    reg              m_valid_q, m_mixed_q;
    reg [SLOTW-1:0]  m_slot_q;
    reg [CB-1:0]     m_colour_q;
    wire [8:0]       m_kr;
    wire [CB-1:0]    m_rgb;
    rt_slot_ram #(.WIDTH(CB+9), .SLOTS(SLOTS), .OLD(0)) u_record (
        .clk(clk), .wr_en_i(material_i[`RT_MATERIAL_VALID]),
        .wr_addr_i(material_i[`RT_MATERIAL_SLOT]),
        .wr_data_i({material_i[`RT_MATERIAL_KR], material_i[`RT_MATERIAL_RGB]}),
        .rd_en_i(e_valid), .rd_addr_i(e_slot), .rd_data_o({m_kr, m_rgb})
    );
    always @(posedge clk) begin
        m_valid_q   <= e_valid;
        m_mixed_q   <= mixed_valid_i;
        m_slot_q    <= e_slot;
        m_colour_q  <= mixed_i;
        out_valid_o <= m_valid_q;
        out_slot_o  <= m_slot_q;
        if (rst) begin m_valid_q <= 1'b0; out_valid_o <= 1'b0; end
    end
    assign albedo_o[`RT_ALBEDO_VALID] = m_valid_q;
    assign albedo_o[`RT_ALBEDO_SLOT]  = m_slot_q;
    assign albedo_o[`RT_ALBEDO_RGB]   = m_mixed_q ? m_colour_q : m_rgb;
    assign albedo_o[`RT_ALBEDO_KR]    = m_kr;
    wire unused = &{1'b0, material_i, plain_in, white_in};
endmodule
`default_nettype wire
