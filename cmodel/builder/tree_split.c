/* tree_split.c - binary surface-area splits of spheres; see tree_split.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Top down: every place of the spheres sorted along x, y and z is tried; the price of a split is
 * d^2 * n^0.8 of left and right, d the diagonal of the box: bounding spheres are hit like d^2, and
 * visits grow slower than n (measured: 7 % fewer visits than box area * n). In a tree of boxes it
 * is their area * n. Bottom up: cost[j], the least expected visits below a pair if it may become j
 * children: one node, visited with probability ~ R^2 of its bounding sphere, or the children of its
 * two halves.
 */
#include "builder/tree_split.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "machine/layout.h"

enum { PARALLEL = 8192 }; /* spheres from which on threads share the work */

struct work {
    const struct sph_ball *balls;
    const struct sph_aabb *boxes; /* or NULL */
    struct sph_pair *pairs;
    uint32_t *order[3], *spare;
    uint8_t *right; /* per sphere: side of the split at hand */
    float
        *price; /* of the right part from place i on; as spare, of the spheres of a pair its own */
    float *weight; /* [n]: n^0.8, or n */
    int limit;     /* binary levels */
};

struct box {
    float lo[3], hi[3];
};

static const struct box EMPTY = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

static void box_add(const struct work *w, struct box *box, uint32_t number) {
    const struct sph_ball *ball = &w->balls[number];
    const struct sph_aabb *own = w->boxes ? &w->boxes[number] : NULL;
    for (int i = 0; i < 3; i++) {
        float lo = (float)(own ? own->lo[i] : ball->c[i] - ball->r);
        float hi = (float)(own ? own->hi[i] : ball->c[i] + ball->r);
        if (lo < box->lo[i]) box->lo[i] = lo;
        if (hi > box->hi[i]) box->hi[i] = hi;
    }
}

/* Half the surface, or the squared diagonal: the bounding sphere on the box is hit like this. */
static float box_area(const struct work *w, const struct box *box) {
    float x = box->hi[0] - box->lo[0], y = box->hi[1] - box->lo[1], z = box->hi[2] - box->lo[2];
    return w->boxes ? x * y + y * z + z * x : x * x + y * y + z * z;
}

/* Finds the cheapest split of a pair: axis and size of the left part. */
static void choose(const struct work *w, const struct sph_pair *p, int *axis, uint32_t *left) {
    float best = INFINITY, *price_of = w->price + p->first;
    *axis = 0, *left = p->count / 2;
    for (int a = 0; a < 3; a++) {
        const uint32_t *order = w->order[a] + p->first;
        struct box box = EMPTY;
        for (uint32_t i = p->count - 1; i > 0; i--) {
            box_add(w, &box, order[i]);
            price_of[i] = box_area(w, &box) * w->weight[p->count - i];
        }
        box = EMPTY;
        for (uint32_t i = 1; i < p->count; i++) {
            box_add(w, &box, order[i - 1]);
            float price = box_area(w, &box) * w->weight[i] + price_of[i];
            if (price < best) best = price, *axis = a, *left = i;
        }
    }
}

/* The longest axis of the centres, for a split in half. */
static int longest(const struct work *w, const struct sph_pair *p) {
    int64_t most = -1;
    int axis = 0;
    for (int a = 0; a < 3; a++) {
        int64_t low = w->balls[w->order[a][p->first]].c[a];
        int64_t length = w->balls[w->order[a][p->first + p->count - 1]].c[a] - low;
        if (length > most) most = length, axis = a;
    }
    return axis;
}

/* Moves the first `left` spheres along `axis` to the front of the other two orders. */
static void partition(const struct work *w, const struct sph_pair *p, int axis, uint32_t left) {
    for (uint32_t i = 0; i < p->count; i++)
        w->right[w->order[axis][p->first + i]] = i >= left;
    for (int a = 0; a < 3; a++) {
        uint32_t *order = w->order[a] + p->first, *spare = w->spare + p->first;
        uint32_t lower = 0, upper = 0;
        if (a == axis) continue;
        for (uint32_t i = 0; i < p->count; i++) {
            if (w->right[order[i]])
                spare[upper++] = order[i];
            else
                order[lower++] = order[i];
        }
        memcpy(order + lower, spare, upper * sizeof *order);
    }
}

/* The levels that two halves need as i and j children. */
static int share_levels(const struct sph_pair *pairs, const struct sph_pair *p, int i, int j) {
    int a = sph_pair_levels(pairs, p->child[0], i), b = sph_pair_levels(pairs, p->child[1], j);
    return a > b ? a : b;
}

int sph_pair_share(const struct sph_pair *pairs, const struct sph_pair *p, int j, int most,
                   float *cost) {
    int best = j / 2;
    *cost = INFINITY;
    for (int i = 1; i < j; i++) {
        if (i > 3 || j - i > 3 || share_levels(pairs, p, i, j - i) > most) continue;
        float c = sph_pair_cost(pairs, p->child[0], i) + sph_pair_cost(pairs, p->child[1], j - i);
        if (c < *cost) *cost = c, best = i;
    }
    return best;
}

void sph_pair_fill(const struct sph_pair *pairs, struct sph_pair *p, float area) {
    float shared[5];
    int levels[5] = {0, 0, INT_MAX, INT_MAX, INT_MAX};
    for (int j = 2; j <= 4; j++) {
        sph_pair_share(pairs, p, j, INT_MAX, &shared[j]);
        for (int i = j < 4 ? j - 1 : 3; i > 0 && j - i <= 3; i--) {
            int need = share_levels(pairs, p, i, j - i);
            if (need < levels[j]) levels[j] = need;
        }
    }
    p->levels[0] = levels[4];
    p->levels[1] = levels[4] + 1;
    for (int j = 2; j <= 3; j++)
        p->levels[j] = levels[j] < p->levels[j - 1] ? levels[j] : p->levels[j - 1];
    p->cost[0] = shared[4];
    p->cost[1] = area + shared[4];
    p->cost[2] = fminf(p->cost[1], shared[2]);
    p->cost[3] = fminf(p->cost[2], shared[3]);
}

/* Splits the spheres first..first+count-1 into the pairs me..me+count-2; returns the binary child.
 * Halves that are large are made by threads of their own. */
static uint32_t split(const struct work *w, uint32_t me, uint32_t first, uint32_t count,
                      int depth) {
    if (count == 1) return SPH_PAIR_LEAF | w->order[0][first];
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
#pragma omp task shared(p) if (count > PARALLEL)
    p->child[0] = split(w, me + 1, first, left, depth + 1);
    p->child[1] = split(w, me + left, first + left, count - left, depth + 1);
#pragma omp taskwait
    return me;
}

double sph_pair_margin(const struct sph_profile *profile) {
    return ldexp(SPH_FILTER_MARGIN + 1, profile->w - profile->fw);
}

int sph_split(const struct sph_ball *balls, const struct sph_aabb *boxes, uint32_t n, int limit,
              struct sph_split *out, struct sph_error *err) {
    struct work w = {.balls = balls, .boxes = boxes, .limit = limit};
    *out = (struct sph_split){.pairs = malloc(n * sizeof *w.pairs)};
    w.pairs = out->pairs;
    w.spare = malloc(n * sizeof *w.spare);
    w.right = malloc(n);
    w.price = malloc(n * sizeof *w.price);
    w.weight = malloc(n * sizeof *w.weight);
    for (int a = 0; a < 3; a++)
        w.order[a] = sph_tree_sort(balls, n, a, 0);
    int good = w.pairs && w.spare && w.right && w.price && w.weight && w.order[0] && w.order[1] &&
               w.order[2];
    for (uint32_t i = 0; good && i < n; i++)
        w.weight[i] = boxes ? (float)i : powf((float)i, 0.8f);
#pragma omp parallel if (n > PARALLEL)
#pragma omp single
    if (good) split(&w, 0, 0, n, 0);
    free(w.spare);
    free(w.right);
    free(w.price);
    free(w.weight);
    free(w.order[1]);
    free(w.order[2]);
    out->n_pairs = n - 1;
    out->order = w.order[0];
    if (good) return 0;
    sph_split_free(out);
    return sph_fail(err, "out of memory for a tree of %u spheres", n);
}

/* What the ball or box around a pair's own is met like. */
static float pair_area(const struct work *w, const struct sph_profile *profile,
                       const uint32_t *order, uint32_t n) {
    double ball[4];
    struct box box = EMPTY;
    for (uint32_t i = 0; w->boxes && i < n; i++)
        box_add(w, &box, order[i]);
    if (w->boxes) return box_area(w, &box);
    sph_enclose(w->balls, order, n, ball);
    double r = ball[3] + sph_pair_margin(profile);
    return (float)(r * r);
}

void sph_split_fill(const struct sph_ball *balls, const struct sph_aabb *boxes,
                    const struct sph_profile *profile, struct sph_split *split) {
    const struct work w = {.balls = balls, .boxes = boxes};
    for (uint32_t i = split->n_pairs; i-- > 0;) { /* children stand behind their parent */
        struct sph_pair *p = &split->pairs[i];
        sph_pair_fill(split->pairs, p, pair_area(&w, profile, split->order + p->first, p->count));
    }
}

void sph_split_free(struct sph_split *tree) {
    free(tree->pairs);
    free(tree->order);
    memset(tree, 0, sizeof *tree);
}
