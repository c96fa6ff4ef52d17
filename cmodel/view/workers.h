/* workers.h - threads that draw the pixels of a job, coarse ones first
 * SPDX-License-Identifier: Apache-2.0
 *
 * Passes of a step of 256, 128 .. 1 pixels; each draws what the passes before it left. A job ends
 * when all is drawn or another one is started. One thread, the owner, calls all functions here.
 */
#ifndef SPH_VIEW_WORKERS_H
#define SPH_VIEW_WORKERS_H

#include "machine/machine.h"
#include "view/aim.h"
#include "view/paint.h"

enum { VIEW_COARSEST = 256 }; /* pixels of the first step */

/* What is drawn: a snapshot. The machine must live while view_workers_need() it. */
struct view_job {
    const struct sph_machine *machine;
    struct view_aim aim;
    const struct sph_fast *fast; /* of the machine, as long; NULL: literally */
};

struct view_workers;

/* Starts threads for frames of width x height; 0 threads: one for every processor. NULL with a
 * message if there is no memory, or no thread. */
struct view_workers *view_workers_new(int width, int height, int threads, struct sph_error *err);

/* Ends what is being drawn, and the threads. */
void view_workers_free(struct view_workers *w);

/* Ends what is being drawn, and starts the job on an empty canvas. Waits for no thread. -1 without
 * memory: then all is as it was. */
int view_workers_start(struct view_workers *w, const struct view_job *job);

/* Whether the newest job, or a worker that has not left one before, needs a machine. */
int view_workers_need(struct view_workers *w, const struct sph_machine *machine);

/* The steps of which all rows are done: 0 not even the first, 1 that, .. VIEW_PASSES all pixels. */
enum { VIEW_PASSES = 9 };
int view_workers_passes(struct view_workers *w);

/* Paints what is drawn so far into pixels of 0xBBGGRR. A pixel that is not, gets its colour from
 * `under`, a picture of as many pixels, or if that is NULL from the coarser pixel that covers it;
 * without such a one it stays as it is. */
void view_workers_paint(struct view_workers *w, const struct view_paint *how, const uint32_t *under,
                        uint32_t *pixels);

/* Draws one cell, by how->fast if that is not NULL; machine: of view_aim_start(). */
struct sph_render_options;
void view_cell_draw(struct sph_machine *machine, const struct view_aim *aim,
                    const struct sph_render_options *how, int x, int y, struct view_cell *cell);

#endif
