/* box.c - see box.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "trace/box.h"

#include "core/stages.h"
#include "machine/layout.h"
#include "math/fx.h"

int32_t sph_box_depth(uint32_t time) {
    int shift = sph_bit_length(time) - (SPH_BOX_NEAR + 1);
    if (shift < 0) return (int32_t)time;
    return (int32_t)((uint32_t)shift << SPH_BOX_NEAR) + (int32_t)(time >> shift);
}

int sph_box_meets(const struct sph_bih_ray *bih, const struct sph_ray *ray,
                  const struct sph_box *box, int32_t depth_max, int32_t *near) {
    struct sph_interval span = {0, SPH_BIH_NO_BOUND};
    int in = 1;
    for (int i = 0; i < 3; i++)
        in &= sph_bih_cut(bih, ray, i, box->lo[i], 0, &span) &&
              sph_bih_cut(bih, ray, i, box->hi[i], 1, &span);
    *near = sph_box_depth(span.lo);
    int pass = in && span.lo <= span.hi && *near <= depth_max;
    SPH_NOTE(ray->stages, SPH_STAGE_BOX, 0, SPH_THREE(box->lo), SPH_THREE(box->hi), *near,
             depth_max, pass);
    return pass;
}
