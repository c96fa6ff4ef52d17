/* surface.h - the surface at a hit on a sphere, with a division of the processor
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FAST_SURFACE_H
#define SPH_FAST_SURFACE_H

#include "fast/setup.h"
#include "math/quotient.h"
#include "shade/surface.h"

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
