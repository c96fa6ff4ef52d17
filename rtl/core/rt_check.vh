// rt_check.vh - a parameter that is not legal stops the elaboration, in every tool
// SPDX-License-Identifier: Apache-2.0
// No include guard: Icarus 11 crashes if it keeps macros with arguments from file to file.

// Where LEGAL does not hold a module is instantiated that does not exist: its name, which every
// tool prints, says which parameter of which module must be what.
`define RT_CHECK(LEGAL, MESSAGE) \
    generate if (!(LEGAL)) begin : MESSAGE MESSAGE u_error (); end endgenerate
