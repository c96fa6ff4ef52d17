/* motion.h - primitives that move and grow, and a camera that flies, from frame to frame
 * SPDX-License-Identifier: Apache-2.0
 *
 * A scene as it is read stands at frame 0, at rest.
 */
#ifndef SPH_SCENE_MOTION_H
#define SPH_SCENE_MOTION_H

#include "scene/scene.h"

#define SPH_MAX_FRAME 65535u

/* Adds a motion at the end. -1 with a message if memory is short. */
int sph_scene_add_motion(struct sph_scene *scene, const struct sph_motion *motion,
                         struct sph_error *err);

/* Adds a place of the camera at the end. -1 with "file:line: ..." if its frame is not after that of
 * the one before, or memory is short. */
int sph_scene_add_flight(struct sph_scene *scene, const struct sph_flight *flight,
                         struct sph_error *err);

/* Could a camera stand at all these places? -1 with "file:line: ..." if not. */
int sph_scene_check_flights(const struct sph_scene *scene, struct sph_error *err);

/* Moves the camera from rest to a frame: its eye and the point it looks at go along Kochanek and
 * Bartels' curve (spline.h) through their places, and stay at the last one. -1 with a message if
 * no camera can stand there, or memory is short. */
int sph_scene_fly(struct sph_scene *scene, uint32_t frame, struct sph_error *err);

/* Moves what moves from rest to a frame: centres, radii, corners, points of planes and the size of
 * one repeat there, and the camera. -1 with "file:line: ..." if nothing is left of a primitive, its
 * numbers are too large for a file, two spheres become the same, or there is no such view. */
int sph_scene_move(struct sph_scene *scene, uint32_t frame, struct sph_error *err);

/* A copy of a scene at rest, moved to a frame: shares with it all but spheres and facets; one of
 * AFF is read again, and shares nothing.
 * sph_scene_at_free() gives back what is its own. 0, or -1 with a message and nothing to free. */
int sph_scene_at(const struct sph_scene *rest, uint32_t frame, struct sph_scene *moved,
                 struct sph_error *err);
void sph_scene_at_free(struct sph_scene *moved);

#endif
