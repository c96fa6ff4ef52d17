/* arith.h - square root, quotient, inverse square root, and one shift that fits a vector
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_MATH_ARITH_H
#define SPH_MATH_ARITH_H

#include <stdint.h>

#include "math/fx.h"

/* ---- integer square root (RTL: rtl/math/rt_isqrt.v) ---- */

/* floor(sqrt(x)) for x < 2^124 (the remainder and two bits more must fit a word), its `bits` most
 * significant bits, from its first 1 on, with 0s behind them; bits 0: all. *inexact = (what is
 * returned squared != x). Digit by digit, two radicand bits a step. */
uint64_t sph_isqrt_bits(sph_u128 x, int bits, int *inexact);

/* Every bit of the root. */
static inline uint64_t sph_isqrt(sph_u128 x, int *inexact) {
    return sph_isqrt_bits(x, 0, inexact);
}

/* ---- t = key / a as a normalised number (RTL: rtl/math/rt_quotient.v) ---- */

/* Quotient of normalised operands: with key = kn * 2^-zk, a = an * 2^-za, kn and an having their
 * top bit set in words of equal weight, mant = floor(kn / an * 2^(pq-1)), so that
 * key / a = mant * 2^-exp, truncated to pq or pq-1 significant bits. exp may be negative.
 * key_bits and a_bits are the widths of the operands, both operands > 0. */
struct sph_quotient {
    uint32_t mant; /* pq bits */
    int exp;
};

struct sph_quotient sph_quotient(uint64_t key, int key_bits, uint64_t a, int a_bits, int pq);

/* 1 / b, b not 0, as the first 22 bits of it, u0.22 of b from 1 to 2: at most that, by a table of
 * straight lines, which RECIPROCAL_ERROR bounds, and of the first 22 bits of b, rounded up. */
uint32_t sph_reciprocal(uint64_t b);

/* a / b, neither 0, lies in [mant, mant + 2) * 2^-exp, mant in 2^16 .. 2^18 - 1: the product of the
 * first 21 bits of a and the reciprocal of b, rounded down (formal/reciprocal.c).
 * RTL: rtl/trace/rt_bih_ray.v */
struct sph_quotient sph_ratio(uint64_t a, uint64_t b);

/* ---- unit vectors by a table of inverse square roots (RTL: rtl/math/rt_unit.v) ---- */

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

/* ---- one shift that fits a vector into a width (RTL: rtl/math/rt_normalise.v) ---- */

/* Shifts v[0..2] by one common amount so that the largest component has its top magnitude bit at
 * bits-2: left exactly, or right rounding half up (a component that rounds up to 2^(bits-1) is
 * limited to 2^(bits-1)-1). A vector of only 0 and -1 is left as it is. out: s(bits). */
void sph_normalise(const sph_i128 v[3], int bits, int64_t out[3]);

#endif
