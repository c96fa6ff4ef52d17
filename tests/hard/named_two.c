/* named_two.c - machines of two leaves: a node of four children, a BIH; see named.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "named.h"

#include <string.h>

#include "builder/emit.h"

static void put_leaf(uint32_t *line, int half, const struct sph_leaf *s) {
    int at = half * SPH_LEAF_STRIDE;
    sph_field_set(line, at + SPH_LEAF_CTR_X_LSB, SPH_LEAF_CTR_X_BITS, (uint32_t)s->ctr[0]);
    sph_field_set(line, at + SPH_LEAF_CTR_Y_LSB, SPH_LEAF_CTR_Y_BITS, (uint32_t)s->ctr[1]);
    sph_field_set(line, at + SPH_LEAF_CTR_Z_LSB, SPH_LEAF_CTR_Z_BITS, (uint32_t)s->ctr[2]);
    sph_field_set(line, at + SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS, (uint32_t)s->rad);
    sph_field_set(line, at + SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS, s->id);
}

/* A machine of one node with two leaves, in this order; their ids are 0 and 1. mem: 4 lines. */
void two_leaves(const struct named *n, const struct sph_leaf leaf[2], uint32_t *mem,
                struct sph_machine *m) {
    memset(m, 0, sizeof *m);
    memset(mem, 0, 4 * SPH_LINE_WORDS * sizeof *mem);
    m->mem = mem;
    m->lines = 4;
    sph_machine_set_profile(m, &sph_profiles[n->profile]);
    m->regs[SPH_REG_PRIM_BASE] = 2;
    m->regs[SPH_REG_MEM_LINES] = 4;
    m->regs[SPH_REG_N_PRIMS] = 2;
    m->regs[SPH_REG_VISIT_LIMIT] = 2;
    sph_field_set(mem, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS, 1);
    sph_field_set(mem, SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS, 2);
    for (int i = 0; i < 2; i++) {
        const struct sph_leaf *s = &leaf[i];
        struct sph_ball ball = {{(int32_t)s->ctr[0], (int32_t)s->ctr[1], (int32_t)s->ctr[2]},
                                (int32_t)s->rad};
        struct sph_ball child = sph_filter_leaf(&ball, n->p);
        int at = i * SPH_CHILD_STRIDE;
        sph_field_set(mem, at + SPH_CHILD_CTR_X_LSB, SPH_CHILD_CTR_X_BITS, (uint32_t)child.c[0]);
        sph_field_set(mem, at + SPH_CHILD_CTR_Y_LSB, SPH_CHILD_CTR_Y_BITS, (uint32_t)child.c[1]);
        sph_field_set(mem, at + SPH_CHILD_CTR_Z_LSB, SPH_CHILD_CTR_Z_BITS, (uint32_t)child.c[2]);
        sph_field_set(mem, at + SPH_CHILD_RAD_LSB, SPH_CHILD_RAD_BITS,
                      (uint32_t)(child.r + SPH_FILTER_MARGIN));
        put_leaf(mem + SPH_LINE_WORDS, i, s);
        put_leaf(mem + (2 + s->id) * SPH_LINE_WORDS, 0, s);
    }
}

/* The same two leaves as a BIH of one primitive a leaf, or as one leaf. */
void two_in_bih(struct named *n, const struct sph_leaf leaf[2], int tree,
                uint32_t mem[TWO_LINES * SPH_LINE_WORDS], struct sph_machine *m) {
    struct sph_aabb box[2];
    struct sph_bih bih;
    struct sph_error err = {{0}};
    const struct sph_bih_options how = {tree == SPH_TREE_BIH ? 1 : 2, SPH_BIH_STACK + 1, 0, NULL};
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 3; j++) {
            box[i].lo[j] = (int32_t)(leaf[i].ctr[j] - leaf[i].rad);
            box[i].hi[j] = (int32_t)(leaf[i].ctr[j] + leaf[i].rad);
        }
    require(n, !sph_bih_build(box, 2, &how, &bih, &err), "no BIH: %s", err.text);
    uint32_t base = bih.n_nodes / 2;
    require(n, base + 3 <= TWO_LINES, "%u lines of nodes", base);
    memset(mem, 0, 4 * TWO_LINES * SPH_LINE_WORDS);
    m->mem = mem;
    m->lines = TWO_LINES;
    m->regs[SPH_REG_TREE] = tree;
    m->regs[SPH_REG_PRIM_BASE] = (int32_t)base + 1;
    m->regs[SPH_REG_MEM_LINES] = TWO_LINES;
    m->regs[SPH_REG_VISIT_LIMIT] = (int32_t)bih.n_nodes + 1;
    sph_emit_bih_nodes(&bih, 0, m);
    for (uint32_t i = 0; i < 2; i++) {
        const struct sph_leaf *s = &leaf[bih.order[i]];
        put_leaf(mem + base * SPH_LINE_WORDS, (int)i, s);
        put_leaf(mem + (base + 1 + s->id) * SPH_LINE_WORDS, 0, s);
    }
    sph_bih_free(&bih);
}
