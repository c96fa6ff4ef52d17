// rt_facet_key.v - the result of a facet: it waits for a divider, or for its taker
// SPDX-License-Identifier: Apache-2.0
//   key = ceil(a*num' / det') of a hit; a miss, or a hit of a ray to a light, needs none: key 1
//   of a plane beyond the grid: num', det' are room, size, and size - ceil(face / way) is added
// One result waits here, others in the dividers. Those of dividers go first; so a result may be
// overtaken, and the one that is offered may change while nobody takes it.
// Model: sph_facet_key() in cmodel/prim/facet.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_bundles.vh"
module rt_facet_key #(
    parameter W     = 16,                        // coordinate, bits
    parameter WD    = 17,                        // direction component, bits
    parameter SLOTS = 32,                        // power of two
    parameter DW    = 50,                        // det', bits
    parameter MW    = 49,                        // num', bits
    parameter STEP  = 2,                         // bits of a key a clock
    parameter UNITS = 1                          // dividers
) (
    input  wire                       clk,
    input  wire                       rst,
    // from rt_facet: det' first, the rest once full_o is low
    input  wire                       det_load_i,
    input  wire [DW-1:0]              det_i,     // det'
    input  wire                       in_valid_i,
    input  wire [2*WD+MW-1:0]         in_x_i,    // a*num'
    input  wire [$clog2(SLOTS)+`RT_ID_BITS-1:0] in_tag_i, // {slot, id}
    input  wire                       in_hit_i,
    input  wire                       in_shadow_i, // the ray ends at a light
    input  wire                       in_far_i,  // the normal looks along the ray
    input  wire                       in_past_i, // a plane beyond the grid: its det'*room, num'
    input  wire [MW+WD-1:0]           in_face_i,
    input  wire [MW-1:0]              in_way_i,
    output wire                       full_o,    // a result waits, and goes on waiting
    // to rt_prim
    output wire [`RT_RESULT_BITS-1:0] result_o,
    input  wire                       result_ready_i,
    // event
    output wire                       divide_o   // a division begins
);
    localparam TAG = $clog2(SLOTS) + `RT_ID_BITS;
    localparam QW  = W + WD + 1;                 // key
    reg  [2*WD+MW-1:0] x_q;
    reg  [DW-1:0]      det_q;
    reg  [TAG-1:0]     tag_q;
    reg                valid_q, hit_q, divide_q, far_q, past_q;
    wire               divider, leaves, k_valid, k_far, ranked, idle;
    wire [TAG-1:0]     k_tag;
    wire [QW:0]        k_key;
    wire [WD:0]        rank;
    wire [WD-1:0]      k_add;
    wire               can = !past_q || ranked;  // its rank is there, if it has one
    assign leaves = divide_q ? divider && can : result_ready_i && !k_valid;
    assign full_o = valid_q && !leaves;
    always @(posedge clk) begin
        if (det_load_i) det_q <= det_i;
        if (leaves) valid_q <= 1'b0;
        if (in_valid_i) begin
            valid_q  <= 1'b1;
            x_q      <= in_x_i;
            tag_q    <= in_tag_i;
            hit_q    <= in_hit_i;
            divide_q <= in_hit_i && !in_shadow_i;
            far_q    <= in_far_i;
            past_q   <= in_hit_i && in_past_i;
        end
        if (rst) valid_q <= 1'b0;
    end
    assign divide_o = valid_q && divide_q && divider && can;

    // ---- order of planes beyond the grid ----
    rt_divide #(.DW(MW), .QW(WD), .STEP(STEP < WD ? STEP : WD)) u_rank (
        .clk(clk), .rst(rst), .in_valid_i(in_valid_i && in_hit_i && in_past_i),
        .in_ready_o(idle), .in_x_i(in_face_i), .in_d_i(in_way_i),
        .out_valid_o(ranked), .out_ready_i(valid_q && past_q && leaves), .out_key_o(rank)
    );
    wire [WD:0] add = past_q ? {1'b0, det_q[WD-1:0]} - rank : {(WD+1){1'b0}};

    rt_divide_pool #(.DW(DW), .QW(QW), .STEP(STEP), .UNITS(UNITS), .TAG(WD+TAG+1)) u_pool (
        .clk(clk), .rst(rst), .in_valid_i(valid_q && divide_q && can), .in_ready_o(divider),
        .in_tag_i({add[WD-1:0], far_q, tag_q}), .in_x_i({1'b0, x_q}), .in_d_i(det_q),
        .out_valid_o(k_valid), .out_ready_i(result_ready_i), .out_tag_o({k_add, k_far, k_tag}),
        .out_key_o(k_key)
    );
    assign result_o[`RT_RESULT_VALID] = k_valid || (valid_q && !divide_q);
    assign {result_o[`RT_RESULT_SLOT], result_o[`RT_RESULT_ID]} = k_valid ? k_tag : tag_q;
    assign result_o[`RT_RESULT_HIT] = k_valid || hit_q;
    assign result_o[`RT_RESULT_FAR] = k_valid ? k_far : far_q;
    assign result_o[`RT_RESULT_KEY] = k_valid ? k_key + {{(QW+1-WD){1'b0}}, k_add}
                                               : {{QW{1'b0}}, 1'b1};
    wire unused = &{1'b0, idle, add[WD]};
endmodule
`default_nettype wire
