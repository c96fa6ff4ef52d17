/* filter.c - see filter.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "trace/filter.h"

#include "math/fx.h"

int sph_filter(const struct sph_ray *ray, const struct sph_child *child, int32_t depth_max,
               int32_t *near) {
    const int32_t *u = ray->unit.u; /* s1.16 */
    int64_t oc[3], cross[3];        /* s(FW+1).0, then s15.2 */
    for (int i = 0; i < 3; i++)
        oc[i] = child->ctr[i] - ray->forg[i];
    cross[0] = sph_round(oc[1] * u[2] - oc[2] * u[1], 14);
    cross[1] = sph_round(oc[2] * u[0] - oc[0] * u[2], 14);
    cross[2] = sph_round(oc[0] * u[1] - oc[1] * u[0], 14);
    int64_t dist2 = cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]; /* u.4 */
    int64_t rad2 = (int64_t)child->rad * child->rad * 16;                            /* u28.4 */

    int32_t depth = (int32_t)(ray->negative ? -oc[ray->axis] : oc[ray->axis]);
    *near = depth - child->rad;
    return dist2 <= rad2 && depth + child->rad >= 0 && *near <= depth_max;
}
