/* tb_hit.cpp - rt_hit, with rt_hit_point and rt_normalise inside it, against sph_surface_at(),
 * sph_surface_facet()
 * SPDX-License-Identifier: Apache-2.0
 *
 * The hits of tests/hard come first. Vectors are keys and a, so that every quotient is one that
 * sph_quotient() can give.
 */
#include <vector>

#include "Vrt_hit.h"
#include "bench.h"
#include "hard.h"

extern "C" {
#include "math/arith.h"
#include "prim/facet.h"
#include "prim/sphere.h"
}

#ifndef FACETS
#define FACETS 0
#endif
#ifndef INTERVAL
#define INTERVAL 8
#endif
#ifndef GUARDED
#define GUARDED 0
#endif

namespace {

constexpr uint64_t LATENCY = INTERVAL == 12 ? 19 : 18;
constexpr uint64_t LONGEST = INTERVAL == 12 ? 23 : 8; /* that a hit waits */
const struct sph_profile profile = {PROFILE, W, WD, PQ, NG, 12, 0};

struct Vector {
    uint64_t key, a;                /* t = key / a */
    int64_t org[3], dir[3], ctr[3]; /* ctr: the normal of a facet */
    int far;
    uint64_t tag, taken;
    hard::Case hard{};
    bool facet = false;
};

constexpr int64_t MAX = ((int64_t)1 << (W - 1)) - 1, MIN = -MAX - 1;     /* coordinate */
constexpr int64_t DMAX = ((int64_t)1 << (WD - 1)) - 1, DMIN = -DMAX - 1; /* direction */
constexpr uint64_t KMAX = ((uint64_t)1 << (W + WD + 2)) - 1;             /* key */
constexpr uint64_t AMAX = ~(uint64_t)0 >> (64 - 2 * WD);                 /* a */
const Vector corners[] = {
    /* key, a, org, dir, ctr, far */
    {1, 1, {0, 0, 0}, {1, 2, 3}, {1, 2, 3}, 0, 0, 0},          /* at the centre: normal -dir */
    {1, 1, {0, 0, 0}, {1, 2, 3}, {1, 2, 3}, 1, 0, 0},          /* the same from inside: also -dir */
    {1, AMAX, {5, 6, 7}, {DMIN, 0, 0}, {5, 6, 7}, 0, 0, 0},    /* -dir of DMIN: must be limited */
    {1, AMAX, {5, 6, 7}, {DMAX, DMIN, 1}, {5, 6, 7}, 1, 0, 0}, /* t = 0+: rounds to org */
    {1, 1, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0, 0, 0},          /* nothing at all: zero normal */
    {1, 1, {0, 0, 0}, {1, 0, 0}, {1, 0, 1}, 0, 0, 0},          /* one component is not zero */
    {KMAX, 1, {0, 0, 0}, {1, -1, 0}, {0, 0, 0}, 0, 0, 0},      /* t too long: exp < NG */
    {KMAX, 1, {MIN, MIN, MAX}, {0, 0, 0}, {1, 1, 1}, 0, 0, 0}, /* the same without any way */
    {KMAX, 1, {MAX, MIN, 0}, {DMAX, DMIN, 1}, {MIN, MAX, 0}, 1, 0, 0}, /* longest of all */
    {1, AMAX, {0, 0, 0}, {DMIN, DMAX, 1}, {1, 1, 1}, 0, 0, 0},         /* largest exp */
    {KMAX, AMAX, {0, 0, 0}, {1, -1, 2}, {3, 3, 3}, 0, 0, 0},           /* largest key and a */
    {1, 1, {MAX, MIN, 0}, {1, -1, 0}, {0, 0, 0}, 0, 0, 0},  /* one step out of the grid */
    {1, 1, {MAX, MIN, 0}, {-1, 1, 0}, {0, 0, 0}, 0, 0, 0},  /* one step into it */
    {1, 2, {MAX, MIN, 0}, {1, -1, 1}, {0, 0, 0}, 0, 0, 0},  /* half: point limited, -1/2, 1/2 */
    {1, 4, {MAX, MIN, 0}, {1, -1, 1}, {0, 0, 0}, 0, 0, 0},  /* a quarter: rounds back, -1/4 */
    {3, 4, {MAX, 0, -1}, {1, -1, 1}, {MIN, 0, 0}, 0, 0, 0}, /* normal that rounds up: limited */
    {3, 4, {MAX, 0, -1}, {1, -1, 1}, {MIN, 0, 0}, 1, 0, 0}, /* its negative: not limited */
    {1, 1, {MIN, MIN, MIN}, {0, 0, 0}, {MAX, MAX, MAX}, 0, 0, 0}, /* longest negative normal */
    {1, 1, {MIN, MIN, MIN}, {0, 0, 0}, {MAX, MAX, MAX}, 1, 0, 0}, /* and its opposite */
    {1, 8, {0, 0, 0}, {1, -1, 3}, {9, 9, 9}, 0, 0, 0}, /* half a guard step up, -1/2 up */
};

Vector make(bench::Random &random) {
    Vector v{};
    uint64_t how = random.below(8);
    v.far = random.percent(30);
    for (int i = 0; i < 3; i++) {
        v.org[i] = random.smixed(W);
        v.dir[i] = how < 2 ? random.smixed(WD) : random.sbits(WD);
        v.ctr[i] = random.smixed(W);
    }
    do
        v.a = how ? (uint64_t)(v.dir[0] * v.dir[0] + v.dir[1] * v.dir[1] + v.dir[2] * v.dir[2])
                  : (uint64_t)random.mixed(2 * WD);
    while (!v.a && (v.dir[0] = random.sbits(WD), 1));
    switch (how) {
    case 0: /* any key, any a */
    case 1: /* any key */
        v.key = (uint64_t)random.log_bits(W + WD + 2);
        break;
    default: { /* a point of the grid, mostly: t of 2^-W to 2 */
        int bits =
            sph_bit_length(v.a) + 1 - (int)(random.percent(70) ? random.below(3) : random.below(W));
        v.key = bits > 0 ? (uint64_t)random.bits(bits) : 0;
        if (v.key > KMAX) v.key = KMAX;
        break;
    }
    }
    if (!v.key) v.key = 1;
    if (how >= 5) /* the point lies near the centre; often at it */
        for (int i = 0; i < 3; i++) {
            int64_t near =
                v.org[i] + (int64_t)((bench::i128)v.dir[i] * (bench::i128)v.key / (bench::i128)v.a);
            if (how >= 6) near += random.between(-1, 1) * random.between(0, 1000);
            v.ctr[i] = near > MAX ? MAX : near < MIN ? MIN : near;
        }
    if (how == 5) { /* t = 1 or 2: exactly at the centre */
        v.key = v.a;
        for (int i = 0; i < 3; i++) {
            v.org[i] >>= 1;
            v.dir[i] = random.smixed(W) >> 1;
            v.ctr[i] = v.org[i] + v.dir[i];
        }
        if (random.percent(50)) v.ctr[random.below(3)] ^= 1; /* or just beside it */
    }
    v.facet = FACETS && random.percent(50);
    for (int i = 0; i < 3 && v.facet; i++)
        v.ctr[i] = random.percent(10) ? 0 : random.smixed(24);
    if (v.facet && random.percent(2)) v.ctr[0] = v.ctr[1] = v.ctr[2] = 0; /* -dir */
    return v;
}

struct sph_quotient quotient(const Vector &v) {
    return sph_quotient(v.key, W + WD + 2, v.a, 2 * WD, PQ);
}

using Bench = bench::Bench<Vrt_hit>;

/* The low half of a primitive record; what a kind does not look at must not matter. */
void shape(Bench &b, const Vector &v) {
    auto &port = b.dut.in_shape_i;
    const int at[3] = {SPH_LEAF_CTR_X_LSB, SPH_LEAF_CTR_Y_LSB, SPH_LEAF_CTR_Z_LSB};
    for (int i = 0; i < SPH_LEAF_STRIDE / 32; i++)
        bench::put(port, 32 * i, 32, (bench::i128)b.random.bits(32));
    for (int i = 0; i < 3; i++)
        bench::put(port, at[i], v.facet ? SPH_LEAF_CTR_X_BITS : W, v.ctr[i]);
    uint32_t effects = (uint32_t)b.random.bits(SPH_EFFECT_BITS);
    if (v.facet) effects |= 1 << SPH_EFFECT_FACETS;
    b.dut.effects_i = (uint16_t)effects;
    if (FACETS && effects >> SPH_EFFECT_FACETS & 1) /* the kind counts */
        bench::put(port, SPH_PRIM_KIND_LSB, SPH_PRIM_KIND_BITS,
                   v.facet ? 1 + (int64_t)b.random.below((1 << SPH_PRIM_KIND_BITS) - 1)
                           : SPH_SPHERE);
}

void send(Bench &b, const Vector &v) {
    struct sph_quotient t = quotient(v);
    b.set(b.dut.in_mant_i, PQ, t.mant);
    b.set(b.dut.in_exp_i, 8, t.exp);
    b.set(b.dut.in_org_x_i, W, v.org[0]);
    b.set(b.dut.in_org_y_i, W, v.org[1]);
    b.set(b.dut.in_org_z_i, W, v.org[2]);
    b.set(b.dut.in_dir_x_i, WD, v.dir[0]);
    b.set(b.dut.in_dir_y_i, WD, v.dir[1]);
    b.set(b.dut.in_dir_z_i, WD, v.dir[2]);
    shape(b, v);
    b.dut.in_far_i = (uint8_t)v.far;
}

void check(Bench &b, const Vector &e) {
    struct sph_ray ray = {};
    struct sph_leaf sphere = {};
    struct sph_surface s;
    for (int i = 0; i < 3; i++) {
        ray.org[i] = e.org[i];
        ray.dir[i] = e.dir[i];
        sphere.ctr[i] = e.ctr[i];
    }
    ray.a = e.a;
    struct sph_hit hit = {e.key, 0, e.far != 0, 0};
    int saturated = e.facet ? sph_surface_facet(&profile, &ray, &hit, e.ctr, &s)
                            : sph_surface_at(&profile, &ray, &hit, &sphere, &s);
    b.expect("out_point_x_o", b.sget(b.dut.out_point_x_o, W), s.point[0], W);
    b.expect("out_point_y_o", b.sget(b.dut.out_point_y_o, W), s.point[1], W);
    b.expect("out_point_z_o", b.sget(b.dut.out_point_z_o, W), s.point[2], W);
    b.expect("out_normal_x_o", b.sget(b.dut.out_normal_x_o, WD), s.normal[0], WD);
    b.expect("out_normal_y_o", b.sget(b.dut.out_normal_y_o, WD), s.normal[1], WD);
    b.expect("out_normal_z_o", b.sget(b.dut.out_normal_z_o, WD), s.normal[2], WD);
    for (int i = 0; i < 3; i++)
        b.expect("out_guarded_o", bench::sign(b.get(b.dut.out_guarded_o) >> (W + NG) * i, W + NG),
                 GUARDED ? s.guarded[i] : 0, W + NG);
    sph_surface_spawn(&profile, &s, &ray);
    for (int i = 0; i < 3; i++)
        b.expect("out_lift_o", bench::sign(b.get(b.dut.out_lift_o) >> (NG + 2) * i, NG + 2),
                 FACETS ? ray.lift[i] : 0, NG + 2);
    b.expect("out_flat_o", b.dut.out_flat_o, s.flat, 1);
    b.expect("out_saturated_o", b.dut.out_saturated_o, saturated, 1);
    if (b.bad()) {
        e.hard.show();
        b.show("key", e.key, W + WD + 2);
        b.show("a", e.a, 2 * WD);
        b.show("in_mant_i", quotient(e).mant, PQ);
        b.show("in_exp_i", quotient(e).exp, 8);
        b.show("in_far_i", e.far, 1);
        b.show("stored normal", e.facet, 1);
    }
    for (int i = 0; i < 3 && b.bad(); i++) {
        b.show("in_org_i", e.org[i], W);
        b.show("in_dir_i", e.dir[i], WD);
        b.show("in_ctr_i", e.ctr[i], W);
    }
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_hit> b("tb_hit", argc, argv);
    std::vector<Vector> directed;
    if (!hard::alone()) directed.assign(std::begin(corners), std::end(corners));
    hard::Source source(
        b.seed,
        [](const sph_profile &p) { return p.w == W && p.wd == WD && p.pq == PQ && p.ng == NG; },
        [](const hard::Case &c) { return (c.is_ray || c.is_point) && c.key; });
    source.limit(b);
    for (Vector v{}; source.next(v.hard);) {
        v.key = v.hard.key;
        v.a = v.hard.a;
        v.far = v.hard.result.far;
        for (int i = 0; i < 3; i++) {
            v.org[i] = v.hard.ray.org[i];
            v.dir[i] = v.hard.ray.dir[i];
            v.ctr[i] = v.hard.leaf.ctr[i];
        }
        directed.push_back(v);
    }
    source.report(b);
    b.stream(
        directed, make, TAG, LATENCY, LONGEST, [&](const Vector &v) { send(b, v); },
        [&](const Vector &v) { check(b, v); });
    return b.finish();
}
