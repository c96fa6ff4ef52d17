/* leaf.h - the exact test of a decoded leaf record
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FAST_LEAF_H
#define SPH_FAST_LEAF_H

#include "fast/decoded.h"
#include "fast/root.h"
#include "trace/leaf_unit.h"

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
