/* rotate.h - a binary tree of boxes whose nodes change places by the rays that meet them
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TREE_ROTATE_H
#define SPH_TREE_ROTATE_H

#include "builder/tree/visibility_samples.h"
#include "builder/tree/split.h"

/* Rotates nodes of a split of n >= 2 boxes where fewer rays meet them then, and fills the costs by
 * areas; leaves the split as it is if it would need more than `most` levels of nodes. unseen: see
 * seen.h. Does not depend on the number of threads. -1 if memory is out. */
int sph_split_rotate(const struct sph_ball *balls, const struct sph_aabb *boxes,
                     const struct sph_visibility_samples *samples, float unseen, int most,
                     struct sph_split *split, struct sph_error *err);

#endif
