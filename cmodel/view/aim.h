/* aim.h - a picture from another place than the one that a machine was built for
 * SPDX-License-Identifier: Apache-2.0
 *
 * A machine is built for the place and axes of its camera, so that one that turns asks for another
 * machine, and hardware has no other way. To build one takes up to seconds. Until it is there, the
 * view sends rays through the machine that it has: with the same arithmetic, but directions that
 * are turned in doubles and rounded, which the hardware cannot make.
 */
#ifndef SPH_VIEW_AIM_H
#define SPH_VIEW_AIM_H

#include "machine/machine.h"
#include "reference/world.h"

struct view_aim {
    int turned; /* 0: the machine's own rays */
    struct sph_ref_view view;
    double rows[3][3]; /* grid directions of the view's axes right, up, back: [i] is grid axis i */
    int32_t eye[3];    /* grid units */
};

/* The machine's own rays. */
struct view_aim view_aim_own(const struct sph_machine *m);

/* The rays of a camera through a machine of another. -1 if it has no direction, or stands outside
 * of the machine's grid. */
int view_aim_at(const struct sph_machine *m, const struct sph_camera *camera, struct view_aim *aim);

/* *copy, which shares the machine's memory, becomes the machine that draws pixels by this aim:
 * traced all of them, from everywhere. */
void view_aim_start(const struct sph_machine *m, const struct view_aim *aim,
                    struct sph_machine *copy);

/* Lets the primary ray of pixel x, y of the copy be the one of the aim. */
void view_aim_pixel(const struct view_aim *aim, int x, int y, struct sph_machine *copy);

#endif
