/* near.h - do spheres come so near each other that a rounded hit point may lie in another one?
 * SPDX-License-Identifier: Apache-2.0
 *
 * The bound E and its proof: docs/design/builder.md. All of it is exact integers; error bounds are
 * in units of 2^-(NG+1) grid units, the step of the last rounding but one.
 *
 * Without INSIDE the leaf test refuses spheres with k >= 0 (the origin is in or on them) and the
 * ray's own; with it the own sphere counts only for a ray that started in it. So only an origin in
 * or on a sphere that the ray did not come from tells them apart. Let the eye be in none, and let
 * all gaps |ci - cj| - ri - rj exceed E. By induction the ray before hit sphere i from outside; the
 * next starts at most ri + E from ci, hence more than rj from every other cj: k < 0. The probe of
 * INTERPENETRATE finds no sphere around its origin but its own, so no pixel is repeated.
 */
#ifndef SPH_NEAR_H
#define SPH_NEAR_H

#include "builder/grid/bound.h"
#include "common/error.h"

/* How two spheres lie to each other; all but the first are near. */
enum { SPH_APART, SPH_NEARLY, SPH_TOUCH, SPH_OVERLAP, SPH_NESTED };

/* Bits of fraction of the bound, NG + 1. */
static inline int sph_error_bits(const struct sph_profile *p) {
    return p->ng + 1;
}

/* A point lies in the ball: 1; on its surface: 0; outside: -1. */
int sph_ball_side(const struct sph_ball *ball, const int32_t at[3]);

/* No point where a secondary ray starts is farther than this from the sphere that was hit. */
int64_t sph_point_error(const struct sph_profile *p);

/* Nor farther than this from the facet that was hit, whose points are rounded outwards. */
int64_t sph_facet_error(const struct sph_profile *p);

/* SPH_APART if the gap between the surfaces exceeds sph_point_error(). */
int sph_nearness(const struct sph_ball *a, const struct sph_ball *b, const struct sph_profile *p);

/* Looks for two of n balls that are not SPH_APART: 1 and pair[0] < pair[1], 0 if there are none,
 * -1 if memory is out. Which pair it is depends on the balls alone. */
int sph_near_pair(const struct sph_ball *balls, uint32_t n, const struct sph_profile *p,
                  uint32_t pair[2], struct sph_error *err);

#endif
