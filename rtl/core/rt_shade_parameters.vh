// rt_shade_parameters.vh - generated from machine.def by make layout; do not edit
// SPDX-License-Identifier: Apache-2.0
// Parameters of rt_shade and of what hands them on, besides effects.
    parameter COARSE     = 0,    // 0..8: bits of the fraction of levels rounded away
    parameter TEXTURE_LINES = 128, // 8..4096, power of two: lines of a shading unit's texture cache
    parameter TEXTURE_WAYS = 4,  // 1..32, power of two: groups of a set of the texture cache
    parameter TEXTURE_GROUP = 1, // 1..4, power of two: lines of a group, fetched together
    parameter TEXTURE_COORDS = 2, // 1..8: units for texture coordinates an engine
    parameter QUOTIENTS  = 2,    // 1..8: dividers an engine
    parameter QUOTIENT_STEP = 2, // 1..PQ: quotient bits a clock
    parameter HIT_INTERVAL = 8,  // 8..12: clocks a hit point and its normal, 8 or 12
    parameter BOUNCE_INTERVAL = 10, // 10..12: clocks a mirrored direction, 10 or 12
    parameter LINE_BITS  = 24,   // 16..26: bits of a line's number in caches: 512 MiB of memory
