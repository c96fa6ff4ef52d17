/* pdb_frame.h - camera and lights for what has none
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_SCENE_PDB_FRAME_H
#define SPH_SCENE_PDB_FRAME_H

#include "scene/scene.h"

/* Points the camera (resolution set) along the thinnest principal axis of the centres, the
 * longest axis across, as near as keeps every sphere in view; adds two lights behind it to
 * left and right, ambient light and a dark background. At least one sphere. */
void sph_scene_frame(struct sph_scene *scene);

/* The same for triangles and spheres of which an axis is up, 'x', 'y' or 'z': seen from the front
 * and above. Of camera (angle above 0) and lights only what is not there yet is added. */
void sph_scene_frame_mesh(struct sph_scene *scene, char axis);

#endif
