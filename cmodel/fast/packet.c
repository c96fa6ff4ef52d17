/* packet.c - which machines packets are for, and what they leave to integers; see packet.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "fast/packets.h"

#include <stddef.h>

#include "fast/leaf.h"
#include "fast/setup.h"

/* The way down to a node: in grid units the balls around it, and how many nodes were met. */
struct way {
    const struct sph_fast *f;
    uint32_t met;
    int64_t ctr[SPH_STACK_DEPTH][3], rad[SPH_STACK_DEPTH];
};

/* Whether all balls above hold a sphere, without the margin of the filter. */
static int held(const struct way *w, const struct sph_fast_leaf *leaf, int level) {
    for (int i = 0; i < level; i++) {
        int64_t x = w->ctr[i][0] - leaf->ctr[0], y = w->ctr[i][1] - leaf->ctr[1],
                z = w->ctr[i][2] - leaf->ctr[2], room = w->rad[i] - leaf->rad;
        if (room < 0 || room * room < x * x + y * y + z * z) return 0;
    }
    return !leaf->record;
}

/* Whether a node and all below is met once and holds what is in it, the root on level 0. */
static int sound(struct way *w, uint32_t number, int level) {
    const struct sph_fast_node *n = &w->f->nodes[number];
    const struct sph_profile *p = sph_machine_profile(w->f->m);
    int64_t unit = (int64_t)1 << (p->w - p->fw);
    if (n->bad || level == SPH_STACK_DEPTH || ++w->met > w->f->n_nodes) return 0;
    for (uint32_t i = 0; i < n->tests; i++) {
        for (int k = 0; k < 3; k++)
            w->ctr[level][k] = sph_fast_ctr(n, k, (int)i) * unit;
        w->rad[level] = (n->zr[i][1] - SPH_FILTER_MARGIN) * unit;
        if (i < n->n_inner ? !sound(w, n->inner + i, level + 1)
                           : !held(w, &w->f->leaves[n->leaf + i], level + 1))
            return 0;
    }
    return 1;
}

int sph_packets_fit(const struct sph_fast *fast) {
    const struct sph_profile *p = sph_machine_profile(fast->m);
    struct way w = {.f = fast};
    return fast->packet && !fast->no_root && fast->n_nodes <= fast->visit_limit && !p->pr &&
           p->w + p->wd + 3 <= 53 && 2 * p->wd + 2 <= 53 && sound(&w, fast->root, 0);
}

struct sph_ray sph_bundle_ray(const struct sph_bundle *rays, int i) {
    struct sph_ray ray = {
        .kind = rays->kind, .skip = {SPH_ID_NONE, 0}, .inside = rays->inside, .first = 0};
    for (int k = 0; k < 3; k++) {
        ray.org[k] = rays->org[k][i];
        ray.dir[k] = rays->dir[k][i];
    }
    if (ray.kind == SPH_SHADOW) ray.skip = rays->skip[i];
    ray.a = sph_fast_square(ray.dir);
    return ray;
}

struct sph_hit sph_packet_exact(const struct sph_fast *fast, const struct sph_bundle *rays, int i,
                                int64_t best, uint32_t *leaf) {
    struct sph_counters none = {{0}};
    uint32_t errors = 0;
    struct sph_ray ray = sph_bundle_ray(rays, i);
    struct sph_ray_query query = sph_fast_ray_query(fast, &ray, &none, &errors);
    if (best >= 0) sph_fast_leaf_visit(&query, &fast->leaves[best], fast->m->mem);
    struct sph_hit before = query.best;
    sph_fast_leaf_visit(&query, &fast->leaves[*leaf], fast->m->mem);
    if (best >= 0 && before.key && before.key == query.best.key && before.id == query.best.id)
        *leaf = (uint32_t)best;
    return query.best;
}

struct sph_hit sph_packet_alone(const struct sph_fast *fast, const struct sph_bundle *rays, int i) {
    struct sph_counters none = {{0}};
    uint32_t visits = 0, errors = 0;
    struct sph_ray ray = sph_bundle_ray(rays, i);
    sph_fast_prepare(sph_machine_profile(fast->m), &ray);
    return fast->walk(fast, &ray, &none, &visits, &errors); /* it has a root: sph_packets_fit() */
}

void sph_packet_nearest(const struct sph_fast *fast, const struct sph_bundle *rays,
                        struct sph_hit hits[SPH_PACKET]) {
    fast->packet->nearest(fast, rays, hits);
}

uint64_t sph_packet_hidden(const struct sph_fast *fast, const struct sph_bundle *rays) {
    return fast->packet->hidden(fast, rays);
}
