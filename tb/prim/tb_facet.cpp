/* tb_facet.cpp - rt_facet against sph_facet_test() and sph_facet_key()
 * SPDX-License-Identifier: Apache-2.0
 *
 * The first vectors are the least and greatest operands in every pattern, as triangle and as plane;
 * then the named and generated cases of tests/hard, if these are the words of a profile. Then
 * families in turn (`family`), by reason: what lies on an edge, a corner, the light, a face of the
 * world, in the plane, beside the ray's start. Results may overtake each other: a slot is one
 * facet's until its result is there. The default run has to meet every outcome.
 */
#include <algorithm>
#include <map>

#include "Vrt_facet.h"
#include "bundles.h"
#include "hard.h"
extern "C" {
#include "tests/hard/list.h"
#include "prim/facet.h"
}

#ifndef NG
#define NG 2
#endif

namespace {

constexpr int64_t C_MIN = -((int64_t)1 << (W - 1)), C_MAX = -C_MIN - 1;
constexpr int64_t D_MIN = -((int64_t)1 << (WD - 1)), D_MAX = -D_MIN - 1;
constexpr int64_t N_MIN = -(1 << 23), N_MAX = -N_MIN - 1;
constexpr int PATTERNS = 1 << 10; /* 5 bits of corners and origin, 3 of dir, plane, shadow */
const struct sph_profile profile = {PROFILE, W, WD, 0, NG, 0, 0};

struct Vector {
    sph_ray ray{};
    sph_facet_leaf facet{};
    bool shadow = false; /* the port; a shadow ray only if they are elaborated */
    int family = 0, named = 0;
    hard::Vector hard{};
};

int64_t clamp(int64_t x, int64_t low, int64_t high) {
    return x < low ? low : x > high ? high : x;
}

class Source {
  public:
    Source(bench::Random &r, uint64_t seed)
        : random(r),
          cases(seed, HARD_FACETS, [](const sph_profile &p) { return p.w == W && p.wd == WD; }) {
        for (const hard::Vector &v : cases)
            for (int i = 0; i < v.c.n; i++)
                generated.emplace_back(v, i);
        for (int p = 0; p < SPH_PROFILES; p++)
            if (sph_profiles[p].w == W && sph_profiles[p].wd == WD) list = hard_facets_named(p);
        for (size_t i = 0; i < list.n; i++) /* of HARD_CASE alone, if it is given */
            if (!hard::alone() || list.items[i].named == hard::alone())
                list.items[n_named++] = list.items[i];
        if (hard::alone()) count = PATTERNS;
    }
    ~Source() { free(list.items); }
    Source(const Source &) = delete;
    Source &operator=(const Source &) = delete;

    size_t named() const { return n_named; }
    bool all() const { return at == n_named && behind == generated.size(); }

    Vector next() {
        Vector v;
        if (count >= PATTERNS && at < n_named) {
            const hard_facet &c = list.items[at++];
            v.ray = c.ray;
            v.facet = c.facet;
            v.named = c.named;
            return finish(v);
        }
        if (count >= PATTERNS && behind < generated.size()) {
            v.hard = generated[behind].first;
            v.ray = v.hard.c.ray;
            v.facet = v.hard.c.facet[generated[behind++].second];
            return finish(v);
        }
        v.facet.id = (uint32_t)random.bits(random.percent(50) ? 3 : 24);
        v.facet.before = (uint32_t)random.mixed(SPH_FACET_BEFORE_BITS);
        v.facet.after = (uint32_t)random.mixed(SPH_FACET_AFTER_BITS);
        v.ray.skip.id = random.percent(50) ? SPH_ID_NONE : (uint32_t)random.bits(24);
        if (random.percent(20)) /* of the group, or next to it */
            v.ray.skip.id =
                (v.facet.id + (random.percent(50) ? v.facet.after + (uint32_t)random.below(2)
                                                  : -v.facet.before - (uint32_t)random.below(2))) &
                0xffffff;
        if (random.percent(10)) /* of the group, but for one bit */
            v.ray.skip.id = v.facet.id ^ 1u << random.below(24);
        v.facet.kind = random.percent(30) ? SPH_PLANE : SPH_TRIANGLE;
        v.shadow = random.percent(33);
        if (count < PATTERNS)
            pattern(v, count);
        else if (v.facet.kind == SPH_PLANE)
            v.family = 10 + (int)random.below(5), plane(v);
        else
            v.family = 1 + (int)random.below(8), triangle(v);
        count++;
        lift(v);
        if (v.family && random.percent(3)) v.ray.dir[random.below(3)] = 0;
        for (int i = 0; i < 3; i++)
            v.ray.dir[i] = clamp(v.ray.dir[i], D_MIN, D_MAX);
        v.ray.kind = v.shadow ? SPH_SHADOW : SPH_PRIMARY;
        return finish(v);
    }

  private:
    bench::Random &random;
    hard::Cases cases;
    std::vector<std::pair<hard::Vector, int>> generated; /* which of its facets */
    int count = 0;
    hard_facets list{};
    size_t n_named = 0, at = 0, behind = 0;

    static Vector finish(Vector &v) {
        const int64_t *d = v.ray.dir;
        v.ray.a = (uint64_t)(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        v.shadow = v.ray.kind == SPH_SHADOW;
        if (!SHADOW) v.ray.kind = SPH_PRIMARY;
        return v;
    }

    /* By how much the origin was rounded; often beside the facet's plane, or along it. */
    void lift(Vector &v) {
        for (int64_t &x : v.ray.lift)
            x = random.percent(30) ? (random.percent(50) ? 1 << NG : -(1 << NG))
                                   : (int64_t)random.between(-(1 << NG), 1 << NG);
        if (!v.family || !random.percent(v.shadow ? 75 : 10)) return;
        int64_t far[3], plane = v.facet.kind == SPH_PLANE;
        for (int i = 0; i < 3; i++) {
            int64_t at = v.facet.v[plane ? 0 : random.below(3)][i];
            far[i] = plane ? coordinate(0) : v.facet.v[random.below(3)][i];
            if (!random.percent(30)) at = v.facet.v[0][i];
            v.ray.org[i] = clamp(at + random.between(-2, 2), C_MIN, C_MAX);
        }
        aim(v, far);
    }

    int64_t coordinate(int small) { return small ? random.between(-3, 3) : random.smixed(W); }

    /* corners in one corner of the world each, all ends of dir */
    void pattern(Vector &v, int n) {
        v.facet.kind = n >> 8 & 1 ? SPH_PLANE : SPH_TRIANGLE;
        v.shadow = n >> 9 & 1;
        for (int i = 0; i < 3; i++) {
            int turn = (n + i * 11) & 31; /* another pattern on every axis */
            for (int c = 0; c < 3; c++)
                v.facet.v[c][i] = turn >> c & 1 ? C_MAX : C_MIN;
            if (v.facet.kind == SPH_PLANE) v.facet.v[1][i] = turn >> 1 & 1 ? N_MAX : N_MIN;
            v.ray.org[i] = turn >> 3 & 1 ? C_MAX : C_MIN;
            v.ray.dir[i] = n >> (5 + i) & 1 ? D_MAX : D_MIN;
        }
    }

    /* A ray towards a point, in a way of its own; org stays in the world. */
    void aim(Vector &v, const int64_t target[3]) {
        int how = (int)random.below(6), up = (int)random.below((uint64_t)(WD - W + 1));
        for (int i = 0; i < 3; i++) {
            int64_t *d = &v.ray.dir[i], to = clamp(target[i], C_MIN, C_MAX) - v.ray.org[i];
            *d = to; /* t = 1 */
            if (how == 1) *d = to * (1 << up);
            if (how == 2) *d = -to;
            if (how == 3) *d = to + random.between(-1, 1);
            if (how == 4 && !(to & 3)) *d = to / 4;      /* t = 4 where it is whole */
            if (how == 5) *d = to - (to > 0) + (to < 0); /* ends a unit before */
        }
    }

    void triangle(Vector &v) {
        int small = random.percent(25);
        int64_t(*c)[3] = v.facet.v, target[3], n = 1 << random.below(4);
        int64_t i1 = random.between(0, n), i2 = random.between(0, n - i1);
        for (int i = 0; i < 3; i++) {
            for (int k = 0; k < 3; k++)
                c[k][i] = coordinate(small);
            v.ray.org[i] = coordinate(small);
        }
        if (random.percent(40)) /* edges of steps that `n` divides */
            for (int i = 0; i < 3; i++)
                for (int k = 1; k < 3; k++)
                    c[k][i] = clamp(c[0][i] + (c[k][i] - c[0][i]) / n * n, C_MIN, C_MAX);
        if (v.family == 2) i1 = 0;                                    /* edge v0 v2 */
        if (v.family == 3) i2 = n - i1;                               /* edge v1 v2 */
        if (v.family == 4) i1 = n * (int64_t)random.below(2), i2 = 0; /* a corner */
        if (v.family == 5)                                            /* in an axis plane */
            for (int k = 0; k < 3; k++)
                c[k][2] = c[0][2];
        for (int i = 0; i < 3; i++)
            target[i] = c[0][i] + ((c[1][i] - c[0][i]) * i1 + (c[2][i] - c[0][i]) * i2) / n;
        if (v.family == 6) /* starts in the triangle's plane, or close to it */
            for (int i = 0; i < 3; i++)
                v.ray.org[i] = clamp(target[i] + (random.percent(30) ? random.between(-1, 1) : 0),
                                     C_MIN, C_MAX);
        aim(v, target);
        if (v.family == 7) /* along the plane, or close to it */
            for (int i = 0; i < 3; i++)
                v.ray.dir[i] = (c[1][i] - c[0][i]) * (int64_t)random.between(-1, 1) +
                               (c[2][i] - c[0][i]) * (int64_t)random.between(-1, 1) +
                               (random.percent(20) ? random.between(-1, 1) : 0);
        if (v.family == 8)
            for (int i = 0; i < 3; i++)
                v.ray.dir[i] = random.smixed(WD);
    }

    void plane(Vector &v) {
        int small = random.percent(20), axis = (int)random.below(3);
        int64_t target[3], *n = v.facet.v[1];
        for (int i = 0; i < 3; i++) {
            v.facet.v[0][i] = coordinate(small);
            v.facet.v[2][i] = random.smixed(W); /* must not matter */
            v.ray.org[i] = coordinate(small);
            n[i] = small ? random.between(-3, 3) : random.smixed(24);
            target[i] = v.facet.v[0][i];
        }
        if (v.family >= 11) { /* across one axis: targets anywhere in it */
            int64_t length = random.smixed(24);
            for (int i = 0; i < 3; i++) {
                n[i] = i == axis ? length : 0;
                if (i != axis) target[i] = coordinate(small);
            }
        }
        if (v.family == 12) /* it is a face of the world */
            v.facet.v[0][axis] = target[axis] = random.percent(50) ? C_MIN : C_MAX;
        if (v.family == 13) /* the horizon: the target lies on a face */
            target[(axis + 1) % 3] = random.percent(50) ? C_MIN : C_MAX;
        aim(v, target);
        if (v.family == 13 && random.percent(30)) /* or just beyond */
            v.ray.dir[(axis + 1) % 3] += random.between(-1, 1);
        if (v.family == 14)
            for (int i = 0; i < 3; i++)
                v.ray.dir[i] = random.smixed(WD);
    }
};

struct Expected {
    Vector v;
    sph_facet_result r;
    uint64_t key;
};

using Bench = bench::Bench<Vrt_facet>;

int record_bit(int lsb, int) {
    return lsb;
} /* of field RECORD */

/* Three numbers in fields of `bits` bits; what is not used of them must not matter. */
bench::u128 pack(Bench &b, const int64_t value[3], int bits, int used) {
    bench::u128 x = 0;
    for (int i = 3; i-- > 0;)
        x = x << bits | (used < bits ? bench::low(b.random.bits(bits) << used, bits) : 0) |
            bench::low((bench::u128)value[i], used);
    return x;
}

void drive(Bench &b, const Vector &v, unsigned slot) {
    auto &port = b.dut.test_i;
    auto field = [&](int lsb, int bits, bench::u128 x) {
        bench::put(port, record_bit(RT_TEST_RECORD) + lsb, bits, (bench::i128)x);
    };
    bool plane = v.facet.kind == SPH_PLANE;
    field(SPH_TRIANGLE_V0_X_LSB, 72, pack(b, v.facet.v[0], 24, W));
    field(SPH_TRIANGLE_V1_X_LSB, 72, pack(b, v.facet.v[1], 24, plane ? 24 : W));
    field(SPH_TRIANGLE_V2_X_LSB, 72, pack(b, v.facet.v[2], 24, W));
    field(SPH_FACET_ID_LSB, SPH_FACET_ID_BITS, v.facet.id);
    field(SPH_FACET_BEFORE_LSB, SPH_FACET_BEFORE_BITS, v.facet.before);
    field(SPH_FACET_AFTER_LSB, SPH_FACET_AFTER_BITS, v.facet.after);
    field(SPH_FACET_KIND_LSB, SPH_FACET_KIND_BITS, (bench::u128)v.facet.kind);
    bench::put(port, RT_TEST_SLOT, slot);
    bench::put(port, RT_TEST_SHADOW, v.shadow);
    bench::put(port, RT_TEST_INSIDE, b.random.percent(50));
    bench::put(port, RT_TEST_ORG, (bench::i128)pack(b, v.ray.org, W, W));
    bench::put(port, RT_TEST_DIR, (bench::i128)pack(b, v.ray.dir, WD, WD));
    bench::put(port, RT_TEST_A, (bench::i128)v.ray.a);
    bench::put(port, RT_TEST_SKIP, v.ray.skip.id);
    bench::put(port, RT_TEST_LIFT, (bench::i128)pack(b, v.ray.lift, NG + 2, NG + 2));
}

void compare(Bench &b, const Expected &e) {
    auto &port = b.dut.result_o;
    bool hit = bench::get(port, RT_RESULT_HIT) != 0;
    b.expect("ID", (bench::i128)bench::get(port, RT_RESULT_ID), e.v.facet.id, 24);
    b.expect("HIT", hit, e.r.hit, 1);
    if (e.r.hit && hit) {
        b.expect("FAR", (bench::i128)bench::get(port, RT_RESULT_FAR), e.r.far, 1);
        b.expect("KEY", (bench::i128)bench::get(port, RT_RESULT_KEY), (bench::i128)e.key,
                 W + WD + 2);
    }
    if (b.bad()) {
        const Vector &x = e.v;
        x.hard.show();
        if (x.named)
            printf("#   named case %d, %s: build/test/hard --named=%d\n", x.named,
                   hard_named_name(x.named), x.named);
        printf("# inputs, family %d: a %s, %s\n", x.family,
               x.facet.kind == SPH_PLANE ? "plane" : "triangle",
               x.shadow ? "to a light" : "of no light");
        for (int c = 0; c < 3; c++)
            for (int i = 0; i < 3; i++)
                b.show(c == 0 ? "v0" : c == 1 ? "v1" : "v2", x.facet.v[c][i], 24);
        for (int i = 0; i < 3; i++)
            b.show("org", x.ray.org[i], W);
        for (int i = 0; i < 3; i++)
            b.show("dir", x.ray.dir[i], WD);
        for (int i = 0; i < 3; i++)
            b.show("lift", x.ray.lift[i], NG + 2);
        b.show("before", x.facet.before, SPH_FACET_BEFORE_BITS);
        b.show("after", x.facet.after, SPH_FACET_AFTER_BITS);
        b.show("skip", x.ray.skip.id, 24);
        b.show("model det'", (bench::i128)e.r.det, 2 * W + WD + 2);
        b.show("model num'", e.r.num, 3 * W + 2);
    }
}

/* To a light: it would be hit if all were ahead of where the ray starts. */
bool beside(Vector v) {
    for (int i = 0; i < 3; i++)
        v.ray.lift[i] = v.ray.dir[i] * ((int64_t)1 << 30);
    return v.shadow && sph_facet_test(&profile, &v.ray, &v.facet).hit;
}

/* Every hard case, kind of facet, ray and outcome, and the clocks from a facet to the next. */
void came(Bench &b, const Source &source, const long met[2][2][2], long passed, uint64_t least) {
    bool all = b.all_vectors && !hard::alone();
    if (all && !source.all()) b.fail("not all hard cases were driven");
    for (int i = 0; i < 8; i++)
        if (all && !met[i >> 2][i >> 1 & 1][i & 1] && (SHADOW || !(i & 2)))
            b.fail("a kind of facet, ray and outcome that never came");
    if (all && SHADOW && passed < 20) b.fail("facets beside a start that hardly came");
    if (all && least != INTERVAL) b.fail("another number of clocks from a facet to the next");
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_facet> b("tb_facet", argc, argv, 60000);
    Source source(b.random, b.seed);
    if (hard::alone()) b.target = (long)source.named();
    if (hard::alone() && !b.target) b.fail("the case has no vector for this bench");
    std::map<unsigned, Expected> sent;
    Vector v = source.next();
    unsigned slot = 0, gaps = 0, stalls = 0;
    bool offered = false;
    uint64_t taken = 0, least = 1000; /* clocks until the next one is taken */
    long met[2][2][2] = {}, passed = 0, divided = 0, divisions = 0; /* plane, shadow, hit */
    Vrt_facet &t = b.dut;
    t.in_valid_i = t.result_ready_i = 0;
    b.reset();
    while (b.more()) {
        if (b.cycle % 4096 == 0) {
            gaps = (unsigned)b.random.below(3) * 45;
            stalls = (unsigned)b.random.below(4) * 32;
        }
        if (!offered && !sent.count(slot)) offered = !b.random.percent(gaps);
        t.in_valid_i = offered;
        drive(b, v, slot);
        t.result_ready_i = !b.random.percent(stalls);
        b.settle();
        divisions += t.divide_o;
        if (bench::get(t.result_o, RT_RESULT_VALID) && t.result_ready_i) {
            auto at = sent.find((unsigned)bench::get(t.result_o, RT_RESULT_SLOT));
            if (at == sent.end()) {
                b.fail("a result that nobody asked for");
                break;
            }
            const Expected &e = at->second;
            compare(b, e);
            b.done();
            sent.erase(at);
        }
        if (offered && t.in_ready_o) {
            Expected e = {v, sph_facet_test(&profile, &v.ray, &v.facet), 1};
            uint64_t n = 0;
            bool shadow = v.ray.kind == SPH_SHADOW;
            if (e.r.hit && !shadow) e.key = sph_facet_key(&v.ray, &e.r, &n);
            divided += (long)n;
            if (taken) least = std::min(least, b.cycle - taken);
            taken = b.cycle;
            passed += !e.r.hit && beside(v);
            met[v.facet.kind == SPH_PLANE][shadow][e.r.hit != 0]++;
            sent.emplace(slot, e);
            slot = (slot + 1) % SLOTS;
            v = source.next();
            offered = false;
        }
        b.tick();
    }
    came(b, source, met, passed, least);
    if (divisions > divided || divisions + (long)sent.size() < divided)
        b.fail("divide_o counts other than the keys of hits");
    printf("# vectors of hard cases: %zu named\n", source.named());
    return b.finish();
}
