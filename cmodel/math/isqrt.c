/* isqrt.c - see isqrt.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "math/isqrt.h"

uint64_t sph_isqrt_bits(sph_u128 x, int bits, int *inexact) {
    uint64_t root = 0, rem = 0; /* invariant: rem = (x / 4^i) - root^2 <= 2*root */
    int length = (sph_bit_length128(x) + 1) / 2,
        left = bits > 0 && length > bits ? length - bits : 0;
    for (int i = length - 1; i >= left; i--) {
        rem = rem << 2 | (uint64_t)(x >> (2 * i) & 3);
        uint64_t trial = root << 2 | 1;
        root <<= 1;
        if (rem >= trial) {
            rem -= trial;
            root |= 1;
        }
    }
    *inexact = rem != 0 || (x & (((sph_u128)1 << (2 * left)) - 1)) != 0;
    return root << left;
}
