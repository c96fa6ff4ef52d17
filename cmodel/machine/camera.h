/* camera.h - how a machine's camera stands on its grid, for hosts: in doubles; and its sum
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_MACHINE_CAMERA_H
#define SPH_MACHINE_CAMERA_H

#include "machine/machine.h"

struct sph_machine_camera {
    double axes[3][3]; /* right, up and back along the grid's axes, of length 1 */
    double screen;     /* its distance, in pixels */
    double view[2];    /* column and row of the picture where the view meets it, from the middle of
                          pixel 0, 0; outside of the picture, maybe */
};

struct sph_machine_camera sph_machine_camera(const struct sph_machine *m);

/* The distance of a direction's end before the eye, along the view. */
double sph_camera_ahead(const struct sph_machine_camera *camera, const int64_t dir[3]);

/* The sum of the camera's registers, as machine.def has it of ONE_CAMERA. A change of one register
 * changes it, one of several all but once in 2^32. */
int32_t sph_camera_sum(const struct sph_machine *m);

/* 1 if the machine lacks what its own camera does not show, and its registers have another one: the
 * error LEFT_OUT. */
int sph_camera_strayed(const struct sph_machine *m);

#endif
