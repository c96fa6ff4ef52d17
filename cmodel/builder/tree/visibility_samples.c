/* visibility_samples.c - see visibility_samples.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/tree/visibility_samples.h"

#include <stdlib.h>

#include "common/parallel.h"
#include "trace/setup.h"

enum { OPEN = 3, BLOCKED = 1 }; /* weights of rays */
enum { ROOM = 4096 };           /* rays that there is room for at first */

struct log {
    const struct sph_profile *profile;
    struct sph_visibility_samples *samples;
    uint32_t room;
    int boxes, full;
};

static void keep(struct log *log, const struct sph_visibility_sample *sight) {
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

static void look(void *user, const struct sph_logged *logged) {
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
    keep(log, &s);
    sph_parallel_unlock();
}

int sph_visibility_samples(const struct sph_machine *m, int boxes,
                           struct sph_visibility_samples *samples, struct sph_error *err) {
    struct log log = {sph_machine_profile(m), samples, 0, boxes, 0};
    *samples = (struct sph_visibility_samples){NULL, 0};
    if (sph_sample(m, look, &log, err)) return -1;
    return log.full ? sph_fail(err, "out of memory for a sample of rays") : 0;
}

void sph_visibility_samples_free(struct sph_visibility_samples *samples) {
    free(samples->rays);
    *samples = (struct sph_visibility_samples){NULL, 0};
}
