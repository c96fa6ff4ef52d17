/* longitude.h - longitude and latitude by shift and add       RTL: rtl/texture/rt_longitude.v
 * SPDX-License-Identifier: Apache-2.0
 *
 * Two rotations by CORDIC: (z, x) gives the longitude and the distance from the axis, which with y
 * gives the latitude. Formats, bounds, poles and seam: docs/design/textures.md.
 */
#ifndef SPH_LONGITUDE_H
#define SPH_LONGITUDE_H

#include <stdint.h>

struct sph_longitude {
    uint32_t around; /* u0.18 turns, 1/2 + atan2(x, z): 0 towards -z, rises towards -x, +z, +x */
    uint32_t down;   /* u1.17, 0 at +y, 1 at -y: acos(y) over half a turn */
};

/* Of v, s2.16 each; only its direction counts, best at a length of 1. On the axis (x = z = 0)
 * around is 1/2; a vector of zeros has down = 1/2. */
struct sph_longitude sph_longitude(const int32_t v[3]);

#endif
