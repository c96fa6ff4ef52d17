/* test_cut.c - planes end nowhere; build says where the grid's end puts them in a wrong light
 * SPDX-License-Identifier: Apache-2.0
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
    struct sph_scene scene = read_scene("tests/scenes/facets/horizon.nff");
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

/* The machine sees the floor wherever the reference does. Only where build says so, far away, is
 * its light off by more than 8, and there it is. */
static void build_counts_what_is_cut(void **state) {
    (void)state;
    struct sph_scene scene = read_scene("tests/scenes/facets/horizon.nff");
    struct sph_build_report report;
    struct sph_counters c;
    int errors;
    uint64_t off = 0, seen = 0;
    struct sph_machine m = build(&scene, 160, 90, &report);
    struct sph_frame f = model_render(&m, SPH_TRAVERSE_TREE, 0, &c, &errors);
    struct sph_reference r = render(&scene, &m);
    for (int i = 0; i < 160 * 90; i++)
        if (r.pixels[i].id == scene.n_spheres && f.pixels[i].id == scene.n_spheres) {
            int red = (int)(r.pixels[i].colour[2] & 255) - (int)(f.pixels[i].colour[2] & 255);
            int marked = r.pixels[i].beyond == SPH_BEYOND_EYE;
            assert_int_equal(marked, r.pixels[i].distance >= report.cut.nearest * (1 - 1e-9));
            off += abs(red) > 8 && marked;
            seen++;
        }
    struct sph_image_error e = sph_reference_compare(&f, &r);
    printf("# %lu of %lu pixels far beyond, from %g on, %lu of them off; floor %lu; %.2f dB\n",
           report.cut.beyond, report.cut.pixels, report.cut.nearest, off, seen, e.psnr[2]);
    assert_int_equal(report.cut.pixels, 160 * 90);
    assert_int_equal(e.silhouette, 0);
    assert_int_equal(report.cut.later, 0);
    assert_true(off > 0 && e.psnr[2] > 25);
    assert_non_null(strstr(report.warning,
                           "horizon.nff:13: the plane goes on beyond the grid: 4.3 % of "
                           "the pixels see it 24.51 or farther"));
    assert_int_equal(uncut(&f, &r), report.cut.beyond);
    assert_true(sph_reference_compare(&f, &r).psnr[2] > 55);
    sph_reference_free(&r);
    sph_frame_free(&f);
    sph_machine_free(&m);
    sph_scene_free(&scene);
}

static int says(const struct sph_build_report *report) {
    return strstr(report->warning, "the plane goes on beyond the grid") != NULL;
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
    struct sph_scene scene = read_scene("tests/scenes/facets/horizon.nff");
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
    assert_true(says(&near) && !says(&far) && !says(&down) && !says(&hidden));
    sph_scene_free(&scene);
}

/* Six planes close a room: the grid holds its corners, at any profile, and nothing is far off. */
static void room_of_six_planes(void **state) {
    (void)state;
    static const double floors[SPH_PROFILES] = {40, 52, 52, 52};
    struct sph_scene scene = read_scene("tests/scenes/facets/six.nff");
    assert_int_equal(scene.n_facets, SPH_MAX_PLANES);
    for (int profile = 0; profile < SPH_PROFILES; profile++)
        for (int tree = SPH_TREE_PAPER; tree <= SPH_TREE_BIH; tree++) {
            struct sph_machine m;
            struct sph_counters c;
            int errors;
            if (!model_build(&scene, profile, tree, SPH_BG_NONE, 64, 48, &m)) fail();
            struct sph_frame f = model_render(&m, SPH_TRAVERSE_TREE, 0, &c, &errors);
            struct sph_reference r = render(&scene, &m);
            struct sph_image_error e = sph_reference_compare(&f, &r);
            printf("# %s: %.1f dB, %lu of another object\n", sph_profiles[profile].name, e.psnr[2],
                   e.wrong_id);
            assert_int_equal(errors, 0);
            assert_int_equal(c.count[SPH_COUNT_SATURATIONS], 0);
            assert_int_equal(e.silhouette, 0);
            assert_int_equal(uncut(&f, &r), 0);
            assert_true(e.psnr[2] > floors[profile]);
            sph_reference_free(&r);
            sph_frame_free(&f);
            sph_machine_free(&m);
        }
    sph_scene_free(&scene);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reference_sees_the_floor),
        cmocka_unit_test(build_counts_what_is_cut),
        cmocka_unit_test(warns_where_something_is_cut),
        cmocka_unit_test(room_of_six_planes),
    };
    return cmocka_run_group_tests_name("cut", tests, NULL, NULL);
}
