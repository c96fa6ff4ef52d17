/* reciprocal.c - proof for every divisor: a / b lies in [mant, mant + 2) of sph_ratio()
 * SPDX-License-Identifier: Apache-2.0
 *
 * With A the first 21 bits of a, A <= a < A + 1, and l the length of b: mant is the floor of
 * A y 2^-25, and has to be at most 2^17 (A 2^-20) / (b 2^(1-l)); that plus 2 is above A y 2^-25 +
 * 1, which has to be at least the same of A + 1. The first holds if y b <= 2^(l+21); the second is
 * linear in A, so that its ends are enough. All b of 22 bits are tried, and of longer ones, which
 * are cut, the least and the greatest of those that are cut alike.
 *
 * rt_divide takes 21 bits of y, of any divisor as if it had been cut: with x its first 22 bits, y x
 * 2^-42 is at least 1 - 41/2^24, and y (x + 1) 2^-42 at most 1.
 *
 * Exit: 0 all hold, 1 one does not.
 */
#include <stdint.h>
#include <stdio.h>

#include "math/arith.h"
#include "math/fx.h"

enum { A = 21, X = 22, CUT = 9 }; /* bits; a direction has at most 31 */

static int holds(uint64_t b) {
    int length = sph_bit_length(b);
    sph_u128 y = sph_reciprocal(b), one = (sph_u128)1 << (length + 21);
    if (y >> 22 || !(y >> 21) || y * b > one) return 0;
    for (uint64_t a = 1 << (A - 1); a < 1 << A; a += (1 << (A - 1)) - 1) {
        struct sph_quotient q = sph_ratio(a, b);
        if (q.mant != (uint32_t)(a * (uint64_t)y >> 25) || q.exp != 17 - A + length) return 0;
        if ((a * y + (1 << 25)) * b < (a + 1) * one) return 0;
    }
    return 1;
}

static int divides(uint64_t x) {
    sph_u128 y = sph_reciprocal((x << 1) + 1) >> 1, one = (sph_u128)1 << 42;
    return y * (x + 1) <= one && (y * x << 24) >= one * ((1 << 24) - 41);
}

int main(void) {
    for (uint64_t x = 1 << (X - 1); x < 1 << X; x++)
        if (!divides(x)) return printf("not of %llu\n", (unsigned long long)x), 1;
    for (uint64_t b = 1; b < 1 << X; b++)
        if (!holds(b)) return printf("not of %llu\n", (unsigned long long)b), 1;
    for (uint64_t x = 1 << (X - 1); x < 1 << X; x++)
        for (int cut = 3; cut <= CUT; cut += CUT - 3) {
            const uint64_t ends[] = {x << cut, (x << cut) + 1, ((x + 1) << cut) - 1};
            for (int i = 0; i < 3; i++)
                if (!holds(ends[i])) return printf("not of %llu\n", (unsigned long long)ends[i]), 1;
        }
    return 0;
}
