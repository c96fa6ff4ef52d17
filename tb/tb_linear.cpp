/* tb_linear.cpp - rt_linear against sph_coords_facet()
 * SPDX-License-Identifier: Apache-2.0
 */
#include "Vrt_linear.h"
#include "bench.h"
extern "C" {
#include "machine/machine.h"
#include "texture/coords.h"
}

namespace {

constexpr int VW = W + NG;
constexpr uint64_t LATENCY = VW > 18 ? 7 : 6;
constexpr int64_t FAR = (int64_t)1 << (VW - 1);

struct Vector {
    int64_t point[3]; /* s(W+NG) */
    int32_t slope[3]; /* s18 */
    int e;            /* s6 */
    int64_t at_0;     /* s19.20 */
    uint64_t tag, taken;
};

const Vector corners[] = {
    {{0, 0, 0}, {0, 0, 0}, 0, 0, 0, 0},   /* nothing */
    {{1, 0, 0}, {1, 0, 0}, 0, 5, 0, 0},   /* one */
    {{1, 0, 0}, {1, 0, 0}, 1, 0, 0, 0},   /* a half: up */
    {{-1, 0, 0}, {1, 0, 0}, 1, 0, 0, 0},  /* minus a half: up */
    {{-1, 0, 0}, {3, 0, 0}, 2, 0, 0, 0},  /* below: down */
    {{1, 0, 0}, {1, 0, 0}, -32, 0, 0, 0}, /* shifted left all the way */
    {{0, 0, 1}, {0, 0, -1}, -32, 0, 0, 0},
    {{FAR - 1, FAR - 1, FAR - 1}, {131071, 131071, 131071}, 31, 0, 0, 0}, /* right all the way */
    {{-FAR, -FAR, -FAR}, {-131072, -131072, -131072}, 0, 0, 0, 0},        /* the largest product */
    {{-FAR, -FAR, -FAR}, {131071, 131071, 131071}, 0, 0, 0, 0},           /* and the smallest */
    {{-FAR, -FAR, -FAR}, {-131072, -131072, -131072}, -32, -1, 0, 0},
    {{0, 0, 0}, {7, 7, 7}, 3, -((int64_t)1 << 39), 0, 0},    /* ends of at_0 */
    {{1, 1, 1}, {1, 1, 1}, 0, ((int64_t)1 << 39) - 1, 0, 0}, /* over the end: modulo */
};

Vector make(bench::Random &random) {
    Vector v{};
    for (int i = 0; i < 3; i++) {
        v.point[i] = random.smixed(VW);
        v.slope[i] = (int32_t)random.smixed(18);
    }
    v.e = (int)random.between(-32, 31);
    v.at_0 = random.smixed(40);
    return v;
}

/* Three numbers as one word, the first low. */
template <class T> bench::i128 pack(const T v[3], int bits) {
    bench::u128 x = 0;
    for (int i = 2; i >= 0; i--)
        x = x << bits | bench::low((bench::u128)(bench::i128)v[i], bits);
    return (bench::i128)x;
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_linear> b("tb_linear", argc, argv);
    auto send = [&](const Vector &v) {
        b.set(b.dut.in_point_i, 3 * VW, pack(v.point, VW));
        b.set(b.dut.in_slope_i, 54, pack(v.slope, 18));
        b.set(b.dut.in_e_i, 6, v.e);
        b.set(b.dut.in_at_0_i, 40, v.at_0);
    };
    auto check = [&](const Vector &e) {
        uint32_t map[SPH_LINE_WORDS] = {0};
        for (int i = 0; i < 3; i++)
            sph_field_set(map, SPH_MAP_S_X_LSB + SPH_MAP_S_X_BITS * i, SPH_MAP_S_X_BITS,
                          (uint32_t)e.slope[i]);
        sph_field_set(map, SPH_MAP_S_E_LSB, SPH_MAP_S_E_BITS, (uint32_t)e.e);
        sph_field_set(map, SPH_MAP_S_0_LSB, 32, (uint32_t)e.at_0);
        sph_field_set(map, SPH_MAP_S_0_LSB + 32, SPH_MAP_S_0_BITS - 32, (uint32_t)(e.at_0 >> 32));
        int64_t expected = sph_coords_facet(map, e.point).at[0];
        b.expect("out_at_o", bench::sign(b.get(b.dut.out_at_o), 40), expected, 40);
        if (b.bad()) {
            b.show("in_point_i", pack(e.point, VW), 3 * VW);
            b.show("in_slope_i", pack(e.slope, 18), 54);
            b.show("in_e_i", e.e, 6);
            b.show("in_at_0_i", e.at_0, 40);
        }
    };
    b.stream(corners, make, TAG, LATENCY, 1, send, check);
    return b.finish();
}
