/* pov_surface.h - materials of a scene for POV-Ray; see pov_write.h
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_SCENE_POV_SURFACE_H
#define SPH_SCENE_POV_SURFACE_H

#include "scene/scene.h"

/* A number, and a vector of three: `<x,y,z>`; every double survives. */
void sph_pov_number(FILE *file, double value);
void sph_pov_vector(FILE *file, const double v[3]);

/* Declares what Look(material, id), Inside(material) and Shade() of the primitives stand for. */
void sph_pov_surfaces(const struct sph_scene *scene, FILE *file);

#endif
