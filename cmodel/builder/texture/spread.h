/* spread.h - how spheres spread the rays that leave them, for levels of textures
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_BUILD_SPREAD_H
#define SPH_BUILD_SPREAD_H

#include "builder/build.h"
#include "builder/tree/tree.h"

/* Of a sphere with that radius, grid units, at least 1: 3 + 2 log2(radius), to nearest. */
uint32_t sph_bend_of(int64_t radius);

/* Behind textures and all other effects: SPREAD if there is an image and a sphere that rays leave;
 * then the bend of each of these. Tells in report->effects, warns of what is called for and off. */
void sph_emit_spread(const struct sph_scene *scene, const struct sph_plants *plants,
                     const struct sph_build_options *options, struct sph_machine *machine,
                     struct sph_build_report *report);

#endif
