/* render.c - see render.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "core/render.h"

#include <omp.h>
#include <stdlib.h>

#include "pixel/background.h"
#include "engine/render_pixel.h"
#include "fast/pixel.h"

int sph_render(const struct sph_machine *m, const struct sph_render_options *o,
               struct sph_frame *frame, struct sph_counters *counters, struct sph_error *err) {
    const int32_t *r = m->regs;
    int width = r[SPH_REG_FRAME_W], height = r[SPH_REG_FRAME_H];
    frame->width = width;
    frame->height = height;
    frame->pixels = calloc((size_t)width * (size_t)height, sizeof *frame->pixels);
    if (!frame->pixels)
        return sph_fail(err, "%s: no memory for a frame of %dx%d", m->name, width, height);

    struct sph_fast *fast =
        o->traverse == SPH_TRAVERSE_FAST && !o->fast ? sph_fast_new(m, SPH_FAST_BEST) : NULL;
    struct sph_render_options how = *o;
    if (fast) how.fast = fast;
    struct sph_pixel (*draw)(const struct sph_machine *, const struct sph_render_options *, int,
                             int, struct sph_counters *, uint32_t *, struct sph_trail *) =
        how.fast && !o->log && sph_fast_shades(m) ? sph_fast_pixel : sph_render_pixel;
    uint32_t errors = sph_background_missing(m) ? 1u << SPH_ERROR_BAD_NODE : 0;
    int rows_done = 0, rows = r[SPH_REG_WIN_Y1] - r[SPH_REG_WIN_Y0];
#pragma omp parallel num_threads(o->threads > 0 ? o->threads : omp_get_num_procs())
    {
        struct sph_counters mine = {{0}};
        uint32_t my_errors = 0;
#pragma omp for schedule(dynamic, 4)
        for (int y = r[SPH_REG_WIN_Y0]; y < r[SPH_REG_WIN_Y1]; y++) {
            for (int x = r[SPH_REG_WIN_X0]; x < r[SPH_REG_WIN_X1]; x++) {
                size_t at = (size_t)y * (size_t)width + (size_t)x;
                frame->pixels[at] =
                    draw(m, &how, x, y, &mine, &my_errors, o->trails ? o->trails + at : NULL);
            }
            if (o->progress) {
#pragma omp critical
                o->progress(o->user, ++rows_done, rows);
            }
        }
#pragma omp critical
        {
            errors |= my_errors;
            for (int i = 0; i < SPH_COUNTERS; i++)
                counters->count[i] += mine.count[i];
        }
    }
    sph_fast_free(fast);
    return (int)errors;
}
