/* spheres_avx2.h - four spheres of a node at once, for walk_avx2.c and walk_any_avx2.c
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FAST_SPHERES_AVX2_H
#define SPH_FAST_SPHERES_AVX2_H

#include <immintrin.h>
#include <stddef.h>

#include "fast/decoded.h"
#include "machine/layout.h"

/* Numbers of 18 bits as products of 16 bits take them: high * 2^LOW + low. */
enum { LOW = 9 };

/* The two axes across the ray, four words of 32 bits each, for pairs of x and y and of z and
 * radius, which counts 0 times. */
struct across {
    __m256i xy_high, xy_low, z_high, z_low;
};

struct lanes {
    __m256i org_xy, org_z; /* eight times x and y, z and 0 */
    struct across pq;
    __m128i pick, org, sign; /* depth = ((coordinate of a pair) - org) * sign */
    __m128i most;            /* no child is nearer than this */
    size_t along;            /* where in a node the pairs with the coordinate are */
};

/* A word of 16 bits of each pair: the first, the second. */
static const _Alignas(16) uint8_t of_pair[2][16] = {
    {0, 1, 4, 5, 8, 9, 12, 13, 128, 128, 128, 128, 128, 128, 128, 128},
    {2, 3, 6, 7, 10, 11, 14, 15, 128, 128, 128, 128, 128, 128, 128, 128}};

/* p from words 1 and 2, without the axis of this number. */
enum { NO = 0x80808080, A = 0x07060504, B = 0x0b0a0908 };
static const _Alignas(16) uint32_t of_p[3][4] = {{NO, A, B, NO}, {A, NO, B, NO}, {A, B, NO, NO}};

/* Constants, which are loaded sooner than they are made. */
#define FOUR(x) x, x, x, x
static const _Alignas(16) int32_t p_sign[4] = {0, 1, -1, 0};
static const _Alignas(16) int32_t low_bits[4] = {FOUR((1 << LOW) - 1)};
static const _Alignas(16) int16_t signs[2][8] = {{FOUR(1), FOUR(1)}, {FOUR(-1), FOUR(-1)}};
/* Pairs of p, then of q: x and y, z and radius. */
static const _Alignas(32) int32_t of_pq[2][8] = {{FOUR(0x0b0a0908), FOUR(0x03020100)},
                                                 {FOUR(0x0f0e0d0c), FOUR(0x07060504)}};

_Static_assert(offsetof(struct sph_across, p_a) == offsetof(struct sph_across, axis_b) + 4 &&
                   offsetof(struct sph_across, p_b) == offsetof(struct sph_across, axis_b) + 8 &&
                   offsetof(struct sph_across, q) == offsetof(struct sph_across, p_b) + 4,
               "words are loaded together");

static inline __m128i load(const void *at) {
    return _mm_load_si128(at);
}

static inline __m256i twice(__m128i x) {
    return _mm256_broadcastsi128_si256(x);
}

static inline struct lanes lanes_of(const struct sph_profile *p, const struct sph_ray *ray) {
    (void)p;
    struct lanes l;
    const struct sph_across *a = &ray->across;
    const int32_t *o = ray->forg;
    const __m128i *from_p = (const void *)&a->axis_b, *from_q = (const void *)&a->p_b;
    __m128i q = _mm_srli_si128(_mm_loadu_si128(from_q), 4);
    __m128i x = _mm_sign_epi32(_mm_loadu_si128(from_p), load(p_sign));
    x = _mm_shuffle_epi8(x, load(of_p[3 - a->axis_a - a->axis_b]));
    __m128i ones = load(low_bits);
    __m256i high = twice(_mm_packs_epi32(_mm_srai_epi32(q, LOW), _mm_srai_epi32(x, LOW)));
    __m256i low = twice(_mm_packs_epi32(_mm_and_si128(q, ones), _mm_and_si128(x, ones)));
    __m256i xy = _mm256_load_si256((const void *)of_pq[0]);
    __m256i z = _mm256_load_si256((const void *)of_pq[1]);
    l.pq.xy_high = _mm256_shuffle_epi8(high, xy);
    l.pq.xy_low = _mm256_shuffle_epi8(low, xy);
    l.pq.z_high = _mm256_shuffle_epi8(high, z);
    l.pq.z_low = _mm256_shuffle_epi8(low, z);
    l.org_xy = _mm256_set1_epi32((int32_t)((uint32_t)o[1] << 16 | (uint16_t)o[0]));
    l.org_z = _mm256_set1_epi32((uint16_t)o[2]);
    l.pick = load(of_pair[ray->axis == 1]);
    l.org = _mm_set1_epi16((int16_t)o[ray->axis]);
    l.sign = load(signs[ray->negative]);
    l.along =
        ray->axis < 2 ? offsetof(struct sph_fast_node, xy) : offsetof(struct sph_fast_node, zr);
    return l;
}

static inline void limit_to(struct lanes *l, int32_t depth_max) {
    l->most = _mm_set1_epi16((int16_t)depth_max);
}

/* The distances along the axes: whole units of 2^-FRACTION, rounded down. */
static inline __m256i distances(const struct across *a, __m256i xy, __m256i zr) {
    __m256i high =
        _mm256_add_epi32(_mm256_madd_epi16(xy, a->xy_high), _mm256_madd_epi16(zr, a->z_high));
    __m256i low =
        _mm256_add_epi32(_mm256_madd_epi16(xy, a->xy_low), _mm256_madd_epi16(zr, a->z_low));
    return _mm256_srai_epi32(_mm256_add_epi32(high, _mm256_srai_epi32(low, LOW)),
                             17 - SPH_FILTER_FRACTION - LOW);
}

/* Distances are as filter.c says; those of 16 bits and more become the greatest of 15, and miss
 * each child: a radius has 14 + FRACTION bits, and is even. Where there is no child, its square is
 * -1. Words of 16 bits: all ones, the child is missed, or there is none of that number; how near it
 * is. */
static inline __m128i missed_of(const struct lanes *l, const struct sph_fast_node *n,
                                __m128i *nearest) {
    __m128i zr = load(n->zr);
    __m256i oc_xy = _mm256_sub_epi16(_mm256_broadcastsi128_si256(load(n->xy)), l->org_xy);
    __m256i oc_zr = _mm256_sub_epi16(_mm256_broadcastsi128_si256(zr), l->org_z);
    __m256i across = distances(&l->pq, oc_xy, oc_zr);
    across = _mm256_packs_epi32(across, across);
    __m128i pq =
        _mm_unpacklo_epi16(_mm256_castsi256_si128(across), _mm256_extracti128_si256(across, 1));
    pq = _mm_xor_si128(pq, _mm_srai_epi16(pq, 15));
    __m128i aside = _mm_cmpgt_epi32(_mm_madd_epi16(pq, pq), load(n->square));

    __m128i rad = _mm_shuffle_epi8(zr, load(of_pair[1]));
    __m128i at = _mm_shuffle_epi8(load((const char *)n + l->along), l->pick);
    __m128i depth = _mm_sign_epi16(_mm_sub_epi16(at, l->org), l->sign);
    __m128i near = _mm_sub_epi16(depth, rad), end = _mm_add_epi16(depth, rad);
    __m128i out = _mm_or_si128(_mm_srai_epi16(end, 15), /* it ends behind the origin */
                               _mm_cmpgt_epi16(near, l->most));
    *nearest = near;
    return _mm_or_si128(_mm_packs_epi32(aside, _mm_set1_epi32(-1)), out);
}

#endif
