/* tree.c - are nodes of four children a tree of every primitive? See check.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "validate/check.h"

#include <stdlib.h>
#include <string.h>

#include "machine/records.h"

struct walk {
    const struct sph_machine *m;
    uint32_t end;   /* its lines stand below: before the records, or anywhere behind them */
    uint8_t *used;  /* per line below that */
    uint8_t *found; /* per primitive */
};

/* Checks the node at `line` on `level` (root: 1) and all below. The depth bounds recursion. */
static int check_node(struct walk *w, uint32_t line, int level, struct sph_error *err) {
    const uint32_t *node = sph_line(w->m, line);
    uint32_t base = sph_field(node, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS);
    uint32_t n_inner = sph_field(node, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS);
    uint32_t n_leaf = sph_field(node, SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS);
    uint32_t group = n_inner + (uint32_t)sph_record_lines(sph_whole(w->m), n_leaf);
    if (level > SPH_STACK_DEPTH)
        return sph_fail(err, "line %u: node on level %d, the stack has %d", line, level,
                        SPH_STACK_DEPTH);
    if (n_inner + n_leaf > 4)
        return sph_fail(err, "line %u: node of %u children", line, n_inner + n_leaf);
    if (group && (base <= line || (uint64_t)base + group > w->end))
        return sph_fail(err, "line %u: children at line %u, not in %u..%u", line, base, line + 1,
                        w->end - 1);
    for (uint32_t i = 0; i < group; i++)
        if (w->used[base + i]++)
            return sph_fail(err, "line %u: child line %u belongs to another node", line, base + i);
    for (uint32_t j = 0; j < n_leaf; j++)
        if (sph_validate_record(w->m, base + n_inner, j, w->found, err)) return -1;
    for (uint32_t i = 0; i < n_inner; i++)
        if (check_node(w, base + i, level + 1, err)) return -1;
    return 0;
}

/* No register is set that a BIH alone has. */
static int check_none(const struct sph_machine *m, struct sph_error *err) {
    static const char *const names[] = {"LEAF_BASE", "N_LOOSE", "BOX_X0", "BOX_Y0",
                                        "BOX_Z0",    "BOX_X1",  "BOX_Y1", "BOX_Z1"};
    for (int i = 0; i < 8; i++)
        if (sph_validate_register(m, SPH_REG_LEAF_BASE + i, names[i], 0, 0, err)) return -1;
    return 0;
}

int sph_validate_tree(const struct sph_machine *m, struct sph_error *err) {
    uint32_t n = (uint32_t)m->regs[SPH_REG_N_PRIMS], root = (uint32_t)m->regs[SPH_REG_ROOT];
    if (check_none(m, err)) return -1;
    if (m->regs[SPH_REG_TREE] == SPH_TREE_BOX4 && sph_machine_effect(m, SPH_EFFECT_FIRST))
        return sph_fail(err, "register EFFECTS is %d: FIRST is not for TREE %d",
                        m->regs[SPH_REG_EFFECTS], SPH_TREE_BOX4);
    uint32_t prims = (uint32_t)m->regs[SPH_REG_PRIM_BASE], end = root < prims ? prims : m->lines;
    struct walk w = {m, end, calloc(end, 1), calloc(n + 1u, 1)};
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
