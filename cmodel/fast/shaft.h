/* shaft.h - four planes around the rays of a packet
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FAST_SHAFT_H
#define SPH_FAST_SHAFT_H

#include <stdint.h>

enum { SPH_SHAFT_ONE = 1 << 14 };

/* Farther from the middle of the grid than any sphere reaches, in filter units of FW <= 14 bits:
 * half the grid and the greatest radius of a node. */
enum { SPH_SHAFT_FAR = 25000 };

/* s is the way along an axis from a plane behind all rays, in filter units, sign * c[axis] - start;
 * no point of a ray has s < 0 or s > end. u is one of the other axes: of each point
 * least <= c[u] - slope * s <= most, with a slope and a bound for both sides. */
struct sph_shaft_side {
    int32_t slope, bound; /* times ONE, rounded outwards */
    int32_t length;       /* of the plane's normal, times ONE, up */
};

struct sph_shaft {
    int axis, sign; /* sign: -1 or 0, of what is added and xored */
    int32_t start, end;
    struct sph_shaft_side most[2], least[2]; /* of axis + 1, axis + 2; all of `least` negated */
};

#endif
