/* tree_links.c - see tree_links.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/tree_links.h"

#include <stdlib.h>
#include <string.h>

enum { PARALLEL = 8192 }; /* spheres from which on threads share the work */

int sph_links_new(const struct sph_ball *balls, const struct sph_aabb *boxes, uint32_t n,
                  double margin, struct sph_links *l) {
    size_t all = 2ull * n - 1, inner = n - 1ull;
    *l = (struct sph_links){.balls = balls, .boxes = boxes, .n = n, .margin = (float)margin};
    l->ball = malloc(all * sizeof *l->ball);
    l->parent = malloc(all * sizeof *l->parent);
    l->child = malloc(inner * sizeof *l->child);
    l->order = malloc(n * sizeof *l->order);
    l->first = malloc(inner * sizeof *l->first);
    l->count = malloc(inner * sizeof *l->count);
    l->stale = malloc(inner);
    if (!l->ball || !l->parent || !l->child || !l->order || !l->first || !l->count || !l->stale)
        return -1;
    for (uint32_t i = 0; boxes && i < n; i++)
        for (int j = 0; j < 3; j++) {
            l->ball[i].lo[j] = (float)boxes[i].lo[j];
            l->ball[i].hi[j] = (float)boxes[i].hi[j];
        }
    for (uint32_t i = 0; !boxes && i < n; i++) {
        for (int j = 0; j < 3; j++)
            l->ball[i].c[j] = (float)balls[i].c[j];
        l->ball[i].r = (float)balls[i].r + l->margin;
    }
    return 0;
}

void sph_links_free(struct sph_links *l) {
    free(l->ball);
    free(l->parent);
    free(l->child);
    free(l->order);
    free(l->first);
    free(l->count);
    free(l->stale);
    memset(l, 0, sizeof *l);
}

void sph_links_renew(struct sph_links *l) {
    memset(l->stale, 1, l->n - 1);
}

void sph_links_take(struct sph_links *l, const struct sph_split *split) {
    l->root = l->n;
    l->parent[l->root] = SPH_LINK_NONE;
    sph_links_renew(l);
    for (uint32_t i = 0; i < split->n_pairs; i++)
        for (int j = 0; j < 2; j++) {
            uint32_t child = split->pairs[i].child[j];
            uint32_t node = child & SPH_PAIR_LEAF ? child & ~SPH_PAIR_LEAF : l->n + child;
            l->child[i][j] = node;
            l->parent[node] = l->n + i;
        }
}

uint32_t sph_link_leftmost(const struct sph_links *l, uint32_t node) {
    while (node >= l->n)
        node = l->child[node - l->n][0];
    return node;
}

uint32_t sph_link_next(const struct sph_links *l, uint32_t node) {
    uint32_t above = l->parent[node];
    if (above == SPH_LINK_NONE || l->child[above - l->n][1] == node) return above;
    return sph_link_leftmost(l, l->child[above - l->n][1]);
}

static uint32_t spheres(const struct sph_links *l, uint32_t node) {
    return node < l->n ? 1 : l->count[node - l->n];
}

static void put_in_order(struct sph_links *l) {
    uint32_t at = 0;
    for (uint32_t node = sph_link_leftmost(l, l->root); node != SPH_LINK_NONE;
         node = sph_link_next(l, node)) {
        if (node < l->n) {
            l->order[at++] = node;
            continue;
        }
        const uint32_t *child = l->child[node - l->n];
        l->count[node - l->n] = spheres(l, child[0]) + spheres(l, child[1]);
        l->first[node - l->n] = at - l->count[node - l->n];
    }
}

struct sph_link_ball sph_link_around(const struct sph_links *l, const uint32_t *spheres,
                                     uint32_t n) {
    double ball[4];
    sph_enclose(l->balls, spheres, n, ball);
    return (struct sph_link_ball){.c = {(float)ball[0], (float)ball[1], (float)ball[2]},
                                  .r = (float)ball[3] + l->margin};
}

double sph_links_fit(struct sph_links *l, uint32_t most) {
    put_in_order(l);
    if (l->boxes) most = 0;
#pragma omp parallel for schedule(dynamic, 256) if (l->n > PARALLEL)
    for (uint32_t i = 0; i < l->n - 1; i++) {
        if (l->count[i] > most || !(l->stale[i] || l->count[i] > l->exact)) continue;
        l->ball[l->n + i] = sph_link_around(l, l->order + l->first[i], l->count[i]);
    }
    double sum = 0;
    l->exact = most;
    memset(l->stale, 0, l->n - 1);
    for (uint32_t node = sph_link_leftmost(l, l->root); node != SPH_LINK_NONE;
         node = sph_link_next(l, node)) {
        if (node < l->n) continue;
        const uint32_t *child = l->child[node - l->n];
        if (l->count[node - l->n] > most)
            l->ball[node] = sph_link_merge(l, &l->ball[child[0]], &l->ball[child[1]]);
        sum += (double)sph_link_area(l, &l->ball[node]);
    }
    return sum;
}

void sph_links_give(struct sph_links *l, struct sph_split *split) {
    uint32_t top = l->root - l->n; /* changes numbers with the first pair */
    sph_links_fit(l, l->n);
    memcpy(split->order, l->order, l->n * sizeof *split->order);
    split->n_pairs = l->n - 1;
    for (uint32_t node = sph_link_leftmost(l, l->root); node != SPH_LINK_NONE;
         node = sph_link_next(l, node)) {
        if (node < l->n) continue;
        uint32_t i = node - l->n, number = i == top ? 0 : i == 0 ? top : i;
        struct sph_pair *p = &split->pairs[number];
        p->first = l->first[i], p->count = l->count[i];
        for (int j = 0; j < 2; j++) {
            uint32_t child = l->child[i][j], below = child - l->n;
            p->child[j] = child < l->n ? SPH_PAIR_LEAF | child : below ? below : top;
        }
        sph_pair_fill(split->pairs, p, sph_link_area(l, &l->ball[node]));
    }
}

struct sph_link_ball sph_link_merge(const struct sph_links *l, const struct sph_link_ball *a,
                                    const struct sph_link_ball *b) {
    struct sph_link_ball out;
    if (l->boxes) {
        for (int i = 0; i < 3; i++) {
            out.lo[i] = a->lo[i] < b->lo[i] ? a->lo[i] : b->lo[i];
            out.hi[i] = a->hi[i] > b->hi[i] ? a->hi[i] : b->hi[i];
        }
        return out;
    }
    float apart = sph_link_apart(a, b);
    if (apart + b->r <= a->r) return *a;
    if (apart + a->r <= b->r) return *b;
    out.r = (apart + a->r + b->r) / 2;
    float part = (out.r - a->r) / apart;
    for (int i = 0; i < 3; i++)
        out.c[i] = a->c[i] + (b->c[i] - a->c[i]) * part;
    return out;
}
