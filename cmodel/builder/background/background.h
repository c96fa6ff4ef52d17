/* background.h - background separation: which pixels are traced, as registers and memory words
 * SPDX-License-Identifier: Apache-2.0
 *
 * Borodavka et al. V. docs/results/effects.md compares the ways and proves that none loses a
 * hit.
 */
#ifndef SPH_BUILD_BACKGROUND_H
#define SPH_BUILD_BACKGROUND_H

#include "builder/build.h"
#include "builder/grid/grid.h"
#include "builder/tree/tree.h"

enum { SPH_BG_LEVELS = 2 }; /* 4^2 spheres are MAX_CONES */

/* The spheres that exact separation takes: the root for level 0, its children for level 1, theirs
 * for level 2; a leaf stays itself. Grid units. Returns how many, at most SPH_MAX_CONES. */
int sph_background_balls(const struct sph_tree *tree, const struct sph_ball *balls,
                         const struct sph_profile *profile, int level, struct sph_ball *out);

/* Sets BG_* and RECT_*, and appends the table of spans or cones to memory; *report says how it
 * went. Registers of frame, eye and rays must be set, and memory be written. -1 if memory is
 * out. */
int sph_emit_background(const struct sph_tree *tree, const struct sph_ball *balls,
                        const struct sph_rays *rays, const struct sph_build_options *options,
                        struct sph_machine *machine, struct sph_build_report *report,
                        struct sph_error *err);

#endif
