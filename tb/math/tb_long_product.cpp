/* tb_long_product.cpp - rt_long_product against the product of whole words
 * SPDX-License-Identifier: Apache-2.0
 *
 * Products follow each other as soon as they may, or later; a reset ends some, and the next one
 * begins in the clock behind it. The first ones are of the least and greatest factors.
 */
#include <deque>

#include "Vrt_long_product.h"
#include "bench.h"

namespace {

constexpr int B = (BW + 16) / 17;
constexpr uint64_t LATENCY = B + 3; /* clocks from start_i to done_o */

struct Factors {
    bench::u128 a = 0, b = 0;
    uint64_t done = 0; /* clock of done_o */
};

bench::u128 mixed(bench::Random &r, int bits) {
    if (r.percent(10)) return bench::low(~(bench::u128)0, bits);
    if (bits <= 64) return (bench::u128)r.mixed(bits);
    return (bench::u128)r.mixed(bits - 64) << 64 | r.next();
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_long_product> b("tb_long_product", argc, argv, 20000);
    Vrt_long_product &t = b.dut;
    std::deque<Factors> sent;
    uint64_t begun = 0, next = 0;
    t.start_i = 0;
    b.reset();
    while (b.more()) {
        const bool anew = !sent.empty() && b.random.percent(2);
        if (anew) {
            t.start_i = 0;
            b.reset(1);
            sent.clear();
            next = b.cycle;
        }
        t.start_i = b.cycle >= next && (anew || b.random.percent(70));
        if (t.start_i) {
            Factors f;
            f.a = mixed(b.random, AW), f.b = mixed(b.random, BW);
            if (begun++ < 2)
                f.a = bench::low(~(bench::u128)0, AW) * (begun & 1), f.b = bench::low(f.a, BW);
            f.done = b.cycle + LATENCY;
            next = b.cycle + B;
            sent.push_back(f);
            b.set(t.a_i, AW, (bench::i128)f.a);
            b.set(t.b_i, BW, (bench::i128)f.b);
        }
        b.settle();
        bool due = !sent.empty() && sent.front().done == b.cycle;
        b.expect("done_o", t.done_o, due, 1);
        if (due) {
            const Factors &e = sent.front();
            b.expect("p_o", b.get(t.p_o), (bench::i128)(e.a * e.b), AW + BW);
            if (b.bad()) {
                b.show("a_i", (bench::i128)e.a, AW);
                b.show("b_i", (bench::i128)e.b, BW);
            }
            b.done();
            sent.pop_front();
        }
        b.tick();
    }
    return b.finish();
}
