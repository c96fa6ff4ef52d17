/* across.h - two axes across a ray, for the node filter                RTL: rtl/trace/rt_across.v
 * SPDX-License-Identifier: Apache-2.0
 *
 * p, q and the unit vector u are at right angles up to roundings, p and q at most 1 long, and so is
 * every mixture of them of length 1: a product with both never makes a vector longer. p has no
 * component along the axis on which u is smallest. docs/design/traversal.md has the bounds.
 */
#ifndef SPH_ACROSS_H
#define SPH_ACROSS_H

#include "core/ray.h"

/* Axes across u, s1.16, which sph_unit() made; all 0 across (0,0,0). */
struct sph_across sph_across(const int32_t u[3]);

#endif
