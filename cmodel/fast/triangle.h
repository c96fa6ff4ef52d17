/* triangle.h - the exact test of a decoded triangle: that of prim/facet.c in words of 64 bits
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FAST_TRIANGLE_H
#define SPH_FAST_TRIANGLE_H

#include "prim/facet.h"
#include "prim/prim.h"
#include "trace/leaf_unit.h"

struct sph_fast_triangle {
    int64_t n[3];               /* e1 x e2, s(2W+1) */
    int32_t v[3], e1[3], e2[3]; /* a corner, sW; the edges from it, s(W+1) */
    uint32_t id, before, after; /* as of sph_facet_leaf */
    uint32_t known;             /* 0: no triangle, or a clear one */
};

/* Whether the volumes, u(2W+WD+1), and num, u(3W+1), have room. */
static inline int sph_fast_triangles_fit(const struct sph_profile *p) {
    return 2 * p->w + p->wd + 1 <= 63 && 3 * p->w + 1 <= 63;
}

/* Sums that have room, though their parts may not. */
static inline int64_t sph_fast_dot(const int64_t a[3], const int64_t b[3]) {
    const uint64_t *x = (const uint64_t *)a, *y = (const uint64_t *)b;
    return (int64_t)(x[0] * y[0] + x[1] * y[1] + x[2] * y[2]);
}

static inline void sph_fast_cross(const int64_t a[3], const int64_t b[3], int64_t out[3]) {
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

/* Of x or, if sign is -1, of -x. */
static inline int64_t sph_fast_turned(int64_t x, int64_t sign) {
    return (int64_t)(((uint64_t)x ^ (uint64_t)sign) - (uint64_t)sign);
}

/* Reads a leaf record that has a whole line. */
void sph_fast_triangle_read(const struct sph_profile *p, const uint32_t *record,
                            struct sph_fast_triangle *t);

/* As ahead() of facet.c. */
static inline int sph_fast_ahead(const struct sph_profile *p, const struct sph_ray *ray,
                                 const int64_t n[3], int64_t sign, int64_t num) {
    sph_i128 lift = 0, all = 0;
    for (int i = 0; i < 3; i++) {
        lift += (sph_i128)n[i] * ray->lift[i];
        all += n[i] < 0 ? -n[i] : n[i];
    }
    return (sph_i128)num * (1 << p->ng) + (sign ? -lift : lift) > all;
}

/* As sph_leaf_visit() of its record. */
static inline void sph_fast_triangle_visit(struct sph_ray_query *query,
                                           const struct sph_fast_triangle *t) {
    const struct sph_ray *ray = query->ray;
    int64_t a0[3], e1[3], e2[3], m[3];
    for (int i = 0; i < 3; i++) {
        a0[i] = t->v[i] - ray->org[i];
        e1[i] = t->e1[i];
        e2[i] = t->e2[i];
    }
    query->c->count[SPH_COUNT_FACET_TESTS]++;
    int64_t det = sph_fast_dot(t->n, ray->dir), sign = det >> 63;
    int64_t num = sph_fast_turned(sph_fast_dot(t->n, a0), sign);
    int64_t size = sph_fast_turned(det, sign);
    int shadow = sph_ray_ends(ray);
    if (num <= 0 || !det || (shadow && num >= size)) return;
    sph_fast_cross(ray->dir, a0, m);
    int64_t u2 = sph_fast_turned(sph_fast_dot(m, e1), sign);
    int64_t u1 = sph_fast_turned(sph_fast_dot(e2, m), ~sign);
    int64_t u0 = (int64_t)((uint64_t)size - (uint64_t)u1 - (uint64_t)u2);
    if ((u0 | u1 | u2) < 0) return;
    uint32_t skip = ray->skip.id;
    if (skip + t->before >= t->id && skip <= t->id + t->after) return;
    if (shadow && !sph_fast_ahead(query->p, ray, t->n, sign, num)) return;
    struct sph_facet_result r = {.det = (sph_u128)size, .num = num};
    uint64_t *divisions = &query->c->count[SPH_COUNT_DIVISIONS];
    uint64_t key = shadow ? 1 : sph_facet_key(ray, &r, divisions);
    struct sph_hit *best = &query->best, hit = {key, t->id, det > 0, 0};
    sph_hit_count(best, &hit);
    if (!best->key || key < best->key || (key == best->key && t->id < best->id)) *best = hit;
}

#endif
