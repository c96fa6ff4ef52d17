/* bih_refit.c - new planes for a bounding interval hierarchy; see refit.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <limits.h>

#include "builder/tree/refit.h"

static const struct sph_aabb NOTHING = {{INT32_MAX, INT32_MAX, INT32_MAX},
                                        {INT32_MIN, INT32_MIN, INT32_MIN}};

static void widen(struct sph_aabb *box, const struct sph_aabb *by) {
    for (int i = 0; i < 3; i++) {
        if (by->lo[i] < box->lo[i]) box->lo[i] = by->lo[i];
        if (by->hi[i] > box->hi[i]) box->hi[i] = by->hi[i];
    }
}

/* Planes of a node and of all below it; the box around the primitives there. An empty side has the
 * clips that no primitive is on the side of, which are the ends of NOTHING. */
static struct sph_aabb refit(const struct sph_aabb *boxes, struct sph_bih *bih, uint32_t number) {
    struct sph_bih_node *node = &bih->nodes[number];
    struct sph_aabb all = NOTHING;
    if (node->axis == SPH_BIH_LEAF) {
        for (uint32_t i = 0; i < node->count; i++)
            widen(&all, &boxes[bih->order[node->first + i]]);
        return all;
    }
    struct sph_aabb left = refit(boxes, bih, node->child), right = left;
    if (!node->fit) right = refit(boxes, bih, node->child + 1);
    node->clip_l = node->fit ? left.lo[node->axis] : left.hi[node->axis];
    node->clip_r = node->fit ? left.hi[node->axis] : right.lo[node->axis];
    all = left;
    widen(&all, &right);
    return all;
}

void sph_bih_refit(const struct sph_aabb *boxes, struct sph_bih *bih) {
    bih->box = refit(boxes, bih, 0);
}

double sph_aabb_area(const struct sph_aabb *b) {
    double x = (double)b->hi[0] - b->lo[0], y = (double)b->hi[1] - b->lo[1],
           z = (double)b->hi[2] - b->lo[2];
    return x < 0 || y < 0 || z < 0 ? 0 : x * y + y * z + z * x;
}

/* Areas of the spaces of a node and of all below it. */
static double cost(const struct sph_bih *bih, uint32_t number, struct sph_aabb space) {
    const struct sph_bih_node *node = &bih->nodes[number];
    double sum = sph_aabb_area(&space);
    if (node->axis == SPH_BIH_LEAF) return sum;
    struct sph_aabb left = space, right = space;
    if (node->fit && node->clip_l > left.lo[node->axis]) left.lo[node->axis] = node->clip_l;
    int32_t end = node->fit ? node->clip_r : node->clip_l;
    if (end < left.hi[node->axis]) left.hi[node->axis] = end;
    if (node->clip_r > right.lo[node->axis]) right.lo[node->axis] = node->clip_r;
    sum += cost(bih, node->child, left);
    return node->fit ? sum : sum + cost(bih, node->child + 1, right);
}

double sph_bih_cost(const struct sph_bih *bih) {
    double whole = sph_aabb_area(&bih->box);
    return whole > 0 ? cost(bih, 0, bih->box) / whole : 0;
}
