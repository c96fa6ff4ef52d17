/* tb_axis.cpp - rt_axis against sph_axis_at()
 * SPDX-License-Identifier: Apache-2.0
 */
#include "Vrt_axis.h"
#include "bench.h"
extern "C" {
#include "texture/texel.h"
}

namespace {

struct Vector {
    int64_t at;    /* s19.20 */
    uint32_t last; /* size of level 0, less 1 */
    int level, clamp;
    uint64_t tag, taken;
};

constexpr int64_t ONE = 1 << 20;
const Vector corners[] = {
    {0, 0, 0, 0, 0, 0},          /* one texel */
    {0, 0, 11, 1, 0, 0},         /* of a level that is no smaller */
    {0, 2047, 0, 0, 0, 0},       /* the first: its neighbour is the last */
    {0, 2047, 0, 1, 0, 0},       /* clamped: itself */
    {ONE - 1, 2047, 0, 0, 0, 0}, /* the last: its neighbour is the first */
    {ONE - 1, 2047, 0, 1, 0, 0},
    {ONE, 2047, 0, 0, 0, 0}, /* 1 is 0 again, or the edge */
    {ONE, 2047, 0, 1, 0, 0},
    {-1, 2047, 0, 0, 0, 0}, /* just before 0 */
    {-1, 2047, 0, 1, 0, 0},
    {ONE << 18, 4095, 0, 1, 0, 0}, /* far away */
    {-(ONE << 19), 4095, 0, 1, 0, 0},
    {ONE / 4, 1, 0, 0, 0, 0},     /* the middle of a texel: weight 0 */
    {ONE / 4 - 1, 1, 0, 0, 0, 0}, /* before it: the texel before */
    {ONE / 2, 4095, 11, 0, 0, 0}, /* between the two of a small level */
};

Vector make(bench::Random &random) {
    Vector v{};
    v.last = (uint32_t)random.mixed(12);
    v.level = (int)random.below(12);
    v.clamp = (int)random.below(2);
    v.at = random.smixed(40);
    if (random.percent(50)) { /* around edges and middles of texels */
        int64_t size = sph_level_size(v.last + 1, v.level);
        v.at = random.between(-4, 4 * size + 4) * ONE / (2 * size) + random.between(-2, 2);
    }
    return v;
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_axis> b("tb_axis", argc, argv);
    auto send = [&](const Vector &v) {
        b.set(b.dut.in_at_i, 40, v.at);
        b.set(b.dut.in_last_i, 12, v.last);
        b.set(b.dut.in_level_i, 4, v.level);
        b.set(b.dut.in_clamp_i, 1, v.clamp);
    };
    auto check = [&](const Vector &e) {
        struct sph_axis r = sph_axis_at(e.at, sph_level_size(e.last + 1, e.level), e.clamp);
        b.expect("out_first_o", (bench::i128)b.get(b.dut.out_first_o), r.texel[0], 12);
        b.expect("out_second_o", (bench::i128)b.get(b.dut.out_second_o), r.texel[1], 12);
        b.expect("out_nearest_o", (bench::i128)b.get(b.dut.out_nearest_o), r.nearest, 12);
        b.expect("out_weight_o", (bench::i128)b.get(b.dut.out_weight_o), r.weight, 8);
        if (b.bad()) {
            b.show("in_at_i", e.at, 40);
            b.show("in_last_i", e.last, 12);
            b.show("in_level_i", e.level, 4);
            b.show("in_clamp_i", e.clamp, 1);
        }
    };
    b.stream(corners, make, TAG, 4, 1, send, check);
    return b.finish();
}
