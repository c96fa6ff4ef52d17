// rt_facet.vh - operations of rt_facet, one a clock
// SPDX-License-Identifier: Apache-2.0
`ifndef RT_FACET_VH
`define RT_FACET_VH
`define RT_FACET_IDLE 4'd0
`define RT_FACET_X0   4'd1   // products of a cross product that are subtracted
`define RT_FACET_X1   4'd2   // the others
`define RT_FACET_DET  4'd3   // N.dir
`define RT_FACET_NUM  4'd4   // N.A0
`define RT_FACET_U2   4'd5   // m.e1
`define RT_FACET_U1   4'd6   // m.e2
`define RT_FACET_BDET 4'd7   // det' * room: distance to what lies a unit beyond the grid
`define RT_FACET_BNUM 4'd8   // num' * size: the longest |component of dir|
`define RT_FACET_KEY  4'd9   // a * num'
`endif
