/* tb_path.cpp - rt_path against sph_path_add()
 * SPDX-License-Identifier: Apache-2.0
 */
#include "Vrt_path.h"
#include "bench.h"
extern "C" {
#include "texture/lod.h"
}

namespace {

constexpr int KB = W + WD + 2, PB = W + 8;
constexpr uint64_t LATENCY = (KB + 1 + 15) / 17 == 2 ? 5 : 6;
constexpr uint64_t MOST = (1ull << PB) - 1, LONGEST = ~0ull >> (64 - KB);

struct Vector {
    uint64_t key;  /* u(W+WD+2) */
    uint32_t y;    /* u1.16 */
    int h;         /* 0 to WD */
    uint64_t path; /* u(W+4).4 */
    uint64_t tag, taken;
};

const Vector corners[] = {
    {0, 65536, 0, 0, 0, 0},               /* nothing */
    {1, 65536, WD, 0, 0, 0},              /* key 1 of the shortest direction: the length is 1 */
    {1, 65536, WD - 5, 0, 0, 0},          /* half a last bit: up */
    {1, 65535, WD - 5, 0, 0, 0},          /* less: down */
    {LONGEST, 131071, WD, 0, 0, 0},       /* as long as words allow: limited */
    {LONGEST, 131071, 0, 0, 0, 0},        /* of the longest direction */
    {16, 65536, WD - 4, MOST - 16, 0, 0}, /* just the limit */
    {17, 65536, WD - 4, MOST - 16, 0, 0}, /* one beyond */
    {0, 65536, 3, MOST, 0, 0},            /* at the limit already */
};

Vector make(bench::Random &random) {
    Vector v{};
    v.key = (uint64_t)(random.percent(50) ? random.log_bits(KB) : random.mixed(KB));
    v.y = 65536 + (uint32_t)random.mixed(16);
    v.h = (int)random.below(WD + 1);
    v.path = (uint64_t)(random.percent(50) ? random.log_bits(PB) : random.mixed(PB));
    return v;
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_path> b("tb_path", argc, argv);
    sph_profile profile{};
    profile.w = W;
    profile.wd = WD;
    auto send = [&](const Vector &v) {
        b.set(b.dut.in_key_i, KB, (bench::i128)v.key);
        b.set(b.dut.in_y_i, 17, v.y);
        b.set(b.dut.in_h_i, 6, v.h);
        b.set(b.dut.in_path_i, PB, (bench::i128)v.path);
    };
    auto check = [&](const Vector &e) {
        sph_ray ray{};
        ray.unit.y = e.y;
        ray.unit.h = e.h;
        uint64_t expected = sph_path_add(&profile, &ray, e.key, e.path);
        b.expect("out_path_o", (bench::i128)b.get(b.dut.out_path_o), (bench::i128)expected, PB);
        if (b.bad()) {
            b.show("in_key_i", (bench::i128)e.key, KB);
            b.show("in_y_i", e.y, 17);
            b.show("in_h_i", e.h, 6);
            b.show("in_path_i", (bench::i128)e.path, PB);
        }
    };
    b.stream(corners, make, TAG, LATENCY, 1, send, check);
    return b.finish();
}
