/* groups.c - the tree of Borodavka et al., section IV            RTL: rtl/build/rt_build_groups.v
 * SPDX-License-Identifier: Apache-2.0
 *
 * Spheres in falling order of z are merged by four, and so are the nodes of each level, until one
 * is left. A merged sphere stands on the box of its four; one that is larger than that on the box
 * of all spheres, as far as this lies on the grid, is replaced by it. Levels stand in memory from
 * the root's down, leaf records behind them: the words of `sphaera build --tree paper`, whose
 * builder is cmodel/builder/tree/paper.c.
 */
#include <string.h>

#include "build/build_tree.h"

/* Cuts off what lies beyond the grid. */
static void clip(struct sph_bt_box *box, const struct sph_profile *profile) {
    int64_t half = 1ll << (profile->w - 1);
    for (int i = 0; i < 3; i++) {
        if (box->lo[i] < -half) box->lo[i] = -half;
        if (box->hi[i] > half - 1) box->hi[i] = half - 1;
    }
}

static uint32_t fours(uint32_t n) {
    return n / 4 + (n % 4 != 0);
}

static void put(struct sph_bt_node *node, uint32_t i, uint32_t child,
                const struct sph_bt_ball *ball) {
    node->child[i] = child;
    node->rad[i] = ball->rad;
    memcpy(node->ctr[i], ball->ctr, sizeof ball->ctr);
}

uint32_t sph_bt_groups(const struct sph_bt_leaf *leaves, const uint32_t *order, uint32_t n,
                       const struct sph_profile *profile, struct sph_bt_ball *balls,
                       struct sph_bt_node *nodes) {
    int k = profile->w - profile->fw;
    uint32_t total = 0, below = n, start;
    struct sph_bt_box box = sph_bt_nothing();
    struct sph_bt_ball most;
    if (!n) {
        nodes[0] = (struct sph_bt_node){.base = 1};
        return 1;
    }
    for (uint32_t at = 0; at < n; at++)
        sph_bt_add(&box, leaves[at].ctr, leaves[at].rad, 0);
    clip(&box, profile);
    sph_bt_on_box(&box, profile, &most);
    do
        below = fours(below), total += below;
    while (below > 1);

    start = total - fours(n);
    for (uint32_t i = 0; i < fours(n); i++) {
        struct sph_bt_node *node = &nodes[start + i];
        *node = (struct sph_bt_node){.line = start + i, .base = total + 2 * i};
        box = sph_bt_nothing();
        for (uint32_t at = 4 * i; at < n && at < 4 * i + 4; at++) {
            struct sph_bt_ball ball;
            sph_bt_enclose(leaves, order, at, at, profile, &ball);
            put(node, node->n_leaf++, order[at], &ball);
            sph_bt_add(&box, leaves[order[at]].ctr, leaves[order[at]].rad, 0);
        }
        sph_bt_on_box(&box, profile, &balls[i]);
        if (balls[i].rad > most.rad) balls[i] = most;
    }
    for (below = fours(n); below > 1; below = fours(below)) {
        uint32_t children = start;
        start -= fours(below);
        for (uint32_t i = 0; i < fours(below); i++) {
            struct sph_bt_node *node = &nodes[start + i];
            *node = (struct sph_bt_node){.line = start + i, .base = children + 4 * i};
            box = sph_bt_nothing();
            for (uint32_t at = 4 * i; at < below && at < 4 * i + 4; at++) {
                put(node, node->n_inner++, children + at, &balls[at]);
                sph_bt_add(&box, balls[at].ctr, balls[at].rad, k);
            }
            sph_bt_on_box(&box, profile, &balls[i]);
            if (balls[i].rad > most.rad) balls[i] = most;
        }
    }
    return total;
}
