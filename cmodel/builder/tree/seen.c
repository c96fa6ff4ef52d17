/* seen.c - see split.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Every ray goes through the binary tree as far as its own hit, and each pair counts those that
 * meet it. To the counts a sixteenth of what the areas would say is added, so that pairs which no
 * ray met have an order.
 */
#include "builder/tree/split.h"

#include <stdlib.h>

#include "builder/grid/bound.h"
#include "builder/tree/links.h"
#include "common/parallel.h"

struct bound {
    struct sph_box box;    /* grid units; or */
    struct sph_child ball; /* filter units */
    float area;
    uint32_t rays; /* that meet it, by their weights */
};

struct work {
    const struct sph_profile *profile;
    const struct sph_split *split;
    struct bound *bounds; /* of pairs */
    const struct sph_visibility_sample *rays;
    const struct sph_ball *balls;
    int boxes;
};

enum { BALLS = 2048, RAYS = 1024 }; /* that are worth a thread */

static void add(struct sph_box *to, const int32_t lo[3], const int32_t hi[3]) {
    for (int i = 0; i < 3; i++) {
        if (lo[i] < to->lo[i]) to->lo[i] = lo[i];
        if (hi[i] > to->hi[i]) to->hi[i] = hi[i];
    }
}

/* Boxes of pairs. */
static void box(const struct work *w, const struct sph_aabb *boxes) {
    for (uint32_t i = w->split->n_pairs; i-- > 0;) { /* children stand behind their parent */
        struct sph_box *b = &w->bounds[i].box;
        float lo[3], hi[3];
        for (int j = 0; j < 3; j++)
            b->lo[j] = INT32_MAX, b->hi[j] = INT32_MIN;
        for (int j = 0; j < 2; j++) {
            uint32_t child = w->split->pairs[i].child[j], leaf = child & ~SPH_PAIR_LEAF;
            if (child & SPH_PAIR_LEAF)
                add(b, boxes[leaf].lo, boxes[leaf].hi);
            else
                add(b, w->bounds[child].box.lo, w->bounds[child].box.hi);
        }
        for (int j = 0; j < 3; j++)
            lo[j] = (float)b->lo[j], hi[j] = (float)b->hi[j];
        w->bounds[i].area = sph_link_surface(lo, hi);
    }
}

/* Balls of pairs. */
static void ball(void *user, uint32_t from, uint32_t end) {
    const struct work *w = user;
    for (uint32_t i = from; i < end; i++) {
        const struct sph_pair *p = &w->split->pairs[i];
        struct sph_ball b =
            sph_filter_enclose(w->balls, w->split->order + p->first, p->count, w->profile);
        int32_t rad = b.r + SPH_FILTER_MARGIN;
        w->bounds[i].ball = (struct sph_child){{b.c[0], b.c[1], b.c[2]}, rad};
        w->bounds[i].area = (float)rad * (float)rad;
    }
}

static void walk(const struct work *w, const struct sph_visibility_sample *ray, uint32_t pair) {
    struct bound *b = &w->bounds[pair];
    const uint32_t *child = w->split->pairs[pair].child;
    if (w->boxes ? !sph_visibility_sample_meets_box(ray, &b->box)
                 : !sph_visibility_sample_meets_ball(ray, &b->ball))
        return;
    __atomic_fetch_add(&b->rays, ray->weight, __ATOMIC_RELAXED);
    for (int i = 0; i < 2; i++)
        if (!(child[i] & SPH_PAIR_LEAF)) walk(w, ray, child[i]);
}

static void rays(void *user, uint32_t from, uint32_t end) {
    const struct work *w = user;
    for (uint32_t i = from; i < end; i++)
        walk(w, &w->rays[i], 0);
}

int sph_split_seen(const struct sph_ball *balls, const struct sph_aabb *boxes,
                   const struct sph_profile *profile, const struct sph_visibility_samples *samples,
                   struct sph_split *split, struct sph_error *err) {
    struct work w = {profile, split, NULL, samples->rays, balls, boxes != NULL};
    w.bounds = calloc(split->n_pairs, sizeof *w.bounds);
    if (!w.bounds) return sph_fail(err, "out of memory for %u pairs", split->n_pairs);
    if (boxes)
        box(&w, boxes);
    else
        sph_parallel_for(split->n_pairs, BALLS, ball, &w);
    sph_parallel_for(samples->n, RAYS, rays, &w);
    float all = (float)(w.bounds[0].rays ? w.bounds[0].rays : 1), scale = w.bounds[0].area / all;
    for (uint32_t i = split->n_pairs; i-- > 0;)
        sph_pair_fill(split->pairs, &split->pairs[i],
                      scale * (float)w.bounds[i].rays + SPH_UNSEEN * w.bounds[i].area);
    free(w.bounds);
    return 0;
}
