/* traverse.h - one ray through the 4-ary tree of bounding spheres     RTL: rtl/trace/rt_traverse.v
 * SPDX-License-Identifier: Apache-2.0
 *
 * Borodavka et al. IV. Which nodes a ray visits depends on the ray alone: the leaves of a visit are
 * all tested before the next visit is chosen. Near children go first, and what lies deeper than the
 * best hit is left out. A shadow ray and a ray with `first` take children in the order of the node,
 * leave out none that the filter passes, and end after the first visit with a hit; among that
 * visit's leaves the smallest key wins, then the smaller id.
 */
#ifndef SPH_TRAVERSE_H
#define SPH_TRAVERSE_H

#include "core/frame.h"
#include "machine/machine.h"
#include "core/ray.h"

/* How primitives are found: through the tree, bit by bit as the RTL does; by testing every one for
 * the nearest hit, whatever effect FIRST says; or, of sph_render() and no way of sph_traverse(),
 * through the tree with the same results by fast/fast.h, or by packets of rays where they fit
 * (fast/tile.h), whose work nobody counts: visits of pixels are 0, counters are what they are. */
enum { SPH_TRAVERSE_TREE, SPH_TRAVERSE_BRUTE, SPH_TRAVERSE_FAST, SPH_TRAVERSE_PACKETS };

/* Traces a ray that was set up, through nodes of four children or a BIH (bih_walk.h), as TREE says;
 * adds to counters, to *visits and to the sticky *errors. A shadow ray reports any occluder (key
 * 1). how: SPH_TRAVERSE_*; brute force knows no `first`. */
struct sph_hit sph_traverse(const struct sph_machine *m, const struct sph_ray *ray, int how,
                            struct sph_counters *c, uint32_t *visits, uint32_t *errors);

#endif
