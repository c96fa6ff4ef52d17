/* test_texture.c - logarithm, level, coordinates of facets and spheres against real numbers
 * SPDX-License-Identifier: Apache-2.0
 */
#include "vectors.h"

#include <math.h>
#include <string.h>

#include "machine/machine.h"
#include "texture/coords.h"
#include "texture/lod.h"
#include "trace/setup.h"

/* Every x of 32 bits: between two neighbours of `step` bits below the top one nothing changes but
 * at the middle, where the rounding is; log2 is monotone, so both ends of each half are enough. */
static void log2_every_input(void **state) {
    (void)state;
    double worst = 0;
    uint32_t last = 0;
    for (int top = 0; top < 32; top++) {
        int half = top > 9 ? top - 9 : 0; /* bits below the one that rounds */
        for (uint64_t x = 1ull << top; x < 2ull << top; x += 1ull << half)
            for (int end = 0; end < 2; end++) {
                uint32_t at = (uint32_t)(x + (end ? (1ull << half) - 1 : 0));
                uint32_t r = sph_log2(at);
                double off = fabs(r / 256.0 - log2(at));
                if (off > worst) worst = off;
                if (r < last) fail_msg("log2(%u) is below that of a smaller number", at);
                last = r;
            }
        assert_int_equal(sph_log2(1u << top), top << 8);
    }
    printf("# log2: off by at most %.6f, %.3f of its last bit\n", worst, 256 * worst);
    assert_true(worst < 0.0048);
}

/* The first million directly, one by one. */
static void log2_small(void **state) {
    (void)state;
    for (uint32_t x = 1; x < (1u << 20) / VEC_SHARE; x++)
        assert_true(fabs(sph_log2(x) / 256.0 - log2(x)) < 0.0048);
}

static void path_length(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("path_length");
    for (int pr = 0; pr < SPH_PROFILES; pr++) {
        const struct sph_profile *p = &sph_profiles[pr];
        uint64_t most = (1ull << (p->w + 8)) - 1;
        for (int i = 0; i < 60000 / VEC_SHARE; i++) {
            struct sph_ray ray;
            vec_ray(&rng, p, &ray);
            sph_ray_setup(p, &ray);
            if (!ray.a) continue;
            uint64_t key = vec_unsigned(&rng, p->w + p->wd + 2), before = vec_unsigned(&rng, 12);
            int spread = i & 1 ? 0 : (int)(vec_unsigned(&rng, 16) % (SPH_SPREAD_MOST + 1));
            uint64_t path = sph_path_add(p, &ray, key, before, spread);
            double length = ldexp(16 * (double)key / sqrt((double)ray.a), spread) + (double)before;
            double low = floor(length - (length - (double)before) * 6 / 65536.0 - 0.5);
            double got = (double)path;
            if (length < (double)most - 1 ? got > length + 0.5 || got < low
                                          : got < (double)most * 0.9998)
                fail_msg("%s: key %llu path %llu, expected %f", p->name, (unsigned long long)key,
                         (unsigned long long)path, length);
            assert_int_equal(sph_path_add(p, &ray, key, most, spread), most);
        }
    }
}

/* By counting up: the last power of two that is not more than path / 2^(bend / 2) by the machine's
 * logarithm; and its distance from the sum in real numbers. */
static void spreads(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("spreads");
    double low = 0, high = 0;
    for (int i = 0; i < 400000 / VEC_SHARE; i++) {
        int before = i % (SPH_SPREAD_MOST + 1), c = -40;
        uint32_t bend = (uint32_t)vec_unsigned(&rng, 6);
        uint64_t path = vec_unsigned(&rng, 1 + i % 32);
        int after = sph_spread(path, before, bend);
        if (!path || !bend) {
            assert_int_equal(after, before);
            continue;
        }
        while (256 * (c + 1) + 128 * (int)bend <= (int)sph_log2((uint32_t)path))
            c++;
        int sum = c < before ? before : c > before ? c : before + 1;
        assert_int_equal(after, sum < SPH_SPREAD_MOST ? sum : SPH_SPREAD_MOST);
        double radius = exp2(((int)bend - SPH_BEND_ONE) / 2.0);
        double off = after - log2(exp2(before) + 4 * ((double)path / 16) / radius);
        if (after < SPH_SPREAD_MOST) low = fmin(low, off), high = fmax(high, off);
    }
    printf("# spread: %.3f to %.3f levels off\n", low, high);
    assert_true(low > -0.95 && high < 0.51);
    assert_true(low < -0.9 && high > 0.45);
}

static void levels(void **state) {
    (void)state;
    assert_int_equal(sph_lod(0, -32768, 12), 0);        /* path 0 */
    assert_int_equal(sph_lod(16, 0, 12), 0);            /* as far as P_b = 1 */
    assert_int_equal(sph_lod(32, 0, 12), 256);          /* twice */
    assert_int_equal(sph_lod(32, 128, 12), 128);        /* P_b = sqrt(2) */
    assert_int_equal(sph_lod(8, 0, 12), 0);             /* nearer */
    assert_int_equal(sph_lod(8, -512, 12), 256);        /* P_b = 1/4 */
    assert_int_equal(sph_lod(UINT32_MAX, 0, 12), 2816); /* the last level */
    assert_int_equal(sph_lod(UINT32_MAX, -32768, 1), 0);
    assert_int_equal(sph_lod(UINT32_MAX, 32767, 12), 0);
}

/* The record of a facet with random numbers in both coordinates. */
static void random_map(struct sph_rng *rng, uint32_t map[SPH_LINE_WORDS]) {
    for (int i = 0; i < SPH_LINE_WORDS; i++)
        map[i] = (uint32_t)sph_rng_next(rng);
}

/* floor(x / 2^n + 1/2) by long division; n < 0 multiplies. */
static __int128 scaled(__int128 x, int n) {
    if (n <= 0) return x * ((__int128)1 << -n);
    __int128 d = (__int128)1 << n, y = 2 * x + d;
    return y >= 0 ? y / (2 * d) : -((2 * d - 1 - y) / (2 * d));
}

static void facet_coords(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("facet_coords");
    for (int i = 0; i < 200000 / VEC_SHARE; i++) {
        uint32_t map[SPH_LINE_WORDS];
        int64_t at[3];
        random_map(&rng, map);
        for (int k = 0; k < 3; k++)
            at[k] = vec_signed(&rng, 26);
        struct sph_st st = sph_coords_facet(map, at);
        for (int axis = 0; axis < 2; axis++) {
            int lsb = axis ? SPH_MAP_T_X_LSB : SPH_MAP_S_X_LSB;
            __int128 dot = 0;
            for (int k = 0; k < 3; k++)
                dot += (__int128)sph_field_signed(map, lsb + 18 * k, 18) * at[k];
            int e = sph_field_signed(map, lsb + 54, 6);
            __int128 sum = scaled(dot, e) + sph_field(map, lsb + 60, 20) +
                           (__int128)sph_field_signed(map, lsb + 80, 20) * (1 << 20);
            __int128 one = (__int128)1 << 40, rest = (sum % one + one) % one;
            if (rest >= one / 2) rest -= one;
            assert_int_equal(st.at[axis], (int64_t)rest);
        }
    }
}

/* Worst errors of a set of unit vectors, in turns, but near the axis, where the longitude of the
 * rounded vector itself is off. */
struct worst {
    double around, down;
};

static void check_direction(const double d[3], struct worst *w) {
    int32_t v[3];
    for (int i = 0; i < 3; i++)
        v[i] = (int32_t)lround(65536 * d[i]);
    struct sph_longitude r = sph_longitude(v);
    double turn = 2 * acos(-1.0), off_axis = hypot(v[0], v[2]) / 65536;
    double around = r.around / 262144.0 - (0.5 + atan2(v[0], v[2]) / turn);
    double down = r.down / 131072.0 - atan2(hypot(v[0], v[2]), v[1]) / (turn / 2);
    around = fabs(around - round(around)) * fmin(1, off_axis); /* as seen on the sphere */
    if (around > w->around) w->around = around;
    if (fabs(down) > w->down) w->down = fabs(down);
    assert_true(r.around < 1 << 18 && r.down <= 1 << 17);
}

static void longitude(void **state) {
    (void)state;
    struct worst w = {0, 0};
    double pi = acos(-1.0);
    int around = VEC_SHARE > 1 ? 90 : 720, down = VEC_SHARE > 1 ? 60 : 540;
    for (int i = 0; i <= around; i++)
        for (int j = 0; j <= down; j++) { /* odd steps: poles, seam, equator and between */
            double a = 2 * pi * i / around, b = pi * j / down;
            check_direction((double[3]){sin(b) * sin(a), cos(b), sin(b) * cos(a)}, &w);
        }
    struct sph_rng rng = vec_seed("longitude");
    for (int i = 0; i < 200000 / VEC_SHARE; i++) { /* anything; thin around poles and the seam */
        double y = sph_rng_range(&rng, -1, 1), a = sph_rng_range(&rng, -pi, pi);
        if (i % 3 == 1) y = copysign(1 - pow(2, -20 * fabs(y)), y);
        if (i % 3 == 2) a = copysign(pi - pow(2, -5 * fabs(a)), a);
        double r = sqrt(1 - y * y);
        check_direction((double[3]){r * sin(a), y, r * cos(a)}, &w);
    }
    printf("# longitude: off by at most %.3g turns on the sphere, latitude by %.3g half turns\n",
           w.around, w.down);
    assert_true(w.around < 0x1p-18 && w.down < 0x1p-17);
}

static void directions(void **state) {
    (void)state;
    static const struct {
        int32_t v[3];
        double around, down;
    } cases[] = {
        {{0, 65536, 0}, 0.5, 0},    {{0, -65536, 0}, 0.5, 1},        {{0, 0, 65536}, 0.5, 0.5},
        {{65536, 0, 0}, 0.75, 0.5}, {{-65536, 0, 0}, 0.25, 0.5},     {{0, 0, -65536}, 0, 0.5},
        {{0, 0, 0}, 0.5, 0.5},      {{46341, 0, 46341}, 0.625, 0.5}, {{0, 46341, 46341}, 0.5, 0.25},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct sph_longitude r = sph_longitude(cases[i].v);
        double off = r.around / 262144.0 - cases[i].around;
        assert_true(fabs(off - round(off)) <= 0x1p-18);
        assert_true(fabs(r.down / 131072.0 - cases[i].down) <= 0x1p-17);
    }
    /* both sides of the seam, where s goes from the end to the start */
    assert_true(sph_longitude((int32_t[3]){40, 0, -65536}).around > 262000);
    assert_true(sph_longitude((int32_t[3]){-40, 0, -65536}).around < 144);
}

/* A record with turns, scale and offset in the words that hold them. */
static void sphere_coords(void **state) {
    (void)state;
    uint32_t map[SPH_LINE_WORDS] = {1};
    const int32_t turns[9] = {0, 0, 32767, 32767, 0, 0, 0, 32767, 0}; /* (x,y,z) -> (z,x,y) */
    for (int i = 0; i < 9; i++)
        sph_field_set(map, SPH_MAP_TURN_LSB + 16 * i, 16, (uint32_t)turns[i]);
    sph_field_set(map, SPH_MAP_SCALE_S_LSB, 16, 3 << 8);                /* 3 repeats */
    sph_field_set(map, SPH_MAP_SCALE_T_LSB, 16, (uint32_t) - (2 << 7)); /* -1 repeat */
    sph_field_set(map, SPH_MAP_PLUS_S_LSB, 16, 1 << 10);                /* 1/4 */
    sph_field_set(map, SPH_MAP_PLUS_T_LSB, 16, (uint32_t) - (5 << 12)); /* -5 */
    const struct sph_textured at = {.unit = {46341, 0, 46341}};         /* is (1, 1, 0): 3/4, 1/4 */
    struct sph_st st = sph_coords(map, &at);
    assert_in_range(llabs(st.at[0] - (int64_t)((3 * 0.75 + 0.25) * 0x1p20)), 0, 16);
    assert_in_range(llabs(st.at[1] - (int64_t)((-0.25 - 5) * 0x1p20)), 0, 16);
    const struct sph_textured inside = {.unit = {-46341, 0, -46341}, .far = 1};
    struct sph_st same = sph_coords(map, &inside);
    assert_in_range(llabs(st.at[0] - same.at[0]), 0, 16);
    assert_in_range(llabs(st.at[1] - same.at[1]), 0, 16);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(log2_every_input), cmocka_unit_test(log2_small),
        cmocka_unit_test(path_length),      cmocka_unit_test(levels),
        cmocka_unit_test(spreads),          cmocka_unit_test(facet_coords),
        cmocka_unit_test(longitude),        cmocka_unit_test(directions),
        cmocka_unit_test(sphere_coords),
    };
    return cmocka_run_group_tests_name("texture", tests, NULL, NULL);
}
