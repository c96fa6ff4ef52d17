/* test_facets_grid.c - triangles and planes on the grid: words, normals, groups, what is refused
 * SPDX-License-Identifier: Apache-2.0
 *
 * build/test/test_facets_grid [seed]
 */
#include "build_scene.h"

#include "prim/facet.h"

/* Cross products at the limits of 24 bits. */
static void test_normals(void **unused) {
    static const struct {
        int32_t u, v, want; /* e1 = (u, 0, 0), e2 = (0, v, 0) */
    } list[] = {{1, 1, 1 << 22},       {1, -1, -(1 << 22)},         {2895, 2897, 8386815},
                {4095, 4097, 1 << 22}, {-4095, 4097, -(1 << 22)},   {4095, 4096, 8386560},
                {5, 1677721, 8388605}, {1 << 23, 1 << 23, 1 << 22}, {3, 1, 3 << 21},
                {3, 2796203, 4194305}, {-3, 2796203, -4194305}};
    (void)unused;
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        int32_t v[3][3] = {{7, 5, 3}, {7, 5, 3}, {7, 5, 3}}, normal[3];
        v[1][0] += list[i].u, v[2][1] += list[i].v;
        assert_int_equal(sph_triangle_normal((const int32_t(*)[3])v, normal), 1);
        assert_true(!normal[0] && !normal[1] && normal[2] == list[i].want);
    }
}

/* The words of every facet: where its corners belong, the normal, ids, the copy in the table. */
static void test_words(void **unused) {
    (void)unused;
    for (int run = 0; run < 40; run++) {
        struct sph_scene s = bare();
        struct sph_build_options o = standard;
        struct sph_build_report report;
        o.profile = run % SPH_PROFILES;
        s.n_lights = 0;
        soup(&s, 20, exp(between(-4, 1)));
        add_plane(&s, at(0.5, 0.25, 0), near_to(at(0, 0, 0), ldexp(1, run - 20)));
        soup(&s, 5, 1);
        add_ball(&s, at(0.5, 0.5, 0.5), 0.05);
        struct sph_machine m = built(&s, o, &report);
        int w = sph_machine_profile(&m)->w;
        int32_t lo = -(1 << (w - 1)) + 4, hi = (1 << (w - 1)) - 5, low[3], high[3];
        memcpy(low, m.regs + SPH_REG_EYE_X, sizeof low);
        memcpy(high, low, sizeof high);
        assert_int_equal(m.regs[SPH_REG_N_SPHERES], 1);
        assert_int_equal(m.regs[SPH_REG_N_PRIMS], 1 + s.n_facets);
        for (uint32_t i = 0; i < s.n_facets; i++) {
            const uint32_t *line = machine_line(&m, (uint32_t)m.regs[SPH_REG_FACET_BASE] + i);
            const uint32_t *prim = machine_line(&m, (uint32_t)m.regs[SPH_REG_PRIM_BASE] + 1 + i);
            const struct sph_facet *f = &s.facets[i];
            int32_t v[3][3] = {{0}}, normal[3];
            assert_int_equal(sph_field(line, SPH_FACET_ID_LSB, SPH_FACET_ID_BITS), i + 1);
            assert_int_equal(sph_field(prim, SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS), i + 1);
            assert_int_equal(sph_field(prim, SPH_PRIM_KIND_LSB, SPH_PRIM_KIND_BITS), f->kind);
            assert_int_equal(sph_field(prim, SPH_PRIM_KR_LSB, SPH_PRIM_KR_BITS), 128);
            get_vector(prim, SPH_LEAF_CTR_X_LSB, normal);
            for (int k = 0; k < (f->kind == SPH_PLANE ? 1 : 3); k++) {
                const double *r = m.rotation;
                get_vector(line, 72 * k, v[k]);
                for (int j = 0; j < 3; j++) {
                    double want =
                        r[3 * j] * f->v[k].x + r[3 * j + 1] * f->v[k].y + r[3 * j + 2] * f->v[k].z;
                    want = (want - m.origin[j]) / report.grid_step;
                    assert_true(fabs(want - v[k][j]) <= 0.5 + 1e-6);
                    assert_in_range(v[k][j] - lo, 0, hi - lo);
                    low[j] = v[k][j] < low[j] ? v[k][j] : low[j];
                    high[j] = v[k][j] > high[j] ? v[k][j] : high[j];
                }
            }
            int64_t n[3], most = 0;
            if (f->kind == SPH_PLANE) {
                double along = 0, size = sqrt(f->v[1].x * f->v[1].x + f->v[1].y * f->v[1].y +
                                              f->v[1].z * f->v[1].z);
                double have = 0;
                get_vector(line, SPH_PLANE_N_X_LSB, v[1]);
                assert_memory_equal(v[1], normal, sizeof normal);
                for (int j = 0; j < 3; j++) {
                    const double *r = m.rotation + 3 * j;
                    along += normal[j] * (r[0] * f->v[1].x + r[1] * f->v[1].y + r[2] * f->v[1].z);
                    have += (double)normal[j] * normal[j];
                    most = llabs(normal[j]) > most ? llabs(normal[j]) : most;
                }
                assert_true(along / size / sqrt(have) > 1 - 1e-12); /* an angle below 2^-20 */
                assert_int_equal(most, (1 << 23) - 1);
                continue;
            }
            for (int j = 0; j < 3; j++) {
                int a = (j + 1) % 3, b = (j + 2) % 3;
                n[j] = ((int64_t)v[1][a] - v[0][a]) * ((int64_t)v[2][b] - v[0][b]) -
                       ((int64_t)v[1][b] - v[0][b]) * ((int64_t)v[2][a] - v[0][a]);
                most = llabs(n[j]) > most ? llabs(n[j]) : most;
            }
            int up = 0, down = 0; /* the shift that leaves 24 bits */
            while (most << up < 1ll << 22)
                up++;
            while ((double)most / (double)(1ll << down) + 0.5 >= (double)(1ll << 23))
                down++;
            for (int j = 0; j < 3; j++) {
                double want = (double)(n[j] * (1ll << up)) / (double)(1ll << down);
                assert_true(normal[j] == (int32_t)lround(want)); /* halves away from zero */
            }
        }
        int most = 0; /* the box is as large as the grid allows, and in its middle */
        for (int j = 0; j < 3; j++) {
            most = high[j] - low[j] > most ? high[j] - low[j] : most;
            assert_in_range(high[j] + low[j] + 2, 0, 4);
        }
        assert_true(most > (hi - lo) / 2 - 16);
        sph_machine_free(&m);
    }
}

static uint32_t group_of(const struct sph_machine *m, uint32_t facet, uint32_t *after) {
    const uint32_t *line = machine_line(m, (uint32_t)m->regs[SPH_REG_FACET_BASE] + facet);
    *after = sph_field(line, SPH_FACET_AFTER_LSB, SPH_FACET_AFTER_BITS);
    return sph_field(line, SPH_FACET_BEFORE_LSB, SPH_FACET_BEFORE_BITS);
}

/* Compares before of the n facets with a list; after must fit it. */
static void expect_groups(struct sph_scene *s, const uint8_t *before, uint32_t n) {
    struct sph_build_report report;
    struct sph_machine m = built(s, standard, &report);
    assert_int_equal(s->n_facets, n);
    for (uint32_t i = 0; i < n; i++) {
        uint32_t after;
        assert_int_equal(group_of(&m, i, &after), before[i]);
        uint32_t end = i + 1;
        while (end < n && before[end] == before[end - 1] + 1)
            end++;
        assert_int_equal(after, end - 1 - i);
    }
    sph_machine_free(&m);
}

static void test_groups(void **unused) {
    (void)unused;
    struct sph_scene s = bare();
    uint8_t want[400];
    s.camera = (struct sph_camera){{0, 0, 4}, {0, 0, 0},   {0, 1, 0},
                                   40,        .width = 64, .height = 48}; /* step 2^-13 */
    s.lights[0].pos = at(1, 3, 0), s.lights[1].pos = at(-3, 0, 0);
    add_triangle(&s, at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), 0); /* a polygon, bent a little */
    add_triangle(&s, at(0, 1, 0), at(1, 0, 0), at(1, 1, 0.001), 0);
    add_triangle(&s, at(0, 1, 0), at(1, 0, 0), at(2, 0, 0), 1);     /* in the plane of its first */
    add_triangle(&s, at(2, 0, 0), at(0, 1, 0), at(2, 1, 0), 2);     /* same plane, an edge: joins */
    add_triangle(&s, at(0, 0, 1), at(1, 0, 1), at(0, 1, 1), 3);     /* another plane */
    add_triangle(&s, at(0, 1, 1), at(1, 2, 1), at(0, 2, 1), 4);     /* one corner only */
    add_triangle(&s, at(0, 2, 1), at(1, 2, 1), at(0, 3, 1.001), 5); /* an edge, not flat */
    add_plane(&s, at(0, 0, 1), at(0, 0, 1));
    add_triangle(&s, at(5, 0, 1), at(6, 0, 1), at(5, 1, 1), 8);
    add_triangle(&s, at(5, 1, 1), at(6, 0, 1), at(6, 1, 1), 9); /* then a polygon in its plane */
    add_triangle(&s, at(6, 0, 1), at(6, 1, 1), at(7, 0, 1), 10);
    add_triangle(&s, at(6, 1, 1), at(7, 0, 1), at(7, 1, 1), 10);
    static const uint8_t few[] = {0, 1, 0, 1, 0, 0, 0, 0, 0, 1, 0, 1};
    expect_groups(&s, few, 12);

    s.n_facets = 0; /* a polygon of 300 triangles, then one of 2 */
    for (int i = 0; i < 300; i++)
        add_triangle(&s, at(1, 0, 0), at(cos((i + 1) * 0.02), sin((i + 1) * 0.02), 0),
                     at(cos((i + 2) * 0.02), sin((i + 2) * 0.02), 0), 0);
    add_triangle(&s, at(0, 0, 1), at(1, 0, 1), at(0, 1, 1), 1);
    add_triangle(&s, at(0, 1, 1), at(1, 0, 1), at(1, 1, 1), 1);
    for (int i = 0; i < 302; i++)
        want[i] = (uint8_t)(i < 300 ? i % SPH_MAX_GROUP : i - 300);
    expect_groups(&s, want, 302);
}

/* Triangles without area on the grid are left out with a warning; the others keep their order. */
static void test_left_out(void **unused) {
    (void)unused;
    struct sph_scene s = bare();
    s.camera = (struct sph_camera){{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 40, .width = 64, .height = 48};
    struct sph_build_report report;
    add_triangle(&s, at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), 0);
    add_triangle(&s, at(0, 0, 0), at(1e-7, 0, 0), at(0, 1, 0), 1); /* two corners in one */
    add_triangle(&s, at(0, 0, 0), at(1, 1e-7, 0), at(0.5, 0, 0), 2);
    add_triangle(&s, at(0, 0, 1), at(1, 0, 1), at(0, 1, 1), 3);
    struct sph_machine m = built(&s, standard, &report);
    assert_int_equal(report.facets, 2);
    assert_int_equal(m.regs[SPH_REG_N_PRIMS], 2);
    assert_int_equal(report.ledger.row[SPH_READ_NO_AREA_GRID].n, 2);
    assert_int_equal(report.ledger.row[SPH_READ_NO_AREA_GRID].line, 101);
    sph_machine_free(&m);
    s.facets++, s.n_facets = 2; /* nothing is left */
    m = built(&s, standard, &report);
    assert_int_equal(m.regs[SPH_REG_N_PRIMS], 0);
    assert_int_equal(m.regs[SPH_REG_EFFECTS] | m.regs[SPH_REG_N_SPHERES], 0);
    assert_int_equal(m.regs[SPH_REG_FACET_BASE], 0);
    sph_machine_free(&m);
}

/* Builds a scene that must be refused and compares the message's parts. */
static void refuse(const struct sph_scene *s, struct sph_build_options o, const char *part) {
    struct sph_build_report report;
    struct sph_machine m;
    struct sph_error err = {{0}};
    if (!sph_build(s, &o, &m, &report, &err)) fail_msg("built, not refused: '%s'", part);
    if (!strstr(err.text, part)) fail_msg("message '%s' lacks '%s'", err.text, part);
    assert_null(m.mem);
}

/* Of two triangles with the same corners in the scene the second is left out with a warning,
 * however it is turned; the polygon that it was in goes on without it. */
static void test_twice(void **unused) {
    (void)unused;
    struct sph_scene s = bare();
    s.camera = (struct sph_camera){{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 40, .width = 64, .height = 48};
    struct sph_build_report report;
    const struct sph_vec a = at(0, 0, 0), b = at(1, 0, 0), c = at(0, 1, 0), d = at(1, 1, 0);
    add_triangle(&s, a, b, c, 0);
    add_triangle(&s, c, a, b, 1);
    add_triangle(&s, b, d, c, 2);
    add_triangle(&s, c, b, a, 3);
    struct sph_machine m = built(&s, standard, &report);
    assert_int_equal(report.facets, 2);
    assert_int_equal(m.regs[SPH_REG_N_PRIMS], 2);
    assert_int_equal(report.ledger.row[SPH_READ_TRIANGLE_TWICE].n, 2);
    assert_int_equal(report.ledger.row[SPH_READ_TRIANGLE_TWICE].line, 101);
    sph_machine_free(&m);
}

static void test_refusals(void **unused) {
    (void)unused;
    struct sph_scene s = bare();
    struct sph_build_options o = standard, first = standard;
    const struct sph_vec a = at(0, 0, 0), b = at(1, 0, 0), c = at(0, 1, 0);
    first.traverse = SPH_BUILD_FIRST;
    add_triangle(&s, a, b, c, 0);
    refuse(&s, first, "cloud.nff:100: traverse first is for spheres");
    add_triangle(&s, c, a, b, 1);
    facet_list[1].v[1].z = 1e-4, o.profile = SPH_DRAFT;
    refuse(&s, o, "profile draft merges this triangle with that of line 100: profile standard sep");
    facet_list[1].v[1].z = NAN;
    refuse(&s, o, "cloud.nff:101: triangle needs finite corners");
    s.n_facets = 1;
    add_plane(&s, at(0, 0, 0), at(0, 0.5, 0.5));
    add_plane(&s, at(9, 1, -1), at(0, 1, 1));
    refuse(&s, o, "cloud.nff:102: the same plane as in line 101");
    facet_list[2].v[0].z += 0.01; /* 28 units off */
    struct sph_build_report report;
    o.profile = SPH_STANDARD;
    struct sph_machine m = built(&s, o, &report);
    sph_machine_free(&m);
    facet_list[2].v[0].z = 1.5, facet_list[2].v[1].x = INFINITY;
    refuse(&s, o, "cloud.nff:102: plane needs a finite point and normal");
    facet_list[2].v[1] = at(0, 0, 0);
    refuse(&s, o, "cloud.nff:102: plane needs a finite point and normal");
    facet_list[2].v[1] = at(1, 0, 0);
    add_plane(&s, at(0, 0, 0), at(0, 1, 0));
    add_plane(&s, at(0, 0, 0), at(0, 0, 1));
    add_plane(&s, at(0, 0, 0), at(0, 1, 2));
    add_plane(&s, at(0, 0, 0), at(2, 0, 1));
    add_plane(&s, at(0, 0, 0), at(1, 2, 3));
    refuse(&s, o, "cloud.nff:107: more than 6 planes");
    s.n_facets = 4;
    facet_list[3].material = 1;
    refuse(&s, o, "cloud.nff:103: triangle or plane without material");
    facet_list[3].kind = 3;
    refuse(&s, o, "cloud.nff:103: there is no facet of kind");
    s.n_facets = SPH_MAX_FACETS + 1;
    refuse(&s, o, "1048577 triangles and planes; at most 16777215, of them 1048576");
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_normals), cmocka_unit_test(test_words),
        cmocka_unit_test(test_groups),  cmocka_unit_test(test_left_out),
        cmocka_unit_test(test_twice),   cmocka_unit_test(test_refusals)};
    seed(argc, argv);
    return cmocka_run_group_tests_name("facets on the grid", tests, NULL, NULL);
}
