/* nesting.h - what is around glass: a sphere within another bends against the other's index
 * SPDX-License-Identifier: Apache-2.0
 *
 * Rule: docs/design/shading.md, *Nesting*. Spheres whose surroundings are no vacuum get
 * materials of their own, at the end of the list; sum.of says of which they are made.
 */
#ifndef SPH_SCENE_NESTING_H
#define SPH_SCENE_NESTING_H

#include "scene/scene.h"

/* Whether rays go through a material. */
int sph_material_clear(const struct sph_material *material);

/* Index of refraction inside of a sphere of this material; and inside over outside. */
double sph_index_inside(const struct sph_material *material);
double sph_index_ratio(const struct sph_material *material);

/* The material of a hollow sphere, of negative radius, whose scene has `material` for it: made if
 * the newest is not of that. -1 with a message if memory is short. */
int sph_scene_hollow(struct sph_scene *scene, uint32_t *material, struct sph_error *err);

/* Finds what each transparent sphere lies in, as the scene stands now. -1 with "file:line: ..." if
 * the ratio of two indices is beyond what a machine has, or memory is short. */
int sph_scene_nest(struct sph_scene *scene, struct sph_error *err);

#endif
