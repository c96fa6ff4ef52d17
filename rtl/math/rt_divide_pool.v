// rt_divide_pool.v - several units of rt_divide that look like one
// SPDX-License-Identifier: Apache-2.0
// They stand behind rt_pool. Model: the division in sph_facet_key(), cmodel/prim/facet.c
`timescale 1ns / 1ps
`default_nettype none
module rt_divide_pool #(
    parameter DW    = 50,  // divisor, bits
    parameter QW    = 34,  // quotient, bits
    parameter STEP  = 2,   // quotient bits a clock
    parameter UNITS = 1,   // dividers
    parameter TAG   = 8    // tag, bits
) (
    input  wire             clk,
    input  wire             rst,
    input  wire             in_valid_i,
    output wire             in_ready_o,
    input  wire [TAG-1:0]   in_tag_i,
    input  wire [DW+QW-1:0] in_x_i,
    input  wire [DW-1:0]    in_d_i,        // > 0
    output wire             out_valid_o,
    input  wire             out_ready_i,
    output wire [TAG-1:0]   out_tag_o,
    output wire [QW:0]      out_key_o
);
    localparam RW = QW + 1;
    wire [UNITS-1:0]    ready, done, take, give;
    wire [UNITS*RW-1:0] keys;
    rt_pool #(.UNITS(UNITS), .RW(RW), .TAG(TAG)) u_pool (
        .clk(clk), .in_valid_i(in_valid_i), .in_ready_o(in_ready_o), .in_tag_i(in_tag_i),
        .ready_i(ready), .take_o(take), .done_i(done), .give_o(give), .results_i(keys),
        .out_valid_o(out_valid_o), .out_ready_i(out_ready_i), .out_tag_o(out_tag_o),
        .out_result_o(out_key_o)
    );
    genvar u;
    generate
        for (u = 0; u < UNITS; u = u + 1) begin : g_unit
            rt_divide #(.DW(DW), .QW(QW), .STEP(STEP)) u_divide (
                .clk(clk), .rst(rst),
                .in_valid_i(take[u]), .in_ready_o(ready[u]), .in_x_i(in_x_i), .in_d_i(in_d_i),
                .out_valid_o(done[u]), .out_ready_i(give[u]), .out_key_o(keys[RW*u +: RW])
            );
        end
    endgenerate
endmodule
`default_nettype wire
