/* prepare_avx2.c - set-up of four rays at once, compiled with -mavx2: the numbers of setup.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "fast/prepare.h"
#include "trace/setup.h"

#ifdef __AVX2__
#include <immintrin.h>
#include <stddef.h>
#include <string.h>

/* A ray has 64 bits. Numbers of 32 bits lie in the lower half, and anything in the upper one;
 * those of 64 bits are called wide. */
typedef __m256i lanes;

enum { AT_ONCE = 4, MOST_BITS = 26 }; /* a double holds squares of directions so wide */

#define PLUS _mm256_add_epi32
#define MINUS _mm256_sub_epi32
#define TIMES _mm256_mul_epi32 /* wide */

static inline lanes all(int64_t x) {
    return _mm256_set1_epi64x(x);
}

static inline lanes down(lanes wide, int n) {
    return _mm256_srl_epi64(wide, _mm_cvtsi32_si128(n));
}

/* sph_fast_round() of what has 32 bits after it. */
static inline lanes rounded(lanes wide, int n) {
    return down(_mm256_add_epi64(wide, all((int64_t)1 << (n - 1))), n);
}

static inline lanes choose(lanes if_not, lanes if_so, lanes mask) {
    return _mm256_blendv_epi8(if_not, if_so, mask);
}

/* Lower in the lower half, upper in the upper one. */
static inline lanes both(lanes lower, lanes upper) {
    return _mm256_blend_epi32(lower, _mm256_slli_epi64(upper, 32), 0xaa);
}

/* Word i of each of four vectors. */
static inline void turn(lanes w[4]) {
    lanes ab = _mm256_unpacklo_epi64(w[0], w[1]), ab_odd = _mm256_unpackhi_epi64(w[0], w[1]);
    lanes cd = _mm256_unpacklo_epi64(w[2], w[3]), cd_odd = _mm256_unpackhi_epi64(w[2], w[3]);
    w[0] = _mm256_permute2x128_si256(ab, cd, 0x20);
    w[1] = _mm256_permute2x128_si256(ab_odd, cd_odd, 0x20);
    w[2] = _mm256_permute2x128_si256(ab, cd, 0x31);
    w[3] = _mm256_permute2x128_si256(ab_odd, cd_odd, 0x31);
}

/* The four words of 64 bits of each ray that begin there. */
static inline void load(const struct sph_ray *r, size_t at, lanes w[4]) {
    for (int i = 0; i < AT_ONCE; i++)
        w[i] = _mm256_loadu_si256((const __m256i *)(const void *)((const char *)&r[i] + at));
    turn(w);
}

static inline void store(struct sph_ray *r, size_t at, lanes a, lanes b, lanes c, lanes d) {
    lanes w[4] = {a, b, c, d};
    turn(w);
    for (int i = 0; i < AT_ONCE; i++)
        _mm256_storeu_si256((__m256i *)(void *)((char *)&r[i] + at), w[i]);
}

/* Words of 64 bits of the table. */

/* The line of the table for an argument of 18 bits, 2^16 at least: what starts there, less what it
 * has fallen. */
static inline lanes inverse_root(lanes argument) {
    lanes at = _mm256_sub_epi64(down(argument, 10), all(64));
    lanes line = _mm256_i64gather_epi64((const long long *)(const void *)sph_rsqrt_table, at, 8);
    lanes part = _mm256_and_si256(argument, all(1023));
    return MINUS(line, down(TIMES(down(line, 32), part), 10));
}

/* Bits of a number below 2^52. */
static inline lanes length(lanes wide) {
    const double exact = 0x1p52;
    __m256d x =
        _mm256_castsi256_pd(_mm256_or_si256(wide, _mm256_castpd_si256(_mm256_set1_pd(exact))));
    lanes exponent = down(_mm256_castpd_si256(_mm256_sub_pd(x, _mm256_set1_pd(exact))), 52);
    return _mm256_sub_epi64(exponent, all(1022));
}

/* Whether all numbers have so many bits with their sign. */
static inline lanes beyond(lanes wide, int n) {
    return down(_mm256_add_epi64(wide, all((int64_t)1 << (n - 1))), n);
}

/* sph_fast_prepare() of four rays; 0 if one of them is wider than a ray of the profile. */
static inline int four(const struct sph_profile *p, struct sph_ray *r) {
    lanes w[8], *org = w, *v = w + 3, *kind = w + 6, u[3], size[3], wide = all(0);
    int bits = p->wd, k = p->w - p->fw;
    load(r, offsetof(struct sph_ray, org), w);
    load(r, offsetof(struct sph_ray, dir[1]), w + 4);
    for (int i = 0; i < 3; i++) {
        wide = _mm256_or_si256(wide, beyond(v[i], bits));
        wide = _mm256_or_si256(wide, beyond(org[i], p->w));
    }
    if (!_mm256_testz_si256(wide, wide)) return 0;

    /* sph_fast_unit() */
    lanes vv =
        _mm256_add_epi64(_mm256_add_epi64(TIMES(v[0], v[0]), TIMES(v[1], v[1])), TIMES(v[2], v[2]));
    lanes none = _mm256_cmpeq_epi64(vv, all(0));
    lanes h = down(_mm256_sub_epi64(all(2 * bits), length(vv)), 1);
    h = _mm256_andnot_si256(none, h);
    lanes x = down(_mm256_sllv_epi64(vv, PLUS(h, h)), 2 * bits - 18);
    x = _mm256_or_si256(x, _mm256_and_si256(none, all(1 << 16)));
    lanes y = _mm256_andnot_si256(none, inverse_root(x));
    for (int i = 0; i < 3; i++) {
        u[i] = rounded(TIMES(_mm256_sllv_epi64(v[i], h), y), bits);
        size[i] = _mm256_abs_epi32(u[i]);
    }

    /* sph_fast_across() */
    lanes m_1 = _mm256_cmpgt_epi32(size[0], size[1]), least = _mm256_min_epi32(size[0], size[1]);
    lanes m_2 = _mm256_cmpgt_epi32(least, size[2]);
    least = _mm256_min_epi32(least, size[2]);
    lanes m_0 = _mm256_andnot_si256(_mm256_or_si256(m_1, m_2), all(-1));
    m_1 = _mm256_andnot_si256(m_2, m_1);
    lanes square = _mm256_andnot_si256(TIMES(least, least), all(UINT32_MAX));
    lanes scale = MINUS(inverse_root(down(square, 14)), all(SPH_ACROSS_SHORT));
    lanes u_i = choose(u[0], u[1], m_0), u_j = choose(u[2], u[1], m_2);
    lanes u_m = choose(choose(u[0], u[1], m_1), u[2], m_2);
    lanes p_a = rounded(TIMES(scale, u_j), 15), p_b = rounded(TIMES(scale, u_i), 15);
    lanes q_a = rounded(TIMES(u_m, p_b), 16), q_b = rounded(TIMES(u_m, p_a), 16);
    lanes sum = _mm256_add_epi64(TIMES(u_i, p_b), TIMES(u_j, p_a));
    lanes q_m = rounded(_mm256_xor_si256(sum, all(-1)), 16);
    lanes q[3] = {choose(q_a, q_m, m_0), choose(choose(q_b, q_a, m_0), q_m, m_1),
                  choose(q_b, q_m, m_2)};

    /* sph_fast_setup() */
    lanes most = all((1 << (p->fw - 1)) - 1), limit = all(sph_depth_limit(p)), forg[3];
    for (int i = 0; i < 3; i++) {
        lanes o =
            k ? _mm256_sra_epi32(PLUS(org[i], all(1 << (k - 1))), _mm_cvtsi32_si128(k)) : org[i];
        o = _mm256_min_epi32(o, most);
        forg[i] = _mm256_max_epi32(o, _mm256_xor_si256(most, all(-1)));
    }
    lanes by_y = _mm256_cmpgt_epi32(size[1], size[0]);
    lanes mag = _mm256_max_epi32(size[0], size[1]), by_z = _mm256_cmpgt_epi32(size[2], mag);
    lanes one = all(1), axis = choose(_mm256_and_si256(by_y, one), all(2), by_z);
    lanes along = choose(choose(v[0], v[1], by_y), v[2], by_z);
    lanes negative = _mm256_srli_epi32(choose(choose(u[0], u[1], by_y), u[2], by_z), 31);
    mag = _mm256_max_epi32(mag, size[2]);
    lanes pace = PLUS(_mm256_srli_epi32(y, 1), all(SPH_RSQRT_ERROR + 2));
    lanes depth_scale = PLUS(down(TIMES(PLUS(mag, one), pace), 16), one);
    lanes light = PLUS(_mm256_srl_epi32(_mm256_abs_epi32(along), _mm_cvtsi32_si128(k)), one);
    lanes ends = _mm256_cmpeq_epi32(*kind, all(SPH_SHADOW)); /* sph_ray_ends() */

    const size_t at = offsetof(struct sph_ray, a);
    lanes forg_xy = both(forg[0], forg[1]);
    store(r, at, vv, both(u[0], u[1]), both(u[2], y), both(h, _mm256_and_si256(m_0, one)));
    store(r, at + 4 * sizeof r->a, both(PLUS(one, _mm256_andnot_si256(m_2, one)), p_a),
          both(p_b, q[0]), both(q[1], q[2]), forg_xy);
    store(r, at + 7 * sizeof r->a, forg_xy, both(forg[2], axis), both(negative, depth_scale),
          both(MINUS(all(30 - p->fw), h), choose(limit, _mm256_min_epi32(limit, light), ends)));
    return 1;
}

/* Where words follow one another: four() stores them together. */
#define BEHIND(field, other)                                                                       \
    _Static_assert(offsetof(struct sph_ray, field) ==                                              \
                       offsetof(struct sph_ray, other) + sizeof((struct sph_ray *)0)->other,       \
                   "set-up stores other words")
BEHIND(dir, org);
BEHIND(kind, dir);
BEHIND(unit, a);
BEHIND(unit.y, unit.u);
BEHIND(unit.h, unit.y);
BEHIND(across, unit);
BEHIND(across.axis_b, across.axis_a);
BEHIND(across.p_a, across.axis_b);
BEHIND(across.p_b, across.p_a);
BEHIND(across.q, across.p_b);
BEHIND(forg, across);
BEHIND(axis, forg);
BEHIND(negative, axis);
BEHIND(depth_scale, negative);
BEHIND(depth_shift, depth_scale);
BEHIND(depth_max, depth_shift);

static void prepare(const struct sph_profile *p, struct sph_ray *rays, int n) {
    int i = 0;
    for (; i + AT_ONCE <= n && p->wd <= MOST_BITS; i += AT_ONCE)
        if (!four(p, rays + i)) break;
    for (; i < n; i++)
        sph_fast_prepare(p, &rays[i]);
}

void (*const sph_fast_prepare_avx2)(const struct sph_profile *, struct sph_ray *, int) = prepare;
#else
#include <stddef.h>

void (*const sph_fast_prepare_avx2)(const struct sph_profile *, struct sph_ray *, int) = NULL;
#endif
