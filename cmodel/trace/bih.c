/* bih.c - see bih.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "trace/bih.h"

#include "core/stages.h"
#include "machine/layout.h"
#include "math/fx.h"
#include "math/arith.h"

static int at_least_0(int n) {
    return n > 0 ? n : 0;
}

void sph_bih_setup(const struct sph_profile *p, const struct sph_ray *ray, struct sph_bih_ray *b) {
    uint64_t a = ray->a ? ray->a : 1;
    b->v_shift = at_least_0(p->w + 2 - SPH_BIH_V);
    b->t_shift = at_least_0(p->w + p->wd + 2 - SPH_BIH_T);
    for (int i = 0; i < 3; i++) {
        int64_t d = ray->dir[i];
        struct sph_quotient q = sph_ratio(a, d ? (uint64_t)(d < 0 ? -d : d) : 1);
        b->axis[i] = (struct sph_bih_axis){d == 0, d < 0, q.mant, q.exp + b->t_shift - b->v_shift};
    }
    b->limit = sph_ray_ends(ray) ? sph_bih_time(b, ray->a) : SPH_BIH_NO_BOUND;
}

uint32_t sph_bih_time(const struct sph_bih_ray *b, uint64_t key) {
    uint64_t t = key >> b->t_shift;
    return t < SPH_BIH_NO_BOUND ? (uint32_t)t : SPH_BIH_NO_BOUND;
}

/* Parameter of a plane at distance v >= 0 that the ray enters at, rounded down. */
static uint32_t entering(const struct sph_bih_ray *b, const struct sph_bih_axis *axis, int64_t v) {
    uint64_t product = (uint64_t)(v >> b->v_shift) * axis->mant; /* u36 */
    product >>= at_least_0(axis->shift);
    return product < SPH_BIH_NO_BOUND ? (uint32_t)product : SPH_BIH_NO_BOUND;
}

/* The same of a plane that it leaves at, rounded up. */
static uint32_t leaving(const struct sph_bih_ray *b, const struct sph_bih_axis *axis, int64_t v) {
    if (axis->shift < 0) return SPH_BIH_NO_BOUND;
    uint64_t up = (uint64_t)((v + (1ll << b->v_shift) - 1) >> b->v_shift);
    uint64_t product = (up * (axis->mant + 2ull) >> axis->shift) + 1;
    return product < SPH_BIH_NO_BOUND ? (uint32_t)product : SPH_BIH_NO_BOUND;
}

int sph_bih_cut(const struct sph_bih_ray *b, const struct sph_ray *ray, int axis, int64_t clip,
                int below, struct sph_interval *span) {
    const struct sph_bih_axis *x = &b->axis[axis];
    int64_t v = clip - ray->org[axis]; /* s(W+3) */
    if (x->zero) return below ? v >= 0 : v <= 0;
    if (x->negative) v = -v;
    if (below != x->negative) { /* the ray runs out of this side */
        if (v < 0) return 0;
        uint32_t hi = leaving(b, x, v);
        if (hi < span->hi) span->hi = hi;
    } else if (v > 0) {
        uint32_t lo = entering(b, x, v);
        if (lo > span->lo) span->lo = lo;
    }
    return 1;
}

/* ---- box ---- */

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
        if (at < -SPH_BOX_FRAME_T) at = -SPH_BOX_FRAME_T;
        if (at > SPH_BOX_BEYOND) at = SPH_BOX_BEYOND;
        int32_t begin = (int32_t)at, rest = begin >> SPH_BOX_EXACT;
        int fine = shift - s > SPH_BOX_FINE ? SPH_BOX_FINE : 0;
        int32_t step = (int32_t)((uint64_t)x->mant >> (shift - s - fine));
        axes[i] = (struct sph_box_axis){
            .enter = begin + (begin < 0 ? rest : 0) - x->zero,
            .leave = begin + (begin < 0 ? 0 : rest) + (step >> fine) + 5,
            .step = step,
            .fine = fine,
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
        int32_t enter = x->enter + ((x->back ? end - hi : lo) * x->step >> x->fine);
        int32_t leave = x->leave + ((x->back ? end - lo : hi) * (x->step + 2) >> x->fine);
        if (x->flat) enter |= SPH_BOX_BEYOND; /* what is below 0 stays so */
        if (x->open) leave |= SPH_BOX_BEYOND;
        if (enter > first) first = enter;
        if (leave < last) last = leave;
    }
    *near = sph_box_depth((uint32_t)first & SPH_BIH_NO_BOUND);
    int pass = first <= last && first < SPH_BOX_BEYOND && *near <= depth_max;
    SPH_NOTE(ray->stages, SPH_STAGE_BOX, 0, SPH_THREE(planes->lo), SPH_THREE(planes->hi), *near,
             depth_max, pass);
    return pass;
}
