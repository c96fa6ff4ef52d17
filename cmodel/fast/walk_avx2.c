/* walk_avx2.c - the walk with four children at once; compiled with -mavx2, see walk.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "fast/decoded.h"

#ifdef __AVX2__
#include <immintrin.h>

enum { KEY_NONE = INT32_MAX };

/* oc x u = ctr x u - org x u, so the origin is a constant of the ray, and so is what rounds: a
 * half, and 2^46, which makes the sum positive, so that it may be shifted as an unsigned number:
 * what that adds to the quotient, 2^32, is beyond the 32 bits that a product takes. */
struct lanes {
    __m256i u[3], minus[3]; /* four words of 64 bits */
    __m128i sign, plus;     /* depth = (ctr ^ sign) + plus, four words of 32 */
    __m128i ordered, lane;  /* key = (near * 4 & ordered) | lane */
    int axis;
};

typedef __m128i keys;

static struct lanes lanes_of(const struct sph_ray *ray) {
    struct lanes l;
    const int32_t *u = ray->unit.u, *o = ray->forg;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        int64_t cross = (int64_t)o[j] * u[k] - (int64_t)o[k] * u[j];
        l.u[i] = _mm256_set1_epi64x(u[i]);
        l.minus[i] = _mm256_set1_epi64x((1ll << 46) + (1 << 13) - cross);
    }
    int any = sph_ray_any(ray), sign = ray->negative ? -1 : 0, at = o[ray->axis];
    l.axis = ray->axis;
    l.sign = _mm_set1_epi32(sign);
    l.plus = _mm_set1_epi32(-sign - (sign ? -at : at));
    l.ordered = _mm_set1_epi32(any ? 0 : -1);
    l.lane = _mm_add_epi32(_mm_setr_epi32(0, 1, 2, 3), _mm_set1_epi32(any ? INT16_MIN * 4 : 0));
    return l;
}

static inline keys no_keys(void) {
    return _mm_set1_epi32(KEY_NONE);
}

static inline int32_t first(keys k) {
    return _mm_cvtsi128_si32(k);
}

static inline keys next(keys k) {
    return _mm_alignr_epi8(no_keys(), k, 4);
}

/* Four words of 16 bits, each in a word of 64, of 32. */
static inline __m256i wide(const int16_t *at) {
    return _mm256_cvtepi16_epi64(_mm_loadl_epi64((const __m128i *)(const void *)at));
}
static inline __m128i half(const int16_t *at) {
    return _mm_cvtepi16_epi32(_mm_loadl_epi64((const __m128i *)(const void *)at));
}

/* A component of the cross product, rounded: its low 32 bits. */
static inline __m256i cross(__m256i a, __m256i ub, __m256i b, __m256i ua, __m256i minus) {
    __m256i sum = _mm256_sub_epi64(_mm256_mul_epi32(a, ub), _mm256_mul_epi32(b, ua));
    return _mm256_srli_epi64(_mm256_add_epi64(sum, minus), 14);
}

/* The four least first: a network of five comparisons, in three steps. */
static inline keys sorted(keys k) {
    keys other = _mm_shuffle_epi32(k, _MM_SHUFFLE(2, 3, 0, 1));
    k = _mm_blend_epi32(_mm_min_epi32(k, other), _mm_max_epi32(k, other), 10);
    other = _mm_shuffle_epi32(k, _MM_SHUFFLE(1, 0, 3, 2));
    k = _mm_blend_epi32(_mm_min_epi32(k, other), _mm_max_epi32(k, other), 12);
    other = _mm_shuffle_epi32(k, _MM_SHUFFLE(3, 1, 2, 0));
    return _mm_blend_epi32(_mm_min_epi32(k, other), _mm_max_epi32(k, other), 4);
}

static inline unsigned children(const struct lanes *l, const struct sph_fast_node *n,
                                int32_t depth_max, keys *order) {
    __m256i x = wide(n->ctr[0]), y = wide(n->ctr[1]), z = wide(n->ctr[2]), r = wide(n->rad);
    __m256i cx = cross(y, l->u[2], z, l->u[1], l->minus[0]);
    __m256i cy = cross(z, l->u[0], x, l->u[2], l->minus[1]);
    __m256i cz = cross(x, l->u[1], y, l->u[0], l->minus[2]);
    __m256i dist2 =
        _mm256_add_epi64(_mm256_mul_epi32(cx, cx),
                         _mm256_add_epi64(_mm256_mul_epi32(cy, cy), _mm256_mul_epi32(cz, cz)));
    __m256i aside = _mm256_cmpgt_epi64(dist2, _mm256_slli_epi64(_mm256_mul_epi32(r, r), 4));
    __m128i rad = half(n->rad);
    __m128i depth = _mm_add_epi32(_mm_xor_si128(half(n->ctr[l->axis]), l->sign), l->plus);
    __m128i near = _mm_sub_epi32(depth, rad);
    __m128i out = _mm_or_si128(_mm_add_epi32(depth, rad), /* negative: it ends behind the origin */
                               _mm_cmpgt_epi32(near, _mm_set1_epi32(depth_max)));
    unsigned missed = (unsigned)_mm256_movemask_pd(_mm256_castsi256_pd(aside)) |
                      (unsigned)_mm_movemask_ps(_mm_castsi128_ps(out));
    unsigned met = ~missed & n->valid, inner = met & ((1u << n->n_inner) - 1);
    *order = no_keys();
    if (inner) {
        const __m128i bit = _mm_setr_epi32(1, 2, 4, 8);
        __m128i is = _mm_cmpeq_epi32(_mm_and_si128(_mm_set1_epi32((int)inner), bit), bit);
        __m128i key = _mm_or_si128(_mm_and_si128(_mm_slli_epi32(near, 2), l->ordered), l->lane);
        *order = sorted(_mm_blendv_epi8(no_keys(), key, is));
    }
    return met;
}

#include "fast/walk.h"

struct sph_hit (*const sph_fast_walk_avx2)(const struct sph_fast *, const struct sph_ray *,
                                           struct sph_counters *, uint32_t *, uint32_t *) = walk;
#else
struct sph_hit (*const sph_fast_walk_avx2)(const struct sph_fast *, const struct sph_ray *,
                                           struct sph_counters *, uint32_t *, uint32_t *) = NULL;
#endif
