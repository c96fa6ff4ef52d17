/* sphere.h - the words of a sphere and its normal
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_PRIM_SPHERE_H
#define SPH_PRIM_SPHERE_H

#include <stdint.h>

#include "core/ray.h"
#include "machine/machine.h"
#include "math/fx.h"
#include "shade/surface.h"

/* ---- the exact ray/sphere test, without root or division (RTL: rtl/prim/rt_leaf.v) ---- */
/* Borodavka et al. VI.A: (R^2 - L^2) |VP|^2 + (VC.VP)^2 > 0, here disc = k*a + b*b > 0, in exact
 * integers; made total for origins on and inside the sphere, or deaf to them (ray.inside). */

struct sph_leaf {
    int64_t ctr[3]; /* sW */
    int64_t rad;    /* uW */
    uint32_t id;
};

struct sph_leaf_result {
    int hit;       /* any other ray: a root with t > 0; shadow ray: one with 0 < t < 1 */
    int far;       /* the far root counts: the origin is inside */
    int exit;      /* inside its own sphere with nothing ahead: leaves at t = 0, key = 1 */
    sph_i128 disc; /* s(2W+2WD+2) */
    int64_t b;     /* s(W+WD+2) */
    int64_t k;     /* s(2W+3) */
};

/* Valid for every operand in range; dir = 0 and rad = 0 miss, and so does a tangent. Without
 * ray->inside the ray's own sphere and every sphere with k >= 0 miss. */
struct sph_leaf_result sph_leaf_test(const struct sph_ray *ray, const struct sph_leaf *leaf);

/* ceil(a*t) of a hit, u(W+WD+2), at least 1. Orders the hits of one ray; *roots counts square
 * roots. Of the root the pr most significant bits count, 0: all; then b -+ root, at least 1.
 * Cut roots make near keys grow and far keys shrink, so the nearest of two hits may be another one,
 * but with any tree the same: a sphere that is pruned lies behind the best key, its own key is no
 * smaller if near, and a ray that starts in it is never pruned from it.
 * RTL: rtl/prim/rt_sphere_key.v */
uint64_t sph_leaf_key_bits(const struct sph_leaf_result *r, int pr, uint64_t *roots);

/* The root of a hit that is no exit, of which the pr most significant bits count; *inexact: it is
 * no square. */
uint64_t sph_leaf_root(const struct sph_leaf_result *r, int pr, int *inexact);

/* With every bit of the root. */
static inline uint64_t sph_leaf_key(const struct sph_leaf_result *r, uint64_t *roots) {
    return sph_leaf_key_bits(r, 0, roots);
}

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
