/* seen.h - what a binary tree costs as nodes of four, by rays of the frame
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TREE_SEEN_H
#define SPH_TREE_SEEN_H

#include "builder/tree/visibility_samples.h"
#include "builder/tree/split.h"

#define SPH_UNSEEN 0.0625f /* what areas count for beside rays */

/* sph_split_fill() of a tree where a pair is met by as many rays as are in sight. Does not depend
 * on the number of threads. -1 if memory is out. */
int sph_split_seen(const struct sph_ball *balls, const struct sph_aabb *boxes,
                   const struct sph_profile *profile, const struct sph_visibility_samples *samples,
                   struct sph_split *split, struct sph_error *err);

#endif
