/* rect.h - background separation: the pixels that may see the root sphere
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_RECT_H
#define SPH_RECT_H

#include "builder/grid/bound.h"
#include "builder/grid/grid.h"
#include "builder/background/work.h"

struct sph_rect {
    int32_t x0, y0, x1, y1; /* pixels; ends are exclusive; all zero: no pixel */
};

/* The rectangle outside of which no primary ray hits the sphere `root` (grid units): the four
 * points C +- 1.4 R of Borodavka et al. V.C where they are safe, the tangents where not, the
 * whole frame where the sphere surrounds the eye or reaches beside it. docs/results/effects.md
 * proves it. Counts its arithmetic in *work. */
struct sph_rect sph_rect_project(const struct sph_ball *root, const int32_t eye[3],
                                 const struct sph_rays *rays, int width, int height,
                                 struct sph_work *work);

#endif
