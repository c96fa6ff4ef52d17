/* lod.h - which level of a MIP chain a hit sees           RTL: rtl/texture/rt_path.v, rt_lod.v
 * SPDX-License-Identifier: Apache-2.0
 *
 * Park et al. 2011, equation 2: lod = log2(path) - log2(P_b). path is the length of all rays from
 * the eye to the hit; P_b stands in the mapping record. With SPREAD a path that a sphere spreads
 * grows by so much more as the footprint of its pixel. Formats and bounds: docs/design/textures.md.
 */
#ifndef SPH_LOD_H
#define SPH_LOD_H

#include <stdint.h>

#include "machine/layout.h"
#include "core/ray.h"

/* log2(x), u6.8, of x >= 1: x is rounded half up to nine significant bits, of which a table gives
 * the fraction. Off by less than 0.0048; exact for powers of two; never falls when x rises. */
uint32_t sph_log2(uint32_t x);

/* Bits of a path length, u(W+4).4 in grid units. */
static inline int sph_path_bits(const struct sph_profile *p) {
    return p->w + 8;
}

/* path + |t*dir| * 2^spread of a hit of the ray that was set up, u(W+4).4, limited to all ones: six
 * segments on the diagonal of the grid are less than 2^(W+4). spread: 0..SPH_SPREAD_MOST. t =
 * key/a, so the length is key / |dir|, and the unit vector has 1/|dir| = y * 2^(h-WD-16), from
 * below within 6 units of y >= 2^16: no root, no quotient, at most 9.2e-5 of itself too short. */
uint64_t sph_path_add(const struct sph_profile *p, const struct sph_ray *ray, uint64_t key,
                      uint64_t path, int spread);

/* k of the ray that leaves a surface after `path`: a pixel's footprint grows along it 2^k times as
 * fast as along a primary ray. 2^k is 2^spread, of the ray before, and 4 path / radius, each to
 * the nearest power of two, and so is their sum; at most SPH_SPREAD_MOST. bend: half steps of
 * log2 of the radius, grid units, and SPH_BEND_ONE; 0: the surface is flat. */
int sph_spread(uint64_t path, int spread, uint32_t bend);

/* The bend of rays refracted at a surface: out of a sphere a quarter of what is mirrored, into it
 * none. Modulo 64, which build keeps away from. */
static inline uint32_t sph_bend_through(uint32_t bend, int out) {
    return bend && out ? (bend + SPH_BEND_THROUGH) & ((1u << SPH_PRIM_BEND_BITS) - 1) : 0;
}

/* log2(path) - base, limited to 0 .. levels-1, u4.8. base: s7.8, log2 of P_b in grid units; path 0
 * is level 0. levels: 1..12. */
uint32_t sph_lod(uint64_t path, int32_t base, int levels);

#endif
