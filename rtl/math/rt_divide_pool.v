// rt_divide_pool.v - several units of rt_divide that look like one
// SPDX-License-Identifier: Apache-2.0
// The lowest idle one takes, the lowest that is done gives, so results may overtake each other. A
// result that waits may give way to one of a lower unit: the consumer looks at it only when it
// takes it. Model: the division in sph_facet_key(), cmodel/trace/facet.c
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
    localparam RW = TAG + QW + 1;
    wire [UNITS-1:0] ready, done;
    wire [UNITS-1:0] take = ready & (~ready + 1'b1) & {UNITS{in_valid_i}};
    wire [UNITS-1:0] give = done & (~done + 1'b1);
    wire [UNITS*RW-1:0] results;
    assign in_ready_o  = |ready;
    assign out_valid_o = |done;
    genvar u;
    generate
        for (u = 0; u < UNITS; u = u + 1) begin : g_unit
            wire [QW:0]    key;
            reg  [TAG-1:0] tag_q;
            rt_divide #(.DW(DW), .QW(QW), .STEP(STEP)) u_divide (
                .clk(clk), .rst(rst),
                .in_valid_i(take[u]), .in_ready_o(ready[u]), .in_x_i(in_x_i), .in_d_i(in_d_i),
                .out_valid_o(done[u]), .out_ready_i(give[u] && out_ready_i), .out_key_o(key)
            );
            always @(posedge clk) if (take[u]) tag_q <= in_tag_i;
            assign results[RW*u +: RW] = give[u] ? {tag_q, key} : {RW{1'b0}};
        end
    endgenerate
    reg [RW-1:0] result;
    integer i;
    always @* begin
        result = {RW{1'b0}};
        for (i = 0; i < UNITS; i = i + 1) result = result | results[RW*i +: RW];
    end
    assign {out_tag_o, out_key_o} = result;
endmodule
`default_nettype wire
