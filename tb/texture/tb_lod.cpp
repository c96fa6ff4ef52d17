/* tb_lod.cpp - rt_lod against sph_lod()
 * SPDX-License-Identifier: Apache-2.0
 *
 * The cases of tests/hard come behind the corners.
 */
#include "Vrt_lod.h"
#include "bench.h"
#include "hard.h"
extern "C" {
#include "texture/lod.h"
}

namespace {

struct Vector {
    uint32_t path; /* u(PB-4).4 */
    int32_t base;  /* s7.8 */
    int levels;
    uint64_t tag, taken;
    hard::Vector hard{};
};

const uint32_t LONGEST = 0xffffffffu >> (32 - PB);

const Vector corners[] = {
    {0, -32768, 12, 0, 0},         /* no path: level 0 */
    {0, 32767, 1, 0, 0},           /* the same */
    {1, -32768, 12, 0, 0},         /* the shortest path, the smallest base: the last level */
    {1, -1024, 12, 0, 0},          /* just level 0 */
    {1, -1025, 12, 0, 0},          /* 1/256 of a level more */
    {1, -1023, 12, 0, 0},          /* less: limited */
    {16, -11 * 256, 12, 0, 0},     /* just the last level */
    {16, -11 * 256 + 1, 12, 0, 0}, /* 1/256 less */
    {16, -11 * 256 - 1, 12, 0, 0}, /* 1/256 more: limited */
    {16, -1, 1, 0, 0},             /* one level: always 0 */
    {LONGEST, 32767, 12, 0, 0},    /* the longest path, the largest base */
    {LONGEST, -32768, 12, 0, 0},   /* the largest difference */
};

Vector make(bench::Random &random) {
    Vector v{};
    v.path = (uint32_t)(random.percent(50) ? random.log_bits(PB) : random.mixed(PB));
    v.levels = 1 + (int)random.below(12);
    v.base = (int32_t)random.smixed(16);
    if (random.percent(60)) { /* around the levels that there are */
        int32_t log2 = v.path ? (int32_t)sph_log2(v.path) - 1024 : 0;
        v.base = log2 - (int32_t)random.between(-300, v.levels * 256 + 300);
    }
    return v;
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_lod> b("tb_lod", argc, argv);
    hard::Cases cases(b.seed, HARD_LEVELS, [](const sph_profile &p) { return p.w + 8 == PB; });
    std::vector<Vector> directed;
    if (!hard::alone()) directed.assign(std::begin(corners), std::end(corners));
    for (const hard::Vector &c : cases)
        directed.push_back({c.c.level.path, c.c.level.base, c.c.level.levels, 0, 0, c});
    cases.limit(b);
    auto send = [&](const Vector &v) {
        b.set(b.dut.in_path_i, PB, v.path);
        b.set(b.dut.in_base_i, 16, v.base);
        b.set(b.dut.in_levels_i, 4, v.levels);
    };
    auto check = [&](const Vector &e) {
        uint32_t expected = sph_lod(e.path, (int16_t)e.base, e.levels);
        b.expect("out_lod_o", (bench::i128)b.get(b.dut.out_lod_o), expected, 12);
        if (b.bad()) {
            e.hard.show();
            b.show("in_path_i", e.path, PB);
            b.show("in_base_i", (int16_t)e.base, 16);
            b.show("in_levels_i", e.levels, 4);
        }
    };
    b.stream(directed, make, TAG, 5, 1, send, check);
    return b.finish();
}
