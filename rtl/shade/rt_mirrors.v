// rt_mirrors.v - mirrored directions of the surfaces that show what lies behind them
// SPDX-License-Identifier: Apache-2.0
// The direction of each slot's ray and the normal of its surface are kept here; the mirrored
// direction goes to rt_setup when the surface is blended. Of an interpolated normal it goes through
// rt_reflect once more, with the facet's own: mirrored again if it goes behind the facet. Those go
// before new surfaces, so that few wait.
// Model: sph_mirror() in cmodel/shade/surface.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_bundles.vh"
`include "rt_check.vh"
module rt_mirrors #(
    parameter W     = 16,  // coordinate, bits
    parameter WD    = 17,  // direction component, bits
    parameter INTERVAL = 10, // clocks a direction, 10 or 12; below 18 bits of WD 10 in any case
    parameter SMOOTH = 0, // 1: interpolated normals
    parameter SLOTS = 32  // power of two
) (
    input  wire              clk,
    input  wire              rst,
    input  wire [`RT_RAY_BITS-1:0] ray_i,     // from rt_setup
    //: {SLOT[SLOTW], H[6], Y[17], UNIT[54], INSIDE, SKIP[24], A[2*WD], DIR[3*WD], ORG[3*W], SHADOW,
    //: PRIMARY, LIGHT, NORMAL, VALID}
    input  wire [`RT_SIDE_BITS-1:0] side_i,   // from rt_smooth
    //: {SLOT[SLOTW], NN[2*WD], VEC[3*WD], BENT, VALID}
    // a surface
    input  wire              in_valid_i,
    input  wire [$clog2(SLOTS)-1:0] in_slot_i,
    // to rt_setup
    output wire              out_valid_o,     // one cycle
    output wire [$clog2(SLOTS)-1:0] out_slot_o,
    output wire [3*WD-1:0]   out_vec_o
);
    localparam SLOTW = $clog2(SLOTS);
    `RT_CHECK(INTERVAL == 10 || INTERVAL == 12, rt_mirrors_INTERVAL_must_be_10_or_12)
    wire             m_valid, m_in;
    wire [SLOTW-1:0] m_slot;
    reg              n_valid_q;
    reg [SLOTW-1:0]  n_slot_q;
    wire             n_ready;
    wire             m_load = !n_valid_q || n_ready;
    wire             a_valid;                 // a direction waits to enter again, of this slot
    wire [SLOTW-1:0] a_slot;
    wire [SLOTW-1:0] slot = a_valid ? a_slot : m_slot;
    wire [3*WD-1:0]  n_dir, n_normal;
    wire [2*WD-1:0]  n_nn;
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_queue (
        .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .in_ready_o(m_in), .in_data_i(in_slot_i),
        .out_valid_o(m_valid), .out_ready_i(m_load && !a_valid), .out_data_o(m_slot)
    );
    rt_slot_ram #(.WIDTH(3*WD), .SLOTS(SLOTS), .OLD(0)) u_dir (
        .clk(clk), .wr_en_i(ray_i[`RT_RAY_VALID] && !ray_i[`RT_RAY_SHADOW]),
        .wr_addr_i(ray_i[`RT_RAY_SLOT]), .wr_data_i(ray_i[`RT_RAY_DIR]),
        .rd_en_i(m_load && m_valid), .rd_addr_i(slot), .rd_data_o(n_dir)
    );
    rt_slot_ram #(.WIDTH(5*WD), .SLOTS(SLOTS), .OLD(0)) u_normal (
        .clk(clk), .wr_en_i(ray_i[`RT_RAY_NORMAL]), .wr_addr_i(ray_i[`RT_RAY_SLOT]),
        .wr_data_i({ray_i[`RT_RAY_A], ray_i[`RT_RAY_DIR]}),
        .rd_en_i(m_load && m_valid), .rd_addr_i(slot), .rd_data_o({n_nn, n_normal})
    );
    always @(posedge clk) begin
        if (m_load) begin
            n_valid_q <= m_valid || a_valid;
            n_slot_q  <= slot;
        end
        if (rst) n_valid_q <= 1'b0;
    end

    // ---- what enters: a surface, or the direction of one with an interpolated normal again ----
    localparam AGAIN = SMOOTH != 0 ? 3*WD : 0;  // bits of that direction, which goes along
    localparam TAG = SLOTW + 2 + AGAIN;
    wire [3*WD-1:0]  dir, normal;
    wire [2*WD-1:0]  nn;
    wire [TAG-1:0]   in_tag, tag;             // {direction, again, bent, slot}
    wire             valid, behind;
    wire [3*WD-1:0]  vec;
    generate
        if (SMOOTH != 0) begin : g_smooth
            // While one waits no new surface goes in: those behind it, at most four, were on their
            // way through rt_reflect or before it.
            wire             a_in, n_bent;
            wire [3*WD-1:0]  a_dir, n_side;
            wire [2*WD-1:0]  n_side_nn;
            wire             first = tag[SLOTW +: 2] == 2'b01;  // it goes in once more
            reg              again_q;
            reg  [3*WD-1:0]  again_dir_q;
            rt_slot_ram #(.WIDTH(5*WD+1), .SLOTS(SLOTS), .OLD(0)) u_side (
                .clk(clk), .wr_en_i(side_i[`RT_SIDE_VALID]), .wr_addr_i(side_i[`RT_SIDE_SLOT]),
                .wr_data_i({side_i[`RT_SIDE_BENT], side_i[`RT_SIDE_NN], side_i[`RT_SIDE_VEC]}),
                .rd_en_i(m_load && (m_valid || a_valid)), .rd_addr_i(slot),
                .rd_data_o({n_bent, n_side_nn, n_side})
            );
            rt_fifo #(.WIDTH(SLOTW+3*WD), .DEPTH(4)) u_again (
                .clk(clk), .rst(rst), .in_valid_i(valid && first), .in_ready_o(a_in),
                .in_data_i({tag[SLOTW-1:0], vec}),
                .out_valid_o(a_valid), .out_ready_i(m_load), .out_data_o({a_slot, a_dir})
            );
            always @(posedge clk) if (m_load) begin
                again_q     <= a_valid;
                again_dir_q <= a_dir;
            end
            assign dir         = again_q ? again_dir_q : n_dir;
            assign normal      = again_q ? n_side : n_normal;
            assign nn          = again_q ? n_side_nn : n_nn;
            assign in_tag      = {again_dir_q, again_q, n_bent, n_slot_q};
            assign out_valid_o = valid && !first;
            assign out_vec_o   = tag[SLOTW+1] && !behind ? tag[SLOTW+2 +: 3*WD] : vec;
            wire unused = a_in;
        end else begin : g_own
            assign {a_valid, a_slot} = {(SLOTW+1){1'b0}};
            assign {dir, normal, nn} = {n_dir, n_normal, n_nn};
            assign in_tag      = {2'd0, n_slot_q};
            assign out_valid_o = valid;
            assign out_vec_o   = vec;
            wire unused = &{1'b0, side_i, tag, behind};
        end
        if (INTERVAL == 12 && WD >= 18) begin : g_twelve
            rt_reflect_twelve #(.WD(WD), .TAG(TAG)) u_bounce (
                .clk(clk), .rst(rst), .in_valid_i(n_valid_q), .in_ready_o(n_ready),
                .in_tag_i(in_tag),
                .in_dir_x_i($signed(dir[`RT_VEC_X])), .in_dir_y_i($signed(dir[`RT_VEC_Y])),
                .in_dir_z_i($signed(dir[`RT_VEC_Z])),
                .in_normal_x_i($signed(normal[`RT_VEC_X])),
                .in_normal_y_i($signed(normal[`RT_VEC_Y])),
                .in_normal_z_i($signed(normal[`RT_VEC_Z])), .in_nn_i(nn),
                .out_valid_o(valid), .out_tag_o(tag), .out_behind_o(behind),
                .out_dir_x_o(vec[`RT_VEC_X]), .out_dir_y_o(vec[`RT_VEC_Y]),
                .out_dir_z_o(vec[`RT_VEC_Z])
            );
        end else begin : g_ten
            rt_reflect #(.WD(WD), .TAG(TAG)) u_bounce (
                .clk(clk), .rst(rst), .in_valid_i(n_valid_q), .in_ready_o(n_ready),
                .in_tag_i(in_tag),
                .in_dir_x_i($signed(dir[`RT_VEC_X])), .in_dir_y_i($signed(dir[`RT_VEC_Y])),
                .in_dir_z_i($signed(dir[`RT_VEC_Z])),
                .in_normal_x_i($signed(normal[`RT_VEC_X])),
                .in_normal_y_i($signed(normal[`RT_VEC_Y])),
                .in_normal_z_i($signed(normal[`RT_VEC_Z])), .in_nn_i(nn),
                .out_valid_o(valid), .out_tag_o(tag), .out_behind_o(behind),
                .out_dir_x_o(vec[`RT_VEC_X]), .out_dir_y_o(vec[`RT_VEC_Y]),
                .out_dir_z_o(vec[`RT_VEC_Z])
            );
        end
    endgenerate
    assign out_slot_o = tag[SLOTW-1:0];
    wire unused = &{1'b0, ray_i, m_in};
endmodule
`default_nettype wire
