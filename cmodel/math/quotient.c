/* quotient.c - see quotient.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "math/quotient.h"

#include "math/fx.h"

struct sph_quotient sph_quotient(uint64_t key, int key_bits, uint64_t a, int a_bits, int pq) {
    int zk = key_bits - sph_bit_length(key), za = a_bits - sph_bit_length(a);
    int bits = key_bits > a_bits ? key_bits : a_bits;
    uint64_t rem = key << (zk + bits - key_bits), div = a << (za + bits - a_bits);
    uint32_t mant = 0;
    for (int i = 0; i < pq; i++) { /* restoring division: invariant rem < 2 * div */
        mant <<= 1;
        if (rem >= div) {
            rem -= div;
            mant |= 1;
        }
        rem <<= 1;
    }
    return (struct sph_quotient){mant, pq - 1 - key_bits + zk + a_bits - za};
}
