/* isqrt.c - see isqrt.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "math/isqrt.h"

uint64_t sph_isqrt(sph_u128 x, int *inexact) {
    uint64_t root = 0, rem = 0; /* invariant: rem = (x / 4^i) - root^2 <= 2*root */
    for (int i = (sph_bit_length128(x) + 1) / 2 - 1; i >= 0; i--) {
        rem = rem << 2 | (uint64_t)(x >> (2 * i) & 3);
        uint64_t trial = root << 2 | 1;
        root <<= 1;
        if (rem >= trial) {
            rem -= trial;
            root |= 1;
        }
    }
    *inexact = rem != 0;
    return root;
}
