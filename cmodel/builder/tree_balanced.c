/* tree_balanced.c - binary splits collapsed to nodes of four at least expected cost
 * SPDX-License-Identifier: Apache-2.0
 *
 * A node opens its halves along the cheapest shares that tree_split.c found until it has four
 * children; of those shares that keep within the hardware's stack, where the tree would get deeper.
 * Should none do, it is split again without reinsertion, then with a lower limit of binary levels;
 * at last in half all the way, two binary levels to a node, which needs ceil(log2(n)/2) levels.
 */
#include <string.h>
#include <stdlib.h>

#include "builder/tree_better.h"
#include "machine/layout.h"

struct work {
    const struct sph_ball *balls;
    const struct sph_profile *profile;
    const int32_t *eye;
    struct sph_split split;
    struct sph_tree *tree;
    int most; /* levels of nodes */
    int even; /* two binary levels to a node, whatever the cost */
};

/* Appends the children that a binary child becomes when it may be j of them, with `most` levels of
 * nodes, which is enough for it; `must` for a node's own pair, which may not stay whole. */
static void open_pair(const struct work *w, uint32_t child, int j, int must, int most,
                      uint32_t out[4], int *n) {
    const struct sph_pair *pairs = w->split.pairs, *p = &pairs[child];
    int whole = child & SPH_PAIR_LEAF || j == 1, share = j / 2;
    float cost = 0;
    if (!whole && !w->even) {
        share = sph_pair_share(pairs, p, j, most, &cost);
        whole = !must && p->levels[1] <= most && cost >= p->cost[1];
    }
    if (whole) {
        out[(*n)++] = child;
        return;
    }
    open_pair(w, p->child[0], share, 0, most, out, n);
    open_pair(w, p->child[1], j - share, 0, most, out, n);
}

/* Squared distance of a child from the eye; spheres of filter units by their centres. */
static double eye_distance(const struct work *w, uint32_t child) {
    const struct sph_pair *pairs = w->split.pairs;
    double sum = 0, c[4];
    uint32_t sphere = child & ~SPH_PAIR_LEAF;
    if (child & SPH_PAIR_LEAF)
        for (int i = 0; i < 3; i++)
            c[i] = w->balls[sphere].c[i];
    else
        sph_enclose(w->balls, w->split.order + pairs[child].first, pairs[child].count, c);
    for (int i = 0; i < 3; i++)
        sum += (c[i] - w->eye[i]) * (c[i] - w->eye[i]);
    return sum;
}

/* Sorts children: inner ones first, each kind near first. */
static void sort_children(const struct work *w, uint32_t children[4], int n) {
    double far[4];
    for (int i = 0; i < n; i++) {
        uint32_t child = children[i];
        double d = eye_distance(w, child);
        int at = i;
        for (; at > 0; at--) {
            uint32_t before = children[at - 1];
            int kind = (child & SPH_PAIR_LEAF) != 0, kind_before = (before & SPH_PAIR_LEAF) != 0;
            if (kind_before < kind || (kind_before == kind && far[at - 1] <= d)) break;
            children[at] = before, far[at] = far[at - 1];
        }
        children[at] = child, far[at] = d;
    }
}

/* Makes the node of a pair and all below it; returns its index. Levels go to tree->depth. */
static uint32_t collapse(struct work *w, uint32_t pair, int level) {
    struct sph_tree *tree = w->tree;
    const struct sph_pair *p = &w->split.pairs[pair];
    uint32_t me = tree->n_nodes++, children[4];
    struct sph_tree_node *node = &tree->nodes[me];
    int n = 0;
    if ((uint32_t)level + 2 > tree->depth) tree->depth = (uint32_t)level + 2;
    node->ball = sph_filter_enclose(w->balls, w->split.order + p->first, p->count, w->profile);
    open_pair(w, pair, 4, 1, w->most - level - 1, children, &n);
    sort_children(w, children, n);
    node->n_inner = node->n_leaf = 0;
    for (int i = 0; i < n; i++) {
        int leaf = (children[i] & SPH_PAIR_LEAF) != 0;
        node->child[i] = leaf ? children[i] & ~SPH_PAIR_LEAF : collapse(w, children[i], level + 1);
        *(leaf ? &node->n_leaf : &node->n_inner) += 1;
    }
    return me;
}

/* The tree of no sphere or of one. */
static void trivial(const struct work *w, uint32_t n) {
    struct sph_tree_node *node = &w->tree->nodes[0];
    memset(node, 0, sizeof *node);
    node->n_leaf = (uint8_t)n;
    if (n) node->ball = sph_filter_leaf(&w->balls[0], w->profile);
    w->tree->n_nodes = 1;
    w->tree->depth = 2;
}

int sph_tree_balanced(const struct sph_ball *balls, const struct sph_aabb *boxes, uint32_t n,
                      const struct sph_profile *profile, const int32_t eye[3], int kind,
                      struct sph_tree *tree, struct sph_error *err) {
    static const int limits[] = {64, 30, 25, 21, 18, 0};
    struct work w = {.balls = balls, .profile = profile, .eye = eye, .tree = tree};
    w.most = SPH_STACK_DEPTH - (int)tree->above;
    /* a node has two children or more, so there are fewer nodes than spheres */
    tree->nodes = malloc((n + 1ull) * sizeof *tree->nodes);
    if (!tree->nodes) return sph_fail(err, "out of memory for a tree of %u spheres", n);
    if (n < 2) {
        trivial(&w, n);
        return 0;
    }
    for (int better = kind == SPH_TREE_REINSERTED || boxes, i = 0; i < 6;
         i += !better, better = 0) {
        if (sph_split(balls, boxes, n, limits[i], &w.split, err) ||
            (better && sph_split_better(balls, boxes, n, profile, &w.split, err))) {
            sph_split_free(&w.split);
            free(tree->nodes);
            tree->nodes = NULL;
            return -1;
        }
        if (!better) sph_split_fill(balls, boxes, profile, &w.split);
        w.even = limits[i] == 0;
        tree->n_nodes = tree->depth = 0;
        int fits = w.even || w.split.pairs[0].levels[1] <= w.most;
        if (fits) collapse(&w, 0, 0);
        sph_split_free(&w.split);
        if (fits) break;
    }
    size_t used = tree->n_nodes ? tree->n_nodes : 1;
    struct sph_tree_node *less = realloc(tree->nodes, used * sizeof *tree->nodes);
    if (less) tree->nodes = less;
    return 0;
}
