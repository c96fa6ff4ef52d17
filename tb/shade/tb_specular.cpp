/* tb_specular.cpp - rt_specular against sph_specular_cosine() and sph_power()
 * SPDX-License-Identifier: Apache-2.0
 */
#include "Vrt_specular.h"
#include "bench.h"

extern "C" {
#include "shade/colour.h"
}

namespace {

constexpr uint64_t LATENCY = 23, INTERVAL = 24;
constexpr int BITS = 17, ONE = 65536;

struct Vector {
    struct sph_unit normal, light, dir;
    uint32_t power; /* u8.4 */
    uint64_t tag, taken;
};

struct sph_unit unit(int64_t x, int64_t y, int64_t z) {
    int64_t v[3] = {x, y, z};
    return sph_unit(v, (uint64_t)(x * x + y * y + z * z), BITS);
}

/* Normal, to the light, of the ray, power u8.4. A unit vector has length ONE. */
constexpr struct sph_unit NONE = {{0, 0, 0}, 0, 0}, Y = {{0, ONE, 0}, 0, 0},
                          Z = {{0, 0, ONE}, 0, 0};

/* Beside the normal Z the cosine of Y and (ONE, y, 0) is y / ONE. */
constexpr struct sph_unit along(int y) {
    return {{ONE, y, 0}, 0, 0};
}

constexpr struct sph_unit down(int z) {
    return {{0, 0, -z}, 0, 0};
}

const Vector corners[] = {
    {Z, Z, down(ONE), 16, 0, 0},      /* c = 1 */
    {Z, Z, down(ONE), 4095, 0, 0},    /* 1 stays 1 */
    {Z, Z, Z, 16, 0, 0},              /* c = -1: 0 */
    {Z, Y, along(0), 16, 0, 0},       /* c = 0: 0 */
    {Z, Y, along(1), 16, 0, 0},       /* the least c */
    {Z, Y, along(2), 16, 0, 0},       /* the next */
    {Z, Y, along(3), 4095, 0, 0},     /* far below */
    {Z, Y, along(65535), 4080, 0, 0}, /* near 1 */
    {Z, Y, along(32768), 16, 0, 0},   /* a half */
    {Z, Y, along(32768), 256, 0, 0},  /* 2^-16 */
    {Z, Y, along(32768), 257, 0, 0},  /* below it */
    {Z, Y, along(32768), 272, 0, 0},  /* 2^-17 */
    {Z, Z, down(ONE + 1), 16, 0, 0},  /* above 1 */
    {NONE, NONE, NONE, 0, 0, 0},      /* nothing */
};

Vector make(bench::Random &random) {
    Vector v{};
    int64_t n[3], l[3], d[3];
    for (int i = 0; i < 3; i++) {
        n[i] = random.sbits(BITS - 1);
        l[i] = random.sbits(BITS - 1);
        d[i] = random.sbits(BITS - 1);
    }
    v.normal = unit(n[0], n[1], n[2]);
    uint64_t how = random.below(8);
    if (how > 2) { /* on or near the mirror direction, where highlights are */
        int64_t nn = 0, nl = 0;
        for (int i = 0; i < 3; i++) {
            nn += n[i] * n[i];
            nl += n[i] * l[i];
        }
        int64_t off = how > 5 ? 1 : 1 << random.below(14);
        for (int i = 0; i < 3; i++)
            d[i] = (nn ? l[i] - 2 * nl * n[i] / nn : l[i]) / 4 + random.between(-off, off);
    }
    v.light = unit(l[0], l[1], l[2]);
    v.dir = unit(d[0], d[1], d[2]);
    v.power = random.percent(30) ? (uint32_t)random.mixed(12) : (uint32_t)random.below(800);
    if (how == 0) { /* any cosine, not cut: every line of both tables */
        v.normal = {{0, 0, ONE}, 0, 0};
        v.light = {{0, ONE, 0}, 0, 0};
        v.dir = {{0, static_cast<int32_t>(random.between(1, ONE)), 0}, 0, 0};
        v.power = 1 + (uint32_t)random.below(64);
    }
    return v;
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_specular> b("tb_specular", argc, argv, 100000);
    auto vector = [&](auto &port, const struct sph_unit &unit) {
        bench::u128 word = 0;
        for (int i = 0; i < 3; i++)
            word |= bench::low((bench::u128)(int64_t)unit.u[i], 18) << (18 * i);
        b.set(port, 54, (bench::i128)word);
    };
    auto send = [&](const Vector &v) {
        vector(b.dut.in_normal_i, v.normal);
        vector(b.dut.in_light_i, v.light);
        vector(b.dut.in_dir_i, v.dir);
        b.set(b.dut.in_power_i, 12, v.power);
    };
    long shines = 0;
    auto check = [&](const Vector &e) {
        uint32_t c = sph_specular_cosine(&e.normal, &e.light, &e.dir);
        uint32_t highlight = sph_power(c, e.power);
        shines += highlight != 0 && highlight != 32768;
        b.expect("out_highlight_o", b.get(b.dut.out_highlight_o), highlight, 16);
        for (int i = 0; i < 3 && b.bad(); i++) {
            b.show("in_normal_i", e.normal.u[i], 18);
            b.show("in_light_i", e.light.u[i], 18);
            b.show("in_dir_i", e.dir.u[i], 18);
        }
        if (b.bad()) b.show("cosine", c, 17), b.show("in_power_i", e.power, 12);
    };
    b.stream(corners, make, TAG, LATENCY, INTERVAL, send, check);
    if (b.all_vectors && shines < b.vectors / 4) b.fail("too few highlights");
    return b.finish();
}
