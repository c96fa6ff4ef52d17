/* prims.h - primitives of a machine: how many of each kind, and whether their words are sound
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_MACHINE_PRIMS_H
#define SPH_MACHINE_PRIMS_H

#include "machine/machine.h"

/* Primitives of each kind. The machine must be valid. */
struct sph_counts {
    uint32_t of[SPH_KINDS];
    uint32_t loose; /* of those without bounds */
};
struct sph_counts sph_machine_count(const struct sph_machine *m);

/* "91 spheres, 2 triangles, 1 plane": those that there are, spheres in any case. */
void sph_counts_text(const struct sph_counts *counts, char *text, size_t size);

/* Registers alone: primitives that are facets, 0 without FACETS; the others are spheres. */
static inline int64_t sph_machine_facets(const struct sph_machine *m) {
    return sph_machine_effect(m, SPH_EFFECT_FACETS)
               ? (int64_t)m->regs[SPH_REG_N_PRIMS] - m->regs[SPH_REG_N_SPHERES]
               : 0;
}

/* A part of sph_machine_validate, of a machine with FACETS: the table from FACET_BASE on, and
 * primitive records. 0, or -1 with a message. */
int sph_validate_facets(const struct sph_machine *m, struct sph_error *err);

/* Checks the leaf record `record` of line `line` in the tree: as the table has it, or as the
 * primitive record. *id: the primitive. 0, or -1 with a message. */
int sph_validate_leaf(const struct sph_machine *m, uint32_t line, const uint32_t *record,
                      uint32_t *id, struct sph_error *err);

#endif
