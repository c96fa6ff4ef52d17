/* roots.c - sph_isqrt_bits() and sph_quotient() of every input of small widths
 * SPDX-License-Identifier: Apache-2.0
 *
 * Root: root^2 <= x < (root+1)^2, of it the first BITS bits, and whether what is left squared is x.
 * Quotient: mant <= key / a * 2^exp < mant + 1, and mant has PQ bits or one less. digits.smt2 shows
 * for all integers that one digit more keeps this.
 */
#include <stdio.h>

#include "math/arith.h"

#ifndef XW
#define XW 16 /* radicands */
#define KW 6  /* operands of a quotient, and its bits */
#endif

static int roots(void) {
    uint64_t root = 0;
    for (uint64_t x = 0; x < 1u << XW; x++) {
        if ((root + 1) * (root + 1) <= x) root++;
        for (int bits = 0; bits <= XW / 2; bits++) {
            int inexact, length = sph_bit_length(root);
            int left = bits && length > bits ? length - bits : 0;
            uint64_t want = root >> left << left, got = sph_isqrt_bits(x, bits, &inexact);
            if (got == want && inexact == (want * want != x)) continue;
            printf("fails: x %llu, bits %d\n", (unsigned long long)x, bits);
            return 1;
        }
    }
    return 0;
}

static int quotients(int key_bits, int a_bits, int pq) {
    for (uint64_t key = 1; key < 1ull << key_bits; key++)
        for (uint64_t a = 1; a < 1ull << a_bits; a++) {
            struct sph_quotient q = sph_quotient(key, key_bits, a, a_bits, pq);
            uint64_t up = q.exp > 0 ? key << q.exp : key, over = q.exp < 0 ? a << -q.exp : a;
            if (q.mant * over <= up && up < (q.mant + 1) * over && q.mant >> (pq - 2) &&
                !(q.mant >> pq))
                continue;
            printf("fails: key %llu of %d, a %llu of %d, pq %d\n", (unsigned long long)key,
                   key_bits, (unsigned long long)a, a_bits, pq);
            return 1;
        }
    return 0;
}

int main(void) {
    int bad = roots();
    for (int key_bits = 1; key_bits <= KW; key_bits++)
        for (int a_bits = 1; a_bits <= KW; a_bits++)
            for (int pq = 2; pq <= KW; pq++)
                bad |= quotients(key_bits, a_bits, pq);
    return bad;
}
