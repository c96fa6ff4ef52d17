/* live.h - what the parts of a running view share
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_VIEW_LIVE_H
#define SPH_VIEW_LIVE_H

#include "view/maker.h"
#include "view/meter.h"
#include "view/pick.h"
#include "view/record.h"
#include "view/screen.h"
#include "view/script.h"
#include "view/state.h"
#include "view/view.h"

struct view {
    const struct view_options *o;
    struct sph_scene scene; /* with the camera as it is now; shares everything else */
    const struct view_screen_calls *calls;
    struct view_screen *screen;
    struct view_state state;
    struct view_workers *workers;
    struct view_maker *builder, *truths, *prices;
    struct view_meter meter;
    struct view_record *record;
    uint8_t *srgb;

    struct view_made *made;        /* the newest machine, NULL before the first */
    struct view_made *truth;       /* the newest reference, NULL: none */
    struct view_made *price;       /* the newest measure, NULL: none */
    uint64_t bad_camera;           /* camera_changes that no machine could be built for */
    uint64_t bad_truth, bad_price; /* the same of the reference, of a measure */

    struct view_job job;            /* what the workers draw, or have drawn */
    struct sph_camera seen;         /* its camera */
    uint64_t job_camera, job_build; /* changes that it stands for; 0: there is none */
    int exact;                      /* it is drawn as the hardware would */
    int shown;                      /* passes of it that were shown; 0 before its first picture */
    double started, last;           /* when it was started; when a picture was shown */
    int redraw;                     /* the layer or what lies over the picture is another one */

    uint32_t *picture, *over; /* without and with the rays over it */
    uint32_t *under;          /* a picture of the same camera, to start with */
    int keep_under;
    struct view_rays rays;

    struct view_script script;
    int at, failed;            /* the next command of it; err is set */
    double due, began;         /* when it is due; of one that takes a while: when it began, or 0 */
    double input;              /* the time that inputs count from: due, of a script */
    double mouse[2], glide[2]; /* of a script: where the mouse is; where a motion began */
    struct sph_error *err;
};

/* work.c: takes what makers have made, asks them for more, starts jobs. */
void view_work(struct view *v, double now);

/* Whether what a maker has made is of the state as it is; made may be NULL. */
int view_stands(const struct view *v, const struct view_made *made);

/* Whether the picture is that of the hardware, wholly drawn and shown, and what is asked for beside
 * it known. */
int view_refined(const struct view *v);

/* show.c: shows a picture if one is due. */
void view_show(struct view *v, double now);
void view_click(struct view *v);

/* play.c: does what is due of the script. */
void view_play(struct view *v, double now);

#endif
