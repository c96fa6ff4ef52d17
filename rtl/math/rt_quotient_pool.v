// rt_quotient_pool.v - several dividers that look like one
// SPDX-License-Identifier: Apache-2.0
// UNITS iterative dividers behind rt_pool. Model: sph_quotient() in cmodel/math/arith.c
`timescale 1ns / 1ps
`default_nettype none
module rt_quotient_pool #(
    parameter KW    = 35,  // key, bits
    parameter AW    = 34,  // a, bits
    parameter PQ    = 17,  // quotient, bits
    parameter UNITS = 3,   // dividers
    parameter STEP  = 2,   // quotient bits a clock
    parameter TAG   = 8    // tag, bits
) (
    input  wire            clk,
    input  wire            rst,
    input  wire            in_valid_i,
    output wire            in_ready_o,
    input  wire [TAG-1:0]  in_tag_i,
    input  wire [KW-1:0]   in_key_i,     // > 0
    input  wire [AW-1:0]   in_a_i,       // > 0
    output wire            out_valid_o,
    input  wire            out_ready_i,
    output wire [TAG-1:0]  out_tag_o,
    output wire [PQ-1:0]   out_mant_o,
    output wire [7:0]      out_exp_o     // s8, t = mant * 2^-exp
);
    localparam RW = PQ + 8;
    wire [UNITS-1:0]    ready, done, take, give;
    wire [UNITS*RW-1:0] results;
    rt_pool #(.UNITS(UNITS), .RW(RW), .TAG(TAG)) u_pool (
        .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .in_ready_o(in_ready_o),
        .in_tag_i(in_tag_i), .ready_i(ready), .take_o(take), .done_i(done), .give_o(give),
        .results_i(results), .out_valid_o(out_valid_o), .out_ready_i(out_ready_i),
        .out_tag_o(out_tag_o), .out_result_o({out_mant_o, out_exp_o})
    );
    genvar u;
    generate
        for (u = 0; u < UNITS; u = u + 1) begin : g_unit
            wire [PQ-1:0]      mant;
            wire signed [7:0]  exp;
            rt_quotient #(.KW(KW), .AW(AW), .PQ(PQ), .STEP(STEP)) u_quotient (
                .clk(clk), .rst(rst),
                .in_valid_i(take[u]), .in_ready_o(ready[u]), .in_key_i(in_key_i), .in_a_i(in_a_i),
                .out_valid_o(done[u]), .out_ready_i(give[u]),
                .out_mant_o(mant), .out_exp_o(exp)
            );
            // for benches: {turned away, taken, clocks of work}
            wire [7:0] work_quotients /* verilator public_flat_rd */ =
                {in_valid_i && !in_ready_o, take[u], 5'd0,
                 take[u] || (!ready[u] && !(done[u] && !give[u]))};
            assign results[RW*u +: RW] = {mant, exp};
        end
    endgenerate
endmodule
`default_nettype wire
