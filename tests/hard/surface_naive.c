/* surface_naive.c - see surface.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "surface.h"

#include "naive/math.h"

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
