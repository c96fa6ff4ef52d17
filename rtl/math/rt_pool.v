// rt_pool.v - makes several iterative units look like one with a tag
// SPDX-License-Identifier: Apache-2.0
// The lowest idle unit takes; units that are done give in turn, so results may overtake each other,
// and one waits for one of each other unit at most. What is offered may change while it waits: the
// consumer looks at it only when it takes it. The units stand outside; combinational but for the
// tags that they work under, and whose turn it is.
`timescale 1ns / 1ps
`default_nettype none
module rt_pool #(
    parameter UNITS = 3,  // units
    parameter RW    = 8,  // result, bits
    parameter TAG   = 8   // tag, bits
) (
    input  wire                clk,
    input  wire                rst,        // synchronous, active high
    // operands, as the units' own ports see them
    input  wire                in_valid_i,
    output wire                in_ready_o,
    input  wire [TAG-1:0]      in_tag_i,
    // the units: unit u in bit u and in field u
    input  wire [UNITS-1:0]    ready_i,
    output wire [UNITS-1:0]    take_o,     // at most one
    input  wire [UNITS-1:0]    done_i,
    output wire [UNITS-1:0]    give_o,     // at most one: its result is taken
    input  wire [UNITS*RW-1:0] results_i,
    // results
    output wire                out_valid_o,
    input  wire                out_ready_i,
    output wire [TAG-1:0]      out_tag_o,
    output wire [RW-1:0]       out_result_o
);
    wire [UNITS-1:0] turn;
    wire [(UNITS > 1 ? $clog2(UNITS) : 1)-1:0] number;
    rt_rr_arbiter #(.N(UNITS)) u_turns (
        .clk(clk), .rst(rst), .asks_i(done_i), .served_i(|give_o), .turn_o(turn),
        .index_o(number)
    );
    assign take_o      = ready_i & (~ready_i + 1'b1) & {UNITS{in_valid_i}};
    assign give_o      = turn & {UNITS{out_ready_i}};
    assign in_ready_o  = |ready_i;
    assign out_valid_o = |done_i;
    wire [UNITS*(TAG+RW)-1:0] all;         // of the unit in turn, 0 of the others
    genvar u;
    generate
        for (u = 0; u < UNITS; u = u + 1) begin : g_unit
            reg [TAG-1:0] tag_q;
            always @(posedge clk) if (take_o[u]) tag_q <= in_tag_i;
            assign all[(TAG+RW)*u +: TAG+RW] =
                turn[u] ? {tag_q, results_i[RW*u +: RW]} : {(TAG+RW){1'b0}};
        end
    endgenerate
    reg [TAG+RW-1:0] one;
    integer i;
    always @* begin
        one = {(TAG+RW){1'b0}};
        for (i = 0; i < UNITS; i = i + 1) one = one | all[(TAG+RW)*i +: TAG+RW];
    end
    assign {out_tag_o, out_result_o} = one;
    wire unused = &{1'b0, number};
endmodule
`default_nettype wire
