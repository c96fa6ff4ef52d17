/* pov_write.h - a scene for POV-Ray 3.7, which draws it without anything of this project
 * SPDX-License-Identifier: Apache-2.0
 *
 * Shading is that of docs/design/shading.md, in linear light; what POV-Ray cannot
 * say stands in docs/results/accuracy.md. Three names may be declared on POV-Ray's command line:
 *   Reflections   rays one after another, as max_depth
 *   Whole         1: what surfaces have of their own is not lessened by their mirrors
 *   Ids           1: each primitive in a flat colour, its number; background 0xffffff
 */
#ifndef SPH_SCENE_POV_WRITE_H
#define SPH_SCENE_POV_WRITE_H

#include "scene/scene.h"

struct sph_pov_options {
    int width, height; /* of the picture that the camera is for; 0: as the scene says */
    int max_depth;     /* reflections and refractions one after another */
};

/* Writes the scene. 0, or -1 with a message. */
int sph_scene_write_pov(const struct sph_scene *scene, const struct sph_pov_options *options,
                        FILE *file, struct sph_error *err);

#endif
