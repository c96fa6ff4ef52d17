/* ray_log.h - the rays of one pixel as a tree
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_RAY_LOG_H
#define SPH_RAY_LOG_H

#include "core/ray.h"

/* A ray as it was traced, and what it found. */
struct sph_logged {
    struct sph_ray ray;
    struct sph_hit hit; /* of a shadow ray the key alone: 1 if the light is hidden */
    uint32_t visits;    /* tree nodes, of this ray */
    int parent;         /* number of the ray at whose hit it starts; -1: the eye */
    int depth;          /* reflections and refractions before it */
};

/* Rays in the order in which they are traced. A pixel whose first hit was void has two of which the
 * parent is -1; the second one counts (Borodavka et al. VI.D). */
struct sph_ray_log {
    struct sph_logged *rays; /* freed by sph_ray_log_free() */
    int n, room;
    int depth; /* of the next ray that is no shadow ray */
    int full;  /* memory was out: rays are missing */
};

/* Appends a ray. */
void sph_ray_log_add(struct sph_ray_log *log, const struct sph_ray *ray, struct sph_hit hit,
                     uint32_t visits);

void sph_ray_log_free(struct sph_ray_log *log);

#endif
