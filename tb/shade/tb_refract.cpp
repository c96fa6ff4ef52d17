/* tb_refract.cpp - rt_refract, with rt_isqrt and rt_normalise inside it, against sph_refract()
 * SPDX-License-Identifier: Apache-2.0
 *
 * The cases of tests/hard come first. Directions at and beside the critical angle are searched for;
 * so are vectors that need long shifts. One result at a time, of any latency.
 */
#include <vector>

#include "Vrt_refract.h"
#include "bench.h"
#include "hard.h"

extern "C" {
#include "machine/layout.h"
#include "shade/refract.h"
}

namespace {

constexpr int SLOWEST = 400; /* clocks from a ray to its result */
constexpr uint32_t ONE = SPH_INDEX_ONE;
const struct sph_profile profile = {PROFILE, W, WD, WD, 2, 12, PR};
constexpr int64_t MAX = ((int64_t)1 << (WD - 1)) - 1, MIN = -MAX - 1;

struct Vector {
    int64_t dir[3], normal[3];
    uint32_t from, to;
    hard::Vector hard{};
};

const Vector corners[] = {
    {{0, 0, 0}, {0, 0, 0}, ONE, 1500},             /* nothing: zero */
    {{1, 2, 3}, {0, 0, 0}, ONE, 1500},             /* no normal */
    {{0, 0, 0}, {MAX, MAX, MAX}, 1500, ONE},       /* no direction */
    {{-1, 0, 0}, {1, 0, 0}, ONE, 1500},            /* the smallest words: longest shifts */
    {{1, 0, 0}, {-1, 0, 0}, 1500, ONE},            /* head on: straight through */
    {{0, -16, -16}, {0, 0, 16}, ONE, 1333},        /* water at 45 degrees */
    {{0, 0, MIN}, {0, 0, MAX}, ONE, 4000},         /* largest index */
    {{MAX, 0, 0}, {0, MAX, 0}, ONE, 1500},         /* along the surface: the critical angle */
    {{MAX, 0, 0}, {0, MAX, 0}, 1500, ONE},         /* along it from inside: reflected */
    {{MAX, 0, 0}, {0, MAX, 0}, ONE, ONE},          /* along it, X = 0: straight on */
    {{MIN, MIN, MIN}, {MIN, MIN, MIN}, 4000, ONE}, /* normal turned away, all words largest */
    {{MIN, MIN, MIN}, {MAX, MAX, MAX}, 4095, ONE}, /* the largest p*B */
    {{MIN, MIN, MIN}, {MAX, MAX, MAX}, ONE, 4095}, /* the largest X */
    {{3, 4, 0}, {0, -5, 0}, 1000, 600},            /* sine 0.6 to index 0.6: X is exactly 0 */
    {{3, 4, 0}, {0, -5, 0}, 1000, 599},            /* just beyond: reflected */
    {{300, 400, 0}, {0, -512, 0}, 1000, 601},      /* just before */
    {{0, 28, -96}, {0, 0, 100}, 2500, 700},        /* sine 0.28 to 0.28 */
    {{MAX, -1, 0}, {0, MAX, 0}, 250, ONE},         /* grazing into what is denser */
    {{MAX, -1, 0}, {0, MAX, 0}, ONE, 250},         /* grazing, reflected */
};

uint64_t dot(const int64_t v[3]) {
    return (uint64_t)(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

uint32_t index_of(bench::Random &random) {
    return random.percent(20) ? (uint32_t)random.below(4096) : (uint32_t)random.between(250, 4000);
}

struct sph_ray ray_of(const Vector &v) {
    struct sph_ray ray = {};
    for (int i = 0; i < 3; i++)
        ray.dir[i] = v.dir[i];
    ray.a = dot(v.dir);
    ray.unit = sph_unit(v.dir, ray.a, WD);
    return ray;
}

struct sph_surface surface_of(const Vector &v) {
    struct sph_surface s = {};
    for (int i = 0; i < 3; i++)
        s.normal[i] = v.normal[i];
    s.nn = dot(v.normal);
    s.unit = sph_unit(v.normal, s.nn, WD);
    return s;
}

Vector make(bench::Random &random) {
    Vector v{};
    uint64_t how = random.below(8);
    for (int i = 0; i < 3; i++) {
        v.dir[i] = how < 3 ? random.sbits(WD) : random.smixed(WD);
        v.normal[i] = how < 3 ? random.sbits(WD) : random.smixed(WD);
    }
    uint32_t index = index_of(random);
    v.from = how & 1 ? ONE : index;
    v.to = how & 1 ? index : ONE;
    if (how == 4 || how == 5) { /* the index at which X turns its sign, or one beside it */
        struct sph_ray ray = ray_of(v);
        struct sph_surface s = surface_of(v);
        uint32_t low = 1, high = 4095;
        v.from = ONE;
        while (low < high) {
            uint32_t middle = (low + high) / 2;
            if (sph_refract_disc(&ray, &s, ONE, middle) < 0)
                low = middle + 1;
            else
                high = middle;
        }
        v.to = low - (random.percent(50) ? 1 : 0);
    }
    if (how == 6) /* along the surface, or nearly */
        v.dir[2] = 0, v.dir[0] = v.normal[1] / 2, v.dir[1] = -(v.normal[0] / 2);
    if (how == 7) /* head on, or nearly */
        for (int i = 0; i < 3; i++)
            v.dir[i] = -(v.normal[i] >> 1) + random.between(-1, 1);
    return v;
}

void show(const bench::Bench<Vrt_refract> &b, const Vector &v) {
    v.hard.show();
    for (int i = 0; i < 3; i++) {
        b.show("in_dir_i", v.dir[i], WD);
        b.show("in_normal_i", v.normal[i], WD);
    }
    b.show("in_from_i", v.from, 12);
    b.show("in_to_i", v.to, 12);
}

/* The corners, then the cases of tests/hard. */
std::vector<Vector> first(const hard::Cases &cases) {
    std::vector<Vector> directed;
    if (!hard::alone()) directed.assign(std::begin(corners), std::end(corners));
    for (const hard::Vector &c : cases) {
        Vector v{};
        memcpy(v.dir, c.c.ray.dir, sizeof v.dir);
        memcpy(v.normal, c.c.v, sizeof v.normal);
        v.from = c.c.from, v.to = c.c.to, v.hard = c;
        directed.push_back(v);
    }
    return directed;
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_refract> b("tb_refract", argc, argv, 24000);
    hard::Cases cases(b.seed, HARD_REFRACTION,
                      [](const sph_profile &p) { return p.w == W && p.wd == WD; });
    const std::vector<Vector> directed = first(cases);
    cases.limit(b);
    auto vector = [&](auto &port, const int64_t v[3]) {
        bench::u128 word = 0;
        for (int i = 0; i < 3; i++)
            word |= bench::low((bench::u128)v[i], WD) << (WD * i);
        b.set(port, 3 * WD, (bench::i128)word);
    };
    size_t corner = 0;
    long totals = 0;
    b.dut.in_valid_i = 0;
    b.reset();
    while (b.more()) {
        Vector v = corner < directed.size() ? directed[corner++] : make(b.random);
        uint64_t tag = (uint64_t)b.random.bits(TAG);
        for (uint64_t gap = b.random.percent(30) ? b.random.below(20) : 0; gap; gap--)
            b.tick();
        vector(b.dut.in_dir_i, v.dir);
        vector(b.dut.in_normal_i, v.normal);
        b.set(b.dut.in_a_i, 2 * WD, (bench::i128)dot(v.dir));
        b.set(b.dut.in_nn_i, 2 * WD, (bench::i128)dot(v.normal));
        b.set(b.dut.in_from_i, 12, v.from);
        b.set(b.dut.in_to_i, 12, v.to);
        b.set(b.dut.in_tag_i, TAG, (bench::i128)tag);
        b.dut.in_valid_i = 1;
        b.settle();
        b.expect("in_ready_o", b.get(b.dut.in_ready_o), 1);
        b.tick();
        b.dut.in_valid_i = 0;
        vector(b.dut.in_dir_i, v.normal); /* must not matter any more */
        int wait = 0;
        for (b.settle(); !b.dut.out_valid_o && wait < SLOWEST; wait++)
            b.tick();
        if (!b.dut.out_valid_o) b.fail("no result");
        struct sph_ray ray = ray_of(v);
        struct sph_surface s = surface_of(v);
        int64_t out[3] = {0, 0, 0};
        int total = !sph_refract(&profile, &ray, &s, v.from, v.to, out);
        totals += total;
        b.expect("out_tag_o", b.get(b.dut.out_tag_o), tag);
        b.expect("out_total_o", b.get(b.dut.out_total_o), total);
        bench::u128 word = b.get(b.dut.out_dir_o);
        for (int i = 0; i < 3 && !total; i++)
            b.expect("out_dir_o", bench::sign(bench::low(word >> (WD * i), WD), WD), out[i], WD);
        if (b.bad()) show(b, v);
        b.done();
        b.tick();
    }
    if (b.all_vectors && corner < directed.size()) b.fail("not all hard cases were driven");
    if (b.all_vectors && !hard::alone() && (totals < b.vectors / 20 || totals > b.vectors / 2))
        b.fail("too few or too many are reflected");
    return b.finish();
}
