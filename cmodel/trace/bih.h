/* bih.h - how a ray crosses the planes of a bounding interval hierarchy
 * SPDX-License-Identifier: Apache-2.0
 *
 * Bounds along a ray are T-words: the top SPH_BIH_T bits of a key's W+WD+2. A lower bound is never
 * above what it bounds, an upper one never below: docs/design/bih.md proves that no hit is lost.
 */
#ifndef SPH_BIH_H
#define SPH_BIH_H

#include <stdint.h>

#include "core/ray.h"
#include "machine/box.h"

/* Where along the ray something may lie: lo <= key/2^t_shift <= hi. */
struct sph_interval {
    uint32_t lo, hi; /* T-words; hi all ones: no bound */
};

#define SPH_BIH_NO_BOUND ((1u << SPH_BIH_T) - 1)

/* One axis of a ray: a/|dir| in [mant, mant+2) * 2^-exp. */
struct sph_bih_axis {
    int zero, negative; /* dir = 0; dir < 0 */
    uint32_t mant;      /* u18, top or next bit set; if zero, of a dir of 1 */
    int shift;          /* exp + t_shift - v_shift: what a product is shifted right by */
};

struct sph_bih_ray {
    struct sph_bih_axis axis[3];
    int v_shift;    /* distances lose that many bits */
    int t_shift;    /* keys lose that many */
    uint32_t limit; /* T-word of the farthest hit that counts, at the ray's start */
};

/* What of a ray that was set up (`a` at least) the planes need. */
void sph_bih_setup(const struct sph_profile *p, const struct sph_ray *ray, struct sph_bih_ray *b);

/* The T-word of a key or of `a`: rounded down, limited. */
uint32_t sph_bih_time(const struct sph_bih_ray *b, uint64_t key);

/* Cuts *span to what lies on one side of the plane: coordinate `axis` >= clip, or with `below` <=
 * clip. 0 if nothing is left on this side; whether lo <= hi is for the caller to see.
 *
 * Why no bound is too narrow, with the words of docs/design/bih.md: q = a / |d| * 2^exp lies in
 * [mant, mant + 2), as sph_ratio() has it. An entering plane, v > 0, is met at
 * T = v a / |d| / 2^SH >= (v >> VS) mant / 2^shift, and a negative shift taken for 0 makes it
 * smaller still: L <= floor(T) of every point behind it. Of every point before a leaving plane,
 * v >= 0, T is at most v a / |d| / 2^SH < up (mant + 2) / 2^shift < U, or U is no bound. */
int sph_bih_cut(const struct sph_bih_ray *b, const struct sph_ray *ray, int axis, int64_t clip,
                int below, struct sph_interval *span);

/* ---- does a ray meet the box of a child, and from where on? (RTL: rtl/trace/rt_boxes.v) ---- */
/* At each visit the ray is set up for the frame of the node: then the T-word of any plane is that
 * where the frame begins and a multiple of that of a step. Both are rounded so that a box never
 * rejects what is hit: docs/design/bih.md. Boxes are ordered by the T-word where the ray enters
 * them, of which the first bit and the SPH_BOX_NEAR behind it are kept: a *depth*. */

/* One axis of a frame, along a ray. Its planes are counted from where the ray comes from: if it
 * runs back, plane n is that of 128 - n steps. */
struct sph_box_axis {
    int32_t enter; /* T-word of plane 0, s26, not above it */
    int32_t leave; /* of plane 1, above it */
    int32_t step;  /* T-words of a step, u17, times 2^fine: not above it, by less than 2 */
    int fine;      /* SPH_BOX_FINE or 0 */
    int back;      /* the ray runs towards smaller coordinates */
    int flat;      /* it does not move along the axis: enter is 1 less */
    int open;      /* planes that are not behind its origin do not bound it from above */
};

enum {
    SPH_BOX_BEYOND = SPH_BIH_NO_BOUND + 1,            /* above all T-words */
    SPH_BOX_FRAME_T = SPH_BOX_CODES << SPH_BOX_CROSS, /* above those of a frame */
    SPH_BOX_EXACT = SPH_BIH_G - 3,                    /* mant + 2 <= mant (1 + 2^-EXACT) */
};

/* The depth of a T-word, u15: rises with it, 0 for 0. */
int32_t sph_box_depth(uint32_t time);

/* A ray in the frame of a node. What leaves W+2 bits of a distance to the frame is lost.
 *
 * Why the words are no better than what they bound: with q = a / |d| in [mant, mant + 2), a plane
 * n steps of 2^s grid units behind plane 0, v away, is met at T = (v + n 2^s) q / 2^shift. If
 * `open` for its shift, the shift is greater than the ray's, so that a T above 0 is taken for a
 * smaller one, which bounds nothing from above; the sign stays. Let x = v mant / 2^shift, y that of
 * q, at = floor(x).
 *
 * For v >= 0, x <= y <= x + 2 v / 2^shift <= x (1 + 2^-15), for mant >= 2^16: at <= y, and floor(y)
 * <= at + 1 + (at >> 15). For v < 0, x >= y >= x (1 + 2^-15): y >= at + (at >> 15), and
 * floor(y) <= at.
 *
 * A step, times 2^fine, is 2^s q / 2^(shift - fine) in [step, step + 2), for it loses a bit at
 * least. So n of them are at least n step / 2^fine, and below n (step + 2) / 2^fine for n > 0.
 * Plane n + 1 is met before leave + (n (step + 2) >> fine): leave has 3 for what three floors lose,
 * and 2 above. Where `at` was limited T is above all words, or below 0 for any n.
 */
void sph_box_axes(const struct sph_profile *p, const struct sph_bih_ray *bih,
                  const struct sph_ray *ray, const struct sph_box_frame *frame,
                  struct sph_box_axis axes[3]);

/* 1 if the ray meets the box no deeper than depth_max; *near is the depth where it enters. */
int sph_box_meets(const struct sph_box_axis axes[3], const struct sph_ray *ray,
                  const struct sph_box_planes *planes, int32_t depth_max, int32_t *near);

#endif
