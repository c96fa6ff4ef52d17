// rt_core_parameters.vh - generated from machine.def by make layout; do not edit
// SPDX-License-Identifier: Apache-2.0
// All parameters of rt_core: the last of those of a module.
    `include "rt_effects.vh"
    parameter COARSE     = 0,    // 0..8: bits of the fraction of levels rounded away
    parameter RECT       = 1,    // 0 or 1: background separation by rectangle
    parameter SPANS      = 1,    // 0 or 1: background separation by spans in memory
    parameter CONES      = 1,    // 0..16: exact background separation, by so many spheres
    parameter ACCEL      = 0,    // 0 or 1: a BIH instead of nodes of four children
    parameter BOXES      = 0,    // 0 or 1: boxes around the children of a node, not spheres
    // sizes, on which only cells and cycles depend
    parameter ENGINES    = 1,    // 1..8: engines
    parameter PIPES      = 1,    // 1..4: traversal pipes an engine
    parameter LEAF_UNITS = 0,    // 0..4: leaf units, 0: 1, for 3 and 4 pipes 2, with BOXES SHADES
    parameter SHADES     = 0,    // 0..4: shading units an engine, 0: 1, 2, 2, 4 by PIPES
    parameter SETUPS     = 0,    // 0..2: set-up units an engine, 0: 2 for 4 pipes, else 1
    parameter WALKS      = 0,    // 0..2: walks of the window, 0: 1, for several pipes 2
    parameter SLOTS      = 64,   // 4..1024, power of two: rays in flight a pipe
    parameter MEM_DATA   = 64,   // 64..256, power of two: bits of a beat of memory; a line has 256
    parameter MEM_PENDING = 0,   // 0..256, power of two: lines on their way from 16 on, 0: MEM_DATA
    parameter LINE_BITS  = 24,   // 16..26: bits of a line's number in caches: 512 MiB of memory
    parameter NODE_LINES = 512,  // 8..4096, power of two: node cache of a pipe, lines
    parameter LEAF_LINES = 128,  // 8..4096, power of two: leaf cache, lines; 4 times if PIPES > 1
    parameter TEXTURE_LINES = 128, // 8..4096, power of two: lines of a shading unit's texture cache
    parameter TEXTURE_WAYS = 4,  // 1..32, power of two: groups of a set of the texture cache
    parameter TEXTURE_GROUP = 1, // 1..4, power of two: lines of a group, fetched together
    parameter TEXTURE_COORDS = 2, // 1..8: units for texture coordinates an engine
    parameter ROOTS      = 0,    // 0..16: roots of a leaf unit at once, 0: 12, for 1 pipe 6
    parameter QUOTIENTS  = 2,    // 1..8: dividers an engine
    parameter ROOT_STEP  = 1,    // 1..W+WD: root bits a clock
    parameter QUOTIENT_STEP = 2, // 1..PQ: quotient bits a clock
    parameter LEAF_INTERVAL = 2, // 2..4, power of two: clocks an exact test of a sphere
    parameter FACET_INTERVAL = 0, // 0..4, power of two: clocks a facet, 0: 2, wide without BOXES 4
    parameter UNITS      = 2,    // 1..2: units for unit vectors an engine
    parameter UNIT_INTERVAL = 2, // 2..4, power of two: clocks a vector of each
    parameter SQUARES    = 0,    // 0..2: squares of filters in LUTs: 1 no, 2 yes, 0: of 4 pipes
    parameter SPILLS     = 0,    // 0..2: odd bits of memories in LUTs: 1 no, 2 yes, 0: from 3 pipes
    parameter HIT_INTERVAL = 8,  // 8..12: clocks a hit point and its normal, 8 or 12
    parameter BOUNCE_INTERVAL = 10 // 10..12: clocks a mirrored direction, 10 or 12
