/* maker.h - a thread that builds machines, draws the double reference or measures, while the view
 * goes on SPDX-License-Identifier: Apache-2.0
 *
 * One thing at a time, which cannot be broken off: the owner asks for the newest when it is done.
 * The thread has less of the processors than what draws.
 */
#ifndef SPH_VIEW_MAKER_H
#define SPH_VIEW_MAKER_H

#include "builder/build.h"
#include "fast/fast.h"
#include "view/paint.h"

/* What a frame is worth and costs: a row of `sphaera price`. */
struct view_price {
    double psnr, cycles; /* dB against double precision; clocks a pixel */
    uint64_t wrong;      /* of the pixels that are looked at */
    const char *limit;   /* the unit that binds longest */
};

struct view_made {
    struct sph_camera camera; /* what for */
    struct sph_build_options build;
    uint64_t camera_changes, build_changes;
    int failed; /* with err; else one of the three below is there */
    struct sph_error err;
    struct sph_machine machine;
    struct sph_fast *fast; /* the machine's; NULL: it is drawn literally */
    struct view_truth *truth;
    struct view_price price;
    double seconds;
    struct view_made *before; /* of the owner: a list */
};

struct view_maker;

/* What a maker makes: a machine for *made, its truth, or its price. The scene and its images stay
 * as they are. */
typedef void view_make(const struct sph_scene *scene, struct view_made *made);
view_make view_make_machine, view_make_truth, view_make_price;

/* NULL if no thread can be started. */
struct view_maker *view_maker_new(const struct sph_scene *scene, view_make *make);

/* Leaves it. What it is making goes on until the process ends: the scene must last as long. 1 if
 * there is such a thing. */
int view_maker_free(struct view_maker *maker);

int view_maker_busy(struct view_maker *maker);

/* Asks for something, of which the first four fields say what; it must not be busy. 0, or -1
 * without memory. */
int view_maker_ask(struct view_maker *maker, const struct view_made *want);

/* What is made, once; NULL if there is nothing. */
struct view_made *view_maker_take(struct view_maker *maker);

void view_made_free(struct view_made *made);

#endif
