/* cones.h - which primary rays hit a sphere, exactly, as forward differences over the frame
 * SPDX-License-Identifier: Apache-2.0
 *
 * A ray hits iff f > 0 && (b > 0 || k > 0) with f = k*a + b^2 (Borodavka et al. VI.A). Along the
 * frame dir is linear, so b is linear and f quadratic in x and y. docs/results/effects.md.
 */
#ifndef SPH_CONES_H
#define SPH_CONES_H

#include "builder/grid/bound.h"
#include "builder/grid/grid.h"
#include "builder/background/work.h"

/* Forward differences at pixel (0, 0): f(x,y) = f + x*fx + x(x-1)/2*fxx + y*fy + y(y-1)/2*fyy
 * + x*y*fxy, b(x,y) = b + x*bx + y*by. All exact, f in s(2W+2WD+4), b in s(W+WD+4). */
struct sph_cone {
    __int128 f, fx, fy, fxx, fxy, fyy;
    int64_t b, bx, by;
    int inside; /* k > 0: the eye is inside the sphere */
};

/* The record of a sphere of grid units; counts its arithmetic in *work. */
struct sph_cone sph_cone_make(const struct sph_ball *ball, const int32_t eye[3],
                              const struct sph_rays *rays, struct sph_work *work);

/* First pixel and one past the last, of a row of `width`, whose ray hits the sphere; both 0 if none
 * does. Counts in *work. */
void sph_cone_row(const struct sph_cone *cone, int width, int y, int32_t *first, int32_t *end,
                  struct sph_work *work);

/* Stores the record in SPH_CONE_LINES lines of zeros. */
void sph_cone_put(uint32_t *lines, const struct sph_cone *cone);

#endif
