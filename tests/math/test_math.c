/* test_math.c - roots, quotients, inverse roots, units, normalising and rounding
 * SPDX-License-Identifier: Apache-2.0
 *
 * Everything is compared with GMP or with the second model (cmodel/naive/math.h).
 */
#include "vectors.h"

#include <gmp.h>
#include <math.h>

#include "math/arith.h"
#include "math/rsqrt_table.h"
#include "naive/math.h"

static void set_u128(mpz_t z, sph_u128 x) {
    mpz_set_ui(z, (uint64_t)(x >> 64));
    mpz_mul_2exp(z, z, 64);
    mpz_add_ui(z, z, (uint64_t)x);
}

static void check_root(sph_u128 x) {
    mpz_t z, rest;
    mpz_inits(z, rest, NULL);
    int inexact;
    uint64_t root = sph_isqrt(x, &inexact);
    set_u128(z, x);
    mpz_sqrtrem(z, rest, z);
    if (mpz_get_ui(z) != root || inexact != (mpz_sgn(rest) != 0))
        fail_msg("isqrt(0x%llx%016llx) = 0x%llx, inexact %d", (unsigned long long)(x >> 64),
                 (unsigned long long)x, (unsigned long long)root, inexact);
    mpz_clears(z, rest, NULL);
}

static void isqrt_small(void **state) {
    (void)state;
    uint64_t expected = 0;
    for (uint64_t x = 0; x < (1u << 22) / VEC_SHARE; x++) {
        int inexact;
        if ((expected + 1) * (expected + 1) <= x) expected++;
        assert_int_equal(sph_isqrt(x, &inexact), expected);
        assert_int_equal(inexact, expected * expected != x);
    }
}

static void isqrt_corners(void **state) {
    (void)state;
    for (int k = 0; k <= 98; k++) /* the widest radicand is u98 */
        for (uint64_t i = 0; i <= 4; i++)
            if (k > 0 || i > 0) check_root(((sph_u128)1 << k) + i - 2);
}

static void isqrt_random(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("isqrt_random");
    for (int i = 0; i < 300000 / VEC_SHARE; i++) {
        uint64_t root = vec_unsigned(&rng, 49);
        sph_u128 square = (sph_u128)root * root;
        check_root(square); /* exact, the last below it, the last with this root, any other */
        if (square) check_root(square - 1);
        check_root(square + 2 * (sph_u128)root);
        check_root((sph_u128)vec_unsigned(&rng, 49) << 49 | vec_unsigned(&rng, 49));
    }
}

static void check_quotient(const struct sph_profile *p, uint64_t key, uint64_t a) {
    uint64_t mant;
    if (!key || !a) return;
    long exp = sph_naive_quotient(key, a, p->pq, &mant);
    struct sph_quotient q = sph_quotient(key, p->w + p->wd + 2, a, 2 * p->wd, p->pq);
    int bits = sph_bit_length(q.mant);
    if (q.mant != mant || q.exp != exp || bits > p->pq || bits < p->pq - 1)
        fail_msg("%s: %llu / %llu = %u * 2^-%d, expected %llu * 2^-%ld", p->name,
                 (unsigned long long)key, (unsigned long long)a, q.mant, q.exp,
                 (unsigned long long)mant, exp);
}

static void quotient(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("quotient");
    for (int n = 0; n < SPH_PROFILES; n++) {
        const struct sph_profile *p = &sph_profiles[n];
        int kb = p->w + p->wd + 2, ab = 2 * p->wd;
        for (int i = 0; i < 100000 / VEC_SHARE; i++) {
            uint64_t a = vec_unsigned(&rng, ab), key = vec_unsigned(&rng, kb);
            uint64_t whole = vec_unsigned(&rng, p->w) * (a >> p->w / 2);
            check_quotient(p, key, a);
            check_quotient(p, key, 1);
            check_quotient(p, key, (1ull << ab) - 1);
            check_quotient(p, key, 1ull << vec_pick(&rng, 0, ab - 1));
            if (whole > 1 && whole < 1ull << kb) { /* exact, and one unit off */
                check_quotient(p, whole, a >> p->w / 2);
                check_quotient(p, whole - 1, a >> p->w / 2);
            }
            check_quotient(p, a, a);
            check_quotient(p, 1ull << vec_pick(&rng, 0, kb - 1), a);
        }
    }
}

static void rsqrt_bounds(void **state) {
    (void)state;
    uint32_t before = 1u << 17;
    for (uint64_t x = 1u << 16; x < 1u << 18; x++) {
        uint64_t y = sph_rsqrt((uint32_t)x), above = y + SPH_RSQRT_ERROR;
        assert_true(y * y * (x + 1) <= 1ull << 50);
        assert_true(above * above * x >= 1ull << 50);
        assert_true(y < 1u << 17 && y <= before + 1); /* seams rise by at most one unit */
        before = (uint32_t)y;
    }
}

/* |u| <= 1 and the angle between u and v, up to half a unit of rounding in each component. */
static void check_unit(const int64_t v[3], int bits) {
    uint64_t vv = (uint64_t)(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    struct sph_unit r = sph_unit(v, vv, bits);
    int64_t expected[3];
    sph_naive_unit(v, bits, expected);
    long double uu = 0, cross2 = 0, half = sqrtl(3) / 2;
    for (int i = 0; i < 3; i++) {
        if (r.u[i] != expected[i])
            fail_msg("unit(%ld, %ld, %ld), %d bits: u[%d] = %d, not %ld", v[0], v[1], v[2], bits, i,
                     r.u[i], expected[i]);
        int j = (i + 1) % 3, k = (i + 2) % 3;
        long double c = (long double)r.u[j] * v[k] - (long double)r.u[k] * v[j];
        uu += (long double)r.u[i] * r.u[i];
        cross2 += c * c;
    }
    if (!vv) return;
    assert_true(r.h >= 0 && vv << (2 * r.h) >> (2 * bits - 2) && !(vv << (2 * r.h) >> (2 * bits)));
    assert_true(sqrtl(uu) <= 65536 + half);
    assert_true(sqrtl(uu) >= 65536 - 12 - half); /* the table's error, and 2 bits of x */
    assert_true(sqrtl(cross2 / (long double)vv) <= half + 1e-6L);
    long double length = sqrtl((long double)vv), inverse = r.y * exp2l(r.h - bits - 16);
    assert_true(inverse * length <= 1);
    assert_true((r.y + SPH_RSQRT_ERROR) * exp2l(r.h - bits - 16) * length >= 1);
}

static void unit(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("unit");
    for (int n = 0; n < SPH_PROFILES; n++) {
        int bits = sph_profiles[n].wd;
        int64_t low = -(1ll << (bits - 1));
        for (int i = 0; i < 27; i++) { /* every octant and axis at both ends of the range */
            int64_t sign[3] = {i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1}, one[3], most[3];
            for (int j = 0; j < 3; j++)
                one[j] = sign[j], most[j] = sign[j] > 0 ? -low - 1 : sign[j] * -low;
            check_unit(one, bits);
            check_unit(most, bits);
        }
        for (int i = 0; i < 200000 / VEC_SHARE; i++) {
            struct sph_ray ray;
            vec_ray(&rng, &sph_profiles[n], &ray);
            check_unit(ray.dir, bits);
        }
    }
}

static void check_normalise(const sph_i128 v[3], int bits) {
    mpz_t z[3];
    int64_t out[3], expected[3];
    for (int i = 0; i < 3; i++) {
        mpz_init(z[i]);
        set_u128(z[i], (sph_u128)(v[i] < 0 ? -v[i] : v[i]));
        if (v[i] < 0) mpz_neg(z[i], z[i]);
    }
    sph_naive_normalise(z, bits, expected);
    sph_normalise(v, bits, out);
    int64_t low = -(1ll << (bits - 1));
    int any = 0, full = 0;
    for (int i = 0; i < 3; i++) {
        assert_int_equal(out[i], expected[i]);
        assert_true(out[i] >= low && out[i] < -low);
        any |= v[i] != 0 && v[i] != -1;
        full |= out[i] >= -low / 2 || out[i] <= low / 2; /* -2^k - 1 may round to -2^k */
        mpz_clear(z[i]);
    }
    assert_true(full || !any);
}

static void normalise(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("normalise");
    for (int n = 0; n < SPH_PROFILES; n++) {
        int bits = sph_profiles[n].wd;
        sph_i128 half = (sph_i128)1 << (bits - 1);
        const sph_i128 special[][3] = {
            {0, 0, 0},                        /* zero stays zero */
            {half - 1, -half, 0},             /* fits as it is */
            {2 * half - 1, 0, 0},             /* rounds up out of range: limited */
            {-2 * half, 2 * half - 1, 1},     /* the most negative number keeps its sign */
            {-1, -1, -1},                     /* all ones: length 0, stays */
            {1, 0, -1},                       /* smallest */
            {half << 60, -(half << 60), 1},   /* widest */
            {(half << 40) + (1 << 20), 3, 0}, /* halves */
        };
        for (size_t i = 0; i < sizeof special / sizeof *special; i++)
            check_normalise(special[i], bits);
        for (int i = 0; i < 200000 / VEC_SHARE; i++) {
            sph_i128 v[3];
            int shift = (int)vec_pick(&rng, 0, 40);
            for (int j = 0; j < 3; j++)
                v[j] =
                    (sph_i128)vec_signed(&rng, 50) * ((sph_i128)1 << shift) + vec_pick(&rng, 0, 1);
            check_normalise(v, bits);
        }
    }
}

static void rounding(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("rounding");
    assert_int_equal(sph_round(3, 1), 2); /* halves go up */
    assert_int_equal(sph_round(-3, 1), -1);
    assert_int_equal(sph_round(-1, 1), 0);
    assert_int_equal(sph_round(-5, 0), -5);
    for (int i = 0; i < 500000 / VEC_SHARE; i++) {
        int64_t x = vec_signed(&rng, 60);
        int n = (int)vec_pick(&rng, 0, 50), bits = (int)vec_pick(&rng, 2, 40), saturated = 0;
        assert_int_equal(sph_round(x, n), sph_naive_round64(x, n));
        assert_true(sph_round128(x, n) == sph_round(x, n));
        mpz_t z;
        mpz_init_set_si(z, x);
        int64_t limited = sph_saturate(x, bits, &saturated);
        assert_int_equal(limited, sph_naive_limit(z, bits));
        assert_int_equal(saturated, limited != x);
        if (x > 0) assert_int_equal(sph_bit_length((uint64_t)x), mpz_sizeinbase(z, 2));
        mpz_clear(z);
    }
    assert_int_equal(sph_bit_length(0), 0);
    assert_int_equal(sph_bit_length128((sph_u128)1 << 127), 128);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(isqrt_small),  cmocka_unit_test(isqrt_corners),
        cmocka_unit_test(isqrt_random), cmocka_unit_test(quotient),
        cmocka_unit_test(rsqrt_bounds), cmocka_unit_test(unit),
        cmocka_unit_test(normalise),    cmocka_unit_test(rounding),
    };
    return cmocka_run_group_tests_name("math", tests, NULL, NULL);
}
