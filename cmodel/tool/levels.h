/* levels.h - what `sphaera accuracy` tells of the levels of textures
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TOOL_LEVELS_H
#define SPH_TOOL_LEVELS_H

#include <jansson.h>
#include <stdio.h>

#include "reference/levels.h"

extern const char *const tool_level_names[]; /* SPH_LOD_*, then NULL */

/* Nothing if `to` is NULL or no pixel sees a texture. */
void print_levels(FILE *to, const struct sph_levels *e);

json_t *levels_json(const struct sph_levels *e);

json_t *report_flops(const struct sph_flops *flops);

/* Arithmetic of the ways to choose a level, by kind of primitive. */
json_t *level_work_json(const struct sph_level_work *work);

#endif
