/* rsqrt.h - unit vectors by a table of inverse square roots             RTL: rtl/math/rt_unit.v
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_RSQRT_H
#define SPH_RSQRT_H

#include <stdint.h>

/* 2^16 / sqrt(x * 2^-18) for x = 2^16 .. 2^18-1, by 192 straight lines, from below:
 * y <= 2^25 / sqrt(x+1) and y + SPH_RSQRT_ERROR >= 2^25 / sqrt(x)
 * (gen_rsqrt.c makes the table and proves both exhaustively). u1.16, at most 2^17-1. */
uint32_t sph_rsqrt(uint32_t x);

/* v / |v| of an integer vector. vv = v.v < 2^(2*bits), v: s(bits); of a wider one, which only
 * registers that no machine has make, the bits that are too many are dropped.
 * u: s1.16, |u| <= 1 up to roundings of half a unit; (0,0,0) for v = 0.
 * 1/|v| is y * 2^(h - bits - 16), from below within SPH_RSQRT_ERROR units of y. */
struct sph_unit {
    int32_t u[3];
    uint32_t y; /* u1.16 */
    int h;      /* left shift that brought |v| into [2^(bits-1), 2^bits); below 0 to the right */
};

struct sph_unit sph_unit(const int64_t v[3], uint64_t vv, int bits);

#endif
