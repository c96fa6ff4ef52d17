/* tb_square.cpp - rt_square against the product of its word with itself, for every word
 * SPDX-License-Identifier: Apache-2.0
 */
#include <queue>

#include "Vrt_square.h"
#include "bench.h"

namespace {

constexpr int BITS = 14;
constexpr size_t LATENCY = 4;
constexpr uint64_t ALL = (uint64_t)1 << BITS;

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_square> b("tb_square", argc, argv, 3 * (long)ALL);
    std::queue<uint64_t> sent;
    for (uint64_t number = 0; b.more(); number++) {
        /* upwards: every word; downwards: every carry from another neighbour; then at random */
        uint64_t r = number < ALL       ? number
                     : number < 2 * ALL ? 2 * ALL - 1 - number
                                        : (uint64_t)b.random.mixed(BITS);
        b.set(b.dut.in_i, BITS, (bench::i128)r);
        sent.push(r);
        b.tick();
        if (sent.size() < LATENCY) continue;
        uint64_t e = sent.front();
        sent.pop();
        b.expect("out_q", b.get(b.dut.out_q), e * e, 2 * BITS);
        if (b.bad()) b.show("in_i", (bench::i128)e, BITS);
        b.done();
    }
    return b.finish();
}
