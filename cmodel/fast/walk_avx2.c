/* walk_avx2.c - the walk with four children at once; compiled with -mavx2, see walk.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "fast/decoded.h"
#include "machine/layout.h"

#ifdef __AVX2__
#include <immintrin.h>

#include "fast/keys_avx2.h"

#define PLUS (1ll << (49 - SPH_FILTER_FRACTION))

/* Added to near in a key: a child that is met has near <= 2^14 and, since it ends before the origin
 * otherwise, near >= -2 rad > -2^15. */
enum { BIAS = 1 << 15 };

/* oc.p = ctr.p - org.p, so the origin is a constant of the ray, and so is PLUS, which makes the sum
 * positive, so that it may be shifted as an unsigned number: what that adds to the quotient, 2^32,
 * is beyond the 32 bits that a product takes. */
struct lanes {
    __m256i p_a, p_b, q[3], minus_p, minus_q; /* four words of 64 bits */
    int i, j;
    __m128i sign, plus; /* depth = (ctr ^ sign) + plus, four words of 32 */
    __m128i ordered;    /* 0 if all are equally near */
    int axis;
};

static struct lanes lanes_of(const struct sph_profile *p, const struct sph_ray *ray) {
    (void)p;
    struct lanes l;
    const struct sph_across *a = &ray->across;
    const int32_t *o = ray->forg;
    int64_t org_p = (int64_t)o[a->axis_a] * a->p_a - (int64_t)o[a->axis_b] * a->p_b, org_q = 0;
    for (int k = 0; k < 3; k++) {
        org_q += (int64_t)o[k] * a->q[k];
        l.q[k] = _mm256_set1_epi64x(a->q[k]);
    }
    l.p_a = _mm256_set1_epi64x(a->p_a);
    l.p_b = _mm256_set1_epi64x(-a->p_b);
    l.minus_p = _mm256_set1_epi64x(PLUS - org_p);
    l.minus_q = _mm256_set1_epi64x(PLUS - org_q);
    l.i = a->axis_a;
    l.j = a->axis_b;
    int any = sph_ray_any(ray), sign = ray->negative ? -1 : 0, at = o[ray->axis];
    l.axis = ray->axis;
    l.sign = _mm_set1_epi32(sign);
    l.plus = _mm_set1_epi32(-sign - (sign ? -at : at));
    l.ordered = _mm_set1_epi32(any ? 0 : -1);
    return l;
}

/* No child is as deep as the limit, so that what has none may be deeper. */
static inline int32_t near_of(int32_t depth) {
    return depth + BIAS < KEY_NONE ? depth + BIAS : KEY_NONE - 1;
}

/* Four words of 16 bits, each in a word of 64, of 32. */
static inline __m256i wide(const int16_t *at) {
    return _mm256_cvtepi16_epi64(_mm_loadl_epi64((const __m128i *)(const void *)at));
}
static inline __m128i half(const int16_t *at) {
    return _mm_cvtepi16_epi32(_mm_loadl_epi64((const __m128i *)(const void *)at));
}

/* The square of a distance along an axis, cut. */
static inline __m256i square(__m256i sum) {
    __m256i x = _mm256_srli_epi64(sum, 17 - SPH_FILTER_FRACTION);
    x = _mm256_xor_si256(x, _mm256_srai_epi32(x, 31));
    return _mm256_mul_epi32(x, x);
}

static inline unsigned children(const struct lanes *l, const struct sph_fast *f, uint32_t node,
                                int32_t depth_max, keys *order) {
    const struct sph_fast_node *n = &f->nodes[node];
    __m256i x = wide(n->ctr[0]), y = wide(n->ctr[1]), z = wide(n->ctr[2]), r = wide(n->rad);
    __m256i p = _mm256_add_epi64(_mm256_mul_epi32(wide(n->ctr[l->i]), l->p_a),
                                 _mm256_mul_epi32(wide(n->ctr[l->j]), l->p_b));
    __m256i q = _mm256_add_epi64(
        _mm256_mul_epi32(x, l->q[0]),
        _mm256_add_epi64(_mm256_mul_epi32(y, l->q[1]), _mm256_mul_epi32(z, l->q[2])));
    __m256i dist2 = _mm256_add_epi64(square(_mm256_add_epi64(p, l->minus_p)),
                                     square(_mm256_add_epi64(q, l->minus_q)));
    __m256i rad2 = _mm256_slli_epi64(_mm256_mul_epi32(r, r), 2 * SPH_FILTER_FRACTION);
    __m256i aside = _mm256_cmpgt_epi64(dist2, rad2);
    __m128i rad = half(n->rad);
    __m128i depth = _mm_add_epi32(_mm_xor_si128(half(n->ctr[l->axis]), l->sign), l->plus);
    __m128i near = _mm_sub_epi32(depth, rad);
    __m128i out = _mm_or_si128(_mm_add_epi32(depth, rad), /* negative: it ends behind the origin */
                               _mm_cmpgt_epi32(near, _mm_set1_epi32(depth_max)));
    __m128i side = _mm_castps_si128(_mm_shuffle_ps(
        _mm_castsi128_ps(_mm256_castsi256_si128(aside)),
        _mm_castsi128_ps(_mm256_extracti128_si256(aside, 1)), _MM_SHUFFLE(2, 0, 2, 0)));
    __m128i missed = _mm_or_si128(side, _mm_srai_epi32(out, 31));
    unsigned met = ~(unsigned)_mm_movemask_ps(_mm_castsi128_ps(missed)) & n->valid;
    __m128i key = _mm_and_si128(_mm_add_epi32(near, _mm_set1_epi32(BIAS)), l->ordered);
    *order = keys_of(key, missed, n->n_inner);
    return met;
}

#include "fast/spheres.h"
#include "fast/walk.h"

struct sph_hit (*const sph_fast_walk_avx2)(const struct sph_fast *, const struct sph_ray *,
                                           struct sph_counters *, uint32_t *, uint32_t *) = walk;
#else
struct sph_hit (*const sph_fast_walk_avx2)(const struct sph_fast *, const struct sph_ray *,
                                           struct sph_counters *, uint32_t *, uint32_t *) = NULL;
#endif
