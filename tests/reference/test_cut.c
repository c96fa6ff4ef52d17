/* test_cut.c - planes in the double reference end nowhere; build says what of them the grid cuts
 * off SPDX-License-Identifier: Apache-2.0
 *
 * Run from the root of the repository: reads scenes/ and tests/scenes/.
 */
#include "model_scene.h"
#include "uncut.h"

#include <math.h>

#include "reference/reference.h"

/* Builds with every effect that the scene calls for. */
static struct sph_machine build(const struct sph_scene *scene, int width, int height,
                                struct sph_build_report *report) {
    struct sph_build_options o = {.profile = SPH_STANDARD,
                                  .tree = SPH_TREE_BALANCED,
                                  .width = width,
                                  .height = height,
                                  .max_depth = 3,
                                  .shadow = SPH_AUTO,
                                  .reflect = SPH_AUTO,
                                  .refract = SPH_AUTO,
                                  .specular = SPH_AUTO,
                                  .lights = SPH_AUTO,
                                  .inside = SPH_AUTO,
                                  .interpenetrate = SPH_AUTO};
    struct sph_machine m;
    struct sph_error err = {{0}};
    if (sph_build(scene, &o, &m, report, &err)) fail_msg("%s", err.text);
    return m;
}

static struct sph_reference render(const struct sph_scene *scene, const struct sph_machine *world) {
    struct sph_reference_options o = {.width = world->regs[SPH_REG_FRAME_W],
                                      .height = world->regs[SPH_REG_FRAME_H],
                                      .max_depth = 3,
                                      .shadow = 1,
                                      .reflect = 1,
                                      .refract = 1,
                                      .world = world};
    struct sph_reference r;
    struct sph_error err = {{0}};
    if (sph_reference_render(scene, &o, &r, &err)) fail_msg("%s", err.text);
    return r;
}

/* The eye is 1 above a floor, the middle of 90 rows looks along it, and 45 degrees are the height:
 * row y below the middle meets the floor at screen / (y + 1/2), whatever the grid. */
static void reference_sees_the_floor(void **state) {
    (void)state;
    struct sph_scene scene = read_scene("tests/scenes/facets/endless.nff");
    struct sph_build_report report;
    struct sph_machine m = build(&scene, 160, 90, &report);
    struct sph_reference r = render(&scene, &m);
    double screen = 45 / tan(acos(-1.0) / 8);
    for (int y = 0; y < 90; y++) {
        const struct sph_reference_pixel *p = &r.pixels[160 * y]; /* beside the ball */
        double down = y - 44.5, across = 79.5;
        assert_int_equal(p->id, down > 0 ? scene.n_spheres : SPH_ID_NONE);
        if (down < 0) continue;
        double distance = sqrt(screen * screen + down * down + across * across) / down;
        assert_true(fabs(p->distance / distance - 1) < 1e-9);
    }
    sph_reference_free(&r);
    sph_machine_free(&m);
    sph_scene_free(&scene);
}

/* What build counts are the pixels that see the floor in the reference and none in the machine; the
 * rest of the picture is right. */
static void build_counts_what_is_cut(void **state) {
    (void)state;
    struct sph_scene scene = read_scene("tests/scenes/facets/endless.nff");
    struct sph_build_report report;
    struct sph_counters c;
    int errors;
    uint64_t missing = 0;
    double nearest = INFINITY;
    struct sph_machine m = build(&scene, 160, 90, &report);
    struct sph_frame f = model_render(&m, SPH_TRAVERSE_TREE, 0, &c, &errors);
    struct sph_reference r = render(&scene, &m);
    for (int i = 0; i < 160 * 90; i++)
        if (r.pixels[i].id == scene.n_spheres && f.pixels[i].id == SPH_ID_NONE) {
            missing++;
            nearest = fmin(nearest, r.pixels[i].distance);
        }
    struct sph_image_error e = sph_reference_compare(&f, &r);
    printf("# %lu of %lu pixels cut, from %g on; %.2f dB\n", report.cut.beyond, report.cut.pixels,
           report.cut.nearest, e.psnr[2]);
    assert_int_equal(report.cut.pixels, 160 * 90);
    assert_int_equal(report.cut.beyond, missing);
    assert_true(fabs(report.cut.nearest / nearest - 1) < 1e-9);
    assert_int_equal(report.cut.later, 0);
    assert_true(missing > 160 * 90 / 10 && e.psnr[2] > 12 && e.psnr[2] < 14);
    assert_non_null(strstr(report.warning,
                           "endless.nff:13: the plane ends with the grid: 15.2 % of "
                           "the pixels see it only beyond, 4.389 or farther"));
    assert_int_equal(uncut(&f, &r), missing);
    assert_true(sph_reference_compare(&f, &r).psnr[2] > 55);
    sph_reference_free(&r);
    sph_frame_free(&f);
    sph_machine_free(&m);
    sph_scene_free(&scene);
}

static int says(const struct sph_build_report *report) {
    return strstr(report->warning, "the plane ends with the grid") != NULL;
}

/* Nothing is said of planes that end behind other things, or outside of the frame; of those that
 * mirrors or glass alone show cut, it is. A light far away makes room for more of the floor. */
static void warns_where_something_is_cut(void **state) {
    (void)state;
    static const struct {
        const char *path;
        int eye, later;
    } cases[] = {{"scenes/facets/room.nff", 0, 0}, /* no plane at all */
                 {"scenes/facets/plane.nff", 1, 1},
                 {"tests/scenes/facets/mixed.nff", 0, 1},
                 {"tests/scenes/refraction/mixed.nff", 0, 1}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct sph_scene scene = read_scene(cases[i].path);
        struct sph_build_report report;
        struct sph_machine m = build(&scene, 64, 36, &report);
        if ((report.cut.beyond > 0) != cases[i].eye || (report.cut.later > 0) != cases[i].later ||
            says(&report) != (cases[i].eye || cases[i].later))
            fail_msg("%s: %lu and %lu pixels cut; %s", cases[i].path, report.cut.beyond,
                     report.cut.later, report.warning);
        sph_machine_free(&m);
        sph_scene_free(&scene);
    }
    struct sph_scene scene = read_scene("tests/scenes/facets/endless.nff");
    struct sph_build_report near, far, down, hidden;
    struct sph_machine m = build(&scene, 64, 36, &near);
    sph_machine_free(&m);
    scene.lights[0].pos = (struct sph_vec){0, 100, 0};
    m = build(&scene, 64, 36, &far);
    sph_machine_free(&m);
    assert_true(far.cut.nearest > 10 * near.cut.nearest && far.cut.beyond < near.cut.beyond / 3);
    scene.spheres[0].rad = 4; /* fills the frame */
    m = build(&scene, 64, 36, &hidden);
    sph_machine_free(&m);
    scene.spheres[0].rad = 0.1, scene.camera.at = (struct sph_vec){0, -9, 0};
    m = build(&scene, 64, 36, &down);
    sph_machine_free(&m);
    assert_true(says(&near) && says(&far) && !says(&down) && !says(&hidden));
    sph_scene_free(&scene);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reference_sees_the_floor),
        cmocka_unit_test(build_counts_what_is_cut),
        cmocka_unit_test(warns_where_something_is_cut),
    };
    return cmocka_run_group_tests_name("cut", tests, NULL, NULL);
}
