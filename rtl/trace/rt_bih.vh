// rt_bih.vh - what passes through rt_bih on its way to a decision
// SPDX-License-Identifier: Apache-2.0
`ifndef RT_BIH_VH
`define RT_BIH_VH
`define RT_BIH_INNER 3'd0  // node with two children
`define RT_BIH_FIT   3'd1  // node with one, between two planes
`define RT_BIH_LEAVE 3'd2  // leaf
`define RT_BIH_KILL  3'd3  // an error ends the ray
`define RT_BIH_START 3'd4  // a new ray
`endif
