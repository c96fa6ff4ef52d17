/* paper.c - the tree of Borodavka et al., section IV, in exact integers
 * SPDX-License-Identifier: Apache-2.0
 *
 * Spheres sorted near to far by the z of their centres, merged by four in that order, level by
 * level. A merged sphere stands on the box of its four; a sphere larger than the one on the box
 * of all spheres is replaced by that one. Each radius is rounded up to filter units.
 */
#include <stdlib.h>

#include "builder/tree/radix.h"
#include "builder/tree/tree.h"

struct box {
    int64_t lo[3], hi[3]; /* grid units */
};

static const struct box EMPTY = {{INT64_MAX, INT64_MAX, INT64_MAX},
                                 {INT64_MIN, INT64_MIN, INT64_MIN}};

/* Grows the box to hold a sphere; unit is the sphere's unit in grid units. */
static void box_add(struct box *box, const struct sph_ball *ball, int64_t unit) {
    for (int i = 0; i < 3; i++) {
        int64_t lo = (ball->c[i] - (int64_t)ball->r) * unit;
        int64_t hi = (ball->c[i] + (int64_t)ball->r) * unit;
        if (lo < box->lo[i]) box->lo[i] = lo;
        if (hi > box->hi[i]) box->hi[i] = hi;
    }
}

/* Cuts off what lies outside of the grid: balls of triangles may reach there, triangles do not. */
static void clip(struct box *box, const struct sph_profile *profile) {
    int64_t half = 1ll << (profile->w - 1);
    for (int i = 0; i < 3; i++) {
        if (box->lo[i] < -half) box->lo[i] = -half;
        if (box->hi[i] > half - 1) box->hi[i] = half - 1;
    }
}

/* The sphere on a box: centre C = (near + far)/2 in filter units, R to the farthest corner. */
static struct sph_ball box_ball(const struct box *box, const struct sph_profile *profile) {
    int k = profile->w - profile->fw;
    struct sph_ball corner = {.r = 0}, out;
    for (int i = 0; i < 3; i++) {
        int64_t centre = (box->lo[i] + box->hi[i]) >> 1;
        out.c[i] = sph_filter_coord(centre, profile);
        int64_t c = (int64_t)out.c[i] * (1ll << k);
        corner.c[i] = (int32_t)(c - box->lo[i] > box->hi[i] - c ? box->lo[i] : box->hi[i]);
    }
    out.r = sph_filter_radius(out.c, &corner, k);
    return out;
}

uint32_t *sph_tree_sort(const struct sph_ball *balls, uint32_t n, int axis, int falling) {
    uint64_t *keys = malloc((2ull * n + 1) * sizeof *keys);
    uint32_t *order = malloc((n + 1ull) * sizeof *order);
    if (keys && order) {
        for (uint32_t i = 0; i < n; i++) {
            int64_t v = falling ? -(int64_t)balls[i].c[axis] : balls[i].c[axis];
            keys[i] = (uint64_t)(v + (1ll << 30)) << 32 | i;
        }
        const uint64_t *sorted = sph_radix(keys, keys + n, n);
        for (uint32_t i = 0; i < n; i++)
            order[i] = (uint32_t)sorted[i];
    } else {
        free(order);
        order = NULL;
    }
    free(keys);
    return order;
}

/* Merges children first..first+count-1 of the level below (spheres through `order` if lowest). */
static void merge(struct sph_tree *tree, struct sph_tree_node *node, uint32_t first, uint32_t count,
                  const uint32_t *order, const struct sph_ball *balls,
                  const struct sph_profile *profile) {
    struct box box = EMPTY;
    for (uint32_t i = 0; i < count; i++) {
        uint32_t child = order ? order[first + i] : first + i;
        node->child[i] = child;
        if (order)
            box_add(&box, &balls[child], 1);
        else
            box_add(&box, &tree->nodes[child].ball, 1ll << (profile->w - profile->fw));
    }
    *(order ? &node->n_leaf : &node->n_inner) = (uint8_t)count;
    node->ball = box_ball(&box, profile);
}

int sph_tree_paper(const struct sph_ball *balls, uint32_t n, const struct sph_profile *profile,
                   struct sph_tree *tree, struct sph_error *err) {
    uint32_t size[20], levels = 0, total = 0;
    for (uint32_t below = n;; below = size[levels - 1]) {
        size[levels] = below ? (below + 3) / 4 : 1;
        total += size[levels];
        if (size[levels++] == 1) break;
    }
    uint32_t *order = sph_tree_sort(balls, n, 2, 1);
    tree->nodes = calloc(total, sizeof *tree->nodes);
    if (!order || !tree->nodes) {
        free(order);
        return sph_fail(err, "out of memory for a tree of %u spheres", n);
    }
    tree->n_nodes = total;
    tree->depth = levels;

    struct box box = EMPTY;
    for (uint32_t i = 0; i < n; i++)
        box_add(&box, &balls[i], 1);
    struct sph_ball most = {.r = 0};
    clip(&box, profile);
    if (n) most = box_ball(&box, profile);

    uint32_t start = total, below_start = 0, below = n;
    for (uint32_t level = 0; level < levels && n; level++) {
        start -= size[level]; /* the root level comes first in memory */
        for (uint32_t i = 0; i < size[level]; i++) {
            struct sph_tree_node *node = &tree->nodes[start + i];
            uint32_t count = below - 4 * i < 4 ? below - 4 * i : 4;
            merge(tree, node, below_start + 4 * i, count, level ? NULL : order, balls, profile);
            if (node->ball.r > most.r && !tree->grows) node->ball = most;
        }
        below_start = start, below = size[level];
    }
    free(order);
    return 0;
}
