/* view.h - the camera as it is written, in double precision
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_REFERENCE_VIEW_H
#define SPH_REFERENCE_VIEW_H

#include "scene/scene.h"

struct sph_ref_view {
    double eye[3];
    double axes[3][3]; /* camera right, up, back in the scene's frame */
    double screen;     /* distance of the screen in pixels */
    int width, height;
};

/* The view of a frame of width x height pixels. 0 if the camera has no direction. */
int sph_ref_view_of(const struct sph_camera *camera, int width, int height,
                    struct sph_ref_view *view);

/* The direction of the ray through the middle of pixel x, y; a pixel's pitch is 1. */
void sph_ref_view_dir(const struct sph_ref_view *view, int x, int y, double dir[3]);

#endif
