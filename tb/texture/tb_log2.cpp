/* tb_log2.cpp - rt_log2 against sph_log2()
 * SPDX-License-Identifier: Apache-2.0
 *
 * A new argument every clock: all from 1 on up to 2^19, then every length with the bits that decide
 * the rounding.
 */
#include "Vrt_log2.h"
#include "bench.h"
extern "C" {
#include "texture/lod.h"
}

namespace {

constexpr uint64_t LATENCY = 3;

uint32_t argument(bench::Random &random, long n) {
    if (n < 1 << 19 && (XB >= 20 || n < 1 << (XB - 1))) return (uint32_t)n + 1;
    auto x = (uint32_t)random.log_bits(XB);
    int top = x ? 31 - __builtin_clz(x) : 0;
    if (top > 9 && random.percent(50)) { /* next to the middle of two table entries */
        uint32_t half = 1u << (top - 9);
        x = (x & ~(2 * half - 1)) + half - 1 + (uint32_t)random.below(2);
    }
    return x ? x : 1;
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_log2> b("tb_log2", argc, argv, 600000);
    std::queue<uint32_t> sent;
    for (long n = 0; b.more(); n++) {
        uint32_t x = argument(b.random, n);
        b.set(b.dut.in_x_i, XB, x);
        sent.push(x);
        b.tick();
        if (sent.size() < LATENCY) continue;
        uint32_t e = sent.front();
        sent.pop();
        b.expect("out_log2_o", (bench::i128)b.get(b.dut.out_log2_o), sph_log2(e), 14);
        if (b.bad()) b.show("in_x_i", e, XB);
        b.done();
    }
    return b.finish();
}
