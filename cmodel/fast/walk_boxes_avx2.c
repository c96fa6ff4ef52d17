/* walk_boxes_avx2.c - the walk of nodes of boxes, four children at once; compiled with -mavx2, see
 * walk.h; trace/bih.c is read beside it
 * SPDX-License-Identifier: Apache-2.0
 */
#include "fast/decoded.h"

#ifdef __AVX2__
#include <immintrin.h>

#include "fast/keys_avx2.h"
#include "fast/setup.h"
#include "trace/bih.h"

struct lanes {
    struct sph_bih_ray bih;
    const struct sph_profile *p;
    const struct sph_ray *ray;
    __m128i ordered;   /* 0 if all are equally near */
    int32_t depth_max; /* of limit_to() */
};

static inline struct lanes lanes_of(const struct sph_profile *p, const struct sph_ray *ray) {
    struct lanes l = {.p = p, .ray = ray, .ordered = _mm_set1_epi32(sph_ray_any(ray) ? 0 : -1)};
    sph_bih_setup(p, ray, &l.bih);
    return l;
}

static inline int32_t limit_of(const struct lanes *l, const struct sph_ray *ray) {
    (void)ray;
    return sph_box_depth(l->bih.limit);
}

static inline int32_t depth_of(const struct lanes *l, const struct sph_profile *p,
                               const struct sph_ray *ray, uint64_t key) {
    (void)p, (void)ray;
    return sph_box_depth(sph_bih_time(&l->bih, key));
}

/* A depth of boxes has 15 bits. */
static inline int32_t near_of(int32_t depth) {
    return depth;
}

static inline __m128i planes(const int32_t at[4]) {
    return _mm_load_si128((const __m128i *)(const void *)at);
}

/* sph_box_depth(): as a float has exponent and fraction. */
static inline __m128i depths(__m128i time) {
    enum { FRACTION = 23, BIAS = 127 };
    __m128i code = _mm_srli_epi32(_mm_castps_si128(_mm_cvtepi32_ps(time)), FRACTION - SPH_BOX_NEAR);
    code = _mm_sub_epi32(code, _mm_set1_epi32((BIAS + SPH_BOX_NEAR - 1) << SPH_BOX_NEAR));
    __m128i small = _mm_cmplt_epi32(time, _mm_set1_epi32(1 << SPH_BOX_NEAR));
    return _mm_blendv_epi8(code, time, small);
}

static inline void limit_to(struct lanes *l, int32_t depth_max) {
    l->depth_max = depth_max;
}

/* sph_box_meets() of four children. */
static inline unsigned children(const struct lanes *l, const struct sph_fast *f,
                                const struct sph_fast_node *n, keys *order) {
    const struct sph_fast_boxes *b = &f->boxes[n - f->nodes];
    const __m128i beyond = _mm_set1_epi32(SPH_BIH_NO_BOUND + 1);
    struct sph_box_axis axes[3];
    __m128i lo = _mm_setzero_si128(), hi = _mm_set1_epi32(INT32_MAX);
    sph_box_axes(l->p, &l->bih, l->ray, &b->frame, axes);
    for (int k = 0; k < 3; k++) {
        const struct sph_box_axis *x = &axes[k];
        __m128i codes = _mm_set1_epi32(x->back ? SPH_BOX_CODES - 1 : 0);
        const __m128i fine = _mm_cvtsi32_si128(x->fine);
        __m128i in = _mm_xor_si128(planes(x->back ? b->hi[k] : b->lo[k]), codes);
        __m128i out = _mm_xor_si128(planes(x->back ? b->lo[k] : b->hi[k]), codes);
        in = _mm_add_epi32(_mm_set1_epi32(x->enter),
                           _mm_srl_epi32(_mm_mullo_epi32(in, _mm_set1_epi32(x->step)), fine));
        out = _mm_add_epi32(_mm_set1_epi32(x->leave),
                            _mm_srl_epi32(_mm_mullo_epi32(out, _mm_set1_epi32(x->step + 2)), fine));
        if (x->flat) in = _mm_or_si128(in, beyond); /* what is below 0 stays so */
        if (x->open) out = _mm_or_si128(out, beyond);
        lo = _mm_max_epi32(lo, in);
        hi = _mm_min_epi32(hi, out);
    }
    __m128i near = depths(_mm_andnot_si128(beyond, lo));
    __m128i missed = _mm_cmpgt_epi32(lo, _mm_min_epi32(hi, _mm_set1_epi32(SPH_BIH_NO_BOUND)));
    missed = _mm_or_si128(missed, _mm_cmpgt_epi32(near, _mm_set1_epi32(l->depth_max)));
    missed = _mm_packs_epi32(missed, no_keys());
    near = _mm_and_si128(near, l->ordered);
    *order = keys_of(_mm_packs_epi32(near, near), missed, n);
    return leaves_of(missed, n);
}

#include "fast/walk.h"

struct sph_hit (*const sph_fast_walk_boxes_avx2)(const struct sph_fast *, const struct sph_ray *,
                                                 struct sph_counters *, uint32_t *,
                                                 uint32_t *) = walk;
#else
struct sph_hit (*const sph_fast_walk_boxes_avx2)(const struct sph_fast *, const struct sph_ray *,
                                                 struct sph_counters *, uint32_t *,
                                                 uint32_t *) = NULL;
#endif
