/* walk_avx2.c - the walk with four children at once; compiled with -mavx2, see walk.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "fast/decoded.h"

#ifdef __AVX2__
#include "fast/keys_avx2.h"
#include "fast/spheres_avx2.h"

/* A key has near without its sign: a child that is met has near <= 2^14 and, since it ends before
 * the origin otherwise, near >= -2 rad > -2^15. No child is as deep as the limit, so that what has
 * none may be deeper. */
static inline int32_t near_of(int32_t depth) {
    return depth - INT16_MIN < KEY_NONE ? depth - INT16_MIN : KEY_NONE - 1;
}

static inline unsigned children(const struct lanes *l, const struct sph_fast *f,
                                const struct sph_fast_node *n, keys *order) {
    (void)f;
    __m128i near, missed = missed_of(l, n, &near);
    *order = keys_of(_mm_xor_si128(near, _mm_set1_epi16(INT16_MIN)), missed, n);
    return leaves_of(missed, n);
}

#include "fast/spheres.h"
#include "fast/walk.h"

static struct sph_hit either(const struct sph_fast *f, const struct sph_ray *ray,
                             struct sph_counters *c, uint32_t *visits, uint32_t *errors) {
    return (sph_ray_any(ray) ? sph_fast_walk_any_avx2 : walk)(f, ray, c, visits, errors);
}

struct sph_hit (*const sph_fast_walk_avx2)(const struct sph_fast *, const struct sph_ray *,
                                           struct sph_counters *, uint32_t *, uint32_t *) = either;
#else
#include <stddef.h>

struct sph_hit (*const sph_fast_walk_avx2)(const struct sph_fast *, const struct sph_ray *,
                                           struct sph_counters *, uint32_t *, uint32_t *) = NULL;
#endif
