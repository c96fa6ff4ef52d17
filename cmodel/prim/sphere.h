/* sphere.h - the words of a sphere and its normal
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_PRIM_SPHERE_H
#define SPH_PRIM_SPHERE_H

#include "machine/machine.h"
#include "prim/leaf.h"
#include "shade/surface.h"

/* The sphere of a leaf record; the low w bits of each number count, as in the RTL. */
static inline struct sph_leaf sph_sphere_read(const uint32_t *record, int w) {
    return (struct sph_leaf){{sph_field_signed(record, SPH_LEAF_CTR_X_LSB, w),
                              sph_field_signed(record, SPH_LEAF_CTR_Y_LSB, w),
                              sph_field_signed(record, SPH_LEAF_CTR_Z_LSB, w)},
                             sph_field(record, SPH_LEAF_RAD_LSB, w),
                             sph_field(record, SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS)};
}

/* From the centre to a point with its guard bits. */
static inline void sph_sphere_normal(const struct sph_profile *p, const struct sph_leaf *sphere,
                                     const int64_t guarded[3], int64_t normal[3]) {
    for (int i = 0; i < 3; i++)
        normal[i] = guarded[i] - sphere->ctr[i] * (1 << p->ng);
}

/* The surface at a hit on a sphere; 1 if the point was limited. */
static inline int sph_surface_at(const struct sph_profile *p, const struct sph_ray *ray,
                                 const struct sph_hit *hit, const struct sph_leaf *sphere,
                                 struct sph_surface *s) {
    int64_t normal[3];
    int saturated = sph_surface_point(p, ray, hit->key, s);
    saturated |= sph_surface_nearest(p, s);
    sph_sphere_normal(p, sphere, s->guarded, normal);
    sph_surface_turn(p, ray, hit->far, normal, s);
    return saturated;
}

#endif
