/* sorted.h - inner children to visit as a sorted list; what walk.h asks of keys
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FAST_SORTED_H
#define SPH_FAST_SORTED_H

#include "fast/decoded.h"
#include "trace/order.h"

enum { KEY_NONE = INT32_MAX };

/* near * 4 + child */
typedef struct {
    int32_t at[4];
} keys;

static keys no_keys(void) {
    return (keys){{KEY_NONE, KEY_NONE, KEY_NONE, KEY_NONE}};
}

static int32_t first(keys k) {
    return k.at[0];
}

static int any(keys k) {
    return first(k) != KEY_NONE;
}

static int is_child(int32_t key, int i) {
    return (key & 3) == i;
}

static int within(int32_t key, int32_t near) {
    return key <= near;
}

static int32_t near_of(int32_t depth) {
    return depth * 4 + 3;
}

/* They are sorted, and the key is the first one. */
static keys without(keys k, int32_t key) {
    (void)key;
    return (keys){{k.at[1], k.at[2], k.at[3], KEY_NONE}};
}

/* Those of the children met, bit 2 i of child i, of a node that are nodes. */
static keys sorted(const struct sph_fast_node *n, unsigned met, const int32_t near[4], int any) {
    keys order = no_keys();
    int count = 0;
    for (int i = 0; i < n->n_inner; i++) {
        if (!(met >> 2 * i & 1)) continue;
        int32_t key = sph_child_depth(any, near[i], i) * 4 + i;
        int at = count++;
        for (; at > 0 && key < order.at[at - 1]; at--)
            order.at[at] = order.at[at - 1];
        order.at[at] = key;
    }
    return order;
}

#endif
