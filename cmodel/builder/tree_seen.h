/* tree_seen.h - what a binary tree costs as nodes of four, by rays of the frame
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TREE_SEEN_H
#define SPH_TREE_SEEN_H

#include "builder/tree_split.h"
#include "machine/machine.h"

/* sph_split_fill() of the tree that the machine was made with, where a pair is met by as many rays
 * as its sample has. Does not depend on the number of threads. -1 if memory is out. */
int sph_split_seen(const struct sph_ball *balls, const struct sph_aabb *boxes,
                   const struct sph_machine *machine, struct sph_split *split,
                   struct sph_error *err);

#endif
