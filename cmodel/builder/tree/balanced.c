/* balanced.c - binary splits collapsed to nodes of four at least expected cost
 * SPDX-License-Identifier: Apache-2.0
 *
 * A node opens its halves along the cheapest shares that split.c found until it has four
 * children; of those shares that keep within the hardware's stack, where the tree would get deeper.
 * Should none do, it is split again without reinsertion, then with a lower limit of binary levels;
 * at last in half all the way, two binary levels to a node, which needs ceil(log2(n)/2) levels.
 */
#include <string.h>
#include <stdlib.h>

#include "builder/tree/split.h"
#include "common/parallel.h"
#include "machine/layout.h"

/* WORTH: nodes that are worth a thread. STEP: nodes between two tellings. */
enum { WORTH = 1024, STEP = 4096 };

/* Shares of the time until it is split, and until that is made better. */
#define SPLIT 0.25
#define BETTER 0.8

/* A node before it has its place. */
struct plan {
    uint32_t pair, child[4]; /* children: plans, or SPH_PAIR_LEAF | sphere */
    struct sph_ball ball;
    double far; /* of its middle from the eye, squared */
    uint8_t n_inner, n_leaf;
};

struct work {
    const struct sph_ball *balls;
    const struct sph_profile *profile;
    const int32_t *eye;
    struct sph_split split;
    struct sph_ball *sorted; /* the balls in its order */
    struct plan *plans;
    uint32_t n;    /* of plans */
    uint32_t seen; /* steps of them that are done */
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

/* Squared distance from the eye. */
static double eye_distance(const struct work *w, const double c[3]) {
    double sum = 0;
    for (int i = 0; i < 3; i++)
        sum += (c[i] - w->eye[i]) * (c[i] - w->eye[i]);
    return sum;
}

/* Makes the node of a pair and all below it, without balls, children as they come; returns its
 * index. */
static uint32_t collapse(struct work *w, uint32_t pair, int level) {
    uint32_t me = w->n++, children[4];
    struct plan *plan = &w->plans[me];
    int n = 0;
    if ((uint32_t)level + 1 > w->tree->depth) w->tree->depth = (uint32_t)level + 1;
    plan->pair = pair;
    plan->n_inner = plan->n_leaf = 0;
    open_pair(w, pair, 4, 1, w->most - level - 1, children, &n);
    for (int i = 0; i < n; i++) {
        int leaf = (children[i] & SPH_PAIR_LEAF) != 0;
        plan->child[i] = leaf ? children[i] : collapse(w, children[i], level + 1);
        *(leaf ? &plan->n_leaf : &plan->n_inner) += 1;
    }
    return me;
}

/* The ball of a planned node, and how far its middle is from the eye. */
static void enclose(const struct work *w, struct plan *plan) {
    const struct sph_pair *p = &w->split.pairs[plan->pair];
    double sphere[4];
    sph_enclose(w->sorted + p->first, NULL, p->count, sphere);
    plan->ball = sph_filter_around(w->sorted + p->first, NULL, p->count, sphere, w->profile);
    plan->far = eye_distance(w, sphere);
}

/* How far a child is; spheres by their centres. */
static double child_distance(const struct work *w, uint32_t child) {
    if (!(child & SPH_PAIR_LEAF)) return w->plans[child].far;
    const struct sph_ball *ball = &w->balls[child & ~SPH_PAIR_LEAF];
    return eye_distance(w, (const double[3]){ball->c[0], ball->c[1], ball->c[2]});
}

/* Sorts children: inner ones first, each kind near first. */
static void sort_children(const struct work *w, uint32_t children[4], int n) {
    double far[4];
    for (int i = 0; i < n; i++) {
        uint32_t child = children[i];
        double d = child_distance(w, child);
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

/* Puts a planned node and all below it into the tree; returns its index. */
static uint32_t put_node(struct work *w, struct plan *plan) {
    struct sph_tree *tree = w->tree;
    uint32_t me = tree->n_nodes++;
    struct sph_tree_node *node = &tree->nodes[me];
    int n = plan->n_inner + plan->n_leaf;
    sort_children(w, plan->child, n);
    node->ball = plan->ball;
    node->n_inner = plan->n_inner, node->n_leaf = plan->n_leaf;
    for (int i = 0; i < n; i++) {
        uint32_t child = plan->child[i];
        node->child[i] =
            child & SPH_PAIR_LEAF ? child & ~SPH_PAIR_LEAF : put_node(w, &w->plans[child]);
    }
    return me;
}

/* The bounding spheres of some plans. */
static void enclose_plans(void *user, uint32_t first, uint32_t end) {
    struct work *w = user;
    struct sph_progress last = sph_progress_part(&w->tree->progress, BETTER, 1);
    for (uint32_t i = first; i < end; i++) {
        enclose(w, &w->plans[i]);
        if (i % STEP) continue;
        uint32_t steps = __atomic_fetch_add(&w->seen, 1, __ATOMIC_RELAXED);
        sph_progress_at(&last, (double)steps * STEP / w->n);
    }
}

/* The nodes of a split. -1 if memory is out. */
static int put_nodes(struct work *w, uint32_t n) {
    struct sph_tree_node *nodes = NULL;
    w->sorted = malloc(n * sizeof *w->sorted);
    w->plans = malloc((n - 1) * sizeof *w->plans);
    w->n = 0;
    if (w->sorted && w->plans) {
        for (uint32_t i = 0; i < n; i++)
            w->sorted[i] = w->balls[w->split.order[i]];
        collapse(w, 0, 0);
        nodes = w->tree->nodes = malloc(w->n * sizeof *nodes);
    }
    if (nodes) {
        w->seen = 0;
        sph_parallel_for(w->n, WORTH, enclose_plans, w);
        put_node(w, w->plans);
    }
    free(w->sorted);
    free(w->plans);
    return nodes ? 0 : -1;
}

/* The tree of no sphere or of one; -1 if memory is out. */
static int trivial(const struct work *w, uint32_t n) {
    struct sph_tree_node *node = w->tree->nodes = calloc(1, sizeof *node);
    if (!node) return -1;
    node->n_leaf = (uint8_t)n;
    if (n) node->ball = sph_filter_leaf(&w->balls[0], w->profile);
    w->tree->n_nodes = w->tree->depth = 1;
    return 0;
}

/* Collapses the split that was kept, by the rays of a machine; one of boxes is rotated before. -1
 * if memory is out. */
static int again(struct work *w, const struct sph_aabb *boxes, uint32_t n, struct sph_error *err) {
    struct sph_split *split = w->tree->split;
    struct sph_visibility_samples samples;
    int failed = sph_visibility_samples(w->tree->seen, boxes != NULL, &samples, err);
    if (!failed && boxes)
        failed = sph_split_rotate(w->balls, boxes, &samples, SPH_UNSEEN, w->most, split, err);
    if (!failed) failed = sph_split_seen(w->balls, boxes, w->profile, &samples, split, err);
    sph_visibility_samples_free(&samples);
    if (failed) return -1;
    w->split = *split;
    w->tree->n_nodes = w->tree->depth = 0;
    return put_nodes(w, n) ? sph_fail(err, "out of memory for a tree") : 0;
}

/* Keeps the split, if that is asked for and there is memory; else frees it. */
static void keep_split(struct work *w) {
    struct sph_split *kept = w->tree->learns ? malloc(sizeof *kept) : NULL;
    if (kept)
        *(w->tree->split = kept) = w->split;
    else
        sph_split_free(&w->split);
}

/* One way to make the tree: 1 if it fits the stack, -1 if memory is out. */
static int attempt(struct work *w, const struct sph_aabb *boxes, uint32_t n, int limit, int better,
                   struct sph_error *err) {
    const struct sph_ball *balls = w->balls;
    int done = -1;
    const struct sph_progress *p = &w->tree->progress;
    struct sph_progress first = sph_progress_part(p, 0, SPLIT);
    struct sph_progress second = sph_progress_part(p, SPLIT, BETTER);
    if (sph_split(balls, boxes, n, limit, &first, &w->split, err)) return -1;
    if (!better || !sph_split_better(balls, boxes, n, w->profile, &second, &w->split, err)) {
        if (!better) sph_split_fill(balls, boxes, w->profile, &w->split);
        w->even = limit == 0;
        w->tree->n_nodes = w->tree->depth = 0;
        done = w->even || w->split.pairs[0].levels[1] <= w->most;
        if (done && put_nodes(w, n)) done = sph_fail(err, "out of memory for a tree");
    }
    if (done > 0 && better && (boxes || n <= SPH_TREE_FEW))
        keep_split(w);
    else
        sph_split_free(&w->split);
    return done;
}

int sph_tree_balanced(const struct sph_ball *balls, const struct sph_aabb *boxes, uint32_t n,
                      const struct sph_profile *profile, const int32_t eye[3], int kind,
                      struct sph_tree *tree, struct sph_error *err) {
    static const int limits[] = {64, 30, 25, 21, 18, 0};
    struct work w = {.balls = balls, .profile = profile, .eye = eye, .tree = tree};
    int done = 0;
    w.most = SPH_STACK_DEPTH - (int)tree->above;
    if (n < 2)
        return trivial(&w, n) ? sph_fail(err, "out of memory for a tree of %u spheres", n) : 0;
    if (tree->seen && tree->split) return again(&w, boxes, n, err);
    for (int better = kind == SPH_TREE_REINSERTED || boxes, i = 0; i < 6 && !done;
         i += !better, better = 0)
        done = attempt(&w, boxes, n, limits[i], better, err);
    return done < 0 ? -1 : 0;
}
