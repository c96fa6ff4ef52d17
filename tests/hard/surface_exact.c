/* surface_exact.c - see surface.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "surface.h"

/* floor(x / 2^n + 1/2); a negative n multiplies. */
static sph_i128 half_up(sph_i128 x, int n) {
    return n > 0 ? (2 * x + ((sph_i128)1 << n)) >> (n + 1) : x * ((sph_i128)1 << -n);
}

static int64_t limit(sph_i128 x, int bits, int *limited) {
    sph_i128 end = (sph_i128)1 << (bits - 1);
    if (x >= end) return *limited = 1, (int64_t)(end - 1);
    if (x < -end) return *limited = 1, (int64_t)-end;
    return (int64_t)x;
}

int exact_is_quotient(const struct sph_profile *p, uint64_t key, uint64_t a,
                      const struct sph_quotient *q) {
    int exp = p->pq - 1 + sph_bit_length(a) - sph_bit_length(key);
    sph_u128 left = (sph_u128)q->mant * a, more = left + a, right = key;
    if (exp >= 0)
        right <<= exp;
    else
        left <<= -exp, more <<= -exp;
    return q->exp == exp && q->mant >> p->pq == 0 && q->mant >> (p->pq - 2) && left <= right &&
           right < more;
}

void exact_normalise(const sph_i128 v[3], int bits, int64_t out[3]) {
    int longest = 0, limited;
    sph_i128 reach = 0; /* of n bits: -2^n <= v < 2^n for all three */
    for (int i = 0; i < 3; i++)
        reach |= v[i] < 0 ? ~v[i] : v[i];
    for (int step = 64; step; step /= 2)
        if (reach >> (longest + step - 1)) longest += step;
    for (int i = 0; i < 3; i++)
        out[i] =
            longest ? limit(half_up(v[i], longest - (bits - 1)), bits, &limited) : (int64_t)v[i];
}

int exact_surface(const struct sph_profile *p, const struct sph_ray *ray,
                  const struct sph_quotient *q, int far, const struct sph_leaf *sphere,
                  struct sph_surface *s) {
    int limited = 0, any = 0;
    sph_i128 n[3];
    for (int i = 0; i < 3; i++) {
        sph_i128 offset = half_up((sph_i128)q->mant * ray->dir[i], q->exp - p->ng);
        int64_t guarded = limit(offset + ray->org[i] * (1 << p->ng), p->w + p->ng, &limited);
        s->point[i] = limit(half_up(guarded, p->ng), p->w, &limited);
        n[i] = (sph_i128)guarded - sphere->ctr[i] * (1 << p->ng);
        if (far) n[i] = -n[i];
        any |= n[i] != 0;
    }
    for (int i = 0; i < 3 && !any; i++)
        n[i] = -ray->dir[i];
    exact_normalise(n, p->wd, s->normal);
    s->nn = 0;
    for (int i = 0; i < 3; i++)
        s->nn += (uint64_t)(s->normal[i] * s->normal[i]);
    return limited;
}

void exact_bounce(const struct sph_profile *p, const int64_t dir[3], const int64_t normal[3],
                  int64_t out[3]) {
    sph_i128 v[3];
    for (int i = 0; i < 3; i++) { /* d(n.n) - 2(d.n)n by components: d_i n_j n_j - 2 d_j n_j n_i */
        v[i] = 0;
        for (int j = 0; j < 3; j++)
            v[i] += (sph_i128)normal[j] * (dir[i] * normal[j] - 2 * dir[j] * normal[i]);
    }
    exact_normalise(v, p->wd, out);
}
