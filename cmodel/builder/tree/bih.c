/* bih.c - see bih.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/tree/bih.h"

#include <stdlib.h>

enum { STEP = 1024 }; /* primitives between two tidings */

struct maker {
    const struct sph_aabb *boxes;
    struct sph_bih_options options;
    struct sph_bih *bih;
    uint32_t room;            /* nodes there is memory for */
    uint32_t n, placed, told; /* primitives: all, in leaves, of these when it was told last */
    struct sph_error *err;
    int failed;
};

/* What is cut: primitives order[first .. first+count-1] of node `node` on level `depth`. */
struct part {
    uint32_t node, first, count, depth;
    struct sph_aabb grid; /* what is halved */
    struct sph_aabb box;  /* where the primitives may be */
};

/* One side of a cut, or both. */
struct side {
    uint32_t count;
    int32_t lo, hi; /* reach of the primitives along the axis */
};

static const struct side NONE = {0, INT32_MAX, INT32_MIN};

static void side_add(struct side *s, int32_t lo, int32_t hi) {
    s->count++;
    if (lo < s->lo) s->lo = lo;
    if (hi > s->hi) s->hi = hi;
}

static int64_t extent(const struct sph_aabb *b, int axis) {
    return (int64_t)b->hi[axis] - b->lo[axis];
}

/* The longest axis, ties to the lower one. */
static int widest(const struct sph_aabb *b) {
    int64_t x = extent(b, 0), y = extent(b, 1), z = extent(b, 2);
    return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

/* Two nodes side by side; the index of the first, 0 if memory is out. */
static uint32_t pair(struct maker *k) {
    struct sph_bih *b = k->bih;
    if (b->n_nodes + 2 > k->room) {
        uint32_t room = k->room * 2;
        struct sph_bih_node *more = realloc(b->nodes, room * sizeof *more);
        if (!more) {
            k->failed = sph_fail(k->err, "out of memory for %u nodes", room);
            return 0;
        }
        b->nodes = more;
        k->room = room;
    }
    uint32_t at = b->n_nodes;
    b->nodes[at] = b->nodes[at + 1] = (struct sph_bih_node){0};
    b->n_nodes += 2;
    return at;
}

static void make_leaf(struct maker *k, uint32_t node, uint32_t first, uint32_t count,
                      uint32_t depth) {
    k->bih->nodes[node] =
        (struct sph_bih_node){.axis = SPH_BIH_LEAF, .first = first, .count = count};
    sph_bih_count_leaf(&k->bih->stats, count, depth);
    k->placed += count;
    if (k->placed - k->told < STEP) return;
    k->told = k->placed;
    if (sph_progress_at(k->options.progress, (double)k->placed / k->n) && !k->failed)
        k->failed = sph_fail(k->err, "cancelled");
}

/* Sorts the part as a step of quicksort does: what has its centre below split2 / 2 to the front,
 * each of the others exchanged with the last that was not looked at. */
static void partition(const struct maker *k, const struct part *p, int axis, int64_t split2,
                      struct side *left, struct side *right) {
    uint32_t *order = k->bih->order, i = p->first, end = p->first + p->count;
    *left = *right = NONE;
    while (i < end) {
        const struct sph_aabb *b = &k->boxes[order[i]];
        if ((int64_t)b->lo[axis] + b->hi[axis] < split2) {
            side_add(left, b->lo[axis], b->hi[axis]);
            i++;
        } else {
            side_add(right, b->lo[axis], b->hi[axis]);
            uint32_t swap = order[i];
            order[i] = order[--end];
            order[end] = swap;
        }
    }
}

/* Makes p's node an inner one and its left child p's node; the node left, or 0. */
static uint32_t enter(struct maker *k, struct part *p, struct sph_bih_node inner) {
    uint32_t at = pair(k);
    if (!at) return 0;
    inner.child = at;
    k->bih->nodes[p->node] = inner;
    k->bih->stats.inner++;
    p->depth++;
    return at;
}

/* What the last halving left out: whether it reaches up to the middle, the side that was kept. */
struct hole {
    int there, axis, was_left;
    int32_t clip; /* where the primitives end */
};

/* Makes the half without primitives an empty leaf, the other one p's node. */
static void make_empty(struct maker *k, struct part *p, const struct hole *h) {
    struct sph_bih_node cut = {.axis = h->axis,
                               .clip_l = h->was_left ? h->clip : SPH_BIH_NOTHING_BELOW,
                               .clip_r = h->was_left ? SPH_BIH_NOTHING_ABOVE : h->clip};
    uint32_t at = enter(k, p, cut), kept = h->was_left ? 0 : 1;
    if (!at) return;
    make_leaf(k, at + 1 - kept, p->first + (kept ? 0 : p->count), 0, p->depth);
    p->node = at + kept;
}

static void subdivide(struct maker *k, struct part p);

/* Makes both children and all below them. */
static void divide(struct maker *k, struct part *p, int axis, int64_t split2,
                   const struct side *left, const struct side *right) {
    uint32_t at =
        enter(k, p, (struct sph_bih_node){.axis = axis, .clip_l = left->hi, .clip_r = right->lo});
    if (!at) return;
    struct part l = *p, r = *p;
    l.node = at, r.node = at + 1;
    l.count = left->count, r.count = right->count;
    r.first += left->count;
    l.box.hi[axis] = left->hi, r.box.lo[axis] = right->lo;
    if (k->options.how == SPH_BIH_FULL) {
        l.grid.hi[axis] = (int32_t)((split2 + 1) >> 1), r.grid.lo[axis] = (int32_t)(split2 >> 1);
    } else {
        l.grid = l.box, r.grid = r.box;
    }
    subdivide(k, l);
    subdivide(k, r);
}

/* Whether the primitives reach over so little of the box that it pays to say so. */
static int loose(const struct maker *k, const struct sph_aabb *box, int axis,
                 const struct side *all) {
    int64_t fit = k->options.fit ? k->options.fit : SPH_BIH_FIT;
    return fit != UINT32_MAX && fit * ((int64_t)all->hi - all->lo) < 100 * extent(box, axis);
}

/* Says of a node that its primitives reach over less than its box: the box becomes theirs. With
 * `full` the node has one child, which does the rest. 1 if there is nothing left to do. */
static int refit(struct maker *k, struct part *p, int axis, const struct side *all) {
    k->bih->stats.optimized++;
    p->box.lo[axis] = all->lo, p->box.hi[axis] = all->hi;
    if (k->options.how == SPH_BIH_LISTING) {
        p->grid = p->box;
        return 0;
    }
    struct sph_bih_node fit = {.axis = axis, .fit = 1, .clip_l = all->lo, .clip_r = all->hi};
    uint32_t at = enter(k, p, fit);
    if (at) {
        p->node = at;
        subdivide(k, *p);
    }
    return 1;
}

/* Leaves out the half of the grid that has no centre. 0 if that is none. */
static int halve(struct part *p, int axis, int64_t split2, int was_left) {
    int32_t *end = was_left ? &p->grid.hi[axis] : &p->grid.lo[axis];
    int32_t before = *end;
    *end = (int32_t)((split2 + was_left) >> 1);
    return *end != before;
}

static void subdivide(struct maker *k, struct part p) {
    struct hole hole = {0};
    if (k->failed) return;
    if (p.count <= k->options.max_prims || p.depth == k->options.max_depth) {
        make_leaf(k, p.node, p.first, p.count, p.depth);
        return;
    }
    for (;;) {
        int axis = widest(&p.grid);
        int64_t split2 = (int64_t)p.grid.lo[axis] + p.grid.hi[axis];
        struct side left, right, all;
        partition(k, &p, axis, split2, &left, &right);
        all = left;
        if (right.lo < all.lo) all.lo = right.lo;
        if (right.hi > all.hi) all.hi = right.hi;

        if (loose(k, &p.box, axis, &all)) {
            if (refit(k, &p, axis, &all)) return;
        } else if (left.count && right.count) {
            if (hole.there && p.depth + 1 < k->options.max_depth) make_empty(k, &p, &hole);
            if (!k->failed) divide(k, &p, axis, split2, &left, &right);
            return;
        } else {
            int was_left = left.count > 0;
            hole = (struct hole){0, axis, was_left, was_left ? left.hi : right.lo};
            hole.there =
                k->options.how == SPH_BIH_FULL &&
                (was_left ? 2 * (int64_t)hole.clip <= split2 : 2 * (int64_t)hole.clip >= split2);
            if (!halve(&p, axis, split2, was_left)) {
                make_leaf(k, p.node, p.first, p.count, p.depth);
                return;
            }
        }
    }
}

int sph_bih_build(const struct sph_aabb *boxes, uint32_t n, const struct sph_bih_options *options,
                  struct sph_bih *bih, struct sph_error *err) {
    struct maker k = {
        .boxes = boxes, .options = *options, .bih = bih, .room = 64, .n = n, .err = err};
    *bih = (struct sph_bih){
        .box = {{INT32_MAX, INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN, INT32_MIN}}};
    bih->nodes = malloc(k.room * sizeof *bih->nodes);
    bih->order = malloc((n + 1ull) * sizeof *bih->order);
    if (!bih->nodes || !bih->order) return sph_fail(err, "out of memory for %u boxes", n);
    for (uint32_t i = 0; i < n; i++) {
        bih->order[i] = i;
        for (int j = 0; j < 3; j++) {
            if (boxes[i].lo[j] < bih->box.lo[j]) bih->box.lo[j] = boxes[i].lo[j];
            if (boxes[i].hi[j] > bih->box.hi[j]) bih->box.hi[j] = boxes[i].hi[j];
        }
    }
    pair(&k);
    subdivide(&k, (struct part){0, 0, n, 1, bih->box, bih->box});
    return k.failed;
}

void sph_bih_free(struct sph_bih *bih) {
    free(bih->nodes);
    free(bih->order);
    bih->nodes = NULL;
    bih->order = NULL;
}
