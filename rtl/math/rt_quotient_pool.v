// rt_quotient_pool.v - several dividers that look like one
// SPDX-License-Identifier: Apache-2.0
// UNITS iterative dividers: the lowest idle one takes, the lowest that is done gives, so results
// may overtake each other. A result that waits may give way to one of a lower unit: the consumer
// looks at it only when it takes it.
// Model: sph_quotient() in cmodel/math/quotient.c
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
    localparam RW = TAG + PQ + 8;
    wire [UNITS-1:0] ready, done;
    wire [UNITS-1:0] take = ready & (~ready + 1'b1) & {UNITS{in_valid_i}};
    wire [UNITS-1:0] give = done & (~done + 1'b1);
    wire [UNITS*RW-1:0] results;
    assign in_ready_o  = |ready;
    assign out_valid_o = |done;
    genvar u;
    generate
        for (u = 0; u < UNITS; u = u + 1) begin : g_unit
            wire [PQ-1:0]      mant;
            wire signed [7:0]  exp;
            reg [TAG-1:0]      tag_q;
            rt_quotient #(.KW(KW), .AW(AW), .PQ(PQ), .STEP(STEP)) u_quotient (
                .clk(clk), .rst(rst),
                .in_valid_i(take[u]), .in_ready_o(ready[u]), .in_key_i(in_key_i), .in_a_i(in_a_i),
                .out_valid_o(done[u]), .out_ready_i(give[u] && out_ready_i),
                .out_mant_o(mant), .out_exp_o(exp)
            );
            always @(posedge clk) if (take[u]) tag_q <= in_tag_i;
            assign results[RW*u +: RW] = give[u] ? {tag_q, mant, exp} : {RW{1'b0}};
        end
    endgenerate
    reg [RW-1:0] result;
    integer i;
    always @* begin
        result = {RW{1'b0}};
        for (i = 0; i < UNITS; i = i + 1) result = result | results[RW*i +: RW];
    end
    assign {out_tag_o, out_mant_o, out_exp_o} = result;
endmodule
`default_nettype wire
