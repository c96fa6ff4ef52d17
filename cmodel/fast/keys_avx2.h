/* keys_avx2.h - the order in which four children are visited, for walk_avx2.c, walk_boxes_avx2.c
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FAST_KEYS_AVX2_H
#define SPH_FAST_KEYS_AVX2_H

#include <immintrin.h>
#include <stdint.h>

#include "fast/decoded.h"

enum { KEY_NONE = 0xffff };

/* Four words of 16 bits, and four that are all ones: how near each child is, all ones if it is not
 * to be visited. A key is one of these words below the number of the child. */
typedef __m128i keys;

static const uint64_t lane_word[4] = {0xffff, 0xffffull << 16, 0xffffull << 32, 0xffffull << 48};

static inline keys no_keys(void) {
    return _mm_set1_epi32(-1);
}

/* The keys of inner children: near, below KEY_NONE; missed, all ones or 0, all ones where there is
 * no child of that number. */
static inline keys keys_of(__m128i near, __m128i missed, const struct sph_fast_node *n) {
    __m128i outer = _mm_cvtepi8_epi16(_mm_loadu_si32(n->outer));
    return _mm_or_si128(_mm_or_si128(near, outer), missed);
}

/* Bit 2 i: leaf child i is met. */
static inline unsigned leaves_of(__m128i missed, const struct sph_fast_node *n) {
    return ~(unsigned)_mm_movemask_epi8(missed) & n->leaves;
}

static inline int32_t first(keys k) {
    return _mm_cvtsi128_si32(_mm_minpos_epu16(k));
}

static inline int any(keys k) {
    return first(k) != KEY_NONE;
}

static inline uint32_t child_of(int32_t key) {
    return (uint32_t)key >> 16;
}

static inline int is_child(int32_t key, int i) {
    return child_of(key) == (uint32_t)i;
}

static inline int within(int32_t key, int32_t near) {
    return (key & 0xffff) <= near;
}

static inline keys without(keys k, int32_t key) {
    return _mm_or_si128(k,
                        _mm_loadl_epi64((const __m128i *)(const void *)&lane_word[child_of(key)]));
}

#endif
