/* spheres.h - depth of a ray's limit among nodes of spheres; what walk.h asks for
 * SPDX-License-Identifier: Apache-2.0
 */
#include "fast/setup.h"

static inline int32_t limit_of(const struct lanes *l, const struct sph_ray *ray) {
    (void)l;
    return ray->depth_max;
}

static inline int32_t depth_of(const struct lanes *l, const struct sph_profile *p,
                               const struct sph_ray *ray, uint64_t key) {
    (void)l;
    return sph_fast_depth(p, ray, key);
}
