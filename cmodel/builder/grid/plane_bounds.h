/* plane_bounds.h - how large a grid planes ask for, which have no end
 * SPDX-License-Identifier: Apache-2.0
 *
 * Beyond the grid a plane is lit as where the ray leaves the grid (docs/design/builder.md). Planes
 * that close a room around the eye are seen no farther than its corners; of others the grid should
 * hold so much that nobody sees the difference.
 */
#ifndef SPH_PLANE_BOUNDS_H
#define SPH_PLANE_BOUNDS_H

#include "machine/layout.h"
#include "scene/scene.h"

/* Corners that so many planes may have. */
enum { SPH_CORNERS = SPH_MAX_PLANES * (SPH_MAX_PLANES - 1) * (SPH_MAX_PLANES - 2) / 6 };

/* Corners of the room that planes close around the eye, seen from the eye; 0: it is open. */
int sph_plane_bounds_corners(const struct sph_scene *scene, struct sph_vec corners[SPH_CORNERS]);

/* How far from the eye the grid should go, in units of the scene.
 *
 * Let eye and light be he and hl above a plane, and let the grid end R away. Of a frame that looks
 * along the plane, he / (2 R tan(angle/2)) of the height shows it farther than R; and its cosine
 * with the light is between 0 and hl / R there: the colour is off by less than I hl / R of white.
 * The square of that over the whole frame is that of 50 dB, 10^-5, if
 *
 *     R^3 = 10^5 he hl^2 I^2 / (2 tan(angle/2)). */
double sph_plane_bounds_reach(const struct sph_scene *scene);

#endif
