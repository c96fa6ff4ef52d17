/* tb_longitude.cpp - rt_longitude against sph_longitude()
 * SPDX-License-Identifier: Apache-2.0
 *
 * The cases of tests/hard come behind the corners.
 */
#include "Vrt_longitude.h"
#include "bench.h"
#include "hard.h"

#include <algorithm>
#include <cmath>
extern "C" {
#include "texture/coords.h"
}

namespace {

constexpr uint64_t LATENCY = 39, INTERVAL = 39;
constexpr int BITS = 19;

struct Vector {
    int32_t v[3]; /* s2.16 */
    uint64_t tag, taken;
    hard::Vector hard{};
};

const Vector corners[] = {
    {{0, 0, 0}, 0, 0},     /* no direction at all */
    {{0, 65536, 0}, 0, 0}, /* poles */
    {{0, -65536, 0}, 0, 0},
    {{0, 1, 0}, 0, 0}, /* the shortest on the axis */
    {{0, -1, 0}, 0, 0},
    {{0, 0, 65536}, 0, 0},  /* the middle of the image */
    {{0, 0, -65536}, 0, 0}, /* the seam, and both sides of it */
    {{1, 0, -65536}, 0, 0},
    {{-1, 0, -65536}, 0, 0},
    {{1, 0, 0}, 0, 0}, /* a quarter turn on each side */
    {{-1, 0, 0}, 0, 0},
    {{0, 0, -1}, 0, 0}, /* the shortest ones */
    {{0, 0, 1}, 0, 0},
    {{1, 65536, 1}, 0, 0}, /* next to a pole */
    {{-1, -65536, -1}, 0, 0},
    {{262143, 262143, 262143}, 0, 0}, /* longest: nothing overflows */
    {{-262144, -262144, -262144}, 0, 0},
    {{-262144, 262143, -262144}, 0, 0},
    {{262143, -262144, -262144}, 0, 0},
};

Vector make(bench::Random &random) {
    Vector v{};
    double length = 0, d[3];
    for (double &c : d) {
        c = (double)random.sbits(20);
        length += c * c;
    }
    for (int i = 0; i < 3; i++)
        v.v[i] = length > 0 ? (int32_t)std::lround(65536 * d[i] / std::sqrt(length)) : 0;
    if (random.percent(20)) v.v[random.below(3)] = (int32_t)random.log_sbits(8); /* near a plane */
    if (random.percent(20))
        for (int32_t &c : v.v)
            c = (int32_t)random.smixed(BITS);
    return v;
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_longitude> b("tb_longitude", argc, argv, 50000);
    hard::Cases cases(b.seed, HARD_AROUND, [](const sph_profile &) { return true; });
    std::vector<Vector> directed;
    if (!hard::alone()) directed.assign(std::begin(corners), std::end(corners));
    for (const hard::Vector &c : cases)
        directed.push_back({{(int32_t)c.c.v[0], (int32_t)c.c.v[1], (int32_t)c.c.v[2]}, 0, 0, c});
    cases.limit(b);
    auto send = [&](const Vector &v) {
        b.set(b.dut.in_x_i, BITS, v.v[0]);
        b.set(b.dut.in_y_i, BITS, v.v[1]);
        b.set(b.dut.in_z_i, BITS, v.v[2]);
    };
    auto check = [&](const Vector &e) {
        struct sph_longitude r = sph_longitude(e.v);
        b.expect("out_around_o", (bench::i128)b.get(b.dut.out_around_o), r.around, 18);
        b.expect("out_down_o", (bench::i128)b.get(b.dut.out_down_o), r.down, 18);
        if (b.bad()) {
            e.hard.show();
            b.show("in_x_i", e.v[0], BITS);
            b.show("in_y_i", e.v[1], BITS);
            b.show("in_z_i", e.v[2], BITS);
        }
    };
    b.stream(directed, make, TAG, LATENCY, INTERVAL, send, check);
    return b.finish();
}
