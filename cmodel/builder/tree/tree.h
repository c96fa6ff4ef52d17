/* tree.h - both tree builders fill this, emit.c turns it into memory words
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TREE_H
#define SPH_TREE_H

#include "builder/tree/bih.h"
#include "builder/grid/facets.h"
#include "common/error.h"
#include "common/parallel.h"

enum { SPH_CHILDREN = 4 }; /* of a node */

struct sph_machine;
struct sph_split;

struct sph_tree_node {
    struct sph_ball ball;         /* filter units, without margin: holds all leaves below */
    uint32_t child[SPH_CHILDREN]; /* n_inner node indices, then n_leaf sphere indices */
    uint8_t n_inner, n_leaf;
};

struct sph_tree {
    struct sph_tree_node *nodes; /* root first; malloc */
    uint32_t n_nodes;
    uint32_t depth; /* levels of nodes */
    uint32_t above; /* levels that will be put above: the balanced tree leaves the stack to them */
    int learns;     /* the binary tree that it is collapsed from is to be kept, */
    struct sph_split *split;        /* here; else NULL; malloc */
    const struct sph_machine *seen; /* NULL, or by whose rays that is collapsed again */
    int grows;       /* of SPH_TREE_PAPER: a node may be larger than the sphere around all */
    uint32_t rounds; /* of SPH_TREE_HW: of joining that follow the first */
    struct sph_progress progress; /* who is told how far it is, if anybody asked */
};

/* What a tree is made of. */
struct sph_plants {
    const struct sph_ball *balls; /* of every id: spheres, then facets */
    uint32_t n_spheres;
    const struct sph_facets *facets;
    const struct sph_profile *profile;
    const int32_t *eye;
    int kind;                    /* SPH_TREE_* */
    const struct sph_rays *rays; /* primary ones, in the camera's axes: for images */
};

/* A tree of all primitives by one of the builders below, planes as leaf children of the nodes
 * above; leaf children are ids. -1 if memory is out; what is in *tree then is to be freed. */
int sph_tree_build(const struct sph_plants *plants, struct sph_tree *tree, struct sph_error *err);

void sph_tree_free(struct sph_tree *tree);

/* Makes the nodes of a tree of ids smaller: around corners of triangles, not around their balls.
 * There may be no planes in it yet. -1 if memory is out. */
int sph_tree_tighten(const struct sph_plants *plants, struct sph_tree *tree, struct sph_error *err);

/* Borodavka et al. IV: sorted by z, merged by four, level by level. -1 if memory is out. */
int sph_tree_paper(const struct sph_ball *balls, uint32_t n, const struct sph_profile *profile,
                   struct sph_tree *tree, struct sph_error *err);

/* The tree of rt_build, of n spheres: build/build_tree.h. -1 if memory is out. */
int sph_tree_hardware(const struct sph_ball *balls, uint32_t n, const struct sph_profile *profile,
                      struct sph_tree *tree, struct sph_error *err);

/* Surface-area heuristic, collapsed to four children at least cost; at most SPH_STACK_DEPTH
 * levels of nodes. `eye` orders siblings near first. kind: SPH_TREE_REINSERTED: with the pairs that
 * split.h makes of them, unless that is too deep. boxes: around each, where nodes are boxes,
 * which are reinserted too; else NULL. -1 if memory is out. */
int sph_tree_balanced(const struct sph_ball *balls, const struct sph_aabb *boxes, uint32_t n,
                      const struct sph_profile *profile, const int32_t eye[3], int kind,
                      struct sph_tree *tree, struct sph_error *err);

/* Indices 0..n-1 sorted by coordinate `axis` of the centre (equal ones by index), rising or
 * falling; malloc, NULL if memory is out. */
uint32_t *sph_tree_sort(const struct sph_ball *balls, uint32_t n, int axis, int falling);

#endif
