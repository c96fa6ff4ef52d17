/* tighten.c - nodes around the corners of triangles, and around what moved; see tree.h,
 * refit.h SPDX-License-Identifier: Apache-2.0
 *
 * The ball around a triangle reaches far over its sides. A tree is built of such balls, but what a
 * node must hold are the corners: its ball is made again around all of them below it. A tree that
 * is refitted gets every ball in this way.
 */
#include <math.h>
#include <stdlib.h>

#include "builder/tree/refit.h"
#include "builder/prim/build.h"
#include "machine/records.h"

struct work {
    const struct sph_plants *plants;
    struct sph_tree *tree;
    struct sph_ball *points; /* spheres, and corners as balls without radius */
    uint32_t *index;         /* 0, 1, 2, .. */
    uint32_t n;              /* points of the nodes that are being visited */
    int refit;               /* balls are replaced in any case, and children sorted */
};

static struct sph_grid_prim prim_of(const struct sph_plants *p, uint32_t id) {
    return sph_grid_prim_of(p->balls, p->n_spheres, p->facets, id);
}

/* Appends what a leaf consists of. 1 if it has no bounds. */
static int add_leaf(struct work *w, uint32_t id) {
    struct sph_grid_prim prim = prim_of(w->plants, id);
    const struct sph_prim_build *kind = sph_prim_build_of(prim.kind);
    if (!sph_kind_unbounded(prim.kind)) w->n += (uint32_t)kind->hull(&prim, &w->points[w->n]);
    return sph_kind_unbounded(prim.kind);
}

/* How far from the eye a point is, in grid units; squared. */
static double far(const struct work *w, const int32_t c[3], int k) {
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        double d = ldexp(c[i], k) - w->plants->eye[i];
        sum += d * d;
    }
    return sum;
}

static double child_far(const struct work *w, const struct sph_tree_node *node, int i) {
    const struct sph_profile *p = w->plants->profile;
    if (i < node->n_inner) return far(w, w->tree->nodes[node->child[i]].ball.c, p->w - p->fw);
    return far(w, prim_of(w->plants, node->child[i]).ball->c, 0);
}

/* Sorts children first .. end-1, near first. */
static void sort(const struct work *w, struct sph_tree_node *node, int first, int end) {
    for (int i = first + 1; i < end; i++)
        for (int at = i; at > first && child_far(w, node, at) < child_far(w, node, at - 1); at--) {
            uint32_t swap = node->child[at];
            node->child[at] = node->child[at - 1];
            node->child[at - 1] = swap;
        }
}

/* Appends all that is below a node, whose ball is replaced if another one is smaller, or in any
 * case. 1 if something there has no bounds: the node holds the whole grid. */
static int visit(struct work *w, uint32_t number) {
    struct sph_tree_node *node = &w->tree->nodes[number];
    uint32_t first = w->n;
    int loose = 0, n = node->n_inner + node->n_leaf;
    for (int i = 0; i < node->n_inner; i++)
        loose |= visit(w, node->child[i]);
    for (int i = node->n_inner; i < n; i++)
        loose |= add_leaf(w, node->child[i]);
    if (loose) {
        node->ball = sph_filter_whole(w->plants->profile);
    } else if (w->n > first) {
        struct sph_ball ball =
            sph_filter_enclose(w->points + first, w->index, w->n - first, w->plants->profile);
        if (w->refit || ball.r < node->ball.r) node->ball = ball;
    }
    if (w->refit && !loose) {
        sort(w, node, 0, node->n_inner);
        sort(w, node, node->n_inner, n);
    }
    return loose;
}

static int work(const struct sph_plants *p, struct sph_tree *tree, int refit,
                struct sph_error *err) {
    uint64_t most = p->n_spheres + 3ull * p->facets->n;
    struct work w = {.plants = p,
                     .tree = tree,
                     .points = malloc((most + 1) * sizeof *w.points),
                     .index = malloc((most + 1) * sizeof *w.index),
                     .refit = refit};
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

int sph_tree_tighten(const struct sph_plants *p, struct sph_tree *tree, struct sph_error *err) {
    return p->facets->n == p->facets->n_loose ? 0 : work(p, tree, 0, err);
}

int sph_tree_refit(const struct sph_plants *p, struct sph_tree *tree, struct sph_error *err) {
    return work(p, tree, 1, err);
}
