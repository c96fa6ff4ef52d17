/* tree_tighten.c - nodes around the corners of triangles instead of around their balls; see tree.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * The ball around a triangle reaches far over its sides. A tree is built of such balls, but what a
 * node must hold are the corners: its ball is made again around all of them below it.
 */
#include <stdlib.h>

#include "builder/tree.h"
#include "prim/build.h"

struct work {
    const struct sph_plants *plants;
    struct sph_tree *tree;
    struct sph_ball *points; /* spheres, and corners as balls without radius */
    uint32_t *index;         /* 0, 1, 2, .. */
    uint32_t n;              /* points of the nodes that are being visited */
};

/* Appends what a leaf consists of. */
static void add_leaf(struct work *w, uint32_t id) {
    const struct sph_plants *p = w->plants;
    struct sph_grid_prim prim = sph_grid_prim_of(p->balls, p->n_spheres, p->facets, id);
    w->n += (uint32_t)sph_prim_build_of(prim.kind)->hull(&prim, &w->points[w->n]);
}

/* Appends all that is below a node, whose ball is replaced if another one is smaller. */
static void visit(struct work *w, uint32_t number) {
    struct sph_tree_node *node = &w->tree->nodes[number];
    uint32_t first = w->n;
    for (int i = 0; i < node->n_inner; i++)
        visit(w, node->child[i]);
    for (int i = 0; i < node->n_leaf; i++)
        add_leaf(w, node->child[node->n_inner + i]);
    struct sph_ball ball =
        sph_filter_enclose(w->points + first, w->index, w->n - first, w->plants->profile);
    if (ball.r < node->ball.r) node->ball = ball;
}

int sph_tree_tighten(const struct sph_plants *p, struct sph_tree *tree, struct sph_error *err) {
    uint64_t most = p->n_spheres + 3ull * p->facets->n;
    if (p->facets->n == p->facets->n_loose) return 0;
    struct work w = {p, tree, malloc(most * sizeof *w.points), malloc(most * sizeof *w.index), 0};
    int failed = 0;
    if (w.points && w.index) {
        for (uint32_t i = 0; i < most; i++)
            w.index[i] = i;
        visit(&w, 0);
    } else {
        failed = sph_fail(err, "out of memory for a tree of %u triangles", p->facets->n);
    }
    free(w.points);
    free(w.index);
    return failed;
}
