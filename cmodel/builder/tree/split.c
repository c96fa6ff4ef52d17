/* split.c - binary surface-area splits of spheres; see split.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Top down: every place of the spheres sorted along x, y and z is tried; the price of a split is
 * d^2 * n^0.8 of left and right, d the diagonal of the box: bounding spheres are hit like d^2, and
 * visits grow slower than n (measured: 7 % fewer visits than box area * n). In a tree of boxes it
 * is their area * n.
 */
#include "builder/tree/split.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/parallel.h"

/* PARALLEL: spheres from which on threads share the work. BLOCK: no more of them get numbers and
 * boxes of their own, which lie together in memory; of fewer than LEAST that does not pay. AHEAD:
 * what is brought from memory before it is needed. */
enum { PARALLEL = 8192, BLOCK = 32768, LEAST = 32, AHEAD = 16 };

struct box {
    float lo[3], hi[3];
};

/* Spheres first..first+n-1 of all, which are to be split; in a block they are 0..n-1. */
struct work {
    const struct sph_ball *balls;
    const struct sph_aabb *boxes; /* or NULL */
    struct sph_pair *pairs;
    uint32_t first;
    uint32_t *names; /* of spheres in a block, whose boxes are `own`; else NULL */
    struct box *own;
    uint32_t *numbers; /* of all: in their blocks */
    uint32_t *out;     /* of all: in their final order */
    uint32_t *order[3], *spare;
    uint8_t *right; /* per sphere: side of the split at hand */
    float
        *price; /* of the right part from place i on; as spare, of the spheres of a pair its own */
    float *weight; /* [n]: n^0.8, or n */
    int limit;     /* binary levels */
    const struct sph_progress *progress;
    uint32_t all, *split; /* spheres, and those of them whose blocks are done */
    int *end;             /* the work is not wanted any more */
};

static const struct box EMPTY = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

static inline struct box box_of(const struct work *w, uint32_t number) {
    const struct sph_ball *ball = &w->balls[number];
    const struct sph_aabb *own = w->boxes ? &w->boxes[number] : NULL;
    struct box box;
    for (int i = 0; i < 3; i++) {
        box.lo[i] = (float)(own ? own->lo[i] : ball->c[i] - ball->r);
        box.hi[i] = (float)(own ? own->hi[i] : ball->c[i] + ball->r);
    }
    return box;
}

/* Brings what is at a place of a list from memory. */
static inline void fetch(const struct work *w, const uint32_t *order, uint32_t at) {
    if (w->own) return;
    if (w->boxes)
        __builtin_prefetch(&w->boxes[order[at]]);
    else
        __builtin_prefetch(&w->balls[order[at]]);
}

static inline void box_add(const struct work *w, struct box *box, uint32_t number) {
    const struct box by = w->own ? w->own[number] : box_of(w, number);
    for (int i = 0; i < 3; i++) {
        box->lo[i] = by.lo[i] < box->lo[i] ? by.lo[i] : box->lo[i];
        box->hi[i] = by.hi[i] > box->hi[i] ? by.hi[i] : box->hi[i];
    }
}

/* Half the surface, or the squared diagonal: the bounding sphere on the box is hit like this. */
static inline float box_area(const struct work *w, const struct box *box) {
    float x = box->hi[0] - box->lo[0], y = box->hi[1] - box->lo[1], z = box->hi[2] - box->lo[2];
    return w->boxes ? x * y + y * z + z * x : x * x + y * y + z * z;
}

/* Finds the cheapest split of a pair: axis and size of the left part. */
static void choose(const struct work *w, const struct sph_pair *p, int *axis, uint32_t *left) {
    float best = INFINITY, *price_of = w->price + (p->first - w->first);
    *axis = 0, *left = p->count / 2;
    for (int a = 0; a < 3; a++) {
        const uint32_t *order = w->order[a] + (p->first - w->first);
        struct box box = EMPTY;
        for (uint32_t i = p->count - 1; i > 0; i--) {
            if (i > AHEAD) fetch(w, order, i - AHEAD);
            box_add(w, &box, order[i]);
            price_of[i] = box_area(w, &box) * w->weight[p->count - i];
        }
        box = EMPTY;
        for (uint32_t i = 1; i < p->count; i++) {
            if (i + AHEAD < p->count) fetch(w, order, i + AHEAD);
            box_add(w, &box, order[i - 1]);
            float price = box_area(w, &box) * w->weight[i] + price_of[i];
            if (price < best) best = price, *axis = a, *left = i;
        }
    }
}

/* The sphere at a place of those along an axis. */
static uint32_t sphere_at(const struct work *w, int axis, uint32_t place) {
    uint32_t number = w->order[axis][place - w->first];
    return w->names ? w->names[number] : number;
}

/* The longest axis of the centres, for a split in half. */
static int longest(const struct work *w, const struct sph_pair *p) {
    int64_t most = -1;
    int axis = 0;
    for (int a = 0; a < 3; a++) {
        int64_t low = w->balls[sphere_at(w, a, p->first)].c[a];
        int64_t length = w->balls[sphere_at(w, a, p->first + p->count - 1)].c[a] - low;
        if (length > most) most = length, axis = a;
    }
    return axis;
}

/* Moves the first `left` spheres along `axis` to the front of the other two orders. */
static void partition(const struct work *w, const struct sph_pair *p, int axis, uint32_t left) {
    uint32_t at = p->first - w->first;
    for (uint32_t i = 0; i < p->count; i++)
        w->right[w->order[axis][at + i]] = i >= left;
    for (int a = 0; a < 3; a++) {
        uint32_t *order = w->order[a] + at, *spare = w->spare + at;
        uint32_t lower = 0, upper = 0;
        if (a == axis) continue;
        for (uint32_t i = 0; i < p->count; i++) { /* one of the two is overwritten by the next */
            uint32_t sphere = order[i], right = w->right[sphere];
            spare[upper] = order[lower] = sphere;
            upper += right, lower += !right;
        }
        memcpy(order + lower, spare, upper * sizeof *order);
    }
}

/* Splits the spheres first..first+count-1 into the pairs me..me+count-2; returns the binary child.
 * Halves that are large are made by threads of their own. */
static uint32_t split(const struct work *w, uint32_t me, uint32_t first, uint32_t count, int depth);

/* The same in a block; out of memory it is made without one. */
static uint32_t split_block(const struct work *all, uint32_t me, uint32_t first, uint32_t count,
                            int depth) {
    struct work w = *all;
    w.first = first;
    w.own = malloc(count * (sizeof *w.own + 5 * sizeof *w.spare + sizeof *w.price + 1));
    if (!w.own) return split(all, me, first, count, depth);
    uint32_t *words = (uint32_t *)(w.own + count);
    w.names = words, w.spare = words + (size_t)4 * count;
    w.price = (float *)(w.spare + count), w.right = (uint8_t *)(w.price + count);
    memcpy(w.names, all->order[0] + first, count * sizeof *w.names);
    for (uint32_t i = 0; i < count; i++) {
        w.own[i] = box_of(all, w.names[i]);
        w.numbers[w.names[i]] = i;
    }
    for (int a = 0; a < 3; a++) {
        w.order[a] = words + (size_t)(a + 1) * count;
        for (uint32_t i = 0; i < count; i++)
            w.order[a][i] = w.numbers[all->order[a][first + i]];
    }
    uint32_t child = split(&w, me, first, count, depth), done;
    free(w.own);
    done = __atomic_add_fetch(w.split, count, __ATOMIC_RELAXED);
    if (sph_progress_at(w.progress, (double)done / w.all))
        __atomic_store_n(w.end, 1, __ATOMIC_RELAXED);
    return child;
}

/* The arguments of split(), and what it returns. */
struct part {
    const struct work *w;
    uint32_t me, first, count;
    int depth;
    uint32_t child;
};

/* split(), in a block if there are few enough. */
static void split_part(void *user) {
    struct part *p = user;
    if (__atomic_load_n(p->w->end, __ATOMIC_RELAXED)) return;
    int block = p->count <= BLOCK && p->count >= LEAST && !p->w->names;
    p->child = block ? split_block(p->w, p->me, p->first, p->count, p->depth)
                     : split(p->w, p->me, p->first, p->count, p->depth);
}

static uint32_t split(const struct work *w, uint32_t me, uint32_t first, uint32_t count,
                      int depth) {
    if (count == 1) return SPH_PAIR_LEAF | (w->out[first] = sphere_at(w, 0, first));
    uint32_t left;
    struct sph_pair *p = &w->pairs[me];
    int axis, need = 0;
    p->first = first, p->count = count;
    while (1ull << need < count)
        need++;
    if (depth + need >= w->limit)
        axis = longest(w, p), left = count / 2;
    else
        choose(w, p, &axis, &left);
    partition(w, p, axis, left);
    if (count > PARALLEL) {
        struct part lower = {w, me + 1, first, left, depth + 1, 0};
        struct part upper = {w, me + left, first + left, count - left, depth + 1, 0};
        sph_parallel_two(1, split_part, &lower, &upper);
        p->child[0] = lower.child, p->child[1] = upper.child;
    } else {
        p->child[0] = split(w, me + 1, first, left, depth + 1);
        p->child[1] = split(w, me + left, first + left, count - left, depth + 1);
    }
    return me;
}

/* Sorts all spheres along some axes. */
static void sort(void *user, uint32_t axis, uint32_t end) {
    struct work *w = user;
    for (; axis < end; axis++)
        w->order[axis] = sph_tree_sort(w->balls, w->all, (int)axis, 0);
}

int sph_split(const struct sph_ball *balls, const struct sph_aabb *boxes, uint32_t n, int limit,
              const struct sph_progress *progress, struct sph_split *out, struct sph_error *err) {
    uint32_t done = 0;
    int end = 0;
    struct work w = {.balls = balls, .boxes = boxes, .limit = limit, .progress = progress};
    w.all = n, w.split = &done, w.end = &end;
    *out = (struct sph_split){.pairs = malloc(n * sizeof *w.pairs)};
    w.pairs = out->pairs;
    w.spare = malloc(n * sizeof *w.spare);
    w.right = malloc(n);
    w.price = malloc(n * sizeof *w.price);
    w.weight = malloc(n * sizeof *w.weight);
    w.numbers = malloc(n * sizeof *w.numbers);
    sph_parallel_for(3, n > PARALLEL ? 1 : 3, sort, &w);
    w.out = w.order[0];
    int good = w.pairs && w.spare && w.right && w.price && w.weight && w.numbers && w.order[0] &&
               w.order[1] && w.order[2];
    for (uint32_t i = 0; good && i < n; i++)
        w.weight[i] = boxes ? (float)i : powf((float)i, 0.8f);
    if (good) split_part(&(struct part){.w = &w, .count = n});
    free(w.numbers);
    free(w.spare);
    free(w.right);
    free(w.price);
    free(w.weight);
    free(w.order[1]);
    free(w.order[2]);
    out->n_pairs = n - 1;
    out->order = w.order[0];
    if (good && !end) return 0;
    sph_split_free(out);
    if (end) return sph_fail(err, "cancelled");
    return sph_fail(err, "out of memory for a tree of %u spheres", n);
}

void sph_split_free(struct sph_split *tree) {
    free(tree->pairs);
    free(tree->order);
    memset(tree, 0, sizeof *tree);
}
