/* quotient.h - t = key / a as a normalised number                     RTL: rtl/math/rt_quotient.v
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_QUOTIENT_H
#define SPH_QUOTIENT_H

#include <stdint.h>

/* Quotient of normalised operands: with key = kn * 2^-zk, a = an * 2^-za, kn and an having their
 * top bit set in words of equal weight, mant = floor(kn / an * 2^(pq-1)), so that
 * key / a = mant * 2^-exp, truncated to pq or pq-1 significant bits. exp may be negative.
 * key_bits and a_bits are the widths of the operands, both operands > 0. */
struct sph_quotient {
    uint32_t mant; /* pq bits */
    int exp;
};

struct sph_quotient sph_quotient(uint64_t key, int key_bits, uint64_t a, int a_bits, int pq);

#endif
