/* tb_quotient.cpp - rt_quotient against sph_quotient()
 * SPDX-License-Identifier: Apache-2.0
 *
 * The quotients of the hits of tests/hard come first.
 */
#include "Vrt_quotient.h"
#include "bench.h"
#include "hard.h"
extern "C" {
#include "math/arith.h"
}

namespace {

struct Operands {
    uint64_t key, a;
};

/* 39: exact quotients, one unit off; a = 1, 2^k, greatest; every pair of lengths; anything. */
Operands operands(bench::Random &r, long n) {
    Operands o;
    auto key_word = [&r] { return (uint64_t)(r.percent(50) ? r.log_bits(KW) : r.mixed(KW)); };
    auto a_word = [&r] { return (uint64_t)(r.percent(50) ? r.log_bits(AW) : r.mixed(AW)); };
    if (n < KW * AW) { /* powers of two: every shift of both operands */
        o = {1ull << (n % KW), 1ull << (n / KW)};
    } else if (n < 2 * KW * AW) { /* all ones of every pair of lengths */
        n -= KW * AW;
        o = {(2ull << (n % KW)) - 1, (2ull << (n / KW)) - 1};
    } else {
        switch (r.below(4)) {
        case 0: { /* exact, and one unit of the key to either side */
            uint64_t a = a_word(), q = (uint64_t)r.log_bits(KW);
            o = {(uint64_t)bench::low((bench::u128)a * q + r.below(3) - 1, KW), a};
            break;
        }
        case 1: { /* both the same but for the last bits: mant at its ends */
            uint64_t a = a_word();
            o = {(uint64_t)bench::low((bench::u128)a + r.below(5) - 2, KW), a};
            break;
        }
        case 2: { /* a at an end */
            uint64_t ends[4] = {1, (uint64_t)bench::low(~(bench::u128)0, AW), 1ull << (AW - 1), 3};
            o = {key_word(), ends[r.below(4)]};
            break;
        }
        default:
            o = {key_word(), a_word()};
        }
    }
    if (!o.key) o.key = 1; /* operands are never 0 */
    if (!o.a) o.a = 1;
    return o;
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_quotient> b("tb_quotient", argc, argv, 200000);
    Vrt_quotient &t = b.dut;
    hard::Source source(
        b.seed,
        [](const sph_profile &p) { return p.w + p.wd + 2 == KW && 2 * p.wd == AW && p.pq == PQ; },
        [](const hard::Case &c) { return c.key != 0; });
    source.limit(b);
    hard::Case hard, hard_inside;
    Operands o = {1, 1}, inside = o;
    bool offered = false;
    unsigned gaps = 0, stalls = 0;
    long sent = 0, taken = 0;
    t.in_valid_i = t.out_ready_i = 0;
    b.reset();
    while (b.more()) {
        if (b.cycle % 4096 == 0) {
            gaps = (unsigned)b.random.below(3) * 30;
            stalls = (unsigned)b.random.below(3) * 40;
        }
        if (!offered && (offered = !b.random.percent(gaps))) {
            o = source.next(hard) ? Operands{hard.key, hard.a} : operands(b.random, sent++);
        }
        t.in_valid_i = offered;
        b.set(t.in_key_i, KW, (bench::i128)o.key);
        b.set(t.in_a_i, AW, (bench::i128)o.a);
        t.out_ready_i = !b.random.percent(stalls);
        b.settle();
        if (t.out_valid_o) { /* compared in every clock in which it waits */
            struct sph_quotient q = sph_quotient(inside.key, KW, inside.a, AW, PQ);
            if (b.vectors == taken) b.fail("a result that nobody asked for");
            b.expect("out_mant_o", (bench::i128)b.get(t.out_mant_o), q.mant, PQ);
            b.expect("out_exp_o", b.sget(t.out_exp_o, 8), q.exp, 8);
            if (b.bad()) {
                hard_inside.show();
                b.show("in_key_i", (bench::i128)inside.key, KW);
                b.show("in_a_i", (bench::i128)inside.a, AW);
            }
            b.expect("in_ready_o beside a quotient", t.in_ready_o, 0);
            if (t.out_ready_i) b.done();
        }
        if (offered && t.in_ready_o) {
            if (b.vectors != taken) b.fail("a result is lost");
            inside = o;
            hard_inside = hard;
            offered = false;
            taken++;
        }
        b.tick();
    }
    source.report(b);
    return b.finish();
}
