/* test_machine_bih.c - damaged machines with a BIH are refused by name, or at least never crash
 * SPDX-License-Identifier: Apache-2.0
 *
 * Run from the root of the repository: reads tests/scenes/facets/.
 */
#include "build_scene.h"
#include "model_scene.h"

#include "machine/bih_stats.h"
#include "validate/validate.h"

static struct sph_machine machine(const struct sph_scene *s, uint32_t prims, int tree) {
    struct sph_build_options o = standard;
    struct sph_build_report report;
    o.tree = tree;
    o.max_prims = prims;
    o.background = SPH_BG_NONE;
    return built(s, o, &report);
}

/* Must be refused with `part` in the message. */
static void wrong(const struct sph_machine *m, const char *part) {
    struct sph_error err = {{0}};
    if (!sph_machine_validate(m, &err)) fail_msg("accepted, should name '%s'", part);
    if (!strstr(err.text, part)) fail_msg("message '%s' lacks '%s'", err.text, part);
}

/* The same of a register or word that has `value` for this one time. */
static void wrong_reg(struct sph_machine *m, int reg, int32_t value, const char *part) {
    int32_t before = m->regs[reg];
    m->regs[reg] = value;
    wrong(m, part);
    m->regs[reg] = before;
}

static void wrong_word(struct sph_machine *m, size_t word, uint32_t value, const char *part) {
    uint32_t before = m->mem[word];
    m->mem[word] = value;
    wrong(m, part);
    m->mem[word] = before;
}

/* Index of the first word of a node: a leaf or not, fit or not, with such a number of primitives.
 */
static size_t find(const struct sph_machine *m, int leaf, int fit, uint32_t most) {
    for (size_t at = 0; at < (size_t)m->regs[SPH_REG_LEAF_BASE] * SPH_LINE_WORDS; at += 4) {
        const uint32_t *n = m->mem + at;
        if ((n[0] | n[1] | n[2]) && (n[0] >> 30 == SPH_BIH_LEAF) == leaf &&
            (leaf ? n[2] <= most && n[2] > 0 : (int)(n[0] >> 29 & 1) == fit))
            return at;
    }
    fail_msg("no such node");
    return 0;
}

/* Small spheres in two corners: nodes with one child. */
static struct sph_scene corners(void) {
    struct sph_scene s = cloud(60, 0.005);
    for (uint32_t i = 0; i < 60; i++)
        s.spheres[i].ctr.x = 0.1 * s.spheres[i].ctr.x + (i & 1 ? 0.9 : 0);
    return s;
}

static void registers(void **unused) {
    struct sph_scene s = cloud(61, 0.1);
    struct sph_machine m = machine(&s, 2, SPH_TREE_BIH);
    int32_t *r = m.regs, base = r[SPH_REG_LEAF_BASE];
    (void)unused;
    wrong_reg(&m, SPH_REG_TREE, SPH_TREE_BALANCED, "LEAF_BASE is");
    wrong_reg(&m, SPH_REG_TREE, SPH_TREE_LAST + 1, "TREE is 8");
    wrong_reg(&m, SPH_REG_LEAF_BASE, 0, "LEAF_BASE is 0");
    wrong_reg(&m, SPH_REG_LEAF_BASE, base + 1, "LEAF_BASE is");
    wrong_reg(&m, SPH_REG_LEAF_BASE, base - 1, "");
    wrong_reg(&m, SPH_REG_N_LOOSE, 1, "N_LOOSE is 1");
    wrong_reg(&m, SPH_REG_N_LOOSE, -1, "N_LOOSE is -1");
    wrong_reg(&m, SPH_REG_BOX_X0, -(1 << 17) - 1, "BOX_X0");
    wrong_reg(&m, SPH_REG_BOX_Z1, 1 << 17, "BOX_Z1");
    wrong_reg(&m, SPH_REG_ROOT, 1, "");
    wrong_reg(&m, SPH_REG_EFFECTS, 1 << SPH_EFFECT_FIRST, "FIRST is not for TREE 3");
    sph_machine_free(&m);
    free(s.spheres);
}

static void nodes(void **unused) {
    struct sph_scene s = corners();
    struct sph_machine m = machine(&s, 2, SPH_TREE_BIH);
    size_t inner = find(&m, 0, 0, 0), fit = find(&m, 0, 1, 0), leaf = find(&m, 1, 0, 9);
    uint32_t lines = (uint32_t)m.regs[SPH_REG_LEAF_BASE], n = m.mem[inner];
    (void)unused;
    wrong_word(&m, 3, 1, "line 0: word 3 of the node");
    wrong_word(&m, 6, 1, "line 0: a node beside the root");
    wrong_word(&m, inner, n & ~0x1fffffffu, "children at line 0");
    wrong_word(&m, inner, (n & ~0x1fffffffu) | lines, "children at line");
    wrong_word(&m, inner, n | 0x1fffffff, "children at line");
    wrong_word(&m, inner, n | 3u << 30, "bits of the leaf that must be 0");
    wrong_word(&m, inner, n | 1u << 29, "a right child of a node that has one");
    wrong_word(&m, inner + 1, 1u << 17, "clip 131072 does not fit 18 bits");
    wrong_word(&m, inner + 2, (uint32_t)(-(1 << 17) - 1), "does not fit 18 bits");
    wrong_word(&m, fit, m.mem[fit] & ~(1u << 29), ""); /* a right child of zeros: loops or clips */
    wrong_word(&m, leaf, m.mem[leaf] | 1, "bits of the leaf that must be 0");
    wrong_word(&m, leaf + 1, m.mem[leaf + 1] + 1, "");
    wrong_word(&m, leaf + 2, m.mem[leaf + 2] + 60, "leaf of records");
    wrong_word(&m, leaf + 2, 0xffffffff, "leaf of records");
    wrong_word(&m, leaf + 2, m.mem[leaf + 2] + 1, "belongs to another leaf");
    wrong_word(&m, leaf + 2, m.mem[leaf + 2] - 1, "is in no leaf");
    size_t record = (size_t)lines * SPH_LINE_WORDS;
    wrong_word(&m, record, m.mem[record] ^ 1, "differs from its primitive record");
    wrong_word(&m, record + 3, 60, "leaf id 60");
    memcpy(m.mem + record, m.mem + record + 4, 16);
    wrong(&m, "stands twice");
    sph_machine_free(&m);
    free(s.spheres);
}

/* Two nodes with the same children, and a chain that is too deep for the stack. */
static void shapes(void **unused) {
    struct sph_scene s = cloud(300, 0.01);
    struct sph_machine m = machine(&s, 1, SPH_TREE_BIH);
    (void)unused;
    uint32_t child = sph_field(m.mem, SPH_BIH_CHILD_LSB, SPH_BIH_CHILD_BITS);
    uint32_t *pair = m.mem + (size_t)child * SPH_LINE_WORDS;
    assert_true(pair[0] >> 30 != SPH_BIH_LEAF && pair[4] >> 30 != SPH_BIH_LEAF);
    uint32_t same = pair[4];
    sph_field_set(pair + 4, SPH_BIH_CHILD_LSB, SPH_BIH_CHILD_BITS,
                  sph_field(pair, SPH_BIH_CHILD_LSB, SPH_BIH_CHILD_BITS));
    wrong(&m, "belongs to another node");
    pair[4] = same;
    for (uint32_t i = 0; i < 70; i++) { /* fit nodes, each the child of the one before */
        uint32_t *at = m.mem + (size_t)i * SPH_LINE_WORDS;
        memset(at, 0, 4 * SPH_LINE_WORDS);
        at[0] = 1u << SPH_BIH_FIT_LSB | (i + 1);
    }
    wrong(&m, "line 65: node on level 66, the stack has 64");
    sph_machine_free(&m);
    free(s.spheres);
}

/* Planes first, whole lines. */
static void facets(void **unused) {
    struct sph_scene s = facet_scene(0);
    struct sph_machine m = machine(&s, 2, SPH_TREE_BIH);
    int32_t loose = m.regs[SPH_REG_N_LOOSE];
    size_t record = (size_t)m.regs[SPH_REG_LEAF_BASE] * SPH_LINE_WORDS;
    (void)unused;
    assert_true(loose > 0);
    wrong_reg(&m, SPH_REG_N_LOOSE, loose - 1, "N_LOOSE is");
    wrong_reg(&m, SPH_REG_N_LOOSE, loose + 1, "N_LOOSE is");
    uint32_t copy[SPH_LINE_WORDS], *plane = m.mem + record, *other = plane + SPH_LINE_WORDS * loose;
    memcpy(copy, plane, sizeof copy);
    memcpy(plane, other, sizeof copy);
    memcpy(other, copy, sizeof copy);
    wrong(&m, "the first");
    memcpy(other, plane, sizeof copy);
    wrong(&m, "");
    sph_machine_free(&m);
    sph_scene_free(&s);
}

/* Any word may be anything: refused, or walked without a crash and without an end of time. */
static void noise(void **unused) {
    (void)unused;
    for (int run = 0; run < (SANITIZED ? 60 : 300); run++) {
        struct sph_scene s = corners();
        struct sph_machine m =
            machine(&s, 1u + (uint32_t)run % 3, run % 5 ? SPH_TREE_BIH : SPH_TREE_BRUTE);
        struct sph_counters c;
        struct sph_error err = {{0}};
        int errors;
        size_t words = (size_t)m.regs[SPH_REG_LEAF_BASE] * SPH_LINE_WORDS;
        for (int i = 0; i < 3; i++)
            m.mem[(size_t)between(0, (double)words)] ^= 1u << (int)between(0, 32);
        m.regs[SPH_REG_WIN_X1] = 8, m.regs[SPH_REG_WIN_Y1] = 6;
        sph_machine_validate(&m, &err); /* may accept a clip that is merely wrong */
        struct sph_frame f = model_render(&m, SPH_TRAVERSE_TREE, 1, &c, &errors);
        sph_frame_free(&f);
        sph_machine_free(&m);
        free(s.spheres);
    }
}

/* Statistics read from the words are those of the builder; bytes as counted by hand. */
static void stats(void **unused) {
    struct sph_scene s = corners();
    struct sph_build_options o = standard;
    struct sph_build_report report;
    struct sph_bih_stats read;
    (void)unused;
    o.tree = SPH_TREE_BIH;
    o.max_prims = 1;
    struct sph_machine m = built(&s, o, &report);
    sph_bih_measure(&m, &read);
    assert_memory_equal(&read, &report.bih, sizeof read);
    assert_true(read.optimized > 0 && read.prims_sum == 60);
    assert_int_equal(sph_bih_bytes(&read), 12 * (read.inner + read.leaves) + 4 * 60 + 24);
    assert_int_equal(sph_bih_node_bytes(&m), 32 * m.regs[SPH_REG_LEAF_BASE]);
    assert_int_equal(sph_bih_record_bytes(&m), 32 * 30);
    assert_int_equal(report.nodes, read.inner + read.leaves);
    sph_machine_free(&m);
    free(s.spheres);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(registers), cmocka_unit_test(nodes), cmocka_unit_test(shapes),
        cmocka_unit_test(facets),    cmocka_unit_test(noise), cmocka_unit_test(stats),
    };
    seed(argc, argv);
    return cmocka_run_group_tests_name("machine bih", tests, NULL, NULL);
}
