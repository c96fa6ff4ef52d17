// rt_latency.vh - fixed latencies that a neighbour aligns its tags with
// SPDX-License-Identifier: Apache-2.0
`ifndef RT_LATENCY_VH
`define RT_LATENCY_VH
`define RT_FILTER_LATENCY 9
`define RT_FILTER_SQUARES_LATENCY 12
// clocks from a ray of rt_setup to its axes across, at most
`define RT_ACROSS_BEHIND 12
`define RT_BIH_STEP_LATENCY 5
`define RT_BOXES_LATENCY 13
`endif
