/* chain.c - neighbours of an order joined to a binary tree       RTL: rtl/build/rt_build_chain.v
 * SPDX-License-Identifier: Apache-2.0
 *
 * Of a row of clusters, at first one for each sphere, those two neighbours are joined whose common
 * box is smaller than that of either with its other neighbour. A cluster that grows only makes
 * boxes larger, so in whatever order such pairs are joined, the tree is the same (a linkage that is
 * reducible; Murtagh 1983). So one walk along the row is enough. Clusters that wait stand on two
 * stacks, `behind` and `ahead` of the place that is looked at:
 *
 *     behind: .. q p | x .. ahead, then spheres that nobody has looked at
 *
 * Boxes of neighbours become smaller along `behind`. If that of p and x is still smaller, x is put
 * there too; if not, q and p are joined, and what becomes of them is looked at again with what is
 * below it. Each step either joins two or puts one behind, so there are at most 3n steps.
 *
 * Both stacks together hold BUILD_STACK clusters: no sphere is taken with the last place, q and p
 * are joined instead.
 */
#include <stddef.h>

#include "build/build_tree.h"
#include "machine/layout.h"

struct cluster {
    int32_t lo[3], hi[3]; /* box, grid units */
    uint32_t number;      /* of the pair */
    uint32_t last;        /* place */
    uint32_t size;        /* behind: of the box around it and what is below it */
};

static struct cluster sphere(const struct sph_bt_leaf *leaf, uint32_t place) {
    struct cluster c = {.number = place, .last = place};
    for (int i = 0; i < 3; i++) {
        c.lo[i] = leaf->ctr[i] - leaf->rad;
        c.hi[i] = leaf->ctr[i] + leaf->rad;
    }
    return c;
}

/* The box around both, of the right one's places; its size. */
static uint32_t join(const struct cluster *left, const struct cluster *right, struct cluster *to) {
    uint32_t size = 0;
    *to = *right;
    for (int i = 0; i < 3; i++) {
        if (left->lo[i] < to->lo[i]) to->lo[i] = left->lo[i];
        if (left->hi[i] > to->hi[i]) to->hi[i] = left->hi[i];
        size += (uint32_t)(to->hi[i] - to->lo[i]);
    }
    return size;
}

uint32_t sph_bt_chain(const struct sph_bt_leaf *leaves, const uint32_t *order, uint32_t n,
                      struct sph_bt_pair *pairs) {
    struct cluster stack[SPH_BUILD_STACK], x, both;
    uint32_t behind = 0, ahead = 0, taken = 0; /* ahead: down from the stack's end */
    while (taken < n || ahead || behind > 1) {
        int any = 1;
        struct cluster *p = behind ? &stack[behind - 1] : NULL, *q = behind > 1 ? p - 1 : NULL;
        if (ahead)
            x = stack[SPH_BUILD_STACK - ahead];
        else if (taken < n)
            x = sphere(&leaves[order[taken]], taken);
        else
            any = 0;
        uint32_t size = p && any ? join(p, &x, &both) : 0;
        int full = !ahead && behind == SPH_BUILD_STACK;
        if (q && (!any || p->size <= size || full)) {
            pairs[q->last] = (struct sph_bt_pair){q->number, p->number, p->size};
            uint32_t number = q->last;
            join(q, p, &both);
            both.number = number;
            behind -= 2;
            stack[SPH_BUILD_STACK - ++ahead] = both;
        } else {
            x.size = size;
            if (ahead)
                ahead--;
            else
                taken++;
            stack[behind++] = x;
        }
    }
    return n > 1 ? stack[0].number : 0;
}
