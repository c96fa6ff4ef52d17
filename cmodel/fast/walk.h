/* walk.h - the walk of walk_plain.c, walk_avx2.c and walk_boxes.c, which define the lanes before
 * SPDX-License-Identifier: Apache-2.0
 *
 * Asked for: `struct lanes`, what of a ray the tests need, made by lanes_of(); limit_of() and
 * depth_of(), how deep a ray goes at first and to a key; limit_to(), which tells the lanes so;
 * children(), which tests those of a node, leaves `keys` of the inner ones that are met and returns
 * the leaves of them, bit 2 i of child i; any(), whether a key is left; first(), the least, and of
 * equal ones that of the first child; is_child(), whether it is that child's and of none before;
 * within(), whether there is one no deeper than near_of() of a depth; without(), the others. The
 * rest is sph_traverse() line by line.
 */
#include <stddef.h>

#include "fast/decoded.h"
#include "fast/leaf.h"

/* Siblings to visit: sph_siblings, with child 0 as their base. */
struct group {
    keys order;
    const struct sph_fast_node *base;
};

/* The child of a key. A branch for each: the processor guesses which child is next and goes on with
 * it, and does not wait for the tests that say so; sums would make it wait. To the compiler the
 * nodes are unknown, else it made sums of the branches. */
static inline const struct sph_fast_node *guessed(const struct sph_fast_node *base, int32_t key) {
    if (is_child(key, 0)) return base;
    if (is_child(key, 1)) {
        base += 1;
        __asm__("" : "+r"(base));
    } else if (is_child(key, 2)) {
        base += 2;
        __asm__("" : "+r"(base));
    } else {
        base += 3;
        __asm__("" : "+r"(base));
    }
    return base;
}

static struct sph_hit walk(const struct sph_fast *f, const struct sph_ray *ray,
                           struct sph_counters *c, uint32_t *visits, uint32_t *errors) {
    struct sph_ray_query query = sph_fast_ray_query(f, ray, c, errors);
    const struct sph_hit *best = &query.best;
    struct lanes lanes = lanes_of(query.p, ray);
    const struct sph_fast_node *n = f->nodes + f->root;
    struct group now, stack[SPH_STACK_DEPTH], *top = stack;
    int ends = sph_ray_any(ray);
    int32_t depth_max = limit_of(&lanes, ray), deepest = near_of(depth_max);
    uint32_t left = f->visit_limit, tests = 0, leaf_tests = 0;
    now.order = no_keys();
    limit_to(&lanes, depth_max);

    for (;;) {
        if (!left) {
            *errors |= 1u << SPH_ERROR_VISIT_LIMIT;
            break;
        }
        left--;
        keys order;
        unsigned leaves = children(&lanes, f, n, &order);
        tests += n->tests;
        if (leaves) {
            uint64_t key_before = best->key;
            do {
                uint32_t leaf = n->leaf + ((unsigned)__builtin_ctz(leaves) >> 1);
                leaf_tests += !f->leaves[leaf].record;
                sph_fast_visit(&query, f, leaf);
                leaves &= leaves - 1;
            } while (leaves);
            if (best->key != key_before) {
                if (ends) break;
                depth_max = depth_of(&lanes, query.p, ray, best->key);
                deepest = near_of(depth_max);
                limit_to(&lanes, depth_max);
            }
        }
        int32_t key = first(order);
        if (within(key, deepest)) {
            if (any(now.order)) {
                if (top == stack + SPH_STACK_DEPTH) {
                    *errors |= 1u << SPH_ERROR_STACK_OVERFLOW;
                    break;
                }
                *top++ = now;
            }
            now.order = order;
            now.base = f->nodes + n->inner;
            n = guessed(now.base, key);
        } else {
            if (n->bad) {
                *errors |= 1u << SPH_ERROR_BAD_NODE;
                break;
            }
            key = first(now.order);
            while (!within(key, deepest) && top > stack) {
                now = *--top;
                key = first(now.order);
            }
            if (!within(key, deepest)) break;
            n = guessed(now.base, key);
        }
        now.order = without(now.order, key);
    }
    uint32_t visited = f->visit_limit - left;
    *visits += visited;
    c->count[SPH_COUNT_NODE_VISITS] += visited;
    c->count[SPH_COUNT_CHILD_TESTS] += tests;
    c->count[SPH_COUNT_LEAF_TESTS] += leaf_tests;
    return *best;
}
