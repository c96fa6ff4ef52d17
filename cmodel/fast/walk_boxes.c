/* walk_boxes.c - the walk of nodes of boxes, child by child: trace/bih.c is read beside it
 * SPDX-License-Identifier: Apache-2.0
 */
#include "fast/setup.h"
#include "fast/sorted.h"
#include "math/fx.h"
#include "trace/bih.h"

struct lanes {
    struct sph_bih_ray bih;
    const struct sph_profile *p;
    const struct sph_ray *ray;
    int any;
    int32_t depth_max; /* of limit_to() */
};

static struct lanes lanes_of(const struct sph_profile *p, const struct sph_ray *ray) {
    struct lanes l = {.p = p, .ray = ray, .any = sph_ray_any(ray)};
    sph_bih_setup(p, ray, &l.bih);
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
    struct sph_box_axis axes[3];
    int32_t near[4];
    unsigned met = 0;
    sph_box_axes(l->p, &l->bih, l->ray, &b->frame, axes);
    for (int i = 0; i < 4; i++) {
        struct sph_box_planes planes;
        for (int k = 0; k < 3; k++) {
            planes.lo[k] = (uint8_t)b->lo[k][i];
            planes.hi[k] = (uint8_t)b->hi[k][i];
        }
        met |= (unsigned)sph_box_meets(axes, l->ray, &planes, l->depth_max, &near[i]) << 2 * i;
    }
    *order = sorted(n, met, near, l->any);
    return met & n->leaves;
}

#include "fast/walk.h"

struct sph_hit sph_fast_walk_boxes(const struct sph_fast *f, const struct sph_ray *ray,
                                   struct sph_counters *c, uint32_t *visits, uint32_t *errors) {
    return walk(f, ray, c, visits, errors);
}
