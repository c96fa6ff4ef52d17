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
    int bits = p->wd > SPH_BIH_DIVIDE ? p->wd : SPH_BIH_DIVIDE;
    int cut = at_least_0(sph_bit_length(ray->a) - bits); /* of a; dir is exact */
    b->v_shift = at_least_0(p->w + 2 - SPH_BIH_V);
    b->t_shift = at_least_0(p->w + p->wd + 2 - SPH_BIH_T);
    for (int i = 0; i < 3; i++) {
        int64_t d = ray->dir[i];
        b->axis[i] = (struct sph_bih_axis){d == 0, d < 0, 0, 0};
        if (!d) continue;
        struct sph_quotient q =
            sph_quotient(ray->a >> cut, bits, (uint64_t)(d < 0 ? -d : d), p->wd, SPH_BIH_G);
        b->axis[i].mant = q.mant;
        b->axis[i].shift = q.exp - cut + b->t_shift - b->v_shift;
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

int sph_box_meets(const struct sph_bih_ray *bih, const struct sph_ray *ray,
                  const struct sph_box *box, int32_t depth_max, int32_t *near) {
    struct sph_interval span = {0, SPH_BIH_NO_BOUND};
    int in = 1;
    for (int i = 0; i < 3; i++)
        in &= sph_bih_cut(bih, ray, i, box->lo[i], 0, &span) &&
              sph_bih_cut(bih, ray, i, box->hi[i], 1, &span);
    *near = sph_box_depth(span.lo);
    int pass = in && span.lo <= span.hi && *near <= depth_max;
    SPH_NOTE(ray->stages, SPH_STAGE_BOX, 0, SPH_THREE(box->lo), SPH_THREE(box->hi), *near,
             depth_max, pass);
    return pass;
}
