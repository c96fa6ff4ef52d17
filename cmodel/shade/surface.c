/* surface.c - see surface.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "shade/surface.h"

#include "math/normalise.h"
#include "math/quotient.h"

int sph_surface_at(const struct sph_profile *p, const struct sph_ray *ray,
                   const struct sph_hit *hit, const struct sph_leaf *sphere,
                   struct sph_surface *s) {
    struct sph_quotient t = sph_quotient(hit->key, p->w + p->wd + 2, ray->a, 2 * p->wd, p->pq);
    int shift = t.exp - p->ng, saturated = 0;
    if (shift < 0) shift = 0, saturated = 1; /* t too long for any point of the grid */
    if (shift > 62) shift = 62;              /* rounds to zero all the same */

    sph_i128 normal[3];
    int any = 0;
    for (int i = 0; i < 3; i++) {
        int64_t offset = sph_round((int64_t)t.mant * ray->dir[i], shift);
        int64_t guarded =
            sph_saturate(ray->org[i] * (1 << p->ng) + offset, p->w + p->ng, &saturated);
        s->point[i] = sph_saturate(sph_round(guarded, p->ng), p->w, &saturated);
        normal[i] = guarded - sphere->ctr[i] * (1 << p->ng);
        if (hit->far) normal[i] = -normal[i];
        any |= normal[i] != 0;
    }
    for (int i = 0; i < 3 && !any; i++)
        normal[i] = -ray->dir[i]; /* hit at the centre */
    sph_normalise(normal, p->wd, s->normal);
    const int64_t *n = s->normal;
    s->nn = (uint64_t)(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    s->unit = sph_unit(n, s->nn, p->wd);
    return saturated;
}

void sph_bounce(const struct sph_profile *p, const int64_t dir[3], const struct sph_surface *s,
                int64_t out[3]) {
    const int64_t *n = s->normal;
    int64_t dn = dir[0] * n[0] + dir[1] * n[1] + dir[2] * n[2];
    sph_i128 mirrored[3];
    for (int i = 0; i < 3; i++)
        mirrored[i] = (sph_i128)dir[i] * s->nn - (sph_i128)n[i] * dn * 2;
    sph_normalise(mirrored, p->wd, out);
}
