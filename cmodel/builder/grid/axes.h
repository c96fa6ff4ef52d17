/* axes.h - which axes the grid has
 * SPDX-License-Identifier: Apache-2.0
 *
 * In the camera's axes a pixel is the same step of one component of the direction for all rays, and
 * background can be separated. Walls and furniture stand along the scene's axes, and there a box
 * holds them with less around it; rays then ask for the effect TURNED. Spheres do not care.
 */
#ifndef SPH_AXES_H
#define SPH_AXES_H

#include "scene/scene.h"

struct sph_build_options;

enum { SPH_AXES_AUTO = -1, SPH_AXES_CAMERA = 0, SPH_AXES_SCENE = 1 };

/* Rows of the scene's own axes. */
extern const double sph_scene_axes[9];

/* The camera's axes in the scene's frame, as rows x (to the right), y (up) and z: it looks along
 * -z. -1 if it has none. */
int sph_camera_axes(const struct sph_scene *scene, double rows[9], struct sph_error *err);

/* SPH_AXES_CAMERA or SPH_AXES_SCENE: as asked, or for SPH_AXES_AUTO the scene's if the tree has
 * boxes or is a BIH, no background is separated, and around the primitives boxes along them have
 * less than seven eighths of the surface that boxes along the camera's have. */
int sph_axes_of(const struct sph_scene *scene, const struct sph_build_options *o);

#endif
