// rt_root_pool.v - square roots of leaf hits, and their keys
// SPDX-License-Identifier: Apache-2.0
// key = b - root for the near root, b + root + inexact for the far one: ceil(a*t).
// PR not 0: of the root its first PR bits count; a far key is then at least 1.
// UNITS iterative roots behind rt_pool.
// Model: sph_leaf_key_bits() in cmodel/prim/sphere.c
`timescale 1ns / 1ps
`default_nettype none
module rt_root_pool #(
    parameter W     = 16,  // coordinate, bits
    parameter WD    = 17,  // direction component, bits
    parameter PR    = 0,   // significant bits of the root, 0: all
    parameter UNITS = 3,   // square root units, 1..8
    parameter STEP  = 2,   // root bits a clock
    parameter TAG   = 8,   // tag, bits
    parameter INSIDE = 1   // 1: the far root may count
) (
    input  wire                    clk,
    input  wire                    rst,
    input  wire                    in_valid_i,
    output wire                    in_ready_o,
    input  wire [TAG-1:0]          in_tag_i,
    input  wire                    in_far_i,   // the far root counts
    input  wire [2*W+2*WD-1:0]     in_disc_i,  // > 0
    input  wire signed [W+WD+1:0]  in_b_i,
    output wire                    out_valid_o,
    input  wire                    out_ready_i,
    output wire [TAG-1:0]          out_tag_o,
    output wire                    out_far_o,
    output wire [W+WD+1:0]         out_key_o   // > 0
);
    localparam XW = 2*W + 2*WD;                // radicand
    localparam KW = W + WD + 2;                // key
    localparam BW = PR != 0 ? PR : XW/2;       // root, without the 0s behind it
    localparam VW = PR != 0 ? KW + BW + 7 : KW;  // of a unit: key, or b, inexact, shift, root
    localparam RW = VW + 1;                    // far above it
    wire [UNITS-1:0]    ready, done, take, give;
    wire [UNITS*RW-1:0] results;
    wire [VW-1:0]       result;
    rt_pool #(.UNITS(UNITS), .RW(RW), .TAG(TAG)) u_pool (
        .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .in_ready_o(in_ready_o),
        .in_tag_i(in_tag_i), .ready_i(ready), .take_o(take), .done_i(done), .give_o(give),
        .results_i(results), .out_valid_o(out_valid_o), .out_ready_i(out_ready_i),
        .out_tag_o(out_tag_o), .out_result_o({out_far_o, result})
    );
    genvar u;
    generate
        for (u = 0; u < UNITS; u = u + 1) begin : g_unit
            wire [BW-1:0]         root;
            wire [5:0]            shift;
            wire                  inexact;
            reg                   far_q;
            reg signed [KW-1:0]   b_q;
            rt_isqrt #(.XW(XW), .STEP(STEP), .BITS(PR)) u_isqrt (
                .clk(clk), .rst(rst),
                .in_valid_i(take[u]), .in_ready_o(ready[u]), .in_x_i(in_disc_i),
                .out_valid_o(done[u]), .out_ready_i(give[u]),
                .out_root_o(root), .out_shift_o(shift), .out_inexact_o(inexact)
            );
            always @(posedge clk)
                if (take[u]) begin
                    far_q <= INSIDE != 0 && in_far_i;
                    b_q   <= in_b_i;
                end
            wire [VW-1:0] value;
            if (PR != 0) begin : g_cut
                assign value = {b_q, inexact, shift, root};
            end else begin : g_all
                wire [KW-1:0] wide = {{(KW-BW){1'b0}}, root};
                assign value = far_q ? b_q + wide + {{(KW-1){1'b0}}, inexact} : b_q - wide;
                wire unused = &{1'b0, shift};
            end
            assign results[RW*u +: RW] = {far_q, value};
            // for benches: {turned away, taken, clocks of work}
            wire [7:0] work_roots /* verilator public_flat_rd */ =
                {in_valid_i && !in_ready_o, take[u], 5'd0,
                 take[u] || (!ready[u] && !(done[u] && !give[u]))};
        end
        if (PR != 0) begin : g_key                   // one shift and one sum for all units
            wire [BW-1:0] root    = result[BW-1:0];
            wire [5:0]    shift   = result[BW +: 6];
            wire          inexact = result[BW+6];
            wire [KW-1:0] b       = result[BW+7 +: KW];
            wire [KW-1:0] wide    = {{(KW-BW){1'b0}}, root} << shift;
            wire [KW-1:0] far     = b + wide + {{(KW-1){1'b0}}, inexact};
            // b < 0, and the lost bits outweigh what the root is longer
            wire          none    = b[KW-1] && (far[KW-1] || far == {KW{1'b0}});
            assign out_key_o = !out_far_o ? b - wide : none ? {{(KW-1){1'b0}}, 1'b1} : far;
        end else begin : g_given
            assign out_key_o = result;
        end
    endgenerate
endmodule
`default_nettype wire
