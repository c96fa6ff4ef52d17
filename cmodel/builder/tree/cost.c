/* cost.c - what binary trees cost as nodes of four; see split.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Bottom up: cost[j], the least expected visits below a pair if it may become j children: one node,
 * visited with probability ~ R^2 of its bounding sphere, or the children of its two halves.
 */
#include <limits.h>
#include <math.h>

#include "builder/tree/links.h"
#include "machine/layout.h"

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

double sph_pair_margin(const struct sph_profile *profile) {
    return ldexp(SPH_FILTER_MARGIN + 1, profile->w - profile->fw);
}

/* What the box around some is met like. */
static float box_area(const struct sph_aabb *boxes, const uint32_t *order, uint32_t n) {
    float lo[3] = {INFINITY, INFINITY, INFINITY}, hi[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (uint32_t i = 0; i < n; i++)
        for (int j = 0; j < 3; j++) {
            lo[j] = fminf(lo[j], (float)boxes[order[i]].lo[j]);
            hi[j] = fmaxf(hi[j], (float)boxes[order[i]].hi[j]);
        }
    return sph_link_surface(lo, hi);
}

/* What the ball around some is met like. */
static float ball_area(const struct sph_ball *balls, const struct sph_profile *profile,
                       const uint32_t *order, uint32_t n) {
    double ball[4];
    sph_enclose(balls, order, n, ball);
    double r = ball[3] + sph_pair_margin(profile);
    return (float)(r * r);
}

void sph_split_fill(const struct sph_ball *balls, const struct sph_aabb *boxes,
                    const struct sph_profile *profile, struct sph_split *split) {
    for (uint32_t i = split->n_pairs; i-- > 0;) { /* children stand behind their parent */
        struct sph_pair *p = &split->pairs[i];
        const uint32_t *order = split->order + p->first;
        sph_pair_fill(split->pairs, p,
                      boxes ? box_area(boxes, order, p->count)
                            : ball_area(balls, profile, order, p->count));
    }
}
