/* better.c - see split.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/tree/split.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "builder/tree/links.h"
#include "common/parallel.h"

/* Trees from the leaves upwards: Walter, Bala, Kulkarni, Pingali: Fast Agglomerative Clustering for
 * Rendering (2008), in the rounds of Meister, Bittner: Parallel Locally-Ordered Clustering for
 * Bounding Volume Hierarchy Construction (2018), with balls. In a round each ball looks for the one
 * that makes the smallest ball with it, and two that choose each other become one. */
/* LOOKS: pairs that are looked at, times n^2; about half of the balls join in a round, which makes
 * 4/3. WORTH: balls of a round that are worth a thread. */
enum { LOOKS = 4, WORTH = 1024 };

struct work {
    struct sph_links *links;
    uint32_t left;              /* balls that have no parent yet */
    struct sph_link_ball *ball; /* of each */
    uint32_t *node, *near;      /* its number, and its choice */
    uint32_t *spheres;          /* of a node */
    int look;
};

/* The radius of the ball around two; the same whichever comes first. */
static inline float radius(const struct sph_link_ball *a, const struct sph_link_ball *b) {
    float r = (sph_link_apart(a, b) + (a->r + b->r)) / 2;
    float most = a->r > b->r ? a->r : b->r;
    return r > most ? r : most;
}

/* The choice of a ball. Of equal ones it is that whose place differs in lower bits, which is an
 * order of pairs: so the first pair of all chooses each other, and of many equal ones half do. */
static uint32_t nearest(const struct work *w, uint32_t at) {
    uint32_t best = at;
    float least = INFINITY;
    for (uint32_t i = 0; i < w->left; i++) {
        float r = radius(&w->ball[i], &w->ball[at]);
        if (r > least || i == at || (r == least && (i ^ at) > (best ^ at))) continue;
        least = r, best = i;
    }
    return best;
}

/* Makes the node `me` of the balls at two places. */
static struct sph_link_ball join(struct work *w, uint32_t me, uint32_t a, uint32_t b, int tight) {
    struct sph_links *l = w->links;
    uint32_t n = 0;
    l->child[me - l->n][0] = w->node[a], l->child[me - l->n][1] = w->node[b];
    l->parent[w->node[a]] = l->parent[w->node[b]] = me;
    if (!tight) return sph_link_merge(l, &w->ball[a], &w->ball[b]);
    for (uint32_t i = sph_link_leftmost(l, me); i != me; i = sph_link_next(l, i))
        if (i < l->n) w->spheres[n++] = i;
    return sph_link_around(l, w->spheres, n);
}

/* The choices of some balls; of any neighbour when they no longer look. */
static void choose(void *user, uint32_t first, uint32_t end) {
    struct work *w = user;
    for (uint32_t i = first; i < end; i++)
        w->near[i] = w->look ? nearest(w, i) : (i ^ 1) < w->left ? i ^ 1 : i;
}

static void agglomerate(struct work *w, int tight) {
    struct sph_links *l = w->links;
    uint64_t looks = 0, most = (uint64_t)LOOKS * l->n * l->n;
    uint32_t made = l->n;
    for (w->left = 0; w->left < l->n; w->left++)
        w->node[w->left] = w->left, w->ball[w->left] = l->ball[w->left];
    while (w->left > 1) {
        uint32_t n = 0;
        w->look = looks < most;
        sph_parallel_for(w->left, WORTH, choose, w);
        looks += (uint64_t)w->left * w->left;
        for (uint32_t i = 0; i < w->left; i++) {
            uint32_t other = w->near[i], me = w->node[i];
            struct sph_link_ball ball = w->ball[i];
            int pair = w->near[other] == i && other != i;
            if (pair && other < i) continue;
            if (pair) me = made++, ball = join(w, me, i, other, tight);
            w->ball[n] = ball, w->node[n++] = me;
        }
        w->left = n;
    }
    l->root = w->node[0];
    l->parent[l->root] = SPH_LINK_NONE;
    sph_links_renew(l);
}

/* Makes the tree by joining the two balls that make the smallest one. tight: balls are the smallest
 * ones around their spheres; else around the two that are joined. It looks at 4 n^2 pairs at most,
 * and the tree does not depend on the number of threads. -1 if memory is out. */
static int from_leaves(struct sph_links *l, int tight) {
    struct work w = {.links = l, .ball = malloc(l->n * sizeof *w.ball)};
    uint32_t *numbers = malloc(3ull * l->n * sizeof *numbers);
    int good = w.ball && numbers;
    if (good) {
        w.node = numbers, w.near = numbers + l->n, w.spheres = w.near + l->n;
        agglomerate(&w, tight);
    }
    free(w.ball);
    free(numbers);
    return good ? 0 : -1;
}

enum { SPLITS, TIGHT, LOOSE, WAYS };

/* Makes a tree one way, of a split if it starts there, and puts it in the place of *out. */
static int make(struct sph_links *l, int way, const struct sph_split *split,
                struct sph_split *out) {
    if (way == SPLITS)
        sph_links_take(l, split);
    else if (from_leaves(l, way == TIGHT))
        return -1;
    if (sph_reinsert(l)) return -1;
    sph_links_give(l, out);
    return 0;
}

/* Makes it in *spare, and puts it in the place of *split if it costs less. */
static int make_cheaper(struct sph_links *l, int way, struct sph_split *split,
                        struct sph_split *spare) {
    if (make(l, way, split, spare)) return -1;
    if (spare->pairs[0].cost[1] >= split->pairs[0].cost[1]) return 0;
    struct sph_split swap = *split;
    *split = *spare, *spare = swap;
    return 0;
}

int sph_split_better(const struct sph_ball *balls, const struct sph_aabb *boxes, uint32_t n,
                     const struct sph_profile *profile, const struct sph_progress *progress,
                     struct sph_split *split, struct sph_error *err) {
    struct sph_links links;
    struct sph_split spare = {NULL, 0, NULL};
    int failed = sph_links_new(balls, boxes, n, sph_pair_margin(profile), &links);
    links.progress = progress;
    int many = n > SPH_TREE_FEW || boxes; /* one way must do */
    if (!many) {
        spare.pairs = malloc((n - 1) * sizeof *spare.pairs);
        spare.order = malloc(n * sizeof *spare.order);
        failed |= !spare.pairs || !spare.order;
        sph_split_fill(balls, NULL, profile, split);
    }
    for (int way = 0; way < WAYS && !failed && !many; way++)
        failed = make_cheaper(&links, way, split, &spare);
    if (!failed && many) failed = make(&links, SPLITS, split, split);
    sph_links_free(&links);
    sph_split_free(&spare);
    return failed ? sph_fail(err, "out of memory for a tree of %u spheres", n) : 0;
}
