/* test_machine_file.c - machine files survive a round trip; damaged ones are refused
 * SPDX-License-Identifier: Apache-2.0
 */
#include "build_scene.h"

#include <string.h>
#include <unistd.h>

#include "validate/describe.h"
#include "machine/format.h"
#include "validate/validate.h"

static char path[64]; /* of this run's file */

static struct sph_machine example(void) {
    struct sph_scene s = cloud(60, 0.1);
    struct sph_build_report report;
    struct sph_machine m = built(&s, standard, &report);
    free(s.spheres);
    return m;
}

static void test_round_trip(void **unused) {
    struct sph_machine m = example(), back;
    struct sph_error err = {{0}};
    (void)unused;
    if (sph_machine_write(&m, path, &err)) fail_msg("%s", err.text);
    if (sph_machine_read(path, &back, &err)) fail_msg("%s", err.text);
    assert_int_equal(m.lines, back.lines);
    assert_memory_equal(m.mem, back.mem, (size_t)m.lines * 4 * SPH_LINE_WORDS);
    assert_memory_equal(m.regs, back.regs, sizeof m.regs);
    assert_memory_equal(m.name, back.name, sizeof m.name);
    assert_memory_equal(m.origin, back.origin, sizeof m.origin);
    assert_memory_equal(m.rotation, back.rotation, sizeof m.rotation);
    assert_int_equal(m.grid_log2, back.grid_log2);
    FILE *file = tmpfile();
    char text[8192] = "";
    sph_machine_describe(&back, file);
    rewind(file);
    assert_true(fread(text, 1, sizeof text - 1, file) > 100);
    assert_non_null(strstr(text, "60 spheres below"));
    assert_non_null(strstr(text, "LIGHT1_B"));
    fclose(file);
    assert_int_equal(sph_machine_write(&m, "/no/such/folder/m.sph", &err), -1);
    assert_non_null(strstr(err.text, "/no/such/folder"));
    sph_machine_free(&m);
    sph_machine_free(&back);
}

/* Reads the file, which must be refused with `part` in the message. */
static void refused(const char *part) {
    struct sph_machine m;
    struct sph_error err = {{0}};
    if (sph_machine_read(path, &m, &err) != -1) fail_msg("accepted, should name '%s'", part);
    assert_null(m.mem);
    if (!strstr(err.text, part) || !strstr(err.text, path))
        fail_msg("message '%s' lacks '%s' or the path", err.text, part);
}

static void put_file(const unsigned char *bytes, size_t n) {
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, n, file), n);
    fclose(file);
}

static unsigned char *get_file(size_t *n) {
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    fseek(file, 0, SEEK_END);
    *n = (size_t)ftell(file);
    rewind(file);
    unsigned char *bytes = malloc(*n);
    assert_int_equal(fread(bytes, 1, *n, file), *n);
    fclose(file);
    return bytes;
}

static void test_damaged_bytes(void **unused) {
    struct sph_machine m = example();
    size_t n;
    (void)unused;
    assert_int_equal(sph_machine_write(&m, path, NULL), 0);
    sph_machine_free(&m);
    unsigned char *bytes = get_file(&n);
    put_file(bytes, n - 1), refused("truncated");
    put_file(bytes, 100), refused("truncated");
    put_file(bytes, 4), refused("magic");
    put_file(bytes, 0), refused("magic");
    bytes[n - 9] ^= 1, put_file(bytes, n), refused("checksum"), bytes[n - 9] ^= 1;
    bytes[n - 1] ^= 1, put_file(bytes, n), refused("checksum"), bytes[n - 1] ^= 1;
    bytes[0] ^= 1, put_file(bytes, n), refused("magic"), bytes[0] ^= 1;
    bytes[SPH_AT_VERSION] ^= 1, put_file(bytes, n), refused("version is 6, not 7");
    bytes[SPH_AT_VERSION] ^= 2, put_file(bytes, n), refused("version is 4, not 7"), /* old */
        bytes[SPH_AT_VERSION] ^= 3;
    unsigned char *longer = malloc(n + 1);
    memcpy(longer, bytes, n), longer[n] = 0;
    put_file(longer, n + 1), refused("too long");
    free(longer);
    sph_put32(bytes + SPH_AT_LINES, 0xffffffff); /* must not be allocated */
    put_file(bytes, n), refused("by its header");
    free(bytes);
    for (int run = 0; run < 300; run++) { /* one bit anywhere */
        m = example();
        assert_int_equal(sph_machine_write(&m, path, NULL), 0);
        sph_machine_free(&m);
        bytes = get_file(&n);
        bytes[(size_t)between(0, (double)n)] ^= (unsigned char)(1 << (int)between(0, 8));
        put_file(bytes, n), refused(":");
        free(bytes);
    }
}

/* The name is text, which a terminal may show, and zeros behind it. */
static void test_wrong_name(void **unused) {
    static const struct {
        int at;
        unsigned char is;
        const char *part;
    } rows[] = {
        {0, 0x1b, "name: byte 0 is 0x1b"}, /* the beginning of a terminal's command */
        {0, '\n', "name: byte 0 is 0x0a"},
        {0, 0x7f, "name: byte 0 is 0x7f"},
        {SPH_NAME_BYTES - 2, 'x', "name: byte 126 is 0x78"}, /* behind its end */
        {SPH_NAME_BYTES - 1, 'x', "name: byte 127 is 0x78"},
    };
    struct sph_machine m = example();
    size_t n;
    (void)unused;
    assert_int_equal(sph_machine_write(&m, path, NULL), 0);
    sph_machine_free(&m);
    unsigned char *bytes = get_file(&n);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        unsigned char *byte = bytes + SPH_AT_NAME + rows[i].at, before = *byte;
        *byte = rows[i].is;
        put_file(bytes, n), refused(rows[i].part);
        *byte = before;
    }
    memset(bytes + SPH_AT_NAME, 'x', SPH_NAME_BYTES);
    put_file(bytes, n), refused("name: no zero at the end");
    free(bytes);
}

/* A machine with a wrong value but a right checksum: written, then read, which must refuse. */
static void wrong(struct sph_machine *m, const char *part) {
    assert_int_equal(sph_machine_write(m, path, NULL), 0);
    refused(part);
}

static void test_wrong_tree(void **unused) {
    struct sph_machine m = example();
    uint32_t *root = m.mem, base = sph_field(root, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS);
    uint32_t *child = m.mem + base * SPH_LINE_WORDS, copy[SPH_LINE_WORDS];
    (void)unused;
    assert_int_equal(sph_field(root, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS), 4);
    memcpy(copy, child, sizeof copy);
    sph_field_set(child, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS, 0); /* cycle to the root */
    wrong(&m, "children at line 0");
    sph_field_set(child, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS, base); /* cycle to itself */
    wrong(&m, "children at line 1");
    sph_field_set(child, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS, base + 1); /* two parents */
    wrong(&m, "belongs to another node");
    sph_field_set(child, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS, m.lines);
    char part[64];
    snprintf(part, sizeof part, "line %u: children at line %u, not in %u..%d", base, m.lines,
             base + 1, m.regs[SPH_REG_PRIM_BASE] - 1);
    wrong(&m, part);
    memcpy(child, copy, sizeof copy);
    sph_field_set(child, SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS, 7);
    wrong(&m, "children");
    memcpy(child, copy, sizeof copy);

    uint32_t *prim = m.mem + m.regs[SPH_REG_PRIM_BASE] * SPH_LINE_WORDS;
    prim[0] ^= 1;
    wrong(&m, "leaf 0 differs from its primitive record");
    prim[0] ^= 1;
    uint32_t *leaf = prim - SPH_LINE_WORDS; /* the last leaf line */
    sph_field_set(leaf, SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS, 60);
    wrong(&m, "leaf id 60");
    sph_machine_free(&m);
}

/* Every wrong bit of a cone record, every wrong end of a span. */
static void test_wrong_tables(void **unused) {
    struct sph_scene s = cloud(60, 0.1);
    struct sph_build_options o = standard;
    struct sph_build_report report;
    (void)unused;
    o.background = SPH_BG_SPANS;
    struct sph_machine m = built(&s, o, &report);
    uint32_t *span = m.mem + (size_t)m.regs[SPH_REG_BG_BASE] * SPH_LINE_WORDS + 47;
    const uint32_t bad[] = {65u << 16, 10u << 16 | 11, 0xffff0000u, 0xffffu};
    for (int i = 0; i < 4; i++) {
        uint32_t before = *span;
        *span = bad[i];
        wrong(&m, "span of row 47");
        *span = before;
    }
    m.regs[SPH_REG_BG_BASE]++;
    wrong(&m, "BG_BASE");
    m.regs[SPH_REG_BG_BASE] -= 2; /* within the primitive records */
    wrong(&m, "BG_BASE");
    sph_machine_free(&m);

    o.background = SPH_BG_EXACT, o.bg_levels = 2;
    for (o.profile = 0; o.profile < SPH_PROFILES; o.profile++) {
        m = built(&s, o, &report);
        const struct sph_profile *p = sph_machine_profile(&m);
        uint32_t *cones = m.mem + (size_t)m.regs[SPH_REG_BG_BASE] * SPH_LINE_WORDS;
        int count = m.regs[SPH_REG_BG_COUNT], line = SPH_LINE_WORDS * 32;
        assert_true(count > 4);
        for (int bit = 0; bit < SPH_CONE_LINES * line; bit++) {
            int number = bit < SPH_CONE_B_LSB ? SPH_CONE_F_BITS : SPH_CONE_B_BITS;
            int width = bit < SPH_CONE_B_LSB ? 2 * p->w + 2 * p->wd + 4 : p->w + p->wd + 4;
            if (bit >= SPH_CONE_INSIDE_LSB ? bit == SPH_CONE_INSIDE_LSB : bit % number < width - 1)
                continue; /* another number, or within the sign's reach */
            uint32_t *word = &cones[(bit / line + SPH_CONE_LINES * (count - 1)) * SPH_LINE_WORDS +
                                    bit % line / 32];
            *word ^= 1u << bit % 32;
            wrong(&m, "does not fit");
            *word ^= 1u << bit % 32;
        }
        m.regs[SPH_REG_BG_COUNT] = 17;
        wrong(&m, "BG_COUNT");
        m.regs[SPH_REG_BG_COUNT] = count;
        m.regs[SPH_REG_BG_BASE]++;
        wrong(&m, "BG_BASE");
        sph_machine_free(&m);
    }
    free(s.spheres);
}

static void test_wrong_registers(void **unused) {
    static const struct {
        int number, value;
        const char *name;
    } list[] = {
        {SPH_REG_EFFECTS, 128, "EFFECTS is 128"},
        {SPH_REG_EFFECTS, 40, "EFFECTS is 40: FACETS excludes FIRST"},
        {SPH_REG_FACET_BASE, 30, "FACET_BASE is 30, not in 0..0"},
        {SPH_REG_N_SPHERES, 1, "N_SPHERES is 1, not in 0..0"},
        {SPH_REG_TEX_FILTER, 1, "TEX_FILTER is 1"},
        {SPH_REG_EFFECTS, -1, "EFFECTS is -1"},
        {SPH_REG_EFFECTS, 16, "EFFECTS is 16: INTERPENETRATE needs INSIDE and FIRST"},
        {SPH_REG_EFFECTS, 20, "EFFECTS is 20: INTERPENETRATE needs"},
        {SPH_REG_EFFECTS, 24, "EFFECTS is 24: INTERPENETRATE needs"},
        {SPH_REG_MAX_DEPTH, 11, "MAX_DEPTH"},
        {SPH_REG_N_LIGHTS, 9, "N_LIGHTS"},
        {SPH_REG_FRAME_W, 0, "FRAME_W"},
        {SPH_REG_WIN_X1, 65, "WIN_X1"},
        {SPH_REG_WIN_Y0, -1, "WIN_Y0"},
        {SPH_REG_BG_MODE, 4, "BG_MODE"},
        {SPH_REG_BG_MODE, 2, "BG_BASE"},
        {SPH_REG_BG_MODE, 3, "BG_BASE"},
        {SPH_REG_BG_BASE, 1, "BG_BASE"},
        {SPH_REG_BG_COUNT, 1, "BG_COUNT"},
        {SPH_REG_FRAME_W, 16384, "FRAME_W"},
        {SPH_REG_FRAME_H, 16384, "FRAME_H"},
        {SPH_REG_RECT_X0, 70, "RECT_X0"},
        {SPH_REG_BG_COLOUR, 1 << 24, "BG_COLOUR"},
        {SPH_REG_AMBIENT_G, 65536, "AMBIENT_G"},
        {SPH_REG_EYE_Z, 40000, "EYE_Z"},
        {SPH_REG_DIR_X0, 70000, "DIR_X0"},
        {SPH_REG_DIR_Z, 1 - SPH_MIN_SCREEN, "DIR_Z"},
        {SPH_REG_PITCH, 100000, "PITCH"},
        {SPH_REG_ACROSS_Y, 1, "ACROSS_Y is 1"},
        {SPH_REG_DOWN_Z, -1, "DOWN_Z is -1"},
        {SPH_REG_ROOT, 100000, "ROOT"},
        {SPH_REG_PRIM_BASE, 100000, "PRIM_BASE"},
        {SPH_REG_MEM_LINES, 3, "MEM_LINES"},
        {SPH_REG_N_PRIMS, -1, "N_PRIMS"},
        {SPH_REG_VISIT_LIMIT, 0, "VISIT_LIMIT"},
        {SPH_REG_PROFILE, 0, "profile width W is 16, not 0"},
        {SPH_REG_PROFILE, 1 << 30, "profile width"},
        {SPH_REG_TREE, SPH_TREE_LAST + 1, "TREE"},
        {SPH_REG_TREE, SPH_TREE_BIH, "LEAF_BASE"},
        {SPH_REG_BOX_X0, 1, "BOX_X0"},
        {SPH_REG_N_LOOSE, 1, "N_LOOSE"},
        {SPH_REG_LIGHT0_X + 8, -40000, "LIGHT1_X"},
        {SPH_REG_LIGHT0_R, -1, "LIGHT0_R"},
        {SPH_REG_LIGHT0_R, 32 << SPH_LIGHT_SHIFT_LSB, "LIGHT0_R"},
        {SPH_REG_LIGHT0_G, 65536, "LIGHT0_G"},
    };
    struct sph_machine m = example();
    (void)unused;
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        int32_t before = m.regs[list[i].number];
        m.regs[list[i].number] = list[i].value;
        wrong(&m, list[i].name);
        m.regs[list[i].number] = before;
    }
    struct sph_profile p = m.profile;
    const struct {
        int *width;
        const char *name;
    } widths[] = {{&p.w, "width W is"},   {&p.wd, "width WD is"}, {&p.pq, "width PQ is"},
                  {&p.ng, "width NG is"}, {&p.fw, "width FW is"}, {&p.pr, "width PR is"}};
    for (size_t i = 0; i < sizeof widths / sizeof *widths; i++) { /* each alone */
        *widths[i].width += 1;
        m.regs[SPH_REG_PROFILE] = (int32_t)sph_profile_pack(&p);
        wrong(&m, widths[i].name);
        *widths[i].width -= 1;
    }
    m.regs[SPH_REG_PROFILE] = (int32_t)sph_profile_pack(&p);
    m.regs[SPH_REG_PROFILE] |= 1 << 29; /* a bit of no width */
    wrong(&m, "register PROFILE");
    sph_machine_free(&m);
}

/* What the hardware does not see of the header, wrong with a right checksum. */
static void test_wrong_place(void **unused) {
    struct sph_machine m = example(), good = m;
    (void)unused;
    static const int32_t steps[] = {100000, INT32_MIN, -1075, 1024};
    for (int i = 0; i < 4; i++)
        m.grid_log2 = steps[i], wrong(&m, "grid step is 2^");
    m = good, m.grid_log2 = 1025 - m.profile.w, wrong(&m, "grid step is 2^");
    m = good, m.origin[1] = NAN, wrong(&m, "origin: y");
    m = good, m.origin[2] = -INFINITY, wrong(&m, "origin: z");
    for (int i = 0; i < 9; i++)
        m = good, m.rotation[i] += 0.01, wrong(&m, "rotation");
    m.rotation[4] = NAN, wrong(&m, "rotation");
    memset(m.rotation, 0, sizeof m.rotation), wrong(&m, "rotation");
    m = good; /* a mirror */
    for (int i = 3; i < 6; i++)
        m.rotation[i] = -m.rotation[i];
    wrong(&m, "rotation");
    sph_machine_free(&good);
}

/* Widths of its own come back; such as cannot be, in header and register alike, are refused. */
static void test_widths(void **unused) {
    static const struct {
        const char *text, *part;
        int w, fw, pr;
    } list[] = {
        {"standard:pr=20,fw=12", NULL, 0, 0, 0},
        {"standard", "register PROFILE is", 17, 0, 0}, /* WD would have to be 18 */
        {"standard", "the filter sees the top fw of w bits", 13, 14, 0},
        {"standard", "fw is 15", 16, 15, 0},
        {"standard", "pr is 33, neither 0", 0, 0, 33},
    };
    struct sph_scene s = cloud(20, 0.1);
    (void)unused;
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        struct sph_profile p;
        struct sph_build_options o = standard;
        struct sph_build_report report;
        struct sph_error err = {{0}};
        assert_int_equal(sph_profile_parse(list[i].text, &p, &err), 0);
        o.widths = &p;
        struct sph_machine m = built(&s, o, &report), back;
        if (list[i].w) p.w = list[i].w;
        if (list[i].fw) p.fw = list[i].fw;
        if (list[i].pr) p.pr = list[i].pr;
        sph_machine_set_profile(&m, &p);
        if (list[i].part) {
            wrong(&m, list[i].part);
        } else {
            assert_int_equal(sph_machine_write(&m, path, NULL), 0);
            assert_int_equal(sph_machine_read(path, &back, &err), 0);
            assert_string_equal(sph_machine_profile(&back)->name, "standard:fw=12,pr=20");
            sph_machine_free(&back);
        }
        sph_machine_free(&m);
    }
    free(s.spheres);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_round_trip),   cmocka_unit_test(test_damaged_bytes),
        cmocka_unit_test(test_wrong_tree),   cmocka_unit_test(test_wrong_registers),
        cmocka_unit_test(test_wrong_tables), cmocka_unit_test(test_widths),
        cmocka_unit_test(test_wrong_place),  cmocka_unit_test(test_wrong_name),
    };
    seed(argc, argv);
    snprintf(path, sizeof path, "/tmp/test_machine_%ld.sph", (long)getpid());
    int failed = cmocka_run_group_tests_name("machine file", tests, NULL, NULL);
    remove(path);
    return failed;
}
