/* walk_neon.c - the walk with four children at once, for processors with NEON; see walk.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * As walk_avx2.c, but what is loaded comes apart into x, y, z and radius.
 */
#include "fast/decoded.h"
#include "machine/layout.h"

#ifdef __aarch64__
#include <arm_neon.h>

/* near * 4 + child; KEY_NONE where there is nothing to visit. */
enum { KEY_NONE = INT32_MAX };
typedef int32x4_t keys;

/* Numbers of 18 bits as products of 16 bits take them: high * 2^LOW + low. */
enum { LOW = 9 };

struct across {
    int16_t high[3], low[3];
};

struct lanes {
    int16_t org[3];
    struct across p, q;
    int axis;
    int16x4_t sign;
    int32x4_t most;    /* near in a key: the least, so that all are equally near, or any */
    int32_t depth_max; /* of limit_to() */
};

static inline struct across across_of(const int32_t v[3]) {
    struct across r;
    for (int k = 0; k < 3; k++) {
        r.high[k] = (int16_t)(v[k] >> LOW);
        r.low[k] = (int16_t)(v[k] & ((1 << LOW) - 1));
    }
    return r;
}

static inline struct lanes lanes_of(const struct sph_profile *profile, const struct sph_ray *ray) {
    (void)profile;
    const struct sph_across *a = &ray->across;
    int32_t p[3] = {0, 0, 0};
    p[a->axis_a] = a->p_a;
    p[a->axis_b] = -a->p_b;
    struct lanes l = {.p = across_of(p), .q = across_of(a->q), .axis = ray->axis};
    for (int k = 0; k < 3; k++)
        l.org[k] = (int16_t)ray->forg[k];
    l.sign = vdup_n_s16((int16_t)(ray->negative ? -1 : 0));
    l.most = vdupq_n_s32(sph_ray_any(ray) ? INT16_MIN : INT16_MAX);
    return l;
}

static inline keys no_keys(void) {
    return vdupq_n_s32(KEY_NONE);
}

static inline int32_t first(keys k) {
    return vminvq_s32(k);
}

static inline int any(keys k) {
    return first(k) != KEY_NONE;
}

static inline int is_child(int32_t key, int i) {
    return (key & 3) == i;
}

static inline int within(int32_t key, int32_t near) {
    return key <= near;
}

static inline int32_t near_of(int32_t depth) {
    return depth * 4 + 3;
}

static inline keys without(keys k, int32_t key) {
    return vbslq_s32(vceqq_s32(k, vdupq_n_s32(key)), no_keys(), k);
}

static inline int32x4_t sum(const int16_t by[3], const int16x4_t oc[3]) {
    return vmlal_n_s16(vmlal_n_s16(vmull_n_s16(oc[0], by[0]), oc[1], by[1]), oc[2], by[2]);
}

/* The distance along an axis, cut as filter.c says; of 16 bits and more the greatest of 15. */
static inline int16x4_t distance(const struct across *a, const int16x4_t oc[3]) {
    int32x4_t all = vsraq_n_s32(sum(a->high, oc), sum(a->low, oc), LOW);
    int16x4_t cut = vqmovn_s32(vshrq_n_s32(all, 17 - SPH_FILTER_FRACTION - LOW));
    return veor_s16(cut, vshr_n_s16(cut, 15));
}

static inline void limit_to(struct lanes *l, int32_t depth_max) {
    l->depth_max = depth_max;
}

static inline unsigned children(const struct lanes *l, const struct sph_fast *f,
                                const struct sph_fast_node *n, keys *order) {
    (void)f;
    static const int32_t number[4] = {0, 1, 2, 3};
    static const uint16_t bit[4] = {1, 4, 16, 64};
    int16x4x2_t xy = vld2_s16(n->xy[0]), zr = vld2_s16(n->zr[0]);
    int16x4_t rad = zr.val[1], oc[3] = {vsub_s16(xy.val[0], vdup_n_s16(l->org[0])),
                                        vsub_s16(xy.val[1], vdup_n_s16(l->org[1])),
                                        vsub_s16(zr.val[0], vdup_n_s16(l->org[2]))};
    int16x4_t p = distance(&l->p, oc), q = distance(&l->q, oc);
    uint32x4_t aside = vcgtq_s32(vmlal_s16(vmull_s16(p, p), q, q), vld1q_s32(n->square));
    int16x4_t depth = vsub_s16(veor_s16(oc[l->axis], l->sign), l->sign);
    int16x4_t near = vsub_s16(depth, rad), end = vadd_s16(depth, rad);
    uint16x4_t out =
        vorr_u16(vclt_s16(end, vdup_n_s16(0)), vcgt_s16(near, vdup_n_s16((int16_t)l->depth_max)));
    uint16x4_t missed = vorr_u16(vmovn_u32(aside), out);
    int32x4_t child = vld1q_s32(number);
    int32x4_t key = vminq_s32(vmovl_s16(near), l->most);
    uint32x4_t none = vorrq_u32(vreinterpretq_u32_s32(vmovl_s16(vreinterpret_s16_u16(missed))),
                                vcgeq_s32(child, vdupq_n_s32(n->n_inner)));
    *order = vbslq_s32(none, no_keys(), vaddq_s32(vshlq_n_s32(key, 2), child));
    return ~vaddv_u16(vand_u16(missed, vld1_u16(bit))) & n->leaves;
}

#include "fast/spheres.h"
#include "fast/walk.h"

struct sph_hit (*const sph_fast_walk_neon)(const struct sph_fast *, const struct sph_ray *,
                                           struct sph_counters *, uint32_t *, uint32_t *) = walk;
#else
#include <stddef.h>

struct sph_hit (*const sph_fast_walk_neon)(const struct sph_fast *, const struct sph_ray *,
                                           struct sph_counters *, uint32_t *, uint32_t *) = NULL;
#endif
