/* refract.c - see refract.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "shade/refract.h"

#include "math/arith.h"

enum { INDEX_BITS = 12 };

/* Direction and normal, shifted so that 2^(WD-1) <= |d|, |n| < 2^WD, and their products. */
struct pair {
    int64_t d[3], n[3]; /* s(WD+1) */
    int64_t dn;         /* s(2WD+1) */
    uint64_t nn;        /* u(2WD) */
    sph_i128 an;        /* d.d * n.n, u(4WD) */
};

static struct pair shifted(const struct sph_ray *ray, const struct sph_surface *s) {
    struct pair r = {.dn = 0};
    for (int i = 0; i < 3; i++) {
        r.d[i] = ray->dir[i] * (1ll << ray->unit.h);
        r.n[i] = s->normal[i] * (1ll << s->unit.h);
        r.dn += r.d[i] * r.n[i];
    }
    r.nn = s->nn << (2 * s->unit.h);
    r.an = (sph_i128)(ray->a << (2 * ray->unit.h)) * r.nn;
    return r;
}

static sph_i128 disc(const struct pair *r, uint32_t from, uint32_t to) {
    sph_i128 cross = r->an - (sph_i128)r->dn * r->dn; /* |d x n|^2 */
    return (sph_i128)(to * to) * r->an - (sph_i128)(from * from) * cross;
}

sph_i128 sph_refract_disc(const struct sph_ray *ray, const struct sph_surface *s, uint32_t from,
                          uint32_t to) {
    struct pair r = shifted(ray, s);
    return disc(&r, from, to);
}

int sph_refract(const struct sph_profile *p, const struct sph_ray *ray, const struct sph_surface *s,
                uint32_t from, uint32_t to, int64_t out[3]) {
    struct pair r = shifted(ray, s);
    sph_i128 x = disc(&r, from, to), bent[3];
    if (x < 0) return 0;
    int cut = p->wd - p->w + INDEX_BITS, inexact; /* the radicand has 2W+2WD bits */
    sph_i128 root = (sph_i128)sph_isqrt_bits((sph_u128)x >> (2 * cut), p->pr, &inexact) << cut;
    sph_i128 along = (sph_i128)from * r.dn + root; /* s(2WD+14) */
    for (int i = 0; i < 3; i++)
        bent[i] = (sph_i128)from * r.nn * r.d[i] - along * r.n[i]; /* s(3WD+13) */
    sph_normalise(bent, p->wd, out);
    return 1;
}
