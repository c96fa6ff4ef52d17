/* test_build.c - what build promises of a machine, checked in exact integers
 * SPDX-License-Identifier: Apache-2.0
 *
 * build/test/test_build [seed] [timing]: with `timing` also builds 10^5 and 10^6 spheres.
 */
#include "build_scene.h"

#include <math.h>
#include <string.h>

#include "builder/emit.h"
#include "builder/tree/tree.h"
#include "validate/describe.h"

static const int trees[] = {SPH_TREE_PAPER, SPH_TREE_BALANCED, SPH_TREE_REINSERTED, SPH_TREE_HW};

static int32_t child_field(const uint32_t *line, int child, int lsb, int width) {
    return sph_field_signed(line, child * SPH_CHILD_STRIDE + lsb, width);
}

struct ancestors {
    int n;
    struct sph_ball ball[SPH_STACK_DEPTH + 1]; /* filter units, without margin */
};

/* Checks that every leaf below `line` lies in all spheres above it; counts leaves. */
static uint32_t check_below(const struct sph_machine *m, uint32_t line, struct ancestors *a) {
    const struct sph_profile *p = sph_machine_profile(m);
    const uint32_t *node = m->mem + (size_t)line * SPH_LINE_WORDS;
    uint32_t base = sph_field(node, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS), leaves = 0;
    int n_inner = (int)sph_field(node, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS);
    int n_leaf = (int)sph_field(node, SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS);
    assert_true(n_inner + n_leaf <= 4);
    for (int i = 0; i < 4; i++) {
        struct sph_ball *ball = &a->ball[a->n];
        ball->c[0] = child_field(node, i, SPH_CHILD_CTR_X_LSB, SPH_CHILD_CTR_X_BITS);
        ball->c[1] = child_field(node, i, SPH_CHILD_CTR_Y_LSB, SPH_CHILD_CTR_Y_BITS);
        ball->c[2] = child_field(node, i, SPH_CHILD_CTR_Z_LSB, SPH_CHILD_CTR_Z_BITS);
        ball->r =
            (int32_t)sph_field(node, i * SPH_CHILD_STRIDE + SPH_CHILD_RAD_LSB, SPH_CHILD_RAD_BITS);
        if (i >= n_inner + n_leaf) { /* an unused slot is zero */
            assert_true(!ball->c[0] && !ball->c[1] && !ball->c[2] && !ball->r);
            continue;
        }
        ball->r -= SPH_FILTER_MARGIN;
        for (int j = 0; j < 3; j++)
            assert_true(ball->c[j] >= -(1 << (p->fw - 1)) && ball->c[j] < 1 << (p->fw - 1));
        a->n++;
        if (i < n_inner) {
            leaves += check_below(m, base + (uint32_t)i, a);
        } else {
            int j = i - n_inner;
            const uint32_t *leaf = m->mem + (base + (uint32_t)(n_inner + j / 2)) * SPH_LINE_WORDS +
                                   (j & 1) * SPH_LEAF_STRIDE / 32;
            int64_t rad = sph_field(leaf, SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS);
            for (int up = 0; up < a->n; up++) {
                int64_t sum = 0, k = 1ll << (p->w - p->fw), room = a->ball[up].r * k - rad;
                for (int axis = 0; axis < 3; axis++) {
                    int64_t d = a->ball[up].c[axis] * k -
                                sph_field_signed(leaf, SPH_LEAF_CTR_X_LSB + 24 * axis, 24);
                    sum += d * d;
                }
                assert_true(room >= 0 && room * room >= sum);
            }
            leaves++;
        }
        a->n--;
    }
    return leaves;
}

static void test_containment(void **unused) {
    static const uint32_t sizes[] = {0, 1, 2, 3, 4, 5, 16, 17, 100, 777};
    (void)unused;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
        for (int profile = 0; profile < SPH_PROFILES; profile++)
            for (int kind = 0; kind < 3; kind++) {
                int tree = trees[kind];
                struct sph_scene s = cloud(sizes[i], i & 1 ? 0.1 : 0.03);
                struct sph_build_options o = standard;
                struct sph_build_report report;
                struct ancestors a = {0};
                o.profile = profile, o.tree = tree;
                struct sph_machine m = built(&s, o, &report);
                assert_int_equal(check_below(&m, 0, &a), sizes[i]); /* and valid: each once */
                assert_true(report.depth <= SPH_STACK_DEPTH);
                if (tree == SPH_TREE_PAPER && sizes[i] > 1) {
                    uint32_t depth = (uint32_t)ceil(log2(sizes[i]) / 2 - 1e-12);
                    assert_int_equal(report.depth, depth);
                }
                sph_machine_free(&m);
                free(s.spheres);
            }
}

/* Spheres ever smaller and closer drive split trees deep; the stack must hold them all. */
static void test_depth(void **unused) {
    enum { N = SANITIZED ? 500 : 4000 };
    static struct sph_ball balls[N];
    const int32_t eye[3] = {0};
    (void)unused;
    for (uint32_t n = 30; n <= N; n += n / 3) {
        struct sph_tree tree = {0};
        for (uint32_t i = 0; i < n; i++) {
            double at = pow(1e-6, (i + 1.0) / n);
            balls[i] = (struct sph_ball){{(int32_t)(at * 8e6) - 4000000, 0, 0}, 1};
            balls[i].r += (int32_t)(at * 1e5);
        }
        const struct sph_profile *p = &sph_profiles[SPH_REFERENCE];
        for (int kind = 1; kind < 3; kind++) {
            assert_int_equal(sph_tree_balanced(balls, NULL, n, p, eye, trees[kind], &tree, NULL),
                             0);
            assert_true(tree.depth <= SPH_STACK_DEPTH);
            free(tree.nodes);
        }
    }
}

static void test_grid(void **unused) {
    (void)unused;
    for (int run = 0; run < 40; run++) {
        double scale = ldexp(between(1, 2), (int)between(-30, 30));
        struct sph_scene s = cloud(20, 0.2);
        struct sph_build_options o = standard;
        struct sph_build_report report;
        struct sph_vec *points[] = {&s.camera.from, &s.camera.at, &s.lights[0].pos,
                                    &s.lights[1].pos};
        for (int i = 0; i < 4; i++)
            points[i]->x *= scale, points[i]->y *= scale, points[i]->z *= scale;
        for (uint32_t i = 0; i < s.n_spheres; i++) {
            struct sph_sphere *b = &s.spheres[i];
            b->ctr.x *= scale, b->ctr.y *= scale, b->ctr.z *= scale, b->rad *= scale;
        }
        o.profile = run % SPH_PROFILES;
        struct sph_machine m = built(&s, o, &report);
        int w = sph_machine_profile(&m)->w;
        int64_t lo = -(1ll << (w - 1)) + 4, hi = (1ll << (w - 1)) - 5, low = hi, high = lo;
        for (uint32_t i = 0; i < s.n_spheres; i++) {
            const uint32_t *prim =
                m.mem + ((uint32_t)m.regs[SPH_REG_PRIM_BASE] + i) * SPH_LINE_WORDS;
            int64_t rad = sph_field(prim, SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS);
            const double *r = m.rotation;
            const struct sph_vec *p = &s.spheres[i].ctr;
            for (int axis = 0; axis < 3; axis++) {
                int64_t c = sph_field_signed(prim, SPH_LEAF_CTR_X_LSB + 24 * axis, 24);
                double want = r[3 * axis] * p->x + r[3 * axis + 1] * p->y + r[3 * axis + 2] * p->z;
                want = (want - m.origin[axis]) / report.grid_step;
                assert_true(fabs(want - (double)c) <= 0.5 + 1e-6);
                assert_true(c - rad >= lo && c + rad <= hi);
                if (c - rad < low) low = c - rad;
                if (c + rad > high) high = c + rad;
            }
        }
        for (int i = 0; i < 3; i++) /* eye and lights stretch the box too */
            for (int l = -1; l < 2; l++) {
                int64_t c = m.regs[l < 0 ? SPH_REG_EYE_X + i : SPH_REG_LIGHT0_X + 8 * l + i];
                assert_true(c >= lo && c <= hi);
                if (c < low) low = c;
                if (c > high) high = c;
            }
        assert_true(high - low > (hi - lo) / 2 - 16); /* half the step would not fit */
        sph_machine_free(&m);
        free(s.spheres);
    }
}

/* Builds a scene that must be refused and compares the message's parts. */
static void refuse(const struct sph_scene *s, int profile, const char *part, const char *part2) {
    struct sph_build_options o = standard;
    struct sph_build_report report;
    struct sph_machine m;
    struct sph_error err = {{0}};
    o.profile = profile;
    assert_int_equal(sph_build(s, &o, &m, &report, &err), -1);
    if (!strstr(err.text, part) || !strstr(err.text, part2))
        fail_msg("message '%s' lacks '%s' or '%s'", err.text, part, part2);
    assert_null(m.mem);
}

static void test_refusals(void **unused) {
    (void)unused;
    struct sph_scene s = cloud(20, 0.1);
    s.spheres[5].rad = 1e-4;
    refuse(&s, SPH_DRAFT, "cloud.nff:15: radius 0.0001", "profile standard would do");
    s.spheres[5] = s.spheres[3], s.spheres[5].line = 15;
    s.spheres[5].ctr.x += 1e-6;
    refuse(&s, SPH_DRAFT, "cloud.nff:15:", "merges this sphere with that of line 13: profile ");
    s.spheres[5].rad = -1;
    refuse(&s, SPH_DRAFT, "cloud.nff:15:", "radius above zero");
    s.spheres[5].rad = NAN;
    refuse(&s, SPH_DRAFT, "cloud.nff:15:", "finite");
    s.spheres[5].rad = 0.1;
    s.camera.width = 9000;
    refuse(&s, SPH_DRAFT, "cloud.nff: profile draft", "fewer pixels; profile standard would do");
    s.camera.angle = 1e-5;
    refuse(&s, SPH_FINE, "cloud.nff: profile fine", "; no finer profile would do");
    refuse(&s, SPH_REFERENCE, "profile reference: a raster", "fewer pixels; no finer profile");
    s.camera.angle = 40;
    s.camera.width = 64, s.camera.up = (struct sph_vec){3, 5, 2};
    s.camera.at = (struct sph_vec){-1, -2, -0.5};
    refuse(&s, SPH_DRAFT, "cloud.nff", "up is parallel");
    s.camera.at = s.camera.from;
    refuse(&s, SPH_DRAFT, "cloud.nff", "same point");
    free(s.spheres);
}

/* Spheres that no grid holds or tells apart are left out, and all others keep their numbers. */
static void test_lost(void **unused) {
    (void)unused;
    struct sph_scene s = cloud(20, 0.1);
    struct sph_build_options o = standard;
    struct sph_build_report report;
    struct sph_error err = {{0}};
    struct sph_machine m;
    uint32_t numbers[20];
    s.spheres[5].rad = 1e-9;
    s.spheres[9] = s.spheres[3], s.spheres[9].line = 19;
    o.numbers = numbers;
    assert_int_equal(sph_build(&s, &o, &m, &report, &err), 0);
    assert_int_equal(m.regs[SPH_REG_N_PRIMS], 18);
    for (uint32_t id = 0; id < 18; id++)
        assert_int_equal(numbers[id], id + (id >= 5) + (id >= 8));
    assert_int_equal(report.ledger.row[SPH_READ_SPHERE_SMALL].n, 1);
    assert_int_equal(report.ledger.row[SPH_READ_SPHERE_SMALL].line, 15);
    assert_int_equal(report.ledger.row[SPH_READ_SPHERE_GRID].line, 19);
    sph_machine_free(&m);
    s.ledger.strict = 1;
    assert_int_equal(sph_build(&s, &o, &m, &report, &err), -1);
    assert_non_null(strstr(err.text, "cloud.nff:15: left out: sphere too small"));
    free(s.spheres);
}

/* A node too large for its field: no tree of ours has one, so one is made by hand. */
static void test_radius(void **unused) {
    (void)unused;
    struct sph_scene s = cloud(0, 0.1);
    const struct sph_facets none = {0};
    int most = (1 << SPH_CHILD_RAD_BITS) - 1 - SPH_FILTER_MARGIN;
    for (int over = 0; over < 2; over++) {
        struct sph_tree_node nodes[2] = {{.n_inner = 1, .child = {1}},
                                         {.ball = {.r = most + over}}};
        struct sph_tree tree = {.nodes = nodes, .n_nodes = 2, .depth = 2};
        struct sph_plants plants = {.facets = &none, .kind = SPH_TREE_BALANCED};
        struct sph_machine m = {.regs = {0}};
        struct sph_error err = {{0}};
        assert_int_equal(sph_emit_memory(&s, &plants, &tree, &m, &err), -over);
        assert_int_equal(strstr(err.text, "node 1: a radius of 16382 ") != NULL, over);
        sph_machine_free(&m);
    }
    free(s.spheres);
}

static void test_effects(void **unused) {
    (void)unused;
    struct sph_scene s = cloud(2, 0.1);
    struct sph_build_options o = standard;
    struct sph_build_report report;
    s.spheres[0].ctr = (struct sph_vec){0.5, 0.5, 0.5};
    s.spheres[1].ctr = (struct sph_vec){0.9, 0.1, 0.9}; /* towards the first light */
    struct sph_machine m = built(&s, o, &report);
    assert_int_equal(m.regs[SPH_REG_EFFECTS], 3);
    assert_int_equal(m.regs[SPH_REG_MAX_DEPTH], 2);
    assert_int_equal(m.regs[SPH_REG_LIGHT0_B], 65535); /* 2.5 is too bright */
    assert_true(report.ledger.row[SPH_READ_LIGHT_LIMITED].n > 0);
    assert_non_null(strstr(report.effects[SPH_REPORT_REFLECT].why, "cloud.nff:7 mirrors 128/256"));
    assert_string_equal(
        report.effects[SPH_REPORT_SHADOW].why,
        "the sphere cloud.nff:11 may shade cloud.nff:10 from the light cloud.nff:3");
    const uint32_t *prim = m.mem + m.regs[SPH_REG_PRIM_BASE] * SPH_LINE_WORDS;
    assert_int_equal(sph_field(prim, SPH_PRIM_RED_LSB, 8), 204); /* kd/(1-ks) = 1 */
    assert_int_equal(sph_field(prim, SPH_PRIM_KR_LSB, 9), 128);
    sph_machine_free(&m);
    o.max_depth = 0, o.shadow = 0;
    m = built(&s, o, &report);
    assert_int_equal(m.regs[SPH_REG_EFFECTS] | m.regs[SPH_REG_MAX_DEPTH], 0);
    sph_machine_free(&m);
    o.shadow = -1, s.n_spheres = 1;
    m = built(&s, o, &report);
    assert_int_equal(m.regs[SPH_REG_EFFECTS], 0);
    sph_machine_free(&m);
    s.spheres[0].rad = 4; /* the eye is inside, the lights are not */
    m = built(&s, o, &report);
    assert_int_equal(m.regs[SPH_REG_EFFECTS], 1 << SPH_EFFECT_INSIDE | 1);
    assert_int_equal(m.regs[SPH_REG_RECT_X1], 64);
    sph_machine_free(&m);
    free(s.spheres);
}

/* Prints how long large scenes take; asserts nothing. */
static void time_large(void) {
    static const uint32_t sizes[] = {100000, 1000000};
    for (int i = 0; i < 2; i++)
        for (int kind = 0; kind < 3; kind++) {
            struct sph_scene s = cloud(sizes[i], 0.3 / cbrt(sizes[i]));
            struct sph_build_options o = standard;
            struct sph_build_report r;
            struct sph_machine m;
            struct sph_error err = {{0}};
            o.profile = SPH_FINE, o.tree = trees[kind];
            if (sph_build(&s, &o, &m, &r, &err)) {
                printf("# %s\n", err.text);
            } else {
                printf("# %u spheres, %s: %.2f s, %u nodes, depth %u\n", sizes[i],
                       sph_machine_tree_name(&m), r.build_seconds, r.nodes, r.depth);
                sph_machine_free(&m);
            }
            free(s.spheres);
        }
}

/* What a record has of a colour, what no ray exceeds, and as many lines as have no numbers. */
static void test_numbers(void **unused) {
    (void)unused;
    struct sph_scene s = cloud(20, 0.1);
    struct sph_build_report report;
    struct sph_error err = {{0}};
    struct sph_machine none = {0};
    struct sph_material own = {{0.5, 1, 0.001}, 1, 0, 10, 0, 1, 7, {0}, 0};
    s.materials = &own;
    struct sph_machine m = built(&s, standard, &report);
    const uint32_t *prim = sph_line(&m, (uint64_t)m.regs[SPH_REG_PRIM_BASE]);
    assert_int_equal(sph_field(prim, SPH_PRIM_RED_LSB, SPH_PRIM_RED_BITS), 128);
    assert_int_equal(sph_field(prim, SPH_PRIM_GREEN_LSB, SPH_PRIM_GREEN_BITS), 255);
    assert_int_equal(sph_field(prim, SPH_PRIM_BLUE_LSB, SPH_PRIM_BLUE_BITS), 0);
    assert_int_equal(m.regs[SPH_REG_VISIT_LIMIT], (int)report.nodes + 1);
    assert_int_equal(sph_emit_alloc(&none, 1ull << SPH_NODE_BASE_BITS, &err), -1);
    sph_machine_free(&m);
    free(s.spheres);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_containment), cmocka_unit_test(test_depth),
        cmocka_unit_test(test_grid),        cmocka_unit_test(test_refusals),
        cmocka_unit_test(test_lost),        cmocka_unit_test(test_effects),
        cmocka_unit_test(test_radius),      cmocka_unit_test(test_numbers),
    };
    seed(argc, argv);
    if (argc > 2 && !strcmp(argv[2], "timing")) time_large();
    return cmocka_run_group_tests_name("build", tests, NULL, NULL);
}
