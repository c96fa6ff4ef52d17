/* leaf.h - the exact test of a decoded leaf record
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FAST_LEAF_H
#define SPH_FAST_LEAF_H

#include <math.h>

#include "fast/decoded.h"
#include "math/fx.h"
#include "trace/leaf_unit.h"

/* ---- the integer root by the processor's own, corrected ---- */

/* Near x; without the call that a compiler makes of it. */
static inline double sph_fast_near(sph_i128 x) {
    return (double)(int64_t)(x >> 62) * 0x1p62 + (double)(int64_t)(x & (((int64_t)1 << 62) - 1));
}

/* floor(sqrt(x)) for x < 2^124. The doubles are a guess and no more: the loops at the end do not
 * stop before root^2 <= x < (root + 1)^2, wherever they begin. They take a step or two, for the
 * guess is off by less than 2^62 * 2^-52 + 1, and one step of Heron's leaves less than 1 of it. */
static inline uint64_t sph_fast_isqrt(sph_u128 x) {
    double guess = sqrt(sph_fast_near((sph_i128)x));
    uint64_t root = (uint64_t)(int64_t)guess;
    if (x >> 96 && root) {
        sph_i128 rest = (sph_i128)x - (sph_i128)((sph_u128)root * root);
        root += (uint64_t)(int64_t)(sph_fast_near(rest) / (2 * guess));
    }
    while ((sph_u128)root * root > x)
        root--;
    while ((sph_u128)(root + 1) * (root + 1) <= x)
        root++;
    return root;
}

/* floor(sqrt(x)) of x < 2^104 from a guess that is less than 2^9 off, and *rest, x - root^2:
 * numbers of 64 bits hold what is left of x. */
static inline uint64_t sph_fast_isqrt_near(sph_u128 x, double guess, int64_t *rest) {
    int64_t root = (int64_t)guess, r = (int64_t)((uint64_t)x - (uint64_t)root * (uint64_t)root);
    for (; r < 0; root--)
        r += 2 * root - 1;
    for (; r > 2 * root; root++)
        r -= 2 * root + 1;
    *rest = r;
    return (uint64_t)root;
}

/* floor(sqrt(disc)), disc = k * a + b * b > 0, b > 0 or k > 0, of numbers below 2^52; *inexact: it
 * is no square. In doubles disc is off by less than 2^-51 of b * b where k < 0, and its root by
 * less than b * 2^-43 if it is not much smaller; else it is too small for them. */
static inline uint64_t sph_fast_root(sph_i128 disc, int64_t k, uint64_t a, int64_t b,
                                     int *inexact) {
    double square = (double)b * (double)b, near = (double)k * (double)(int64_t)a + square;
    if (near > square * 0x1p-18) {
        int64_t rest;
        uint64_t root = sph_fast_isqrt_near((sph_u128)disc, sqrt(near), &rest);
        *inexact = rest != 0;
        return root;
    }
    uint64_t root = sph_fast_isqrt((sph_u128)disc);
    *inexact = (sph_u128)root * root != (sph_u128)disc;
    return root;
}

/* As sph_isqrt_bits(): the root's `bits` most significant bits, 0: all. */
static inline uint64_t sph_fast_isqrt_bits(sph_u128 x, int bits, int *inexact) {
    uint64_t root = sph_fast_isqrt(x);
    int length = sph_bit_length(root), left = bits > 0 && length > bits ? length - bits : 0;
    root = root >> left << left;
    *inexact = (sph_u128)root * root != x;
    return root;
}

/* sph_ray_query_of() */
static inline struct sph_ray_query sph_fast_ray_query(const struct sph_fast *f,
                                                      const struct sph_ray *ray,
                                                      struct sph_counters *c, uint32_t *errors) {
    return (struct sph_ray_query){.p = sph_machine_profile(f->m),
                                  .ray = ray,
                                  .whole = f->whole,
                                  .passes = ray->kind == SPH_SHADOW && f->clear,
                                  .best = {0, SPH_ID_NONE, 0, 0},
                                  .c = c,
                                  .errors = errors};
}

/* As sph_leaf_visit(), but for the counter of tests of spheres. What is no sphere, or a
 * clear one, is tested by its literal function here; of spheres this is sph_leaf_test() with the
 * root of root.h. */
static inline void sph_fast_leaf_visit(struct sph_ray_query *query,
                                       const struct sph_fast_leaf *leaf, const uint32_t *mem) {
    const struct sph_ray *ray = query->ray;
    const int64_t *d = ray->dir;
    if (__builtin_expect(leaf->record != 0, 0)) {
        sph_leaf_visit(query, mem + (leaf->record - 1));
        return;
    }
    int64_t x = leaf->ctr[0] - ray->org[0], y = leaf->ctr[1] - ray->org[1],
            z = leaf->ctr[2] - ray->org[2], rad = leaf->rad, a = (int64_t)ray->a;
    int64_t k = rad * rad - (x * x + y * y + z * z);
    int own = leaf->id == ray->skip.id;
    if (ray->inside ? own && !ray->skip.inside : own || k >= 0) return;
    int64_t b = x * d[0] + y * d[1] + z * d[2];
    sph_i128 disc = (sph_i128)k * a + (sph_i128)b * b;
    struct sph_hit hit = {1, leaf->id, k >= 0 || own, 0};
    if (sph_ray_ends(ray)) {
        int64_t k_light = k + 2 * b - a;
        if (own     ? k_light >= 0
            : k < 0 ? !(disc > 0 && b > 0 && (b < a || k_light > 0))
                    : !((k > 0 || b > 0) && k_light < 0))
            return;
    } else {
        int ahead = disc > 0 && (b > 0 || k > 0);
        if (!ahead && !own) return;
        if (ahead) { /* else it leaves its own sphere at t = 0 */
            int inexact, pr = query->p->pr;
            int64_t root = (int64_t)(pr ? sph_fast_isqrt_bits((sph_u128)disc, pr, &inexact)
                                        : sph_fast_root(disc, k, ray->a, b, &inexact));
            int64_t key = hit.far ? b + root + inexact : b - root;
            hit.key = pr && hit.far && key < 1 ? 1 : (uint64_t)key;
            query->c->count[SPH_COUNT_ROOTS]++;
        }
    }
    struct sph_hit *best = &query->best;
    sph_hit_count(best, &hit);
    if (!best->key || hit.key < best->key || (hit.key == best->key && hit.id < best->id))
        *best = hit;
}

/* The same of leaf record `number`. */
static inline void sph_fast_visit(struct sph_ray_query *query, const struct sph_fast *f,
                                  uint32_t number) {
    const struct sph_fast_leaf *leaf = &f->leaves[number];
    if (leaf->record && f->triangles && f->triangles[number].known)
        sph_fast_triangle_visit(query, &f->triangles[number]);
    else
        sph_fast_leaf_visit(query, leaf, f->m->mem);
}

#endif
