/* arith.c - see arith.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "math/fx.h"
#include "math/arith.h"
#include "math/reciprocal_table.h"
#include "math/rsqrt_table.h"

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

/* ---- quotient ---- */

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

uint32_t sph_reciprocal(uint64_t b) {
    enum { X = 22, REST = 12, HALF = 1 << 21 };
    int length = sph_bit_length(b);
    uint64_t x = length > X ? b >> (length - X) : b << (X - length);
    uint32_t index = (uint32_t)(x >> REST) & 511, rest = (uint32_t)x & ((1 << REST) - 1);
    if (length > X && x << (length - X) != b) rest++;
    uint32_t y = sph_reciprocal_table[index].start -
                 ((sph_reciprocal_table[index].slope * rest + 2047) >> 11);
    return y < HALF ? HALF : y;
}

struct sph_quotient sph_ratio(uint64_t a, uint64_t b) {
    enum { A = 21 };
    int length = sph_bit_length(a);
    uint64_t top = length > A ? a >> (length - A) : a << (A - length);
    return (struct sph_quotient){(uint32_t)(top * sph_reciprocal(b) >> 25),
                                 17 - length + sph_bit_length(b)};
}

/* ---- rsqrt ---- */

uint32_t sph_rsqrt(uint32_t x) {
    uint32_t i = (x >> 10) - 64, frac = x & 1023;
    return sph_rsqrt_table[i].start - (sph_rsqrt_table[i].slope * frac >> 10);
}

struct sph_unit sph_unit(const int64_t v[3], uint64_t vv, int bits) {
    struct sph_unit r = {{0, 0, 0}, 0, 0};
    if (!vv) return r;
    r.h = (2 * bits - sph_bit_length(vv)) >> 1;
    int up = r.h > 0 ? r.h : 0, down = up - r.h;
    r.y = sph_rsqrt((uint32_t)(vv << (2 * up) >> (2 * down) >> (2 * bits - 18)));
    for (int i = 0; i < 3; i++)
        r.u[i] = (int32_t)sph_round((int64_t)((uint64_t)v[i] << up) * r.y >> down, bits);
    return r;
}

/* ---- normalise ---- */

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
