/* root.h - the integer root by the processor's own, corrected
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FAST_ROOT_H
#define SPH_FAST_ROOT_H

#include <math.h>

#include "math/fx.h"

/* Near x; without the call that a compiler makes of it. */
static inline double sph_fast_near(sph_i128 x) {
    return (double)(int64_t)(x >> 62) * 0x1p62 + (double)(int64_t)(x & (((int64_t)1 << 62) - 1));
}

/* floor(sqrt(x)) for x < 2^124. The doubles are a guess and no more: the loops at the end do not
 * stop before root^2 <= x < (root + 1)^2, wherever they begin. They take a step or two, for the
 * guess is off by less than 2^62 * 2^-52 + 1, and one step of Heron's leaves less than 1 of it. */
static inline uint64_t sph_fast_isqrt(sph_u128 x) {
    double guess = sqrt(sph_fast_near((sph_i128)x));
    uint64_t root = (uint64_t)(int64_t)guess;
    if (x >> 96 && root) {
        sph_i128 rest = (sph_i128)x - (sph_i128)((sph_u128)root * root);
        root += (uint64_t)(int64_t)(sph_fast_near(rest) / (2 * guess));
    }
    while ((sph_u128)root * root > x)
        root--;
    while ((sph_u128)(root + 1) * (root + 1) <= x)
        root++;
    return root;
}

/* floor(sqrt(x)) of x < 2^104 from a guess that is less than 2^9 off, and *rest, x - root^2:
 * numbers of 64 bits hold what is left of x. */
static inline uint64_t sph_fast_isqrt_near(sph_u128 x, double guess, int64_t *rest) {
    int64_t root = (int64_t)guess, r = (int64_t)((uint64_t)x - (uint64_t)root * (uint64_t)root);
    for (; r < 0; root--)
        r += 2 * root - 1;
    for (; r > 2 * root; root++)
        r -= 2 * root + 1;
    *rest = r;
    return (uint64_t)root;
}

/* floor(sqrt(disc)), disc = k * a + b * b > 0, b > 0 or k > 0, of numbers below 2^52; *inexact: it
 * is no square. In doubles disc is off by less than 2^-51 of b * b where k < 0, and its root by
 * less than b * 2^-43 if it is not much smaller; else it is too small for them. */
static inline uint64_t sph_fast_root(sph_i128 disc, int64_t k, uint64_t a, int64_t b,
                                     int *inexact) {
    double square = (double)b * (double)b, near = (double)k * (double)(int64_t)a + square;
    if (near > square * 0x1p-18) {
        int64_t rest;
        uint64_t root = sph_fast_isqrt_near((sph_u128)disc, sqrt(near), &rest);
        *inexact = rest != 0;
        return root;
    }
    uint64_t root = sph_fast_isqrt((sph_u128)disc);
    *inexact = (sph_u128)root * root != (sph_u128)disc;
    return root;
}

/* As sph_isqrt_bits(): the root's `bits` most significant bits, 0: all. */
static inline uint64_t sph_fast_isqrt_bits(sph_u128 x, int bits, int *inexact) {
    uint64_t root = sph_fast_isqrt(x);
    int length = sph_bit_length(root), left = bits > 0 && length > bits ? length - bits : 0;
    root = root >> left << left;
    *inexact = (sph_u128)root * root != x;
    return root;
}

#endif
