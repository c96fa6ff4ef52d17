/* camera.h - how a machine's camera stands on its grid, for hosts: in doubles
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_MACHINE_CAMERA_H
#define SPH_MACHINE_CAMERA_H

#include "machine/machine.h"

struct sph_machine_camera {
    double axes[3][3]; /* right, up and back along the grid's axes, of length 1 */
    double screen;     /* its distance, in pixels */
};

struct sph_machine_camera sph_machine_camera(const struct sph_machine *m);

/* The distance of a direction's end before the eye, along the view. */
double sph_camera_ahead(const struct sph_machine_camera *camera, const int64_t dir[3]);

#endif
