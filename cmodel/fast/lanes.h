/* lanes.h - vectors of doubles and of integers: four doubles where the file is compiled for AVX2,
 * else two, as SSE2 and NEON have them
 * SPDX-License-Identifier: Apache-2.0
 *
 * The operators are those of the compiler (GCC, Clang); here is what it has none for.
 */
#ifndef SPH_FAST_LANES_H
#define SPH_FAST_LANES_H

#include <math.h>
#include <stdint.h>
#include <string.h>

#if defined __AVX2__ || defined __SSE2__
#include <immintrin.h>
#endif

#ifdef __AVX2__
enum { LANES = 4 };
#else
enum { LANES = 2 };
#endif

typedef double real __attribute__((vector_size(8 * LANES), may_alias));
typedef int64_t real_mask __attribute__((vector_size(8 * LANES), may_alias));
typedef int32_t four __attribute__((vector_size(16)));

/* LANES integers; the compiler's own conversion takes twice as many instructions. */
static inline real reals(const int32_t *at) {
#if defined __AVX2__
    return (real)_mm256_cvtepi32_pd(_mm_loadu_si128((const __m128i *)(const void *)at));
#elif defined __SSE2__
    return (real)_mm_cvtepi32_pd(_mm_loadl_epi64((const __m128i *)(const void *)at));
#else
    return (real){at[0], at[1]};
#endif
}

/* Of a mask one bit for each lane. */
static inline unsigned bits(real_mask m) {
#if defined __AVX2__
    return (unsigned)_mm256_movemask_pd((__m256d)m);
#elif defined __SSE2__
    return (unsigned)_mm_movemask_pd((__m128d)m);
#else
    return (unsigned)((m[0] & 1) | (m[1] & 2));
#endif
}

static inline unsigned signs(four m) {
#ifdef __SSE2__
    return (unsigned)_mm_movemask_ps((__m128)m);
#else
    return (unsigned)((m[0] & 1) | (m[1] & 2) | (m[2] & 4) | (m[3] & 8));
#endif
}

static inline real pick(real_mask m, real yes, real no) {
#if defined __AVX2__
    return (real)_mm256_blendv_pd((__m256d)no, (__m256d)yes, (__m256d)m);
#else
    return (real)((m & (real_mask)yes) | (~m & (real_mask)no));
#endif
}

static inline real greater(real x, real y) {
#if defined __AVX2__
    return (real)_mm256_max_pd((__m256d)x, (__m256d)y);
#elif defined __SSE2__
    return (real)_mm_max_pd((__m128d)x, (__m128d)y);
#else
    return pick(x > y, x, y);
#endif
}

static inline real lesser(real x, real y) {
#if defined __AVX2__
    return (real)_mm256_min_pd((__m256d)x, (__m256d)y);
#elif defined __SSE2__
    return (real)_mm_min_pd((__m128d)x, (__m128d)y);
#else
    return pick(x < y, x, y);
#endif
}

/* The greatest of the lanes. */
static inline double greatest(real x) {
    double most = x[0];
    for (int i = 1; i < LANES; i++)
        most = x[i] > most ? x[i] : most;
    return most;
}

static inline real roots(real x) {
#if defined __AVX2__
    return (real)_mm256_sqrt_pd((__m256d)x);
#elif defined __SSE2__
    return (real)_mm_sqrt_pd((__m128d)x);
#else
    return (real){sqrt(x[0]), sqrt(x[1])};
#endif
}

/* Four times the same pair, the first the lower half. */
static inline four pair(int first, int second) {
    return (four){0} + (int32_t)((uint32_t)second << 16 | (uint16_t)first);
}

/* Of four pairs the products with those of another four, added. */
static inline four products(const int16_t at[4][2], four by) {
#ifdef __SSE2__
    __m128i x = _mm_loadu_si128((const __m128i *)(const void *)at);
    return (four)_mm_madd_epi16(x, (__m128i)by);
#else
    four x;
    for (int i = 0; i < 4; i++)
        x[i] = at[i][0] * (int16_t)by[i] + at[i][1] * (by[i] >> 16);
    return x;
#endif
}

/* x[0], y[0], x[1], y[1] and so on. */
static inline void store_pairs(void *to, real_mask x, real_mask y) {
#ifdef __AVX2__
    real_mask both[2] = {__builtin_shufflevector(x, y, 0, 4, 1, 5),
                         __builtin_shufflevector(x, y, 2, 6, 3, 7)};
#else
    real_mask both[2] = {__builtin_shufflevector(x, y, 0, 2), __builtin_shufflevector(x, y, 1, 3)};
#endif
    memcpy(to, both, sizeof both);
}

#endif
