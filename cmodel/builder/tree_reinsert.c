/* tree_reinsert.c - see tree_reinsert.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Meister, Bittner: Parallel Reinsertion for Bounding Volume Hierarchy Optimization (2018), with
 * balls or boxes. In a round nodes look for the place where they would save most; the tree stands
 * still, so that threads may share the work. Then the moves are made one after another, those that
 * save most first, unless one before touched the same nodes. In the next round those look again
 * that wanted to move or were touched.
 */
#include "builder/tree_reinsert.h"

#include <stdlib.h>
#include <string.h>

/* EXACT: more spheres than that have a ball around those of the children, while nodes move.
 * ENOUGH: a round that saves less than this part is the last one. */
enum { ROUNDS = 10, LOOKS = 256, EXACT = 4096, ENOUGH = 1024, PARALLEL = 8192 };

struct move {
    float gain;
    uint32_t node, to; /* becomes the sibling of `to` */
};

static float square(float x) {
    return x * x;
}

/* The area of what is around two. */
static inline float merged(const struct sph_links *l, const struct sph_link_ball *a,
                           const struct sph_link_ball *b) {
    if (l->boxes) {
        struct sph_link_ball both = sph_link_merge(l, a, b);
        return sph_link_surface(both.lo, both.hi);
    }
    float apart = sph_link_apart(a, b);
    if (apart + b->r <= a->r) return square(a->r);
    if (apart + a->r <= b->r) return square(b->r);
    return square((apart + a->r + b->r) / 2);
}

/* How far a node is from another: between centres, of boxes four times the square of that. */
static inline float distance(const struct sph_links *l, uint32_t node,
                             const struct sph_link_ball *to) {
    const struct sph_link_ball *at = &l->ball[node];
    float sum = 0;
    if (!l->boxes) return sph_link_apart(at, to);
    for (int i = 0; i < 3; i++)
        sum += square(at->lo[i] + at->hi[i] - to->lo[i] - to->hi[i]);
    return sum;
}

/* Looks for the best place of a node in the subtree `top`, which it is not in. saved: what taking
 * it out saves; *looks: places that may still be looked at. */
static void look_below(const struct sph_links *l, uint32_t top, float saved, int *looks,
                       struct move *best) {
    enum { DEEP = 64 };
    struct {
        uint32_t node;
        float left; /* saved, less what the nodes above it grow */
    } stack[DEEP];
    const struct sph_link_ball *ball = &l->ball[best->node];
    float least = sph_link_area(l, ball);
    int n = 0;
    stack[n].node = top, stack[n++].left = saved;
    while (n && *looks > 0) {
        uint32_t at = stack[--n].node;
        float left = stack[n].left;
        if (left - least <= best->gain) continue;
        --*looks;
        float area = merged(l, &l->ball[at], ball), grown = area - sph_link_area(l, &l->ball[at]);
        if (left - area > best->gain) best->gain = left - area, best->to = at;
        if (grown > 0) left -= grown;
        if (at < l->n || left - least <= best->gain || n + 2 > DEEP) continue;
        const uint32_t *child = l->child[at - l->n];
        int near = distance(l, child[1], ball) < distance(l, child[0], ball); /* goes first */
        stack[n].node = child[!near], stack[n++].left = left;
        stack[n].node = child[near], stack[n++].left = left;
    }
}

/* The best move of a node: up from ancestor to ancestor, each time into its other side. */
static struct move look(const struct sph_links *l, uint32_t node) {
    struct move best = {0, node, SPH_LINK_NONE};
    uint32_t parent = l->parent[node];
    if (parent == SPH_LINK_NONE) return best;
    int looks = LOOKS;
    uint32_t sibling = sph_link_other(l, parent, node), below = parent;
    float saved = sph_link_area(l, &l->ball[parent]);
    struct sph_link_ball rest = l->ball[sibling]; /* of `below` without the node */
    if (sibling >= l->n)
        for (int i = 0; i < 2; i++) /* the place beside the sibling is where it is */
            look_below(l, l->child[sibling - l->n][i],
                       saved + sph_link_area(l, &rest) - merged(l, &rest, &l->ball[node]), &looks,
                       &best);
    for (uint32_t pivot = l->parent[parent]; pivot != SPH_LINK_NONE && looks > 0;
         below = pivot, pivot = l->parent[pivot]) {
        uint32_t other = sph_link_other(l, pivot, below);
        look_below(l, other, saved, &looks, &best);
        rest = sph_link_merge(l, &rest, &l->ball[other]);
        float area = sph_link_area(l, &l->ball[pivot]), less = sph_link_area(l, &rest);
        if (less > area) rest = l->ball[pivot], less = area;
        if (saved - less > best.gain) best.gain = saved - less, best.to = pivot;
        saved += area - less;
    }
    return best;
}

/* The most gain first; of equal ones the lower node. */
static int compare(const void *a, const void *b) {
    const struct move *x = a, *y = b;
    if (x->gain != y->gain) return x->gain > y->gain ? -1 : 1;
    return (x->node > y->node) - (x->node < y->node);
}

static int is_below(const struct sph_links *l, uint32_t node, uint32_t above) {
    while (node != SPH_LINK_NONE && node != above)
        node = l->parent[node];
    return node == above;
}

static void replace(struct sph_links *l, uint32_t parent, uint32_t old, uint32_t new) {
    l->parent[new] = parent;
    if (parent == SPH_LINK_NONE)
        l->root = new;
    else
        l->child[parent - l->n][l->child[parent - l->n][1] == old] = new;
}

/* What is below an inner node changes, and below all above it. */
static void outdate(struct sph_links *l, uint32_t node) {
    for (; node != SPH_LINK_NONE; node = l->parent[node])
        l->stale[node - l->n] = 1;
}

/* Makes a move unless a node that it touches is marked; marks them. */
static int apply(struct sph_links *l, const struct move *m, uint8_t *marked) {
    uint32_t node = m->node, to = m->to, parent = l->parent[node];
    if (marked[node]) return 0; /* it may be the root by now */
    uint32_t sibling = sph_link_other(l, parent, node);
    uint32_t touched[] = {node, to, parent, sibling, l->parent[parent], l->parent[to]};
    int n = sizeof touched / sizeof *touched;
    for (int i = 0; i < n; i++)
        if (touched[i] != SPH_LINK_NONE && marked[touched[i]]) return 0;
    if (is_below(l, to, node)) return 0; /* since another move */
    for (int i = 0; i < n; i++)
        if (touched[i] != SPH_LINK_NONE) marked[touched[i]] = 1;
    outdate(l, parent);
    replace(l, l->parent[parent], parent, sibling);
    replace(l, l->parent[to], to, parent);
    l->child[parent - l->n][0] = to, l->child[parent - l->n][1] = node;
    l->parent[to] = l->parent[node] = parent;
    outdate(l, parent);
    return 1;
}

/* One round; the number of moves. */
static uint32_t go_round(struct sph_links *l, struct move *moves, uint8_t *marked) {
    uint32_t all = 2 * l->n - 1, n = 0, done = 0;
#pragma omp parallel for schedule(dynamic, 256) if (l->n > PARALLEL)
    for (uint32_t i = 0; i < all; i++)
        moves[i] = marked[i] ? look(l, i) : (struct move){0};
    memset(marked, 0, all);
    for (uint32_t i = 0; i < all; i++)
        if (moves[i].gain > 0) moves[n++] = moves[i];
    qsort(moves, n, sizeof *moves, compare);
    for (uint32_t i = 0; i < n; i++)
        done += (uint32_t)apply(l, &moves[i], marked);
    for (uint32_t i = 0; i < n; i++)
        marked[moves[i].node] = 1;
    return done;
}

int sph_reinsert(struct sph_links *l) {
    uint32_t all = 2 * l->n - 1;
    struct move *moves = malloc(all * sizeof *moves);
    uint8_t *marked = malloc(all);
    int good = moves && marked;
    if (good) {
        double sum = sph_links_fit(l, EXACT), before = 0;
        memset(marked, 1, all);
        for (int round = 0; round < ROUNDS && go_round(l, moves, marked); round++) {
            before = sum, sum = sph_links_fit(l, EXACT);
            if (before - sum < sum / ENOUGH) break;
        }
    }
    free(moves);
    free(marked);
    return good ? 0 : -1;
}
