/* bih.c - is a bounding interval hierarchy one that the hardware may walk? See check.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>

#include "validate/prims.h"
#include "machine/records.h"
#include "validate/check.h"
#include "prim/prim.h"

struct walk {
    const struct sph_machine *m;
    uint8_t *used; /* per line below LEAF_BASE */
    uint8_t *held; /* per leaf record: a leaf has it */
};

/* A node's words, in the low or the high half of a line. */
static const uint32_t *node_at(const struct sph_machine *m, uint32_t line, int half) {
    return sph_line(m, line) + half * (SPH_BIH_STRIDE / 32);
}

static int is_zero(const uint32_t *node) {
    return !(node[0] | node[1] | node[2] | node[3]);
}

static int check_registers(const struct sph_machine *m, struct sph_error *err) {
    static const char *const names[] = {"BOX_X0", "BOX_Y0", "BOX_Z0", "BOX_X1", "BOX_Y1", "BOX_Z1"};
    const int32_t *r = m->regs;
    int64_t end = 2ll << m->profile.w;
    int64_t records = (int64_t)sph_record_lines(sph_whole(m), (uint64_t)r[SPH_REG_N_PRIMS]);
    uint32_t loose = sph_machine_count(m).loose;
    if (sph_machine_effect(m, SPH_EFFECT_FIRST))
        return sph_fail(err, "register EFFECTS is %d: FIRST is not for TREE %d", r[SPH_REG_EFFECTS],
                        r[SPH_REG_TREE]);
    if (sph_validate_register(m, SPH_REG_LEAF_BASE, "LEAF_BASE", r[SPH_REG_ROOT] + 1ll,
                              r[SPH_REG_PRIM_BASE] - records, err) ||
        sph_validate_register(m, SPH_REG_N_LOOSE, "N_LOOSE", loose, loose, err) ||
        sph_validate_register(m, SPH_REG_N_LOOSE, "N_LOOSE", 0, SPH_MAX_PLANES, err))
        return -1;
    for (int i = 0; i < 6; i++)
        if (sph_validate_register(m, SPH_REG_BOX_X0 + i, names[i], -end, end - 1, err)) return -1;
    return 0;
}

/* Every primitive has one leaf record, those without bounds the first. */
static int check_records(const struct sph_machine *m, uint8_t *found, struct sph_error *err) {
    uint32_t n = (uint32_t)m->regs[SPH_REG_N_PRIMS], base = (uint32_t)m->regs[SPH_REG_LEAF_BASE];
    int whole = sph_whole(m);
    for (uint32_t i = 0; i < n; i++) {
        if (sph_validate_record(m, base, i, found, err)) return -1;
        uint32_t kind = sph_record_kind(whole, sph_record(m, whole, base, i));
        if (sph_kind_unbounded(kind) != (i < (uint32_t)m->regs[SPH_REG_N_LOOSE]))
            return sph_fail(err, "line %u: leaf record %u of kind %u, the first %d are planes",
                            base + (whole ? i : i / 2), i, kind, m->regs[SPH_REG_N_LOOSE]);
    }
    return 0; /* n records, none twice: all */
}

static int check_leaf(struct walk *w, uint32_t line, const uint32_t *node, struct sph_error *err) {
    uint32_t first = sph_field(node, SPH_BIH_FIRST_LSB, SPH_BIH_FIRST_BITS);
    uint32_t count = sph_field(node, SPH_BIH_COUNT_LSB, SPH_BIH_COUNT_BITS);
    uint32_t n = (uint32_t)w->m->regs[SPH_REG_N_PRIMS];
    uint32_t loose = (uint32_t)w->m->regs[SPH_REG_N_LOOSE];
    if (node[0] != (uint32_t)SPH_BIH_LEAF << SPH_BIH_AXIS_LSB)
        return sph_fail(err, "line %u: bits of the leaf that must be 0 are not", line);
    if (first < loose || (uint64_t)first + count > n)
        return sph_fail(err, "line %u: leaf of records %u..%llu, not in %u..%u", line, first,
                        (unsigned long long)first + count, loose, n);
    for (uint32_t i = 0; i < count; i++)
        if (w->held[first + i]++)
            return sph_fail(err, "line %u: record %u belongs to another leaf", line, first + i);
    return 0;
}

/* Checks the node in a half of `line` on `level` (root: 1) and all below. The level bounds
 * recursion. */
static int check_node(struct walk *w, uint32_t line, int half, int level, struct sph_error *err) {
    const uint32_t *node = node_at(w->m, line, half);
    uint32_t root = (uint32_t)w->m->regs[SPH_REG_ROOT];
    uint32_t end = (uint32_t)w->m->regs[SPH_REG_LEAF_BASE];
    int unused = 30 - w->m->profile.w; /* of a clip word */
    if (level > SPH_BIH_STACK + 1)
        return sph_fail(err, "line %u: node on level %d, the stack has %d", line, level,
                        SPH_BIH_STACK);
    if (node[3]) return sph_fail(err, "line %u: word 3 of the node is not 0", line);
    if (sph_field(node, SPH_BIH_AXIS_LSB, SPH_BIH_AXIS_BITS) == SPH_BIH_LEAF)
        return check_leaf(w, line, node, err);
    for (int i = 1; i < 3; i++) {
        int32_t clip = (int32_t)node[i];
        if ((int32_t)(node[i] << unused) >> unused != clip)
            return sph_fail(err, "line %u: clip %d does not fit %d bits", line, clip,
                            w->m->profile.w + 2);
    }
    int fit = (int)sph_field(node, SPH_BIH_FIT_LSB, SPH_BIH_FIT_BITS);
    uint64_t child = (uint64_t)root + sph_field(node, SPH_BIH_CHILD_LSB, SPH_BIH_CHILD_BITS);
    if (child <= line || child >= end)
        return sph_fail(err, "line %u: children at line %llu, not in %u..%u", line,
                        (unsigned long long)child, line + 1, end - 1);
    uint32_t at = (uint32_t)child;
    if (w->used[at]++)
        return sph_fail(err, "line %u: child line %u belongs to another node", line, at);
    if (fit && !is_zero(node_at(w->m, at, 1)))
        return sph_fail(err, "line %u: a right child of a node that has one", at);
    if (check_node(w, at, 0, level + 1, err)) return -1;
    return fit ? 0 : check_node(w, at, 1, level + 1, err);
}

static int check_tree(struct walk *w, struct sph_error *err) {
    uint32_t root = (uint32_t)w->m->regs[SPH_REG_ROOT];
    w->used[root] = 1;
    if (!is_zero(node_at(w->m, root, 1)))
        return sph_fail(err, "line %u: a node beside the root", root);
    if (check_node(w, root, 0, 1, err)) return -1;
    for (uint32_t i = (uint32_t)w->m->regs[SPH_REG_N_LOOSE];
         i < (uint32_t)w->m->regs[SPH_REG_N_PRIMS]; i++)
        if (!w->held[i]) return sph_fail(err, "leaf record %u is in no leaf", i);
    return 0;
}

int sph_validate_bih(const struct sph_machine *m, struct sph_error *err) {
    if (check_registers(m, err)) return -1;
    uint32_t n = (uint32_t)m->regs[SPH_REG_N_PRIMS];
    struct walk w = {m, calloc((size_t)m->regs[SPH_REG_LEAF_BASE], 1), calloc(n + 1u, 1)};
    uint8_t *found = calloc(n + 1u, 1);
    int result = w.used && w.held && found ? check_records(m, found, err) || check_tree(&w, err)
                                           : sph_fail(err, "out of memory to check the tree");
    free(w.used);
    free(w.held);
    free(found);
    return result ? -1 : 0;
}
