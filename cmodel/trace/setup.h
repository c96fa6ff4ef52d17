/* setup.h - what a ray needs before it walks the tree
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

/* ---- two axes across a ray, for the node filter (RTL: rtl/trace/rt_across.v) ---- */
/* p, q and the unit vector u are at right angles up to roundings, p and q at most 1 long, and so is
 * every mixture of them of length 1: a product with both never makes a vector longer. p has no
 * component along the axis on which u is smallest. docs/design/traversal.md has the bounds. */

/* Axes across u, s1.16, which sph_unit() made; all 0 across (0,0,0). */
struct sph_across sph_across(const int32_t u[3]);

#endif
