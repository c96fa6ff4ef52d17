// rt_prim.vh - widths at the ports of primitives
// SPDX-License-Identifier: Apache-2.0
// No include guard: Icarus 11 crashes if it keeps macros with arguments from file to file.

// A component of a vector along a normal: of a sphere s(w+ng+1), of a facet s24 that may be turned.
`define RT_PRIM_VECTOR_BITS(w, ng, facets) \
    ((facets) != 0 && (w) + (ng) < 24 ? 25 : (w) + (ng) + 1)

// 1: vectors of rt_hit_point may come later than the point.
`define RT_PRIM_POINT_LATER 1'b0
