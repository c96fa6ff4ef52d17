/* tb_colour.cpp - rt_colour against sph_surface_colour() and sph_blend_add() of one surface
 * SPDX-License-Identifier: Apache-2.0
 */
#include "Vrt_colour.h"
#include "bench.h"

extern "C" {
#include "shade/colour.h"
}

using bench::u128;

namespace {

constexpr uint64_t LATENCY = 5, INTERVAL = 3;

struct Vector {
    uint32_t light[3], albedo; /* u2.15, 0xBBGGRR */
    uint64_t tag, taken;
};

constexpr uint32_t L1 = 32768, LMAX = 131071; /* light of 1.0 and the largest */
const Vector corners[] = {
    {{0, 0, 0}, 0xffffff, 0, 0},             /* no light */
    {{LMAX, LMAX, LMAX}, 0, 0, 0},           /* black */
    {{L1, L1 + 1, LMAX}, 0xffffff, 0, 0},    /* light of 1: albedo as it is; above: limited */
    {{LMAX, LMAX, LMAX}, 0x018040, 0, 0},    /* largest light: 4, 512 and 256 times */
    {{65794, 65795, 65796}, 0x7f7f7f, 0, 0}, /* one step around the limit of 255.0 */
    {{16319, 16320, 16321}, 0x010101, 0, 0}, /* one step around 0.5, first rounding up to it */
    {{16256, 16383, 16384}, 0x010101, 0, 0}, /* the same, exactly below and at it */
    {{L1 / 2, L1 / 2 - 1, L1 / 2 - 64}, 0xff0301, 0, 0}, /* half a byte: up, just not, up */
};

Vector make(bench::Random &random) {
    Vector v{};
    v.albedo = (uint32_t)random.mixed(24);
    for (int i = 0; i < 3; i++) {
        uint32_t albedo = v.albedo >> (8 * i) & 255;
        v.light[i] = (uint32_t)random.mixed(17);
        if (!albedo || random.percent(50)) continue;
        /* near half a byte, where both roundings decide */
        int64_t light =
            (int64_t)((random.below(256) * 32768 + 16320) / albedo) + random.between(-2, 2);
        v.light[i] = light < 0 ? 0 : light > LMAX ? LMAX : (uint32_t)light;
    }
    return v;
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_colour> b("tb_colour", argc, argv);
    auto send = [&](const Vector &v) {
        b.set(b.dut.in_light_i, 51,
              (bench::i128)((u128)v.light[2] << 34 | (u128)v.light[1] << 17 | v.light[0]));
        b.set(b.dut.in_albedo_i, 24, v.albedo);
    };
    auto check = [&](const Vector &e) {
        struct sph_blend state;
        uint32_t colour[3];
        sph_blend_start(&state);
        for (int i = 0; i < 3; i++)
            colour[i] = sph_surface_colour(e.albedo >> (8 * i) & 255, e.light[i]);
        sph_blend_add(&state, colour, 0, 1);
        for (uint32_t frame : state.colour) /* all three are the same */
            b.expect("out_colour_o", b.get(b.dut.out_colour_o), frame, 24);
        if (b.bad()) {
            b.show("in_albedo_i", e.albedo, 24);
            for (uint32_t light : e.light)
                b.show("in_light_i", light, 17);
        }
    };
    b.stream(corners, make, TAG, LATENCY, INTERVAL, send, check);
    return b.finish();
}
