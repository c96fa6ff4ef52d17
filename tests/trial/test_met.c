/* test_met.c - what no ray of a frame meets is left out, and the frame stays what it was
 * SPDX-License-Identifier: Apache-2.0
 *
 * build/test/test_met; run from the root of the repository: reads scenes/ and tests/scenes/met/.
 */
#include "effects_scene.h"

#include <glob.h>

#include "common/parallel.h"
#include "textured.h"
#include "trial/met.h"
#include "validate/validate.h"

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
        if (report.effects[i].on > full.effects[i].on)
            fail_msg("%s: %s came on", path, report.effects[i].name);
        off[i] += report.effects[i].on < full.effects[i].on;
        less |= report.effects[i].on < full.effects[i].on;
    }
    *grids += other;
    if (!less != !some.regs[SPH_REG_ONE_CAMERA]) fail_msg("%s: ONE_CAMERA", path);
    sph_frame_free(&a), sph_frame_free(&b);
    sph_machine_free(&every), sph_machine_free(&some);
    sph_scene_free(&r.scene);
}

static void each_scene(void (*take)(const char *path, int off[SPH_REPORTS], int *n),
                       int off[SPH_REPORTS], int *n) {
    static const char *const where[] = {"scenes/*.nff",          "scenes/effects/*.nff",
                                        "scenes/facets/*.nff",   "scenes/refraction/*.nff",
                                        "scenes/texture/*.nff",  "scenes/views/*.nff",
                                        "tests/scenes/met/*.nff"};
    glob_t found = {0};
    for (size_t i = 0; i < sizeof where / sizeof *where; i++)
        assert_int_equal(glob(where[i], i ? GLOB_APPEND : 0, NULL, &found), 0);
    for (size_t i = 0; i < found.gl_pathc; i++)
        take(found.gl_pathv[i], off, n);
    globfree(&found);
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
                              SPH_REPORT_FACETS};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        assert_true(off[all[i]] > 0);
    assert_true(grids >= 4);
}

/* A census that lies, no ray meets any surface: where that changes a pixel by a material, the model
 * says so by the error LEFT_OUT, and by no other. */
static void lie(const char *path, int caught[SPH_REPORTS], int *n) {
    struct read r = read_scene(path);
    struct sph_machine every = build(&r, 0), some;
    size_t prims = (size_t)r.scene.n_spheres + r.scene.n_facets + 1;
    uint8_t *none = malloc(prims);
    struct sph_unmet unmet = {.prims = none};
    struct sph_build_options o = r.o;
    struct sph_error err = {{0}};
    struct sph_frame a = frame_of(&every), b;
    memset(none, 1, prims);
    o.widths = sph_machine_profile(&every), o.unmet = &unmet;
    if (sph_build(&r.scene, &o, &some, &report, &err)) fail_msg("%s", err.text);
    for (int way = 0; way < 2; way++) {
        struct sph_render_options how = {.traverse = way ? SPH_TRAVERSE_FAST : SPH_TRAVERSE_TREE,
                                         .threads = 1};
        struct sph_counters c = {{0}};
        int errors = sph_render(&some, &how, &b, &c, &err);
        if (errors & ~(1 << SPH_ERROR_LEFT_OUT)) fail_msg("%s: error bits %d", path, errors);
        if (frames_differ(&a, &b) && !errors) fail_msg("%s: a wrong pixel and no error", path);
        sph_frame_free(&b);
        *n += errors != 0;
    }
    for (int i = 0; i < SPH_REPORTS; i++)
        caught[i] += report.effects[i].left_out;
    free(none);
    sph_frame_free(&a);
    sph_machine_free(&every), sph_machine_free(&some);
    sph_scene_free(&r.scene);
}

static void test_lies(void **unused) {
    int caught[SPH_REPORTS] = {0}, n = 0;
    (void)unused;
    each_scene(lie, caught, &n);
    printf("# %d frames in error\n", n);
    assert_true(n > 60);
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
                                       cmocka_unit_test(test_lies), cmocka_unit_test(test_threads)};
    return cmocka_run_group_tests_name("what rays meet", tests, paint, wipe);
}
