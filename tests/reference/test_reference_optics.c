/* test_reference_optics.c - refraction of the double reference: by formulas, and the model against
 * it SPDX-License-Identifier: Apache-2.0
 *
 * Run from the root of the repository: reads scenes/.
 */
#include "model_scene.h"
#include "uncut.h"

#include <math.h>

#include "reference/reference.h"
#include "reference/follow.h"

enum { W = 120, H = 90, DEPTH = 4 };

static const char *const scenes[] = {"four", "index", "water"};
enum { SCENES = sizeof scenes / sizeof *scenes };

/* dB of the deepest layer, 3 below what was measured. */
static const double floors[SCENES][SPH_PROFILES] = {
    {47.5, 53, 53, 53}, {35.5, 45, 49, 49}, {36, 43, 49, 51}};

static void psnr_of_refraction(void **state) {
    (void)state;
    for (int n = 0; n < (SANITIZED ? 1 : SCENES); n++) {
        char path[64];
        struct sph_scene scene;
        struct sph_error err = {{0}};
        snprintf(path, sizeof path, "scenes/refraction/%s.nff", scenes[n]);
        if (sph_scene_read(path, NULL, &scene, &err)) fail_msg("%s", err.text);
        for (int profile = 0; profile < SPH_PROFILES; profile++) {
            struct sph_build_options b = {.profile = profile,
                                          .tree = SPH_TREE_BALANCED,
                                          .width = W,
                                          .height = H,
                                          .max_depth = DEPTH,
                                          .shadow = SPH_AUTO,
                                          .reflect = SPH_AUTO,
                                          .refract = SPH_AUTO,
                                          .specular = SPH_AUTO,
                                          .lights = SPH_AUTO,
                                          .inside = SPH_AUTO};
            struct sph_build_report report;
            struct sph_machine m;
            struct sph_counters c;
            int errors;
            if (sph_build(&scene, &b, &m, &report, &err)) fail_msg("%s", err.text);
            struct sph_reference_options o = {.width = W,
                                              .height = H,
                                              .max_depth = DEPTH,
                                              .shadow = 1,
                                              .reflect = 1,
                                              .refract = 1,
                                              .specular = 1,
                                              .world = &m};
            struct sph_reference r;
            if (sph_reference_render(&scene, &o, &r, &err)) fail_msg("%s", err.text);
            struct sph_frame f = model_render(&m, SPH_TRAVERSE_TREE, 0, &c, &errors);
            double all = sph_reference_compare(&f, &r).psnr[2];
            uint64_t cut = uncut(&f, &r);
            assert_int_equal(cut, report.cut.beyond);
            struct sph_image_error e = sph_reference_compare(&f, &r);
            printf("# %-8s %-9s %6.1f %6.1f %6.1f dB, %lu off by more than 8; %.1f dB with "
                   "the plane beyond the grid, %lu pixels\n",
                   scenes[n], sph_profiles[profile].name, e.psnr[0], e.psnr[1], e.psnr[2],
                   e.far_off, all, cut);
            assert_int_equal(e.pixels, W * H);
            assert_true(e.psnr[SPH_FRAMES - 1] >= floors[n][profile]);
            sph_frame_free(&f);
            sph_reference_free(&r);
            sph_machine_free(&m);
        }
        sph_scene_free(&scene);
    }
}

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Angles by Snell's law, both ways, and the critical angle. */
static void angles(void **state) {
    (void)state;
    const double normal[3] = {0, 1, 0};
    for (int i = 25; i <= 400; i += 1 + i / 11)
        for (int k = 1; k < 157; k++) {
            double index = i / 100.0, in = k / 100.0;
            const double dir[3] = {sin(in), -cos(in), 0};
            double out[3], back[3], up[3], sine = sin(in) / index;
            int through = sph_ref_refract(dir, normal, 1 / index, out);
            if (fabs(sine - 1) > 1e-12) assert_int_equal(through, sine < 1);
            if (!through) continue;
            assert_true(fabs(out[0] - sine) < 1e-12 && out[1] < 0 && fabs(out[2]) < 1e-15);
            assert_true(fabs(dot(out, out) - 1) < 1e-12);
            const double turned[3] = {-out[0], -out[1], -out[2]}, down[3] = {0, -1, 0};
            if (sine > 0.9999) continue;
            assert_true(sph_ref_refract(turned, down, index, back));
            for (int j = 0; j < 3; j++)
                up[j] = back[j] + dir[j];
            assert_true(dot(up, up) < 1e-16);
        }
}

/* Where the ray at x, y of a small screen ends after it has gone through a glass ball onto a floor,
 * and what it has with it. */
static void through_ball(double x, double y, struct sph_ref_path *path, double at[3]) {
    const double ctr[3] = {0.3, 2, -6}, rad = 1.5, index = 1.5;
    const double right[3] = {1, 0, 0}, up[3] = {0, 1, 0};
    double org[3] = {0, 2.2, 0}, dir[3] = {x, y, -400};
    sph_ref_path_start(path, dir, right, up);
    for (int side = 0; side < 3; side++) {
        double n[3] = {0, 1, 0}, oc[3], t;
        for (int i = 0; i < 3; i++)
            oc[i] = ctr[i] - org[i];
        double a = dot(dir, dir), b = dot(oc, dir), c = dot(oc, oc) - rad * rad;
        if (side < 2)
            t = (b + (side ? 1 : -1) * sqrt(b * b - a * c)) / a;
        else
            t = -org[1] / dir[1]; /* floor y = 0 */
        for (int i = 0; i < 3; i++)
            org[i] += t * dir[i];
        for (int i = 0; i < 3 && side < 2; i++)
            n[i] = (side ? -1 : 1) * (org[i] - ctr[i]) / rad;
        sph_ref_path_hit(path, dir, t, n);
        if (side == 2) break;
        double ratio = side ? index : 1 / index, size = sqrt(a), bent[3];
        sph_ref_path_refract(path, dir, n, (side ? -1 : 1) / rad, ratio);
        for (int i = 0; i < 3; i++)
            dir[i] /= size;
        assert_true(sph_ref_refract(dir, n, ratio, bent));
        memcpy(dir, bent, sizeof dir);
    }
    memcpy(at, org, sizeof org);
}

/* Ray differentials through the ball are what neighbouring rays do. */
static void differentials(void **state) {
    (void)state;
    const double step = 1e-4;
    for (int x = -40; x <= 60; x += 20)
        for (int y = 10; y <= 50; y += 20) { /* above the middle: bent down to the floor */
            struct sph_ref_path path, other;
            double at[3], next[2][3];
            through_ball(x, y, &path, at);
            through_ball(x + step, y, &other, next[0]);
            through_ball(x, y + step, &other, next[1]);
            for (int k = 0; k < 2; k++)
                for (int i = 0; i < 3; i++) {
                    double moved = (next[k][i] - at[i]) / step;
                    assert_true(fabs(moved - path.org[k][i]) < 1e-3 * (1 + fabs(moved)));
                }
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(angles),
        cmocka_unit_test(differentials),
        cmocka_unit_test(psnr_of_refraction),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
