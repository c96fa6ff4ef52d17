// rt_mirrors.v - mirrored directions of the surfaces that show what lies behind them
// SPDX-License-Identifier: Apache-2.0
// The direction of each slot's ray and the normal of its surface are kept here; the mirrored
// direction goes to rt_setup when the surface is blended. Of an interpolated normal it goes through
// rt_bounce once more, with the facet's own: mirrored again if it goes behind the facet. Such a
// surface has rt_bounce for itself.
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
    input  wire [`RT_SIDE_BITS-1:0] side_i,   // from rt_smooth
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
    wire             m_valid, m_in, ready;
    wire [SLOTW-1:0] m_slot;
    reg              n_valid_q;
    reg [SLOTW-1:0]  n_slot_q;
    wire             n_ready, n_bent;
    wire             m_load = !n_valid_q || n_ready;
    wire [3*WD-1:0]  n_dir, n_normal;
    wire [2*WD-1:0]  n_nn;
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_queue (
        .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .in_ready_o(m_in), .in_data_i(in_slot_i),
        .out_valid_o(m_valid), .out_ready_i(m_load), .out_data_o(m_slot)
    );
    rt_slot_ram #(.WIDTH(3*WD), .SLOTS(SLOTS), .OLD(0)) u_dir (
        .clk(clk), .wr_en_i(ray_i[`RT_RAY_VALID] && !ray_i[`RT_RAY_SHADOW]),
        .wr_addr_i(ray_i[`RT_RAY_SLOT]), .wr_data_i(ray_i[`RT_RAY_DIR]),
        .rd_en_i(m_load && m_valid), .rd_addr_i(m_slot), .rd_data_o(n_dir)
    );
    rt_slot_ram #(.WIDTH(5*WD), .SLOTS(SLOTS), .OLD(0)) u_normal (
        .clk(clk), .wr_en_i(ray_i[`RT_RAY_NORMAL]), .wr_addr_i(ray_i[`RT_RAY_SLOT]),
        .wr_data_i({ray_i[`RT_RAY_A], ray_i[`RT_RAY_DIR]}),
        .rd_en_i(m_load && m_valid), .rd_addr_i(m_slot), .rd_data_o({n_nn, n_normal})
    );
    always @(posedge clk) begin
        if (m_load) begin
            n_valid_q <= m_valid;
            n_slot_q  <= m_slot;
        end
        if (rst) n_valid_q <= 1'b0;
    end

    // ---- what enters: a surface, or the direction of one with an interpolated normal again ----
    wire             in_valid;
    wire [3*WD-1:0]  dir, normal;
    wire [2*WD-1:0]  nn;
    wire [SLOTW+1:0] in_tag, tag;             // {again, bent, slot}
    wire             valid, behind;
    wire [3*WD-1:0]  vec;
    generate
        if (SMOOTH != 0) begin : g_smooth
            wire [3*WD-1:0]  n_side;
            wire [2*WD-1:0]  n_side_nn;
            reg              alone_q, again_q;  // one has the unit; its direction waits to enter
            reg  [3*WD-1:0]  again_dir_q, side_q;
            reg  [2*WD-1:0]  side_nn_q;
            rt_slot_ram #(.WIDTH(5*WD+1), .SLOTS(SLOTS), .OLD(0)) u_side (
                .clk(clk), .wr_en_i(side_i[`RT_SIDE_VALID]), .wr_addr_i(side_i[`RT_SIDE_SLOT]),
                .wr_data_i({side_i[`RT_SIDE_BENT], side_i[`RT_SIDE_NN], side_i[`RT_SIDE_VEC]}),
                .rd_en_i(m_load && m_valid), .rd_addr_i(m_slot),
                .rd_data_o({n_bent, n_side_nn, n_side})
            );
            assign n_ready  = ready && !alone_q;
            assign in_valid = alone_q ? again_q : n_valid_q;
            assign dir      = again_q ? again_dir_q : n_dir;
            assign normal   = again_q ? side_q : n_normal;
            assign nn       = again_q ? side_nn_q : n_nn;
            assign in_tag   = {again_q, n_bent, n_slot_q};
            reg [SLOTW-1:0]  slot_q;
            always @(posedge clk) begin
                if (n_valid_q && n_ready && n_bent) begin
                    alone_q   <= 1'b1;
                    slot_q    <= n_slot_q;
                    side_q    <= n_side;
                    side_nn_q <= n_side_nn;
                end else if (valid && tag[SLOTW+1]) begin
                    alone_q   <= 1'b0;
                end
                if (valid && tag[SLOTW+1:SLOTW] == 2'b01) begin
                    again_q     <= 1'b1;
                    again_dir_q <= vec;
                end else if (ready) begin
                    again_q     <= 1'b0;
                end
                if (rst) {alone_q, again_q} <= 2'd0;
            end
            assign out_valid_o = valid && tag[SLOTW+1:SLOTW] != 2'b01;
            assign out_vec_o   = tag[SLOTW+1] && !behind ? again_dir_q : vec;
            assign out_slot_o  = tag[SLOTW+1] ? slot_q : tag[SLOTW-1:0];
        end else begin : g_own
            assign {n_ready, in_valid, dir, normal, nn} = {ready, n_valid_q, n_dir, n_normal, n_nn};
            assign n_bent = 1'b0;
            assign in_tag      = {2'd0, n_slot_q};
            assign out_valid_o = valid;
            assign out_vec_o   = vec;
            assign out_slot_o  = tag[SLOTW-1:0];
            wire unused = &{1'b0, side_i, tag, behind, n_bent};
        end
        if (INTERVAL == 12 && WD >= 18) begin : g_twelve
            rt_bounce_twelve #(.WD(WD), .TAG(SLOTW+2)) u_bounce (
                .clk(clk), .rst(rst), .in_valid_i(in_valid), .in_ready_o(ready),
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
            rt_bounce #(.WD(WD), .TAG(SLOTW+2)) u_bounce (
                .clk(clk), .rst(rst), .in_valid_i(in_valid), .in_ready_o(ready),
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
    wire unused = &{1'b0, ray_i, m_in};
endmodule
`default_nettype wire
