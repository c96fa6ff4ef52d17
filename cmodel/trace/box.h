/* box.h - does a ray meet the box of a child, and from where on?           RTL: rtl/trace/rt_box.v
 * SPDX-License-Identifier: Apache-2.0
 *
 * A box is what lies between its six planes, each of which cuts the ray as one of a BIH does
 * (trace/bih.h), so that a box never rejects what is hit: docs/design/bih.md. Boxes are ordered by
 * the T-word where the ray enters them, of which the first bit and the SPH_BOX_NEAR behind it are
 * kept: a *depth*.
 */
#ifndef SPH_TRACE_BOX_H
#define SPH_TRACE_BOX_H

#include "machine/box.h"
#include "trace/bih.h"

/* The depth of a T-word, u15: rises with it, 0 for 0. */
int32_t sph_box_depth(uint32_t time);

/* 1 if the ray meets the box no deeper than depth_max; *near is the depth where it enters. */
int sph_box_meets(const struct sph_bih_ray *bih, const struct sph_ray *ray,
                  const struct sph_box *box, int32_t depth_max, int32_t *near);

#endif
