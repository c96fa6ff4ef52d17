/* test_choose.c - what samples promise holds, and no thread changes what is chosen
 * SPDX-License-Identifier: Apache-2.0
 */
#include "model_scene.h"

#include <math.h>

#include "common/parallel.h"
#include "scene/rng.h"
#include "trial/choose.h"

enum { PIXELS = 2000, SAMPLES = SANITIZED ? 500 : 4000 };

/* Errors that are rare or many, far off or not: of the samples no more promise too much than may.
 */
static void promises(void **state) {
    (void)state;
    static const struct {
        double part; /* of pixels that are off */
        uint32_t off;
    } rows[] = {
        {0.003, 0xffffff},  /* white for black: one sample of 400 sees none */
        {0.0028, 0xffffff}, /* just where a sample that sees none is wrong */
        {0.01, 0xffffff},   /* some in every sample */
        {0.004, 0x808080},  /* half off, rare */
        {0.5, 0x080808},    /* many, a little off */
        {1, 0xffffff},      /* all, and no bet is won */
        {0, 0},             /* none */
    };
    struct sph_rng rng = {2};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct sph_squares one = {0};
        sph_squares_add(&one, rows[i].off, 0);
        double true_psnr = sph_squares_psnr(&one, 1) - 10 * log10(rows[i].part);
        int broken = 0;
        for (int s = 0; s < SAMPLES; s++) {
            struct sph_squares sum = {0};
            for (int p = 0; p < PIXELS; p++) {
                int off = sph_rng_range(&rng, 0, 1) < rows[i].part;
                sph_squares_add(&sum, off ? rows[i].off : 0, 0);
            }
            broken += sph_squares_psnr_least(&sum) > true_psnr;
        }
        printf("# %g off by %06x: %d of %d samples promise too much\n", rows[i].part, rows[i].off,
               broken, SAMPLES);
        assert_true(broken <= 2 * SAMPLES * (1 - SPH_TRIAL_SURE) / SPH_PROFILES);
    }
}

/* What is promised of equal pixels: no more than their number tells, and no less. */
static void equal_pixels(void **state) {
    (void)state;
    static const struct {
        uint64_t n;
        double least;
    } rows[] = {{0, 0}, {1, 0}, {1000, 22.5}, {SPH_JUDGE_PIXELS, 49.7}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct sph_squares sum = {.n = rows[i].n};
        assert_true(fabs(sph_squares_psnr_least(&sum) - rows[i].least) < 0.1);
    }
}

/* A profile is left early only if its whole picture misses the bound; threads change no bit. */
static void measured(void **state) {
    (void)state;
    static const struct {
        const char *scene;
        int width, height; /* the last one is a sample */
    } rows[] = {{"scenes/paper100.nff", 96, 54},
                {"scenes/sphereflake2.nff", 96, 54},
                {"scenes/facets/room.nff", 96, 54},
                {"scenes/refraction/nested.nff", 96, 54},
                {"scenes/sphereflake2.nff", 1024, 768}};
    const struct sph_error_bound bound = {SPH_ERROR_BOUND_PIXELS, SPH_ERROR_BOUND_PSNR};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct sph_scene scene = read_scene(rows[i].scene);
        struct sph_build_options o = SPH_BUILD_DEFAULT;
        struct sph_profile_choice alone, shared;
        struct sph_error err = {""};
        struct sph_judge judge;
        o.width = rows[i].width, o.height = rows[i].height;
        int before = sph_parallel_most(1);
        assert_int_equal(sph_choose(&scene, &o, &bound, &alone, &err), 0);
        sph_parallel_most(3);
        assert_int_equal(sph_choose(&scene, &o, &bound, &shared, &err), 0);
        sph_parallel_most(before);
        assert_true(alone.kept && alone.taken == shared.taken && alone.taken == o.profile);
        for (int p = 0; p < SPH_PROFILES; p++)
            assert_memory_equal(&alone.of[p].measured, &shared.of[p].measured,
                                sizeof alone.of[p].measured);
        assert_int_equal(sph_judge_begin(&scene, &o, &judge, &err), 0);
        assert_true(alone.of[o.profile].measured.psnr_least <= alone.of[o.profile].measured.psnr);
        for (int p = 0; p < SPH_PROFILES && !judge.yardstick.places; p++) {
            const struct sph_profile *w = &sph_profiles[p];
            struct sph_measured all = sph_judge_widths(&judge, w, 0);
            assert_true(!all.left && all.pixels == all.of && all.psnr == all.psnr_least);
            assert_false(sph_judge_widths(&judge, w, all.psnr - 1e-9).left);
            struct sph_measured some = sph_judge_widths(&judge, w, all.psnr + 1e-9);
            assert_true((some.left || isinf(all.psnr)) && some.psnr >= all.psnr);
        }
        sph_judge_end(&judge);
        sph_scene_free(&scene);
    }
}

/* What cannot be measured is known before anything is drawn. */
static void cannot(void **state) {
    (void)state;
    struct sph_scene scene = read_scene("scenes/paper5.nff"), many = scene;
    many.n_spheres = SPH_JUDGE_PRIMS + 1;
    const struct sph_build_options o = SPH_BUILD_DEFAULT;
    struct sph_build_options first = o, light = o, coarse = o, inside = o, shadow = o;
    first.traverse = SPH_BUILD_FIRST, light.least_weight = 1, coarse.coarse = 1;
    inside.inside = SPH_OFF, shadow.shadow = SPH_OFF;
    const struct {
        const struct sph_scene *scene;
        const struct sph_build_options *o;
        int can;
    } rows[] = {
        {&scene, &o, 1},      {&many, &o, 0},        /* trees take too long */
        {&scene, &first, 0},                         /* hits are not the nearest */
        {&scene, &light, 0},  {&scene, &coarse, 0},  /* left out on purpose */
        {&scene, &inside, 0}, {&scene, &shadow, 1}}; /* the reference can leave shadows out */
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        assert_int_equal(sph_judge_cannot(rows[i].scene, rows[i].o) == NULL, rows[i].can);
    sph_scene_free(&scene);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(promises), cmocka_unit_test(equal_pixels),
                                       cmocka_unit_test(measured), cmocka_unit_test(cannot)};
    return cmocka_run_group_tests_name("trial/test_choose", tests, NULL, NULL);
}
