// rt_mirrors.v - mirrored directions of the surfaces that show what lies behind them
// SPDX-License-Identifier: Apache-2.0
// The direction of each slot's ray and the normal of its surface are kept here; the mirrored
// direction goes to rt_setup when the surface is blended.
// Model: sph_bounce() in cmodel/shade/surface.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_bundles.vh"
`include "rt_check.vh"
module rt_mirrors #(
    parameter W     = 16,  // coordinate, bits
    parameter WD    = 17,  // direction component, bits
    parameter INTERVAL = 10, // clocks a direction, 10 or 12; below 18 bits of WD 10 in any case
    parameter SLOTS = 32  // power of two
) (
    input  wire              clk,
    input  wire              rst,
    input  wire [`RT_RAY_BITS-1:0] ray_i,     // from rt_setup
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
    wire             m_load = !n_valid_q || ready;
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
    generate
        if (INTERVAL == 12 && WD >= 18) begin : g_twelve
            rt_bounce_twelve #(.WD(WD), .TAG(SLOTW)) u_bounce (
                .clk(clk), .rst(rst), .in_valid_i(n_valid_q), .in_ready_o(ready),
                .in_tag_i(n_slot_q),
                .in_dir_x_i($signed(n_dir[`RT_VEC_X])), .in_dir_y_i($signed(n_dir[`RT_VEC_Y])),
                .in_dir_z_i($signed(n_dir[`RT_VEC_Z])),
                .in_normal_x_i($signed(n_normal[`RT_VEC_X])),
                .in_normal_y_i($signed(n_normal[`RT_VEC_Y])),
                .in_normal_z_i($signed(n_normal[`RT_VEC_Z])), .in_nn_i(n_nn),
                .out_valid_o(out_valid_o), .out_tag_o(out_slot_o),
                .out_dir_x_o(out_vec_o[`RT_VEC_X]), .out_dir_y_o(out_vec_o[`RT_VEC_Y]),
                .out_dir_z_o(out_vec_o[`RT_VEC_Z])
            );
        end else begin : g_ten
            rt_bounce #(.WD(WD), .TAG(SLOTW)) u_bounce (
                .clk(clk), .rst(rst), .in_valid_i(n_valid_q), .in_ready_o(ready),
                .in_tag_i(n_slot_q),
                .in_dir_x_i($signed(n_dir[`RT_VEC_X])), .in_dir_y_i($signed(n_dir[`RT_VEC_Y])),
                .in_dir_z_i($signed(n_dir[`RT_VEC_Z])),
                .in_normal_x_i($signed(n_normal[`RT_VEC_X])),
                .in_normal_y_i($signed(n_normal[`RT_VEC_Y])),
                .in_normal_z_i($signed(n_normal[`RT_VEC_Z])), .in_nn_i(n_nn),
                .out_valid_o(out_valid_o), .out_tag_o(out_slot_o),
                .out_dir_x_o(out_vec_o[`RT_VEC_X]), .out_dir_y_o(out_vec_o[`RT_VEC_Y]),
                .out_dir_z_o(out_vec_o[`RT_VEC_Z])
            );
        end
    endgenerate
    wire unused = &{1'b0, ray_i, m_in};
endmodule
`default_nettype wire
