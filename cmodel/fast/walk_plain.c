/* walk_plain.c - the walk in plain C, for processors of any kind; see walk.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "machine/layout.h"
#include "core/ray.h"

#include "fast/decoded.h"
#include "fast/sorted.h"

struct lanes {
    int32_t org[3];
    struct sph_across across;
    int axis, sign, any;
    int32_t depth_max; /* of limit_to() */
};

static struct lanes lanes_of(const struct sph_profile *p, const struct sph_ray *ray) {
    (void)p;
    struct lanes l = {.across = ray->across,
                      .axis = ray->axis,
                      .sign = ray->negative ? -1 : 1,
                      .any = sph_ray_any(ray)};
    for (int i = 0; i < 3; i++)
        l.org[i] = ray->forg[i];
    return l;
}

static int64_t cut(int64_t x) {
    x >>= 17 - SPH_FILTER_FRACTION;
    return x ^ (x >> 63);
}

static inline void limit_to(struct lanes *l, int32_t depth_max) {
    l->depth_max = depth_max;
}

/* sph_filter() of four children; the order of the inner ones. */
static unsigned children(const struct lanes *l, const struct sph_fast *f,
                         const struct sph_fast_node *n, keys *order) {
    (void)f;
    const struct sph_across *a = &l->across;
    int32_t near[4];
    unsigned met = 0;
    for (int i = 0; i < 4; i++) {
        int32_t oc[3];
        for (int k = 0; k < 3; k++)
            oc[k] = sph_fast_ctr(n, k, i) - l->org[k];
        int64_t p = cut((int64_t)oc[a->axis_a] * a->p_a - (int64_t)oc[a->axis_b] * a->p_b);
        int64_t q =
            cut((int64_t)oc[0] * a->q[0] + (int64_t)oc[1] * a->q[1] + (int64_t)oc[2] * a->q[2]);
        int64_t rad = (int64_t)n->zr[i][1] << SPH_FILTER_FRACTION;
        int32_t depth = l->sign * oc[l->axis];
        near[i] = depth - n->zr[i][1];
        met |= (unsigned)(p * p + q * q <= rad * rad && depth + n->zr[i][1] >= 0 &&
                          near[i] <= l->depth_max)
               << 2 * i;
    }
    *order = sorted(n, met, near, l->any);
    return met & n->leaves;
}

#include "fast/spheres.h"
#include "fast/walk.h"

struct sph_hit sph_fast_walk_plain(const struct sph_fast *f, const struct sph_ray *ray,
                                   struct sph_counters *c, uint32_t *visits, uint32_t *errors) {
    return walk(f, ray, c, visits, errors);
}
