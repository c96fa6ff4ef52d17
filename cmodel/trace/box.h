/* box.h - does a ray meet the box of a child, and from where on?         RTL: rtl/trace/rt_boxes.v
 * SPDX-License-Identifier: Apache-2.0
 *
 * A ray is set up for planes (trace/bih.h) once, for the frame of a node at each visit: then the
 * T-word of any plane is that where the frame begins and a multiple of that of a step. Both are
 * rounded so that a box never rejects what is hit: docs/design/bih.md. Boxes are ordered by the
 * T-word where the ray enters them, of which the first bit and the SPH_BOX_NEAR behind it are kept:
 * a *depth*.
 */
#ifndef SPH_TRACE_BOX_H
#define SPH_TRACE_BOX_H

#include "machine/box.h"
#include "trace/bih.h"

/* One axis of a frame, along a ray. Its planes are counted from where the ray comes from: if it
 * runs back, plane n is that of 128 - n steps. */
struct sph_box_axis {
    int32_t enter; /* T-word of plane 0, s26, not above it */
    int32_t leave; /* not below it */
    int32_t step;  /* T-word of a step, u17, not above it, nor below it by more than 2 */
    int back;      /* the ray runs towards smaller coordinates */
    int flat;      /* it does not move along the axis: enter is 1 less */
    int open;      /* planes that are not behind its origin do not bound it from above */
};

/* The depth of a T-word, u15: rises with it, 0 for 0. */
int32_t sph_box_depth(uint32_t time);

/* A ray in the frame of a node. What leaves W+2 bits of a distance to the frame is lost.
 *
 * Why the words are no better than what they bound: with q = a / |d| in [mant, mant + 2), a plane
 * n steps of 2^s grid units behind plane 0, v away, is met at T = (v + n 2^s) q / 2^shift. If
 * `open` for its shift, the shift is greater than the ray's, so that a T above 0 is taken for a
 * smaller one, which bounds nothing from above; the sign stays. With x = v mant / 2^shift and at =
 * floor(x): v >= 0   x <= v q / 2^shift <= x + 2 v / 2^shift <= x (1 + 2^-15), for mant >= 2^16, so
 * that at <= T of plane 0, and its floor is at most at + 1 + (at + 1 >> 15) v < 0    x >= v q /
 * 2^shift >= x (1 + 2^-15), so that T >= at + (at >> 15), and its floor is at most `at` A step is
 * 2^s q / 2^shift in [step, step + 2), for it loses a bit at least. So n > 0 of them are below n
 * (step + 2), and T of the plane below leave + n (step + 2) - 1. Where `at` was limited T is above
 * all words, or below 0 for any n. */
void sph_box_axes(const struct sph_profile *p, const struct sph_bih_ray *bih,
                  const struct sph_ray *ray, const struct sph_box_frame *frame,
                  struct sph_box_axis axes[3]);

/* 1 if the ray meets the box no deeper than depth_max; *near is the depth where it enters. */
int sph_box_meets(const struct sph_box_axis axes[3], const struct sph_ray *ray,
                  const struct sph_box_planes *planes, int32_t depth_max, int32_t *near);

#endif
