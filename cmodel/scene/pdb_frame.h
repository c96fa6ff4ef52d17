/* pdb_frame.h - camera and lights for a cloud of spheres
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_SCENE_PDB_FRAME_H
#define SPH_SCENE_PDB_FRAME_H

#include "scene/scene.h"

/* Points the camera (resolution set) along the thinnest principal axis of the centres, the
 * longest axis across, as near as keeps every sphere in view; adds two lights behind it to
 * left and right, ambient light and a dark background. At least one sphere. */
void sph_scene_frame(struct sph_scene *scene);

#endif
