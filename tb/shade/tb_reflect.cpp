/* tb_reflect.cpp - rt_reflect, or rt_reflect_twelve, and rt_normalise inside it, against
 * sph_reflect() SPDX-License-Identifier: Apache-2.0
 *
 * The hits of tests/hard come first.
 */
#include <vector>

#include "bench.h"
#ifdef TWELVE
#include "Vrt_reflect_twelve.h"
using Bounce = Vrt_reflect_twelve;
#else
#include "Vrt_reflect.h"
using Bounce = Vrt_reflect;
#define TWELVE 0
#endif
#include "hard.h"

extern "C" {
#include "shade/surface.h"
}

namespace {

constexpr uint64_t LATENCY = TWELVE ? 24 : 20, INTERVAL = TWELVE ? 24 : 10;
const struct sph_profile profile = {PROFILE, WD - 1, WD, WD, 2, 12, 0};

struct Vector {
    int64_t dir[3], normal[3];
    uint64_t tag, taken;
    hard::Case hard{};
};

constexpr int64_t MAX = ((int64_t)1 << (WD - 1)) - 1, MIN = -MAX - 1;
const Vector corners[] = {
    {{0, 0, 0}, {0, 0, 0}, 0, 0},             /* nothing: zero */
    {{1, 2, 3}, {0, 0, 0}, 0, 0},             /* no normal: zero */
    {{0, 0, 0}, {MAX, MAX, MAX}, 0, 0},       /* no direction: zero */
    {{1, 0, 0}, {1, 0, 0}, 0, 0},             /* -dir, from the smallest words */
    {{MAX, 0, 0}, {-MAX, 0, 0}, 0, 0},        /* head on: straight back */
    {{MIN, 0, 0}, {MAX, 0, 0}, 0, 0},         /* back from MIN: 2^(WD-1) needs a shift */
    {{0, MIN, 0}, {0, MIN, 0}, 0, 0},         /* the same off a normal of MIN */
    {{0, MAX, MIN}, {MAX, 0, 0}, 0, 0},       /* dir.normal = 0: dir again */
    {{MAX, -MAX, 0}, {1, 1, 1}, 0, 0},        /* the same by cancelling */
    {{MIN, MIN, MIN}, {MIN, MIN, MIN}, 0, 0}, /* the largest dn, nn and products */
    {{MIN, MIN, MIN}, {MAX, MAX, MAX}, 0, 0}, /* the smallest dn */
    {{MAX, MAX, MAX}, {MIN, MIN, MIN}, 0, 0}, /* the smallest dn, other signs */
    {{MIN, MIN, MIN}, {MIN, 0, 0}, 0, 0},     /* one component turns round */
    {{MIN, MAX, 0}, {MAX, MAX, 0}, 0, 0},     /* dn of -MAX: all but cancels */
    {{-1, -1, -1}, {1, 1, 1}, 0, 0},          /* smallest words with all components */
    {{-1, 0, 0}, {MAX, 0, 0}, 0, 0},          /* long left shift */
    {{-1, MAX, MIN}, {1, 0, 0}, 0, 0},        /* a small component beside large ones */
};

uint64_t dot(const int64_t v[3]) {
    return (uint64_t)(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

Vector make(bench::Random &random) {
    Vector v{};
    uint64_t how = random.below(8);
    for (int i = 0; i < 3; i++) {
        v.dir[i] = how < 3 ? random.sbits(WD) : random.smixed(WD);
        v.normal[i] = how < 3 ? random.sbits(WD) : random.smixed(WD);
    }
    switch (how) {
    case 4: { /* along one axis and almost 2^n: often rounds up to 2^(WD-1), or its negative */
        v.normal[2] = v.dir[0] = v.dir[1] = 0;
        uint64_t nn = dot(v.normal);
        int power = sph_bit_length(nn) + WD - 2;
        if (nn) v.dir[2] = (int64_t)((((uint64_t)1 << power) - 1) / nn);
        if (v.dir[2] > MAX) v.dir[2] = MAX;
        if (random.percent(50)) v.dir[2] = -v.dir[2];
        break;
    }
    case 5: /* dir.normal = 0 */
        v.dir[2] = 0;
        v.dir[0] = v.normal[1];
        v.dir[1] = v.normal[0] == MIN ? MAX : -v.normal[0];
        break;
    case 6: /* nearly head on */
        for (int i = 0; i < 3; i++)
            v.dir[i] = -(v.normal[i] >> 1) + random.between(-1, 1);
        break;
    default:
        break;
    }
    return v;
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Bounce> b("tb_reflect", argc, argv);
    auto send = [&](const Vector &v) {
        b.set(b.dut.in_dir_x_i, WD, v.dir[0]);
        b.set(b.dut.in_dir_y_i, WD, v.dir[1]);
        b.set(b.dut.in_dir_z_i, WD, v.dir[2]);
        b.set(b.dut.in_normal_x_i, WD, v.normal[0]);
        b.set(b.dut.in_normal_y_i, WD, v.normal[1]);
        b.set(b.dut.in_normal_z_i, WD, v.normal[2]);
        b.set(b.dut.in_nn_i, 2 * WD, (bench::i128)dot(v.normal));
    };
    auto check = [&](const Vector &e) {
        struct sph_surface s = {};
        for (int i = 0; i < 3; i++)
            s.normal[i] = e.normal[i];
        s.nn = dot(e.normal);
        int64_t out[3];
        sph_reflect(&profile, e.dir, &s, out);
        int64_t dn = 0;
        for (int i = 0; i < 3; i++)
            dn += e.dir[i] * s.normal[i];
        b.expect("out_behind_o", b.dut.out_behind_o, dn < 0, 1);
        b.expect("out_dir_x_o", b.sget(b.dut.out_dir_x_o, WD), out[0], WD);
        b.expect("out_dir_y_o", b.sget(b.dut.out_dir_y_o, WD), out[1], WD);
        b.expect("out_dir_z_o", b.sget(b.dut.out_dir_z_o, WD), out[2], WD);
        if (b.bad()) e.hard.show();
        for (int i = 0; i < 3 && b.bad(); i++) {
            b.show("in_dir_i", e.dir[i], WD);
            b.show("in_normal_i", e.normal[i], WD);
        }
    };
    std::vector<Vector> directed;
    if (!hard::alone()) directed.assign(std::begin(corners), std::end(corners));
    hard::Source source(
        b.seed, [](const sph_profile &p) { return p.wd == WD; },
        [](const hard::Case &c) { return c.mirrors; });
    source.limit(b);
    for (Vector v{}; source.next(v.hard);) {
        for (int i = 0; i < 3; i++) {
            v.dir[i] = v.hard.dir[i];
            v.normal[i] = v.hard.normal[i];
        }
        directed.push_back(v);
    }
    source.report(b);
    b.stream(directed, make, TAG, LATENCY, INTERVAL, send, check);
    return b.finish();
}
