/* normalise.c - see normalise.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "math/normalise.h"

void sph_normalise(const sph_i128 v[3], int bits, int64_t out[3]) {
    sph_u128 any = 0;
    for (int i = 0; i < 3; i++)
        any |= (sph_u128)(v[i] < 0 ? ~v[i] : v[i]);
    int shift = sph_bit_length128(any) - (bits - 1); /* > 0: right */
    int64_t max = ((int64_t)1 << (bits - 1)) - 1;
    for (int i = 0; i < 3; i++) {
        if (shift > 0) {
            int64_t r = (int64_t)sph_round128(v[i], shift);
            out[i] = r > max ? max : r;
        } else {
            out[i] = (int64_t)((sph_u128)v[i] << (any ? -shift : 0));
        }
    }
}
