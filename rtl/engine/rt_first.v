// rt_first.v - of several bundles that wait the first goes, with its unit on top of its slot
// SPDX-License-Identifier: Apache-2.0
// The lowest bit of a bundle says that it waits; the other way round: rt_route. Combinational; with
// one unit nothing is here.
`timescale 1ns / 1ps
`default_nettype none
module rt_first #(
    parameter WIDTH = 8,  // of a unit's bundle, bits; its slot is on top
    parameter N     = 1   // units, power of two
) (
    input  wire [N*WIDTH-1:0]         in_i,
    output wire [N-1:0]               ready_o,
    output wire [$clog2(N)+WIDTH-1:0] out_o,    // {unit, its bundle}; the first's, if none waits
    input  wire                       ready_i
);
    generate
        if (N > 1) begin : g_several
            localparam NB = $clog2(N);
            reg  [N-1:0]  waits;
            wire [N-1:0]  take = waits & (~waits + 1'b1);
            reg  [NB-1:0] one;
            integer       i;
            always @* begin
                for (i = 0; i < N; i = i + 1) waits[i] = in_i[WIDTH*i];
                one = {NB{1'b0}};
                for (i = 0; i < N; i = i + 1) if (take[i]) one = one | i[NB-1:0];
            end
            assign ready_o = take & {N{ready_i}};
            assign out_o   = {one, in_i[WIDTH*one +: WIDTH]};
        end else begin : g_one
            assign ready_o = ready_i;
            assign out_o   = in_i;
        end
    endgenerate
endmodule
`default_nettype wire
