/* test_met.c - what no ray of a frame meets is left out, and the frame stays what it was
 * SPDX-License-Identifier: Apache-2.0
 *
 * build/test/test_met; run from the root of the repository: reads scenes/ and tests/scenes/met.nff.
 */
#include "effects_scene.h"

#include "common/parallel.h"
#include "machine/camera.h"
#include "naive/naive.h"
#include "textured.h"
#include "trial/met.h"
#include "validate/validate.h"
#include "scene_list.h"

enum { WIDTH = 64, HEIGHT = 36 };

static struct sph_build_report report, full;
static const struct sph_error_bound bound = {SPH_ERROR_BOUND_PIXELS, SPH_ERROR_BOUND_PSNR};

enum { IMAGES = 16 };
static struct sph_mip images[IMAGES]; /* noise: what a file shows does not matter here */

struct read {
    struct sph_scene scene;
    struct sph_build_options o;
};

static int paint(void **unused) {
    struct sph_rng random = {1};
    (void)unused;
    for (int i = 0; i < IMAGES; i++)
        images[i] = textured_mip(64, 64, &random);
    return 0;
}

static int wipe(void **unused) {
    (void)unused;
    for (int i = 0; i < IMAGES; i++)
        free(images[i].texels);
    return 0;
}

static struct read read_scene(const char *path) {
    struct read r = {.o = SPH_BUILD_DEFAULT};
    struct sph_error err = {{0}};
    struct sph_read_options how = {0};
    if (sph_scene_read(path, &how, &r.scene, &err)) fail_msg("%s", err.text);
    assert_true(r.scene.n_textures <= IMAGES);
    r.o.width = WIDTH, r.o.height = HEIGHT, r.o.mips = images;
    return r;
}

static struct sph_machine build(const struct read *r, int met) {
    struct sph_machine m;
    struct sph_error err = {{0}};
    struct sph_build_options o = r->o;
    struct sph_profile_choice choice;
    if ((met ? sph_build_met : sph_build_kept)(&r->scene, &o, 1, &bound, &choice, &m,
                                               met ? &report : &full, &err))
        fail_msg("%s", err.text);
    if (sph_machine_validate(&m, &err)) fail_msg("%s: %s", r->scene.path, err.text);
    return m;
}

/* Effects are fewer, and pixels differ only where the grid does. Counts what was left out. */
static void compare_scene(const char *path, int off[SPH_REPORTS], int *grids) {
    struct read r = read_scene(path);
    struct sph_machine every = build(&r, 0), some = build(&r, 1);
    struct sph_frame a = frame_of(&every), b = frame_of(&some); /* and no error */
    int other = every.grid_log2 != some.grid_log2 ||
                every.regs[SPH_REG_N_PRIMS] != some.regs[SPH_REG_N_PRIMS];
    if (!other && frames_differ(&a, &b)) fail_msg("%s: frames differ", path);
    int less = other;
    for (int i = 0; i < SPH_REPORTS; i++) {
        if (i != SPH_REPORT_CAMERA && report.effects[i].on > full.effects[i].on)
            fail_msg("%s: %s came on", path, report.effects[i].name);
        off[i] += report.effects[i].on < full.effects[i].on;
        less |= report.effects[i].on < full.effects[i].on;
    }
    *grids += other;
    if (!less != !sph_machine_effect(&some, SPH_EFFECT_CAMERA)) fail_msg("%s: ONE_CAMERA", path);
    sph_frame_free(&a), sph_frame_free(&b);
    sph_machine_free(&every), sph_machine_free(&some);
    sph_scene_free(&r.scene);
}

static void each_scene(void (*take)(const char *path, int off[SPH_REPORTS], int *n),
                       int off[SPH_REPORTS], int *n) {
    static const char *const where[] = {"scenes/*.nff",          "scenes/effects/effects.nff:*",
                                        "scenes/facets/*.nff",   "scenes/refraction/*.nff",
                                        "scenes/texture/*.nff",  "scenes/views/*.nff",
                                        "tests/scenes/met.nff:*"};
    struct scene_list found = list_scenes(where, sizeof where / sizeof *where);
    for (size_t i = 0; i < found.n; i++)
        take(found.name[i], off, n);
}

static void test_same_frames(void **unused) {
    int off[SPH_REPORTS] = {0}, grids = 0;
    (void)unused;
    each_scene(compare_scene, off, &grids);
    for (int i = 0; i < SPH_REPORTS; i++)
        if (off[i]) printf("# %s left out of %d scenes\n", sph_parts[i].word, off[i]);
    printf("# %d with another grid, or fewer primitives\n", grids);
    static const int all[] = {SPH_REPORT_SHADOW,   SPH_REPORT_REFLECT, SPH_REPORT_LIGHTS,
                              SPH_REPORT_INSIDE,   SPH_REPORT_REFRACT, SPH_REPORT_TEXTURE,
                              SPH_REPORT_SPECULAR, SPH_REPORT_SUM,     SPH_REPORT_SMOOTH,
                              SPH_REPORT_FACETS,   SPH_REPORT_CLEAR};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        assert_true(off[all[i]] > 0);
    assert_true(grids >= 4);
}

/* ---- a camera that moves ---- */

/* The frame, whichever errors there are. */
static int drawn(const struct sph_machine *m, int how, struct sph_frame *frame) {
    struct sph_render_options o = {.traverse = how, .threads = 1};
    struct sph_counters c = {{0}};
    struct sph_error err = {{0}};
    return sph_render(m, &o, frame, &c, &err);
}

/* Moves the eye by scene units along the camera's axes. */
static void move(struct sph_machine *m, const double by[3]) {
    for (int i = 0; i < 3; i++)
        m->regs[SPH_REG_EYE_X + i] += (int32_t)lround(ldexp(by[i], -m->grid_log2));
}

/* A scene, what is left out of it, and where the eye has to go to meet that. */
static const struct moved {
    const char *scene;
    int left_out; /* SPH_REPORT_* */
    double by[3];
} moves[] = {
    {"light_below", SPH_REPORT_LIGHTS, {0, -4, 0}},   /* under the floor, which it lights */
    {"shadow_behind", SPH_REPORT_SHADOW, {0, 0, 12}}, /* the shadow comes into sight */
    {"clear_behind", SPH_REPORT_CLEAR, {0, 0, 12}},   /* it would be one */
    {"inside_behind", SPH_REPORT_INSIDE, {0, -5, 6}}, /* the eye is in both balls */
    {"mirror_behind", SPH_REPORT_REFLECT, {0, 0, 8}}, /* the mirror */
    {"all_behind", SPH_REPORT_TEXTURE, {-3, -3, 12}}, /* the image */
    {"all_behind", SPH_REPORT_SMOOTH, {4, 0, 12}},    /* the normals */
    {"all_behind", SPH_REPORT_REFRACT, {3, -5, 15}},  /* the glass */
    {"all_behind", SPH_REPORT_SPECULAR, {3, -5, 15}}, /* its highlight */
    {"all_behind", SPH_REPORT_SUM, {3, -5, 15}},      /* its shares */
    {"mirrors_behind", SPH_REPORTS, {0, 0, 9}},       /* mirrors that face each other */
    {"behind", SPH_REPORTS, {0, 0, 60}},              /* a ball that made the grid coarse */
    {"triangle_behind", SPH_REPORTS, {4, -2.5, 12}},  /* the only triangle */
};

/* One of them: another camera is refused by model and naive model, in every way of drawing, where
 * it would show what is left out; its own is not. */
static void move_one(const struct moved *t) {
    char path[128];
    snprintf(path, sizeof path, "tests/scenes/met.nff:%s", t->scene);
    struct read r = read_scene(path);
    r.o.max_depth = SPH_MAX_DEPTH;
    struct sph_machine every = build(&r, 0), some = build(&r, 1);
    if (t->left_out < SPH_REPORTS && !report.effects[t->left_out].left_out)
        fail_msg("%s: %s is not left out", path, sph_parts[t->left_out].word);
    if (t->left_out == SPH_REPORTS && !report.left_out[0]) fail_msg("%s: nothing more", path);
    assert_int_equal(sph_naive_strayed(&some), 0);
    move(&every, t->by), move(&some, t->by);
    struct sph_frame nothing, wrong, right = frame_of(&every);
    assert_int_equal(sph_naive_strayed(&some), 1);
    for (int how = SPH_TRAVERSE_TREE; how <= SPH_TRAVERSE_PACKETS; how++) {
        if (drawn(&some, how, &nothing) != 1 << SPH_ERROR_LEFT_OUT) fail_msg("%s: drawn", path);
        for (int i = 0; i < WIDTH * HEIGHT; i++)
            assert_int_equal(nothing.pixels[i].colour[0], 0);
        sph_frame_free(&nothing);
    }
    struct sph_error err = {{0}};
    assert_int_equal(sph_machine_validate(&some, &err), -1);
    some.regs[SPH_REG_EFFECTS] &= ~(1 << SPH_EFFECT_CAMERA);
    assert_int_equal(drawn(&some, SPH_TRAVERSE_TREE, &wrong), 0);
    if (!frames_differ(&right, &wrong)) fail_msg("%s: it was not met at all", path);
    sph_frame_free(&right), sph_frame_free(&wrong);
    sph_machine_free(&every), sph_machine_free(&some);
    sph_scene_free(&r.scene);
}

static void test_moved(void **unused) {
    (void)unused;
    for (size_t i = 0; i < sizeof moves / sizeof *moves; i++)
        move_one(&moves[i]);
}

/* The sum of any registers, in axes of the camera and of the scene: each changed bit that a core
 * keeps is found, as by the naive model; of registers that it does not keep, none. */
static void test_sum(void **unused) {
    struct sph_rng random = {7};
    struct sph_machine m = {.regs[SPH_REG_EFFECTS] = 1 << SPH_EFFECT_CAMERA};
    (void)unused;
    for (int n = 0; n < 4000; n++) {
        sph_machine_set_profile(&m, &sph_profiles[n % SPH_PROFILES]);
        m.regs[SPH_REG_EFFECTS] ^= (n & 1) << SPH_EFFECT_TURNED;
        for (int i = 0; i < SPH_N_REGS; i++)
            if (i != SPH_REG_EFFECTS && i != SPH_REG_PROFILE)
                m.regs[i] = (int32_t)sph_rng_next(&random);
        m.regs[SPH_REG_ONE_CAMERA] = sph_camera_sum(&m);
        assert_int_equal(sph_camera_strayed(&m) | sph_naive_strayed(&m), 0);
        int reg = (int)(sph_rng_next(&random) % SPH_REG_ONE_CAMERA);
        if (reg == SPH_REG_EFFECTS || reg == SPH_REG_PROFILE) continue;
        m.regs[reg] ^= (int32_t)(1u << sph_rng_next(&random) % 12); /* no profile has fewer bits */
        int seen = (reg >= SPH_REG_EYE_X && reg <= SPH_REG_PITCH) ||
                   (reg >= SPH_REG_ACROSS_X && reg <= SPH_REG_DOWN_Z);
        assert_int_equal(sph_camera_strayed(&m), seen);
        assert_int_equal(sph_naive_strayed(&m), seen);
    }
}

/* Nothing depends on the number of threads. */
static void test_threads(void **unused) {
    struct read r = read_scene("scenes/sphereflake2.nff");
    int before = sph_parallel_most(1);
    (void)unused;
    struct sph_machine one = build(&r, 1);
    sph_parallel_most(7);
    struct sph_machine many = build(&r, 1);
    sph_parallel_most(before);
    assert_int_equal(one.lines, many.lines);
    assert_memory_equal(one.regs, many.regs, sizeof one.regs);
    assert_memory_equal(one.mem, many.mem, 4ul * SPH_LINE_WORDS * one.lines);
    sph_machine_free(&one), sph_machine_free(&many);
    sph_scene_free(&r.scene);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_same_frames),
                                       cmocka_unit_test(test_moved), cmocka_unit_test(test_sum),
                                       cmocka_unit_test(test_threads)};
    return cmocka_run_group_tests_name("what rays meet", tests, paint, wipe);
}
