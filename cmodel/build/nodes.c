/* nodes.c - nodes of four of a binary tree                       RTL: rtl/build/rt_build_nodes.v
 * SPDX-License-Identifier: Apache-2.0
 *
 * A node's children are at first the two halves of its pair. As long as there are fewer than four,
 * the one of the largest box is replaced by its own two halves. Inner children come first, each
 * kind in the order in which they were found; nodes are made depth first, the first child first.
 *
 * A child holds a run of places of the order, first to last. The sphere around it is made of the
 * leaves alone, so no error adds up along the levels.
 *
 * A node on level l of which more than 4^(STACK_DEPTH - l) spheres are below, so that a bad tree
 * would be too deep for the stack, is cut in halves of its run instead, and so is all below it.
 */
#include <string.h>

#include "build/build_tree.h"
#include "machine/layout.h"

/* A run of places, one cluster of the binary tree. */
struct run {
    uint32_t first, last;
    uint32_t number; /* of its pair */
    int even;        /* it is cut in halves, whatever its pair */
};

struct waiting {
    struct run run;
    uint32_t line, level;
    uint32_t parent, slot; /* which node's child it is */
};

static uint32_t spheres(const struct run *run) {
    return run->last - run->first + 1;
}

/* By which of two runs is opened first. */
static uint32_t size(const struct sph_bt_pair *pairs, const struct run *run) {
    return run->even ? spheres(run) : pairs[run->number].size;
}

static void halves(const struct sph_bt_pair *pairs, const struct run *run, struct run *left,
                   struct run *right) {
    struct run whole = *run;
    uint32_t at =
        whole.even ? whole.first + (whole.last - whole.first) / 2 : pairs[whole.number].cut;
    *left = (struct run){whole.first, at, pairs[whole.number].left, whole.even};
    *right = (struct run){at + 1, whole.last, pairs[whole.number].right, whole.even};
}

/* The runs of a node's children; returns how many. */
static int open_run(const struct sph_bt_pair *pairs, struct run run,
                    struct run child[SPH_BT_CHILDREN]) {
    int n = 1, largest = 0;
    child[0] = run;
    while (n < SPH_BT_CHILDREN && largest >= 0) {
        largest = -1;
        for (int i = 0; i < n; i++)
            if (spheres(&child[i]) > 1 &&
                (largest < 0 || size(pairs, &child[i]) > size(pairs, &child[largest])))
                largest = i;
        if (largest >= 0) halves(pairs, &child[largest], &child[largest], &child[n]), n++;
    }
    return n;
}

uint32_t sph_bt_nodes(const struct sph_bt_leaf *leaves, const uint32_t *order, uint32_t n,
                      const struct sph_bt_pair *pairs, uint32_t root,
                      const struct sph_profile *profile, struct sph_bt_node *nodes) {
    struct waiting stack[3 * SPH_STACK_DEPTH + 1];
    uint32_t waits = 1, made = 0, next = 1; /* next: the first line that is free */
    if (!n) {
        nodes[0] = (struct sph_bt_node){.base = 1};
        return 1;
    }
    stack[0] = (struct waiting){.run = {0, n - 1, root, 0}, .level = 1};
    while (waits) {
        struct waiting it = stack[--waits];
        struct sph_bt_node *node = &nodes[made];
        struct run found[SPH_BT_CHILDREN], child[SPH_BT_CHILDREN];
        if (spheres(&it.run) > 1ull << 2 * (SPH_STACK_DEPTH - it.level)) it.run.even = 1;
        int opened = open_run(pairs, it.run, found), n_children = 0;
        *node = (struct sph_bt_node){.base = next, .line = it.line};
        if (made) nodes[it.parent].child[it.slot] = made;
        for (int leaf = 0; leaf < 2; leaf++)
            for (int i = 0; i < opened; i++) {
                if ((spheres(&found[i]) == 1) != leaf) continue;
                if (leaf) node->child[n_children] = order[found[i].first];
                *(leaf ? &node->n_leaf : &node->n_inner) += 1;
                child[n_children++] = found[i];
            }
        for (int i = 0; i < n_children; i++) {
            struct sph_bt_ball ball;
            sph_bt_enclose(leaves, order, child[i].first, child[i].last, profile, &ball);
            memcpy(node->ctr[i], ball.ctr, sizeof ball.ctr);
            node->rad[i] = ball.rad;
        }
        for (uint32_t i = node->n_inner; i--;)
            stack[waits++] = (struct waiting){child[i], next + i, it.level + 1, made, i};
        next += node->n_inner + (node->n_leaf + 1u) / 2;
        made++;
    }
    return made;
}
