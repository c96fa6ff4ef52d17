/* test_machine_limits.c - what a register of a valid machine may hold: both ends, and one beyond
 * SPDX-License-Identifier: Apache-2.0
 */
#include "build_scene.h"

#include <string.h>

#include "machine/machine.h"
#include "validate/validate.h"

/* Both ends are valid, what lies below or above them is refused in words. */
static void between_ends(struct sph_machine *m, int number, int64_t least, int64_t most,
                         const char *below, const char *above) {
    const int32_t before = m->regs[number];
    const int64_t values[] = {least, most, least - 1, most + 1};
    for (int i = 0; i < 4; i++) {
        struct sph_error err = {{0}};
        const char *part = i & 1 ? above : below;
        if (values[i] < INT32_MIN || values[i] > INT32_MAX) continue;
        m->regs[number] = (int32_t)values[i];
        int refused = sph_machine_validate(m, &err);
        if (refused != (i < 2 ? 0 : -1))
            fail_msg("register %d (%s) of %ld: %d %s", number, part, (long)values[i], refused,
                     err.text);
        if (refused && !strstr(err.text, part)) fail_msg("'%s' lacks '%s'", err.text, part);
    }
    m->regs[number] = before;
}

static void ends(struct sph_machine *m, int number, int64_t least, int64_t most, const char *part) {
    between_ends(m, number, least, most, part, part);
}

static struct sph_machine example(int profile) {
    struct sph_scene s = cloud(60, 0.1);
    struct sph_build_options o = standard;
    struct sph_build_report report;
    o.profile = profile;
    o.background = SPH_BG_NONE;
    struct sph_machine m = built(&s, o, &report);
    free(s.spheres);
    return m;
}

static void test_frame(void **unused) {
    (void)unused;
    struct sph_machine m = example(SPH_STANDARD);
    int32_t *r = m.regs;
    ends(&m, SPH_REG_MAX_DEPTH, 0, SPH_MAX_DEPTH, "MAX_DEPTH");
    ends(&m, SPH_REG_N_LIGHTS, 0, SPH_MAX_LIGHTS, "N_LIGHTS");
    ends(&m, SPH_REG_WIN_X0, 0, r[SPH_REG_WIN_X1], "WIN_X0");
    ends(&m, SPH_REG_WIN_Y0, 0, r[SPH_REG_WIN_Y1], "WIN_Y0");
    ends(&m, SPH_REG_WIN_X1, r[SPH_REG_WIN_X0], r[SPH_REG_FRAME_W], "WIN_X");
    ends(&m, SPH_REG_WIN_Y1, r[SPH_REG_WIN_Y0], r[SPH_REG_FRAME_H], "WIN_Y");
    ends(&m, SPH_REG_BG_COLOUR, 0, 0xffffff, "BG_COLOUR");
    for (int i = 0; i < 3; i++)
        ends(&m, SPH_REG_AMBIENT_R + i, 0, 65535, "AMBIENT_");
    ends(&m, SPH_REG_VISIT_LIMIT, 1, 0xffffff, "VISIT_LIMIT");
    ends(&m, SPH_REG_MEM_LINES, m.lines, m.lines, "MEM_LINES");
    ends(&m, SPH_REG_LEAST_WEIGHT, 0, SPH_LEAST_WEIGHT_MAX, "LEAST_WEIGHT");
    r[SPH_REG_RECT_X1] = 20, r[SPH_REG_RECT_Y1] = 10;
    ends(&m, SPH_REG_RECT_X0, 0, 20, "RECT_X0");
    ends(&m, SPH_REG_RECT_Y0, 0, 10, "RECT_Y0");
    ends(&m, SPH_REG_RECT_X1, 0, r[SPH_REG_FRAME_W], "RECT_X1");
    ends(&m, SPH_REG_RECT_Y1, 0, r[SPH_REG_FRAME_H], "RECT_Y1");
    ends(&m, SPH_REG_TEX_FILTER, 0, 0, "TEX_FILTER");
    ends(&m, SPH_REG_COARSE, 0, 0, "COARSE");
    ends(&m, SPH_REG_SMOOTH_BASE, 0, 0, "SMOOTH_BASE");
    ends(&m, SPH_REG_FACET_BASE, 0, 0, "FACET_BASE");
    ends(&m, SPH_REG_N_SPHERES, 0, 0, "N_SPHERES");
    ends(&m, SPH_REG_BG_COUNT, 0, 0, "BG_COUNT");
    ends(&m, SPH_REG_BG_BASE, 0, 0, "BG_BASE");
    for (int i = 0; i < 8; i++)
        ends(&m, SPH_REG_LEAF_BASE + i, 0, 0, i < 2 ? "L" : "BOX_");
    sph_machine_free(&m);
}

/* Eye, directions and lights in the width of each profile. */
static void test_geometry(void **unused) {
    (void)unused;
    for (int profile = 0; profile < SPH_PROFILES; profile++) {
        struct sph_machine m = example(profile);
        int32_t *r = m.regs;
        const struct sph_profile *p = sph_machine_profile(&m);
        const int64_t w = 1ll << (p->w - 1), wd = (1ll << (p->wd - 1)) - 1;
        for (int i = 0; i < 3; i++) {
            ends(&m, SPH_REG_EYE_X + i, -w, w - 1, "EYE_");
            ends(&m, SPH_REG_ACROSS_X + i, 0, 0, "ACROSS_");
            ends(&m, SPH_REG_DOWN_X + i, 0, 0, "DOWN_");
        }
        ends(&m, SPH_REG_DIR_Z, -wd, -sph_min_screen(p), "DIR_Z");
        r[SPH_REG_PITCH] = 3;
        between_ends(&m, SPH_REG_DIR_X0, -wd, wd - 3 * (r[SPH_REG_FRAME_W] - 1), "DIR_X0",
                     "PITCH is 3: the last column");
        between_ends(&m, SPH_REG_DIR_Y0, 3 * (r[SPH_REG_FRAME_H] - 1) - wd, wd,
                     "PITCH is 3: the last row", "DIR_Y0");
        r[SPH_REG_DIR_X0] = (int32_t)-wd, r[SPH_REG_DIR_Y0] = 0;
        ends(&m, SPH_REG_PITCH, 1, wd / (r[SPH_REG_FRAME_H] - 1), "PITCH");
        r[SPH_REG_DIR_X0] = 0, r[SPH_REG_DIR_Y0] = (int32_t)wd;
        ends(&m, SPH_REG_PITCH, 1, wd / (r[SPH_REG_FRAME_W] - 1), "PITCH");
        r[SPH_REG_PITCH] = 1, r[SPH_REG_DIR_X0] = r[SPH_REG_DIR_Y0] = 0;
        if (wd >= SPH_MAX_SIDE) {
            ends(&m, SPH_REG_FRAME_W, r[SPH_REG_WIN_X1], SPH_MAX_SIDE, "");
            ends(&m, SPH_REG_FRAME_H, r[SPH_REG_WIN_Y1], SPH_MAX_SIDE, "");
        }
        for (int i = 0; i < 6; i++)
            ends(&m, SPH_REG_LIGHT0_X + SPH_LIGHT_STRIDE + i, i < 3 ? -w : 0,
                 i < 3    ? w - 1
                 : i == 3 ? (32 << SPH_LIGHT_SHIFT_LSB) - 1
                          : 65535,
                 "LIGHT1_");
        r[SPH_REG_FRAME_W] = r[SPH_REG_WIN_X1] = r[SPH_REG_FRAME_H] = r[SPH_REG_WIN_Y1] = 1;
        r[SPH_REG_RECT_X1] = r[SPH_REG_RECT_Y1] = 0;
        ends(&m, SPH_REG_PITCH, 1, 2 * wd, "PITCH");
        sph_machine_free(&m);
    }
}

/* Weights have a limit where something is weighed: mirrors or glass, either of them. */
static void test_weight(void **unused) {
    (void)unused;
    struct sph_machine m = example(SPH_STANDARD);
    m.regs[SPH_REG_EFFECTS] &= ~(1 << SPH_EFFECT_REFLECT);
    struct sph_error err = {{0}};
    m.regs[SPH_REG_LEAST_WEIGHT] = 1;
    assert_int_equal(sph_machine_validate(&m, &err), -1);
    sph_machine_free(&m);
}

/* A line is a child of one node: the first of a group too. */
static void test_shared(void **unused) {
    (void)unused;
    struct sph_machine m = example(SPH_STANDARD);
    struct sph_error err = {{0}};
    const uint32_t base = sph_field(m.mem, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS);
    uint32_t *child = sph_line(&m, base);
    char said[80];
    sph_field_set(child, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS, base + 1);
    sph_field_set(child, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS, 1);
    sph_field_set(child, SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS, 0);
    assert_int_equal(sph_machine_validate(&m, &err), -1);
    snprintf(said, sizeof said, "line %u: child line %u belongs to another node", base, base + 1);
    if (!strstr(err.text, said)) fail_msg("'%s' lacks '%s'", err.text, said);
    sph_machine_free(&m);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_frame),
        cmocka_unit_test(test_geometry),
        cmocka_unit_test(test_weight),
        cmocka_unit_test(test_shared),
    };
    seed(argc, argv);
    return cmocka_run_group_tests_name("machine limits", tests, NULL, NULL);
}
