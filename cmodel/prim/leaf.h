/* leaf.h - the exact ray/sphere test, without root or division            RTL: rtl/prim/rt_leaf.v
 * SPDX-License-Identifier: Apache-2.0
 *
 * Borodavka et al. VI.A: (R^2 - L^2) |VP|^2 + (VC.VP)^2 > 0, here disc = k*a + b*b > 0, in exact
 * integers; made total for origins on and inside the sphere, or deaf to them (ray.inside).
 */
#ifndef SPH_LEAF_H
#define SPH_LEAF_H

#include <stdint.h>

#include "math/fx.h"
#include "core/ray.h"

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
 * RTL: rtl/prim/rt_root_pool.v */
uint64_t sph_leaf_key_bits(const struct sph_leaf_result *r, int pr, uint64_t *roots);

/* The root of a hit that is no exit, of which the pr most significant bits count; *inexact: it is
 * no square. */
uint64_t sph_leaf_root(const struct sph_leaf_result *r, int pr, int *inexact);

/* With every bit of the root. */
static inline uint64_t sph_leaf_key(const struct sph_leaf_result *r, uint64_t *roots) {
    return sph_leaf_key_bits(r, 0, roots);
}

#endif
