/* test_light.c - lights beyond the grid: words, bounds, pictures
 * SPDX-License-Identifier: Apache-2.0
 *
 * Run from the root of the repository: reads scenes/ and tests/scenes/.
 */
#include "model_scene.h"

#include <math.h>

#include "builder/grid/light.h"
#include "math/fx.h"
#include "naive/naive.h"
#include "reference/reference.h"
#include "validate/validate.h"

enum { W = 64, H = 48 };

static int shift_of(const struct sph_machine *m, int l) {
    return m->regs[SPH_REG_LIGHT0_R + SPH_LIGHT_STRIDE * l] >> SPH_LIGHT_SHIFT_LSB;
}

/* The vector from any surface to a light has its word, is off by no more than light.h says, and
 * ends beyond all that could stand before the light. */
static void check_light(const struct sph_scene *s, const struct sph_machine *m, int l) {
    const struct sph_profile *p = sph_machine_profile(m);
    const int32_t *lamp = m->regs + SPH_REG_LIGHT0_X + SPH_LIGHT_STRIDE * l;
    struct sph_grid grid;
    double at[3];
    int shift = shift_of(m, l);
    assert_int_equal(sph_grid_fit(s, p->w, SPH_AXES_CAMERA, &grid, NULL), 0);
    sph_grid_real(&grid, s->lights[l].pos, at);
    for (uint32_t i = 0; i < s->n_spheres; i++) {
        struct sph_ball from = sph_grid_ball(&grid, &s->spheres[i]);
        double v[3], to[3], vv = 0, tt = 0, vt = 0, end = -INFINITY;
        for (int k = 0; k < 3; k++) {
            int64_t d = lamp[k] - sph_round(from.c[k], shift);
            assert_true(llabs(d) < 1ll << (p->wd - 1));
            v[k] = (double)d, to[k] = at[k] - from.c[k];
            vv += v[k] * v[k], tt += to[k] * to[k], vt += v[k] * to[k];
        }
        double sine = sqrt(fmax(0, 1 - vt / sqrt(vv) * (vt / sqrt(vv)) / tt));
        assert_true(sine < sqrt(3) / sqrt(vv) + 1e-7);
        for (uint32_t j = 0; shift && j < s->n_spheres; j++) { /* nothing lies at the end or on */
            struct sph_ball to_pass = sph_grid_ball(&grid, &s->spheres[j]);
            end = -INFINITY;
            for (int k = 0; k < 3; k++)
                end = fmax(end, copysign(1, v[k]) * (from.c[k] + v[k] - to_pass.c[k]) - to_pass.r);
            assert_true(end > 0);
        }
    }
}

/* Lights on the grid, some grids away, and as good as infinitely far; the reference has them where
 * they are. */
static void far_lights(void **state) {
    static const double floors[SPH_PROFILES] = {34, 48, 52, 52};
    (void)state;
    struct sph_scene scene = read_scene("tests/scenes/lights/far.nff");
    for (int profile = 0; profile < SPH_PROFILES; profile++) {
        struct sph_machine m;
        struct sph_counters c;
        struct sph_error err = {{0}};
        struct sph_reference r;
        struct sph_reference_options o = {
            .width = W, .height = H, .max_depth = 3, .shadow = 1, .reflect = 1};
        int errors, wrong = 0;
        if (!model_build(&scene, profile, SPH_TREE_BALANCED, SPH_BG_NONE, W, H, &m)) fail();
        if (sph_machine_validate(&m, &err)) fail_msg("%s", err.text);
        assert_int_equal(shift_of(&m, 0), 0);
        assert_true(shift_of(&m, 1) > 1 && shift_of(&m, 2) > 10 && shift_of(&m, 3) == 31);
        for (int l = 0; l < scene.n_lights - 1; l++)
            check_light(&scene, &m, l);
        struct sph_frame f = model_render(&m, SPH_TRAVERSE_TREE, 0, &c, &errors);
        if (sph_reference_render(&scene, &o, &r, &err)) fail_msg("%s", err.text);
        struct sph_image_error e = sph_reference_compare(&f, &r);
        printf("# %s: %.1f dB\n", sph_profiles[profile].name, e.psnr[2]);
        assert_true(e.psnr[2] > floors[profile]);
        for (int i = 0; i < W * H; i += 7) {
            struct sph_pixel naive = sph_naive_pixel(&m, i % W, i / W);
            wrong += naive.colour[2] != f.pixels[i].colour[2] || naive.id != f.pixels[i].id;
        }
        assert_int_equal(wrong, 0);
        m.regs[SPH_REG_LIGHT0_X + SPH_LIGHT_STRIDE] = 1 << sph_machine_profile(&m)->w;
        assert_int_equal(sph_machine_validate(&m, &err), -1);
        assert_non_null(strstr(err.text, "LIGHT1_X"));
        sph_reference_free(&r);
        sph_frame_free(&f);
        sph_machine_free(&m);
    }
    sph_scene_free(&scene);
}

/* A light moved away from a row of spheres, by a tenth at a time, along the row and across: the
 * grid is never coarser than four times that of the spheres, and the light always sound. */
static void moved_away(void **state) {
    static const struct sph_vec ways[] = {{1, 0.01, 0}, {-1, 0.05, 0}, {0.9, 1, 0.8}, {0, 1, 0}};
    (void)state;
    struct sph_scene scene = model_scene("paper5");
    for (uint32_t i = 0; i < scene.n_spheres; i++) {
        scene.spheres[i].ctr = (struct sph_vec){20.0 * i - 40, 0, 0};
        scene.spheres[i].rad = 9;
    }
    scene.camera.from = (struct sph_vec){0, 11, 0};
    scene.camera.at = (struct sph_vec){0, 0, -100};
    for (int i = 0; i < 4 * SPH_PROFILES; i++) {
        double first = 0, by = 20;
        for (int k = 0; k < 160; k++, by *= 1.1) {
            const struct sph_vec *way = &ways[i / 4];
            struct sph_machine m;
            scene.lights[0].pos = (struct sph_vec){way->x * by, way->y * by, way->z * by};
            if (!model_build(&scene, i % 4, SPH_TREE_BALANCED, SPH_BG_NONE, W, H, &m)) fail();
            if (!k) first = ldexp(1, m.grid_log2);
            assert_true(ldexp(1, m.grid_log2) <= 4 * first);
            if (m.regs[SPH_REG_N_LIGHTS]) check_light(&scene, &m, 0); /* not in a sphere */
            sph_machine_free(&m);
        }
    }
    sph_scene_free(&scene);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(far_lights),
        cmocka_unit_test(moved_away),
    };
    return cmocka_run_group_tests_name("lamp", tests, NULL, NULL);
}
