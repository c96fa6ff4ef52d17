/* camera.h - how the camera of the live view moves
 * SPDX-License-Identifier: Apache-2.0
 *
 * Aroxa 2014, User Interaction: a finger moves the camera in the plane of the picture, two fingers
 * move it along the view. The rest is what a mouse and keys add. Doubles, as the scene is written:
 * the machine has no moving camera, it is built for one.
 */
#ifndef SPH_VIEW_CAMERA_H
#define SPH_VIEW_CAMERA_H

#include "scene/scene.h"

/* How far the camera is from what it looks at; scene units. */
double view_distance(const struct sph_camera *c);

/* Around the point that it looks at, by angles to its right and up. Neither this nor view_look()
 * comes closer to the pole, where up is along the view, than VIEW_POLE. */
#define VIEW_POLE 0.02 /* radians */
void view_orbit(struct sph_camera *c, double right, double up);

/* Turns where it stands, by angles to the right and up. */
void view_look(struct sph_camera *c, double right, double up);

/* Moves it, and what it looks at, in its own axes, scene units. */
void view_walk(struct sph_camera *c, double right, double up, double forward);

/* So that what lies at the distance of `at` moves in the picture by parts of the frame's height to
 * the right and down. */
void view_pan(struct sph_camera *c, double right, double down);

/* Changes its distance from what it looks at by a factor above 0. */
void view_near(struct sph_camera *c, double factor);

/* Changes what the picture holds by a factor above 0: the tangent of half the angle. The angle
 * stays within VIEW_NARROW to VIEW_WIDE degrees. */
#define VIEW_NARROW 1.0
#define VIEW_WIDE 120.0
void view_angle(struct sph_camera *c, double factor);

/* Puts the eye at another place before the screen through what the camera looks at, in parts of the
 * screen's height to the right of *at and above it; *at is there then. */
void view_head(struct sph_camera *c, double at[2], double right, double up);

/* Where a line from a to b lies in a picture of width x height pixels: ends[0..3] are x, y of both
 * ends, the parts behind the camera left out. 0 if all of it is, or the camera has no direction. */
int view_line(const struct sph_camera *c, int width, int height, struct sph_vec a, struct sph_vec b,
              double ends[4]);

#endif
