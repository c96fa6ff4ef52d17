/* planes.c - a tree of spheres, triangles and planes; see tree.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * A plane's ball is the whole grid, so that nothing is gained by sorting it in: three planes are
 * leaf children of the root, and the tree of all others, and of further planes, is a child beside
 * them.
 */
#include <stdlib.h>
#include <string.h>

#include "builder/tree/box.h"
#include "builder/tree/split.h"
#include "builder/prim/build.h"
#include "machine/records.h"

static int loose(const struct sph_plants *p, uint32_t id) {
    struct sph_grid_prim prim = sph_grid_prim_of(p->balls, p->n_spheres, p->facets, id);
    return sph_kind_unbounded(prim.kind);
}

/* A tree of boxes is made of the boxes of primitives; other trees take none. */
static int make(const struct sph_plants *p, const struct sph_ball *balls, const uint32_t *id,
                uint32_t n, struct sph_tree *tree, struct sph_error *err) {
    struct sph_aabb *boxes = NULL;
    if (p->kind == SPH_TREE_PAPER) return sph_tree_paper(balls, n, p->profile, tree, err);
    if (p->kind == SPH_TREE_HW) return sph_tree_hardware(balls, n, p->profile, tree, err);
    if (p->kind == SPH_TREE_BOX4) {
        boxes = malloc((n + 1ull) * sizeof *boxes);
        if (!boxes) return sph_fail(err, "out of memory for %u boxes", n);
        for (uint32_t i = 0; i < n; i++)
            sph_box_of(p, id[i], &boxes[i]);
    }
    int failed = sph_tree_balanced(balls, boxes, n, p->profile, p->eye, p->kind, tree, err);
    free(boxes);
    return failed;
}

/* Builds the tree of what has bounds; leaf children are ids. */
static int plant(const struct sph_plants *p, struct sph_tree *tree, struct sph_error *err) {
    const struct sph_facets *facets = p->facets;
    uint32_t n = 0, all = p->n_spheres + facets->n;
    struct sph_ball *balls = malloc((all + 1ull) * sizeof *balls);
    uint32_t *id = malloc((all + 1ull) * sizeof *id);
    int failed = -1;
    if (!balls || !id) {
        sph_fail(err, "out of memory for a tree of %u primitives", all);
    } else {
        for (uint32_t i = 0; i < all; i++) {
            if (loose(p, i)) continue;
            balls[n] = p->balls[i];
            id[n++] = i;
        }
        tree->above = (facets->n_loose + SPH_CHILDREN - 2) / (SPH_CHILDREN - 1);
        failed = make(p, balls, id, n, tree, err);
    }
    for (uint32_t i = 0; !failed && i < tree->n_nodes; i++) {
        struct sph_tree_node *node = &tree->nodes[i];
        for (int j = 0; j < node->n_leaf; j++)
            node->child[node->n_inner + j] = id[node->child[node->n_inner + j]];
    }
    free(balls);
    free(id);
    return failed;
}

/* Puts a node above the root and the tree below it. */
static int raise(struct sph_tree *tree, const struct sph_profile *profile, struct sph_error *err) {
    struct sph_tree_node *more = realloc(tree->nodes, (tree->n_nodes + 1ull) * sizeof *more);
    if (!more) return sph_fail(err, "out of memory for a tree of %u nodes", tree->n_nodes);
    tree->nodes = more;
    memmove(more + 1, more, tree->n_nodes * sizeof *more);
    tree->n_nodes++;
    tree->depth++;
    for (uint32_t i = 1; i < tree->n_nodes; i++)
        for (int j = 0; j < more[i].n_inner; j++)
            more[i].child[j]++;
    more[0] = (struct sph_tree_node){.child = {1}, .n_inner = 1};
    more[0].ball = sph_filter_whole(profile);
    return 0;
}

void sph_tree_free(struct sph_tree *tree) {
    if (tree->split) sph_split_free(tree->split);
    free(tree->split);
    free(tree->nodes);
    tree->split = NULL, tree->nodes = NULL;
}

static int children(const struct sph_tree_node *node) {
    return node->n_inner + node->n_leaf;
}

int sph_tree_build(const struct sph_plants *p, struct sph_tree *tree, struct sph_error *err) {
    if (plant(p, tree, err)) return -1;
    if (p->kind != SPH_TREE_PAPER && p->kind != SPH_TREE_HW && sph_tree_tighten(p, tree, err))
        return -1;
    if (!p->facets->n_loose) return 0;
    if (children(tree->nodes) > 1 && raise(tree, p->profile, err)) return -1;
    tree->nodes->ball = sph_filter_whole(p->profile);
    for (uint32_t i = 0; i < p->facets->n; i++) {
        if (!loose(p, p->n_spheres + i)) continue;
        if (children(tree->nodes) == SPH_CHILDREN && raise(tree, p->profile, err)) return -1;
        struct sph_tree_node *root = tree->nodes;
        root->child[root->n_inner + root->n_leaf++] = p->n_spheres + i;
    }
    return 0;
}
