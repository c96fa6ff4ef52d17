/* test_machine_text.c - a machine in words, and as text for Verilog and C, says what it holds
 * SPDX-License-Identifier: Apache-2.0
 */
#include "build_scene.h"

#include <string.h>
#include <unistd.h>

#include "common/file.h"
#include "machine/bih_stats.h"
#include "validate/describe.h"
#include "machine/export.h"
#include "machine/parts.h"

static char text[1 << 20]; /* what was said, or what a file holds */
static char stem[64];      /* of this run's files */

static void described(const struct sph_machine *m) {
    FILE *file = fmemopen(text, sizeof text, "w");
    assert_non_null(file);
    sph_machine_describe(m, file);
    fclose(file);
}

static void taken(const char *ending) {
    char name[96];
    snprintf(name, sizeof name, "%s%s", stem, ending);
    FILE *file = fopen(name, "rb");
    assert_non_null(file);
    text[fread(text, 1, sizeof text - 1, file)] = 0;
    fclose(file);
    unlink(name);
}

static void has(const char *part) {
    if (!strstr(text, part)) fail_msg("'%s' is not in: %s", part, text);
}

/* The tree level by level: nodes of each number of children, leaves of each level. */
static void check_tree(const struct sph_machine *m, uint32_t primitives) {
    uint32_t *lines = malloc(m->lines * sizeof *lines), children[5] = {0}, n = 1, at = 0;
    char said[512], leaves[256] = "leaves   ";
    int levels = 0;
    assert_non_null(lines);
    lines[0] = (uint32_t)m->regs[SPH_REG_ROOT];
    while (at < n) {
        uint32_t end = n, found = 0;
        for (levels++; at < end; at++) {
            const uint32_t *node = sph_line(m, lines[at]);
            uint32_t inner = node[7] >> 26 & 7, leaf = node[7] >> 29;
            uint32_t base = node[7] & 0x3ffffff; /* bits 249..224 */
            children[inner + leaf]++, found += leaf;
            for (uint32_t i = 0; i < inner; i++)
                lines[n++] = base + i;
        }
        if (found) sprintf(leaves + strlen(leaves), " %d: %u", levels, found);
    }
    snprintf(said, sizeof said,
             "tree      balanced, %u nodes on %d levels, %u spheres below them\n", n, levels,
             primitives);
    has(said);
    strcpy(said, "children ");
    for (int i = 0; i <= 4; i++)
        if (children[i]) sprintf(said + strlen(said), " %d: %u", i, children[i]);
    has(strcat(said, "  (children of a node: nodes)\n"));
    has(strcat(leaves, "  (level of the node: primitives)\n"));
    free(lines);
}

static void check_registers(const struct sph_machine *m) {
    static const struct {
        int number;
        const char *name;
    } names[] = {
#define NAMED(name) {SPH_REG_##name, #name},
        SPH_EACH_REG(NAMED)};
    int lines = 0, lights = m->regs[SPH_REG_N_LIGHTS];
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        for (int l = 0; l < (strncmp(names[i].name, "LIGHT0_", 7) ? 1 : lights); l++, lines++) {
            char said[96], name[32];
            int number = names[i].number + SPH_LIGHT_STRIDE * l;
            strcpy(name, names[i].name);
            if (!strncmp(name, "LIGHT0_", 7)) name[5] = (char)('0' + l);
            snprintf(said, sizeof said, "\n  %3d %-12s %11d 0x%08x\n", number, name,
                     m->regs[number], (unsigned)m->regs[number]);
            has(said);
        }
    for (const char *c = strstr(text, "\nregisters\n") + 11; *c; c++)
        lines -= *c == '\n';
    assert_int_equal(lines, 0);
}

static void test_words(void **unused) {
    (void)unused;
    for (uint32_t n = 1; n < 400; n += 1 + n / 3) {
        struct sph_scene s = cloud(n, 0.1);
        struct sph_build_report report;
        char said[256];
        s.n_lights = (int)(n % 3);
        struct sph_machine m = built(&s, standard, &report);
        described(&m);
        check_tree(&m, n);
        check_registers(&m);
        snprintf(said, sizeof said,
                 "memory    %u lines, %.1f KiB; primitive records from line %d\n", m.lines,
                 m.lines / 32.0, m.regs[SPH_REG_PRIM_BASE]);
        has(said);
        has("scene     cloud\nprofile   standard: W 16, WD 17, PR 0 (all 33), PQ 17, NG 2, FW 14 "
            "bits\n");
        sph_machine_free(&m);
        free(s.spheres);
    }
}

static void test_bih(void **unused) {
    struct sph_scene s = cloud(200, 0.1);
    struct sph_build_options o = standard;
    struct sph_build_report report;
    struct sph_bih_stats stats;
    char said[256];
    (void)unused;
    o.tree = SPH_TREE_BIH;
    struct sph_machine m = built(&s, o, &report);
    described(&m);
    sph_bih_measure(&m, &stats);
    snprintf(said, sizeof said, "tree      bih, %u nodes on %u levels, 200 spheres below them\n",
             stats.inner + stats.leaves, stats.depth_max);
    has(said);
    assert_string_equal(sph_machine_tree_name(&m), "bih");
    sph_machine_free(&m);
    free(s.spheres);
}

/* The core by name, into any room. */
static void test_core(void **unused) {
    static const char whole[] = "shadow+reflect2+lights2+inside+rect";
    struct sph_scene s = cloud(60, 0.3);
    struct sph_build_options o = standard;
    struct sph_build_report report;
    char said[64];
    (void)unused;
    struct sph_machine m = built(&s, o, &report);
    for (size_t size = 1; size < sizeof said; size++) {
        memset(said, '#', sizeof said);
        sph_machine_core(&m, said, size);
        assert_true(memchr(said, 0, size) != NULL);
        if (size >= sizeof whole) assert_string_equal(said, whole);
        for (size_t i = size; i < sizeof said; i++)
            assert_int_equal(said[i], '#');
    }
    sph_machine_free(&m);
    s.n_lights = 0, mirror.ks = 0;
    o.max_depth = 0, o.background = SPH_BG_NONE;
    o.inside = o.interpenetrate = SPH_OFF;
    m = built(&s, o, &report);
    sph_machine_core(&m, said, sizeof said);
    assert_string_equal(said, "none");
    sph_machine_free(&m);
    free(s.spheres);
}

/* The comment on the core that text for programs has. */
static void check_comment(const struct sph_machine *m) {
    char said[512] = "//";
    for (int i = 0; i < SPH_PARTS; i++)
        if (sph_part_asked(m, i))
            sprintf(said + strlen(said), " %s=%d", sph_parts[i].core, sph_part_asked(m, i));
    has(strcat(said, "\n"));
    has("// scene cloud, 64 x 48 pixels\n");
    has("// rt_core with W=16 WD=17 PQ=17 NG=2 FW=14 PR=0 and at least\n");
}

/* Hexadecimal words behind the comments, as many as there are. */
static void check_words(const char *from, const uint32_t *words, size_t n, int size, int back) {
    size_t at = 0;
    for (const char *c = from; *c && at < n; c++) {
        if (*c == '/') {
            c = strchr(c, '\n');
            continue;
        }
        if (*c == '\n' || *c == ' ' || *c == ',') continue;
        char word[9] = {0};
        if (c[0] == '0' && c[1] == 'x') c += 2;
        memcpy(word, c, 8);
        size_t turned =
            back ? at / (size_t)size * (size_t)size + (size_t)size - 1 - at % (size_t)size : at;
        uint64_t value;
        assert_int_equal(strspn(word, "0123456789abcdef"), 8);
        assert_int_equal(sph_parse_hex(word, UINT32_MAX, &value), 0);
        assert_int_equal(value, words[turned]);
        at++, c += 7;
        if (back) assert_int_equal(c[1] == '\n', at % (size_t)size == 0);
    }
    assert_int_equal(at, n);
}

static void test_export(void **unused) {
    struct sph_scene s = cloud(60, 0.1);
    struct sph_build_report report;
    struct sph_error err = {{0}};
    struct sph_machine m = built(&s, standard, &report);
    const size_t words = (size_t)m.lines * SPH_LINE_WORDS;
    uint32_t regs[SPH_N_REGS];
    char said[256], name[96], longest[sizeof((struct sph_output){0}.path)];
    const char *base = strrchr(stem, '/') + 1;
    (void)unused;
    memcpy(regs, m.regs, sizeof regs);
    if (sph_machine_write_hex(&m, stem, &err)) fail_msg("%s", err.text);
    taken(".regs.hex");
    snprintf(said, sizeof said, "// registers 0 .. %d of a machine, 32 bits each\n",
             SPH_N_REGS - 1);
    has(said), check_comment(&m), check_words(text, regs, SPH_N_REGS, 1, 1);
    taken(".mem.hex");
    snprintf(said, sizeof said, "// %u lines of memory of a machine, 256 bits each\n", m.lines);
    has(said), check_comment(&m), check_words(text, m.mem, words, SPH_LINE_WORDS, 1);

    snprintf(name, sizeof name, "%s.and-more.h", stem);
    if (sph_machine_write_c(&m, name, &err)) fail_msg("%s", err.text);
    taken(".and-more.h");
    check_comment(&m);
    has("// registers, and memory in lines of 8 words, low bits first\n");
    snprintf(said, sizeof said,
             "#include <stdint.h>\n\nenum { %s_REGISTERS = %d, %s_LINES = %u };\n", base,
             SPH_N_REGS, base, m.lines);
    has(said);
    snprintf(said, sizeof said, "static const uint32_t %s_regs[%d] = {\n    0x", base, SPH_N_REGS);
    has(said);
    check_words(strstr(text, "= {\n") + 4, regs, SPH_N_REGS, 1, 0);
    snprintf(said, sizeof said, "\n};\nstatic const uint32_t %s_mem[%zu] = {\n    0x", base, words);
    has(said);
    const char *from = strstr(strstr(text, "= {\n") + 4, "= {\n") + 4;
    check_words(from, m.mem, words, 1, 0);
    assert_string_equal(strchr(from, '}'), "};\n");

    assert_int_equal(sph_machine_write_c(&m, "/tmp/7.h", &err), -1);
    assert_non_null(strstr(err.text, "/tmp/7.h: its name does not begin"));
    assert_int_equal(sph_machine_write_c(&m, "/tmp/.h", &err), -1);
    assert_int_equal(sph_machine_write_c(&m, "/no/such/folder/m.h", &err), -1);
    assert_int_equal(sph_machine_write_hex(&m, "/no/such/folder/m", &err), -1);
    memset(longest, 'a', sizeof longest - 1), longest[sizeof longest - 1] = 0;
    err.text[0] = 0;
    assert_int_equal(sph_machine_write_hex(&m, longest, &err), -1);
    assert_non_null(strstr(err.text, "name is too long"));
    sph_machine_free(&m);
    free(s.spheres);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_words),
        cmocka_unit_test(test_bih),
        cmocka_unit_test(test_core),
        cmocka_unit_test(test_export),
    };
    seed(argc, argv);
    snprintf(stem, sizeof stem, "/tmp/sphaera_text_%ld", (long)getpid());
    return cmocka_run_group_tests_name("machine text", tests, NULL, NULL);
}
