/* emit.c - tree and spheres to memory words; see emit.h, machine/machine.def
 * SPDX-License-Identifier: Apache-2.0
 *
 * Breadth first: the children of a node stand together from its base, inner ones a line each,
 * then leaf records two to a line; after all of them the primitive records.
 */
#include <math.h>
#include <stdlib.h>

#include "build/emit.h"

static uint32_t *line_at(struct sph_machine *m, uint32_t line) {
    return m->mem + (size_t)line * SPH_LINE_WORDS;
}

/* Writes child slot i of a node line: the sphere with the filter's margin. */
static void put_child(uint32_t *node, int i, const struct sph_ball *ball) {
    int at = i * SPH_CHILD_STRIDE;
    sph_field_set(node, at + SPH_CHILD_CTR_X_LSB, SPH_CHILD_CTR_X_BITS, (uint32_t)ball->c[0]);
    sph_field_set(node, at + SPH_CHILD_CTR_Y_LSB, SPH_CHILD_CTR_Y_BITS, (uint32_t)ball->c[1]);
    sph_field_set(node, at + SPH_CHILD_CTR_Z_LSB, SPH_CHILD_CTR_Z_BITS, (uint32_t)ball->c[2]);
    sph_field_set(node, at + SPH_CHILD_RAD_LSB, SPH_CHILD_RAD_BITS,
                  (uint32_t)(ball->r + SPH_FILTER_MARGIN));
}

/* Writes the leaf record of a sphere into half 0 or 1 of a line. */
static void put_leaf(uint32_t *line, int half, const struct sph_ball *ball, uint32_t id) {
    int at = half * SPH_LEAF_STRIDE;
    sph_field_set(line, at + SPH_LEAF_CTR_X_LSB, SPH_LEAF_CTR_X_BITS, (uint32_t)ball->c[0]);
    sph_field_set(line, at + SPH_LEAF_CTR_Y_LSB, SPH_LEAF_CTR_Y_BITS, (uint32_t)ball->c[1]);
    sph_field_set(line, at + SPH_LEAF_CTR_Z_LSB, SPH_LEAF_CTR_Z_BITS, (uint32_t)ball->c[2]);
    sph_field_set(line, at + SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS, (uint32_t)ball->r);
    sph_field_set(line, at + SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS, id);
}

/* lround(255 * c) of a colour 0..1, clamped. */
static uint32_t byte(double c) {
    return (uint32_t)lround(255 * fmin(fmax(c, 0), 1));
}

static void put_prim(uint32_t *line, const struct sph_ball *ball, uint32_t id,
                     const struct sph_material *material) {
    double weight = sph_material_weight(material);
    put_leaf(line, 0, ball, id);
    sph_field_set(line, SPH_PRIM_RED_LSB, SPH_PRIM_RED_BITS, byte(weight * material->rgb[0]));
    sph_field_set(line, SPH_PRIM_GREEN_LSB, SPH_PRIM_GREEN_BITS, byte(weight * material->rgb[1]));
    sph_field_set(line, SPH_PRIM_BLUE_LSB, SPH_PRIM_BLUE_BITS, byte(weight * material->rgb[2]));
    sph_field_set(line, SPH_PRIM_KR_LSB, SPH_PRIM_KR_BITS, (uint32_t)sph_material_kr(material));
}

/* 0 if every node's radius, margin included, fits its field. All spheres lie on the grid, so a
 * sound tree has none above sqrt(3) * 2^(FW-1); a leaf's is smaller still. */
static int check_radii(const struct sph_tree *tree, struct sph_error *err) {
    for (uint32_t i = 0; i < tree->n_nodes; i++)
        if (tree->nodes[i].ball.r + SPH_FILTER_MARGIN >= 1 << SPH_CHILD_RAD_BITS)
            return sph_fail(err, "node %u: a radius of %d filter units does not fit %d bits", i,
                            tree->nodes[i].ball.r, SPH_CHILD_RAD_BITS);
    return 0;
}

/* Lines of all nodes and leaf records. */
static uint64_t tree_lines(const struct sph_tree *tree) {
    uint64_t lines = 1;
    for (uint32_t i = 0; i < tree->n_nodes; i++)
        lines += tree->nodes[i].n_inner + (tree->nodes[i].n_leaf + 1u) / 2;
    return lines;
}

/* Writes node `node` to `line`, its leaf children from `base` on; queues its inner children. */
static void put_node(struct sph_machine *m, const struct sph_tree *tree,
                     const struct sph_ball *balls, uint32_t node, uint32_t line, uint32_t base) {
    const struct sph_tree_node *from = &tree->nodes[node];
    uint32_t *to = line_at(m, line);
    int n_inner = from->n_inner;
    sph_field_set(to, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS, base);
    sph_field_set(to, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS, from->n_inner);
    sph_field_set(to, SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS, from->n_leaf);
    for (int i = 0; i < n_inner; i++)
        put_child(to, i, &tree->nodes[from->child[i]].ball);
    for (int j = 0; j < from->n_leaf; j++) {
        uint32_t id = from->child[n_inner + j];
        struct sph_ball ball = sph_filter_leaf(&balls[id], sph_machine_profile(m));
        put_child(to, n_inner + j, &ball);
        put_leaf(line_at(m, base + (uint32_t)n_inner + (uint32_t)(j >> 1)), j & 1, &balls[id], id);
    }
}

int sph_emit_memory(const struct sph_scene *scene, const struct sph_ball *balls,
                    const struct sph_tree *tree, struct sph_machine *machine,
                    struct sph_error *err) {
    if (check_radii(tree, err)) return -1;
    uint32_t n = scene->n_spheres;
    uint64_t prim_base = tree_lines(tree), lines = prim_base + n;
    struct place {
        uint32_t node, line;
    } *queue = malloc(tree->n_nodes * sizeof *queue);
    machine->mem = calloc(lines * SPH_LINE_WORDS, sizeof *machine->mem);
    if (lines >= 1ull << SPH_NODE_BASE_BITS || !queue || !machine->mem) {
        free(queue);
        return sph_fail(err, "out of memory or addresses for %u spheres", n);
    }
    machine->lines = (uint32_t)lines;

    uint32_t base = 1, tail = 1;
    queue[0] = (struct place){0, 0};
    for (uint32_t head = 0; head < tail; head++) {
        const struct sph_tree_node *node = &tree->nodes[queue[head].node];
        put_node(machine, tree, balls, queue[head].node, queue[head].line, base);
        for (uint32_t i = 0; i < node->n_inner; i++)
            queue[tail++] = (struct place){node->child[i], base + i};
        base += node->n_inner + (node->n_leaf + 1u) / 2;
    }
    free(queue);
    for (uint32_t id = 0; id < n; id++)
        put_prim(line_at(machine, base + id), &balls[id], id,
                 &scene->materials[scene->spheres[id].material]);

    machine->regs[SPH_REG_ROOT] = 0;
    machine->regs[SPH_REG_PRIM_BASE] = (int32_t)base;
    machine->regs[SPH_REG_MEM_LINES] = (int32_t)lines;
    machine->regs[SPH_REG_N_PRIMS] = (int32_t)n;
    machine->regs[SPH_REG_VISIT_LIMIT] =
        tree->n_nodes < 0xfffffe ? (int32_t)tree->n_nodes + 1 : 0xffffff;
    return 0;
}
