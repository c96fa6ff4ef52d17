/* tb_blend.cpp - rt_blend against sph_surface_colour() and sph_blend_add()
 * SPDX-License-Identifier: Apache-2.0
 *
 * Corners, then whole pixels (chains of depths from sph_blend_start) mixed with any state.
 */
#include "Vrt_blend.h"
#include "bench.h"

extern "C" {
#include "shade/colour.h"
}

using bench::u128;

namespace {

constexpr uint64_t LATENCY = 9, INTERVAL = 8;
constexpr int DW = REFLECT > 7 ? 4 : REFLECT > 3 ? 3 : REFLECT > 1 ? 2 : 1; /* bits of the depth */
constexpr int FRAMES = REFLECT > 1 ? 3 : 2;

struct Vector {
    uint32_t light[3], albedo; /* u2.15, 0xBBGGRR */
    uint32_t background, kr, last;
    struct sph_blend state;
    uint64_t tag, taken;
};

constexpr uint32_t L1 = 32768, LMAX = 131071; /* light of 1.0 and the largest */
constexpr uint32_t W1 = 65536;                /* weight of 1.0 */
const Vector corners[] = {
    /* black, nothing behind: closes all frames */
    {{0, 0, 0}, 0, 0, 0, 1, {{0, 0, 0}, W1, 0, {1, 2, 3}}, 0, 0},
    /* background at once: colour as it is in all frames */
    {{0, 1, LMAX}, 0xff8001, 1, 0, 1, {{0, 0, 0}, W1, 0, {1, 2, 3}}, 0, 0},
    /* light of 1: albedo as it is; light above 1: limited to 255.0 */
    {{L1, L1 + 1, LMAX}, 0xffffff, 0, 0, 1, {{0, 0, 0}, W1, 0, {1, 2, 3}}, 0, 0},
    /* one step around the limit of 255.0 */
    {{65794, 65795, 65796}, 0x7f7f7f, 0, 0, 0, {{0, 0, 0}, W1, 0, {1, 2, 3}}, 0, 0},
    /* product rounds: 63/128 down, 64/128 up, 65/128 up */
    {{63, 64, 65}, 0x010101, 0, 128, 0, {{0, 0, 0}, W1, 0, {1, 2, 3}}, 0, 0},
    /* kr 0: nothing is left for what lies behind; not last: only frame 0 */
    {{L1, L1, L1}, 0x804020, 0, 0, 0, {{0, 0, 0}, W1, 0, {1, 2, 3}}, 0, 0},
    /* kr 256: a perfect mirror adds nothing, weight stays 1 */
    {{LMAX, LMAX, LMAX}, 0xffffff, 0, 256, 0, {{0, 0, 0}, W1, 0, {1, 2, 3}}, 0, 0},
    /* kr above 256 counts as 256 */
    {{L1, L1, L1}, 0x123456, 0, 257, 0, {{4, 5, 6}, W1 - 1, 0, {1, 2, 3}}, 0, 0},
    {{L1, L1, L1}, 0xffffff, 0, 511, 1, {{4, 5, 6}, W1, 1, {1, 2, 3}}, 0, 0},
    /* kr 1 and 255: rounding of the weights to either side */
    {{L1, L1, L1}, 0xfe017f, 0, 1, 0, {{0, 0, 0}, 32767, 1, {1, 2, 3}}, 0, 0},
    {{L1, L1, L1}, 0xfe017f, 0, 255, 0, {{0, 0, 0}, 384, 1, {1, 2, 3}}, 0, 0},
    /* weight*kr = 127/256, 128/256: weight 0 and 1 */
    {{L1, L1, L1}, 0xffffff, 0, 127, 0, {{9, 9, 9}, 1, 2, {1, 2, 3}}, 0, 0},
    {{L1, L1, L1}, 0xffffff, 0, 128, 0, {{9, 9, 9}, 1, 2, {1, 2, 3}}, 0, 0},
    /* weight 0: only the sum is seen; bytes round at 127/256, 128/256 */
    {{L1, L1, L1}, 0xffffff, 0, 64, 1, {{127, 128, 0x7f80}, 0, 1, {1, 2, 3}}, 0, 0},
    /* byte limit: 255.0, just below and above 255.5, most of all */
    {{0, 0, 0}, 0, 0, 64, 1, {{65280, 65407, 65408}, W1, 2, {1, 2, 3}}, 0, 0},
    {{LMAX, LMAX, LMAX}, 0xffffff, 0, 0, 1, {{65535, 65535, 65279}, W1, 2, {1, 2, 3}}, 0, 0},
    /* each depth, last and not: which frames change */
    {{L1, L1, L1}, 0x112233, 0, 64, 0, {{1, 2, 3}, 999, 1, {7, 8, 9}}, 0, 0},
    {{L1, L1, L1}, 0x112233, 0, 64, 1, {{1, 2, 3}, 999, 1, {7, 8, 9}}, 0, 0},
    {{L1, L1, L1}, 0x112233, 0, 64, 0, {{1, 2, 3}, 999, 2, {7, 8, 9}}, 0, 0},
    {{L1, L1, L1}, 0x112233, 0, 64, 1, {{1, 2, 3}, 999, 3, {7, 8, 9}}, 0, 0},
    {{L1, L1, L1}, 0x112233, 0, 64, 0, {{1, 2, 3}, 999, 4, {7, 8, 9}}, 0, 0},
    {{L1, L1, L1}, 0x112233, 0, 64, 1, {{1, 2, 3}, 999, 7, {7, 8, 9}}, 0, 0},
};

/* A corner may be deeper than this core goes. */
int depth(const Vector &v) {
    return v.state.depth < REFLECT ? v.state.depth : REFLECT;
}

/* Colour of the surface, then the blend, on *state. */
void model(const Vector &v, struct sph_blend *state) {
    uint32_t colour[3];
    for (int i = 0; i < 3; i++) {
        uint32_t albedo = v.albedo >> (8 * i) & 255;
        colour[i] = v.background ? albedo << 8 : sph_surface_colour(albedo, v.light[i]);
    }
    sph_blend_add(state, colour, v.kr < 256 ? v.kr : 256, (int)v.last);
}

Vector make(bench::Random &random) {
    static struct sph_blend pixel; /* the chain */
    static bool chained = false;
    Vector v{};
    v.albedo = (uint32_t)random.mixed(24);
    for (int i = 0; i < 3; i++)
        v.light[i] = (uint32_t)random.mixed(17);
    v.background = random.percent(20);
    v.kr = (uint32_t)(random.percent(20) ? random.below(2) * 256 : random.below(258));
    if (random.percent(5)) v.kr = (uint32_t)random.below(512);
    v.last = random.percent(30);
    if (random.percent(30)) { /* any state; what a pixel cannot reach too */
        for (int i = 0; i < 3; i++) {
            v.state.sum[i] = (uint32_t)random.mixed(16);
            v.state.colour[i] = (uint32_t)random.bits(24);
        }
        v.state.weight =
            (uint32_t)(random.percent(20) ? random.below(2) * W1 : random.below(W1 + 1));
        v.state.depth = (int)random.below(REFLECT + 1);
        return v;
    }
    if (!chained) sph_blend_start(&pixel);
    v.state = pixel;
    v.last |= pixel.depth == REFLECT;
    model(v, &pixel);
    chained = !v.last;
    return v;
}

/* Three channels as one word, red low. */
bench::i128 pack(const uint32_t channel[3], int bits) {
    return (bench::i128)((u128)channel[2] << 2 * bits | (u128)channel[1] << bits | channel[0]);
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_blend> b("tb_blend", argc, argv);
    auto send = [&](const Vector &v) {
        b.set(b.dut.in_light_i, 51, pack(v.light, 17));
        b.set(b.dut.in_albedo_i, 24, v.albedo);
        b.dut.in_background_i = (uint8_t)v.background;
        b.set(b.dut.in_kr_i, 9, v.kr);
        b.set(b.dut.in_sum_i, 48, pack(v.state.sum, 16));
        b.set(b.dut.in_weight_i, 17, v.state.weight);
        b.set(b.dut.in_depth_i, DW, depth(v));
        b.set(b.dut.in_colour_i, 24 * FRAMES - 24, pack(v.state.colour, 24));
    };
    auto check = [&](const Vector &e) {
        struct sph_blend s = e.state;
        s.depth = depth(e);
        model(e, &s);
        for (uint32_t &sum : s.sum)
            sum &= 0xffff; /* only states that no pixel reaches go beyond */
        b.expect("out_sum_o", (bench::i128)b.get(b.dut.out_sum_o), pack(s.sum, 16), 48);
        b.expect("out_weight_o", b.get(b.dut.out_weight_o), s.weight, 17);
        b.expect("out_depth_o", b.get(b.dut.out_depth_o), s.depth & ((1 << DW) - 1), DW);
        for (int i = 0; i < FRAMES; i++) /* frames of greater depths are complete with the last */
            if (i < s.depth || e.last)
                b.expect("out_colour_o", bench::low(b.get(b.dut.out_colour_o) >> (24 * i), 24),
                         s.colour[i], 24);
        if (b.bad()) {
            b.show("in_light_i", pack(e.light, 17), 51);
            b.show("in_albedo_i", e.albedo, 24);
            b.show("in_background_i", e.background, 1);
            b.show("in_kr_i", e.kr, 9);
            b.show("in_last_i", e.last, 1);
            b.show("in_sum_i", pack(e.state.sum, 16), 48);
            b.show("in_weight_i", e.state.weight, 17);
            b.show("in_depth_i", depth(e), DW);
            b.show("in_colour_i", pack(e.state.colour, 24), 72);
        }
    };
    b.stream(corners, make, TAG, LATENCY, INTERVAL, send, check);
    return b.finish();
}
