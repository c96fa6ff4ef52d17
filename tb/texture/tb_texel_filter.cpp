/* tb_texel_filter.cpp - rt_texel_filter against sph_filter_bilinear() and sph_filter_levels()
 * SPDX-License-Identifier: Apache-2.0
 *
 * The cases of tests/hard come behind the corners.
 */
#include "Vrt_texel_filter.h"
#include "bench.h"
#include "hard.h"
extern "C" {
#include "texture/texel.h"
}

namespace {

struct Vector {
    uint32_t near[4], far[4]; /* 0xBBGGRR */
    uint32_t near_weight, far_weight, level;
    uint64_t tag, taken;
    hard::Vector hard{};
};

const uint32_t WHITE = 0xffffff;
const Vector corners[] = {
    {{1, 2, 3, 4}, {5, 6, 7, 8}, 0, 0, 0, 0, 0}, /* nearest: the first */
    {{0xc0ffee, 0xc0ffee, 0xc0ffee, 0xc0ffee},
     {0xc0ffee, 0xc0ffee, 0xc0ffee, 0xc0ffee},
     0x80ff,
     0x1337,
     127,
     0,
     0},                                                                     /* one colour stays */
    {{0, WHITE, WHITE, 0}, {WHITE, 0, 0, WHITE}, 0xffff, 0xffff, 255, 0, 0}, /* greatest slopes */
    {{0, 0, 0, WHITE}, {0, 0, 0, WHITE}, 0xffff, 0xffff, 0, 0, 0},
    {{WHITE, 0, 0, 0}, {WHITE, 0, 0, 0}, 0xffff, 0xffff, 0, 0, 0},
    {{0, 0, 0, 0}, {0x010101, 0x010101, 0x010101, 0x010101}, 0, 0, 128, 0, 0}, /* half: up */
    {{0, 0, 0, 0}, {0x010101, 0x010101, 0x010101, 0x010101}, 0, 0, 127, 0, 0}, /* below: down */
    {{0, 0x010101, 0, 0}, {0, 0, 0, 0}, 0x0080, 0, 0, 0, 0}, /* half in x: up at the end */
    {{0, 0x010101, 0, 0}, {0, 0, 0, 0}, 0x8001, 0, 0, 0, 0}, /* half of 2^-8 in y */
    {{0, 0, 0, 0}, {WHITE, WHITE, WHITE, WHITE}, 0xffff, 0xffff, 0, 0, 0}, /* far is not seen */
};

Vector make(bench::Random &random) {
    Vector v{};
    uint32_t same = (uint32_t)random.mixed(24);
    for (int i = 0; i < 8; i++)
        (i < 4 ? v.near : v.far)[i & 3] = random.percent(20) ? same : (uint32_t)random.mixed(24);
    v.near_weight = (uint32_t)random.mixed(16);
    v.far_weight = (uint32_t)random.mixed(16);
    v.level = (uint32_t)random.mixed(8);
    return v;
}

/* Four texels as one word, the first low. */
bench::i128 pack(const uint32_t texel[4]) {
    bench::u128 x = 0;
    for (int i = 3; i >= 0; i--)
        x = x << 24 | texel[i];
    return (bench::i128)x;
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_texel_filter> b("tb_texel_filter", argc, argv);
    hard::Cases cases(b.seed, HARD_TEXELS, [](const sph_profile &) { return true; });
    std::vector<Vector> directed;
    if (!hard::alone()) directed.assign(std::begin(corners), std::end(corners));
    for (const hard::Vector &c : cases) {
        Vector v{};
        for (int i = 0; i < 4; i++)
            v.near[i] = c.c.texel.near[i] & WHITE, v.far[i] = c.c.texel.far[i] & WHITE;
        v.near_weight = v.far_weight = c.c.texel.wy << 8 | c.c.texel.wx;
        v.level = c.c.texel.between;
        v.hard = c;
        directed.push_back(v);
    }
    cases.limit(b);
    auto send = [&](const Vector &v) {
        b.set(b.dut.in_near_i, 96, pack(v.near));
        b.set(b.dut.in_far_i, 96, pack(v.far));
        b.set(b.dut.in_near_weight_i, 16, v.near_weight);
        b.set(b.dut.in_far_weight_i, 16, v.far_weight);
        b.set(b.dut.in_level_i, 8, v.level);
    };
    auto check = [&](const Vector &e) {
        uint32_t near[4], far[4];
        sph_filter_bilinear(e.near, e.near_weight & 255, e.near_weight >> 8, near);
        sph_filter_bilinear(e.far, e.far_weight & 255, e.far_weight >> 8, far);
        uint32_t expected = sph_filter_levels(near, far, e.level) & 0xffffff;
        b.expect("out_texel_o", (bench::i128)b.get(b.dut.out_texel_o), expected, 24);
        if (b.bad()) {
            e.hard.show();
            b.show("in_near_i", pack(e.near), 96);
            b.show("in_far_i", pack(e.far), 96);
            b.show("in_near_weight_i", e.near_weight, 16);
            b.show("in_far_weight_i", e.far_weight, 16);
            b.show("in_level_i", e.level, 8);
        }
    };
    b.stream(directed, make, TAG, 13, 7, send, check);
    return b.finish();
}
