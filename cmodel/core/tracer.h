/* tracer.h - another way to set up and to trace the rays of a machine, with the same numbers
 * SPDX-License-Identifier: Apache-2.0
 *
 * The golden model is literal; whoever renders with it may hand it a faster walk: fast/fast.h.
 */
#ifndef SPH_TRACER_H
#define SPH_TRACER_H

#include "core/frame.h"
#include "core/ray.h"

struct sph_fast;

struct sph_tracer {
    /* As sph_ray_setup(). */
    void (*setup)(const struct sph_profile *p, struct sph_ray *ray);
    /* As sph_traverse() of the machine through its tree: the same hit, counters, visits, errors. */
    struct sph_hit (*trace)(const struct sph_fast *fast, const struct sph_ray *ray,
                            struct sph_counters *c, uint32_t *visits, uint32_t *errors);
};

/* Every struct sph_fast begins with one. */
static inline const struct sph_tracer *sph_tracer_of(const struct sph_fast *fast) {
    return (const struct sph_tracer *)fast;
}

#endif
