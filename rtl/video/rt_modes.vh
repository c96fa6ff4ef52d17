// rt_modes.vh - generated from modes.def by make layout; do not edit
// SPDX-License-Identifier: Apache-2.0
// mode_i[`RT_MODE_H_SYNC] is a field of the bundle; `RT_MODE_640X480 is a whole one
`ifndef RT_MODES_VH
`define RT_MODES_VH
`define RT_MODE_H_ACTIVE 0 +: 13
`define RT_MODE_H_FRONT 13 +: 13
`define RT_MODE_H_SYNC 26 +: 13
`define RT_MODE_H_BACK 39 +: 13
`define RT_MODE_V_ACTIVE 52 +: 13
`define RT_MODE_V_FRONT 65 +: 13
`define RT_MODE_V_SYNC 78 +: 13
`define RT_MODE_V_BACK 91 +: 13
`define RT_MODE_H_POL 104 +: 1
`define RT_MODE_V_POL 105 +: 1
`define RT_MODE_640X480 {1'd0, 1'd0, 13'd33, 13'd2, 13'd10, 13'd480, 13'd48, 13'd96, 13'd16, 13'd640}
`define RT_MODE_800X480 {1'd1, 1'd0, 13'd10, 13'd7, 13'd3, 13'd480, 13'd96, 13'd72, 13'd24, 13'd800}
`define RT_MODE_1280X720 {1'd1, 1'd1, 13'd20, 13'd5, 13'd5, 13'd720, 13'd220, 13'd40, 13'd110, 13'd1280}
`define RT_MODE_1920X1080 {1'd1, 1'd1, 13'd36, 13'd5, 13'd4, 13'd1080, 13'd148, 13'd44, 13'd88, 13'd1920}
`define RT_MODE_BITS 106
`endif
