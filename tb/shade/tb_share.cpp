/* tb_share.cpp - rt_share against sph_shading_light(), sph_surface_colour(), sph_shares_add()
 * SPDX-License-Identifier: Apache-2.0
 */
#include <algorithm>

#include "Vrt_share.h"
#include "bench.h"

extern "C" {
#include "shade/colour.h"
#include "shade/material.h"
}

namespace {

constexpr uint64_t LATENCY = 12, INTERVAL = 12;

struct Vector {
    int background;
    uint32_t ambient[3], lights[3], gloss[3], albedo[3];
    struct sph_shading shading;
    uint32_t weight, least;
    int depth;
    struct sph_shares shares;
    uint64_t tag, taken;
};

constexpr uint32_t ONE = 65536, LIGHT = 131071, FULL = 65535;

/* A shading; without SUM or SPECULAR what the model makes of it. */
constexpr struct sph_shading shading(int sum, uint32_t kr, uint32_t kt, uint32_t ks) {
    return {{0, 0, 0}, kr, kt, sum && SUM, 256, 256, sum && SPECULAR && SUM ? ks : 0, 0, 0};
}

const Vector corners[] = {
    /* all largest: every limit at once */
    {0,
     {32768, 32768, 32768},
     {LIGHT, LIGHT, LIGHT},
     {LIGHT, LIGHT, LIGHT},
     {255, 255, 255},
     shading(1, 256, 256, 255),
     ONE,
     0,
     0,
     {{{FULL, FULL, FULL}, {FULL, FULL, FULL}, {0, 0, 0}}},
     0,
     0},
    /* nothing at all */
    {0, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, shading(0, 0, 0, 0), 0, 0, 0, {{{0}}}, 0, 0},
    /* background, whose own shares are all of it: words that must not count */
    {1,
     {1, 2, 3},
     {LIGHT, 9, 9},
     {LIGHT, 9, 9},
     {255, 128, 1},
     shading(1, 0, 0, 255),
     40000,
     0,
     1,
     {{{5, 5, 5}, {6, 6, 6}, {7, 7, 7}}},
     0,
     0},
    /* no share left: 256 - kr - kt below 0 */
    {0,
     {0, 0, 0},
     {32768, 32768, 32768},
     {0, 0, 0},
     {200, 100, 50},
     shading(0, 200, 100, 0),
     ONE,
     0,
     0,
     {{{0}}},
     0,
     0},
    /* each share above 256: as 256 */
    {0,
     {32768, 32768, 32768},
     {LIGHT, 32768, 1},
     {0, 0, 0},
     {200, 100, 50},
     {{0, 0, 0}, 257, 511, SUM, SUM ? 257 : 256, SUM ? 511 : 256, 0, 0, 0},
     ONE,
     0,
     0,
     {{{0}}},
     0,
     0},
    /* kr + kt of 256 and one less */
    {0,
     {0, 0, 0},
     {32768, 32768, 32768},
     {0, 0, 0},
     {200, 100, 50},
     shading(0, 128, 128, 0),
     ONE,
     0,
     1,
     {{{0}}},
     0,
     0},
    {0,
     {0, 0, 0},
     {32768, 32768, 32768},
     {0, 0, 0},
     {200, 100, 50},
     shading(0, 128, 127, 0),
     32767,
     0,
     2,
     {{{0}}},
     0,
     0},
    /* both rays a bit too light: all is left to the surface */
    {0,
     {0, 0, 0},
     {32768, 32768, 32768},
     {0, 0, 0},
     {200, 100, 50},
     shading(0, 63, 63, 0),
     ONE,
     64,
     1,
     {{{0}}},
     0,
     0},
    /* the mirror ray just worth it, the refracted ray not */
    {0,
     {0, 0, 0},
     {32768, 32768, 32768},
     {0, 0, 0},
     {200, 100, 50},
     shading(1, 64, 63, 0),
     ONE,
     64,
     1,
     {{{0}}},
     0,
     0},
    /* depths beyond the frames */
    {0,
     {0, 0, 0},
     {32768, 32768, 32768},
     {0, 0, 0},
     {255, 255, 255},
     shading(0, 64, 64, 0),
     1,
     0,
     5,
     {{{FULL, 0, 0}, {0, FULL, 0}, {0, 0, FULL}}},
     0,
     0},
};

/* What counts of a share of a record. */
uint32_t counts(uint32_t share) {
    return std::min(256u, share);
}

uint32_t share(bench::Random &random) {
    return random.percent(30)   ? 0
           : random.percent(5)  ? (uint32_t)random.below(512)
           : random.percent(20) ? 256
                                : (uint32_t)random.below(257);
}

Vector make(bench::Random &random) {
    Vector v{};
    v.background = random.percent(15);
    int sum = random.percent(60);
    v.shading = shading(sum, v.background ? 0 : share(random), v.background ? 0 : share(random),
                        (uint32_t)random.below(256));
    if (v.shading.sum) v.shading.ka = share(random), v.shading.kd = share(random);
    for (int i = 0; i < 3; i++) {
        v.ambient[i] = random.percent(50) ? (uint32_t)random.below(32769) : 0;
        v.lights[i] = (uint32_t)random.mixed(random.percent(50) ? 17 : 15);
        v.gloss[i] = (uint32_t)random.mixed(random.percent(30) ? 17 : 14);
        v.albedo[i] = (uint32_t)random.mixed(8);
        for (int f = 0; f < 3; f++)
            v.shares.sum[f][i] = (uint32_t)random.mixed(random.percent(30) ? 16 : 14);
    }
    v.weight = random.percent(30) ? ONE : (uint32_t)std::min<uint64_t>(ONE, random.below(70000));
    v.least = random.percent(50) ? 0 : (uint32_t)random.below(257);
    v.depth = (int)random.below(6);
    return v;
}

bench::i128 word(const uint32_t part[3], int bits) {
    return (bench::i128)part[0] | (bench::i128)part[1] << bits | (bench::i128)part[2] << (2 * bits);
}

using Bench = bench::Bench<Vrt_share>;

void send(Bench &b, const Vector &v) {
    b.dut.in_background_i = v.background != 0;
    b.set(b.dut.in_ambient_i, 48, word(v.ambient, 16));
    uint32_t lights[3]; /* without SUM the ambient light is in them */
    for (int i = 0; i < 3; i++)
        lights[i] = SUM ? v.lights[i] : std::min(LIGHT, v.lights[i] + v.ambient[i]);
    b.set(b.dut.in_lights_i, 51, word(lights, 17));
    b.set(b.dut.in_gloss_i, 51, word(v.gloss, 17));
    b.set(b.dut.in_albedo_i, 24, word(v.albedo, 8));
    b.dut.in_sum_i = v.shading.sum != 0;
    b.set(b.dut.in_ka_i, 9, v.shading.sum ? v.shading.ka : 77); /* must not count without sum */
    b.set(b.dut.in_kd_i, 9, v.shading.sum ? v.shading.kd : 99);
    b.set(b.dut.in_ks_i, 8, v.shading.sum ? v.shading.ks : 111);
    b.set(b.dut.in_kr_i, 9, v.shading.kr);
    b.set(b.dut.in_kt_i, 9, v.shading.kt);
    b.set(b.dut.in_weight_i, 17, v.weight);
    b.set(b.dut.in_least_i, 9, v.least);
    b.set(b.dut.in_depth_i, 2, std::min(v.depth, 2));
    for (int f = 0; f < 3; f++)
        for (int i = 0; i < 3; i++) { /* 16 bits at a time: the port has 144 */
            int at = 48 * f + 16 * i;
            uint32_t *part = &b.dut.in_frames_i[at / 32];
            *part = at % 32 ? (*part & 0xffff) | v.shares.sum[f][i] << 16
                            : (*part & 0xffff0000) | v.shares.sum[f][i];
        }
}

void check(Bench &b, const Vector &e) {
    uint32_t colour[3];
    struct sph_shading shading = e.shading;
    for (uint32_t *s : {&shading.kr, &shading.kt, &shading.ka, &shading.kd})
        *s = counts(*s);
    uint32_t mirror = sph_share(e.weight, shading.kr), refract = sph_share(e.weight, shading.kt);
    shading.kr = sph_shading_worth(e.weight, shading.kr, e.least);
    shading.kt = sph_shading_worth(e.weight, shading.kt, e.least);
    for (int i = 0; i < 3; i++) {
        uint32_t light = sph_shading_light(&shading, e.ambient[i], e.lights[i]);
        colour[i] = e.background
                        ? e.albedo[i] << 8
                        : std::min(65280u, sph_surface_colour(e.albedo[i], light) +
                                               sph_surface_colour(e.shading.ks, e.gloss[i]));
    }
    struct sph_shares shares = e.shares;
    uint32_t own = sph_share(e.weight, sph_shading_own(&shading, shading.kr, shading.kt));
    sph_shares_add(&shares, e.depth, e.weight, own, colour);
    for (int f = 0; f < 3; f++)
        for (int i = 0; i < 3; i++) {
            int at = 48 * f + 16 * i;
            uint32_t sum = b.dut.out_frames_o[at / 32] >> (at % 32) & 0xffff;
            b.expect("out_frames_o", sum, shares.sum[f][i], 16);
        }
    uint32_t total = std::min(256u, shading.kr + shading.kt);
    b.expect("out_mirror_o", b.get(b.dut.out_mirror_o), mirror, 17);
    b.expect("out_refract_o", b.get(b.dut.out_refract_o), refract, 17);
    b.expect("out_light_mirror_o", b.dut.out_light_mirror_o, mirror < 256 * e.least, 1);
    b.expect("out_light_refract_o", b.dut.out_light_refract_o, refract < 256 * e.least, 1);
    b.expect("out_total_o", b.get(b.dut.out_total_o), sph_share(e.weight, total), 17);
    if (b.bad()) {
        b.show("depth", e.depth, 3);
        b.show("in_weight_i", e.weight, 17);
        b.show("in_least_i", e.least, 9);
        b.show("in_sum_i", e.shading.sum, 1);
        b.show("in_kr_i", e.shading.kr, 9);
        b.show("in_kt_i", e.shading.kt, 9);
        b.show("in_background_i", e.background, 1);
    }
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_share> b("tb_share", argc, argv);
    b.stream(
        corners, make, TAG, LATENCY, INTERVAL, [&](const Vector &v) { send(b, v); },
        [&](const Vector &v) { check(b, v); });
    return b.finish();
}
