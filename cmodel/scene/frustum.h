/* frustum.h - cones and cylinders as triangles
 * SPDX-License-Identifier: Apache-2.0
 *
 * NFF: a surface without endcaps, between two circles around an axis; if both radii are negative
 * its inside is the side that is meant. It becomes a ring of flat quadrangles, or of triangles
 * where a radius is 0. Corners lie on the surface, and neighbours share theirs to the last bit.
 */
#ifndef SPH_SCENE_FRUSTUM_H
#define SPH_SCENE_FRUSTUM_H

#include "scene/scene.h"

/* No point of the triangles is farther from the surface than this part of the larger radius, if
 * nothing else is asked for: rings of 32. */
#define SPH_FRUSTUM_ROUND 0.005
#define SPH_FRUSTUM_ROUND_MIN 1e-6
#define SPH_FRUSTUM_ROUND_MAX 0.5

/* The fewest sides, at least 3, of a ring that keeps `round`: 1 - cos(pi / sides) <= round. */
int sph_frustum_sides(double round);

/* Adds the triangles of a cone, normals outwards or, with negative radii, inwards; each side is a
 * group of its own from *n_groups on. Of look, material, motion and line count; keeps the cone in
 * the scene. -1 with a message ("file:line: `c`: ...") if it has no axis or no surface, its radii
 * have different signs, or there are too many triangles. */
int sph_scene_add_frustum(struct sph_scene *scene, const struct sph_frustum *cone, double round,
                          const struct sph_facet *look, uint32_t *n_groups, struct sph_error *err);

#endif
