/* texture.h - mapping records and images into the machine's memory
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_BUILD_TEXTURE_H
#define SPH_BUILD_TEXTURE_H

#include "builder/build.h"
#include "builder/grid/grid.h"
#include "builder/tree/tree.h"

/* Appends a mapping record for every way that an image lies on a primitive, and the images that are
 * used, each once; sets the primitives' tex, the effect TEXTURE and TEX_FILTER. Facets are read
 * from their leaf lines: the last thing to be put into memory. A machine without textures stays as
 * it is. -1 with "file:line: ..." if images were not given, a mapping does not fit its formats, or
 * memory or addresses are out. */
int sph_emit_textures(const struct sph_scene *scene, const struct sph_grid *grid,
                      const struct sph_plants *plants, const struct sph_build_options *options,
                      struct sph_machine *machine, struct sph_build_report *report,
                      struct sph_error *err);

/* ---- how spheres spread the rays that leave them, for levels of textures ---- */

/* Of a sphere with that radius, grid units, at least 1: 3 + 2 log2(radius), to nearest. */
uint32_t sph_bend_of(int64_t radius);

/* Behind textures and all other effects: SPREAD if there is an image and a sphere that rays leave;
 * then the bend of each of these. Tells in report->effects, warns of what is called for and off. */
void sph_emit_spread(const struct sph_scene *scene, const struct sph_plants *plants,
                     const struct sph_build_options *options, struct sph_machine *machine,
                     struct sph_build_report *report);

#endif
