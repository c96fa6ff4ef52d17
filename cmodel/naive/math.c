/* math.c - see math.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "naive/math.h"

#include "math/rsqrt_table.h" /* data only */

void sph_naive_round(mpz_t x, long n) {
    if (n <= 0) {
        mpz_mul_2exp(x, x, (mp_bitcnt_t)-n);
        return;
    }
    mpz_t half;
    mpz_init_set_ui(half, 1);
    mpz_mul_2exp(half, half, (mp_bitcnt_t)(n - 1));
    mpz_add(x, x, half);
    mpz_fdiv_q_2exp(x, x, (mp_bitcnt_t)n);
    mpz_clear(half);
}

int64_t sph_naive_round64(int64_t x, int n) {
    mpz_t big;
    mpz_init_set_si(big, x);
    sph_naive_round(big, n);
    x = mpz_get_si(big);
    mpz_clear(big);
    return x;
}

int64_t sph_naive_limit(const mpz_t x, int bits) {
    int64_t end = 1;
    for (int i = 1; i < bits; i++)
        end *= 2;
    if (mpz_cmp_si(x, end - 1) > 0) return end - 1;
    if (mpz_cmp_si(x, -end) < 0) return -end;
    return mpz_get_si(x);
}

long sph_naive_quotient(uint64_t key, uint64_t a, int pq, uint64_t *mant) {
    mpz_t n, d;
    mpz_init_set_ui(n, key);
    mpz_init_set_ui(d, a);
    long exp = pq - 1 + (long)mpz_sizeinbase(d, 2) - (long)mpz_sizeinbase(n, 2);
    if (exp >= 0)
        mpz_mul_2exp(n, n, (mp_bitcnt_t)exp);
    else
        mpz_mul_2exp(d, d, (mp_bitcnt_t)-exp);
    mpz_fdiv_q(n, n, d);
    *mant = mpz_get_ui(n);
    mpz_clears(n, d, NULL);
    return exp;
}

/* Bits of x in two's complement without the sign: -2^k and 2^k - 1 need k. */
static long length(const mpz_t x) {
    mpz_t y;
    mpz_init_set(y, x);
    if (mpz_sgn(y) < 0) mpz_com(y, y);
    long bits = mpz_sgn(y) ? (long)mpz_sizeinbase(y, 2) : 0;
    mpz_clear(y);
    return bits;
}

void sph_naive_normalise(mpz_t v[3], int bits, int64_t out[3]) {
    long longest = 0;
    for (int i = 0; i < 3; i++) {
        long n = length(v[i]);
        longest = n > longest ? n : longest;
    }
    for (int i = 0; i < 3; i++) {
        if (longest) sph_naive_round(v[i], longest - (bits - 1));
        out[i] = sph_naive_limit(v[i], bits);
    }
}

void sph_naive_unit(const int64_t v[3], int bits, int64_t u[3]) {
    mpz_t length2, bound;
    mpz_inits(length2, bound, NULL);
    for (int i = 0; i < 3; i++) {
        mpz_set_si(bound, v[i]);
        mpz_addmul(length2, bound, bound);
        u[i] = 0;
    }
    if (mpz_sgn(length2)) {
        int h = 0; /* the least that brings |v| * 2^h to 2^(bits-1) */
        mpz_set_ui(bound, 1);
        mpz_mul_2exp(bound, bound, (mp_bitcnt_t)(2 * bits - 2));
        while (mpz_cmp(length2, bound) < 0) {
            mpz_mul_2exp(length2, length2, 2);
            h++;
        }
        mpz_fdiv_q_2exp(length2, length2, (mp_bitcnt_t)(2 * bits - 18));
        uint64_t x = mpz_get_ui(length2), line = x / 1024 - 64;
        uint64_t drop = sph_rsqrt_table[line].slope * (x % 1024) / 1024;
        for (int i = 0; i < 3; i++) {
            mpz_set_si(bound, v[i]);
            mpz_mul_2exp(bound, bound, (mp_bitcnt_t)h);
            mpz_mul_ui(bound, bound, sph_rsqrt_table[line].start - drop);
            sph_naive_round(bound, bits);
            u[i] = mpz_get_si(bound);
        }
    }
    mpz_clears(length2, bound, NULL);
}
