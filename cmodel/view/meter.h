/* meter.h - how soon the live view answers, and how many pictures a second it shows
 * SPDX-License-Identifier: Apache-2.0
 *
 * An input is answered by the first picture that is shown with it: of one that moves the camera,
 * the first one drawn from there, coarse as it may be. Times in seconds.
 */
#ifndef SPH_VIEW_METER_H
#define SPH_VIEW_METER_H

#include <stdint.h>
#include <stdio.h>

enum { VIEW_WAITING = 256 }; /* inputs that wait for an answer, at most; others are not measured */

struct view_meter {
    struct {
        double time;
        uint64_t camera_changes; /* of the state after it */
    } waiting[VIEW_WAITING];
    int n;
    uint64_t answers, late, pictures; /* late: above VIEW_SOON; pictures while the camera moves */
    double sum, worst, last_input, last_picture, moving;
};

#define VIEW_SOON 0.1   /* what an answer takes at most, if all is well */
#define VIEW_STILL 0.25 /* without input: the camera does not move any more */

/* Seconds since some time. */
double view_now(void);

/* An input at a time, which led to this number of changes of the camera. */
void view_meter_input(struct view_meter *m, double time, uint64_t camera_changes);

/* A picture of the camera after so many changes is shown at a time. */
void view_meter_shown(struct view_meter *m, double time, uint64_t camera_changes);

/* A line of what was measured. */
void view_meter_print(const struct view_meter *m, FILE *to);

#endif
