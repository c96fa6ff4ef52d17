// rt_root_pool.v - square roots of leaf hits, and their keys
// SPDX-License-Identifier: Apache-2.0
// key = b - root for the near root, b + root + inexact for the far one: ceil(a*t).
// UNITS iterative roots. A result that waits may give way to one of a lower unit: the consumer
// looks at it only when it takes it.
// Model: sph_leaf_key() in cmodel/trace/leaf.c
`default_nettype none
module rt_root_pool #(
    parameter W     = 16,  // coordinate, bits
    parameter WD    = 17,  // direction component, bits
    parameter UNITS = 3,   // square root units, 1..8
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
    wire [UNITS-1:0] ready, done;
    wire [UNITS-1:0] take, give;               // one-hot choice of the lowest
    assign take = ready & (~ready + 1'b1) & {UNITS{in_valid_i}};
    assign give = done & (~done + 1'b1);
    assign in_ready_o  = |ready;
    assign out_valid_o = |done;

    wire [UNITS*(KW+TAG+1)-1:0] results;
    genvar u;
    generate
        for (u = 0; u < UNITS; u = u + 1) begin : g_unit
            wire [XW/2-1:0]       root;
            wire                  inexact;
            reg [TAG-1:0]         tag_q;
            reg                   far_q;
            reg signed [KW-1:0]   b_q;
            rt_isqrt #(.XW(XW)) u_isqrt (
                .clk(clk), .rst(rst),
                .in_valid_i(take[u]), .in_ready_o(ready[u]), .in_x_i(in_disc_i),
                .out_valid_o(done[u]), .out_ready_i(give[u] && out_ready_i),
                .out_root_o(root), .out_inexact_o(inexact)
            );
            always @(posedge clk)
                if (take[u]) begin
                    tag_q <= in_tag_i;
                    far_q <= INSIDE != 0 && in_far_i;
                    b_q   <= in_b_i;
                end
            wire [KW-1:0] wide = {{(KW-XW/2){1'b0}}, root};
            wire [KW-1:0] key  = far_q ? b_q + wide + {{(KW-1){1'b0}}, inexact} : b_q - wide;
            assign results[u*(KW+TAG+1) +: KW+TAG+1] =
                give[u] ? {tag_q, far_q, key} : {(KW+TAG+1){1'b0}};
        end
    endgenerate
    reg [KW+TAG:0] result;
    integer i;
    always @* begin
        result = {(KW+TAG+1){1'b0}};
        for (i = 0; i < UNITS; i = i + 1) result = result | results[i*(KW+TAG+1) +: KW+TAG+1];
    end
    assign {out_tag_o, out_far_o, out_key_o} = result;
endmodule
`default_nettype wire
