/* test_malformed.c - broken memory ends with a sticky error, never with a crash or a loop
 * SPDX-License-Identifier: Apache-2.0
 *
 * A machine in memory need not come from a file that was validated: the hardware has only its
 * checks on addresses, stack and visits.
 */
#include "model_scene.h"
#include "number.h"
#include "scene/rng.h"

enum { W = 24, H = 16 };

static int profile; /* of every machine here */

/* name: NULL for a scene of triangles and planes. */
static struct sph_machine machine(const char *name) {
    struct sph_scene scene = name ? model_scene(name) : facet_scene(0);
    struct sph_machine m;
    assert_true(model_build(&scene, profile, SPH_TREE_BALANCED, SPH_BG_NONE, W, H, &m));
    sph_scene_free(&scene);
    return m;
}

static uint32_t *root(struct sph_machine *m) {
    return m->mem + (size_t)m->regs[SPH_REG_ROOT] * SPH_LINE_WORDS;
}

/* The errors of a frame. */
static int walk(const struct sph_machine *m, int how) {
    struct sph_counters c;
    int errors;
    struct sph_frame frame = model_render(m, how, 1, &c, &errors);
    sph_frame_free(&frame);
    return errors;
}

/* The same with the paper's order of children and its correction. */
static int paper_errors_of(struct sph_machine *m) {
    int before = m->regs[SPH_REG_EFFECTS];
    m->regs[SPH_REG_EFFECTS] |= 1 << SPH_EFFECT_FIRST | 1 << SPH_EFFECT_INTERPENETRATE;
    int errors = walk(m, SPH_TRAVERSE_TREE);
    m->regs[SPH_REG_EFFECTS] = before;
    return errors;
}

/* Renders both ways, which must err alike. */
static int errors_of(struct sph_machine *m) {
    int errors = walk(m, SPH_TRAVERSE_TREE);
    assert_int_equal(errors, paper_errors_of(m));
    return errors;
}

static void root_beyond_memory(void **state) {
    (void)state;
    struct sph_machine m = machine("paper5");
    assert_int_equal(errors_of(&m), 0);
    m.regs[SPH_REG_ROOT] = m.regs[SPH_REG_MEM_LINES];
    assert_int_equal(errors_of(&m), 1 << SPH_ERROR_BAD_NODE);
    m.regs[SPH_REG_ROOT] = -1;
    assert_int_equal(errors_of(&m), 1 << SPH_ERROR_BAD_NODE);
    sph_machine_free(&m);
}

static void child_beyond_memory(void **state) {
    (void)state;
    struct sph_machine m = machine("paper100");
    sph_field_set(root(&m), SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS, (1u << SPH_NODE_BASE_BITS) - 1);
    assert_int_equal(errors_of(&m), 1 << SPH_ERROR_BAD_NODE);
    sph_field_set(root(&m), SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS, m.lines - 1);
    assert_int_equal(errors_of(&m), 1 << SPH_ERROR_BAD_NODE);
    sph_machine_free(&m);
}

static void five_children(void **state) {
    (void)state;
    struct sph_machine m = machine("paper100");
    sph_field_set(root(&m), SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS, 4);
    sph_field_set(root(&m), SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS, 1);
    assert_int_equal(errors_of(&m), 1 << SPH_ERROR_BAD_NODE);
    sph_field_set(root(&m), SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS, 7);
    assert_int_equal(errors_of(&m), 1 << SPH_ERROR_BAD_NODE);
    sph_machine_free(&m);
}

static void prim_beyond_memory(void **state) {
    (void)state;
    struct sph_machine m = machine("paper5");
    m.regs[SPH_REG_PRIM_BASE] = m.regs[SPH_REG_MEM_LINES];
    assert_int_equal(errors_of(&m), 1 << SPH_ERROR_BAD_NODE);
    sph_machine_free(&m);
}

/* The sphere that the paper's probe finds may have no record. */
static void other_beyond_memory(void **state) {
    (void)state;
    struct sph_machine m = machine("interpenetrating");
    int found = 0, lines = m.regs[SPH_REG_MEM_LINES];
    m.regs[SPH_REG_EFFECTS] = 1 << SPH_EFFECT_INSIDE; /* no mirror ray but the probe */
    while (--m.regs[SPH_REG_MEM_LINES] >= m.regs[SPH_REG_PRIM_BASE])
        found += paper_errors_of(&m) == 1 << SPH_ERROR_BAD_NODE;
    assert_int_equal(found, lines - m.regs[SPH_REG_PRIM_BASE]);
    sph_machine_free(&m);
}

/* Bits above the profile's coordinates are not there for the hardware. */
static void high_bits(void **state) {
    (void)state;
    struct sph_machine m = machine("interpenetrating");
    struct sph_counters c;
    int errors, w = sph_profiles[profile].w;
    for (int how = SPH_TRAVERSE_TREE; how <= SPH_TRAVERSE_BRUTE; how++) {
        struct sph_frame before = model_render(&m, how, 1, &c, &errors);
        for (uint32_t id = 0; id < (uint32_t)m.regs[SPH_REG_N_PRIMS]; id++) {
            uint32_t *line =
                m.mem + ((uint32_t)m.regs[SPH_REG_PRIM_BASE] + (size_t)id) * SPH_LINE_WORDS;
            for (int i = 0; i < 4 && w < SPH_LEAF_CTR_X_BITS; i++)
                sph_field_set(line, SPH_LEAF_CTR_X_LSB + i * SPH_LEAF_CTR_X_BITS + w,
                              SPH_LEAF_CTR_X_BITS - w, 0x5aa55a >> (id + (uint32_t)i) % 8);
        }
        struct sph_frame after = model_render(&m, how, 1, &c, &errors);
        assert_int_equal(errors, 0);
        assert_int_equal(model_differ("high bits", &m, &after, &before), 0);
        sph_frame_free(&before);
        sph_frame_free(&after);
    }
    sph_machine_free(&m);
}

/* Nor are those of corners, and of the points of planes. */
static void high_bits_of_facets(void **state) {
    (void)state;
    struct sph_machine m = machine(NULL);
    struct sph_counters c;
    int errors, w = sph_profiles[profile].w;
    struct sph_frame before = model_render(&m, SPH_TRAVERSE_BRUTE, 1, &c, &errors);
    for (uint32_t line = (uint32_t)m.regs[SPH_REG_FACET_BASE]; line < m.lines; line++) {
        uint32_t *facet = m.mem + (size_t)line * SPH_LINE_WORDS;
        int plane = sph_field(facet, SPH_FACET_KIND_LSB, SPH_FACET_KIND_BITS) == SPH_PLANE;
        for (int i = 0; i < (plane ? 3 : 9) && w < 24; i++)
            sph_field_set(facet, 24 * i + w, 24 - w, 0x5aa55a >> (line + (uint32_t)i) % 8);
    }
    struct sph_frame after = model_render(&m, SPH_TRAVERSE_BRUTE, 1, &c, &errors);
    assert_int_equal(model_differ("high bits", &m, &after, &before), 0);
    sph_frame_free(&before);
    sph_frame_free(&after);
    sph_machine_free(&m);
}

static void visit_limit(void **state) {
    (void)state;
    struct sph_machine m = machine("paper100");
    m.regs[SPH_REG_VISIT_LIMIT] = 1;
    assert_int_equal(errors_of(&m), 1 << SPH_ERROR_VISIT_LIMIT);
    m.regs[SPH_REG_VISIT_LIMIT] = 0;
    assert_int_equal(errors_of(&m), 1 << SPH_ERROR_VISIT_LIMIT);
    sph_machine_free(&m);
}

/* Makes the root its own and only child, or its own first of two children. */
static void cycles(void **state) {
    (void)state;
    for (uint32_t children = 1; children <= 2; children++) {
        struct sph_machine m = machine("paper100");
        uint32_t *line = root(&m);
        memset(line, 0, SPH_LINE_WORDS * sizeof *line);
        sph_field_set(line, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS, (uint32_t)m.regs[SPH_REG_ROOT]);
        sph_field_set(line, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS, children);
        for (uint32_t i = 0; i < children; i++)
            sph_field_set(line, (int)i * SPH_CHILD_STRIDE + SPH_CHILD_RAD_LSB, SPH_CHILD_RAD_BITS,
                          (1u << SPH_CHILD_RAD_BITS) - 1 - i);
        m.regs[SPH_REG_VISIT_LIMIT] = 1000;
        assert_int_equal(errors_of(&m),
                         1 << (children == 1 ? SPH_ERROR_VISIT_LIMIT : SPH_ERROR_STACK_OVERFLOW));
        sph_machine_free(&m);
    }
}

/* Random bits of memory turned over: anything may be seen, but every frame ends. */
static void damage(const char *name, int times) {
    uint64_t seed = test_seed();
    struct sph_rng rng = {seed};
    int reported = 0;
    printf("# %s: SEED=%lu\n", name ? name : "facets", seed);
    struct sph_machine m = machine(name);
    size_t bytes = (size_t)m.lines * SPH_LINE_WORDS * sizeof *m.mem;
    uint32_t *sound = malloc(bytes);
    memcpy(sound, m.mem, bytes);
    m.regs[SPH_REG_VISIT_LIMIT] = 200;
    for (int i = 0; i < times; i++) {
        uint64_t flips = 1 + sph_rng_next(&rng) % 40;
        memcpy(m.mem, sound, bytes);
        for (uint64_t j = 0; j < flips; j++) {
            uint64_t r = sph_rng_next(&rng);
            m.mem[(r >> 5) % (m.lines * SPH_LINE_WORDS)] ^= 1u << (r & 31);
        }
        reported += (walk(&m, SPH_TRAVERSE_TREE) | paper_errors_of(&m)) != 0;
    }
    printf("# %d of %d damaged machines were reported\n", reported, times);
    assert_true(reported > 0);
    free(sound);
    sph_machine_free(&m);
}

static void random_damage(void **state) {
    (void)state;
    damage("interpenetrating", 150);
    damage(NULL, 50);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(root_beyond_memory),  cmocka_unit_test(child_beyond_memory),
        cmocka_unit_test(five_children),       cmocka_unit_test(prim_beyond_memory),
        cmocka_unit_test(other_beyond_memory), cmocka_unit_test(high_bits),
        cmocka_unit_test(visit_limit),         cmocka_unit_test(cycles),
        cmocka_unit_test(random_damage),       cmocka_unit_test(high_bits_of_facets),
    };
    int failed = 0;
    for (profile = 0; profile < SPH_PROFILES; profile++)
        failed += cmocka_run_group_tests_name(sph_profiles[profile].name, tests, NULL, NULL);
    return failed;
}
