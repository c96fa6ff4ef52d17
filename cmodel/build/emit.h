/* emit.h - the parts of a machine that build fills one by one
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_EMIT_H
#define SPH_EMIT_H

#include "build/build.h"
#include "build/grid.h"
#include "build/tree.h"

/* Writes nodes, leaf records and primitive records to machine->mem and the registers that tell
 * where they are; balls[id]. With facets every leaf has a line of its own, and the table of facets
 * follows. -1 if memory or addresses are out, or a node's radius exceeds its field. */
int sph_emit_memory(const struct sph_scene *scene, const struct sph_ball *balls,
                    const struct sph_facets *facets, const struct sph_tree *tree,
                    struct sph_machine *machine, struct sph_error *err);

/* Writes the leaf line of a facet, and the part of its primitive record that a sphere's leaf record
 * has elsewhere. */
void sph_emit_facet(uint32_t *line, const struct sph_grid_facet *facet, uint32_t id);
void sph_emit_facet_prim(uint32_t *line, const struct sph_grid_facet *facet, uint32_t id);

/* Ambient and background colours. Appends to report->warning what had to be clamped. */
void sph_emit_colours(const struct sph_scene *scene, struct sph_machine *machine,
                      struct sph_build_report *report);

/* Mirror weight of a material in 1/256 (0..256), and its colour weight: what rgb is multiplied
 * by so that (1 - kr/256) * colour = kd * rgb. */
int sph_material_kr(const struct sph_material *material);
double sph_material_weight(const struct sph_material *material);

/* Appends a printf-style line to text of `size` bytes; cut off where it does not fit. */
void sph_note(char *text, size_t size, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
