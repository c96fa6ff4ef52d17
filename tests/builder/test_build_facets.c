/* test_build_facets.c - trees and effects of machines with triangles and planes
 * SPDX-License-Identifier: Apache-2.0
 *
 * build/test/test_build_facets [seed]
 */
#include "containment.h"

/* Soups with spheres and planes, large triangles too, in both trees and all profiles. */
static void test_containment(void **unused) {
    static const uint32_t sizes[] = {0, 1, 2, 3, 4, 5, 17, 100, SANITIZED ? 200 : 700};
    (void)unused;
    for (int run = 0; run < 9 * 4 * 2 * 4; run++) {
        struct sph_scene s = bare();
        struct sph_build_options o = standard;
        struct sph_build_report report;
        struct ancestors a = {0};
        uint32_t size = sizes[run % 9], planes = (uint32_t)(run / 9 % 4) + 3 * (run / 72 & 1);
        o.profile = run / 72, o.tree = run / 36 & 1 ? SPH_TREE_PAPER : SPH_TREE_BALANCED;
        soup(&s, size, run & 1 ? 0.03 : 2);
        for (uint32_t i = 0; i < planes; i++)
            add_plane(&s, at(uniform(), uniform(), uniform()), near_to(at(0, 0, 0), 1));
        for (int i = run % 3; i > 0; i--)
            add_ball(&s, at(uniform(), uniform(), uniform()), 0.1);
        struct sph_machine m = built(&s, o, &report);
        assert_int_equal(check_below(&m, 0, &a), report.facets + s.n_spheres);
        assert_in_range(report.facets - planes, size - size / 50,
                        size); /* draft: some have no area */
        assert_int_equal(report.loose, planes);
        assert_int_equal(m.regs[SPH_REG_EFFECTS] >> SPH_EFFECT_FACETS, s.n_facets > 0);
        sph_machine_free(&m);
    }
}

/* Triangles between the corners of the grid: their balls reach far out of it, nodes may not. */
static void test_corners(void **unused) {
    (void)unused;
    for (int run = 0; run < 40; run++) {
        struct sph_scene s = bare();
        struct sph_build_options o = standard;
        struct sph_build_report report;
        struct ancestors a = {0};
        s.camera = (struct sph_camera){{0.5, 0.5, 0.5}, {0.5, 0.5, 0}, {0, 1, 0}, 40,
                                       .width = 64,     .height = 48};
        s.n_lights = 0;
        o.profile = run % SPH_PROFILES, o.tree = run & 4 ? SPH_TREE_PAPER : SPH_TREE_BALANCED;
        for (int i = 0; i < 30; i++) {
            struct sph_vec v[3];
            for (int k = 0; k < 3; k++) {
                v[k] = near_to(at(uniform() < 0.5, uniform() < 0.5, uniform() < 0.5), 0.001);
                v[k] = at(fmin(fmax(v[k].x, 0), 0.9998), fmin(fmax(v[k].y, 0), 0.9998), v[k].z);
            }
            add_triangle(&s, v[0], v[1], v[2], s.n_facets);
        }
        struct sph_machine m = built(&s, o, &report);
        check_below(&m, 0, &a);
        sph_machine_free(&m);
    }
}

/* Levels of a tree with planes: one or two more than without, and never more than the stack has. */
static void test_depth(void **unused) {
    (void)unused;
    for (int planes = 0; planes <= SPH_MAX_PLANES; planes++) {
        struct sph_scene s = bare();
        s.n_lights = 0; /* which would make the grid larger */
        struct sph_build_report report;
        struct ancestors a = {0};
        for (int i = 0; i < MOST_FACETS - SPH_MAX_PLANES; i++) { /* ever smaller and closer */
            double far = pow(1e-4, (i + 1.0) / MOST_FACETS);
            add_triangle(&s, at(far, 0, 0), at(far * 1.01, far / 50, 0), at(far, 0, far / 50),
                         s.n_facets);
        }
        for (int i = 0; i < planes; i++)
            add_plane(&s, at(0, 0, 0), at(i, 1, 0));
        struct sph_build_options o = standard;
        o.profile = SPH_REFERENCE;
        struct sph_machine m = built(&s, o, &report);
        check_below(&m, 0, &a);
        assert_true(report.depth <= SPH_STACK_DEPTH);
        sph_machine_free(&m);
    }
}

/* Which effects facets call for, and the reasons. */
static void test_effects(void **unused) {
    (void)unused;
    struct sph_scene s = bare();
    struct sph_build_options o = standard;
    struct sph_build_report r;
    struct sph_machine m = built(&s, o, &r);
    assert_string_equal(r.effects[SPH_REPORT_FACETS].why, "there is no triangle and no plane");
    sph_machine_free(&m);
    add_plane(&s, at(0, 0, 0), at(0, 0, 1));
    o.background = SPH_BG_EXACT;
    m = built(&s, o, &r);
    assert_int_equal(m.regs[SPH_REG_EFFECTS],
                     1 << SPH_EFFECT_FACETS | 2); /* the material mirrors */
    assert_string_equal(r.effects[SPH_REPORT_FACETS].why,
                        "1 plane; the first is the plane cloud.nff:100");
    assert_string_equal(r.effects[SPH_REPORT_SHADOW].why,
                        "there is one polygon or plane and nothing else");
    assert_non_null(strstr(r.background, "every pixel is traced"));
    sph_machine_free(&m);
    add_triangle(&s, at(0, 0, 1), at(1, 0, 1), at(0, 1, 1), 1);
    o.max_depth = 0;
    m = built(&s, o, &r);
    assert_int_equal(m.regs[SPH_REG_EFFECTS], 1 << SPH_EFFECT_FACETS | 1);
    assert_string_equal(r.effects[SPH_REPORT_SHADOW].why,
                        "the plane cloud.nff:100 may shade or be shaded");
    sph_machine_free(&m);
    add_ball(&s, at(0.5, 0.5, 0.5), 0.25); /* near neither */
    m = built(&s, o, &r);
    assert_int_equal(r.effects[SPH_REPORT_INSIDE].on, 0);
    sph_machine_free(&m);
    s.spheres[0].rad = 0.5; /* on the plane */
    m = built(&s, o, &r);
    assert_non_null(strstr(r.effects[SPH_REPORT_INSIDE].why,
                           "the plane cloud.nff:100 comes within 5.5 grid units of the sphere "
                           "cloud.nff:10"));
    assert_int_equal(m.regs[SPH_REG_EFFECTS], 1 << SPH_EFFECT_FACETS | 5);
    sph_machine_free(&m);
    s.n_facets = 1; /* the plane and the sphere */
    m = built(&s, o, &r);
    assert_int_equal(r.effects[SPH_REPORT_SHADOW].on, 1);
    sph_machine_free(&m);
    s.n_lights = 0;
    m = built(&s, o, &r);
    assert_int_equal(r.effects[SPH_REPORT_SHADOW].on, 0);
    sph_machine_free(&m);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_containment),
                                       cmocka_unit_test(test_corners), cmocka_unit_test(test_depth),
                                       cmocka_unit_test(test_effects)};
    seed(argc, argv);
    return cmocka_run_group_tests_name("build of facets", tests, NULL, NULL);
}
