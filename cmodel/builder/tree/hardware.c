/* hardware.c - the tree that rt_build makes, as other builders leave theirs; see tree.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>

#include "build/build_tree.h"
#include "builder/tree/tree.h"

int sph_tree_hardware(const struct sph_ball *balls, uint32_t n, const struct sph_profile *profile,
                      struct sph_tree *tree, struct sph_error *err) {
    struct sph_bt_leaf *leaves = malloc((n + 1ull) * sizeof *leaves);
    struct sph_bt_node *from = NULL;
    if (!leaves) return sph_fail(err, "out of memory for a tree of %u spheres", n);
    for (uint32_t i = 0; i < n; i++)
        leaves[i] = (struct sph_bt_leaf){{balls[i].c[0], balls[i].c[1], balls[i].c[2]}, balls[i].r};
    int failed = sph_bt_tree(leaves, n, SPH_BUILD_CURVE, tree->rounds, profile, NULL, &from,
                             &tree->n_nodes, err);
    free(leaves);
    if (failed) return -1;
    tree->nodes = calloc(tree->n_nodes, sizeof *tree->nodes);
    uint8_t *level = calloc(tree->n_nodes, 1);
    for (uint32_t i = 0; tree->nodes && level && i < tree->n_nodes; i++) {
        struct sph_tree_node *node = &tree->nodes[i];
        node->n_inner = from[i].n_inner, node->n_leaf = from[i].n_leaf;
        if (++level[i] > tree->depth) tree->depth = level[i];
        for (int j = 0; j < node->n_inner + node->n_leaf; j++)
            node->child[j] = from[i].child[j];
        for (int j = 0; j < node->n_inner; j++) {
            const int32_t *ctr = from[i].ctr[j];
            level[node->child[j]] = level[i];
            tree->nodes[node->child[j]].ball =
                (struct sph_ball){{ctr[0], ctr[1], ctr[2]}, from[i].rad[j]};
        }
    }
    failed = !tree->nodes || !level;
    if (!failed) tree->nodes[0].ball = sph_filter_enclose(balls, NULL, n, profile);
    free(level);
    free(from);
    return failed ? sph_fail(err, "out of memory for %u nodes", tree->n_nodes) : 0;
}
