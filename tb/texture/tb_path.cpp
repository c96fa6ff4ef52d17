/* tb_path.cpp - rt_path against sph_path_add() and, with SPREAD, sph_spread()
 * SPDX-License-Identifier: Apache-2.0
 */
#include "Vrt_path.h"
#include "bench.h"

extern "C" {
#include "texture/lod.h"
}

namespace {

constexpr int KW = W + WD + 2, PW = W + 8;
constexpr uint64_t CHUNKS = (KW + 16) / 17;
constexpr uint64_t KMAX = ((uint64_t)1 << KW) - 1, PMAX = ((uint64_t)1 << PW) - 1;

struct Vector {
    uint64_t key, y, h, path, spread, bend, tag, taken;
};

const Vector corners[] = {
    {1, 65536, 0, 0, 0, 0, 0, 0},                             /* rounds to nothing */
    {KMAX, 131071, WD - 1, 0, 0, 0, 0, 0},                    /* too long for any path */
    {0, 65536, 0, PMAX, 0, 0, 0, 0},                          /* nothing is added to the longest */
    {KMAX, 131071, 0, PMAX, 0, 0, 0, 0},                      /* over the end */
    {(uint64_t)1 << (WD - 5), 65536, 0, 0, 0, 0, 0, 0},       /* half a unit: up */
    {((uint64_t)1 << (WD - 5)) - 1, 65536, 0, 0, 0, 0, 0, 0}, /* just below */
    {KMAX, 131071, WD - 1, PMAX, 12, 3, 0, 0},                /* no shift is left */
    {(uint64_t)1 << (KW - 6), 65536, WD - 1, 0, 12, 0, 0, 0}, /* one bit of the sum, beyond it */
    {1000, 65536, 0, 16, 0, 8, 0, 0},                         /* as much as before: twice */
    {1000, 65536, 0, 16, 1, 8, 0, 0},                         /* less: nothing */
    {1000, 65536, 0, 15, 0, 8, 0, 0},                         /* just less */
    {1000, 65536, 0, 0, 3, 3, 0, 0},                          /* at the eye: nothing */
    {1000, 65536, 0, PMAX, 3, 0, 0, 0},                       /* flat */
    {1000, 65536, 0, 1, 0, 63, 0, 0},                         /* as little as can be */
    {1000, 65536, 0, 4096, 11, 2, 0, 0},                      /* to the most */
    {1000, 65536, 0, 4096, 12, 0, 0, 0},                      /* there already */
};

Vector make(bench::Random &r) {
    Vector v{};
    v.key = (uint64_t)(r.percent(50) ? r.log_bits(KW) : r.mixed(KW));
    v.y = (uint64_t)r.between(65536, 131071);
    v.h = r.below(WD);
    v.path = (uint64_t)(r.percent(50) ? r.log_bits(PW) : r.mixed(PW));
    v.spread = SPREAD ? r.below(13) : 0;
    v.bend = SPREAD && r.percent(85) ? r.below(64) : 0;
    if (SPREAD && v.path && r.percent(50)) { /* near what was before */
        uint64_t bits = 0;
        while (bits < 40 && v.path >> bits)
            bits++;
        int64_t bend = 2 * ((int64_t)bits - (int64_t)v.spread) + r.between(-3, 1);
        if (bend > 0 && bend < 64) v.bend = (uint64_t)bend;
    }
    return v;
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_path> b("tb_path", argc, argv);
    struct sph_profile p = {};
    p.w = W;
    p.wd = WD;
    auto send = [&](const Vector &v) {
        b.set(b.dut.in_key_i, KW, (bench::i128)v.key);
        b.dut.in_y_i = (uint32_t)v.y;
        b.dut.in_h_i = (uint8_t)v.h;
        b.set(b.dut.in_path_i, PW, (bench::i128)v.path);
        b.dut.in_spread_i = (uint8_t)(SPREAD ? v.spread : 0);
        b.dut.in_bend_i = (uint8_t)(SPREAD ? v.bend : 0);
    };
    auto check = [&](const Vector &e) {
        struct sph_ray ray = {};
        ray.unit.y = (uint32_t)e.y;
        ray.unit.h = (int)e.h;
        int spread = SPREAD ? sph_spread(e.path, (int)e.spread, (uint32_t)e.bend) : 0;
        b.expect("out_path_o", (bench::i128)b.get(b.dut.out_path_o),
                 (bench::i128)sph_path_add(&p, &ray, e.key, e.path, spread), PW);
        b.expect("out_spread_o", b.dut.out_spread_o, spread, 4);
        if (!b.bad()) return;
        b.show("in_key_i", (bench::i128)e.key, KW);
        b.show("in_y_i", (bench::i128)e.y, 17);
        b.show("in_h_i", (bench::i128)e.h, 6);
        b.show("in_path_i", (bench::i128)e.path, PW);
        b.show("in_spread_i", (bench::i128)e.spread, 4);
        b.show("in_bend_i", (bench::i128)e.bend, 6);
    };
    b.stream(corners, make, TAG, CHUNKS + 6, CHUNKS, send, check);
    return b.finish();
}
