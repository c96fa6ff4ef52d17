/* vectors.h - seeded hard cases for the tests: bit patterns, rays, spheres that rays graze
 * SPDX-License-Identifier: Apache-2.0
 *
 * Every suite prints its seed; SEED=n in the environment repeats it.
 */
#ifndef SPH_VECTORS_H
#define SPH_VECTORS_H

#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <setjmp.h>

#include <cmocka.h>

#include "machine/layout.h"
#include "number.h"
#include "machine/profile.h"
#include "scene/rng.h"
#include "prim/sphere.h"
#include "core/ray.h"

enum { VEC_SHARE = SANITIZED ? 20 : 1 };

/* A generator with the seed of the environment, 1 by default, printed as a TAP comment. */
static inline struct sph_rng vec_seed(const char *test) {
    uint64_t seed = test_seed();
    printf("# %s: SEED=%llu\n", test, (unsigned long long)seed);
    return (struct sph_rng){seed};
}

/* low <= number <= high, uniform. */
static inline int64_t vec_pick(struct sph_rng *rng, int64_t low, int64_t high) {
    return low + (int64_t)(sph_rng_next(rng) % (uint64_t)(high - low + 1));
}

/* Up to `bits` bits (1..63): uniform, of a random length, 2^i +- 2^j, all ones, few ones, small. */
static inline uint64_t vec_unsigned(struct sph_rng *rng, int bits) {
    uint64_t all = (1ull << bits) - 1, r = sph_rng_next(rng) & all;
    int i = (int)vec_pick(rng, 0, bits - 1), j = (int)vec_pick(rng, 0, bits - 1);
    switch (vec_pick(rng, 0, 7)) {
    case 0:
        return r >> i;
    case 1:
        return ((1ull << i) + (1ull << j)) & all;
    case 2:
        return ((1ull << i) - (1ull << j)) & all;
    case 3:
        return all - (1ull << i >> 1);
    case 4:
        return r & sph_rng_next(rng) & sph_rng_next(rng);
    case 5:
        return (uint64_t)vec_pick(rng, 0, 3) & all;
    default:
        return r;
    }
}

/* The same as `bits` bits of two's complement. */
static inline int64_t vec_signed(struct sph_rng *rng, int bits) {
    int64_t r = (int64_t)vec_unsigned(rng, bits - 1);
    return sph_rng_next(rng) & 1 ? -r - 1 : r;
}

/* A ray of kind primary: any origin; directions of every length, along axes and diagonals too. */
static inline void vec_ray(struct sph_rng *rng, const struct sph_profile *p, struct sph_ray *ray) {
    *ray = (struct sph_ray){.kind = SPH_PRIMARY, .skip = {SPH_ID_NONE, 0}, .inside = 1};
    int family = (int)vec_pick(rng, 0, 9), axis = (int)vec_pick(rng, 0, 2);
    int64_t most = (1ll << (p->wd - 1)) - 1, same = vec_signed(rng, p->wd);
    for (int i = 0; i < 3; i++) {
        ray->org[i] = vec_signed(rng, p->w);
        ray->dir[i] = family < 5 ? vec_pick(rng, -most - 1, most) : vec_signed(rng, p->wd);
        int64_t sign = sph_rng_next(rng) & 1 ? 1 : -1;
        if (family == 6 && i != axis) ray->dir[i] = 0;
        if (family == 7 && i == axis) ray->dir[i] = 0;
        if (family == 8) ray->dir[i] = sign * (same > -most ? same : most);
        if (family == 9) ray->dir[i] = vec_pick(rng, -3, 3);
    }
}

/* A sphere whose surface passes close to the ray at a random place in front of it: the radius is
 * `graze` times the distance of centre and ray, within one unit. Not always inside the grid: 0. */
static inline int vec_grazed(struct sph_rng *rng, const struct sph_profile *p,
                             const struct sph_ray *ray, double graze, struct sph_leaf *leaf) {
    double d[3], oc[3], a = 0, b = 0, off2 = 0, half = (double)(1ll << (p->w - 1));
    for (int i = 0; i < 3; i++) {
        d[i] = (double)ray->dir[i];
        a += d[i] * d[i];
    }
    double reach = half * sph_rng_range(rng, 0, 2) / (a > 0 ? __builtin_sqrt(a) : 1);
    double spread = half * sph_rng_range(rng, 0, 1);
    if (sph_rng_next(rng) & 1) spread *= 0.05;
    for (int i = 0; i < 3; i++) {
        double c = (double)ray->org[i] + reach * d[i] + sph_rng_range(rng, -spread, spread);
        if (!(c >= -half && c <= half - 1)) return 0;
        leaf->ctr[i] = (int64_t)__builtin_floor(c);
        oc[i] = (double)(leaf->ctr[i] - ray->org[i]);
        b += oc[i] * d[i];
    }
    for (int i = 0; i < 3; i++) {
        double v = oc[i] - (a > 0 ? b / a * d[i] : 0);
        off2 += v * v;
    }
    double rad = __builtin_sqrt(off2) * graze + (double)vec_pick(rng, 0, 1);
    if (rad > 2 * half - 1) return 0;
    leaf->rad = (int64_t)rad;
    leaf->id = 7;
    return 1;
}

#endif
