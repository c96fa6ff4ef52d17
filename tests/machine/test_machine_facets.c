/* test_machine_facets.c - machines with triangles and planes: every wrong field is refused by name
 * SPDX-License-Identifier: Apache-2.0
 *
 * build/test/test_machine_facets [seed]
 */
#include "build_scene.h"

#include <unistd.h>

#include "validate/prims.h"
#include "prim/facet.h"
#include "trace/leaf_unit.h"
#include "trace/setup.h"
#include "validate/validate.h"

static char path[64];

/* One sphere, triangles 1..4, of which 3 and 4 are a polygon, and the plane 5. */
static struct sph_machine example(void) {
    struct sph_scene s = bare();
    struct sph_build_options o = standard;
    struct sph_build_report report;
    o.background = SPH_BG_SPANS;
    add_ball(&s, at(0, 0, 0), 0.5);
    soup(&s, 2, 1);
    add_triangle(&s, at(0, 0, 1), at(1, 0, 1), at(0, 1, 1), 2);
    add_triangle(&s, at(0, 1, 1), at(1, 0, 1), at(1, 1, 1), 2);
    add_plane(&s, at(0, 0, -1), at(0.1, 0.2, 1));
    return built(&s, o, &report);
}

/* A machine with a wrong value but a right checksum: written, then read, which must refuse. */
static void wrong(struct sph_machine *m, const char *part) {
    struct sph_machine again;
    struct sph_error err = {{0}};
    assert_int_equal(sph_machine_write(m, path, NULL), 0);
    if (!sph_machine_read(path, &again, &err)) fail_msg("read, not refused: '%s'", part);
    if (!strstr(err.text, part)) fail_msg("message '%s' lacks '%s'", err.text, part);
    assert_null(again.mem);
}

static uint32_t *line_of(struct sph_machine *m, int reg, uint32_t i) {
    return m->mem + ((size_t)m->regs[reg] + i) * SPH_LINE_WORDS;
}

/* Tries a value in a field of a line and puts the line back. */
static void field(struct sph_machine *m, uint32_t *line, int lsb, int width, int64_t value,
                  const char *part) {
    uint32_t before[SPH_LINE_WORDS];
    memcpy(before, line, sizeof before);
    sph_field_set(line, lsb, width, (uint32_t)value);
    assert_memory_not_equal(before, line, sizeof before);
    wrong(m, part);
    memcpy(line, before, sizeof before);
}

#define FACET(name) SPH_FACET_##name##_LSB, SPH_FACET_##name##_BITS

static void test_table(void **unused) {
    (void)unused;
    struct sph_machine m = example();
    uint32_t *first = line_of(&m, SPH_REG_FACET_BASE, 0), *plane = first + 4 * SPH_LINE_WORDS;
    struct sph_counts n = sph_machine_count(&m);
    assert_true(n.of[SPH_SPHERE] == 1 && n.of[SPH_TRIANGLE] == 4 && n.of[SPH_PLANE] == 1);
    assert_int_equal(n.loose, 1);
    field(&m, first, FACET(KIND), 0, "facet of kind 0");
    field(&m, first, FACET(KIND), 3, "facet of kind 3");
    field(&m, first, FACET(ID), 2, "not the facet 1");
    field(&m, first, FACET(BEFORE), 1, "the polygon of facet 1 is 0..1, facets are 1..5");
    field(&m, first, FACET(AFTER), 5, "the polygon of facet 1 is 1..6, facets are 1..5");
    field(&m, first + 3 * SPH_LINE_WORDS, FACET(BEFORE), 4, "the polygon of facet 4 is 0..4");
    field(&m, first, SPH_FACET_KIND_LSB - 1, 1, 1, "a bit of the triangle that must be 0 is not");
    for (int i = 0; i < 9; i++) {
        field(&m, first, 24 * i, 24, 1 << 15, "of the triangle is not on the grid");
        field(&m, first, 24 * i, 24, -(1 << 15) - 1, "of the triangle is not on the grid");
    }
    for (int i = 0; i < 3; i++)
        field(&m, plane, 24 * i, 24, 1 << 15, "the point of the plane is not on the grid"),
            field(&m, plane, 24 * i, 24, -(1 << 15) - 1, "the point of the plane is not on");
    for (int bit = SPH_PLANE_N_Z_LSB + SPH_PLANE_N_Z_BITS; bit < SPH_FACET_ID_LSB; bit++)
        field(&m, plane, bit, 1, 1, "bits of the plane that must be 0 are not");
    field(&m, plane, SPH_PLANE_N_X_LSB, 24, -(1 << 23), "cannot be turned");
    uint32_t save[SPH_LINE_WORDS];
    memcpy(save, plane, sizeof save);
    for (int i = 0; i < 3; i++)
        sph_field_set(plane, SPH_PLANE_N_X_LSB + 24 * i, 24, 0);
    wrong(&m, "the normal of the plane is zero");
    memcpy(plane, save, sizeof save);
    memcpy(save, first, sizeof save); /* a triangle that is a line */
    for (int i = 0; i < 9; i++)
        sph_field_set(first, 24 * i, 24, (uint32_t)(i / 3 * (5 + i % 3)));
    wrong(&m, "the triangle has no area");
    memcpy(first, save, sizeof save);
    sph_machine_free(&m);
}

/* A plane's own part: every bit that must be 0, and points at the ends of the grid. */
static void test_plane(void **unused) {
    (void)unused;
    struct sph_machine m = example();
    const struct sph_prim *kind = sph_prim_of(SPH_PLANE);
    uint32_t *prim = line_of(&m, SPH_REG_PRIM_BASE, 5);
    uint32_t *plane = line_of(&m, SPH_REG_FACET_BASE, 4), save[SPH_LINE_WORDS];
    memcpy(save, plane, sizeof save);
    for (int bit = 0; bit < SPH_FACET_KIND_LSB; bit++) {
        struct sph_error err = {{0}};
        int zero = bit >= SPH_PLANE_N_Z_LSB + SPH_PLANE_N_Z_BITS && bit != SPH_FACET_CLEAR_LSB &&
                   (bit < SPH_FACET_ID_LSB || bit >= SPH_FACET_BEFORE_LSB);
        plane[bit / 32] |= 1u << bit % 32;
        int bad = kind->validate(&m, 0, plane, 5, prim, &err);
        assert_int_equal(zero, bad && strstr(err.text, "bits of the plane that must be 0") != NULL);
        memcpy(plane, save, sizeof save);
    }
    for (int i = 0; i < 3; i++) { /* normals along the axes are good ones */
        struct sph_error err = {{0}};
        for (int k = 0; k < 3; k++) {
            sph_field_set(plane, SPH_PLANE_N_X_LSB + 24 * k, 24, k == i ? 7 : 0);
            sph_field_set(prim, SPH_LEAF_CTR_X_LSB + 24 * k, 24, k == i ? 7 : 0);
        }
        assert_int_equal(kind->validate(&m, 0, plane, 5, prim, &err), 0);
    }
    memcpy(plane, save, sizeof save);
    for (int k = 0; k < 3; k++) /* the record's copy of the normal, as it was */
        sph_field_set(prim, SPH_LEAF_CTR_X_LSB + 24 * k, 24,
                      sph_field(plane, SPH_PLANE_N_X_LSB + 24 * k, 24));
    for (int i = 0; i < 3; i++)
        for (int end = -1; end <= 1; end += 2)
            for (int out = 0; out < 2; out++) {
                int32_t at = (end < 0 ? -(1 << 15) : (1 << 15) - 1) + out * end;
                struct sph_error err = {{0}};
                sph_field_set(plane, SPH_PLANE_P_X_LSB + 24 * i, 24, (uint32_t)at);
                assert_int_equal(kind->validate(&m, 0, plane, 5, prim, &err), -out);
                memcpy(plane, save, sizeof save);
            }
    sph_machine_free(&m);
}

/* A triangle has the three corners of its record: with any of them elsewhere a ray misses it. */
static void test_corners(void **unused) {
    static const int32_t away[3][2] = {{5000, -100}, {-5000, -100}, {0, -5000}};
    (void)unused;
    struct sph_machine m = example();
    struct sph_ray ray = {.skip = {SPH_ID_NONE, 0}, .dir = {1000, 0, 0}, .inside = 1};
    sph_ray_setup(sph_machine_profile(&m), &ray);
    for (int moved = -1; moved < 3; moved++) {
        int32_t v[3][3] = {{100, -100, -100}, {100, 100, -100}, {100, 0, 100}};
        uint32_t line[SPH_LINE_WORDS] = {0}, errors = 0;
        struct sph_counters c = {{0}};
        struct sph_ray_query query = sph_ray_query_of(&m, &ray, &c, &errors);
        for (int i = 0; i < 2 && moved >= 0; i++)
            v[moved][i + 1] = away[moved][i];
        for (int i = 0; i < 9; i++)
            sph_field_set(line, 24 * i, 24, (uint32_t)v[i / 3][i % 3]);
        sph_field_set(line, FACET(KIND), SPH_TRIANGLE);
        sph_leaf_visit(&query, line);
        assert_int_equal(query.best.key, moved < 0 ? 100 * 1000 : 0);
    }
    sph_machine_free(&m);
}

/* The normal of a triangle is the cross product as it is, if that just fills its bits; one bit more
 * is rounded, halves away from 0, and what that makes too long is halved again. */
static void test_normal(void **unused) {
    static const struct {
        int32_t a, b, normal;
    } cases[] = {{1 << 11, (1 << 12) - 1, ((1 << 12) - 1) << 11},
                 {2895, 2897, 2895 * 2897},
                 {2047, 4097, 2047 * 4097},
                 {4095, 4097, 1 << 22},
                 {3001, 3001, (3001 * 3001 + 1) / 2},
                 {-3001, 3001, -4503001},
                 {1, 3, 3 << 21}};
    (void)unused;
    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        const int32_t v[3][3] = {{0}, {cases[n].a, 0, 0}, {0, cases[n].b, 0}};
        int32_t normal[3];
        assert_int_equal(sph_triangle_normal(v, normal), 1);
        assert_int_equal(normal[2], cases[n].normal);
        assert_true(!normal[0] && !normal[1]);
    }
}

/* Kinds beyond the two bits: each number has one pattern, and is told. */
static void test_kinds(void **unused) {
    (void)unused;
    struct sph_machine m = example();
    uint32_t *first = line_of(&m, SPH_REG_FACET_BASE, 0), save[SPH_LINE_WORDS];
    memcpy(save, first, sizeof save);
    for (uint32_t kind = 0; kind < 3 + (1 << SPH_FACET_MORE_BITS); kind++) {
        char message[64];
        memcpy(first, save, sizeof save);
        sph_field_set(first, FACET(KIND), kind < 3 ? kind : 3);
        if (kind >= 3) sph_field_set(first, FACET(MORE), kind - 3);
        assert_int_equal(sph_record_kind(1, first), kind);
        if (kind == SPH_TRIANGLE || kind == SPH_PLANE) continue;
        snprintf(message, sizeof message, "facet of kind %u", kind);
        wrong(&m, message);
    }
    sph_machine_free(&m);
}

/* A leaf line of a kind that there is not is a miss and an error. */
static void test_no_kind(void **unused) {
    (void)unused;
    struct sph_machine m = example();
    struct sph_ray ray = {.kind = SPH_SHADOW, .skip = {SPH_ID_NONE, 0}, .inside = 1};
    for (uint32_t kind = 0; kind < 3 + (1 << SPH_FACET_MORE_BITS); kind++) {
        uint32_t line[SPH_LINE_WORDS] = {0}, errors = 0;
        struct sph_counters c = {{0}};
        struct sph_ray_query query = sph_ray_query_of(&m, &ray, &c, &errors);
        sph_field_set(line, FACET(KIND), kind < 3 ? kind : 3);
        if (kind >= 3) sph_field_set(line, FACET(MORE), kind - 3);
        sph_leaf_visit(&query, line);
        assert_int_equal(errors, kind < SPH_KINDS ? 0 : 1 << SPH_ERROR_BAD_NODE);
        assert_int_equal(query.best.key, 0);
        assert_int_equal(c.count[SPH_COUNT_LEAF_TESTS], kind == SPH_SPHERE);
        assert_int_equal(c.count[SPH_COUNT_FACET_TESTS], kind == SPH_TRIANGLE || kind == SPH_PLANE);
    }
    sph_machine_free(&m);
}

static void test_records(void **unused) {
    (void)unused;
    struct sph_machine m = example();
    uint32_t *sphere = line_of(&m, SPH_REG_PRIM_BASE, 0), *facet = sphere + SPH_LINE_WORDS;
    field(&m, sphere, SPH_PRIM_KIND_LSB, 8, SPH_TRIANGLE, "primitive 0: not marked as a sphere");
    field(&m, sphere, SPH_PRIM_KIND_LSB, 7, 64, "primitive 0: not marked");
    field(&m, sphere, SPH_LEAF_CLEAR_LSB, 1, 1, "leaf 0 differs from its primitive record");
    field(&m, facet, SPH_PRIM_KIND_LSB, 8, SPH_SPHERE, "primitive 1: not marked as a facet");
    field(&m, facet, SPH_PRIM_KIND_LSB, 8, SPH_KINDS, "primitive 1: not marked as a facet");
    field(&m, facet, SPH_PRIM_KIND_LSB, 8, SPH_PLANE,
          "primitive 1: of kind 2, its leaf line is of");
    field(&m, facet, SPH_LEAF_RAD_LSB, 24, 1, "primitive 1: a facet with a radius");
    field(&m, facet, SPH_LEAF_ID_LSB, 24, 0, "primitive 1: another id");
    for (int i = 0; i < 3; i++) {
        int32_t normal = sph_field_signed(facet, 24 * i, 24);
        field(&m, facet, 24 * i, 24, normal + 1, "primitive 1: the normal is not that of its");
        field(&m, facet + 4 * SPH_LINE_WORDS, 24 * i, 24, 0, "primitive 5: the normal is not");
    }
    sph_machine_free(&m);
}

/* Flips every bit of every leaf line below a node; how many lines. */
static uint32_t flip_leaves(struct sph_machine *m, uint32_t line) {
    const uint32_t *node = m->mem + (size_t)line * SPH_LINE_WORDS;
    uint32_t base = sph_field(node, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS);
    uint32_t n_inner = sph_field(node, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS);
    uint32_t n_leaf = sph_field(node, SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS), leaves = n_leaf;
    for (uint32_t i = 0; i < n_inner; i++)
        leaves += flip_leaves(m, base + i);
    for (uint32_t j = 0; j < n_leaf; j++)
        for (int bit = 0; bit < 256; bit++) {
            uint32_t *word = m->mem + (size_t)(base + n_inner + j) * SPH_LINE_WORDS + bit / 32;
            *word ^= 1u << bit % 32;
            wrong(m, "line");
            *word ^= 1u << bit % 32;
        }
    return leaves;
}

static void test_leaves(void **unused) {
    (void)unused;
    struct sph_machine m = example();
    assert_int_equal(flip_leaves(&m, 0), 6);
    sph_machine_free(&m);
}

static void test_registers(void **unused) {
    static const struct {
        int number, change;
        const char *part;
    } list[] = {
        {SPH_REG_EFFECTS, 1 << SPH_EFFECT_FIRST, "FACETS excludes FIRST"},
        {SPH_REG_EFFECTS, -(1 << SPH_EFFECT_FACETS), "N_SPHERES is 1, not in 0..0"},
        {SPH_REG_N_SPHERES, -2, "N_SPHERES is -1"},
        {SPH_REG_N_SPHERES, 6, "N_SPHERES is 7"},
        {SPH_REG_N_SPHERES, 1, "primitive 1: not marked as a sphere"},
        {SPH_REG_N_SPHERES, -1, "BG_BASE is"}, /* the table would reach into the spans */
        {SPH_REG_FACET_BASE, -1, "FACET_BASE is"},
        {SPH_REG_FACET_BASE, 100, "FACET_BASE is"},
        {SPH_REG_FACET_BASE, 1, "BG_BASE is"},
        {SPH_REG_BG_BASE, -1, "BG_BASE is"},
        {SPH_REG_N_PRIMS, 1, "FACET_BASE is"},
        {SPH_REG_TEX_FILTER, 1, "TEX_FILTER is 1"},
    };
    (void)unused;
    struct sph_machine m = example();
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        int32_t before = m.regs[list[i].number];
        m.regs[list[i].number] += list[i].change;
        wrong(&m, list[i].part);
        m.regs[list[i].number] = before;
    }
    sph_machine_free(&m);
}

/* A leaf that stands twice, one that is missing, a table line of another facet in the tree. */
static void test_tree(void **unused) {
    (void)unused;
    struct sph_machine m = example();
    uint32_t *table = line_of(&m, SPH_REG_FACET_BASE, 0), found = 0, save[SPH_LINE_WORDS];
    for (uint32_t line = 1; line < (uint32_t)m.regs[SPH_REG_PRIM_BASE]; line++)
        if (!memcmp(m.mem + line * SPH_LINE_WORDS, table, sizeof save)) found = line;
    uint32_t *leaf = m.mem + found * SPH_LINE_WORDS;
    assert_true(found > 0);
    memcpy(save, leaf, sizeof save);
    memcpy(leaf, table + SPH_LINE_WORDS, sizeof save);
    wrong(&m, "primitive 2 stands twice");
    leaf[0] ^= 1;
    wrong(&m, "facet 2 differs from its line in the table");
    memset(leaf, 0, sizeof save);
    wrong(&m, "leaf 0 differs from its primitive record");
    memcpy(leaf, save, sizeof save);
    sph_field_set(leaf, FACET(ID), 0);
    wrong(&m, "leaf id 0 of kind 1, there are 1 spheres, then 5 facets");
    sph_field_set(leaf, FACET(ID), 6);
    wrong(&m, "leaf id 6 of kind 1");
    sph_machine_free(&m);
}

/* Random damage to a machine, many times: refused or valid, never a crash. How often valid. */
static int damage(struct sph_machine *m, int times) {
    struct sph_machine sound = *m;
    size_t size = m->lines * SPH_LINE_WORDS * sizeof *m->mem;
    int valid = 0;
    assert_non_null(sound.mem = malloc(size));
    memcpy(sound.mem, m->mem, size);
    while (times--) {
        struct sph_error err = {{0}};
        for (int n = (int)between(1, 4); n; n--) {
            uint32_t *word = uniform() < 0.3
                                 ? (uint32_t *)&m->regs[(int)between(0, SPH_N_REGS)]
                                 : &m->mem[(size_t)between(0, m->lines * (double)SPH_LINE_WORDS)];
            *word ^= 1u << (int)between(0, 32);
        }
        if (!sph_machine_validate(m, &err)) valid++;
        memcpy(m->mem, sound.mem, size);
        memcpy(m->regs, sound.regs, sizeof sound.regs);
    }
    free(sound.mem);
    return valid;
}

static void test_damaged(void **unused) {
    (void)unused;
    int valid = 0;
    for (int scene = 0; scene < 40; scene++) { /* to build one takes longest */
        struct sph_machine m = example();
        valid += damage(&m, 50);
        sph_machine_free(&m);
    }
    assert_in_range(valid, 100, 1900); /* colours, lights and the like may be anything */
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_table),   cmocka_unit_test(test_kinds),
        cmocka_unit_test(test_no_kind), cmocka_unit_test(test_records),
        cmocka_unit_test(test_leaves),  cmocka_unit_test(test_registers),
        cmocka_unit_test(test_tree),    cmocka_unit_test(test_damaged),
        cmocka_unit_test(test_plane),   cmocka_unit_test(test_normal),
        cmocka_unit_test(test_corners),
    };
    seed(argc, argv);
    snprintf(path, sizeof path, "/tmp/test_facets_%ld.sph", (long)getpid());
    int failed = cmocka_run_group_tests_name("machine of facets", tests, NULL, NULL);
    remove(path);
    return failed;
}
