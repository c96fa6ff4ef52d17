/* tb_long_product.cpp - rt_long_product against the product of whole words
 * SPDX-License-Identifier: Apache-2.0
 *
 * Products follow each other at once, in the last clock of the one before, or later. The first ones
 * are of the least and greatest factors. A product stands until pieces of the next one come.
 */
#include <deque>

#include "Vrt_long_product.h"
#include "bench.h"

namespace {

constexpr int A = (AW + 33) / 34, B = (BW + 16) / 17, N = (BN + 16) / 17;
constexpr uint64_t BEHIND = 4; /* clocks from the last piece to done_o */

struct Factors {
    bench::u128 a = 0, b = 0;
    bool narrow = false;
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
    uint64_t begun = 0;
    long met[2] = {};
    t.start_i = 0;
    b.reset();
    while (b.more()) {
        b.settle();
        Factors f;
        t.start_i = t.ready_o && b.random.percent(70);
        b.settle();
        if (t.start_i) {
            f.narrow = b.random.percent(50);
            f.b = mixed(b.random, f.narrow ? BN : BW);
            f.a = mixed(b.random, AW);
            if (begun++ < 2)
                f.a = bench::low(~(bench::u128)0, AW) * (begun & 1), f.b = bench::low(f.a, BN);
            f.done = b.cycle + (uint64_t)((A + 1) * (f.narrow ? N : B)) + BEHIND;
            met[f.narrow]++;
        }
        bool due = !sent.empty() && sent.front().done == b.cycle;
        b.expect("done_o", t.done_o, due, 1);
        if (due) {
            const Factors &e = sent.front();
            bench::u128 want = e.a * e.b;
            if (e.narrow)
                b.expect("narrow_o", b.get(t.narrow_o), (bench::i128)want, AW + BN);
            else
                b.expect("p_o", b.get(t.p_o), (bench::i128)want, AW + BW);
            if (b.bad()) {
                b.show("a_i", (bench::i128)e.a, AW);
                b.show("b_i", (bench::i128)e.b, BW);
            }
            b.done();
            sent.pop_front();
        }
        b.tick();
        if (!f.done) continue;
        sent.push_back(f);
        b.set(t.a_i, AW, (bench::i128)f.a);
        b.set(t.b_i, BW, (bench::i128)f.b);
        t.narrow_i = f.narrow;
        t.start_i = 0;
    }
    if (b.all_vectors && (!met[0] || !met[1])) b.fail("a kind of product that never came");
    return b.finish();
}
