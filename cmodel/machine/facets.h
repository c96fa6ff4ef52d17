/* facets.h - what both build and validation know of the words of triangles and planes
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_MACHINE_FACETS_H
#define SPH_MACHINE_FACETS_H

#include "machine/machine.h"

/* Primitives of each kind. The machine must be valid. */
struct sph_counts {
    uint32_t spheres, triangles, planes;
};
struct sph_counts sph_machine_count(const struct sph_machine *m);

/* Registers alone: primitives that are facets, 0 without FACETS; the others are spheres. */
static inline int64_t sph_machine_facets(const struct sph_machine *m) {
    return sph_machine_effect(m, SPH_EFFECT_FACETS)
               ? (int64_t)m->regs[SPH_REG_N_PRIMS] - m->regs[SPH_REG_N_SPHERES]
               : 0;
}

/* The normal of a triangle of grid points (sW, W <= 24) as its primitive record has it:
 * (v1-v0) x (v2-v0), shifted so that the largest component fills 24 bits, sign included, and
 * rounded half away from zero. 0 if the corners are on one line: no normal, no area. */
int sph_triangle_normal(const int32_t (*v)[3], int32_t normal[3]);

/* The facets' part of sph_machine_validate, of a machine with FACETS: the table from FACET_BASE on,
 * and primitive records. 0, or -1 with a message. */
int sph_validate_facets(const struct sph_machine *m, struct sph_error *err);

/* The same of a leaf line in the tree: equal to its table line, or a sphere in the low half and
 * nothing else. *id: the primitive. */
int sph_validate_leaf_line(const struct sph_machine *m, uint32_t line, uint32_t *id,
                           struct sph_error *err);

#endif
