/* split.h - the binary tree that balanced.c collapses to nodes of four
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TREE_SPLIT_H
#define SPH_TREE_SPLIT_H

#include "builder/tree/tree.h"
#include "builder/tree/visibility_samples.h"

#define SPH_PAIR_LEAF 0x80000000u /* a binary child that is one sphere */

struct sph_pair {          /* node of the binary tree */
    uint32_t first, count; /* its spheres: order[first..first+count-1] */
    uint32_t child[2];     /* pair index, or SPH_PAIR_LEAF | sphere index */
    float cost[4];         /* least expected visits as at most [j] children; [0]: inside a node */
    int levels[4];         /* least levels of nodes, in the same way; they may cost more */
};

struct sph_split {
    struct sph_pair *pairs; /* root first */
    uint32_t n_pairs;
    uint32_t *order;
};

/* Splits n >= 2 spheres by the surface-area heuristic; where a branch would grow deeper than
 * `limit` binary levels it is split in half. boxes: those that a tree of boxes is made of, or NULL.
 * progress: of this, or NULL. -1 if memory is out. */
int sph_split(const struct sph_ball *balls, const struct sph_aabb *boxes, uint32_t n, int limit,
              const struct sph_progress *progress, struct sph_split *split, struct sph_error *err);

/* Fills costs and levels of all pairs of a split of balls, or of boxes unless NULL. */
void sph_split_fill(const struct sph_ball *balls, const struct sph_aabb *boxes,
                    const struct sph_profile *profile, struct sph_split *split);

void sph_split_free(struct sph_split *split);

/* The cost of a binary child that may become j = 1..3 children; spheres cost nothing here. */
static inline float sph_pair_cost(const struct sph_pair *pairs, uint32_t child, int j) {
    return child & SPH_PAIR_LEAF ? 0 : pairs[child].cost[j];
}

static inline int sph_pair_levels(const struct sph_pair *pairs, uint32_t child, int j) {
    return child & SPH_PAIR_LEAF ? 0 : pairs[child].levels[j];
}

/* Divides j = 2..4 children among the two halves of a pair: the first half's share of the
 * cheapest way that needs at most `most` levels of nodes, and its cost; infinite if none does. */
int sph_pair_share(const struct sph_pair *pairs, const struct sph_pair *p, int j, int most,
                   float *cost);

/* Fills cost[] and levels[] of a pair whose children are done; area: what its ball or box is met
 * like. */
void sph_pair_fill(const struct sph_pair *pairs, struct sph_pair *p, float area);

/* What the radius of a node in memory may be more than that of its ball, grid units. */
double sph_pair_margin(const struct sph_profile *profile);

/* ---- a binary tree with fewer visits than its splits have ---- */

enum { SPH_TREE_FEW = 8192 }; /* spheres of a tree that time is taken for */

/* Improves a split of n >= 2 spheres by reinsertion. Up to 8192 spheres it is the cheapest of the
 * splits, of the splits with reinsertion, and of two trees made from the leaves upwards, with
 * reinsertion too; with boxes it is the splits with reinsertion. The tree does not depend on the
 * number of threads. progress: of this, or NULL. -1 if memory is out. */
int sph_split_better(const struct sph_ball *balls, const struct sph_aabb *boxes, uint32_t n,
                     const struct sph_profile *profile, const struct sph_progress *progress,
                     struct sph_split *split, struct sph_error *err);

/* ---- a binary tree of boxes whose nodes change places by the rays that meet them ---- */

/* Rotates nodes of a split of n >= 2 boxes where fewer rays meet them then, and fills the costs by
 * areas; leaves the split as it is if it would need more than `most` levels of nodes. unseen: see
 * seen.h. Does not depend on the number of threads. -1 if memory is out. */
int sph_split_rotate(const struct sph_ball *balls, const struct sph_aabb *boxes,
                     const struct sph_visibility_samples *samples, float unseen, int most,
                     struct sph_split *split, struct sph_error *err);

/* ---- what a binary tree costs as nodes of four, by rays of the frame ---- */

#define SPH_UNSEEN 0.0625f /* what areas count for beside rays */

/* sph_split_fill() of a tree where a pair is met by as many rays as are in sight. Does not depend
 * on the number of threads. -1 if memory is out. */
int sph_split_seen(const struct sph_ball *balls, const struct sph_aabb *boxes,
                   const struct sph_profile *profile, const struct sph_visibility_samples *samples,
                   struct sph_split *split, struct sph_error *err);

#endif
