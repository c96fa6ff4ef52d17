/* test_specular.c - highlights: logarithm, power and cosine against real numbers; shares of rays
 * SPDX-License-Identifier: Apache-2.0
 */
#include "vectors.h"

#include <math.h>
#include <string.h>

#include "shade/colour.h"
#include "shade/material.h"

static void log2_every_input(void **state) {
    (void)state;
    double worst = 0;
    uint32_t last = UINT32_MAX;
    for (uint32_t c = 1; c <= 65536; c++) {
        uint32_t r = sph_specular_log2(c);
        worst = fmax(worst, fabs(r / 65536.0 - (16 - log2(c))));
        assert_true(r <= last);
        last = r;
    }
    printf("# -log2: off by at most %.3f of its last bit\n", worst * 65536);
    assert_true(worst * 65536 < 1.7);
    for (int i = 0; i <= 16; i++)
        assert_int_equal(sph_specular_log2(1u << i), (16 - i) << 16);
}

/* Every cosine to every whole power; powers in sixteenths for a share of them. */
static void power_every_input(void **state) {
    (void)state;
    double worst = 0, worst_part = 0;
    for (uint32_t c = 0; c <= 65536; c += VEC_SHARE) {
        double x = c / 65536.0, exact = 1;
        uint32_t last = 32768;
        for (uint32_t power = 1; power <= 255; power++) {
            uint32_t r = sph_power(c, 16 * power);
            exact *= x;
            worst = fmax(worst, fabs(r - 32768 * exact));
            assert_true(r <= last); /* falls as the power rises */
            last = r;
        }
        if (c % 64) continue;
        for (uint32_t power = 16; power <= 4080; power += 3)
            worst_part = fmax(worst_part, fabs(sph_power(c, power) - 32768 * pow(x, power / 16.0)));
    }
    printf("# power: off by at most %.6f, in sixteenths %.6f, of 1\n", worst / 32768,
           worst_part / 32768);
    assert_true(worst < 32768 * 0.003 && worst_part < 32768 * 0.003);
    for (uint32_t power = 16; power <= 4080; power++) {
        assert_int_equal(sph_power(65536, power), 32768);
        assert_int_equal(sph_power(0, power), 0);
        assert_true(sph_power(65535, power) <= 32768);
    }
    assert_int_equal(sph_power(32768, 16), 16384);
    assert_int_equal(sph_power(1, 16), 1); /* 2^-16 is half of the last bit: up */
    assert_int_equal(sph_power(1, 17), 0);
}

/* It never falls when the cosine rises. */
static void power_monotone(void **state) {
    (void)state;
    for (uint32_t power = 16; power <= 4080; power += 1 + power / 3)
        for (uint32_t c = 0, last = 0; c <= 65536; c++) {
            uint32_t r = sph_power(c, power);
            assert_true(r >= last);
            last = r;
        }
}

/* Against the cosine of the true vectors: units are too short by up to 6 of 2^-16. */
static void cosine_of_vectors(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("cosine_of_vectors");
    double low = 0, high = 0;
    for (int i = 0; i < 200000 / VEC_SHARE; i++) {
        int bits = 9 + (int)(sph_rng_next(&rng) % 17);
        struct sph_unit unit[3];
        double v[3][3], c[3] = {0};
        for (int k = 0; k < 3; k++) {
            int64_t whole[3], vv = 0;
            for (int j = 0; j < 3; j++) {
                whole[j] = vec_signed(&rng, bits);
                vv += whole[j] * whole[j];
            }
            if (!vv) whole[0] = vv = 1;
            unit[k] = sph_unit(whole, (uint64_t)vv, bits);
            for (int j = 0; j < 3; j++)
                v[k][j] = (double)whole[j] / sqrt((double)vv);
        }
        for (int k = 0; k < 3; k++)
            for (int j = 0; j < 3; j++)
                c[k] += v[k][j] * v[(k + 1) % 3][j];
        /* normal 0, to the light 1, ray 2 */
        double exact = fmin(1, fmax(0, c[1] - 2 * c[0] * c[2]));
        double off = sph_specular_cosine(&unit[0], &unit[1], &unit[2]) / 65536.0 - exact;
        low = fmin(low, off), high = fmax(high, off);
    }
    printf("# cosine: off by %.2e to %.2e\n", low, high);
    assert_true(low > -7e-4 && high < 7e-4);
}

static void cosine_head_on(void **state) {
    (void)state;
    const struct sph_unit z = {{0, 0, 65536}, 0, 0}, back = {{0, 0, -65536}, 0, 0};
    const struct sph_unit x = {{65536, 0, 0}, 0, 0}, half = {{46341, 0, 46341}, 0, 0};
    const struct sph_unit down = {{46341, 0, -46341}, 0, 0};
    assert_int_equal(sph_specular_cosine(&z, &z, &back), 65536);    /* light behind the eye */
    assert_int_equal(sph_specular_cosine(&z, &x, &back), 0);        /* light at the horizon */
    assert_int_equal(sph_specular_cosine(&z, &half, &down), 65536); /* seen in its mirror */
    const struct sph_unit away = {{-46341, 0, -46341}, 0, 0};
    assert_int_equal(sph_specular_cosine(&z, &half, &away), 0);
    const struct sph_unit left = {{-46341, 0, 46341}, 0, 0};
    assert_int_equal(sph_specular_cosine(&z, &left, &down), 0); /* the light is beside the eye */
}

/* One ray after another: shares give what the blend gives, frame by frame. */
static void shares_are_the_blend(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("shares_are_the_blend");
    for (int run = 0; run < 100000 / VEC_SHARE; run++) {
        struct sph_blend blend;
        struct sph_shares shares = {{{0}}};
        sph_blend_start(&blend);
        uint32_t weight = 65536;
        int most = (int)(sph_rng_next(&rng) % 6);
        for (int depth = 0; depth <= most; depth++) {
            uint32_t colour[3], kr = (uint32_t)(sph_rng_next(&rng) % 257);
            if (run % 7 == 0) kr = run % 2 ? 256 : 1;
            for (int i = 0; i < 3; i++)
                colour[i] = run % 5 ? (uint32_t)(sph_rng_next(&rng) % 65281) : 65280;
            int last = depth == most || !kr;
            struct sph_shading look = {.sum = 0};
            uint32_t left = last ? 0 : kr;
            sph_blend_add(&blend, colour, kr, last);
            sph_shares_add(&shares, depth, weight,
                           sph_share(weight, sph_shading_own(&look, left, 0)), colour);
            weight = sph_share(weight, kr);
            if (last) break;
        }
        for (int f = 0; f < SPH_FRAMES; f++)
            assert_int_equal(sph_shares_colour(&shares, f), blend.colour[f]);
    }
}

/* Without words of its own a material has the light that it always had. */
static void light_of_materials(void **state) {
    (void)state;
    struct sph_shading plain = {.ka = 256, .kd = 256}, sum = {.sum = 1, .ka = 77, .kd = 26};
    for (uint32_t ambient = 0; ambient < 65536; ambient += 1021)
        for (uint32_t lights = 0; lights < 131072; lights += 1531) {
            uint32_t all = ambient + lights;
            assert_int_equal(sph_shading_light(&plain, ambient, lights),
                             all < 131071 ? all : 131071);
            double part = (77.0 * ambient + 26.0 * lights) / 256;
            assert_true(fabs(sph_shading_light(&sum, ambient, lights) - part) <= 1);
        }
    assert_int_equal(sph_shading_own(&plain, 100, 50), 106);
    assert_int_equal(sph_shading_own(&plain, 200, 100), 0);
    assert_int_equal(sph_shading_own(&sum, 100, 50), 256);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(log2_every_input),   cmocka_unit_test(power_every_input),
        cmocka_unit_test(power_monotone),     cmocka_unit_test(cosine_of_vectors),
        cmocka_unit_test(cosine_head_on),     cmocka_unit_test(shares_are_the_blend),
        cmocka_unit_test(light_of_materials),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
