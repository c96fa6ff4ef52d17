/* tb_box.cpp - rt_box against sph_box_meets()
 * SPDX-License-Identifier: Apache-2.0
 *
 * A vector is a ray, as sph_bih_setup() makes it, and a box, most of them at some distance before
 * its origin, of any size. The limit is far away or near the depth at which the ray enters.
 * Compiled with -O0, for it has few vectors.
 */
#include <algorithm>
#include <deque>
#include "Vrt_box.h"
#include "bench.h"
extern "C" {
#include "machine/layout.h"
#include "trace/bih.h"
}

namespace {

constexpr size_t LATENCY = 9;
constexpr int CW = W + 2, PACE = SPH_BIH_G + 7;
constexpr int64_t C_MAX = ((int64_t)1 << (W + 1)) - 1;
constexpr int32_t FAR = 0x7fff;
const sph_profile profile = {PROFILE, W, WD, 0, 0, 0, 0};

struct Vector {
    sph_ray ray{};
    sph_bih_ray bih{};
    sph_box box{};
    bool in = false; /* however far away */
    int32_t near = 0, limit = 0;
};

void choose_ray(bench::Random &random, sph_ray &ray) {
    ray.kind = SPH_PRIMARY;
    do
        for (int i = 0; i < 3; i++) {
            ray.dir[i] = random.percent(10)   ? 0
                         : random.percent(50) ? random.sbits(WD)
                                              : random.log_sbits(WD);
            ray.org[i] = random.smixed(W);
        }
    while (!ray.dir[0] && !ray.dir[1] && !ray.dir[2]);
    for (int64_t d : ray.dir)
        ray.a += (uint64_t)(d * d);
}

Vector make(bench::Random &random) {
    Vector v;
    choose_ray(random, v.ray);
    int64_t way = (int64_t)random.log_bits(W + 4); /* in 2^-8 of the direction */
    int size = (int)random.below(W + 2);
    for (int i = 0; i < 3; i++) {
        int64_t at = v.ray.org[i] + (v.ray.dir[i] * way >> 8);
        if (random.percent(5)) at = random.smixed(CW);
        int64_t lo = at - (int64_t)random.log_bits(size), hi = at + (int64_t)random.log_bits(size);
        v.box.lo[i] = (int32_t)std::clamp(lo, -C_MAX - 1, C_MAX);
        v.box.hi[i] = (int32_t)std::clamp(hi, -C_MAX - 1, C_MAX);
    }
    sph_bih_setup(&profile, &v.ray, &v.bih);
    v.in = sph_box_meets(&v.bih, &v.ray, &v.box, FAR, &v.near);
    v.limit = random.percent(40) ? FAR : (int32_t)random.log_bits(15);
    if (random.percent(40)) v.limit = std::clamp(v.near + (int32_t)random.between(-1, 1), 0, FAR);
    return v;
}

void send(bench::Bench<Vrt_box> &b, const Vector &v) {
    bench::u128 places = 0, paces = 0, lo = 0, hi = 0;
    for (int i = 2; i >= 0; i--) {
        const sph_bih_axis &x = v.bih.axis[i];
        bench::u128 open = x.shift < 0, shift = open ? 0 : (unsigned)x.shift;
        places = places << W | bench::low((bench::u128)v.ray.org[i], W);
        places = places << 2 | (x.negative ? 2 : 0) | (x.zero ? 1 : 0);
        paces = paces << PACE | open << (PACE - 1) | shift << SPH_BIH_G | x.mant;
        lo = lo << CW | bench::low((bench::u128)v.box.lo[i], CW);
        hi = hi << CW | bench::low((bench::u128)v.box.hi[i], CW);
    }
    b.set(b.dut.in_places_i, 3 * CW, (bench::i128)places);
    b.set(b.dut.in_paces_i, 3 * PACE, (bench::i128)paces);
    b.set(b.dut.in_lo_i, 3 * CW, (bench::i128)lo);
    b.set(b.dut.in_hi_i, 3 * CW, (bench::i128)hi);
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_box> b("tb_box", argc, argv, 60000);
    std::deque<Vector> sent;
    long met = 0;
    while (b.more()) {
        sent.push_back(make(b.random));
        send(b, sent.back());
        b.dut.in_limit_i = (uint16_t)sent.front().limit;
        b.tick();
        if (sent.size() < LATENCY) continue;
        const Vector v = sent.front();
        sent.pop_front();
        b.expect("out_pass_o", b.dut.out_pass_o, v.in && v.near <= v.limit, 1);
        if (v.in) b.expect("out_near_o", b.dut.out_near_o, v.near, 15);
        met += v.in;
        if (b.bad())
            for (int i = 0; i < 3; i++) {
                b.show("org", v.ray.org[i], W);
                b.show("dir", v.ray.dir[i], WD);
                b.show("lo", v.box.lo[i], CW);
                b.show("hi", v.box.hi[i], CW);
            }
        b.done();
    }
    if (b.all_vectors && 4 * met < b.vectors) b.fail("too few boxes are met");
    return b.finish();
}
