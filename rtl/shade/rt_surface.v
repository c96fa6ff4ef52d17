// rt_surface.v - from a ray's first hit to the point and normal of its surface
// SPDX-License-Identifier: Apache-2.0
// t = key / a in one of QUOTIENTS iterative dividers, then the primitive record through the leaf
// cache, then org + t*dir and the normal. Tokens wait in queues between the three.
// Model: sph_quotient() in cmodel/math/quotient.c, sph_surface_at() in cmodel/shade/surface.c
`default_nettype none
`include "rt_layout.vh"
module rt_surface #(
    parameter W     = 16,      // coordinate, bits
    parameter WD    = 17,      // direction component, bits
    parameter PQ    = 17,      // significant bits of the quotient
    parameter NG    = 2,       // guard bits of the normal
    parameter SLOTS = 32,      // power of two
    parameter SLOTW = 5,       // log2 of SLOTS
    parameter QUOTIENTS = 3    // dividers
) (
    input  wire              clk,
    input  wire              rst,
    input  wire [25:0]       prim_base_i,    // register
    // from rt_setup: primary and reflected rays
    input  wire              ray_valid_i,
    input  wire [SLOTW-1:0]  ray_slot_i,
    input  wire [3*W-1:0]    ray_org_i,
    input  wire [3*WD-1:0]   ray_dir_i,
    input  wire [2*WD-1:0]   ray_a_i,
    // a token and its ray's first hit
    input  wire              in_valid_i,
    input  wire [SLOTW-1:0]  in_slot_i,
    input  wire              in_far_i,
    input  wire [23:0]       in_id_i,
    input  wire [W+WD+1:0]   in_key_i,
    // to and from rt_leaf_unit: primitive records
    output wire              prim_valid_o,
    input  wire              prim_ready_i,
    output wire [SLOTW-1:0]  prim_slot_o,
    output wire [25:0]       prim_line_o,
    input  wire              prim_valid_i,
    output wire              prim_ready_o,
    input  wire [SLOTW-1:0]  prim_slot_i,
    input  wire [255:0]      prim_data_i,
    // the material, as the record arrives
    output wire              material_valid_o,
    output wire [SLOTW-1:0]  material_slot_o,
    output wire [32:0]       material_o,     // {kr u1.8, 0xBBGGRR}
    // the surface
    output wire              out_valid_o,
    output wire [SLOTW-1:0]  out_slot_o,
    output wire [3*W-1:0]    out_point_o,
    output wire [3*WD-1:0]   out_normal_o,
    // counters
    output wire              quotient_o,
    output wire              saturated_o
);
    localparam KW = W + WD + 2;

    // ---- queue of hits; what is read at the head ----
    wire             h_valid, h_in, h_taken, divider;
    wire [SLOTW-1:0] h_slot;
    rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_hits (
        .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .in_ready_o(h_in),
        .in_data_i(in_slot_i),
        .out_valid_o(h_valid), .out_ready_i(h_taken), .out_data_o(h_slot)
    );
    wire [KW+23:0]   h;                       // {id, key}
    wire [2*WD-1:0]  h_a;
    reg              h_read_q;                // h and h_a belong to the head
    rt_slot_ram #(.WIDTH(KW+24), .SLOTS(SLOTS), .OLD(0)) u_hit_data (
        .clk(clk), .wr_en_i(in_valid_i), .wr_addr_i(in_slot_i), .wr_data_i({in_id_i, in_key_i}),
        .rd_en_i(h_valid), .rd_addr_i(h_slot), .rd_data_o(h)
    );
    rt_slot_ram #(.WIDTH(2*WD), .SLOTS(SLOTS), .OLD(0)) u_a (
        .clk(clk), .wr_en_i(ray_valid_i), .wr_addr_i(ray_slot_i), .wr_data_i(ray_a_i),
        .rd_en_i(h_valid), .rd_addr_i(h_slot), .rd_data_o(h_a)
    );
    always @(posedge clk) begin
        h_read_q <= h_valid && !h_taken;
        if (rst) h_read_q <= 1'b0;
    end
    assign h_taken    = h_read_q && divider;
    assign quotient_o = h_taken;

    // ---- dividers: the lowest idle one takes, the lowest that is done gives ----
    localparam DW = PQ + 8 + SLOTW + 26;
    wire [QUOTIENTS-1:0] ready, done;
    wire [QUOTIENTS-1:0] take = ready & (~ready + 1'b1) & {QUOTIENTS{h_read_q}};
    wire [QUOTIENTS-1:0] give = done & (~done + 1'b1);
    wire [QUOTIENTS*DW-1:0] results;
    assign divider = |ready;
    genvar u;
    generate
        for (u = 0; u < QUOTIENTS; u = u + 1) begin : g_divider
            wire [PQ-1:0]      mant;
            wire signed [7:0]  exp;
            reg [SLOTW+25:0]   side_q;        // {slot, line of the record}
            rt_quotient #(.KW(KW), .AW(2*WD), .PQ(PQ)) u_quotient (
                .clk(clk), .rst(rst),
                .in_valid_i(take[u]), .in_ready_o(ready[u]),
                .in_key_i(h[KW-1:0]), .in_a_i(h_a),
                .out_valid_o(done[u]), .out_ready_i(give[u]),
                .out_mant_o(mant), .out_exp_o(exp)
            );
            always @(posedge clk)
                if (take[u]) side_q <= {h_slot, prim_base_i + {2'b0, h[KW +: 24]}};
            assign results[DW*u +: DW] = give[u] ? {mant, exp, side_q} : {DW{1'b0}};
        end
    endgenerate
    reg [DW-1:0] t;
    integer i;
    always @* begin
        t = {DW{1'b0}};
        for (i = 0; i < QUOTIENTS; i = i + 1) t = t | results[DW*i +: DW];
    end

    // ---- fetch the primitive record ----
    wire p_in;
    rt_fifo #(.WIDTH(SLOTW+26), .DEPTH(SLOTS)) u_fetches (
        .clk(clk), .rst(rst), .in_valid_i(|done), .in_ready_o(p_in),
        .in_data_i(t[SLOTW+25:0]),
        .out_valid_o(prim_valid_o), .out_ready_i(prim_ready_i),
        .out_data_o({prim_slot_o, prim_line_o})
    );
    wire [PQ+7:0]    r_t;
    wire [3*W-1:0]   r_org;
    wire [3*WD-1:0]  r_dir;
    wire             r_far;
    wire             r_load;
    rt_slot_ram #(.WIDTH(PQ+8), .SLOTS(SLOTS), .OLD(0)) u_t (
        .clk(clk), .wr_en_i(|done), .wr_addr_i(t[26 +: SLOTW]), .wr_data_i(t[DW-1 -: PQ+8]),
        .rd_en_i(r_load), .rd_addr_i(prim_slot_i), .rd_data_o(r_t)
    );
    rt_slot_ram #(.WIDTH(3*W+3*WD), .SLOTS(SLOTS), .OLD(0)) u_ray (
        .clk(clk), .wr_en_i(ray_valid_i), .wr_addr_i(ray_slot_i),
        .wr_data_i({ray_dir_i, ray_org_i}),
        .rd_en_i(r_load), .rd_addr_i(prim_slot_i), .rd_data_o({r_dir, r_org})
    );
    rt_slot_ram #(.WIDTH(1), .SLOTS(SLOTS), .OLD(0)) u_far (
        .clk(clk), .wr_en_i(in_valid_i), .wr_addr_i(in_slot_i), .wr_data_i(in_far_i),
        .rd_en_i(r_load), .rd_addr_i(prim_slot_i), .rd_data_o(r_far)
    );

    // ---- record, ray and t side by side ----
    reg              r_valid_q;
    reg [SLOTW-1:0]  r_slot_q;
    reg [71:0]       r_ctr_q;                 // {z, y, x} s24
    wire             hit_ready, saturated;
    assign prim_ready_o = !r_valid_q || hit_ready;
    assign r_load = prim_valid_i && prim_ready_o;
    always @(posedge clk) begin
        if (r_load) begin
            r_slot_q <= prim_slot_i;
            r_ctr_q  <= prim_data_i[71:0];
        end
        if (prim_ready_o) r_valid_q <= prim_valid_i;
        if (rst) r_valid_q <= 1'b0;
    end
    assign material_valid_o = r_load;
    assign material_slot_o  = prim_slot_i;
    assign material_o = {prim_data_i[`RT_PRIM_KR_LSB +: 9], prim_data_i[`RT_PRIM_RED_LSB +: 24]};

    rt_hit #(.W(W), .WD(WD), .PQ(PQ), .NG(NG), .TAG(SLOTW)) u_hit (
        .clk(clk), .rst(rst), .in_valid_i(r_valid_q), .in_ready_o(hit_ready),
        .in_tag_i(r_slot_q), .in_mant_i(r_t[PQ+7:8]), .in_exp_i($signed(r_t[7:0])),
        .in_org_x_i($signed(r_org[0 +: W])), .in_org_y_i($signed(r_org[W +: W])),
        .in_org_z_i($signed(r_org[2*W +: W])),
        .in_dir_x_i($signed(r_dir[0 +: WD])), .in_dir_y_i($signed(r_dir[WD +: WD])),
        .in_dir_z_i($signed(r_dir[2*WD +: WD])),
        .in_ctr_x_i($signed(r_ctr_q[0 +: W])), .in_ctr_y_i($signed(r_ctr_q[24 +: W])),
        .in_ctr_z_i($signed(r_ctr_q[48 +: W])), .in_far_i(r_far),
        .out_valid_o(out_valid_o), .out_tag_o(out_slot_o),
        .out_point_x_o(out_point_o[0 +: W]), .out_point_y_o(out_point_o[W +: W]),
        .out_point_z_o(out_point_o[2*W +: W]),
        .out_normal_x_o(out_normal_o[0 +: WD]), .out_normal_y_o(out_normal_o[WD +: WD]),
        .out_normal_z_o(out_normal_o[2*WD +: WD]), .out_saturated_o(saturated)
    );
    assign saturated_o = out_valid_o && saturated;
    wire unused = &{1'b0, h_in, p_in, prim_data_i, r_ctr_q};
endmodule
`default_nettype wire
