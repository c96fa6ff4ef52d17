/* describe.c - see describe.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "validate/describe.h"

#include <math.h>

#include "machine/bih_stats.h"
#include "machine/camera.h"
#include "validate/prims.h"
#include "machine/parts.h"

struct shape {
    uint32_t nodes, depth;
    uint32_t children[5];                 /* nodes with that many children */
    uint32_t leaves[SPH_STACK_DEPTH + 1]; /* primitives whose node is on that level, root: 1 */
};

/* Counts the node at `line` on `level` and all below. */
static void count(const struct sph_machine *m, uint32_t line, uint32_t level, struct shape *s) {
    const uint32_t *node = sph_line(m, line);
    uint32_t base = sph_field(node, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS);
    uint32_t n_inner = sph_field(node, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS);
    uint32_t n_leaf = sph_field(node, SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS);
    s->nodes++;
    s->children[n_inner + n_leaf]++;
    s->leaves[level] += n_leaf;
    if (level > s->depth) s->depth = level;
    for (uint32_t i = 0; i < n_inner; i++)
        count(m, base + i, level + 1, s);
}

void sph_machine_describe_tree(const struct sph_machine *m, FILE *file) {
    struct shape s = {0};
    count(m, (uint32_t)m->regs[SPH_REG_ROOT], 1, &s);
    struct sph_counts n = sph_machine_count(m);
    char text[256];
    sph_counts_text(&n, text, sizeof text);
    fprintf(file, "tree      %s, %u nodes on %u levels, %s below them\n", sph_machine_tree_name(m),
            s.nodes, s.depth, text);
    fprintf(file, "children ");
    for (int i = 0; i <= 4; i++)
        if (s.children[i]) fprintf(file, " %d: %u", i, s.children[i]);
    fprintf(file, "  (children of a node: nodes)\nleaves   ");
    for (uint32_t i = 1; i <= s.depth; i++)
        if (s.leaves[i]) fprintf(file, " %u: %u", i, s.leaves[i]);
    fprintf(file, "  (level of the node: primitives)\n");
}

void sph_machine_note(const struct sph_machine *m, const char *path, struct sph_ledger *ledger) {
    static const enum sph_read prims[SPH_KINDS] = {[SPH_SPHERE] = SPH_READ_SPHERE,
                                                   [SPH_TRIANGLE] = SPH_READ_TRIANGLE,
                                                   [SPH_PLANE] = SPH_READ_PLANE};
    struct sph_counts n = sph_machine_count(m);
    sph_ledger_add(ledger, SPH_READ_MACHINE, 1, path, 0, 0, NULL);
    sph_ledger_add(ledger, SPH_READ_LIGHT, (uint64_t)m->regs[SPH_REG_N_LIGHTS], path, 0, 0, NULL);
    for (int kind = 0; kind < SPH_KINDS; kind++)
        sph_ledger_add(ledger, prims[kind], n.of[kind], path, 0, 0, NULL);
}

static void describe_bih(const struct sph_machine *m, FILE *file) {
    struct sph_bih_stats s;
    struct sph_counts n = sph_machine_count(m);
    sph_bih_measure(m, &s);
    char text[256];
    sph_counts_text(&n, text, sizeof text);
    fprintf(file, "tree      %s, %u nodes on %u levels, %s below them", sph_machine_tree_name(m),
            s.inner + s.leaves, s.depth_max, text);
    if (n.loose) fprintf(file, ", %u of them beside", n.loose);
    fprintf(file, "\n");
}

static const struct {
    int number;
    const char *name;
} names[] = {
#define NAMED(name) {SPH_REG_##name, #name},
    SPH_EACH_REG(NAMED)};

static void describe_registers(const struct sph_machine *m, FILE *file) {
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        int light = names[i].number >= SPH_REG_LIGHT0_X && names[i].number <= SPH_REG_LIGHT0_B;
        for (int l = 0; l < (light ? m->regs[SPH_REG_N_LIGHTS] : 1); l++) {
            char name[32];
            int number = names[i].number + SPH_LIGHT_STRIDE * l;
            snprintf(name, sizeof name, "%s", names[i].name);
            if (light) name[5] = (char)('0' + l);
            fprintf(file, "  %3d %-12s %11d 0x%08x\n", number, name, m->regs[number],
                    (unsigned)m->regs[number]);
        }
    }
}

void sph_machine_core(const struct sph_machine *m, char *text, size_t size) {
    size_t used = 0;
    snprintf(text, size, "none");
    for (int i = 0; i < SPH_PARTS; i++) {
        int asked = sph_part_asked(m, i);
        if (!asked || used >= size) continue;
        used +=
            (size_t)snprintf(text + used, size - used, "%s%s", used ? "+" : "", sph_parts[i].word);
        if (sph_parts[i].most > 1 && used < size)
            used += (size_t)snprintf(text + used, size - used, "%d", asked);
    }
}

void sph_machine_describe(const struct sph_machine *m, FILE *file) {
    const struct sph_profile *p = sph_machine_profile(m);
    fprintf(file, "scene     %s\n", m->name);
    char root[24] = ""; /* PR as rt_core has it: 0 are all */
    if (!p->pr) snprintf(root, sizeof root, " (all %d)", p->w + p->wd);
    fprintf(file, "profile   %s: W %d, WD %d, PR %d%s, PQ %d, NG %d, FW %d bits\n", p->name, p->w,
            p->wd, p->pr, root, p->pq, p->ng, p->fw);
    fprintf(file, "grid      step 2^%d = %g scene units, point 0 at camera-frame (%g, %g, %g)\n",
            m->grid_log2, ldexp(1, m->grid_log2), m->origin[0], m->origin[1], m->origin[2]);
    const struct sph_machine_camera c = sph_machine_camera(m);
    fprintf(file,
            "view      the screen is %.6g pixels away, and the view meets it at (%.6g, %.6g)\n",
            c.screen, c.view[0], c.view[1]);
    fprintf(file, "memory    %u lines, %.1f KiB; primitive records from line %d\n", m->lines,
            m->lines * 4.0 * SPH_LINE_WORDS / 1024, m->regs[SPH_REG_PRIM_BASE]);
    if (sph_machine_bih(m))
        describe_bih(m, file);
    else
        sph_machine_describe_tree(m, file);
    char core[160];
    sph_machine_core(m, core, sizeof core);
    fprintf(file, "core      %s\n", core);
    if (sph_machine_effect(m, SPH_EFFECT_CAMERA))
        fprintf(file, "camera    this one alone: what its rays do not meet is left out\n");
    fprintf(file, "registers\n");
    describe_registers(m, file);
}
