/* render.h - the golden model: machine in, frame out, bit by bit what the RTL gives
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_RENDER_H
#define SPH_RENDER_H

#include "common/error.h"
#include "core/frame.h"
#include "core/ray_log.h"
#include "core/trail.h"
#include "machine/machine.h"
#include "texture/lookup.h"
#include "trace/traverse.h"

struct sph_render_options {
    int traverse;                /* SPH_TRAVERSE_* */
    const struct sph_fast *fast; /* of sph_render_pixel() with FAST: the machine; NULL: literally */
    int threads;                 /* 0: all */
    void (*progress)(void *user, int rows_done, int rows); /* may be NULL; called under a lock */
    void *user;
    void (*fetch)(void *user, const struct sph_texel *texel); /* may be NULL; every texel, as it is
                                                                asked for: with one thread */
    void *fetch_user;
    struct sph_trail *trails; /* may be NULL; one for each pixel of the frame, row by row */
    /* may be NULL; every ray, with one thread: of one pixel they are a tree */
    struct sph_ray_log *log;
};

/* Renders the machine's window into *frame (allocated here at the full frame size; pixels outside
 * the window are zero) and adds up *counters. Returns the sticky error bits (1 << SPH_ERROR_*),
 * or -1 with a message if memory is out. */
int sph_render(const struct sph_machine *machine, const struct sph_render_options *options,
               struct sph_frame *frame, struct sph_counters *counters, struct sph_error *err);

#endif
