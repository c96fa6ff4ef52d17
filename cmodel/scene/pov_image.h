/* pov_image.h - images of a scene for POV-Ray; see pov_write.h
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_SCENE_POV_IMAGE_H
#define SPH_SCENE_POV_IMAGE_H

#include "scene/scene.h"

/* Declares the images, and what the pigments below stand for. POV-Ray opens them by the names that
 * the scene has, as seen from the folder where it runs. */
void sph_pov_images(const struct sph_scene *scene, FILE *file);

/* The pigment of a sphere or facet with a texture; scale: that of the file. */
void sph_pov_round(const struct sph_scene *scene, const struct sph_sphere *sphere, double scale,
                   FILE *file);
void sph_pov_flat(const struct sph_scene *scene, const struct sph_facet *facet, double scale,
                  FILE *file);

#endif
