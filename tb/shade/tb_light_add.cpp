/* tb_light_add.cpp - rt_light_add against sph_light_add()
 * SPDX-License-Identifier: Apache-2.0
 */
#include "Vrt_light_add.h"
#include "bench.h"

extern "C" {
#include "shade/colour.h"
}

using bench::u128;

namespace {

constexpr uint64_t LATENCY = 5, INTERVAL = 3;

struct Vector {
    uint32_t sum[3], cosine, intensity[3]; /* u2.15, u1.15, u1.15 */
    uint64_t tag, taken;
};

const Vector corners[] = {
    {{0, 0, 0}, 0, {0, 0, 0}, 0, 0},                          /* nothing at all */
    {{1, 2, 3}, 32768, {32768, 1, 65535}, 0, 0},              /* cosine 1: intensity as it is */
    {{131071, 131070, 0}, 32768, {1, 1, 65535}, 0, 0},        /* limit: one over, just reached */
    {{131071, 131071, 131071}, 1, {16383, 16384, 1}, 0, 0},   /* half at the limit: below, at */
    {{131070, 65536, 65535}, 1, {16383, 16384, 49152}, 0, 0}, /* rounds to 0, 1, 2 */
    {{65536, 65537, 131071}, 32768, {65535, 65535, 0}, 0, 0}, /* 2^17-1, one more, no light */
    {{131071, 0, 65535}, 65535, {65535, 65535, 65535}, 0, 0}, /* widest operands */
};

Vector make(bench::Random &random) {
    Vector v{};
    v.cosine = (uint32_t)(random.percent(20) ? random.mixed(16) : random.below(32769));
    for (int i = 0; i < 3; i++) {
        v.sum[i] = (uint32_t)random.mixed(17);
        v.intensity[i] = (uint32_t)random.mixed(16);
    }
    return v;
}

/* Three channels as one word, red low. */
bench::i128 pack(const uint32_t channel[3], int bits) {
    return (bench::i128)((u128)channel[2] << 2 * bits | (u128)channel[1] << bits | channel[0]);
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_light_add> b("tb_light_add", argc, argv);
    auto send = [&](const Vector &v) {
        b.set(b.dut.in_sum_i, 51, pack(v.sum, 17));
        b.set(b.dut.in_cosine_i, 16, v.cosine);
        b.set(b.dut.in_intensity_i, 48, pack(v.intensity, 16));
    };
    auto check = [&](const Vector &e) {
        for (int i = 0; i < 3; i++) {
            uint32_t expected = sph_light_add(e.sum[i], e.cosine, e.intensity[i]);
            b.expect("out_sum_o", bench::low(b.get(b.dut.out_sum_o) >> (17 * i), 17), expected, 17);
        }
        if (b.bad()) {
            b.show("in_cosine_i", e.cosine, 16);
            b.show("in_sum_i", pack(e.sum, 17), 51);
            b.show("in_intensity_i", pack(e.intensity, 16), 48);
        }
    };
    b.stream(corners, make, TAG, LATENCY, INTERVAL, send, check);
    return b.finish();
}
