/* agglomerate.c - see agglomerate.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Walter, Bala, Kulkarni, Pingali: Fast Agglomerative Clustering for Rendering (2008), in the
 * rounds of Meister, Bittner: Parallel Locally-Ordered Clustering for Bounding Volume Hierarchy
 * Construction (2018), with balls. In a round each ball looks for the one that makes the smallest
 * ball with it, and two that choose each other become one.
 */
#include "builder/tree/agglomerate.h"

#include <math.h>
#include <stdlib.h>

#include "common/parallel.h"

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

int sph_agglomerate(struct sph_links *l, int tight) {
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
