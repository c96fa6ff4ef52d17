/* window.h - the window of a screen that a camera's picture shows
 * SPDX-License-Identifier: Apache-2.0
 *
 * The screen is square to the view, which meets it anywhere: between the rays through the corners
 * of the picture lies an oblique frustum. So a screen may stay while the eye moves before it, and
 * several pictures may be tiles of a larger one (Borodavka et al. 2015, V.A: the viewpoint X_v,
 * Y_v of the projection).
 */
#ifndef SPH_SCENE_WINDOW_H
#define SPH_SCENE_WINDOW_H

#include "scene/scene.h"

/* The most that a picture is moved on its screen, in heights of the picture. */
#define SPH_SHIFT_MAX 64

/* Middles of pixels from where the view meets the screen, in pixels of the picture. */
struct sph_window {
    double left, top; /* of column 0 to the right, of row 0 upwards */
    double screen;    /* distance of the screen from the eye */
};

/* Of a picture of width x height pixels. */
struct sph_window sph_window_of(const struct sph_camera *camera, int width, int height);

/* A wall's columns and rows of pictures; 1 and 1 if the camera has none. */
int sph_wall_columns(const struct sph_camera *camera);
int sph_wall_rows(const struct sph_camera *camera);

/* Moves the eye, in scene units along the camera's axes, before a screen that stays: the one
 * through `at`. -1 with a message that starts with `where` if the eye comes to lie on the screen or
 * behind it, or sees the picture too far aside. */
int sph_camera_move_eye(struct sph_camera *camera, double right, double up, double back,
                        const char *where, struct sph_error *err);

/* What a user changes of a scene's camera; all zero: nothing. */
struct sph_aim {
    int shifted;             /* shift counts */
    double shift[2], eye[3]; /* as of sph_camera; right, up, back of sph_camera_move_eye() */
    struct sph_wall wall;
};
int sph_camera_aim(const struct sph_aim *aim, struct sph_camera *camera, const char *where,
                   struct sph_error *err);

#endif
