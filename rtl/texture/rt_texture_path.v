// rt_texture_path.v - adds up the way of every surface's ray and sorts out what has a texture
// SPDX-License-Identifier: Apache-2.0
// Park et al. 2011, Figure 1: path length on the ray stack; here a word a slot, begun anew by each
// primary ray, with SPREAD beside how spheres spread it. Tokens leave in order.
// Model: cmodel/engine/render_pixel.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_texture_path #(
    parameter W     = 16,      // coordinate, bits
    parameter WD    = 17,      // direction component, bits
    parameter BACK  = 0,       // 1: rays that waited come back
    parameter SPREAD = 0,      // 1: spheres spread rays
    parameter SLOTS = 32  // power of two
) (
    input  wire              clk,
    input  wire              rst,
    // primary and reflected rays
    input  wire              ray_valid_i,
    input  wire [$clog2(SLOTS)-1:0] ray_slot_i,
    input  wire              ray_primary_i,
    input  wire [16:0]       ray_y_i,        // of the unit vector: 1 / |dir|
    input  wire [5:0]        ray_h_i,
    // what they hit
    input  wire              hit_valid_i,
    input  wire [$clog2(SLOTS)-1:0] hit_slot_i,
    input  wire [W+WD+1:0]   hit_key_i,
    // line of its mapping record, 0: none; how it bends rays
    input  wire              tex_valid_i,
    input  wire [$clog2(SLOTS)-1:0] tex_slot_i,
    input  wire [`RT_LINE_BITS-1:0] tex_i,
    input  wire [`RT_PRIM_BEND_BITS-1:0] bend_i,
    // the path of a ray that takes up where another has left; not with out_valid_o
    input  wire              back_valid_i,
    input  wire [$clog2(SLOTS)-1:0] back_slot_i,
    input  wire [W+17:0]     back_path_i,
    // token: a surface
    input  wire              in_valid_i,
    input  wire [$clog2(SLOTS)-1:0] in_slot_i,
    // the same, with
    output wire              out_valid_o,
    output wire [$clog2(SLOTS)-1:0] out_slot_o,
    output wire [`RT_LINE_BITS-1:0] out_tex_o,
    output wire              out_primary_o,
    output wire [W+17:0]     out_path_o      // {bend u6, log2 of the spread u4, u(W+4).4}
);
    localparam SLOTW = $clog2(SLOTS);
    localparam KW = W + WD + 2;
    localparam PW = W + 8;
    localparam EW = `RT_PRIM_BEND_BITS;
    localparam OW = SPREAD != 0 ? PW + 4 + EW : PW;   // word of the stack
    localparam OWN = SLOTW + `RT_LINE_BITS + 1;
    localparam TAG = SPREAD != 0 ? OWN + EW : OWN;    // {bend, slot, tex, primary}
    wire             back = BACK != 0 && back_valid_i;
    wire             n_valid, n_in, n_take, ready;
    wire [SLOTW-1:0] n_slot;
    wire [KW-1:0]    n_key;
    wire             n_primary;
    wire [5:0]       n_h;
    wire [16:0]      n_y;
    wire [`RT_LINE_BITS-1:0] n_tex;
    wire [OW-1:0]    n_word;
    wire [EW-1:0]    n_bend, out_bend;                // of the surface
    reg              n_read_q;               // what belongs to the head is read
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_in (
        .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .in_ready_o(n_in), .in_data_i(in_slot_i),
        .out_valid_o(n_valid), .out_ready_i(n_take), .out_data_o(n_slot)
    );
    rt_slot_ram #(.WIDTH(KW), .SLOTS(SLOTS), .OLD(0)) u_key (
        .clk(clk), .wr_en_i(hit_valid_i), .wr_addr_i(hit_slot_i), .wr_data_i(hit_key_i),
        .rd_en_i(n_valid), .rd_addr_i(n_slot), .rd_data_o(n_key)
    );
    rt_slot_ram #(.WIDTH(1 + 6 + 17), .SLOTS(SLOTS), .OLD(0)) u_ray (
        .clk(clk), .wr_en_i(ray_valid_i), .wr_addr_i(ray_slot_i),
        .wr_data_i({ray_primary_i, ray_h_i, ray_y_i}),
        .rd_en_i(n_valid), .rd_addr_i(n_slot), .rd_data_o({n_primary, n_h, n_y})
    );
    rt_slot_ram #(.WIDTH(`RT_LINE_BITS), .SLOTS(SLOTS), .OLD(0)) u_tex (
        .clk(clk), .wr_en_i(tex_valid_i), .wr_addr_i(tex_slot_i), .wr_data_i(tex_i),
        .rd_en_i(n_valid), .rd_addr_i(n_slot), .rd_data_o(n_tex)
    );
    rt_slot_ram #(.WIDTH(OW), .SLOTS(SLOTS), .OLD(0)) u_stack (
        .clk(clk), .wr_en_i(out_valid_o || back), .wr_addr_i(back ? back_slot_i : out_slot_o),
        .wr_data_i(back ? back_path_i[OW-1:0] : out_path_o[OW-1:0]),
        .rd_en_i(n_valid), .rd_addr_i(n_slot), .rd_data_o(n_word)
    );
    wire [OWN+EW-1:0] n_tag = {n_bend, n_slot, n_tex, n_primary};
    wire [TAG-1:0]   out_tag;
    // where the ray of this surface started
    wire [W+17:0]    n_start = n_primary ? {(W+18){1'b0}} : {{(W+18-OW){1'b0}}, n_word};
    generate
        if (SPREAD != 0) begin : g_bend
            rt_slot_ram #(.WIDTH(EW), .SLOTS(SLOTS), .OLD(0)) u_bend (
                .clk(clk), .wr_en_i(tex_valid_i), .wr_addr_i(tex_slot_i), .wr_data_i(bend_i),
                .rd_en_i(n_valid), .rd_addr_i(n_slot), .rd_data_o(n_bend)
            );
            assign out_bend = out_tag[OWN +: EW];
        end else begin : g_even
            assign n_bend   = {EW{1'b0}};
            assign out_bend = {EW{1'b0}};
            wire unused = &{1'b0, bend_i, back_path_i};
        end
    endgenerate
    assign n_take = n_read_q && ready;
    always @(posedge clk) begin
        n_read_q <= n_valid && !n_take;
        if (rst) n_read_q <= 1'b0;
    end
    rt_path #(.W(W), .WD(WD), .SPREAD(SPREAD), .TAG(TAG)) u_path (
        .clk(clk), .rst(rst), .in_valid_i(n_read_q), .in_ready_o(ready),
        .in_tag_i(n_tag[TAG-1:0]), .in_key_i(n_key), .in_y_i(n_y),
        .in_h_i(n_h), .in_path_i(n_start[PW-1:0]), .in_spread_i(n_start[PW +: 4]),
        .in_bend_i(n_start[PW+4 +: EW]),
        .out_valid_o(out_valid_o), .out_tag_o(out_tag),
        .out_path_o(out_path_o[PW-1:0]), .out_spread_o(out_path_o[PW +: 4])
    );
    assign out_path_o[PW+4 +: EW] = out_bend;
    assign {out_slot_o, out_tex_o, out_primary_o} = out_tag[OWN-1:0];
    wire unused = &{1'b0, n_in, back_valid_i, n_tag};
endmodule
`default_nettype wire
