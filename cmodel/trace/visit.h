/* visit.h - what a ray meets of the four children of a node           RTL: rtl/trace/rt_traverse.v
 * SPDX-License-Identifier: Apache-2.0
 *
 * Borodavka et al. IV. All children are filtered at once, with the depth that the ray has when it
 * comes. Which of them are visited, and when, is for traverse.h.
 */
#ifndef SPH_VISIT_H
#define SPH_VISIT_H

#include "machine/machine.h"
#include "trace/bih.h"
#include "core/ray.h"

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

#endif
