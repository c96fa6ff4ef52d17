/* validate.c - is a machine in memory one that the hardware may run? See machine.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>
#include <string.h>

#include "machine/facets.h"
#include "machine/textures.h"
#include "scene/scene.h" /* SPH_MAX_SPHERES */

/* Checks lo <= register <= hi. */
static int in_range(const struct sph_machine *m, int number, const char *name, int64_t lo,
                    int64_t hi, struct sph_error *err) {
    int32_t v = m->regs[number];
    if (v >= lo && v <= hi) return 0;
    return sph_fail(err, "register %s is %d, not in %lld..%lld", name, v, (long long)lo,
                    (long long)hi);
}

#define RANGE(name, lo, hi)                                                                        \
    if (in_range(m, SPH_REG_##name, #name, lo, hi, err)) return -1

/* Frame, window, background and colours. */
static int check_frame(const struct sph_machine *m, struct sph_error *err) {
    const int32_t *r = m->regs;
    RANGE(EFFECTS, 0, (2 << SPH_EFFECT_TEXTURE) - 1);
    if (sph_machine_effect(m, SPH_EFFECT_INTERPENETRATE) &&
        !(sph_machine_effect(m, SPH_EFFECT_FIRST) && sph_machine_effect(m, SPH_EFFECT_INSIDE)))
        return sph_fail(err, "register EFFECTS is %d: INTERPENETRATE needs FIRST and INSIDE",
                        r[SPH_REG_EFFECTS]);
    if (sph_machine_effect(m, SPH_EFFECT_FACETS) &&
        (sph_machine_effect(m, SPH_EFFECT_FIRST) ||
         sph_machine_effect(m, SPH_EFFECT_INTERPENETRATE)))
        return sph_fail(err, "register EFFECTS is %d: FACETS excludes FIRST and INTERPENETRATE",
                        r[SPH_REG_EFFECTS]);
    RANGE(MAX_DEPTH, 0, SPH_MAX_DEPTH);
    RANGE(N_LIGHTS, 0, SPH_MAX_LIGHTS);
    RANGE(FRAME_W, 1, SPH_MAX_SIDE);
    RANGE(FRAME_H, 1, SPH_MAX_SIDE);
    RANGE(WIN_X1, 0, r[SPH_REG_FRAME_W]);
    RANGE(WIN_Y1, 0, r[SPH_REG_FRAME_H]);
    RANGE(WIN_X0, 0, r[SPH_REG_WIN_X1]);
    RANGE(WIN_Y0, 0, r[SPH_REG_WIN_Y1]);
    RANGE(BG_MODE, 0, 3);
    RANGE(RECT_X1, 0, r[SPH_REG_FRAME_W]);
    RANGE(RECT_Y1, 0, r[SPH_REG_FRAME_H]);
    RANGE(RECT_X0, 0, r[SPH_REG_RECT_X1]);
    RANGE(RECT_Y0, 0, r[SPH_REG_RECT_Y1]);
    RANGE(BG_COLOUR, 0, 0xffffff);
    RANGE(AMBIENT_R, 0, 65535);
    RANGE(AMBIENT_G, 0, 65535);
    RANGE(AMBIENT_B, 0, 65535);
    return 0;
}

/* The widths are those of the register, and such as model and RTL can hold. */
static int check_profile(const struct sph_machine *m, struct sph_error *err) {
    struct sph_error why = {{0}};
    int32_t packed = (int32_t)sph_profile_pack(&m->profile);
    RANGE(PROFILE, packed, packed);
    if (!sph_profile_check(&m->profile, &why)) return 0;
    return sph_fail(err, "register PROFILE is %d: %.300s", packed, why.text);
}

/* Eye, directions and lights, in the widths of the profile. */
static int check_geometry(const struct sph_machine *m, struct sph_error *err) {
    const struct sph_profile *p = sph_machine_profile(m);
    const int32_t *r = m->regs;
    int64_t w = 1ll << (p->w - 1), wd = (1ll << (p->wd - 1)) - 1;
    RANGE(EYE_X, -w, w - 1);
    RANGE(EYE_Y, -w, w - 1);
    RANGE(EYE_Z, -w, w - 1);
    RANGE(DIR_X0, -wd, wd);
    RANGE(DIR_Y0, -wd, wd);
    RANGE(DIR_Z, -wd, -sph_min_screen(p));
    RANGE(PITCH, 1, 2 * wd);
    if (r[SPH_REG_DIR_X0] + (r[SPH_REG_FRAME_W] - 1ll) * r[SPH_REG_PITCH] > wd)
        return sph_fail(err, "register PITCH is %d: the last column leaves %d bits",
                        r[SPH_REG_PITCH], p->wd);
    if (r[SPH_REG_DIR_Y0] - (r[SPH_REG_FRAME_H] - 1ll) * r[SPH_REG_PITCH] < -wd)
        return sph_fail(err, "register PITCH is %d: the last row leaves %d bits", r[SPH_REG_PITCH],
                        p->wd);
    for (int l = 0; l < r[SPH_REG_N_LIGHTS]; l++) {
        static const char *const names[6] = {"X", "Y", "Z", "R", "G", "B"};
        for (int i = 0; i < 6; i++) {
            int32_t v = r[SPH_REG_LIGHT0_X + SPH_LIGHT_STRIDE * l + i];
            if (i < 3 ? v < -w || v >= w : v < 0 || v > 65535)
                return sph_fail(err, "register LIGHT%d_%s is %d, out of range", l, names[i], v);
        }
    }
    return 0;
}

/* Sizes and addresses of memory. */
static int check_memory(const struct sph_machine *m, struct sph_error *err) {
    const int32_t *r = m->regs;
    int facets = sph_machine_effect(m, SPH_EFFECT_FACETS);
    if (m->lines < 1 || m->lines >= 1u << SPH_NODE_BASE_BITS)
        return sph_fail(err, "memory has %u lines, not 1..%u", m->lines,
                        (1u << SPH_NODE_BASE_BITS) - 1);
    RANGE(MEM_LINES, m->lines, m->lines);
    RANGE(N_PRIMS, 0, facets ? SPH_ID_NONE : SPH_MAX_SPHERES);
    RANGE(PRIM_BASE, 1, (int64_t)m->lines - r[SPH_REG_N_PRIMS]);
    RANGE(N_SPHERES, facets ? (int64_t)r[SPH_REG_N_PRIMS] - SPH_MAX_FACETS : 0,
          facets ? r[SPH_REG_N_PRIMS] : 0);
    RANGE(N_SPHERES, 0, SPH_MAX_SPHERES);
    RANGE(FACET_BASE, facets ? (int64_t)r[SPH_REG_PRIM_BASE] + r[SPH_REG_N_PRIMS] : 0,
          facets ? m->lines - sph_machine_facets(m) : 0);
    RANGE(TEX_FILTER, 0, sph_machine_effect(m, SPH_EFFECT_TEXTURE) ? 3 : 0);
    RANGE(ROOT, 0, r[SPH_REG_PRIM_BASE] - 1);
    RANGE(VISIT_LIMIT, 1, 0xffffff);
    RANGE(TREE, 1, 2);
    return 0;
}

static const uint32_t *line_at(const struct sph_machine *m, uint32_t line) {
    return m->mem + (size_t)line * SPH_LINE_WORDS;
}

/* Spans of background separation: every row within the frame. */
static int check_spans(const struct sph_machine *m, struct sph_error *err) {
    const int32_t *r = m->regs;
    uint32_t base = (uint32_t)r[SPH_REG_BG_BASE], width = (uint32_t)r[SPH_REG_FRAME_W];
    for (uint32_t y = 0; y < (uint32_t)r[SPH_REG_FRAME_H]; y++) {
        const uint32_t *word = line_at(m, base + y / SPH_LINE_WORDS) + y % SPH_LINE_WORDS;
        uint32_t x0 = sph_field(word, SPH_SPAN_X0_LSB, SPH_SPAN_X0_BITS);
        uint32_t x1 = sph_field(word, SPH_SPAN_X1_LSB, SPH_SPAN_X1_BITS);
        if (x0 > x1 || x1 > width)
            return sph_fail(err, "line %u: span of row %u is %u..%u, the frame has %u columns",
                            base + y / SPH_LINE_WORDS, y, x0, x1, width);
    }
    return 0;
}

/* 1 if n words are a number of `bits` bits, sign extended. */
static int extended(const uint32_t *word, int n, int bits) {
    int top = (bits - 1) / 32;
    int32_t sign = (int32_t)(word[top] << (31 - (bits - 1) % 32)) >> 31;
    if ((int32_t)word[top] >> (bits - 1) % 32 != sign) return 0;
    while (++top < n)
        if (word[top] != (uint32_t)sign) return 0;
    return 1;
}

/* Cone records: every number in the width that the hardware keeps. */
static int check_cones(const struct sph_machine *m, struct sph_error *err) {
    const struct sph_profile *p = sph_machine_profile(m);
    int f_bits = 2 * p->w + 2 * p->wd + 4, b_bits = p->w + p->wd + 4;
    for (int i = 0; i < m->regs[SPH_REG_BG_COUNT]; i++) {
        uint32_t base = (uint32_t)(m->regs[SPH_REG_BG_BASE] + SPH_CONE_LINES * i);
        const uint32_t *cone = line_at(m, base);
        int good = 1, tail = SPH_CONE_INSIDE_LSB / 32;
        for (int lsb = SPH_CONE_F_LSB; lsb <= SPH_CONE_FYY_LSB; lsb += SPH_CONE_F_BITS)
            good &= extended(cone + lsb / 32, SPH_CONE_F_BITS / 32, f_bits);
        for (int lsb = SPH_CONE_B_LSB; lsb <= SPH_CONE_BY_LSB; lsb += SPH_CONE_B_BITS)
            good &= extended(cone + lsb / 32, SPH_CONE_B_BITS / 32, b_bits);
        if (!good || cone[tail] > 1 || cone[tail + 1])
            return sph_fail(err, "line %u: cone %d does not fit %d and %d bits", base, i, f_bits,
                            b_bits);
    }
    return 0;
}

/* Background separation: its table behind the primitive records, and what stands in it. */
static int check_background(const struct sph_machine *m, struct sph_error *err) {
    const int32_t *r = m->regs;
    int mode = r[SPH_REG_BG_MODE], rows = (r[SPH_REG_FRAME_H] + SPH_LINE_WORDS - 1);
    RANGE(BG_COUNT, 0, mode == 3 ? SPH_MAX_CONES : 0);
    int lines = mode == 2   ? rows / SPH_LINE_WORDS
                : mode == 3 ? SPH_CONE_LINES * r[SPH_REG_BG_COUNT]
                            : 0;
    if (mode < 2) {
        RANGE(BG_BASE, 0, 0);
        return 0;
    }
    int64_t first = sph_machine_effect(m, SPH_EFFECT_FACETS)
                        ? r[SPH_REG_FACET_BASE] + sph_machine_facets(m)
                        : (int64_t)r[SPH_REG_PRIM_BASE] + r[SPH_REG_N_PRIMS];
    RANGE(BG_BASE, first, (int64_t)m->lines - lines);
    return mode == 2 ? check_spans(m, err) : check_cones(m, err);
}

struct walk {
    const struct sph_machine *m;
    uint8_t *used;  /* per line below PRIM_BASE */
    uint8_t *found; /* per primitive */
};

/* Checks one leaf record, half 0 or 1 of a line, against its primitive record. */
static int check_leaf(struct walk *w, uint32_t line, int half, struct sph_error *err) {
    const struct sph_machine *m = w->m;
    const uint32_t *leaf = line_at(m, line) + half * SPH_LEAF_STRIDE / 32;
    uint32_t id = sph_field(leaf, SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS);
    int whole = sph_machine_effect(m, SPH_EFFECT_FACETS);
    if (whole && sph_validate_leaf_line(m, line, &id, err)) return -1;
    if (whole && id >= (uint32_t)m->regs[SPH_REG_N_SPHERES])
        return w->found[id]++ ? sph_fail(err, "line %u: primitive %u stands twice", line, id) : 0;
    if (id >= (uint32_t)m->regs[SPH_REG_N_PRIMS])
        return sph_fail(err, "line %u: leaf id %u, there are %d primitives", line, id,
                        m->regs[SPH_REG_N_PRIMS]);
    if (memcmp(leaf, line_at(m, (uint32_t)m->regs[SPH_REG_PRIM_BASE] + id), SPH_LEAF_STRIDE / 8) !=
        0)
        return sph_fail(err, "line %u: leaf %u differs from its primitive record", line, id);
    if (!sph_field(leaf, SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS))
        return sph_fail(err, "line %u: leaf %u has no radius", line, id);
    if (w->found[id]++) return sph_fail(err, "line %u: primitive %u stands twice", line, id);
    return 0;
}

/* Checks the node at `line` on `level` (root: 1) and all below. The depth bounds recursion. */
static int check_node(struct walk *w, uint32_t line, int level, struct sph_error *err) {
    const uint32_t *node = line_at(w->m, line);
    uint32_t base = sph_field(node, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS);
    uint32_t n_inner = sph_field(node, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS);
    uint32_t n_leaf = sph_field(node, SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS);
    int whole = sph_machine_effect(w->m, SPH_EFFECT_FACETS); /* a line for each leaf */
    uint32_t group = n_inner + (whole ? n_leaf : (n_leaf + 1) / 2),
             end = (uint32_t)w->m->regs[SPH_REG_PRIM_BASE];
    if (level > SPH_STACK_DEPTH)
        return sph_fail(err, "line %u: node on level %d, the stack has %d", line, level,
                        SPH_STACK_DEPTH);
    if (n_inner + n_leaf > 4)
        return sph_fail(err, "line %u: node of %u children", line, n_inner + n_leaf);
    if (group && (base <= line || (uint64_t)base + group > end))
        return sph_fail(err, "line %u: children at line %u, not in %u..%u", line, base, line + 1,
                        end - 1);
    for (uint32_t i = 0; i < group; i++)
        if (w->used[base + i]++)
            return sph_fail(err, "line %u: child line %u belongs to another node", line, base + i);
    for (uint32_t j = 0; j < n_leaf; j++)
        if (check_leaf(w, base + n_inner + (whole ? j : j / 2), whole ? 0 : j & 1, err)) return -1;
    for (uint32_t i = 0; i < n_inner; i++)
        if (check_node(w, base + i, level + 1, err)) return -1;
    return 0;
}

/* Checks that the nodes are a tree that holds every primitive once. */
static int check_tree(const struct sph_machine *m, struct sph_error *err) {
    uint32_t n = (uint32_t)m->regs[SPH_REG_N_PRIMS], root = (uint32_t)m->regs[SPH_REG_ROOT];
    struct walk w = {m, calloc((size_t)m->regs[SPH_REG_PRIM_BASE], 1), calloc(n + 1u, 1)};
    int result;
    if (w.used && w.found) {
        w.used[root] = 1;
        result = check_node(&w, root, 1, err);
        for (uint32_t id = 0; id < n && !result; id++)
            if (!w.found[id]) result = sph_fail(err, "primitive %u is not in the tree", id);
    } else {
        result = sph_fail(err, "out of memory to check the tree");
    }
    free(w.used);
    free(w.found);
    return result;
}

int sph_machine_validate(const struct sph_machine *m, struct sph_error *err) {
    if (check_profile(m, err) || check_frame(m, err) || check_geometry(m, err) ||
        check_memory(m, err) || check_background(m, err))
        return -1;
    if (sph_machine_effect(m, SPH_EFFECT_FACETS) && sph_validate_facets(m, err)) return -1;
    if (sph_machine_effect(m, SPH_EFFECT_TEXTURE) && sph_validate_textures(m, err)) return -1;
    return check_tree(m, err);
}
