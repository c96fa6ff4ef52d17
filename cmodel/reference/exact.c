/* exact.c - see exact.h; integers of any length, where doubles cannot tell
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/exact.h"

#include <gmp.h>
#include <limits.h>
#include <math.h>

enum { DIGITS = 53 }; /* of a double */

/* The least exponent of n numbers that are not 0: each is a whole number times 2 to that power. */
static int grain(const double *v, int n, int least) {
    for (int i = 0; i < n; i++) {
        int exponent;
        frexp(v[i], &exponent);
        if (v[i] != 0 && exponent - DIGITS < least) least = exponent - DIGITS;
    }
    return least;
}

static void whole(mpz_t out, double v, int grain) {
    int exponent;
    mpz_set_d(out, ldexp(frexp(v, &exponent), DIGITS));
    if (v != 0) mpz_mul_2exp(out, out, (mp_bitcnt_t)(exponent - DIGITS - grain));
}

int sph_ref_exact_side(const double org[3], const double dir[3], const double p[3],
                       const double q[3]) {
    mpz_t d[3], a[3], b[3], o, sum, product;
    int space = grain(org, 3, grain(p, 3, grain(q, 3, INT_MAX))), turn = grain(dir, 3, INT_MAX);
    mpz_inits(d[0], d[1], d[2], a[0], a[1], a[2], b[0], b[1], b[2], o, sum, product, NULL);
    for (int i = 0; i < 3; i++) {
        whole(d[i], dir[i], turn);
        whole(a[i], p[i], space);
        whole(b[i], q[i], space);
        whole(o, org[i], space);
        mpz_sub(a[i], a[i], o);
        mpz_sub(b[i], b[i], o);
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        mpz_mul(product, a[j], b[k]);
        mpz_submul(product, a[k], b[j]);
        mpz_addmul(sum, product, d[i]);
    }
    int sign = mpz_sgn(sum);
    mpz_clears(d[0], d[1], d[2], a[0], a[1], a[2], b[0], b[1], b[2], o, sum, product, NULL);
    return sign;
}
