/* world.h - where the grid of a machine ends in the scene, and what that does to a plane's light
 * SPDX-License-Identifier: Apache-2.0
 *
 * A ray that meets a plane farther than the grid is shaded where it leaves the grid along its
 * longest axis (docs/design/primitives.md). It sees the plane all the same; lights are in other
 * directions from there.
 */
#ifndef SPH_WORLD_H
#define SPH_WORLD_H

#include "machine/machine.h"
#include "scene/window.h"

/* ---- the camera as it is written, in double precision ---- */

struct sph_ref_view {
    double eye[3];
    double axes[3][3]; /* camera right, up, back in the scene's frame */
    struct sph_window window;
    int width, height;
};

/* The view of a frame of width x height pixels. 0 if the camera has no direction. */
int sph_ref_view_of(const struct sph_camera *camera, int width, int height,
                    struct sph_ref_view *view);

/* The direction of the ray through the middle of pixel x, y; a pixel's pitch is 1. */
void sph_ref_view_dir(const struct sph_ref_view *view, int x, int y, double dir[3]);

struct sph_ends {
    const double *rotation, *origin; /* as of a machine */
    double step, half;               /* scene units; grid units, 2^(W-1) */
};

struct sph_ends sph_ends_of(const struct sph_machine *machine);

/* How many times dir it is from org, a point on the grid, to where the machine ends the ray. */
double sph_ends_at(const struct sph_ends *ends, const double org[3], const double dir[3]);

/* The angle, in radians, by which the light turns most on a plane that is met at t * dir: 0 unless
 * that is beyond the grid. */
double sph_ends_turn(const struct sph_ends *ends, const struct sph_scene *scene,
                     const double org[3], const double dir[3], double t);

/* By how many of 255 levels the light of a white plane there is off, at most. */
double sph_ends_levels(const struct sph_ends *ends, const struct sph_scene *scene,
                       const double org[3], const double dir[3], double t);

/* Whether that is more than a few levels, as pictures are judged by; an image is elsewhere too. */
int sph_ends_show(const struct sph_ends *ends, const struct sph_scene *scene,
                  const struct sph_facet *plane, const double org[3], const double dir[3],
                  double t);

#endif
