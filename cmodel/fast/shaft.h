/* shaft.h - planes around the rays of a packet
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FAST_SHAFT_H
#define SPH_FAST_SHAFT_H

#include <stdint.h>

#include "fast/lanes.h"

/* Farther from the middle of the grid than any sphere reaches, in filter units of FW <= 14 bits:
 * half the grid and the greatest radius of a node. */
enum { SPH_SHAFT_FAR = 25000 };

/* A sphere of a node lies outside, with its radius r, if of its pairs of words, as the node has
 * them, xy . (x, y) + zr . (z, r) > bound; each for four children. */
struct sph_shaft_plane {
    four xy, zr, bound;
};

/* s is the way along an axis from a plane behind all rays, in filter units, sign * c[axis] - start;
 * no point of a ray has s < 0 or s > end. u is one of the other axes, or minus it: of each point
 * u - slope * s <= bound, with a slope and a bound for each of the four. */
enum { SPH_SHAFT_END, SPH_SHAFT_BEGIN, SPH_SHAFT_SIDES, SPH_SHAFT_PLANES = 6 };

struct sph_shaft {
    struct sph_shaft_plane plane[SPH_SHAFT_PLANES];
    int axis;
    int32_t start;
};

#endif
