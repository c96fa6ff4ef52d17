/* filter.c - see filter.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "trace/filter.h"

#include "core/stages.h"
#include "machine/layout.h"

/* |x| of a number with 17 bits of fraction, cut to FILTER_FRACTION: never more than |x|. */
static int64_t cut(int64_t x) {
    x >>= 17 - SPH_FILTER_FRACTION;
    return x < 0 ? ~x : x;
}

int sph_filter(const struct sph_ray *ray, const struct sph_child *child, int32_t depth_max,
               int32_t *near) {
    const struct sph_across *a = &ray->across;
    int64_t oc[3]; /* s(FW+1).0 */
    for (int k = 0; k < 3; k++)
        oc[k] = child->ctr[k] - ray->forg[k];
    int64_t p = cut(oc[a->axis_a] * a->p_a - oc[a->axis_b] * a->p_b); /* u15.1 */
    int64_t q = cut(oc[0] * a->q[0] + oc[1] * a->q[1] + oc[2] * a->q[2]);
    int64_t rad = (int64_t)child->rad << SPH_FILTER_FRACTION;

    int32_t depth = (int32_t)(ray->negative ? -oc[ray->axis] : oc[ray->axis]);
    *near = depth - child->rad;
    int pass = p * p + q * q <= rad * rad && depth + child->rad >= 0 && *near <= depth_max;
    SPH_NOTE(ray->stages, SPH_STAGE_FILTER, 0, SPH_THREE(child->ctr), child->rad, p, q, *near,
             depth_max, pass);
    return pass;
}
