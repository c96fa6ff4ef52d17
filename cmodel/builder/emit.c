/* emit.c - tree and spheres to memory words; see emit.h, machine/machine.def
 * SPDX-License-Identifier: Apache-2.0
 *
 * Breadth first: the children of a node stand together from its base, inner ones a line each,
 * then leaf records two to a line, or one with facets; after all of them the primitive records and
 * the table of facets.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "builder/tree/box.h"
#include "builder/emit.h"
#include "build/build_tree.h"
#include "common/parallel.h"
#include "machine/records.h"
#include "builder/prim/build.h"

enum { WORTH = 4096 }; /* nodes or primitives, a thread */

/* Writes child slot i of a node line: the sphere with the filter's margin. */
static void put_child(uint32_t *node, int i, const struct sph_ball *ball) {
    int at = i * SPH_CHILD_STRIDE;
    sph_field_set(node, at + SPH_CHILD_CTR_X_LSB, SPH_CHILD_CTR_X_BITS, (uint32_t)ball->c[0]);
    sph_field_set(node, at + SPH_CHILD_CTR_Y_LSB, SPH_CHILD_CTR_Y_BITS, (uint32_t)ball->c[1]);
    sph_field_set(node, at + SPH_CHILD_CTR_Z_LSB, SPH_CHILD_CTR_Z_BITS, (uint32_t)ball->c[2]);
    sph_field_set(node, at + SPH_CHILD_RAD_LSB, SPH_CHILD_RAD_BITS,
                  (uint32_t)(ball->r + SPH_FILTER_MARGIN));
}

/* lround(255 * c) of a colour 0..1, clamped. */
static uint32_t byte(double c) {
    return (uint32_t)lround(255 * fmin(fmax(c, 0), 1));
}

static void put_material(uint32_t *line, const struct sph_material *material) {
    double weight = sph_material_weight(material);
    sph_field_set(line, SPH_PRIM_RED_LSB, SPH_PRIM_RED_BITS, byte(weight * material->rgb[0]));
    sph_field_set(line, SPH_PRIM_GREEN_LSB, SPH_PRIM_GREEN_BITS, byte(weight * material->rgb[1]));
    sph_field_set(line, SPH_PRIM_BLUE_LSB, SPH_PRIM_BLUE_BITS, byte(weight * material->rgb[2]));
    sph_field_set(line, SPH_PRIM_KR_LSB, SPH_PRIM_KR_BITS, (uint32_t)sph_material_kr(material));
    if (material->sum.on) sph_emit_sum(line, material);
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

/* Lines of the children of a node; `whole`: each leaf has one. */
static uint32_t group_lines(const struct sph_tree_node *node, int whole) {
    return node->n_inner + (uint32_t)sph_record_lines(whole, node->n_leaf);
}

/* Lines of all nodes and leaf records. */
static uint64_t tree_lines(const struct sph_tree *tree, int whole) {
    uint64_t lines = 1;
    for (uint32_t i = 0; i < tree->n_nodes; i++)
        lines += group_lines(&tree->nodes[i], whole);
    return lines;
}

/* What the memory is made of. */
struct content {
    const struct sph_scene *scene;
    const struct sph_tree *tree;
    const struct sph_plants *plants;
    struct sph_aabb *boxes; /* of nodes, or NULL: they are spheres */
};

/* Writes what bounds the children of a node. */
static void put_bounds(const struct content *c, const struct sph_tree_node *from, uint32_t *to) {
    const struct sph_profile *p = c->plants->profile;
    struct sph_aabb boxes[SPH_CHILDREN];
    for (int i = 0; i < from->n_inner; i++)
        if (c->boxes)
            boxes[i] = c->boxes[from->child[i]];
        else
            put_child(to, i, &c->tree->nodes[from->child[i]].ball);
    for (int i = from->n_inner; i < from->n_inner + from->n_leaf; i++) {
        if (c->boxes) {
            sph_box_of(c->plants, from->child[i], &boxes[i]);
            continue;
        }
        struct sph_ball ball = sph_filter_leaf(&c->plants->balls[from->child[i]], p);
        put_child(to, i, &ball);
    }
    if (c->boxes) sph_box_put(to, boxes, from->n_inner + from->n_leaf, p);
}

/* Writes node `node` to `line`, its leaf children from `base` on, after the inner ones. */
static void put_node(struct sph_machine *m, const struct content *c, uint32_t node, uint32_t line,
                     uint32_t base) {
    const struct sph_tree_node *from = &c->tree->nodes[node];
    uint32_t *to = sph_line(m, line);
    int n_inner = from->n_inner;
    sph_field_set(to, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS, base);
    sph_field_set(to, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS, from->n_inner);
    sph_field_set(to, SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS, from->n_leaf);
    put_bounds(c, from, to);
    for (int j = 0; j < from->n_leaf; j++) {
        const struct sph_plants *p = c->plants;
        uint32_t id = from->child[n_inner + j];
        uint32_t *record = sph_record(m, p->facets->n > 0, base + (uint32_t)n_inner, (uint32_t)j);
        struct sph_grid_prim prim = sph_grid_prim_of(p->balls, p->n_spheres, p->facets, id);
        sph_put_record(c->scene, &prim, record);
    }
}

/* Primitives, whose records stand from line `base` on, then the table of facets. */
struct prims {
    struct sph_machine *m;
    const struct sph_scene *scene;
    const struct sph_ball *balls;
    const struct sph_facets *facets;
    uint32_t base, n;
};

static void put_prims(void *user, uint32_t first, uint32_t end) {
    const struct prims *p = user;
    uint32_t spheres = p->scene->n_spheres;
    for (uint32_t id = first; id < end; id++) {
        struct sph_grid_prim prim = sph_grid_prim_of(p->balls, spheres, p->facets, id);
        uint32_t *line = sph_line(p->m, p->base + id);
        sph_put_prim(p->scene, &prim, line);
        put_material(line, &p->scene->materials[sph_grid_appearance(p->scene, &prim).material]);
        if (id >= spheres)
            sph_put_record(p->scene, &prim, sph_line(p->m, p->base + p->n + id - spheres));
    }
}

int sph_emit_alloc(struct sph_machine *machine, uint64_t lines, struct sph_error *err) {
    if (lines < 1ull << SPH_NODE_BASE_BITS)
        machine->mem = calloc(lines * SPH_LINE_WORDS, sizeof *machine->mem);
    if (!machine->mem)
        return sph_fail(err, "out of memory or addresses for %llu lines",
                        (unsigned long long)lines);
    machine->lines = (uint32_t)lines;
    return 0;
}

/* Visits that no ray exceeds. */
static int32_t visit_limit(uint32_t nodes) {
    return nodes < 0xfffffe ? (int32_t)nodes + 1 : 0xffffff;
}

void sph_emit_prims(const struct sph_scene *scene, const struct sph_ball *balls,
                    const struct sph_facets *facets, uint32_t base, uint32_t nodes,
                    struct sph_machine *machine) {
    uint32_t n = scene->n_spheres + facets->n;
    struct prims prims = {machine, scene, balls, facets, base, n};
    sph_parallel_for(n, WORTH, put_prims, &prims);
    machine->regs[SPH_REG_ROOT] = 0;
    machine->regs[SPH_REG_PRIM_BASE] = (int32_t)base;
    machine->regs[SPH_REG_MEM_LINES] = (int32_t)machine->lines;
    machine->regs[SPH_REG_N_PRIMS] = (int32_t)n;
    machine->regs[SPH_REG_N_SPHERES] = facets->n ? (int32_t)scene->n_spheres : 0;
    machine->regs[SPH_REG_FACET_BASE] = facets->n ? (int32_t)(base + n) : 0;
    machine->regs[SPH_REG_VISIT_LIMIT] = visit_limit(nodes);
}

/* A node, its line, and where what is below it begins. */
struct place {
    uint32_t node, line, base;
};

struct places {
    struct sph_machine *m;
    const struct content *c;
    const struct place *queue;
};

static void put_nodes(void *user, uint32_t first, uint32_t end) {
    const struct places *p = user;
    for (uint32_t i = first; i < end; i++)
        put_node(p->m, p->c, p->queue[i].node, p->queue[i].line, p->queue[i].base);
}

/* Writes nodes and leaf records. -1 if memory is out, or a radius does not fit. */
static int put_tree(struct sph_machine *m, struct content *c, struct sph_error *err) {
    const struct sph_tree *tree = c->tree;
    int whole = c->plants->facets->n > 0, failed = 0;
    uint32_t base = 1, tail = 1;
    struct place *queue = malloc(tree->n_nodes * sizeof *queue);
    if (!queue) return sph_fail(err, "out of memory for %u nodes", tree->n_nodes);
    if (c->plants->kind == SPH_TREE_BOX4)
        failed = !(c->boxes = sph_box_nodes(c->plants, tree, err));
    else
        failed = check_radii(tree, err);
    queue[0].node = queue[0].line = 0;
    for (uint32_t head = 0; !failed && head < tail; head++) {
        const struct sph_tree_node *node = &tree->nodes[queue[head].node];
        queue[head].base = base;
        for (uint32_t i = 0; i < node->n_inner; i++)
            queue[tail].node = node->child[i], queue[tail++].line = base + i;
        base += group_lines(node, whole);
    }
    if (!failed) sph_parallel_for(tail, WORTH, put_nodes, &(struct places){m, c, queue});
    free(queue);
    free(c->boxes);
    return failed ? -1 : 0;
}

/* Nodes and leaf records as rt_build makes them of the primitive records. */
static int put_built(struct sph_machine *m, uint32_t rounds, const struct sph_profile *p,
                     struct sph_error *err) {
    uint32_t n = (uint32_t)m->regs[SPH_REG_N_PRIMS], written;
    struct sph_bt_job job = {
        n, (uint32_t)m->regs[SPH_REG_PRIM_BASE], 0, UINT32_MAX, SPH_BUILD_CURVE, rounds, NULL};
    int reasons = sph_bt_words(m->mem, &job, n, p, &written, err);
    if (reasons <= 0) return reasons;
    return sph_fail(err, "a radius is not within 1 .. 2^%d - 1", p->w);
}

int sph_emit_memory(const struct sph_scene *scene, const struct sph_plants *plants,
                    const struct sph_tree *tree, struct sph_machine *machine,
                    struct sph_error *err) {
    const struct sph_facets *facets = plants->facets;
    struct content c = {scene, tree, plants, NULL};
    int hardware = plants->kind == SPH_TREE_HW; /* which asks for room for any tree */
    uint64_t base = hardware ? sph_bt_lines(scene->n_spheres) : tree_lines(tree, facets->n > 0);
    if (sph_emit_alloc(machine, base + scene->n_spheres + 2ull * facets->n, err) ||
        (!hardware && put_tree(machine, &c, err)))
        return -1;
    sph_emit_prims(scene, plants->balls, facets, (uint32_t)base, tree->n_nodes, machine);
    return hardware ? put_built(machine, tree->rounds, plants->profile, err) : 0;
}

int sph_emit_again(const struct sph_scene *scene, const struct sph_plants *plants,
                   const struct sph_tree *tree, struct sph_machine *machine,
                   struct sph_error *err) {
    static const int moved[] = {SPH_REG_PRIM_BASE, SPH_REG_FACET_BASE, SPH_REG_BG_BASE,
                                SPH_REG_SMOOTH_BASE, SPH_REG_MEM_LINES};
    struct content c = {scene, tree, plants, NULL};
    struct sph_machine old = *machine;
    uint32_t from = (uint32_t)old.regs[SPH_REG_PRIM_BASE], rest = old.lines - from;
    uint64_t base = tree_lines(tree, plants->facets->n > 0);
    machine->mem = NULL;
    if (sph_emit_alloc(machine, base + rest, err) || put_tree(machine, &c, err)) {
        free(machine->mem);
        *machine = old;
        return -1;
    }
    memcpy(sph_line(machine, base), sph_line(&old, from),
           (size_t)rest * SPH_LINE_WORDS * sizeof *old.mem);
    free(old.mem);
    for (size_t i = 0; i < sizeof moved / sizeof *moved; i++)
        if (old.regs[moved[i]]) machine->regs[moved[i]] += (int32_t)((int64_t)base - from);
    machine->regs[SPH_REG_VISIT_LIMIT] = visit_limit(tree->n_nodes);
    return 0;
}
