/* walk_any_avx2.c - the same walk of rays that take children in the node's order
 * SPDX-License-Identifier: Apache-2.0
 */
#ifdef __AVX2__
#include "fast/spheres_avx2.h"

/* Bit 2 i: child i is to be visited. A key is those that are left. */
typedef unsigned keys;

static inline keys no_keys(void) {
    return 0;
}

static inline int any(keys k) {
    return k != 0;
}

static inline int32_t first(keys k) {
    return (int32_t)k;
}

static inline int is_child(int32_t key, int i) {
    return key >> 2 * i & 1;
}

/* All are equally near. */
static inline int32_t near_of(int32_t depth) {
    return depth;
}

static inline int within(int32_t key, int32_t near) {
    (void)near;
    return key != 0;
}

static inline keys without(keys k, int32_t key) {
    (void)key;
    return k & (k - 1);
}

static inline unsigned children(const struct lanes *l, const struct sph_fast *f,
                                const struct sph_fast_node *n, keys *order) {
    (void)f;
    __m128i near, missed = missed_of(l, n, &near);
    unsigned met = ~(unsigned)_mm_movemask_epi8(missed) & 0x55, leaves = met & n->leaves;
    *order = met ^ leaves;
    return leaves;
}

#include "fast/spheres.h"
#include "fast/walk.h"

struct sph_hit sph_fast_walk_any_avx2(const struct sph_fast *f, const struct sph_ray *ray,
                                      struct sph_counters *c, uint32_t *visits, uint32_t *errors) {
    return walk(f, ray, c, visits, errors);
}
#endif
