/* better.h - a binary tree with fewer visits than its splits have
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TREE_BETTER_H
#define SPH_TREE_BETTER_H

#include "builder/tree/split.h"

enum { SPH_TREE_FEW = 8192 }; /* spheres of a tree that time is taken for */

/* Improves a split of n >= 2 spheres by reinsertion. Up to 8192 spheres it is the cheapest of the
 * splits, of the splits with reinsertion, and of two trees made from the leaves upwards, with
 * reinsertion too; with boxes it is the splits with reinsertion. The tree does not depend on the
 * number of threads. progress: of this, or NULL. -1 if memory is out. */
int sph_split_better(const struct sph_ball *balls, const struct sph_aabb *boxes, uint32_t n,
                     const struct sph_profile *profile, const struct sph_progress *progress,
                     struct sph_split *split, struct sph_error *err);

#endif
