/* render_pixel.h - one pixel of the golden model, from ray to colours
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_RENDER_PIXEL_H
#define SPH_RENDER_PIXEL_H

#include "core/frame.h"
#include "core/met.h"
#include "core/ray_log.h"
#include "core/stages.h"
#include "core/tracer.h"
#include "core/trail.h"
#include "machine/machine.h"
#include "texture/lookup.h"
#include "trace/traverse.h"

/* Of sph_render(); of one pixel traverse, fast, fetch and log count. */
struct sph_render_options {
    int traverse;                /* SPH_TRAVERSE_* */
    const struct sph_fast *fast; /* of sph_render_pixel() with FAST: the machine; NULL: literally */
    int threads;                 /* 0: all */
    /* may be NULL; called under a lock; not 0: no more is drawn, sph_render() fails */
    int (*progress)(void *user, int rows_done, int rows);
    const int *stop; /* may be NULL; the same once this is not 0, and sooner */
    void *user;
    void (*fetch)(void *user, const struct sph_texel *texel); /* may be NULL; every texel, as it is
                                                                asked for: with one thread */
    void *fetch_user;
    struct sph_trail *trails; /* may be NULL; one for each pixel of the frame, row by row */
    /* may be NULL; every ray, with one thread: of one pixel they are a tree */
    struct sph_ray_log *log;
    struct sph_stages *stages; /* the same: of one pixel, by the literal walk */
    struct sph_met *met;       /* may be NULL; of a machine that is sound */
};

/* Renders pixel x, y; adds to *c and to the sticky *errors. Of the options traverse, fetch
 * and met count. trail may be NULL. */
struct sph_pixel sph_render_pixel(const struct sph_machine *m, const struct sph_render_options *o,
                                  int x, int y, struct sph_counters *c, uint32_t *errors,
                                  struct sph_trail *trail);

#endif
