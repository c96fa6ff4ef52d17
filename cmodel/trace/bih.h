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
    uint32_t mant;      /* u18, top or next bit set; 0 if zero */
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
 * Why no bound is too narrow, with the words of docs/design/bih.md: q = a / |d| * 2^(exp - cut)
 * lies in [mant, mant + 2), for sph_quotient forms floor(An / Dn 2^17) of a >> cut and the size of
 * d, both with their top bits set in DW bits; what `cut` took of a adds less than 2^17 / Dn <= 1/4,
 * so with the floor q < mant + 1 + 1/4. An entering plane, v > 0, is met at
 * T = v a / |d| / 2^SH >= (v >> VS) mant / 2^shift, and a negative shift taken for 0 makes it
 * smaller still: L <= floor(T) of every point behind it. Of every point before a leaving plane,
 * v >= 0, T is at most v a / |d| / 2^SH < up (mant + 2) / 2^shift < U, or U is no bound. */
int sph_bih_cut(const struct sph_bih_ray *b, const struct sph_ray *ray, int axis, int64_t clip,
                int below, struct sph_interval *span);

/* ---- does a ray meet the box of a child, and from where on? (RTL: rtl/trace/rt_box.v) ---- */
/* A box is what lies between its six planes, each of which cuts the ray as one of a BIH does
 * (trace/bih.h), so that a box never rejects what is hit: docs/design/bih.md. Boxes are ordered by
 * the T-word where the ray enters them, of which the first bit and the SPH_BOX_NEAR behind it are
 * kept: a *depth*. */

/* The depth of a T-word, u15: rises with it, 0 for 0. */
int32_t sph_box_depth(uint32_t time);

/* 1 if the ray meets the box no deeper than depth_max; *near is the depth where it enters. */
int sph_box_meets(const struct sph_bih_ray *bih, const struct sph_ray *ray,
                  const struct sph_box *box, int32_t depth_max, int32_t *near);

#endif
