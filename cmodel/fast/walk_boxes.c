/* walk_boxes.c - the walk of nodes of boxes: trace/bih.c and trace/bih.c are read beside it
 * SPDX-License-Identifier: Apache-2.0
 *
 * All planes of an axis are cut in the same way, so that a ray has two multipliers and shifts an
 * axis, and what it needs of each child comes without a branch. A ray that does not move along an
 * axis has multipliers of 0 and no bounds there; it misses what its origin is not in.
 */
#include "fast/setup.h"
#include "fast/sorted.h"
#include "math/fx.h"
#include "trace/bih.h"

/* An axis: distances from the origin, along the ray, become T-words. */
struct course {
    int64_t org, sign; /* -1: it runs down */
    int64_t in, out;   /* multipliers, of planes where it enters and leaves */
    int64_t none;      /* added to the bound of a plane where it leaves: 1, or what is no bound */
    int shift;
    int still; /* it does not move along this axis */
};

struct lanes {
    struct course axis[3];
    struct sph_bih_ray bih;
    int any;
    int32_t depth_max; /* of limit_to() */
};

static struct lanes lanes_of(const struct sph_profile *p, const struct sph_ray *ray) {
    struct lanes l = {.any = sph_ray_any(ray)};
    sph_fast_planes(p, ray, &l.bih);
    for (int i = 0; i < 3; i++) {
        const struct sph_bih_axis *x = &l.bih.axis[i];
        int bound = !x->zero && x->shift >= 0;
        l.axis[i] = (struct course){.org = ray->org[i],
                                    .sign = x->negative ? -1 : 1,
                                    .in = x->zero ? 0 : x->mant,
                                    .out = bound ? x->mant + 2ll : 0,
                                    .none = bound ? 1 : SPH_BIH_NO_BOUND,
                                    .shift = x->shift > 0 ? x->shift : 0,
                                    .still = x->zero};
    }
    return l;
}

static int32_t limit_of(const struct lanes *l, const struct sph_ray *ray) {
    (void)ray;
    return sph_box_depth(l->bih.limit);
}

static int32_t depth_of(const struct lanes *l, const struct sph_profile *p,
                        const struct sph_ray *ray, uint64_t key) {
    (void)p, (void)ray;
    return sph_box_depth(sph_bih_time(&l->bih, key));
}

static inline void limit_to(struct lanes *l, int32_t depth_max) {
    l->depth_max = depth_max;
}

/* sph_box_meets() of four children; the order of the inner ones. */
static unsigned children(const struct lanes *l, const struct sph_fast *f,
                         const struct sph_fast_node *n, keys *order) {
    const struct sph_fast_boxes *b = &f->boxes[n - f->nodes];
    int64_t lo[4] = {0}, hi[4], lost = l->bih.v_shift, up = (1ll << lost) - 1;
    int64_t missed[4] = {0};
    int32_t near[4];
    unsigned met = 0;
    for (int i = 0; i < 4; i++)
        hi[i] = SPH_BIH_NO_BOUND;
    for (int k = 0; k < 3; k++) {
        const struct course *x = &l->axis[k];
        const int32_t *enter = x->sign < 0 ? b->hi[k] : b->lo[k];
        const int32_t *leave = x->sign < 0 ? b->lo[k] : b->hi[k];
        for (int i = 0; i < 4; i++) {
            int64_t v = (enter[i] - x->org) * x->sign, w = (leave[i] - x->org) * x->sign;
            missed[i] |= (int64_t)(w < 0) | (x->still & (v > 0));
            v = v > 0 ? v : 0;
            w = w > 0 ? w : 0;
            int64_t from = (v >> lost) * x->in >> x->shift;
            int64_t to = ((w + up) >> lost) * x->out >> x->shift;
            to += x->none;
            lo[i] = from > lo[i] ? from : lo[i];
            hi[i] = to < hi[i] ? to : hi[i];
        }
    }
    for (int i = 0; i < 4; i++) {
        if (lo[i] > (int64_t)SPH_BIH_NO_BOUND) lo[i] = SPH_BIH_NO_BOUND;
        near[i] = sph_box_depth((uint32_t)lo[i]);
        met |= (unsigned)(!missed[i] && lo[i] <= hi[i] && near[i] <= l->depth_max) << 2 * i;
    }
    *order = sorted(n, met, near, l->any);
    return met & n->leaves;
}

#include "fast/walk.h"

struct sph_hit sph_fast_walk_boxes(const struct sph_fast *f, const struct sph_ray *ray,
                                   struct sph_counters *c, uint32_t *visits, uint32_t *errors) {
    return walk(f, ray, c, visits, errors);
}
