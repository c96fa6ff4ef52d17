/* ray_log.c - see ray_log.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "core/ray_log.h"

#include <stdlib.h>

/* The latest ray of this depth that is no shadow ray. A waiting ray goes on when all that its
 * surface sent before is traced, so that this one is where it starts. */
static int latest(const struct sph_ray_log *log, int depth) {
    int i = log->n - 1;
    while (i >= 0 && (log->rays[i].ray.kind == SPH_SHADOW || log->rays[i].depth != depth))
        i--;
    return i;
}

void sph_ray_log_add(struct sph_ray_log *log, const struct sph_ray *ray, struct sph_hit hit,
                     uint32_t visits) {
    if (log->n == log->room) {
        int room = log->room ? 2 * log->room : 16;
        struct sph_logged *more = realloc(log->rays, (size_t)room * sizeof *more);
        if (!more) {
            log->full = 1;
            return;
        }
        log->rays = more;
        log->room = room;
    }
    struct sph_logged *to = &log->rays[log->n];
    *to = (struct sph_logged){*ray, hit, visits, -1, log->depth};
    if (ray->kind == SPH_SHADOW)
        to->parent = latest(log, log->depth);
    else if (log->depth)
        to->parent = latest(log, log->depth - 1);
    log->n++;
}

void sph_ray_log_free(struct sph_ray_log *log) {
    free(log->rays);
    *log = (struct sph_ray_log){0};
}
