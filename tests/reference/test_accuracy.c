/* test_accuracy.c - what the number formats cost: every profile against double precision
 * SPDX-License-Identifier: Apache-2.0
 *
 * The reference sees the scene as written. All that differs is the grid (W), the direction (WD),
 * the quotient (PQ), the table of unit vectors and 8-bit colour. Run from the repository's root.
 */
#include "model_scene.h"
#include "uncut.h"

#include <math.h>

#include "reference/accuracy.h"
#include "render/render.h"

enum { W = 160, H = 90, DEPTH = 3 };

/* dB of the deepest layer: mean over the scenes and any one scene, 3 below what was measured. From
 * profile fine on 8-bit colours are the limit: a third of the channels off by one is 53 dB. */
static const double floors[SPH_PROFILES] = {41, 50, 54.5, 56};
static const double scene_floors[SPH_PROFILES] = {28, 29, 40, 49.5};

static const double facet_floors[SPH_PROFILES] = {27, 34, 45, 51};

/* world: marks pixels that see planes beyond its grid, or NULL. */
static struct sph_reference reference(const struct sph_scene *scene, int width, int height,
                                      const struct sph_machine *world) {
    struct sph_reference_options o = {.width = width,
                                      .height = height,
                                      .max_depth = DEPTH,
                                      .shadow = 1,
                                      .reflect = 1,
                                      .world = world};
    struct sph_reference r;
    struct sph_error err = {{0}};
    if (sph_reference_render(scene, &o, &r, &err)) fail_msg("%s", err.text);
    return r;
}

static void print_row(const char *scene, int profile, const struct sph_image_error *e) {
    printf("# %-16s %-9s %6.1f %6.1f %6.1f %5lu %5lu %5lu %5d\n", scene, sph_profiles[profile].name,
           e->psnr[0], e->psnr[1], e->psnr[2], e->silhouette, e->wrong_id, e->far_off, e->worst);
}

static void psnr_of_profiles(void **state) {
    (void)state;
    double mean[SPH_PROFILES] = {0};
    int count[SPH_PROFILES] = {0};
    printf("# %-16s %-9s %6s %6s %6s %5s %5s %5s %5s\n", "scene", "profile", "depth0", "depth1",
           "deep", "edge", "id", ">8", "worst");
    for (int n = 0; n < MODEL_SCENES; n++) {
        struct sph_scene scene = model_scene(model_scenes[n]);
        struct sph_reference r = reference(&scene, W, H, NULL);
        for (int profile = 0; profile < SPH_PROFILES; profile++) {
            struct sph_machine m;
            struct sph_counters c;
            int errors;
            if (!model_build(&scene, profile, SPH_TREE_BALANCED, SPH_BG_RECT, W, H, &m)) continue;
            struct sph_frame f = model_render(&m, SPH_TRAVERSE_TREE, 0, &c, &errors);
            struct sph_image_error e = sph_reference_compare(&f, &r);
            assert_int_equal(e.pixels, W * H);
            print_row(model_scenes[n], profile, &e);
            assert_true(e.psnr[SPH_FRAMES - 1] >= scene_floors[profile]);
            if (isfinite(e.psnr[SPH_FRAMES - 1])) {
                mean[profile] += e.psnr[SPH_FRAMES - 1];
                count[profile]++;
            }
            sph_frame_free(&f);
            sph_machine_free(&m);
        }
        sph_reference_free(&r);
        sph_scene_free(&scene);
    }
    for (int profile = 0; profile < SPH_PROFILES; profile++) {
        mean[profile] /= count[profile];
        printf("# mean of %d scenes, %s: %.1f dB, floor %.1f\n", count[profile],
               sph_profiles[profile].name, mean[profile], floors[profile]);
        assert_true(mean[profile] >= floors[profile]);
        assert_true(profile == 0 || mean[profile] > mean[profile - 1]);
    }
}

/* Triangles and planes, but for what of planes lies beyond the grid. */
static void psnr_of_facets(void **state) {
    (void)state;
    for (int n = 0; n < (SANITIZED ? 1 : FACET_SCENES); n++) {
        struct sph_scene scene = facet_scene(n);
        for (int profile = 0; profile < SPH_PROFILES; profile++) {
            struct sph_machine m;
            struct sph_counters c;
            int errors;
            if (!model_build(&scene, profile, SPH_TREE_BALANCED, SPH_BG_RECT, W, H, &m)) continue;
            struct sph_reference r = reference(&scene, W, H, &m);
            struct sph_frame f = model_render(&m, SPH_TRAVERSE_TREE, 0, &c, &errors);
            uncut(&f, &r);
            struct sph_image_error e = sph_reference_compare(&f, &r);
            assert_int_equal(e.pixels, W * H);
            print_row(facet_scenes[n], profile, &e);
            assert_true(e.psnr[SPH_FRAMES - 1] >= facet_floors[profile]);
            sph_frame_free(&f);
            sph_machine_free(&m);
            sph_reference_free(&r);
        }
        sph_scene_free(&scene);
    }
}

/* One sphere on the axis: the reference itself against a formula. */
static void reference_by_hand(void **state) {
    (void)state;
    struct sph_material f = {.rgb = {1, 0.5, 0.25}, .kd = 0.5, .ks = 0.5};
    struct sph_sphere ball = {.ctr = {0, 0, 0}, .rad = 1};
    struct sph_scene scene = {.path = "by hand", .n_lights = 1, .n_materials = 1, .n_spheres = 1};
    scene.camera =
        (struct sph_camera){{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 30, .width = 33, .height = 33};
    scene.lights[0] = (struct sph_light){{0, 0, 20}, {0.75, 0.75, 0.75}, 0};
    scene.ambient[0] = scene.background[1] = 0.25;
    scene.materials = &f, scene.spheres = &ball;
    struct sph_reference r = reference(&scene, 33, 33, NULL);
    const struct sph_reference_pixel *middle = &r.pixels[16 * 33 + 16], *corner = &r.pixels[0];
    assert_int_equal(corner->id, SPH_ID_NONE);
    assert_int_equal(corner->colour[0], 64 << 8);
    assert_int_equal(middle->id, 0);
    assert_int_equal(middle->reflected_id, SPH_ID_NONE);
    assert_int_equal(middle->shadow, 0);
    /* red 1*(0.25+0.75), green 0.5*0.75, blue 0.25*0.75; then half of it and half of 0.25 green */
    assert_int_equal(middle->colour[0], 48 << 16 | 96 << 8 | 255);
    assert_int_equal(middle->colour[1], 24 << 16 | 80 << 8 | 128);
    int seen = 0;
    for (int i = 0; i < 33; i++)
        seen += r.pixels[16 * 33 + i].id == 0;
    /* half width of the disc in pixels: 16.5 / tan(15 deg) * 1 / sqrt(99) */
    assert_int_equal(seen, 2 * (int)(16.5 / tan(M_PI / 12) / sqrt(99)) + 1);
    sph_reference_free(&r);
}

/* A square of two triangles before a plane that looks away, lit from between eye and square. */
static void facets_by_hand(void **state) {
    (void)state;
    struct sph_material f = {.rgb = {1, 0.5, 0.25}, .kd = 1};
    struct sph_facet facets[3] = {
        {.kind = SPH_TRIANGLE, .v = {{1, -1, 0}, {1, 1, 0}, {-1, -1, 0}}},
        {.kind = SPH_TRIANGLE, .v = {{-1, -1, 0}, {-1, 1, 0}, {1, 1, 0}}},
        {.kind = SPH_PLANE, .v = {{3, 4, -5}, {0, 0, -2}}, .group = 1},
    };
    struct sph_scene scene = {.path = "by hand", .n_lights = 1, .n_materials = 1, .n_facets = 3};
    scene.camera =
        (struct sph_camera){{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 30, .width = 33, .height = 33};
    scene.lights[0] = (struct sph_light){{0, 0, 5}, {0.75, 0.75, 0.75}, 0};
    scene.ambient[0] = 0.25;
    scene.materials = &f, scene.facets = facets;
    struct sph_reference r = reference(&scene, 33, 33, NULL);
    const struct sph_reference_pixel *row = &r.pixels[16 * 33];
    assert_int_equal(row[16].id, 0); /* on the edge that both have */
    assert_int_equal(row[16].colour[0], 48 << 16 | 96 << 8 | 255);
    assert_int_equal(r.pixels[15 * 33 + 15].id, 1);
    int seen = 0, plane = 0, shadow = 0;
    for (int i = 0; i < 33; i++) {
        seen += row[i].id < 2;
        plane += row[i].id == 2;
        shadow += row[i].shadow == 1;
        assert_true(!row[i].shadow || row[i].id == 2);
        assert_true(row[i].shadow ||
                    row[i].colour[0] >> 16 > 0); /* lit from the side that is seen */
    }
    /* screen 16.5 / tan(15 deg) = 61.6: the square to 6.16 pixels, its shadow to 61.6 * 2 / 15 */
    assert_int_equal(seen, 13);
    assert_int_equal(plane, 33 - 13);
    assert_int_equal(shadow, 4);
    sph_reference_free(&r);
}

/* A ball before a large one, lit from the right by the second light; the first is black
 * and build leaves it out. */
static struct sph_scene two_balls(struct sph_material *f, struct sph_sphere balls[2]) {
    *f = (struct sph_material){.rgb = {1, 0.5, 0.25}, .kd = 0.5, .ks = 0.5};
    balls[0] = (struct sph_sphere){.ctr = {0, 0, -20}, .rad = 19};
    balls[1] = (struct sph_sphere){.ctr = {3, 0, 2}, .rad = 1};
    struct sph_scene scene = {.path = "two balls", .n_lights = 2, .n_materials = 1, .n_spheres = 2};
    scene.camera =
        (struct sph_camera){{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 30, .width = 48, .height = 48};
    scene.lights[0] = (struct sph_light){{0, 0, 20}, {0, 0, 0}, 0};
    scene.lights[1] = (struct sph_light){{8, 0, 10}, {0.75, 0.75, 0.75}, 0};
    scene.materials = f, scene.spheres = balls;
    return scene;
}

/* Every kind of mistake is counted, once each, where there was none. */
static void mistakes(void **state) {
    (void)state;
    struct sph_material f;
    struct sph_sphere balls[2];
    struct sph_scene scene = two_balls(&f, balls);
    struct sph_build_options o = {.profile = SPH_REFERENCE,
                                  .tree = SPH_TREE_BALANCED,
                                  .background = SPH_BG_NONE,
                                  .max_depth = DEPTH,
                                  .shadow = SPH_AUTO,
                                  .reflect = SPH_AUTO,
                                  .lights = SPH_AUTO,
                                  .inside = SPH_AUTO,
                                  .interpenetrate = SPH_AUTO};
    static struct sph_trail trails[48 * 48];
    struct sph_render_options how = {.threads = 1, .trails = trails};
    struct sph_machine m;
    struct sph_build_report report;
    struct sph_frame frame;
    struct sph_counters c = {{0}};
    struct sph_error err = {{0}};
    assert_int_equal(sph_build(&scene, &o, &m, &report, &err), 0);
    assert_int_equal(m.regs[SPH_REG_N_LIGHTS], 1);
    assert_int_equal(report.lights[0], 1);
    assert_int_equal(sph_render(&m, &how, &frame, &c, &err), 0);
    struct sph_reference r = reference(&scene, 48, 48, NULL);
    struct sph_accuracy_frame view = {&m, &frame, trails, report.lights, 0, 1, NULL};

    struct sph_accuracy e = sph_accuracy_measure(&view, &r);
    assert_int_equal(e.image.silhouette + e.image.wrong_id + e.shadow + e.reflected, 0);
    assert_true(e.same > 1000 && e.t_worst > 0 && e.t_worst < 0.5 && e.t_mean < e.t_worst);

    int shaded = -1, mirrored = -1;
    for (int i = 0; i < 48 * 48; i++) {
        if (trails[i].blocked) shaded = i;
        if (trails[i].reflected_id == 1 && frame.pixels[i].id == 0) mirrored = i;
    }
    assert_true(shaded >= 0 && mirrored >= 0);
    assert_int_equal(r.pixels[shaded].shadow, 2);
    trails[shaded].blocked = 0;
    assert_int_equal(sph_accuracy_measure(&view, &r).shadow, 1);
    trails[shaded].faced = 0; /* then it is no shadow, but a light on the other side */
    assert_int_equal(sph_accuracy_measure(&view, &r).shadow, 0);
    trails[mirrored].reflected_id = SPH_ID_NONE;
    assert_int_equal(sph_accuracy_measure(&view, &r).reflected, 1);
    r.pixels[mirrored].distance += ldexp(100, m.grid_log2);
    e = sph_accuracy_measure(&view, &r);
    assert_true(fabs(e.t_worst - 100) < 1);
    assert_int_equal(48 * e.y + e.x, mirrored);
    r.pixels[mirrored].id = 1; /* another sphere: nothing else is asked of the pixel */
    e = sph_accuracy_measure(&view, &r);
    assert_int_equal(e.image.wrong_id, 1);
    assert_int_equal(e.reflected, 0);
    assert_true(e.t_worst < 0.5);

    sph_reference_free(&r);
    sph_frame_free(&frame);
    sph_machine_free(&m);
}

static void comparison(void **state) {
    (void)state;
    struct sph_pixel p[2] = {{.colour = {0x102030, 0, 0}, .id = 1}, {.id = SPH_ID_NONE}};
    struct sph_reference_pixel q[2] = {{.colour = {0x102030, 0, 9}, .id = 2}, {.id = 3}};
    struct sph_frame f = {2, 1, p};
    struct sph_reference r = {.width = 2, .height = 1, .pixels = q};
    struct sph_image_error e = sph_reference_compare(&f, &r);
    assert_true(isinf(e.psnr[0]) && isinf(e.psnr[1]));
    assert_true(fabs(e.psnr[2] - 10 * log10(65025.0 * 6 / 81)) < 1e-9);
    assert_int_equal(e.silhouette, 1);
    assert_int_equal(e.wrong_id, 1);
    assert_int_equal(e.far_off, 1);
    assert_int_equal(e.worst, 9);
    r.width = 1;
    assert_int_equal(sph_reference_compare(&f, &r).pixels, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reference_by_hand), cmocka_unit_test(facets_by_hand),
        cmocka_unit_test(mistakes),          cmocka_unit_test(comparison),
        cmocka_unit_test(psnr_of_profiles),  cmocka_unit_test(psnr_of_facets),
    };
    return cmocka_run_group_tests_name("accuracy", tests, NULL, NULL);
}
