// rt_board.vh - the core of the boards: profile standard, spheres, shadows, mirrors, one light
// SPDX-License-Identifier: Apache-2.0
`ifndef RT_BOARD_VH
`define RT_BOARD_VH
// lines of a scene on their way; memory answers them in their order
`define RT_BOARD_PENDING 16
`define RT_BOARD_CORE .DATA(64), .VIDEO(1), .MEM_PENDING(`RT_BOARD_PENDING), \
    .SHADOW(1), .REFLECT(2), .LIGHTS(1), .INSIDE(1), .FIRST(0), .INTERPENETRATE(0), .FACETS(0), \
    .TEXTURE(0), .REFRACT(0), .SPECULAR(0), .SUM(0), .COARSE(0), .RECT(1), .SPANS(0), .CONES(0), \
    .ACCEL(0)
// lists of registers in the SDRAM, for the buttons (rt_pick); cmodel/tool/board.h has them, too
`define RT_BOARD_LISTS 32'h0140_0000
`define RT_BOARD_MAGIC 32'h5370_4c73
`endif
