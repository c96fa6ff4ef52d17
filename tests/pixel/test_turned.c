/* test_turned.c - rays of a grid that has the scene's axes, and when it has them
 * SPDX-License-Identifier: Apache-2.0
 */
#include "build_scene.h"

#include "builder/grid/grid.h"
#include "render/render.h"
#include "machine/camera.h"
#include "pixel/background.h"
#include "naive/naive.h"
#include "validate/validate.h"

enum { W = 24, H = 18 };

static const struct sph_build_options along = {.profile = SPH_STANDARD,
                                               .tree = SPH_TREE_BOX4,
                                               .axes = SPH_AXES_AUTO,
                                               .width = W,
                                               .height = H,
                                               .max_depth = 2,
                                               .asked = {SPH_EACH_EFFECT(SPH_BUILD_ASKED)}};

/* A wall in the plane where axis i is p, of two triangles from lo to hi. */
static void wall(struct sph_scene *s, int i, double p, double lo, double hi) {
    double v[4][3];
    for (int k = 0; k < 4; k++) {
        v[k][i] = p;
        v[k][(i + 1) % 3] = k & 1 ? hi : lo;
        v[k][(i + 2) % 3] = k & 2 ? hi : lo;
    }
    struct sph_vec c[4];
    for (int k = 0; k < 4; k++)
        c[k] = at(v[k][0], v[k][1], v[k][2]);
    add_triangle(s, c[0], c[1], c[2], s->n_facets);
    add_triangle(s, c[3], c[1], c[2], s->n_facets);
}

/* Six walls of a box around two balls, seen askew from within. */
static struct sph_scene room(void) {
    struct sph_scene s = bare();
    for (int i = 0; i < 3; i++) {
        wall(&s, i, -5.1, -5.1, 5.1);
        wall(&s, i, 5.1, -5.1, 5.1);
    }
    add_ball(&s, at(0.3, 0.2, 0.4), 0.8);
    add_ball(&s, at(-2, 1, 0), 0.6);
    return s;
}

static struct sph_vec anywhere(double far) {
    return near_to(at(0, 0, 0), far);
}

/* Directions are those of the camera, to nearest, as long as WD bits hold; camera and screen are
 * found again in the registers. */
static void test_directions(void **unused) {
    (void)unused;
    double worst = 0;
    for (int run = 0; run < 150; run++) {
        struct sph_scene s = room();
        struct sph_build_options o = along;
        struct sph_build_report report;
        s.camera.from = anywhere(4);
        s.camera.at = anywhere(4);
        s.camera.angle = between(5, 100);
        for (int i = 0; i < 2 && run & 4; i++) /* the view meets the screen beside the middle */
            s.camera.shift[i] = between(-0.7, 0.7);
        o.profile = run % SPH_PROFILES;
        o.axes = SPH_AXES_SCENE;
        o.width = (int)between(1, 900), o.height = (int)between(1, 700);
        struct sph_machine m;
        struct sph_grid grid;
        struct sph_rays rays;
        struct sph_error err = {{0}};
        if (sph_build(&s, &o, &m, &report, &err)) {
            assert_non_null(strstr(err.text, "profile"));
            continue;
        }
        assert_int_equal(sph_machine_validate(&m, &err), 0);
        assert_true(sph_machine_effect(&m, SPH_EFFECT_TURNED));
        const struct sph_profile *p = &m.profile;
        assert_int_equal(sph_grid_fit(&s, p->w, SPH_AXES_SCENE, &grid, &err), 0);
        struct sph_raster raster =
            sph_raster_of(&s.camera, o.width, o.height, grid.seen_from.angle);
        assert_int_equal(sph_rays_of(&raster, p, &rays, &err), 0);
        struct sph_machine_camera camera = sph_machine_camera(&m);
        assert_true(fabs(camera.screen / (-(double)rays.z / rays.pitch) - 1) < 1e-3);
        int64_t most = 0;
        for (int n = 0; n < 40; n++) {
            int x = n & 1 ? o.width - 1 : 0, y = n & 2 ? o.height - 1 : 0; /* corners first */
            if (n > 3) x = (int)between(0, o.width), y = (int)between(0, o.height);
            double d[3] = {rays.x0 + (double)x * rays.pitch, rays.y0 - (double)y * rays.pitch,
                           rays.z};
            double exact[3], size = 0, length = 0, off = 0;
            int64_t dir[3];
            sph_primary_dir(&m, x, y, dir);
            for (int i = 0; i < 3; i++) { /* rows of the camera are its axes in the scene */
                exact[i] =
                    grid.camera[i] * d[0] + grid.camera[3 + i] * d[1] + grid.camera[6 + i] * d[2];
                size += exact[i] * exact[i];
                length += (double)dir[i] * (double)dir[i];
                assert_true(llabs(dir[i]) < 1ll << (p->wd - 1));
                if (llabs(dir[i]) > most) most = llabs(dir[i]);
            }
            for (int i = 0; i < 3; i++)
                off += pow((double)dir[i] / sqrt(length) - exact[i] / sqrt(size), 2);
            double aside = hypot(x - (o.width - 1) / 2.0, y - (o.height - 1) / 2.0);
            double step = (report.fov_error - rays.fov_error) * aside / camera.screen;
            worst = fmax(worst, (sqrt(off) - step) * sqrt(length));
            assert_true(sph_camera_ahead(&camera, dir) >= (double)sph_min_screen(p));
        }
        assert_true(most > (1ll << (p->wd - 1)) - 7 - ((o.width + o.height) >> (32 - p->wd)));
        for (int k = 0; k < 3; k++)
            for (int i = 0; i < 3; i++)
                assert_true(fabs(camera.axes[k][i] - grid.camera[3 * k + i]) < 2e-3);
        sph_machine_free(&m);
    }
    printf("# no ray is off by more than %.3f units of its direction\n", worst);
    assert_true(worst > 0.5 && worst < 0.9); /* half a unit in three axes is 0.87 */
}

/* The naive model, which adds nothing up, draws the same. */
static void test_naive(void **unused) {
    (void)unused;
    for (int run = 0; run < 8; run++) {
        struct sph_scene s = room();
        struct sph_build_options o = along;
        struct sph_build_report report;
        struct sph_error err = {{0}};
        s.camera.from = anywhere(4);
        o.profile = run % SPH_PROFILES;
        o.tree = run & 4 ? SPH_TREE_BIH : SPH_TREE_BOX4;
        struct sph_machine m = built(&s, o, &report);
        assert_true(sph_machine_effect(&m, SPH_EFFECT_TURNED));
        for (int fast = 0; fast < 2; fast++) {
            struct sph_frame frame;
            struct sph_counters counters = {{0}};
            struct sph_render_options how = {.traverse =
                                                 fast ? SPH_TRAVERSE_FAST : SPH_TRAVERSE_TREE};
            assert_int_equal(sph_render(&m, &how, &frame, &counters, &err), 0);
            for (int i = 0; i < W * H; i += SANITIZED ? 7 : 1) {
                struct sph_pixel naive = sph_naive_pixel(&m, i % W, i / W);
                assert_int_equal(naive.id, frame.pixels[i].id);
                assert_true(naive.key == frame.pixels[i].key);
                assert_memory_equal(naive.colour, frame.pixels[i].colour, sizeof naive.colour);
            }
            sph_frame_free(&frame);
        }
        sph_machine_free(&m);
    }
}

/* Boxes of what stands along the scene's axes ask for them, unless the camera's are needed. */
static void test_choice(void **unused) {
    (void)unused;
    struct sph_scene s = room();
    struct sph_build_options o = along;
    s.camera.from = at(4, 3, 1.5);
    assert_int_equal(sph_axes_of(&s, &o), SPH_AXES_SCENE);
    o.tree = SPH_TREE_AUTO;
    assert_int_equal(sph_axes_of(&s, &o), SPH_AXES_SCENE);
    o.tree = SPH_TREE_BIH;
    assert_int_equal(sph_axes_of(&s, &o), SPH_AXES_SCENE);
    o.tree = SPH_TREE_BRUTE;
    assert_int_equal(sph_axes_of(&s, &o), SPH_AXES_CAMERA);
    o.tree = SPH_TREE_REINSERTED;
    assert_int_equal(sph_axes_of(&s, &o), SPH_AXES_CAMERA);
    o.axes = SPH_AXES_SCENE;
    assert_int_equal(sph_axes_of(&s, &o), SPH_AXES_SCENE);
    o = along;
    o.background = SPH_BG_RECT;
    assert_int_equal(sph_axes_of(&s, &o), SPH_AXES_CAMERA);
    o.background = SPH_BG_NONE;
    s.camera = (struct sph_camera){{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 40, .width = W, .height = H};
    assert_int_equal(sph_axes_of(&s, &o), SPH_AXES_CAMERA); /* they are the scene's */
    s.n_facets = 0;
    s.camera.from = at(4, 3, 1.5);
    assert_int_equal(sph_axes_of(&s, &o), SPH_AXES_CAMERA); /* balls do not care */
}

static void refuse(struct sph_build_options o, const char *part) {
    struct sph_scene s = room();
    struct sph_machine m;
    struct sph_build_report report;
    struct sph_error err = {{0}};
    assert_int_equal(sph_build(&s, &o, &m, &report, &err), -1);
    if (!strstr(err.text, part)) fail_msg("%s: not %s", err.text, part);
}

/* What a turned grid does without is refused, by build and in a machine. */
static void test_refusals(void **unused) {
    (void)unused;
    static const struct {
        int number, value;
        const char *part;
    } list[] = {{SPH_REG_BG_MODE, 1, "BG_MODE is 1"},
                {SPH_REG_PITCH, 2, "PITCH is 2"},
                {SPH_REG_ACROSS_Y, 1 << 30, "DIR_Y: a corner of the frame leaves 17 bits"},
                {SPH_REG_DOWN_Z, -(1 << 30), "DIR_Z: a corner of the frame leaves 17 bits"},
                {SPH_REG_DIR_X0, INT32_MIN, "DIR_X: a corner of the frame leaves 17 bits"}};
    struct sph_build_options o = along;
    o.axes = SPH_AXES_SCENE;
    struct sph_scene s = room();
    struct sph_build_report report;
    struct sph_error err = {{0}};
    struct sph_machine m = built(&s, o, &report);
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        int32_t before = m.regs[list[i].number];
        err = (struct sph_error){{0}};
        m.regs[list[i].number] = list[i].value;
        assert_int_equal(sph_machine_validate(&m, &err), -1);
        if (!strstr(err.text, list[i].part)) fail_msg("%s: not %s", err.text, list[i].part);
        m.regs[list[i].number] = before;
    }
    err = (struct sph_error){{0}};
    for (int i = 0; i < 3; i++) /* the eye in the plane of the screen */
        m.regs[SPH_REG_DIR_X0 + i] = -m.regs[SPH_REG_ACROSS_X + i];
    assert_int_equal(sph_machine_validate(&m, &err), -1);
    assert_non_null(strstr(err.text, "the screen is too near"));
    for (int i = 0; i < 3; i++) /* no plane at all */
        m.regs[SPH_REG_DOWN_X + i] = m.regs[SPH_REG_ACROSS_X + i];
    assert_int_equal(sph_machine_validate(&m, &err), -1);
    sph_machine_free(&m);
    o.background = SPH_BG_SPANS;
    refuse(o, "background is separated along the camera's axes alone");
    o.background = SPH_BG_NONE;
    o.axes = 2;
    refuse(o, "there are no axes 2");
}

/* Triangles that every grid merges are left out with a note; a finer profile that tells them apart
 * is named instead. */
static void test_merged(void **unused) {
    (void)unused;
    struct sph_scene s = room();
    struct sph_build_options o = along;
    struct sph_build_report report;
    struct sph_machine m;
    struct sph_error err = {{0}};
    const struct sph_vec a = at(1, 0, 0), b = at(0, 1, 0), c = at(0, 0, 1), d = at(0, 1e-9, 1);
    uint32_t n = s.n_facets;
    add_triangle(&s, a, b, c, n);
    add_triangle(&s, a, b, d, n + 1);
    for (o.profile = SPH_DRAFT; o.profile < SPH_PROFILES; o.profile++) {
        m = built(&s, o, &report);
        assert_int_equal(report.facets, n + 1);
        assert_int_equal(report.ledger.row[SPH_READ_TRIANGLE_GRID].n, 1);
        assert_int_equal(report.ledger.row[SPH_READ_TRIANGLE_GRID].line, 113);
        sph_machine_free(&m);
    }
    facet_list[n + 1].v[2].y = 1e-4;
    o.profile = SPH_DRAFT;
    assert_int_equal(sph_build(&s, &o, &m, &report, &err), -1);
    assert_non_null(strstr(err.text, "merges this triangle with that of line 112: profile"));
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_directions), cmocka_unit_test(test_naive),
        cmocka_unit_test(test_choice),     cmocka_unit_test(test_refusals),
        cmocka_unit_test(test_merged),
    };
    seed(argc, argv);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
