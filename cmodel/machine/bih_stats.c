/* bih_stats.c - see bih_stats.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "machine/bih_stats.h"

#include <string.h>

void sph_bih_count_leaf(struct sph_bih_stats *s, uint32_t prims, uint32_t depth) {
    if (!s->leaves || prims < s->prims_min) s->prims_min = prims;
    if (!s->leaves || depth < s->depth_min) s->depth_min = depth;
    if (prims > s->prims_max) s->prims_max = prims;
    if (depth > s->depth_max) s->depth_max = depth;
    s->leaves++;
    s->prims_sum += prims;
    s->depth_sum += depth;
    s->bars[prims < SPH_BIH_BARS - 1 ? prims : SPH_BIH_BARS - 1]++;
}

/* Counts the node in a half of `line` and all below; a valid machine bounds the depth. */
static void count(const struct sph_machine *m, uint32_t line, int half, uint32_t depth,
                  struct sph_bih_stats *s) {
    const uint32_t *node = sph_line(m, line) + half * (SPH_BIH_STRIDE / 32);
    if (sph_field(node, SPH_BIH_AXIS_LSB, SPH_BIH_AXIS_BITS) == SPH_BIH_LEAF) {
        sph_bih_count_leaf(s, sph_field(node, SPH_BIH_COUNT_LSB, SPH_BIH_COUNT_BITS), depth);
        return;
    }
    uint32_t fit = sph_field(node, SPH_BIH_FIT_LSB, SPH_BIH_FIT_BITS);
    uint32_t child =
        (uint32_t)m->regs[SPH_REG_ROOT] + sph_field(node, SPH_BIH_CHILD_LSB, SPH_BIH_CHILD_BITS);
    s->inner++;
    s->optimized += fit;
    count(m, child, 0, depth + 1, s);
    if (!fit) count(m, child, 1, depth + 1, s);
}

void sph_bih_measure(const struct sph_machine *m, struct sph_bih_stats *s) {
    memset(s, 0, sizeof *s);
    count(m, (uint32_t)m->regs[SPH_REG_ROOT], 0, 1, s);
}

uint64_t sph_bih_bytes(const struct sph_bih_stats *s) {
    return 12ull * (s->inner + s->leaves) + 4 * s->prims_sum + 24;
}

uint64_t sph_bih_node_bytes(const struct sph_machine *m) {
    return 4ull * SPH_LINE_WORDS * (uint32_t)(m->regs[SPH_REG_LEAF_BASE] - m->regs[SPH_REG_ROOT]);
}

uint64_t sph_bih_record_bytes(const struct sph_machine *m) {
    return 4ull * SPH_LINE_WORDS *
           (uint32_t)(m->regs[SPH_REG_PRIM_BASE] - m->regs[SPH_REG_LEAF_BASE]);
}
