/* walk_boxes_avx2.c - the walk of nodes of boxes, four children at once; compiled with -mavx2, see
 * walk.h; walk_boxes.c is read beside it
 * SPDX-License-Identifier: Apache-2.0
 *
 * What planes give along a ray are products of 19 and 18 bits divided by a power of two, so that
 * doubles have them exactly; the greatest of floors is the floor of the greatest.
 */
#include "fast/decoded.h"

#ifdef __AVX2__
#include <immintrin.h>

#include "fast/keys_avx2.h"
#include "fast/setup.h"
#include "trace/bih.h"

/* An axis: distances from the origin, along the ray, become T-words. */
struct course {
    __m128i org, sign; /* -1: it runs down */
    __m128i still;     /* -1: it does not move along this axis */
    __m256d in, out;   /* factors of planes where it enters and leaves */
    __m256d none;      /* added to the bound of a plane where it leaves: 0, or what is no bound */
    int down;
};

struct lanes {
    struct course axis[3];
    __m128i lost, up;
    __m128i ordered; /* 0 if all are equally near */
    struct sph_bih_ray bih;
    int32_t depth_max; /* of limit_to() */
};

/* 2^-n of n up to 1022. */
static inline double part_of(int n) {
    union {
        uint64_t bits;
        double value;
    } x = {.bits = (uint64_t)(1023 - n) << 52};
    return x.value;
}

static inline struct lanes lanes_of(const struct sph_profile *p, const struct sph_ray *ray) {
    struct lanes l;
    sph_fast_planes(p, ray, &l.bih);
    for (int i = 0; i < 3; i++) {
        const struct sph_bih_axis *x = &l.bih.axis[i];
        int bound = !x->zero && x->shift >= 0, shift = x->shift > 0 ? x->shift : 0;
        double part = part_of(shift);
        l.axis[i] = (struct course){
            .org = _mm_set1_epi32((int32_t)ray->org[i]),
            .sign = _mm_set1_epi32(x->negative ? -1 : 0),
            .still = _mm_set1_epi32(x->zero ? -1 : 0),
            .in = _mm256_set1_pd(x->zero ? 0 : x->mant * part),
            .out = _mm256_set1_pd(bound ? (x->mant + 2.0) * part : 0),
            .none = _mm256_set1_pd(bound ? 0 : SPH_BIH_NO_BOUND),
            .down = x->negative,
        };
    }
    l.lost = _mm_cvtsi32_si128(l.bih.v_shift);
    l.up = _mm_set1_epi32((1 << l.bih.v_shift) - 1);
    l.ordered = _mm_set1_epi32(sph_ray_any(ray) ? 0 : -1);
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

/* From the origin along the ray: minus a distance where it runs down. */
static inline __m128i along(const struct course *x, __m128i plane) {
    return _mm_sub_epi32(_mm_xor_si128(_mm_sub_epi32(plane, x->org), x->sign), x->sign);
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
    const __m128i none = _mm_set1_epi32(SPH_BIH_NO_BOUND);
    __m128i missed = _mm_setzero_si128();
    __m256d low = _mm256_setzero_pd(), high = _mm256_set1_pd(SPH_BIH_NO_BOUND);
    for (int k = 0; k < 3; k++) {
        const struct course *x = &l->axis[k];
        __m128i v = along(x, planes(x->down ? b->hi[k] : b->lo[k]));
        __m128i w = along(x, planes(x->down ? b->lo[k] : b->hi[k]));
        __m128i off = _mm_and_si128(x->still, _mm_cmpgt_epi32(v, _mm_setzero_si128()));
        missed = _mm_or_si128(missed, _mm_or_si128(w, off));
        __m256d from = _mm256_cvtepi32_pd(_mm_sra_epi32(v, l->lost));
        __m256d to = _mm256_cvtepi32_pd(_mm_sra_epi32(_mm_add_epi32(w, l->up), l->lost));
        low = _mm256_max_pd(low, _mm256_mul_pd(from, x->in));
        high = _mm256_min_pd(high, _mm256_add_pd(_mm256_mul_pd(to, x->out), x->none));
    }
    low = _mm256_min_pd(low, _mm256_set1_pd(SPH_BIH_NO_BOUND));
    __m128i lo = _mm256_cvttpd_epi32(low);
    __m128i hi = _mm_add_epi32(_mm256_cvttpd_epi32(high), _mm_set1_epi32(1));
    __m128i near = depths(lo);
    missed = _mm_or_si128(_mm_srai_epi32(missed, 31), _mm_cmpgt_epi32(lo, _mm_min_epi32(hi, none)));
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
