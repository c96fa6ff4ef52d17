/* setup.h - what a ray needs before it walks the tree                  RTL: rtl/trace/rt_setup.v
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TRACE_SETUP_H
#define SPH_TRACE_SETUP_H

#include "core/ray.h"

/* Fills in everything from `a` on. */
void sph_ray_setup(const struct sph_profile *p, struct sph_ray *ray);

/* Filter depth that no point with ceil(a*t) <= key exceeds; limited to 2^(FW+1)-1. */
int32_t sph_ray_depth(const struct sph_profile *p, const struct sph_ray *ray, uint64_t key);

/* Largest filter depth: nothing lies deeper. */
static inline int32_t sph_depth_limit(const struct sph_profile *p) {
    return (2 << p->fw) - 1;
}

#endif
