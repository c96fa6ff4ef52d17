/* links.c - see links.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/tree/links.h"

#include <stdlib.h>
#include <string.h>

#include "common/parallel.h"

enum { PARALLEL = 8192 }; /* spheres from which on threads share the work */

int sph_links_new(const struct sph_ball *balls, const struct sph_aabb *boxes, uint32_t n,
                  double margin, struct sph_links *l) {
    size_t all = 2ull * n - 1, inner = n - 1ull;
    *l = (struct sph_links){.balls = balls, .boxes = boxes, .n = n, .margin = (float)margin};
    l->ball = malloc(all * sizeof *l->ball);
    l->parent = malloc(all * sizeof *l->parent);
    l->child = malloc(inner * sizeof *l->child);
    l->order = malloc(n * sizeof *l->order);
    l->sorted = malloc(n * sizeof *l->sorted);
    l->count = calloc(inner, sizeof *l->count);
    l->stale = malloc(inner);
    if (!l->ball || !l->parent || !l->child || !l->order || !l->sorted || !l->count || !l->stale)
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
    free(l->sorted);
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
    for (uint32_t i = 0; i < split->n_pairs; i++) {
        l->count[i] = split->pairs[i].count;
        for (int j = 0; j < 2; j++) {
            uint32_t child = split->pairs[i].child[j];
            uint32_t node = child & SPH_PAIR_LEAF ? child & ~SPH_PAIR_LEAF : l->n + child;
            l->child[i][j] = node;
            l->parent[node] = l->n + i;
        }
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

/* Where a node stands: the place of its first sphere, its own, and the side that it is below. */
struct stand {
    uint32_t first, place, above;
};

/* A node and all below it, what is done with them, and what comes out. */
struct part {
    struct sph_links *l;
    uint32_t node;
    struct stand at;
    uint32_t most;           /* of fit() */
    struct sph_split *split; /* of give() */
    uint32_t count;
    double area;
};

static void recount_part(void *part);

/* Counts the spheres below nodes that are stale. What was counted before says where threads share
 * the work. */
static uint32_t recount(struct sph_links *l, uint32_t node) {
    if (node < l->n) return 1;
    uint32_t i = node - l->n;
    if (!l->stale[i]) return l->count[i];
    struct part left = {.l = l, .node = l->child[i][0]}, right = {.l = l, .node = l->child[i][1]};
    sph_parallel_two(l->count[i] > PARALLEL, recount_part, &left, &right);
    return l->count[i] = left.count + right.count;
}

static void recount_part(void *user) {
    struct part *p = user;
    p->count = recount(p->l, p->node);
}

static struct sph_link_ball enclose(const struct sph_links *l, const struct sph_ball *balls,
                                    const uint32_t *index, uint32_t n) {
    double ball[4];
    sph_enclose(balls, index, n, ball);
    return (struct sph_link_ball){.c = {(float)ball[0], (float)ball[1], (float)ball[2]},
                                  .r = (float)ball[3] + l->margin};
}

struct sph_link_ball sph_link_around(const struct sph_links *l, const uint32_t *spheres,
                                     uint32_t n) {
    return enclose(l, l->balls, spheres, n);
}

static void make_ball(struct sph_links *l, uint32_t i, uint32_t first, uint32_t most) {
    const uint32_t *child = l->child[i];
    struct sph_link_ball *ball = &l->ball[l->n + i];
    if (l->count[i] > most)
        *ball = sph_link_merge(l, &l->ball[child[0]], &l->ball[child[1]]);
    else if (l->stale[i] || l->count[i] > l->exact)
        *ball = enclose(l, l->sorted + first, NULL, l->count[i]);
    l->stale[i] = 0;
}

static void put_pair(struct sph_links *l, uint32_t i, struct stand at, uint32_t left) {
    const uint32_t *child = l->child[i], place[2] = {at.place + 1, at.place + left};
    struct sph_link_pair *p = &l->pairs[at.place];
    for (int j = 0; j < 2; j++) {
        p->ball[j] = l->ball[child[j]];
        p->child[j] = child[j] < l->n ? SPH_PAIR_LEAF | child[j] : place[j];
    }
    p->above = at.above;
    p->node = l->n + i;
}

static void fit_part(void *part);

/* The balls of a node and all below it, children first; the sum of areas. */
static double fit(struct sph_links *l, uint32_t node, struct stand at, uint32_t most) {
    if (node < l->n) {
        l->order[at.first] = node;
        l->sorted[at.first] = l->balls[node];
        return 0;
    }
    uint32_t i = node - l->n, left = spheres(l, l->child[i][0]);
    struct part a = {l, l->child[i][0], {at.first, at.place + 1, 2 * at.place}, .most = most};
    struct part b = {
        l, l->child[i][1], {at.first + left, at.place + left, 2 * at.place + 1}, .most = most};
    sph_parallel_two(l->count[i] > PARALLEL, fit_part, &a, &b);
    make_ball(l, i, at.first, most);
    if (l->pairs) put_pair(l, i, at, left);
    return a.area + b.area + (double)sph_link_area(l, &l->ball[node]);
}

static void fit_part(void *user) {
    struct part *p = user;
    p->area = fit(p->l, p->node, p->at, p->most);
}

double sph_links_fit(struct sph_links *l, uint32_t most) {
    const struct stand root = {0, 0, SPH_LINK_NONE};
    if (l->boxes) most = 0;
    recount(l, l->root);
    double sum = fit(l, l->root, root, most);
    l->exact = most;
    return sum;
}

/* A pair and all below it; costs are known when those of the children are. */
static void give(void *user) {
    const struct part *from = user;
    const struct sph_links *l = from->l;
    struct sph_split *split = from->split;
    uint32_t node = from->node;
    struct stand at = from->at;
    if (node < l->n) return;
    uint32_t i = node - l->n, left = spheres(l, l->child[i][0]);
    const uint32_t *child = l->child[i];
    struct part a = {from->l, child[0], {at.first, at.place + 1, 0}, .split = split};
    struct part b = {from->l, child[1], {at.first + left, at.place + left, 0}, .split = split};
    struct sph_pair *p = &split->pairs[at.place];
    p->first = at.first, p->count = l->count[i];
    p->child[0] = child[0] < l->n ? SPH_PAIR_LEAF | child[0] : a.at.place;
    p->child[1] = child[1] < l->n ? SPH_PAIR_LEAF | child[1] : b.at.place;
    sph_parallel_two(p->count > PARALLEL, give, &a, &b);
    sph_pair_fill(split->pairs, p, sph_link_area(l, &l->ball[node]));
}

void sph_links_give(struct sph_links *l, struct sph_split *split) {
    struct part root = {l, l->root, {0, 0, SPH_LINK_NONE}, .split = split};
    sph_links_fit(l, l->n);
    memcpy(split->order, l->order, l->n * sizeof *split->order);
    split->n_pairs = l->n - 1;
    give(&root);
}

struct sph_link_ball sph_link_merge(const struct sph_links *l, const struct sph_link_ball *a,
                                    const struct sph_link_ball *b) {
    struct sph_link_ball out;
    if (l->boxes) return sph_link_box(a, b);
    float apart = sph_link_apart(a, b);
    if (apart + b->r <= a->r) return *a;
    if (apart + a->r <= b->r) return *b;
    out.r = (apart + a->r + b->r) / 2;
    float part = (out.r - a->r) / apart;
    for (int i = 0; i < 3; i++)
        out.c[i] = a->c[i] + (b->c[i] - a->c[i]) * part;
    return out;
}
