/* smooth.h - records of interpolated normals into the machine's memory
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_BUILD_SMOOTH_H
#define SPH_BUILD_SMOOTH_H

#include "builder/build.h"
#include "builder/grid/grid.h"
#include "builder/tree/tree.h"

/* Whether a triangle has normals and one of them is not its own: cosine below 1 - 2^-20. */
int sph_smooth_bends(const struct sph_facet *facet);

/* The record of the normals n (camera axes, any length) at the corners v (grid units) of a triangle
 * with the normal `own`. 0 if no record holds them: they turn too far within a unit of the grid, or
 * the middle of its box is too far from a sliver. */
int sph_smooth_put(const struct sph_profile *profile, const int32_t v[3][3], const int32_t own[3],
                   const double n[3][3], uint32_t *record);

/* With the effect SMOOTH appends a record for each triangle whose normals bend, sets the
 * primitives' smooth and SMOOTH_BASE, and notes in report->warning how many triangles stay flat. -1
 * if memory or addresses are out. */
int sph_emit_smooth(const struct sph_scene *scene, const struct sph_grid *grid,
                    const struct sph_plants *plants, struct sph_machine *machine,
                    struct sph_build_report *report, struct sph_error *err);

#endif
