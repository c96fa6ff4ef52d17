/* rotate.c - see split.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Kensler: Tree Rotations for Improving Bounding Volume Hierarchies (2008), where a node costs what
 * rays of a sample meet it instead of its area. A child of a node and a grandchild below the other
 * child change places, or two grandchildren do, if the boxes in between then cost less. The tree is
 * gone through from the root down, each node with the rays that meet it, so that nobody looks where
 * no ray comes; and again, until that saves little.
 */
#include "builder/tree/split.h"

#include <stdlib.h>

#include "builder/tree/links.h"
#include "common/parallel.h"

/* PASSES over the tree, at most; TURNS of a node in each, at most. LITTLE: of what is saved for
 * each ray. PARALLEL: rays from which on threads share the work. */
enum { PASSES = 8, TURNS = 8, PARALLEL = 512 };
#define LITTLE (1. / 64)

struct work {
    struct sph_links *l;
    const struct sph_visibility_sample *rays;
    struct sph_box *box; /* of each node */
    double per_area;     /* cost, in weights of rays */
    int failed;          /* memory is out */
};

/* The rays that meet a node. */
struct list {
    uint32_t *ray, n;
};

/* Two nodes that change places, and what that saves. */
struct swap {
    uint32_t a, b;
    double saves;
};

static const uint32_t *children(const struct work *w, uint32_t node) {
    return w->l->child[node - w->l->n];
}

static int is_leaf(const struct work *w, uint32_t node) {
    return node < w->l->n;
}

static struct sph_box around(const struct work *w, uint32_t a, uint32_t b) {
    struct sph_box out = w->box[a];
    const struct sph_box *by = &w->box[b];
    for (int i = 0; i < 3; i++) {
        if (by->lo[i] < out.lo[i]) out.lo[i] = by->lo[i];
        if (by->hi[i] > out.hi[i]) out.hi[i] = by->hi[i];
    }
    return out;
}

static double surface(const struct sph_box *box) {
    float lo[3], hi[3];
    for (int i = 0; i < 3; i++)
        lo[i] = (float)box->lo[i], hi[i] = (float)box->hi[i];
    return (double)sph_link_surface(lo, hi);
}

/* What a box costs whose parent the rays meet. */
static double cost(const struct work *w, const struct sph_box *box, struct list rays) {
    uint64_t met = 0;
    for (uint32_t i = 0; i < rays.n; i++) {
        const struct sph_visibility_sample *s = &w->rays[rays.ray[i]];
        if (sph_visibility_sample_meets_box(s, box)) met += s->weight;
    }
    return (double)met + w->per_area * surface(box);
}

static void choose(struct swap *best, uint32_t a, uint32_t b, double saves) {
    if (saves > best->saves) *best = (struct swap){a, b, saves};
}

/* The rotation below a node that saves most. */
static struct swap look(const struct work *w, uint32_t node, struct list rays) {
    const uint32_t *child = children(w, node);
    struct swap best = {0, 0, 0};
    double now[2];
    for (int i = 0; i < 2; i++)
        now[i] = is_leaf(w, child[i]) ? 0 : cost(w, &w->box[child[i]], rays);
    for (int i = 0; i < 2; i++) { /* a grandchild with the other child */
        if (is_leaf(w, child[i])) continue;
        const uint32_t *below = children(w, child[i]);
        for (int j = 0; j < 2; j++) {
            struct sph_box box = around(w, child[!i], below[!j]);
            choose(&best, child[!i], below[j], now[i] - cost(w, &box, rays));
        }
    }
    if (is_leaf(w, child[0]) || is_leaf(w, child[1])) return best;
    const uint32_t *left = children(w, child[0]), *right = children(w, child[1]);
    for (int j = 0; j < 2; j++) { /* two grandchildren */
        struct sph_box a = around(w, right[j], left[1]), b = around(w, left[0], right[!j]);
        choose(&best, left[0], right[j], now[0] + now[1] - cost(w, &a, rays) - cost(w, &b, rays));
    }
    return best;
}

static void replace_child(struct sph_links *l, uint32_t parent, uint32_t old, uint32_t new) {
    l->child[parent - l->n][l->child[parent - l->n][1] == old] = new;
    l->parent[new] = parent;
}

/* Lets two nodes below a node change places. Its own box stays. */
static void swap(const struct work *w, uint32_t node, uint32_t a, uint32_t b) {
    const uint32_t over[2] = {w->l->parent[a], w->l->parent[b]};
    replace_child(w->l, over[0], a, b);
    replace_child(w->l, over[1], b, a);
    for (int i = 0; i < 2; i++)
        if (over[i] != node)
            w->box[over[i]] = around(w, children(w, over[i])[0], children(w, over[i])[1]);
}

/* A child of a node, with the rays that meet the node; what is saved there. */
struct half {
    struct work *w;
    uint32_t node;
    struct list rays;
    double saved;
};

static void turn_half(void *half);

/* A node and all below it; returns what that saves. */
static double turn(struct work *w, uint32_t node, struct list rays) {
    double saved = 0;
    if (is_leaf(w, node) || !rays.n) return 0;
    for (int i = 0; i < TURNS; i++) {
        struct swap s = look(w, node, rays);
        if (!(s.saves > 0)) break;
        swap(w, node, s.a, s.b);
        saved += s.saves;
    }
    struct half left = {w, children(w, node)[0], rays, 0};
    struct half right = {w, children(w, node)[1], rays, 0};
    int both = !is_leaf(w, left.node) && !is_leaf(w, right.node);
    sph_parallel_two(both && rays.n > PARALLEL, turn_half, &left, &right);
    return left.saved + right.saved + saved;
}

static void turn_half(void *user) {
    struct half *h = user;
    if (is_leaf(h->w, h->node)) return;
    struct list below = {malloc(h->rays.n * sizeof *below.ray), 0};
    if (!below.ray) __atomic_store_n(&h->w->failed, 1, __ATOMIC_RELAXED);
    for (uint32_t j = 0; below.ray && j < h->rays.n; j++)
        if (sph_visibility_sample_meets_box(&h->w->rays[h->rays.ray[j]], &h->w->box[h->node]))
            below.ray[below.n++] = h->rays.ray[j];
    h->saved = turn(h->w, h->node, below);
    free(below.ray);
}

static void make_boxes(const struct work *w) {
    const struct sph_links *l = w->l;
    for (uint32_t i = 0; i < l->n; i++)
        for (int j = 0; j < 3; j++)
            w->box[i].lo[j] = l->boxes[i].lo[j], w->box[i].hi[j] = l->boxes[i].hi[j];
    for (uint32_t node = sph_link_leftmost(l, l->root); node != SPH_LINK_NONE;
         node = sph_link_next(l, node))
        if (!is_leaf(w, node)) w->box[node] = around(w, children(w, node)[0], children(w, node)[1]);
}

/* All passes. -1 if memory is out. */
static int rotate(struct sph_links *l, const struct sph_visibility_samples *samples, float unseen) {
    struct work w = {.l = l, .rays = samples->rays};
    struct list all = {malloc((samples->n + 1ull) * sizeof *all.ray), 0};
    double met = 0;
    w.box = malloc((2ull * l->n - 1) * sizeof *w.box);
    w.failed = !all.ray || !w.box;
    if (!w.failed) {
        make_boxes(&w);
        for (uint32_t i = 0; i < samples->n; i++)
            if (sph_visibility_sample_meets_box(&samples->rays[i], &w.box[l->root]))
                met += samples->rays[i].weight, all.ray[all.n++] = i;
        w.per_area = unseen * met / surface(&w.box[l->root]);
    }
    for (int i = 0; i < PASSES && !w.failed; i++) {
        double saved = turn(&w, l->root, all);
        if (saved <= LITTLE * met) break;
    }
    free(all.ray);
    free(w.box);
    return w.failed ? -1 : 0;
}

int sph_split_rotate(const struct sph_ball *balls, const struct sph_aabb *boxes,
                     const struct sph_visibility_samples *samples, float unseen, int most,
                     struct sph_split *split, struct sph_error *err) {
    uint32_t n = split->n_pairs + 1;
    struct sph_links links;
    struct sph_split spare = {.pairs = malloc((n - 1ull) * sizeof *spare.pairs),
                              .order = malloc(n * sizeof *spare.order)};
    int failed = sph_links_new(balls, boxes, n, 0, &links) || !spare.pairs || !spare.order;
    if (!failed) {
        sph_links_take(&links, split);
        failed = rotate(&links, samples, unseen);
    }
    if (!failed) sph_links_give(&links, &spare);
    if (!failed && spare.pairs[0].levels[1] <= most) {
        struct sph_split old = *split;
        *split = spare, spare = old;
    }
    sph_links_free(&links);
    sph_split_free(&spare);
    return failed ? sph_fail(err, "out of memory for a tree of %u boxes", n) : 0;
}
