/* render.c - see render.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "render/render.h"

#include <stdlib.h>

#include "common/parallel.h"
#include "machine/camera.h"
#include "pixel/background.h"
#include "engine/render_pixel.h"
#include "fast/pixel.h" /* sph_fast_shades */
#include "fast/tile.h"

enum { TILES = 8, ROWS = 4 }; /* what a thread draws at a time: a row of tiles, or rows */

struct job {
    const struct sph_machine *m;
    struct sph_render_options how;
    struct sph_frame *frame;
    struct sph_pixel (*draw)(const struct sph_machine *, const struct sph_render_options *, int,
                             int, struct sph_counters *, uint32_t *, struct sph_trail *);
    int tiles;         /* sph_fast_tile() instead of draw */
    int packets;       /* and in packets */
    int width, height; /* of what a thread draws at a time */
    int across, down;  /* how many of those there are */
    int done;          /* of them */
    int end;           /* nobody wants the rest */
    uint32_t errors;
    struct sph_counters *counters;
};

static int stopped(const struct job *j) {
    return __atomic_load_n(&j->end, __ATOMIC_RELAXED) ||
           (j->how.stop && __atomic_load_n(j->how.stop, __ATOMIC_RELAXED));
}

static int less(int a, int b) {
    return a < b ? a : b;
}

/* What a thread draws at a time, from x0, y0 on. */
static void draw(const struct job *j, int x0, int y0, struct sph_counters *c, uint32_t *errors) {
    int x1 = less(x0 + j->width, j->m->regs[SPH_REG_WIN_X1]);
    int y1 = less(y0 + j->height, j->m->regs[SPH_REG_WIN_Y1]);
    for (int x = x0; x < x1 && j->tiles && !stopped(j); x += SPH_TILE)
        sph_fast_tile(j->m, &j->how, j->packets, x, y0, less(x + SPH_TILE, x1), y1, j->frame, c,
                      errors);
    for (int y = y0; y < y1 && !j->tiles; y++)
        for (int x = x0; x < x1 && !stopped(j); x++) {
            size_t at = (size_t)y * (size_t)j->frame->width + (size_t)x;
            j->frame->pixels[at] =
                j->draw(j->m, &j->how, x, y, c, errors, j->how.trails ? j->how.trails + at : NULL);
        }
}

/* Draws parts of the window and adds up what they cost. */
static void parts(void *user, uint32_t first, uint32_t end) {
    struct job *j = user;
    const int32_t *r = j->m->regs;
    int rows = r[SPH_REG_WIN_Y1] - r[SPH_REG_WIN_Y0];
    for (int i = (int)first; i < (int)end && !stopped(j); i++) {
        struct sph_counters mine = {{0}};
        uint32_t errors = 0;
        draw(j, r[SPH_REG_WIN_X0] + i % j->across * j->width,
             r[SPH_REG_WIN_Y0] + i / j->across * j->height, &mine, &errors);
        sph_parallel_lock();
        j->errors |= errors;
        for (int c = 0; c < SPH_COUNTERS; c++)
            j->counters->count[c] += mine.count[c];
        if (++j->done % j->across == 0 && j->how.progress &&
            j->how.progress(j->how.user, (int)((int64_t)j->done * rows / (j->across * j->down)),
                            rows))
            __atomic_store_n(&j->end, 1, __ATOMIC_RELAXED);
        sph_parallel_unlock();
    }
}

/* What is not known of packets is not told of a frame that was drawn otherwise. */
static void forget_work(struct sph_frame *frame, struct sph_counters *counters) {
    static const int work[] = {SPH_COUNT_NODE_VISITS, SPH_COUNT_CHILD_TESTS, SPH_COUNT_LEAF_TESTS,
                               SPH_COUNT_ROOTS,       SPH_COUNT_FACET_TESTS, SPH_COUNT_DIVISIONS};
    for (size_t i = 0; i < (size_t)frame->width * (size_t)frame->height; i++)
        frame->pixels[i].visits = 0;
    for (size_t i = 0; i < sizeof work / sizeof *work; i++)
        counters->count[work[i]] = 0;
}

int sph_render(const struct sph_machine *m, const struct sph_render_options *o,
               struct sph_frame *frame, struct sph_counters *counters, struct sph_error *err) {
    const int32_t *r = m->regs;
    int width = r[SPH_REG_FRAME_W], height = r[SPH_REG_FRAME_H];
    frame->width = width;
    frame->height = height;
    frame->pixels = calloc((size_t)width * (size_t)height, sizeof *frame->pixels);
    if (!frame->pixels)
        return sph_fail(err, "%s: no memory for a frame of %dx%d", m->name, width, height);

    if (sph_camera_strayed(m)) return 1 << SPH_ERROR_LEFT_OUT; /* refused, as by the core */
    int packets = o->traverse == SPH_TRAVERSE_PACKETS;
    struct sph_fast *fast = (packets || o->traverse == SPH_TRAVERSE_FAST) && !o->fast
                                ? sph_fast_new(m, SPH_FAST_BEST)
                                : NULL;
    int columns = r[SPH_REG_WIN_X1] - r[SPH_REG_WIN_X0];
    int rows = r[SPH_REG_WIN_Y1] - r[SPH_REG_WIN_Y0];
    struct job job = {.m = m,
                      .how = *o,
                      .frame = frame,
                      .draw = sph_render_pixel,
                      .width = columns,
                      .height = ROWS,
                      .counters = counters};
    if (fast) job.how.fast = fast;
    if (job.how.fast && !o->log && !o->met && sph_fast_shades(m)) {
        job.tiles = 1;
        job.packets = packets && sph_fast_tiles(m, job.how.fast);
        job.width = TILES * SPH_TILE;
        job.height = SPH_TILE;
    }
    job.errors = sph_background_missing(m) ? 1u << SPH_ERROR_BAD_NODE : 0;
    job.across = columns > 0 ? (columns + job.width - 1) / job.width : 0; /* or no window */
    job.down = rows > 0 ? (rows + job.height - 1) / job.height : 0;
    int before = sph_parallel_most(o->threads);
    sph_parallel_for((uint32_t)(job.across * job.down), 1, parts, &job);
    sph_parallel_most(before);
    sph_fast_free(fast);
    if (packets) forget_work(frame, counters);
    if (stopped(&job)) return sph_fail(err, "%s: cancelled", m->name);
    return (int)job.errors;
}
