// rt_facet.vh - widths and latency that rt_facet and rt_facet_sums share
// SPDX-License-Identifier: Apache-2.0
// No include guard: Icarus 11 crashes if it keeps macros with arguments from file to file.

// Bits of a difference or a component of dir; of a component of N or m (docs/design/primitives.md).
`define RT_FACET_NARROW(w, wd) ((w) + 1 > (wd) ? (w) + 1 : (wd))
`define RT_FACET_LONGER(w, wd) ((w) + (wd) > 2*(w) ? (w) + (wd) + 1 : 2*(w) + 1)
`define RT_FACET_WIDE(w, wd) (`RT_FACET_LONGER(w, wd) > 24 ? `RT_FACET_LONGER(w, wd) : 24)

// rt_facet_sums: clocks from taking a facet to its normal; to its sums.
`define RT_FACET_NORMAL(w, wd, interval) \
    (`RT_MUL_LATENCY(`RT_FACET_NARROW(w, wd)) + ((interval) == 4 ? 1 : 0) + 3)
`define RT_FACET_SUMS_LATENCY(w, wd, interval) \
    (`RT_MUL_LATENCY(`RT_FACET_NARROW(w, wd)) + ((interval) == 4 ? 1 : 0) + 4 + (interval) + \
     `RT_PRODUCT_LATENCY(`RT_FACET_WIDE(w, wd)))

// rt_facet_key: clocks from a plane to the next, two products by a component of dir, pieces of 17.
`define RT_FACET_PLANE(w, wd) (2*((`RT_FACET_NARROW(w, wd) + 16) / 17))
