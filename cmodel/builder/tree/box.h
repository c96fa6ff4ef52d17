/* box.h - boxes in a node's frame, outwards in integers of the grid; docs/design/bih.md
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_BUILD_BOX_H
#define SPH_BUILD_BOX_H

#include "builder/tree/tree.h"
#include "common/error.h"
#include "machine/machine.h"

/* A plane of a box, moved outwards by the error of a hit point: a ray may start that far outside of
 * the sphere that it is in. Beyond the ends of the grid nothing is. */
int32_t sph_outwards(const struct sph_profile *profile, int32_t plane, int up);

/* What a node must hold of primitive `id`: its box moved outwards, or all of the grid. */
void sph_box_of(const struct sph_plants *plants, uint32_t id, struct sph_aabb *box);

/* The boxes of a tree's nodes; malloc, NULL with a message if memory is out. */
struct sph_aabb *sph_box_nodes(const struct sph_plants *plants, const struct sph_tree *tree,
                               struct sph_error *err);

/* Writes frame and children of a node line: n <= 4 boxes within -2^(W-1) .. 2^(W-1), each of which
 * the written one holds. A step of an axis is the least that reaches from the origin to the end. */
void sph_box_put(uint32_t *line, const struct sph_aabb *boxes, int n,
                 const struct sph_profile *profile);

/* ---- the order in which shadow rays take the children of a node; docs/design/bih.md ---- */

/* Puts the inner children of each node of boxes into the order in which a sample of the machine's
 * own shadow rays finds a hit with the fewest visits; of equal ones the order stays. Any other
 * machine, and one whose rays end at the first hit that they find, stays as it is. The machine is
 * whole but for this. -1 if memory is out. */
int sph_box_order(struct sph_machine *machine, struct sph_error *err);

#endif
