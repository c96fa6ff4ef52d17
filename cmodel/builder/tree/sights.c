/* sights.c - see sights.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/tree/sights.h"

#include <stdlib.h>

#include "common/parallel.h"
#include "trace/setup.h"

enum { OPEN = 3, BLOCKED = 1 }; /* weights of rays */
enum { ROOM = 4096 };           /* rays that there is room for at first */

struct log {
    const struct sph_profile *profile;
    struct sph_sights *sights;
    uint32_t room;
    int boxes, full;
};

static void keep(struct log *log, const struct sph_sight *sight) {
    struct sph_sights *all = log->sights;
    if (all->n == log->room) {
        uint32_t room = log->room ? 2 * log->room : ROOM;
        struct sph_sight *rays = realloc(all->rays, room * sizeof *rays);
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
    struct sph_sight s = {.ray = logged->ray, .weight = any && key ? BLOCKED : OPEN};
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

int sph_sights(const struct sph_machine *m, int boxes, struct sph_sights *sights,
               struct sph_error *err) {
    struct log log = {sph_machine_profile(m), sights, 0, boxes, 0};
    *sights = (struct sph_sights){NULL, 0};
    if (sph_sample(m, look, &log, err)) return -1;
    return log.full ? sph_fail(err, "out of memory for a sample of rays") : 0;
}

void sph_sights_free(struct sph_sights *sights) {
    free(sights->rays);
    *sights = (struct sph_sights){NULL, 0};
}
