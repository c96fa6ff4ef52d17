/* setup.h - set-up of rays, with fewer steps: the numbers of arith.c and setup.c
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FAST_SETUP_H
#define SPH_FAST_SETUP_H

#include "core/ray.h"
#include "machine/layout.h"
#include "math/fx.h"
#include "math/arith.h"
#include "math/rsqrt_table.h" /* sph_rsqrt_table */
#include "shade/surface.h"
#include "trace/bih.h"
#include "trace/setup.h"

/* sph_round() of n > 0 and a number that has room for the half. */
static inline int64_t sph_fast_round(int64_t x, int n) {
    return (x + ((int64_t)1 << (n - 1))) >> n;
}

/* sph_unit(), which has what is too wide */
static inline struct sph_unit sph_fast_unit(const int64_t v[3], uint64_t vv, int bits) {
    struct sph_unit r = {{0, 0, 0}, 0, 0};
    if (!vv) return r;
    r.h = (2 * bits - 64 + __builtin_clzll(vv)) >> 1;
    if (__builtin_expect(r.h < 0, 0)) return sph_unit(v, vv, bits);
    uint32_t x = (uint32_t)(vv << (2 * r.h) >> (2 * bits - 18)), i = (x >> 10) - 64;
    r.y = sph_rsqrt_table[i].start - (sph_rsqrt_table[i].slope * (x & 1023) >> 10);
    for (int k = 0; k < 3; k++)
        r.u[k] = (int32_t)sph_fast_round((int64_t)((uint64_t)v[k] << r.h) * r.y, bits);
    return r;
}

/* sph_across() */
static inline struct sph_across sph_fast_across(const int32_t u[3]) {
    int32_t x = u[0] < 0 ? -u[0] : u[0], y = u[1] < 0 ? -u[1] : u[1], z = u[2] < 0 ? -u[2] : u[2];
    int m = y < x;
    uint64_t mag = (uint64_t)(m ? y : x);
    m = z < (int32_t)mag ? 2 : m;
    mag = z < (int32_t)mag ? (uint64_t)z : mag;
    struct sph_across r = {.axis_a = m == 0, .axis_b = m == 2 ? 1 : 2};
    uint32_t arg = (uint32_t) ~(mag * mag) >> 14, at = (arg >> 10) - 64;
    int64_t u_i = u[r.axis_a], u_j = u[r.axis_b], u_m = u[m];
    int64_t scale = (int64_t)sph_rsqrt_table[at].start - SPH_ACROSS_SHORT -
                    (sph_rsqrt_table[at].slope * (arg & 1023) >> 10);
    r.p_a = (int32_t)sph_fast_round(scale * u_j, 15);
    r.p_b = (int32_t)sph_fast_round(scale * u_i, 15);
    r.q[r.axis_a] = (int32_t)sph_fast_round(u_m * r.p_b, 16);
    r.q[r.axis_b] = (int32_t)sph_fast_round(u_m * r.p_a, 16);
    r.q[m] = (int32_t)sph_fast_round(~(u_i * r.p_b + u_j * r.p_a), 16);
    return r;
}

/* dir.dir */
static inline uint64_t sph_fast_square(const int64_t v[3]) {
    uint64_t x = (uint64_t)v[0], y = (uint64_t)v[1], z = (uint64_t)v[2];
    return x * x + y * y + z * z;
}

/* What sph_ray_setup() makes, of a ray that has `a` and `unit`. */
static inline void sph_fast_setup(const struct sph_profile *p, struct sph_ray *ray) {
    int k = p->w - p->fw;
    int64_t most = ((int64_t)1 << (p->fw - 1)) - 1;
    for (int i = 0; i < 3; i++) {
        int64_t o = k ? sph_fast_round(ray->org[i], k) : ray->org[i];
        o = o > most ? most : o;
        ray->forg[i] = (int32_t)(o < -most - 1 ? -most - 1 : o);
    }
    const int32_t *u = ray->unit.u;
    ray->across = sph_fast_across(u);
    int32_t x = u[0] < 0 ? -u[0] : u[0], y = u[1] < 0 ? -u[1] : u[1], z = u[2] < 0 ? -u[2] : u[2];
    int axis = y > x;
    int32_t mag = axis ? y : x;
    axis = z > mag ? 2 : axis;
    mag = z > mag ? z : mag;
    ray->axis = axis;
    ray->negative = u[axis] < 0;
    uint64_t scale = (ray->unit.y >> 1) + SPH_RSQRT_ERROR + 2;
    ray->depth_scale = (uint32_t)(((uint64_t)mag + 1) * scale >> 16) + 1;
    ray->depth_shift = 30 - p->fw - ray->unit.h;
    int64_t span = ray->dir[axis] < 0 ? -ray->dir[axis] : ray->dir[axis];
    int64_t light = (span >> k) + 1;
    int32_t limit = sph_depth_limit(p);
    ray->depth_max = sph_ray_ends(ray) && light < limit ? (int32_t)light : limit;
}

/* sph_ray_depth() */
static inline int32_t sph_fast_depth(const struct sph_profile *p, const struct sph_ray *ray,
                                     uint64_t key) {
    int32_t limit = sph_depth_limit(p);
    if (ray->depth_shift < 0) return limit;
    uint64_t depth =
        (((key >> (p->w + p->wd - 15)) + 1) * ray->depth_scale >> ray->depth_shift) + 1;
    return depth < (uint64_t)limit ? (int32_t)depth : limit;
}

/* All of sph_ray_setup(). */
static inline void sph_fast_prepare(const struct sph_profile *p, struct sph_ray *ray) {
    ray->a = sph_fast_square(ray->dir);
    ray->unit = sph_fast_unit(ray->dir, ray->a, p->wd);
    sph_fast_setup(p, ray);
}

/* ---- the surface at a hit on a sphere, with a division of the processor ---- */

/* sph_quotient(): its steps divide rem * 2^(pq-1) by div, rounding down. */
static inline struct sph_quotient sph_fast_quotient(uint64_t key, int key_bits, uint64_t a,
                                                    int a_bits, int pq) {
    int zk = key_bits - sph_bit_length(key), za = a_bits - sph_bit_length(a);
    int bits = key_bits > a_bits ? key_bits : a_bits;
    uint64_t rem = key << (zk + bits - key_bits), div = a << (za + bits - a_bits);
    uint64_t mant = !div              ? ((uint64_t)1 << pq) - 1 /* it goes into anything */
                    : bits + pq <= 65 ? (rem << (pq - 1)) / div
                                      : (uint64_t)(((sph_u128)rem << (pq - 1)) / div);
    return (struct sph_quotient){(uint32_t)mant, pq - 1 - key_bits + zk + a_bits - za};
}

/* x limited to -most - 1 .. most; *saturated grows by 1 if that changed it. */
static inline int64_t sph_fast_limit(int64_t x, int64_t most, int *saturated) {
    int64_t y = x > most ? most : x;
    y = y < -most - 1 ? -most - 1 : y;
    *saturated |= y != x;
    return y;
}

/* sph_normalise() of words of 64 bits */
static inline void sph_fast_normalise(const int64_t v[3], int bits, int64_t out[3]) {
    uint64_t any = (uint64_t)((v[0] ^ v[0] >> 63) | (v[1] ^ v[1] >> 63) | (v[2] ^ v[2] >> 63));
    int shift = sph_bit_length(any) - (bits - 1);
    int64_t max = ((int64_t)1 << (bits - 1)) - 1;
    for (int i = 0; i < 3; i++) {
        if (shift > 0) {
            int64_t r = sph_fast_round(v[i], shift);
            out[i] = r > max ? max : r;
        } else {
            out[i] = (int64_t)((uint64_t)v[i] << (any ? -shift : 0));
        }
    }
}

/* sph_surface_at(); ctr: of the sphere. */
static inline int sph_fast_surface(const struct sph_profile *p, const struct sph_ray *ray,
                                   const struct sph_hit *hit, const int64_t ctr[3],
                                   struct sph_surface *s) {
    struct sph_quotient t = sph_fast_quotient(hit->key, p->w + p->wd + 2, ray->a, 2 * p->wd, p->pq);
    int shift = t.exp - p->ng, saturated = 0;
    int64_t most = ((int64_t)1 << (p->w - 1)) - 1, most_guarded = ((most + 1) << p->ng) - 1;
    int64_t normal[3], unit = (int64_t)1 << p->ng;
    if (shift < 0) shift = 0, saturated = 1;
    if (shift > 62) shift = 62;
    for (int i = 0; i < 3; i++) {
        int64_t offset = sph_round((int64_t)t.mant * ray->dir[i], shift);
        s->guarded[i] = sph_fast_limit(ray->org[i] * unit + offset, most_guarded, &saturated);
        s->point[i] = sph_fast_limit(sph_round(s->guarded[i], p->ng), most, &saturated);
        normal[i] = s->guarded[i] - ctr[i] * unit;
    }
    int any = normal[0] || normal[1] || normal[2];
    for (int i = 0; i < 3; i++)
        normal[i] = !any ? -ray->dir[i] : hit->far ? -normal[i] : normal[i];
    sph_fast_normalise(normal, p->wd, s->normal);
    for (int i = 0; i < 3; i++)
        s->side[i] = s->normal[i];
    s->flat = s->bent = 0;
    s->nn = sph_fast_square(s->normal);
    s->unit = sph_fast_unit(s->normal, s->nn, p->wd);
    return saturated;
}

#endif
