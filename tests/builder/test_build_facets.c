/* test_build_facets.c - trees and effects of machines with triangles and planes
 * SPDX-License-Identifier: Apache-2.0
 *
 * build/test/test_build_facets [seed]
 */
#include "facets_scene.h"

/* Every corner of every leaf lies in all balls above it; counts leaves. */
struct ancestors {
    int n;
    struct sph_ball ball[SPH_STACK_DEPTH + 1];
};

static void check_point(const struct sph_machine *m, const struct ancestors *a, const int32_t p[3],
                        int64_t rad) {
    const struct sph_profile *prof = sph_machine_profile(m);
    int64_t k = 1ll << (prof->w - prof->fw);
    for (int up = 0; up < a->n; up++) {
        int64_t room = a->ball[up].r * k - rad, sum = 0;
        for (int i = 0; i < 3; i++)
            sum += (a->ball[up].c[i] * k - p[i]) * (a->ball[up].c[i] * k - p[i]);
        assert_true(room >= 0 && room * room >= sum);
    }
}

static void check_leaf(const struct sph_machine *m, uint32_t line, const struct ancestors *a) {
    const uint32_t *leaf = machine_line(m, line);
    const struct sph_ball *ball = &a->ball[a->n - 1];
    int64_t half = 1ll << (sph_machine_profile(m)->fw - 1);
    int32_t v[3];
    switch (sph_field(leaf, SPH_FACET_KIND_LSB, SPH_FACET_KIND_BITS)) {
    case 0:
        get_vector(leaf, SPH_LEAF_CTR_X_LSB, v);
        check_point(m, a, v, sph_field(leaf, SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS));
        break;
    case SPH_TRIANGLE:
        for (int k = 0; k < 3; k++) {
            get_vector(leaf, SPH_TRIANGLE_V0_X_LSB + 72 * k, v);
            check_point(m, a, v, 0);
        }
        break;
    default:                         /* the whole grid */
        assert_in_range(a->n, 1, 2); /* of the first six */
        assert_true(!ball->c[0] && !ball->c[1] && !ball->c[2]);
        assert_true((int64_t)ball->r * ball->r >= 3 * half * half);
    }
}

static uint32_t check_below(const struct sph_machine *m, uint32_t line, struct ancestors *a) {
    const uint32_t *node = machine_line(m, line);
    uint32_t base = sph_field(node, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS), leaves = 0;
    uint32_t n_inner = sph_field(node, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS);
    uint32_t n_leaf = sph_field(node, SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS);
    assert_true(a->n < SPH_STACK_DEPTH);
    for (uint32_t i = 0; i < n_inner + n_leaf; i++) {
        struct sph_ball *ball = &a->ball[a->n++];
        int lsb = (int)i * SPH_CHILD_STRIDE;
        for (int k = 0; k < 3; k++)
            ball->c[k] =
                sph_field_signed(node, lsb + SPH_CHILD_CTR_Y_LSB * k, SPH_CHILD_CTR_X_BITS);
        ball->r = (int32_t)sph_field(node, lsb + SPH_CHILD_RAD_LSB, SPH_CHILD_RAD_BITS);
        ball->r -= SPH_FILTER_MARGIN;
        if (i < n_inner)
            leaves += check_below(m, base + i, a);
        else
            check_leaf(m, base + i, a), leaves++;
        a->n--;
    }
    return leaves;
}

/* Soups with spheres and planes, large triangles too, in both trees and all profiles. */
static void test_containment(void **unused) {
    static const uint32_t sizes[] = {0, 1, 2, 3, 4, 5, 17, 100, 700};
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
        s.camera = (struct sph_camera){{0.5, 0.5, 0.5}, {0.5, 0.5, 0}, {0, 1, 0}, 40, 0, 64, 48};
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
        assert_true(report.depth - 1 <= SPH_STACK_DEPTH);
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
