/* emit.h - the parts of a machine that build fills one by one
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_EMIT_H
#define SPH_EMIT_H

#include "builder/tree/bih.h"
#include "builder/build.h"
#include "builder/grid/grid.h"
#include "builder/tree/tree.h"

/* Builds the tree that is asked for and writes it with one of the two below; *tree is one of four
 * children in any case, with a BIH and no background separation its root alone. Fills nodes, depth,
 * bih and tree_seconds of the report. */
int sph_emit_tree(const struct sph_scene *scene, const struct sph_build_options *o,
                  const struct sph_plants *plants, struct sph_tree *tree, struct sph_machine *m,
                  struct sph_build_report *report, struct sph_error *err);

/* Collapses the tree again by rays of the machine, where its binary tree was kept, and puts it into
 * the place of what was written. kept: as the tree's. -1 if memory or addresses are out. */
int sph_emit_learned(const struct sph_scene *scene, const struct sph_plants *plants,
                     struct sph_kept_tree *kept, struct sph_tree *tree, struct sph_machine *m,
                     struct sph_build_report *report, struct sph_error *err);

/* Writes nodes, leaf records and primitive records to machine->mem and the registers that tell
 * where they are; children are boxes if plants->kind is SPH_TREE_BOX4, else spheres. With facets
 * every leaf has a line of its own, and the table of facets follows. -1 if memory or addresses are
 * out, or a node's radius exceeds its field. */
int sph_emit_memory(const struct sph_scene *scene, const struct sph_plants *plants,
                    const struct sph_tree *tree, struct sph_machine *machine,
                    struct sph_error *err);

/* Puts another tree of the same primitives before all else that the machine has, of which nothing
 * tells its line but registers: there are no textures yet. -1 as above: then it is as it was. */
int sph_emit_again(const struct sph_scene *scene, const struct sph_plants *plants,
                   const struct sph_tree *tree, struct sph_machine *machine, struct sph_error *err);

/* The same with a bounding interval hierarchy, the global box and its leaf records, planes first;
 * what it is like goes to *stats. With one leaf (brute force) there is no box. kept: see refit.h.
 */
int sph_emit_bih(const struct sph_scene *scene, const struct sph_plants *plants,
                 const struct sph_bih_options *options, struct sph_kept_tree *kept,
                 struct sph_machine *machine, struct sph_bih_stats *stats, struct sph_error *err);

/* Its nodes from line 0 on, global box and the two registers of leaf records, n_loose of which
 * come first; memory has room for them, and TREE is set. */
void sph_emit_bih_nodes(const struct sph_bih *bih, uint32_t n_loose, struct sph_machine *m);

/* Parts of both: lines of zeros; primitive records from line `base` on, the table of facets and the
 * registers that tell where they are and how many nodes a ray can visit. */
int sph_emit_alloc(struct sph_machine *machine, uint64_t lines, struct sph_error *err);
void sph_emit_prims(const struct sph_scene *scene, const struct sph_ball *balls,
                    const struct sph_facets *facets, uint32_t base, uint32_t nodes,
                    struct sph_machine *machine);

/* The words of a material with Whitted's sum. */
void sph_emit_sum(uint32_t *line, const struct sph_material *material);

/* Ambient and background colours. */
void sph_emit_colours(const struct sph_scene *scene, struct sph_machine *machine);

/* Mirror weight of a material in 1/256 (0..256), and its colour weight: what rgb is multiplied
 * by so that (1 - kr/256) * colour = kd * rgb; 1 with Whitted's sum. */
int sph_material_kr(const struct sph_material *material);
int sph_material_kt(const struct sph_material *material); /* transmitted, the same */
int sph_material_ks(const struct sph_material *material); /* highlight in 1/255 */
double sph_material_weight(const struct sph_material *material);

/* Appends a printf-style line to text of `size` bytes; cut off where it does not fit. */
void sph_note(char *text, size_t size, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
