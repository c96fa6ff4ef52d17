// rt_memory.vh - what a tool is told of memories and synchronisers: the only words of a family
// SPDX-License-Identifier: Apache-2.0
// The files that include this one are all that hold memory or take bits of another clock. To put a
// compiled memory in the place of one, replace that file and keep its ports and what its head says.
//   RT_NO_LUT_RAM   defined for a family without memory in LUTs, and for standard cells: a
//                   rt_slot_file is of flip-flops then, unless its file is replaced
//   RT_FALLING_BITS a number: a rt_slot_file of so many bits and more is block RAM that is read at
//                   the falling edge, for a family whose memory has registered reads only
`ifndef RT_FALLING_BITS
`define RT_FALLING_BITS 0
`endif
`ifndef RT_LUT_RAM
`ifdef RT_NO_LUT_RAM
`define RT_LUT_RAM
`else
`define RT_LUT_RAM (* ram_style = "distributed" *)
`endif
// read behind a register; FREE: never in the clock of a write to the same word
`define RT_BLOCK_RAM      (* ram_style = "block" *)
`define RT_BLOCK_RAM_FREE (* ram_style = "block", no_rw_check *)
// the flip-flops of a synchroniser, side by side and out of every other optimisation
`define RT_SYNC_FLOPS     (* async_reg = "true" *)
`endif
