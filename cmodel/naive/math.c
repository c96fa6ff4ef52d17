/* math.c - see math.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "naive/math.h"

#include <math.h>

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

uint64_t sph_naive_inverse_length(const int64_t v[3], int bits, int *h) {
    mpz_t length2, bound;
    uint64_t y = 0;
    mpz_inits(length2, bound, NULL);
    for (int i = 0; i < 3; i++) {
        mpz_set_si(bound, v[i]);
        mpz_addmul(length2, bound, bound);
    }
    *h = 0;
    if (mpz_sgn(length2)) {
        mpz_set_ui(bound, 1);
        mpz_mul_2exp(bound, bound, (mp_bitcnt_t)(2 * bits - 2));
        while (mpz_cmp(length2, bound) < 0) {
            mpz_mul_2exp(length2, length2, 2);
            ++*h;
        }
        mpz_fdiv_q_2exp(length2, length2, (mp_bitcnt_t)(2 * bits - 18));
        uint64_t x = mpz_get_ui(length2), line = x / 1024 - 64;
        y = sph_rsqrt_table[line].start - sph_rsqrt_table[line].slope * (x % 1024) / 1024;
    }
    mpz_clears(length2, bound, NULL);
    return y;
}

void sph_naive_unit(const int64_t v[3], int bits, int64_t u[3]) {
    int h;
    uint64_t y = sph_naive_inverse_length(v, bits, &h);
    mpz_t x;
    mpz_init(x);
    for (int i = 0; i < 3; i++) {
        mpz_set_si(x, v[i]);
        mpz_mul_2exp(x, x, (mp_bitcnt_t)h);
        mpz_mul_ui(x, x, y);
        sph_naive_round(x, bits);
        u[i] = mpz_get_si(x);
    }
    mpz_clear(x);
}

/* ---- optics ---- */
/* Lagrange's identity gives the sine, |d x n|; tables come from the library's logarithms. */

static void dot(mpz_t out, mpz_t a[3], mpz_t b[3]) {
    mpz_set_ui(out, 0);
    for (int i = 0; i < 3; i++)
        mpz_addmul(out, a[i], b[i]);
}

/* v times the least power of two that makes it at least 2^(bits-1) long, and its square. */
static void stretch(const int64_t v[3], int bits, mpz_t out[3], mpz_t square) {
    mpz_t least;
    mpz_init_set_ui(least, 1);
    mpz_mul_2exp(least, least, (mp_bitcnt_t)(2 * bits - 2));
    for (int i = 0; i < 3; i++)
        mpz_set_si(out[i], v[i]);
    for (dot(square, out, out); mpz_cmp(square, least) < 0; dot(square, out, out))
        for (int i = 0; i < 3; i++)
            mpz_mul_ui(out[i], out[i], 2);
    mpz_clear(least);
}

/* x = floor(sqrt(x) / 2^cut) * 2^cut, of which only pr significant bits are kept if pr > 0. */
static void root(mpz_t x, long cut, int pr) {
    mpz_sqrt(x, x);
    mpz_fdiv_q_2exp(x, x, (mp_bitcnt_t)cut);
    long more = mpz_sgn(x) && pr ? (long)mpz_sizeinbase(x, 2) - pr : 0;
    if (more > 0) {
        mpz_fdiv_q_2exp(x, x, (mp_bitcnt_t)more);
        mpz_mul_2exp(x, x, (mp_bitcnt_t)more);
    }
    mpz_mul_2exp(x, x, (mp_bitcnt_t)cut);
}

int sph_naive_refract(const struct sph_profile *p, const int64_t d[3], const int64_t n[3],
                      uint32_t from, uint32_t to, int64_t out[3]) {
    mpz_t v[3], w[3], a, nn, dn, x, y;
    mpz_inits(v[0], v[1], v[2], w[0], w[1], w[2], a, nn, dn, x, y, NULL);
    stretch(d, p->wd, v, a);
    stretch(n, p->wd, w, nn);
    dot(dn, v, w);
    mpz_mul(x, a, nn); /* to^2 |d|^2 |n|^2 - from^2 |d x n|^2 */
    mpz_mul_ui(x, x, (unsigned long)to * to);
    for (int i = 0; i < 3; i++) {
        mpz_mul(y, v[(i + 1) % 3], w[(i + 2) % 3]);
        mpz_submul(y, v[(i + 2) % 3], w[(i + 1) % 3]);
        mpz_mul(y, y, y);
        mpz_submul_ui(x, y, (unsigned long)from * from);
    }
    int through = mpz_sgn(x) >= 0;
    if (through) {
        root(x, p->wd - p->w + 12, p->pr);
        mpz_addmul_ui(x, dn, from);
        mpz_mul_ui(nn, nn, from);
        for (int i = 0; i < 3; i++) {
            mpz_mul(v[i], v[i], nn);
            mpz_submul(v[i], w[i], x);
        }
        sph_naive_normalise(v, p->wd, out);
    }
    mpz_clears(v[0], v[1], v[2], w[0], w[1], w[2], a, nn, dn, x, y, NULL);
    return through;
}

/* Between round(65536 * f(i / 256)) and the next of them, f = log2(1 + x) or 2^-x: at part/256 of
 * the way, towards the first. */
static int64_t between(double (*f)(double), int64_t at) {
    int64_t i = at / 256, part = at % 256;
    int64_t low = lround(65536 * f((double)i / 256)),
            high = lround(65536 * f((double)(i + 1) / 256));
    return low + (high - low) * part / 256;
}

static double log2_of_1_plus(double x) {
    return log2(1 + x);
}

static double half_to(double x) {
    return exp2(-x);
}

int64_t sph_naive_specular(const int64_t n[3], const int64_t l[3], const int64_t d[3],
                           uint32_t power) {
    int64_t nl = 0, nd = 0, ld = 0, e = 0;
    for (int i = 0; i < 3; i++) {
        nl += n[i] * l[i];
        nd += n[i] * d[i];
        ld += l[i] * d[i];
    }
    ld -= 2 * sph_naive_round64(nl, 16) * sph_naive_round64(nd, 16);
    int64_t c = sph_naive_round64(ld, 16);
    if (c <= 0) return 0;
    if (c > 65536) c = 65536;
    for (; c < 65536; c *= 2)
        e += 65536;
    e = (e - between(log2_of_1_plus, c - 65536)) * power / 16;
    int64_t shine = between(half_to, e % 65536);
    return sph_naive_round64(shine, (int)(e / 65536 < 40 ? e / 65536 : 40) + 1);
}
