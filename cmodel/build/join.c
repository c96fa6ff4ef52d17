/* join.c - spheres that are near on a curve joined to a tree      RTL: rtl/build/rt_build_join.v
 * SPDX-License-Identifier: Apache-2.0
 *
 * Clusters stand in a row, at first one for each sphere. In a pass over the row each finds the
 * nearest of the BUILD_WINDOW on either side of it; two that find each other are joined, and stand
 * where the left one stood (PLOC; Meister and Bittner 2018). Passes follow until one is left.
 *
 * How far two are apart is the longest edge of the box around both. Boxes have sides of BUILD_SIDE
 * bits: what is cut off changes which tree is made, not what its spheres hold. Of equal distances
 * the lesser number of places between counts, and of two neighbours as many places to the left and
 * to the right one of the two pairs has an even place, in units of the power of two of that number,
 * and comes first. So no two pairs of one cluster are equal, and the least of all is joined.
 *
 * If fewer than one cluster in eight has gone in a pass, all distances are 0 in the next one, which
 * joins every two: however spheres lie, n of them take no more than a fixed multiple of n steps.
 *
 * Leaves of a cluster are a list: joining links the left one's last to the right one's first. The
 * list of the root is the order of the tree.
 */
#include <stdlib.h>

#include "build/build_tree.h"
#include "machine/layout.h"

enum { FEW = 8 }; /* one of so many */

struct cluster {
    int32_t lo[3], hi[3];        /* box */
    uint32_t number, head, tail; /* of the pair; its first and last sphere */
};

/* The box around both; its longest edge. */
static uint32_t around(const struct cluster *a, const struct cluster *b, struct cluster *to) {
    uint32_t longest = 0;
    for (int i = 0; i < 3; i++) {
        to->lo[i] = a->lo[i] < b->lo[i] ? a->lo[i] : b->lo[i];
        to->hi[i] = a->hi[i] > b->hi[i] ? a->hi[i] : b->hi[i];
        uint32_t edge = (uint32_t)(to->hi[i] - to->lo[i]);
        if (edge > longest) longest = edge;
    }
    return longest;
}

/* The nearest of cluster i: how many places on, below 0 if to the left; 0 if it is alone. */
static int nearest(const struct cluster *row, uint32_t m, uint32_t i, int even) {
    uint32_t least = UINT32_MAX;
    int found = 0;
    for (int k = 1; k <= SPH_BUILD_WINDOW; k++) {
        int left_first = i & (uint32_t)(k & -k) ? -k : k; /* of equal ones */
        for (int side = 0; side < 2; side++) {
            int to = side ? -left_first : left_first;
            if (to < 0 ? i < (uint32_t)k : i + (uint32_t)k >= m) continue;
            struct cluster unused;
            uint32_t apart = even ? 0 : around(&row[i], &row[(int64_t)i + to], &unused);
            if (apart < least) least = apart, found = to;
        }
    }
    return found;
}

int sph_bt_join(const struct sph_bt_leaf *leaves, uint32_t n, const struct sph_profile *profile,
                uint32_t *order, struct sph_bt_pair *pairs, uint32_t *root) {
    struct cluster *row = malloc((n + 1ull) * sizeof *row);
    int8_t *to = malloc(n + 1ull);
    uint32_t *next = malloc((n + 1ull) * sizeof *next), m = n;
    int made = row && to && next, even = 0;
    int cut = profile->w + 2 > SPH_BUILD_SIDE ? profile->w + 2 - SPH_BUILD_SIDE : 0;
    for (uint32_t i = 0; made && i < n; i++) {
        const struct sph_bt_leaf *leaf = &leaves[order[i]];
        row[i].number = row[i].head = row[i].tail = order[i];
        for (int j = 0; j < 3; j++) {
            row[i].lo[j] = (leaf->ctr[j] - leaf->rad) >> cut;
            row[i].hi[j] = (leaf->ctr[j] + leaf->rad) >> cut;
        }
    }
    while (made && m > 1) {
        uint32_t left = 0;
        for (uint32_t i = 0; i < m; i++)
            to[i] = (int8_t)nearest(row, m, i, even);
        for (uint32_t i = 0; i < m; i++) {
            struct cluster it = row[i], *other = &row[(int64_t)i + to[i]];
            if (to[(int64_t)i + to[i]] == -to[i]) {
                if (to[i] < 0) continue;
                pairs[it.tail].left = it.number, pairs[it.tail].right = other->number;
                pairs[it.tail].size = around(&it, other, &it);
                next[it.tail] = other->head;
                it.number = it.tail, it.tail = other->tail;
            }
            row[left++] = it;
        }
        even = !even && left > m - m / FEW;
        m = left;
    }
    if (made && n) {
        *root = row[0].number;
        uint32_t id = row[0].head;
        for (uint32_t place = 0; place < n; place++) {
            order[place] = id;
            pairs[id].cut = place;
            if (id != row[0].tail) id = next[id];
        }
    }
    free(row);
    free(to);
    free(next);
    return made ? 0 : -1;
}
