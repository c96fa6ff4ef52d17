/* filter.h - the narrow node test that never rejects what the exact test accepts
 * SPDX-License-Identifier: Apache-2.0
 *
 * (oc.p)^2 + (oc.q)^2 <= rad^2 with p and q across the ray: the squared distance of the child's
 * centre from it, without the cancellation of rad^2 - |oc|^2 + (oc.u)^2. Depth is measured along
 * the largest axis of u: a child behind the origin or deeper than the best hit is left out.
 *
 * Why it never rejects wrongly: docs/design/traversal.md adds up the roundings, SPH_FILTER_MARGIN
 * covers them.
 */
#ifndef SPH_FILTER_H
#define SPH_FILTER_H

#include <stdint.h>

#include "core/ray.h"
#include "machine/machine.h"

struct sph_child {
    int32_t ctr[3]; /* sFW filter units */
    int32_t rad;    /* u14, inflated by SPH_FILTER_MARGIN */
};

/* 1 if the child may hold a hit at a filter depth of at most depth_max; *near (s16) is the least
 * depth that the child reaches. */
int sph_filter(const struct sph_ray *ray, const struct sph_child *child, int32_t depth_max,
               int32_t *near);

/* ---- reads the words of a tree node (layout: machine/machine.def) ---- */

static inline struct sph_child sph_child_read(const uint32_t *line, int i) {
    int at = i * SPH_CHILD_STRIDE;
    return (struct sph_child){
        {sph_field_signed(line, at + SPH_CHILD_CTR_X_LSB, SPH_CHILD_CTR_X_BITS),
         sph_field_signed(line, at + SPH_CHILD_CTR_Y_LSB, SPH_CHILD_CTR_Y_BITS),
         sph_field_signed(line, at + SPH_CHILD_CTR_Z_LSB, SPH_CHILD_CTR_Z_BITS)},
        (int32_t)sph_field(line, at + SPH_CHILD_RAD_LSB, SPH_CHILD_RAD_BITS)};
}

#endif
