/* box.c - see box.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "trace/box.h"

#include "core/stages.h"
#include "machine/layout.h"
#include "math/fx.h"

enum {
    BEYOND = SPH_BIH_NO_BOUND + 1,            /* above all T-words */
    FRAME_T = SPH_BOX_CODES << SPH_BOX_CROSS, /* above those of a frame */
    EXACT = SPH_BIH_G - 3,                    /* mant + 2 <= mant (1 + 2^-EXACT) */
};

int32_t sph_box_depth(uint32_t time) {
    int shift = sph_bit_length(time) - (SPH_BOX_NEAR + 1);
    if (shift < 0) return (int32_t)time;
    return (int32_t)((uint32_t)shift << SPH_BOX_NEAR) + (int32_t)(time >> shift);
}

void sph_box_axes(const struct sph_profile *p, const struct sph_bih_ray *bih,
                  const struct sph_ray *ray, const struct sph_box_frame *frame,
                  struct sph_box_axis axes[3]) {
    int spare = 64 - (p->w + 2);
    for (int i = 0; i < 3; i++) {
        const struct sph_bih_axis *x = &bih->axis[i];
        int s = frame->step[i], shift = (x->shift > 0 ? x->shift : 0) + bih->v_shift;
        int steep = shift <= s; /* a step would lose no bit */
        if (steep) shift = s + 1;
        int64_t org = frame->org[i];
        int64_t v =
            x->negative ? ray->org[i] - org - ((int64_t)SPH_BOX_CODES << s) : org - ray->org[i];
        v = (int64_t)((uint64_t)v << spare) >> spare;
        int64_t at = v * x->mant >> shift;
        if (at < -FRAME_T) at = -FRAME_T;
        if (at > BEYOND) at = BEYOND;
        int32_t begin = (int32_t)at, more = begin >> EXACT;
        axes[i] = (struct sph_box_axis){
            .enter = begin + (begin < 0 ? more : 0) - x->zero,
            .leave = begin + 2 + (begin < 0 ? 0 : more),
            .step = (int32_t)((uint64_t)x->mant >> (shift - s)),
            .back = x->negative,
            .flat = x->zero,
            .open = x->zero || x->shift < 0 || steep,
        };
    }
}

int sph_box_meets(const struct sph_box_axis axes[3], const struct sph_ray *ray,
                  const struct sph_box_planes *planes, int32_t depth_max, int32_t *near) {
    int32_t first = 0, last = INT32_MAX;
    for (int i = 0; i < 3; i++) {
        const struct sph_box_axis *x = &axes[i];
        int lo = planes->lo[i], hi = planes->hi[i], end = SPH_BOX_CODES - 1;
        int32_t enter = x->enter + (x->back ? end - hi : lo) * x->step;
        int32_t leave = x->leave + ((x->back ? end - lo : hi) + 1) * (x->step + 2);
        if (x->flat) enter |= BEYOND; /* what is below 0 stays so */
        if (x->open) leave |= BEYOND;
        if (enter > first) first = enter;
        if (leave < last) last = leave;
    }
    *near = sph_box_depth((uint32_t)first & SPH_BIH_NO_BOUND);
    int pass = first <= last && first < BEYOND && *near <= depth_max;
    SPH_NOTE(ray->stages, SPH_STAGE_BOX, 0, SPH_THREE(planes->lo), SPH_THREE(planes->hi), *near,
             depth_max, pass);
    return pass;
}
