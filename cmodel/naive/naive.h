/* naive.h - a second, slow model that checks the golden one
 * SPDX-License-Identifier: Apache-2.0
 *
 * Written from the definitions alone: every primitive of the machine is tested against every ray in
 * unbounded integers (GMP), the discriminant in Lagrange's form rad^2*a - |oc x dir|^2, roots are
 * compared by squaring, keys are found by search; facets are met by solving equations in rational
 * numbers. Nothing of the golden model is called.
 */
#ifndef SPH_NAIVE_H
#define SPH_NAIVE_H

#include "core/frame.h"
#include "machine/machine.h"
#include "prim/facet.h"
#include "prim/sphere.h"
#include "core/ray.h"

struct sph_naive_leaf {
    int hit;      /* a root t > 0 (shadow ray: 0 < t < 1), after the skip rules */
    int far;      /* the greater root, or leaving the ray's own sphere */
    int exit;     /* inside its own sphere with no root ahead: key 1 */
    uint64_t key; /* smallest integer n >= 1 with n >= a*t; 0 for shadow rays and misses */
};

/* Tests one sphere; of *ray only org, dir, kind, skip and inside are read. Total for any int64
 * operands below 2^30. pr: significant bits of the root that the key is made of, 0: all. */
struct sph_naive_leaf sph_naive_leaf_bits(const struct sph_ray *ray, const struct sph_leaf *leaf,
                                          int pr);

static inline struct sph_naive_leaf sph_naive_leaf(const struct sph_ray *ray,
                                                   const struct sph_leaf *leaf) {
    return sph_naive_leaf_bits(ray, leaf, 0);
}

/* Tests one facet: org + t*dir = v0 + x*e1 + y*e2 is solved in rational numbers. exit is 0, and far
 * that the normal looks along the ray. */
struct sph_naive_leaf sph_naive_facet(const struct sph_profile *p, const struct sph_ray *ray,
                                      const struct sph_facet_leaf *facet);

/* The facet of a leaf line. */
struct sph_facet_leaf sph_naive_facet_read(const uint32_t *line);

/* 1 if pixel x, y is left out by the background separation of BG_MODE. */
int sph_naive_background(const struct sph_machine *m, int x, int y);

/* The colours, id, key and word of textures of pixel x, y; visits stays 0. The machine must be well
 * formed. Its tree is read for effect FIRST alone, and of it no bounding sphere: what they leave
 * out is not hit. */
struct sph_pixel sph_naive_pixel(const struct sph_machine *m, int x, int y);

/* 1 if the machine lacks what another camera than its own would show, and has another: every bit of
 * every register is put where it counts, one by one. */
int sph_naive_strayed(const struct sph_machine *m);

#endif
