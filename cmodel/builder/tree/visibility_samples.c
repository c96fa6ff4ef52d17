/* visibility_samples.c - see visibility_samples.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/tree/visibility_samples.h"

#include <stdlib.h>

#include "common/parallel.h"
#include "engine/render_pixel.h"
#include "fast/fast.h"
#include "trace/setup.h"

enum { OPEN = 3, BLOCKED = 1 }; /* weights of rays */
enum { ROOM = 4096 };           /* rays that there is room for at first */

struct log {
    const struct sph_profile *profile;
    struct sph_visibility_samples *samples;
    uint32_t room;
    int boxes, full;
};

static void append_sample(struct log *log, const struct sph_visibility_sample *sight) {
    struct sph_visibility_samples *all = log->samples;
    if (all->n == log->room) {
        uint32_t room = log->room ? 2 * log->room : ROOM;
        struct sph_visibility_sample *rays = realloc(all->rays, room * sizeof *rays);
        if (!rays) {
            log->full = 1;
            return;
        }
        all->rays = rays, log->room = room;
    }
    all->rays[all->n++] = *sight;
}

static void log_ray(void *user, const struct sph_logged *logged) {
    struct log *log = user;
    uint64_t key = logged->hit.key;
    int any = sph_ray_any(&logged->ray);
    struct sph_visibility_sample s = {.ray = logged->ray, .weight = any && key ? BLOCKED : OPEN};
    if (log->boxes) {
        sph_bih_setup(log->profile, &s.ray, &s.planes);
        s.depth_max = sph_box_depth(any || !key ? s.planes.limit : sph_bih_time(&s.planes, key));
    } else {
        s.depth_max = any || !key ? s.ray.depth_max : sph_ray_depth(log->profile, &s.ray, key);
    }
    sph_parallel_lock();
    append_sample(log, &s);
    sph_parallel_unlock();
}

int sph_visibility_samples(const struct sph_machine *m, int boxes,
                           struct sph_visibility_samples *samples, struct sph_error *err) {
    struct log log = {sph_machine_profile(m), samples, 0, boxes, 0};
    *samples = (struct sph_visibility_samples){NULL, 0};
    if (sph_sample(m, log_ray, &log, err)) return -1;
    return log.full ? sph_fail(err, "out of memory for a sample of rays") : 0;
}

void sph_visibility_samples_free(struct sph_visibility_samples *samples) {
    free(samples->rays);
    *samples = (struct sph_visibility_samples){NULL, 0};
}

/* Parts of the frame at most, and how far their middles lie apart at least. */
enum { COLUMNS = 32, ROWS = 18, APART = 4 };

enum { WORTH = 64 }; /* pixels, a thread */

struct sample {
    const struct sph_machine *m;
    struct sph_fast *fast;
    int columns, rows, full;
    sph_sample_look *look;
    void *user;
};

static int parts(int side, int most) {
    int n = (side + APART - 1) / APART;
    return n < most ? n : most;
}

static void pixels(void *user, uint32_t first, uint32_t end) {
    struct sample *s = user;
    int width = s->m->regs[SPH_REG_FRAME_W], height = s->m->regs[SPH_REG_FRAME_H];
    for (int i = (int)first; i < (int)end; i++) {
        struct sph_ray_log log = {0};
        struct sph_render_options o = {.traverse = s->fast ? SPH_TRAVERSE_FAST : SPH_TRAVERSE_TREE,
                                       .fast = s->fast,
                                       .log = &log};
        struct sph_counters counters = {{0}};
        uint32_t errors = 0;
        sph_render_pixel(s->m, &o, (2 * (i % s->columns) + 1) * width / (2 * s->columns),
                         (2 * (i / s->columns) + 1) * height / (2 * s->rows), &counters, &errors,
                         NULL);
        for (int j = 0; j < log.n; j++)
            s->look(s->user, &log.rays[j]);
        if (log.full) __atomic_store_n(&s->full, 1, __ATOMIC_RELAXED);
        sph_ray_log_free(&log);
    }
}

int sph_sample(const struct sph_machine *m, sph_sample_look *look, void *user,
               struct sph_error *err) {
    struct sample s = {.m = m,
                       .fast = sph_fast_new(m, SPH_FAST_BEST), /* or NULL */
                       .columns = parts(m->regs[SPH_REG_FRAME_W], COLUMNS),
                       .rows = parts(m->regs[SPH_REG_FRAME_H], ROWS),
                       .look = look,
                       .user = user};
    sph_parallel_for((uint32_t)(s.columns * s.rows), WORTH, pixels, &s);
    sph_fast_free(s.fast);
    return s.full ? sph_fail(err, "out of memory for a sample of rays") : 0;
}
