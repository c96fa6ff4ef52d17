/* planes.h - set-up of a ray that is cut by planes, with the divisions of the processor
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FAST_PLANES_H
#define SPH_FAST_PLANES_H

#include "fast/surface.h"
#include "trace/bih.h"

/* sph_bih_setup() */
static inline void sph_fast_planes(const struct sph_profile *p, const struct sph_ray *ray,
                                   struct sph_bih_ray *b) {
    int bits = p->wd > SPH_BIH_DIVIDE ? p->wd : SPH_BIH_DIVIDE, lost = p->w + 2 - SPH_BIH_V;
    uint64_t a = ray->a ? ray->a : 1;
    int cut = sph_bit_length(a) - bits, shift = p->w + p->wd + 2 - SPH_BIH_T;
    if (cut < 0) cut = 0;
    b->v_shift = lost > 0 ? lost : 0;
    b->t_shift = shift > 0 ? shift : 0;
    for (int i = 0; i < 3; i++) {
        int64_t d = ray->dir[i];
        b->axis[i] = (struct sph_bih_axis){d == 0, d < 0, 0, 0};
        uint64_t size = (uint64_t)(d < 0 ? -d : d);
        struct sph_quotient q =
            sph_fast_quotient(a >> cut, bits, size ? size : 1, p->wd, SPH_BIH_G);
        b->axis[i].mant = q.mant;
        b->axis[i].shift = q.exp - cut + b->t_shift - b->v_shift;
    }
    b->limit = sph_ray_ends(ray) ? sph_bih_time(b, ray->a) : SPH_BIH_NO_BOUND;
}

#endif
