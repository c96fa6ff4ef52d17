/* traverse.h - one ray through the 4-ary tree of bounding spheres
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
#include "core/ray.h"
#include "machine/machine.h"
#include "trace/bih.h"

/* ---- what a ray meets of the four children of a node (RTL: rtl/trace/rt_traverse.v) ---- */
/* Borodavka et al. IV. All children are filtered at once, with the depth that the ray has when it
 * comes. Which of them are visited, and when, is for traverse.h. */

/* Inner children to visit, in order: the near ones first, equal ones as the node has them; all as
 * the node has them if any hit will do. */
struct sph_siblings {
    uint32_t base; /* line of child 0 of the node */
    int count;
    struct {
        uint8_t child;
        int32_t near; /* s16, least depth that the child reaches */
    } list[4];
};

/* What a visit finds. */
struct sph_found {
    struct sph_siblings inner;
    uint32_t leaves; /* bit j: leaf child j is to be tested */
    uint32_t line;   /* of leaf child 0 */
    uint32_t tests;  /* children of the node */
};

/* Tests the children of the node in line `node`, which exists, against a ray that was set up: their
 * spheres, or with `bih`, the same ray set up for planes, their boxes. Those of a sph_ray_any()
 * keep the order of the node: all are at the least depth. Returns 0, and *found is of no use, if
 * the node has more than four children or they do not end in memory. */
int sph_visit(const struct sph_machine *m, const struct sph_ray *ray, const struct sph_bih_ray *bih,
              uint32_t node, int32_t depth_max, struct sph_found *found);

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
