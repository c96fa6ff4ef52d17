/* test_choose_tree.c - the tree of a scene that none was asked for: the rule, and what it saves
 * SPDX-License-Identifier: Apache-2.0
 *
 * Run from the root of the repository: reads scenes/ and tests/scenes/.
 */
#include "model_scene.h"

/* A core takes a clock a visit and a sphere, and two a triangle or plane, all of them at once. */
enum { W = 48, H = 27, FACET_CLOCKS = 2 };

static struct sph_machine build(const struct sph_scene *scene, int tree, uint32_t max_prims,
                                struct sph_build_report *report) {
    struct sph_build_options o = {.profile = SPH_STANDARD,
                                  .tree = tree,
                                  .max_prims = max_prims,
                                  .width = W,
                                  .height = H,
                                  .max_depth = 2,
                                  .shadow = SPH_AUTO,
                                  .reflect = SPH_AUTO,
                                  .refract = SPH_AUTO,
                                  .specular = SPH_AUTO,
                                  .texture = SPH_OFF,
                                  .lights = SPH_AUTO,
                                  .inside = SPH_AUTO};
    struct sph_machine m;
    struct sph_error err = {{0}};
    if (sph_build(scene, &o, &m, report, &err)) fail_msg("%s", err.text);
    return m;
}

/* Clocks of a frame, as its slower unit has it. */
static double clocks(const struct sph_machine *m) {
    struct sph_counters c;
    int errors;
    struct sph_frame f = model_render(m, SPH_TRAVERSE_TREE, 0, &c, &errors);
    sph_frame_free(&f);
    double tests = (double)c.count[SPH_COUNT_LEAF_TESTS] +
                   FACET_CLOCKS * (double)c.count[SPH_COUNT_FACET_TESTS];
    double visits = (double)c.count[SPH_COUNT_NODE_VISITS];
    return (tests > visits ? tests : visits) / (W * H);
}

/* Triangles, as many as spheres or more: nodes of boxes, the very machine that names them. */
static void rule(void **state) {
    (void)state;
    static const struct {
        const char *path;
        int boxes;
    } cases[] = {{"scenes/texture/kitchen.nff", 1},
                 {"scenes/texture/museum.nff", 1},
                 {"scenes/texture/robot.nff", 1},
                 {"scenes/facets/room.nff", 1},
                 {"scenes/facets/triangles.nff", 1},
                 {"scenes/refraction/water.nff", 1},
                 {"scenes/texture/hall.nff", 0},
                 {"scenes/texture/slant.nff", 1},
                 {"scenes/facets/plane.nff", 0},
                 {"scenes/refraction/four.nff", 0},
                 {"scenes/paper100.nff", 0},
                 {"scenes/sphereflake2.nff", 0},
                 {"scenes/empty.nff", 0}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct sph_build_report report, asked;
        struct sph_scene scene = read_scene(cases[i].path);
        struct sph_machine m = build(&scene, SPH_TREE_AUTO, 0, &report);
        struct sph_machine same =
            build(&scene, cases[i].boxes ? SPH_TREE_BOX4 : SPH_TREE_REINSERTED, 0, &asked);
        printf("# %s: %s\n", cases[i].path, report.tree_why);
        assert_int_equal(m.lines, same.lines);
        assert_memory_equal(m.regs, same.regs, sizeof m.regs);
        assert_memory_equal(m.mem, same.mem, m.lines * SPH_LINE_WORDS * sizeof *m.mem);
        assert_non_null(strstr(report.tree_why, "chosen for "));
        assert_string_equal(asked.tree_why, "");
        sph_machine_free(&m);
        sph_machine_free(&same);
        sph_scene_free(&scene);
    }
}

/* Counted on every scene with triangles: boxes cost less than spheres around children, in the hall
 * as much, or a BIH of one primitive a leaf, and in rooms half of the one and a fourth of the
 * other. */
static void saves(void **state) {
    (void)state;
    enum { BOX4, BVH4, BIH, TREES };
    static const int trees[TREES] = {SPH_TREE_BOX4, SPH_TREE_REINSERTED, SPH_TREE_BIH};
    static const struct {
        const char *path;
        double most[TREES]; /* of the other tree's clocks */
    } cases[] = {{"scenes/texture/kitchen.nff", {1, 0.45, 0.2}},
                 {"scenes/texture/museum.nff", {1, 0.45, 0.25}},
                 {"scenes/texture/robot.nff", {1, 0.55, 0.3}},
                 {"scenes/facets/room.nff", {1, 0.3, 0.25}},
                 {"scenes/facets/triangles.nff", {1, 0.65, 0.25}},
                 {"scenes/refraction/water.nff", {1, 0.95, 0.97}},
                 {"tests/scenes/facets/mixed.nff", {1, 0.92, 0.98}},
                 {"scenes/texture/hall.nff", {1, 1.05, 0.75}},
                 {"scenes/texture/slant.nff", {1, 0.65, 0.65}}};
    for (size_t i = 0; i < (SANITIZED ? 1 : sizeof cases / sizeof *cases); i++) {
        struct sph_scene scene = read_scene(cases[i].path);
        double took[TREES];
        for (int t = 0; t < TREES; t++) {
            struct sph_build_report report;
            struct sph_machine m = build(&scene, trees[t], t == BIH, &report);
            took[t] = clocks(&m);
            sph_machine_free(&m);
        }
        printf("# %-30s clocks a pixel: box4 %6.1f, bvh4 %6.1f, bih %6.1f\n", cases[i].path,
               took[BOX4], took[BVH4], took[BIH]);
        for (int t = 0; t < TREES; t++)
            assert_true(took[BOX4] <= cases[i].most[t] * took[t]);
        sph_scene_free(&scene);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(rule), cmocka_unit_test(saves)};
    return cmocka_run_group_tests_name("choose tree", tests, NULL, NULL);
}
