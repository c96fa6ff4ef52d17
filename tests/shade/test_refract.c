/* test_refract.c - refracted directions: exact sign, Snell's law, bound of the error
 * SPDX-License-Identifier: Apache-2.0
 *
 * docs/design/shading.md. The naive model computes in unbounded integers, Snell's law is checked
 * in real numbers of 64 bits.
 */
#include "vectors.h"

#include <math.h>
#include <string.h>

#include "math/arith.h"
#include "naive/math.h"
#include "shade/refract.h"
#include "trace/setup.h"

/* Ray and surface of a direction and a normal. */
struct meeting {
    struct sph_ray ray;
    struct sph_surface s;
};

static struct meeting meet(const struct sph_profile *p, const int64_t d[3], const int64_t n[3]) {
    struct meeting m = {.ray = {.kind = SPH_PRIMARY, .skip = {SPH_ID_NONE, 0}}};
    for (int i = 0; i < 3; i++) {
        m.ray.dir[i] = d[i];
        m.s.normal[i] = n[i];
        m.s.nn += (uint64_t)(n[i] * n[i]);
    }
    sph_ray_setup(p, &m.ray);
    m.s.unit = sph_unit(n, m.s.nn, p->wd);
    return m;
}

/* Model against naive model; 1 if the ray goes through. */
static int compare(const struct sph_profile *p, const int64_t d[3], const int64_t n[3],
                   uint32_t from, uint32_t to, int64_t out[3]) {
    struct meeting m = meet(p, d, n);
    int64_t other[3] = {0};
    int through = sph_refract(p, &m.ray, &m.s, from, to, out);
    int same = through == sph_naive_refract(p, d, n, from, to, other);
    if (same && through) same = !memcmp(out, other, sizeof other);
    if (!same)
        fail_msg("%s: d %ld %ld %ld n %ld %ld %ld, %u to %u: %d %ld %ld %ld, expected %ld %ld %ld",
                 p->name, d[0], d[1], d[2], n[0], n[1], n[2], from, to, through, out[0], out[1],
                 out[2], other[0], other[1], other[2]);
    return through;
}

static const uint32_t sides[][2] = {{1000, 950}, {950, 1000},  {1000, 1500}, {1500, 1000},
                                    {1000, 250}, {4000, 1000}, {1000, 1000}};
enum { SIDES = sizeof sides / sizeof *sides };

/* Every direction and normal with components of -2..2. */
static void every_small_vector(void **state) {
    (void)state;
    int through = 0, all = 0;
    for (int d = 0; d<125; d += VEC_SHARE> 1 ? 7 : 1)
        for (int n = 0; n < 125; n++)
            for (int k = 0; k < SIDES; k++) {
                const int64_t dir[3] = {d % 5 - 2, d / 5 % 5 - 2, d / 25 - 2};
                const int64_t normal[3] = {n % 5 - 2, n / 5 % 5 - 2, n / 25 - 2};
                int64_t out[3];
                if (d == 62 || n == 62) continue; /* 0 */
                all++;
                through += compare(&sph_profiles[(d + n) % SPH_PROFILES], dir, normal, sides[k][0],
                                   sides[k][1], out);
            }
    printf("# %d of %d go through\n", through, all);
    assert_true(through > all / 2 && through < all);
}

typedef long double real;

static real length(const real v[3]) {
    return sqrtl(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static void cross(const real a[3], const real b[3], real out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* The sine of the angle between the model's direction and the exact one, of X as it is. */
static double off(const struct meeting *m, uint32_t from, uint32_t to, const int64_t out[3]) {
    real d[3], n[3], t[3], o[3], c[3], nn = 0, dn = 0;
    for (int i = 0; i < 3; i++) {
        d[i] = ldexpl((real)m->ray.dir[i], m->ray.unit.h);
        n[i] = ldexpl((real)m->s.normal[i], m->s.unit.h);
        o[i] = (real)out[i];
        nn += n[i] * n[i];
        dn += d[i] * n[i];
    }
    real root = sqrtl((real)sph_refract_disc(&m->ray, &m->s, from, to));
    for (int i = 0; i < 3; i++)
        t[i] = (real)from * nn * d[i] - ((real)from * dn + root) * n[i];
    cross(t, o, c);
    return (double)(length(c) / (length(t) * length(o)));
}

/* Least bound of docs/design/shading.md, radians. */
static double bound(const struct sph_profile *p) {
    double root = ldexp(1 / 250.0, 14 - p->w - p->wd), cut = p->pr ? ldexp(1, 1 - p->pr) : 0;
    return root + cut + sqrt(3) / 2 * ldexp(1, 2 - p->wd);
}

/* A direction and a normal: anything; along the surface; about the critical angle; short. */
static void pick(struct sph_rng *rng, const struct sph_profile *p, int family, uint32_t from,
                 uint32_t to, int64_t d[3], int64_t n[3]) {
    int64_t most = (1ll << (p->wd - 1)) - 1;
    do {
        for (int i = 0; i < 3; i++) {
            n[i] = vec_pick(rng, -most, most);
            d[i] = family == 3 ? vec_pick(rng, -20, 20) : vec_signed(rng, p->wd);
        }
        if (family == 1 || family == 2) { /* across n, and of n what bends to 90 degrees */
            double u[3], nn = 0, dn = 0, sine = (double)to / from;
            for (int i = 0; i < 3; i++)
                nn += (double)n[i] * (double)n[i], dn += (double)d[i] * (double)n[i];
            double size = 0, slope = sine < 1 ? sqrt(1 - sine * sine) / sine : 0.5;
            for (int i = 0; i < 3; i++)
                u[i] = (double)d[i] - dn / nn * (double)n[i], size += u[i] * u[i];
            size = sqrt(size) + 1e-9;
            for (int i = 0; i < 3; i++) {
                double c = u[i] / size - (family == 2 ? slope * (double)n[i] / sqrt(nn) : 0);
                d[i] =
                    lround(0.5 * (double)most * c / sqrt(1 + slope * slope)) + vec_pick(rng, -1, 1);
            }
        }
    } while ((!d[0] && !d[1] && !d[2]) || (!n[0] && !n[1] && !n[2]));
}

static void error_within_bound(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("error_within_bound");
    struct sph_error err = {{0}};
    struct sph_profile own[2];
    assert_int_equal(sph_profile_parse("standard:pr=8", &own[0], &err), 0);
    assert_int_equal(sph_profile_parse("draft:w=8,fw=8,wd=9,pq=10", &own[1], &err), 0);
    for (int k = 0; k < SPH_PROFILES + 2; k++) {
        const struct sph_profile *p = k < SPH_PROFILES ? &sph_profiles[k] : &own[k - SPH_PROFILES];
        double worst = 0;
        int through[4] = {0}, runs = 60000 / VEC_SHARE;
        for (int i = 0; i < runs; i++) {
            uint32_t index = (uint32_t)vec_pick(&rng, SPH_INDEX_MIN, SPH_INDEX_MAX);
            uint32_t from = i & 1 ? index : SPH_INDEX_ONE, to = i & 1 ? SPH_INDEX_ONE : index;
            int family = i / 2 % 4;
            int64_t d[3], n[3], out[3];
            pick(&rng, p, family, from, to, d, n);
            struct meeting m = meet(p, d, n);
            if (i % 8 == 0) compare(p, d, n, from, to, out);
            if (!sph_refract(p, &m.ray, &m.s, from, to, out)) continue;
            through[family]++;
            worst = fmax(worst, off(&m, from, to, out));
        }
        printf("# %s: off by at most %.3e, the bound is %.3e; through %d %d %d %d of %d\n", p->name,
               worst, bound(p), through[0], through[1], through[2], through[3], runs / 4);
        assert_true(worst <= bound(p));
        assert_true(worst > bound(p) / 8);
        for (int f = 0; f < 4; f++)
            assert_true(through[f] > runs / 40 && through[f] < runs / 4);
    }
}

/* from * sine = to * sine, in one plane, on the other side. */
static void snell(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("snell");
    const struct sph_profile *p = &sph_profiles[SPH_REFERENCE];
    int through = 0;
    for (int i = 0; i < 40000 / VEC_SHARE; i++) {
        uint32_t from = i & 1 ? 1500 : 1000, to = i & 1 ? 1000 : 950;
        int64_t d[3], n[3], out[3];
        pick(&rng, p, 0, from, to, d, n);
        struct meeting m = meet(p, d, n);
        int went = sph_refract(p, &m.ray, &m.s, from, to, out);
        real a[3], b[3], c[3], o[3], e[3];
        for (int k = 0; k < 3; k++)
            a[k] = (real)d[k], b[k] = (real)n[k], o[k] = (real)out[k];
        cross(a, b, c);
        real sine = length(c) / (length(a) * length(b)), wanted = (real)from / (real)to * sine;
        if (fabsl(wanted - 1) > 1e-15L) assert_int_equal(went, wanted < 1);
        if (!went) continue;
        through++;
        cross(o, b, e);
        real got = length(e) / (length(o) * length(b)), side = 0, plane = 0;
        for (int k = 0; k < 3; k++)
            side += o[k] * b[k], plane += c[k] * o[k];
        assert_true(fabsl(got - wanted) < bound(p));
        assert_true(side < 0 || side / (length(o) * length(b)) < bound(p));
        assert_true(fabsl(plane) <= (real)bound(p) * length(c) * length(o));
    }
    assert_true(through > 10000 / VEC_SHARE);
}

/* Bits of x in two's complement, without the sign. */
static int bits_of(sph_i128 x) {
    return sph_bit_length128((sph_u128)(x < 0 ? ~x : x));
}

/* The widths of docs/design/shading.md hold at the ends of all ranges, and X and T fill theirs
 * but for a few bits. */
static void widths(void **state) {
    (void)state;
    for (int pr = 0; pr < SPH_PROFILES; pr++) {
        const struct sph_profile *p = &sph_profiles[pr];
        int64_t most = (1ll << (p->wd - 1)) - 1;
        const int64_t ends[] = {-most - 1, -1, 0, 1, most};
        int x_bits = 0, t_bits = 0, cut = p->wd - p->w + 12;
        for (int i = 0; i < 125; i++)
            for (int k = 0; k<125 * SIDES; k += VEC_SHARE> 1 ? 11 : 1) {
                int j = k / SIDES;
                const int64_t d[3] = {ends[i % 5], ends[i / 5 % 5], ends[i / 25]};
                const int64_t n[3] = {ends[j % 5], ends[j / 5 % 5], ends[j / 25]};
                if (i == 62 || j == 62) continue;
                uint32_t from = sides[k % SIDES][0], to = sides[k % SIDES][1];
                struct meeting m = meet(p, d, n);
                sph_i128 x = sph_refract_disc(&m.ray, &m.s, from, to), dn = 0;
                x_bits = bits_of(x) > x_bits ? bits_of(x) : x_bits;
                if (x < 0) continue;
                int inexact;
                assert_true(bits_of(x >> 2 * cut) <= 2 * p->w + 2 * p->wd);
                sph_i128 root = (sph_i128)sph_isqrt((sph_u128)x >> 2 * cut, &inexact) << cut;
                sph_i128 nn = (sph_i128)m.s.nn << 2 * m.s.unit.h;
                for (int c = 0; c < 3; c++)
                    dn += ((sph_i128)d[c] * n[c]) * ((sph_i128)1 << (m.ray.unit.h + m.s.unit.h));
                assert_true(bits_of(dn) <= 2 * p->wd && bits_of(from * nn) <= 2 * p->wd + 12);
                assert_true(bits_of(from * dn + root) <= 2 * p->wd + 13);
                for (int c = 0; c < 3; c++) {
                    sph_i128 t = from * nn * d[c] * (1 << m.ray.unit.h) -
                                 (from * dn + root) * n[c] * (1 << m.s.unit.h);
                    t_bits = bits_of(t) > t_bits ? bits_of(t) : t_bits;
                }
            }
        printf("# %s: X %d of %d bits, T %d of %d\n", p->name, x_bits + 1, 4 * p->wd + 25,
               t_bits + 1, 3 * p->wd + 13);
        assert_true(x_bits <= 4 * p->wd + 24 && x_bits > 4 * p->wd + 24 - 3);
        assert_true(t_bits <= 3 * p->wd + 12 && t_bits > 3 * p->wd + 12 - 3);
    }
}

/* With one index on both sides a ray goes straight on. */
static void straight(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("straight");
    for (int i = 0; i < 4000 / VEC_SHARE; i++) {
        const struct sph_profile *p = &sph_profiles[i % SPH_PROFILES];
        int64_t d[3], n[3], out[3], dn = 0;
        pick(&rng, p, 0, 1000, 1000, d, n);
        for (int k = 0; k < 3; k++)
            dn += d[k] * n[k];
        if (dn > 0)
            for (int k = 0; k < 3; k++)
                n[k] = -n[k];
        struct meeting m = meet(p, d, n);
        assert_true(sph_refract(p, &m.ray, &m.s, 1000, 1000, out));
        real a[3], o[3], c[3];
        for (int k = 0; k < 3; k++)
            a[k] = (real)d[k], o[k] = (real)out[k];
        cross(a, o, c);
        assert_true(length(c) <= (real)bound(p) * length(a) * length(o));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_small_vector),
        cmocka_unit_test(error_within_bound),
        cmocka_unit_test(snell),
        cmocka_unit_test(straight),
        cmocka_unit_test(widths),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
