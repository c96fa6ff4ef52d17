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
    __m128i ordered;   /* 0 if all are equally near */
    int32_t depth_max; /* of limit_to() */
    int back[3];       /* all ones or 0 */
    /* of axes 0..2: what of struct sph_box_axis asks for no frame */
    __m128i org, shift, mant, runs; /* runs back: all ones, else 0 */
    __m128i codes;                  /* what turns planes round */
    __m128i none, flat, open;       /* flat: -1; SPH_BOX_BEYOND if it is flat, if it is open */
    __m256i wide;                   /* mant, 64 bits each */
    __m128i lost;                   /* bits of 32 above W+2 */
};

/* Words of the axes of a ray in the frame of a node, as sph_box_axes() has them. */
struct axes {
    __m128i enter, leave, step, fine, open;
};

enum { MOST = 62 }; /* of shifts: products are below 2^45 */

static inline __m128i four(const int32_t at[4]) {
    return _mm_loadu_si128((const void *)at);
}

static inline struct lanes lanes_of(const struct sph_profile *p, const struct sph_ray *ray) {
    struct lanes l = {.ordered = _mm_set1_epi32(sph_ray_any(ray) ? 0 : -1)};
    int32_t org[4] = {0}, shift[4] = {0}, mant[4] = {0}, back[4] = {0};
    int32_t flat[4] = {0}, open[4] = {0};
    sph_bih_setup(p, ray, &l.bih);
    for (int i = 0; i < 3; i++) {
        const struct sph_bih_axis *x = &l.bih.axis[i];
        int s = (x->shift > 0 ? x->shift : 0) + l.bih.v_shift;
        org[i] = (int32_t)ray->org[i];
        shift[i] = s < MOST ? s : MOST;
        mant[i] = (int32_t)x->mant;
        l.back[i] = back[i] = -x->negative;
        flat[i] = -x->zero;
        open[i] = -(x->zero || x->shift < 0);
    }
    l.org = four(org), l.shift = four(shift), l.mant = four(mant);
    l.runs = four(back), l.none = four(flat);
    l.codes = _mm_and_si128(l.runs, _mm_set1_epi32(SPH_BOX_CODES - 1));
    l.flat = _mm_and_si128(l.none, _mm_set1_epi32(SPH_BOX_BEYOND));
    l.open = _mm_and_si128(four(open), _mm_set1_epi32(SPH_BOX_BEYOND));
    l.wide = _mm256_cvtepu32_epi64(l.mant);
    l.lost = _mm_cvtsi32_si128(32 - (p->w + 2));
    return l;
}

/* The step of an axis stands behind the origins, a byte each. */
static inline struct axes axes_of(const struct lanes *l, const struct sph_box_frame *frame) {
    enum { NONE = -1 };
    _Static_assert(sizeof *frame == sizeof(__m128i), "a frame is read at once");
    const __m128i place = _mm_setr_epi8(12, NONE, NONE, NONE, 13, NONE, NONE, NONE, 14, NONE, NONE,
                                        NONE, NONE, NONE, NONE, NONE);
    const __m128i fine_most = _mm_set1_epi32(SPH_BOX_FINE);
    const __m256i bias = _mm256_set1_epi64x(1ll << MOST);
    const __m256i least = _mm256_set1_epi64x(-SPH_BOX_FRAME_T);
    const __m256i most = _mm256_set1_epi64x(SPH_BOX_BEYOND);
    const __m256i low = _mm256_setr_epi32(0, 2, 4, 6, 0, 0, 0, 0);
    const __m128i all = _mm_set1_epi32(-1), beyond = _mm_set1_epi32(SPH_BOX_BEYOND);
    __m128i org = _mm_loadu_si128((const void *)frame);
    __m128i s = _mm_shuffle_epi8(org, place);
    __m128i steep = _mm_xor_si128(_mm_cmpgt_epi32(l->shift, s), all);
    __m128i shift = _mm_blendv_epi8(l->shift, _mm_sub_epi32(s, all), steep);
    __m128i v = _mm_sub_epi32(org, l->org);
    __m128i size = _mm_sllv_epi32(_mm_set1_epi32(SPH_BOX_CODES), s);
    v = _mm_add_epi32(v, _mm_and_si128(l->runs, size));
    v = _mm_sub_epi32(_mm_xor_si128(v, l->runs), l->runs);
    v = _mm_sra_epi32(_mm_sll_epi32(v, l->lost), l->lost);
    /* shifted as unsigned, 2^MOST above */
    __m256i at = _mm256_mul_epi32(_mm256_cvtepi32_epi64(v), l->wide);
    __m256i by = _mm256_cvtepu32_epi64(shift);
    at = _mm256_srlv_epi64(_mm256_add_epi64(at, bias), by);
    at = _mm256_sub_epi64(at, _mm256_srlv_epi64(bias, by));
    at = _mm256_blendv_epi8(at, most, _mm256_cmpgt_epi64(at, most));
    at = _mm256_blendv_epi8(at, least, _mm256_cmpgt_epi64(least, at));
    __m128i begin = _mm256_castsi256_si128(_mm256_permutevar8x32_epi32(at, low));
    __m128i below = _mm_srai_epi32(begin, 31), rest = _mm_srai_epi32(begin, SPH_BOX_EXACT);
    __m128i over = _mm_sub_epi32(shift, s);
    struct axes x = {.fine = _mm_and_si128(_mm_cmpgt_epi32(over, fine_most), fine_most),
                     .open = _mm_or_si128(l->open, _mm_and_si128(steep, beyond))};
    x.step = _mm_srlv_epi32(l->mant, _mm_sub_epi32(over, x.fine));
    x.enter = _mm_add_epi32(_mm_add_epi32(begin, _mm_and_si128(below, rest)), l->none);
    x.leave = _mm_add_epi32(_mm_add_epi32(begin, _mm_andnot_si128(below, rest)),
                            _mm_add_epi32(_mm_srlv_epi32(x.step, x.fine), _mm_set1_epi32(5)));
    return x;
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

/* sph_box_meets() of four children, along axis k. */
#define ALONG(word, k) _mm_shuffle_epi32(word, 0x55 * (k))
#define MEET(k)                                                                                    \
    do {                                                                                           \
        const __m128i fine = ALONG(x.fine, k), step = ALONG(x.step, k);                            \
        const __m128i codes = ALONG(l->codes, k);                                                  \
        __m128i in = _mm_xor_si128(four(l->back[k] ? b->hi[k] : b->lo[k]), codes);                 \
        __m128i out = _mm_xor_si128(four(l->back[k] ? b->lo[k] : b->hi[k]), codes);                \
        in = _mm_srlv_epi32(_mm_mullo_epi32(in, step), fine);                                      \
        out = _mm_srlv_epi32(_mm_mullo_epi32(out, _mm_add_epi32(step, two)), fine);                \
        in = _mm_add_epi32(in, ALONG(x.enter, k));                                                 \
        out = _mm_add_epi32(out, ALONG(x.leave, k));                                               \
        in = _mm_or_si128(in, ALONG(l->flat, k)); /* what is below 0 stays so */                   \
        out = _mm_or_si128(out, ALONG(x.open, k));                                                 \
        lo = _mm_max_epi32(lo, in);                                                                \
        hi = _mm_min_epi32(hi, out);                                                               \
    } while (0)

/* sph_box_meets() of four children. */
static inline unsigned children(const struct lanes *l, const struct sph_fast *f,
                                const struct sph_fast_node *n, keys *order) {
    const struct sph_fast_boxes *b = &f->boxes[n - f->nodes];
    const __m128i beyond = _mm_set1_epi32(SPH_BOX_BEYOND), two = _mm_set1_epi32(2);
    __m128i lo = _mm_setzero_si128(), hi = _mm_set1_epi32(INT32_MAX);
    const struct axes x = axes_of(l, &b->frame);
    MEET(0);
    MEET(1);
    MEET(2);
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
