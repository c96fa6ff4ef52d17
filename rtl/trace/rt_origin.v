// rt_origin.v - where a ray starts, on which sphere, and the same in filter units
// SPDX-License-Identifier: Apache-2.0
// Primary rays start at the eye, on no sphere. Others start at the point that rt_surface left in
// their slot; where no others are built, nothing is kept. With LIFTS
// also by how much the point of a ray to a light was rounded.
//   filter origin = org / 2^(W-FW), half up, limited to FW bits
// A ray a clock, latency 2 clocks. Model: sph_ray_setup() in cmodel/trace/setup.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_bundles.vh"
module rt_origin #(
    parameter W         = 16,  // coordinate, bits
    parameter FW        = 14,  // filter coordinate, bits
    parameter NG        = 2,   // guard bits of a hit point
    parameter LIFTS     = 0,   // 1: facets may stand between a point and a light
    parameter SECONDARY = 1,   // 1: there are shadow or reflected rays
    parameter LUTS      = 0,   // LUT cells that a block RAM is worth, rt_slot_ram
    parameter SHADES    = 1,   // shading units, power of two
    parameter SLOTS     = 32   // power of two
) (
    input  wire                     clk,
    input  wire [3*W-1:0]           eye_i,  // register
    // from each shading unit: where secondary rays of its slots start, and on what
    input  wire [SHADES*(`RT_ORG_BITS-$clog2(SHADES))-1:0]  org_i,
    //: {SLOT[SLOTW], LIFT[3*(NG+2)], POINT[3*W], VALID}
    input  wire [SHADES*(`RT_SKIP_BITS-$clog2(SHADES))-1:0] skip_i,
    //: {SLOT[SLOTW], INSIDE, ID[24], VALID}
    // a ray
    input  wire                     read_i,
    input  wire [$clog2(SLOTS)-1:0] slot_i,
    input  wire                     primary_i,
    output wire [3*W-1:0]           org_o,
    output wire [`RT_ID_BITS:0]     skip_o, // {inside, id}
    output wire [3*(NG+2)-1:0]      lift_o, // of a ray to a light, as LIFT of org; with LIFTS
    output reg  [3*FW-1:0]          forg_o  // 3 x sFW
);
    localparam K = W - FW;
    localparam LIFT = 3*(NG+2);
    localparam [`RT_ID_BITS:0] NONE = {1'b0, {`RT_ID_BITS{1'b1}}};
    wire [3*W-1:0] org;
    reg            read_q;
    always @(posedge clk) read_q <= read_i;
    genvar s;
    generate
        if (SECONDARY != 0) begin : g_secondary
            localparam SB = $clog2(SHADES);
            localparam OB = `RT_ORG_BITS - SB, KB = `RT_SKIP_BITS - SB;
            localparam SLOTW = $clog2(SLOTS) - SB;                // of a shading unit's slot
            localparam PB = 3*W + (LIFTS != 0 ? LIFT : 0);        // a point and its lift
            wire [PB-1:0]  kept;
            wire [3*W-1:0] point = kept[3*W-1:0];
            wire [`RT_ID_BITS:0] skip;
            wire [SHADES*PB-1:0] points;
            wire [SHADES*(`RT_ID_BITS+1)-1:0] skips;
            reg            primary_q;
            reg [3*W-1:0]  org_q;
            reg [`RT_ID_BITS:0] skip_q;
            for (s = 0; s < SHADES; s = s + 1) begin : g_shade
                wire read_s = read_i && slot_i >> SLOTW == s;
                wire [OB-1:0] org_s  = org_i[OB*s +: OB];
                wire [KB-1:0] skip_s = skip_i[KB*s +: KB];
                wire [3*W+LIFT-1:0] from = {org_s[`RT_ORG_LIFT], org_s[`RT_ORG_POINT]};
                rt_slot_ram #(.WIDTH(PB), .SLOTS(SLOTS >> SB), .OLD(0), .LUTS(LUTS)) u_point (
                    .clk(clk), .wr_en_i(org_s[`RT_ORG_VALID]), .wr_addr_i(org_s[OB-1 -: SLOTW]),
                    .wr_data_i(from[PB-1:0]),
                    .rd_en_i(read_s), .rd_addr_i(slot_i[SLOTW-1:0]),
                    .rd_data_o(points[PB*s +: PB])
                );
                rt_slot_ram #(.WIDTH(25), .SLOTS(SLOTS >> SB), .OLD(0)) u_skip (
                    .clk(clk), .wr_en_i(skip_s[`RT_SKIP_VALID]),
                    .wr_addr_i(skip_s[KB-1 -: SLOTW]),
                    .wr_data_i({skip_s[`RT_SKIP_INSIDE], skip_s[`RT_SKIP_ID]}),
                    .rd_en_i(read_s), .rd_addr_i(slot_i[SLOTW-1:0]),
                    .rd_data_o(skips[(`RT_ID_BITS+1)*s +: `RT_ID_BITS+1])
                );
                if (LIFTS == 0) begin : g_no_lift
                    wire unused = &{1'b0, from[3*W +: LIFT]};
                end
            end
            if (SHADES > 1) begin : g_choose
                reg [SB-1:0] shade_q;
                always @(posedge clk) shade_q <= slot_i[SLOTW +: SB];
                assign kept = points[PB*shade_q +: PB];
                assign skip = skips[(`RT_ID_BITS+1)*shade_q +: `RT_ID_BITS+1];
            end else begin : g_one
                assign {kept, skip} = {points, skips};
            end
            assign org = primary_q ? eye_i : point;
            always @(posedge clk) begin
                primary_q <= primary_i;
                if (read_q) begin
                    org_q  <= org;
                    skip_q <= primary_q ? NONE : skip;
                end
            end
            assign org_o  = org_q;
            assign skip_o = skip_q;
            if (LIFTS != 0) begin : g_lift
                reg [LIFT-1:0] lift_q;
                always @(posedge clk) if (read_q) lift_q <= kept[3*W +: LIFT];
                assign lift_o = lift_q;
            end else begin : g_no_lift
                assign lift_o = {LIFT{1'b0}};
            end
        end else begin : g_primary
            assign org    = eye_i;
            assign org_o  = eye_i;
            assign skip_o = NONE;
            assign lift_o = {LIFT{1'b0}};
            wire unused = &{1'b0, org_i, skip_i, slot_i, primary_i};
        end
    endgenerate

    genvar i;
    generate
        for (i = 0; i < 3; i = i + 1) begin : g_forg
            if (K == 0) begin : g_same
                always @(posedge clk) if (read_q) forg_o[FW*i +: FW] <= org[W*i +: W];
            end else begin : g_round
                wire [FW:0] up = {org[W*i + W-1], org[W*i + K +: FW]} +
                                 {{FW{1'b0}}, org[W*i + K-1]};  // one bit more than fits
                always @(posedge clk) if (read_q)
                    forg_o[FW*i +: FW] <= up[FW] != up[FW-1] ? {1'b0, {(FW-1){1'b1}}}
                                                             : up[FW-1:0];
            end
        end
    endgenerate
endmodule
`default_nettype wire
