/* nodes.c - nodes of four of a binary tree, and their spheres    RTL: rtl/build/rt_build_nodes.v
 * SPDX-License-Identifier: Apache-2.0
 *
 * A node's children are at first the two halves of its pair. As long as there are fewer than four,
 * the one of the largest box is replaced by its own two halves. Inner children come first, each
 * kind in the order in which they were found; nodes are made depth first, the first child first.
 *
 * A child holds a run of places of the order, first to last. The sphere around it has a centre that
 * is rounded to filter units, and the smallest radius with which it holds every leaf: it is made of
 * the leaves alone, so no error adds up along the levels. The centre is the mean of two: the middle
 * of the box around the leaves, and the point in the middle, as nearly as can be, of their extents
 * along the four diagonals of a cube.
 *
 * A node on level l of which more than 4^(STACK_DEPTH - l) spheres are below, so that a bad tree
 * would be too deep for the stack, is cut in halves of its run instead, and so is all below it.
 */
#include <stdlib.h>

#include "build/build_tree.h"
#include "machine/layout.h"
#include "math/arith.h"
#include "math/fx.h"

/* A run of places, one cluster of the binary tree. */
struct run {
    uint32_t first, last;
    uint32_t number; /* of its pair */
    int even;        /* it is cut in halves, whatever its pair */
};

struct waiting {
    struct run run;
    uint32_t line, level;
    uint32_t parent, slot; /* which node's child it is */
};

struct work {
    const struct sph_bt_leaf *leaves;
    const uint32_t *order;
    const struct sph_bt_pair *pairs;
    const struct sph_profile *profile;
};

static uint32_t spheres(const struct run *run) {
    return run->last - run->first + 1;
}

/* By which of two runs is opened first. */
static uint32_t size(const struct work *w, const struct run *run) {
    return run->even ? spheres(run) : w->pairs[run->number].size;
}

static void halves(const struct work *w, const struct run *run, struct run *left,
                   struct run *right) {
    struct run whole = *run;
    uint32_t at =
        whole.even ? whole.first + (whole.last - whole.first) / 2 : w->pairs[whole.number].cut;
    *left = (struct run){whole.first, at, w->pairs[whole.number].left, whole.even};
    *right = (struct run){at + 1, whole.last, w->pairs[whole.number].right, whole.even};
}

/* The runs of a node's children; returns how many. */
static int open_run(const struct work *w, struct run run, struct run child[SPH_BT_CHILDREN]) {
    int n = 1, largest = 0;
    child[0] = run;
    while (n < SPH_BT_CHILDREN && largest >= 0) {
        largest = -1;
        for (int i = 0; i < n; i++)
            if (spheres(&child[i]) > 1 &&
                (largest < 0 || size(w, &child[i]) > size(w, &child[largest])))
                largest = i;
        if (largest >= 0) halves(w, &child[largest], &child[largest], &child[n]), n++;
    }
    return n;
}

/* Sums of the ends of a run's extent along x, y, z and four diagonals, which are not normalised: a
 * radius is sqrt(3) times as long there, or 7/4. */
enum { ACROSS = 7 };
static const int across[ACROSS][3] = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1}, {1, 1, 1},
                                      {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}};

static int64_t ends(const struct work *w, const struct run *run, int way) {
    const int *to = across[way];
    int64_t lo = INT64_MAX, hi = INT64_MIN;
    for (uint32_t at = run->first; at <= run->last; at++) {
        const struct sph_bt_leaf *leaf = &w->leaves[w->order[at]];
        int64_t rad = leaf->rad, d = 0;
        for (int i = 0; i < 3; i++)
            d += to[i] * (int64_t)leaf->ctr[i];
        if (way >= 3) rad += (rad >> 1) + (rad >> 2);
        if (d - rad < lo) lo = d - rad;
        if (d + rad > hi) hi = d + rad;
    }
    return lo + hi;
}

/* The sphere around a run: see above. One that is larger than that around the grid becomes it. */
static void enclose(const struct work *w, const struct run *run, int32_t ctr[3], int32_t *rad) {
    const struct sph_profile *p = w->profile;
    int k = p->w - p->fw, unused;
    int64_t half = 1ll << (p->fw - 1), most = 0, sum[ACROSS];
    for (int way = 0; way < ACROSS; way++)
        sum[way] = ends(w, run, way);
    for (int i = 0; i < 3; i++) {
        int64_t sixteen = 4 * sum[i]; /* times the centre */
        for (int way = 3; way < ACROSS; way++)
            sixteen += across[way][i] * sum[way];
        int64_t f = sph_round(sixteen, k + 4);
        ctr[i] = (int32_t)(f > half - 1 ? half - 1 : f < -half ? -half : f);
    }
    for (uint32_t at = run->first; at <= run->last; at++) {
        const struct sph_bt_leaf *leaf = &w->leaves[w->order[at]];
        sph_u128 square = 0;
        for (int i = 0; i < 3; i++) {
            int64_t d = ctr[i] * (1ll << k) - leaf->ctr[i];
            square += (uint64_t)(d * d);
        }
        int inexact;
        int64_t reach = (int64_t)sph_isqrt(square, &inexact);
        reach += inexact + leaf->rad;
        if (reach > most) most = reach;
    }
    int64_t r = -(-most >> k), whole = (int64_t)sph_isqrt((uint64_t)(3 * half * half), &unused) + 1;
    for (int i = 0; i < 3 && r > whole; i++)
        ctr[i] = 0;
    *rad = (int32_t)(r > whole ? whole : r);
}

uint32_t sph_bt_nodes(const struct sph_bt_leaf *leaves, const uint32_t *order, uint32_t n,
                      const struct sph_bt_pair *pairs, uint32_t root,
                      const struct sph_profile *profile, struct sph_bt_node *nodes) {
    const struct work w = {leaves, order, pairs, profile};
    struct waiting stack[3 * SPH_STACK_DEPTH + 1];
    uint32_t waits = 1, made = 0, next = 1; /* next: the first line that is free */
    if (!n) {
        nodes[0] = (struct sph_bt_node){.base = 1};
        return 1;
    }
    stack[0] = (struct waiting){.run = {0, n - 1, root, 0}, .level = 1};
    while (waits) {
        struct waiting it = stack[--waits];
        struct sph_bt_node *node = &nodes[made];
        struct run found[SPH_BT_CHILDREN], child[SPH_BT_CHILDREN];
        if (spheres(&it.run) > 1ull << 2 * (SPH_STACK_DEPTH - it.level)) it.run.even = 1;
        int opened = open_run(&w, it.run, found), n_children = 0;
        *node = (struct sph_bt_node){.base = next, .line = it.line};
        if (made) nodes[it.parent].child[it.slot] = made;
        for (int leaf = 0; leaf < 2; leaf++)
            for (int i = 0; i < opened; i++) {
                if ((spheres(&found[i]) == 1) != leaf) continue;
                if (leaf) node->child[n_children] = order[found[i].first];
                *(leaf ? &node->n_leaf : &node->n_inner) += 1;
                child[n_children++] = found[i];
            }
        for (int i = 0; i < n_children; i++)
            enclose(&w, &child[i], node->ctr[i], &node->rad[i]);
        for (uint32_t i = node->n_inner; i--;)
            stack[waits++] = (struct waiting){child[i], next + i, it.level + 1, made, i};
        next += node->n_inner + (node->n_leaf + 1u) / 2;
        made++;
    }
    return made;
}

int sph_bt_tree(const struct sph_bt_leaf *leaves, uint32_t n, const struct sph_profile *profile,
                struct sph_bt_node **nodes, uint32_t *n_nodes, struct sph_error *err) {
    uint32_t *order = malloc((n + 1ull) * sizeof *order);
    uint64_t *spare = malloc((2ull * n + 1) * sizeof *spare);
    struct sph_bt_pair *pairs = calloc(n + 1ull, sizeof *pairs);
    *nodes = malloc((n + 1ull) * sizeof **nodes);
    uint32_t root = 0;
    int made = order && spare && pairs && *nodes;
    if (made) {
        sph_bt_order(leaves, n, order, spare);
        made = !sph_bt_join(leaves, n, profile, order, pairs, &root);
    }
    if (made) {
        *n_nodes = sph_bt_nodes(leaves, order, n, pairs, root, profile, *nodes);
    } else {
        free(*nodes);
        *nodes = NULL;
    }
    free(order);
    free(spare);
    free(pairs);
    return made ? 0 : sph_fail(err, "out of memory for a tree of %u spheres", n);
}
