/* fx.h - the named rounding rules of the machine                    RTL: rtl/math/rt_fx.vh
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FX_H
#define SPH_FX_H

#include <stdint.h>

typedef __int128 sph_i128;
typedef unsigned __int128 sph_u128;

/* floor(x / 2^n + 1/2): round half up, n >= 0. */
static inline int64_t sph_round(int64_t x, int n) {
    return n == 0 ? x : ((x >> (n - 1)) + 1) >> 1;
}

static inline sph_i128 sph_round128(sph_i128 x, int n) {
    return n == 0 ? x : ((x >> (n - 1)) + 1) >> 1;
}

/* x limited to what `bits` bits of two's complement hold; *saturated is set if that changed it. */
static inline int64_t sph_saturate(int64_t x, int bits, int *saturated) {
    int64_t max = ((int64_t)1 << (bits - 1)) - 1;
    if (x > max) return *saturated = 1, max;
    if (x < -max - 1) return *saturated = 1, -max - 1;
    return x;
}

/* Number of bits of x: 0 for 0, else 1 + floor(log2(x)). */
static inline int sph_bit_length(uint64_t x) {
    return x ? 64 - __builtin_clzll(x) : 0;
}

static inline int sph_bit_length128(sph_u128 x) {
    uint64_t high = (uint64_t)(x >> 64);
    return high ? 64 + sph_bit_length(high) : sph_bit_length((uint64_t)x);
}

#endif
