// rt_route.v - bundles of several sources, to the units that their slots belong to
// SPDX-License-Identifier: Apache-2.0
//   source --+--> unit 0    the bundle without the top bits of its slot, which name the unit;
//            +--> unit 1    for all others its lowest bits, which say that something comes, are 0
// Each source has the slots of TO/FROM units, rounded up to a power of two. A slot is the top of a
// bundle; that of a source leaves out the bits that name the source. Combinational; where a source
// has one unit nothing is here.
`timescale 1ns / 1ps
`default_nettype none
module rt_route #(
    parameter WIDTH = 8,  // of a bundle with all of its slot, bits
    parameter LOW   = 1,  // bits that say that something comes
    parameter FROM  = 1,  // sources, power of two
    parameter TO    = 1   // units, at least FROM
) (
    input  wire [FROM*(WIDTH-$clog2(FROM))-1:0] in_i,
    output wire [TO*(WIDTH-$clog2(TO))-1:0]     out_o
);
    localparam IW = WIDTH - $clog2(FROM), OW = WIDTH - $clog2(TO);
    localparam NAME = IW - OW;                 // bits of a unit among those of a source
    genvar n;
    generate
        for (n = 0; n < TO; n = n + 1) begin : g_unit
            localparam [31:0] UNIT = n;
            wire [IW-1:0] from = in_i[IW*(n >> NAME) +: IW];
            if (NAME > 0) begin : g_several
                wire own = from[IW-1 -: NAME] == UNIT[NAME-1:0];
                assign out_o[OW*n +: OW] = {from[OW-1:LOW], from[LOW-1:0] & {LOW{own}}};
            end else begin : g_one
                assign out_o[OW*n +: OW] = from;
            end
        end
    endgenerate
endmodule
`default_nettype wire
