/* facet_exact.h - ray and facet in exact integers, by volumes of four points
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef HARD_FACET_EXACT_H
#define HARD_FACET_EXACT_H

#include "hard.h"

/* t = num/det where the ray meets the facet's plane; det >= 0, and 0 for a ray along it. */
struct facet_exact {
    int hit, far;
    int ended;    /* t is that of the end of the world, before the plane is met */
    int met;      /* the ray's line meets the plane ahead of the origin, and before a light */
    uint64_t key; /* of a hit, of no shadow ray */
    sph_i128 num, det;
    sph_i128 own_num, own_det; /* of the plane, wherever the ray ends */
};

struct facet_exact exact_facet(const struct sph_profile *p, const struct sph_ray *ray,
                               const struct sph_facet_leaf *f);

/* Sign of t1 - t2 of the planes, exactly; both det > 0, both num >= 0. */
int exact_facet_order(const struct facet_exact *e1, const struct facet_exact *e2);

#endif
