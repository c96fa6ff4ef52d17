/* surface.c - hit point, normal, mirror direction and refracted ray by definition; see surface.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>

#include "naive/math.h"
#include "surface.h"

/* ---- surface_exact ---- */

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

void exact_reflect(const struct sph_profile *p, const int64_t dir[3], const int64_t normal[3],
                   int64_t out[3]) {
    sph_i128 v[3];
    for (int i = 0; i < 3; i++) { /* d(n.n) - 2(d.n)n by components: d_i n_j n_j - 2 d_j n_j n_i */
        v[i] = 0;
        for (int j = 0; j < 3; j++)
            v[i] += (sph_i128)normal[j] * (dir[i] * normal[j] - 2 * dir[j] * normal[i]);
    }
    exact_normalise(v, p->wd, out);
}

/* ---- surface_naive ---- */

int naive_surface(const struct sph_profile *p, const struct sph_ray *ray, uint64_t key, int far,
                  const struct sph_leaf *sphere, struct sph_surface *s) {
    uint64_t mant, a = 0;
    int64_t unit[3], limited = 0, any = 0;
    mpz_t n[3], x;
    mpz_inits(n[0], n[1], n[2], x, NULL);
    for (int i = 0; i < 3; i++)
        a += (uint64_t)(ray->dir[i] * ray->dir[i]);
    long exp = sph_naive_quotient(key, a, p->pq, &mant);
    for (int i = 0; i < 3; i++) {
        mpz_set_ui(n[i], mant);
        mpz_mul_si(n[i], n[i], ray->dir[i]);
        sph_naive_round(n[i], exp - p->ng);
        mpz_set_si(x, ray->org[i]);
        mpz_mul_2exp(x, x, (mp_bitcnt_t)p->ng);
        mpz_add(n[i], n[i], x);
        mpz_set_si(x, sph_naive_limit(n[i], p->w + p->ng));
        limited |= mpz_cmp(n[i], x) != 0;
        mpz_set(n[i], x);
        sph_naive_round(x, p->ng);
        s->point[i] = sph_naive_limit(x, p->w);
        limited |= mpz_cmp_si(x, s->point[i]) != 0;
        mpz_set_si(x, sphere->ctr[i]);
        mpz_mul_2exp(x, x, (mp_bitcnt_t)p->ng);
        mpz_sub(n[i], n[i], x);
        if (far) mpz_neg(n[i], n[i]);
        any |= mpz_sgn(n[i]);
    }
    for (int i = 0; i < 3 && !any; i++)
        mpz_set_si(n[i], -ray->dir[i]);
    sph_naive_normalise(n, p->wd, s->normal);
    sph_naive_unit(s->normal, p->wd, unit);
    s->nn = 0;
    for (int i = 0; i < 3; i++) {
        s->nn += (uint64_t)(s->normal[i] * s->normal[i]);
        s->unit.u[i] = (int32_t)unit[i];
    }
    mpz_clears(n[0], n[1], n[2], x, NULL);
    return limited != 0;
}

/* ---- refract_exact ---- */

/* v times the power of two that brings its length into 2^(bits-1) .. 2^bits; its square. */
static sph_i128 stretch(const int64_t v[3], int bits, sph_i128 out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = v[i];
    for (;;) {
        sph_i128 square = out[0] * out[0] + out[1] * out[1] + out[2] * out[2];
        if (square >> (2 * bits - 2)) return square;
        for (int i = 0; i < 3; i++)
            out[i] *= 2;
    }
}

/* floor(sqrt(x)) of x < 2^124. */
static sph_i128 root_of(sph_i128 x) {
    sph_i128 root = (sph_i128)sqrtl((long double)x);
    while (root * root > x)
        root--;
    while ((root + 1) * (root + 1) <= x)
        root++;
    return root;
}

int exact_refract(const struct sph_profile *p, const int64_t dir[3], const int64_t normal[3],
                  uint32_t from, uint32_t to, int64_t out[3]) {
    sph_i128 d[3], n[3], v[3], dn = 0, sine = 0;
    sph_i128 a = stretch(dir, p->wd, d), nn = stretch(normal, p->wd, n);
    for (int i = 0; i < 3; i++) {
        sph_i128 c = d[(i + 1) % 3] * n[(i + 2) % 3] - d[(i + 2) % 3] * n[(i + 1) % 3];
        sine += c * c;
        dn += d[i] * n[i];
    }
    sph_i128 x = a * nn * to * to - sine * from * from;
    if (x < 0) return 0;
    int cut = p->wd - p->w + 12;
    sph_i128 root = root_of(x / ((sph_i128)1 << 2 * cut)) * ((sph_i128)1 << cut);
    for (int i = 0; i < 3; i++)
        v[i] = from * nn * d[i] - (from * dn + root) * n[i];
    exact_normalise(v, p->wd, out);
    return 1;
}
