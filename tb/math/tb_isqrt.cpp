/* tb_isqrt.cpp - rt_isqrt against sph_isqrt_bits()
 * SPDX-License-Identifier: Apache-2.0
 *
 * The roots of the hits of tests/hard come first.
 */
#include "Vrt_isqrt.h"
#include "bench.h"
#include "hard.h"
extern "C" {
#include "math/arith.h"
}

namespace {

using bench::u128;

/* 38: squares, squares +-1, 2^(2k), 2^(2k)-1, both ends; then every length, then anything. */
u128 radicand(bench::Random &r, long n) {
    if (n < XW) return (u128)1 << n;
    if (n < 2 * XW) return bench::low(~(u128)0, (int)(n - XW) + 1);
    if (n < 2 * XW + 256) return bench::low((u128)(n - 2 * XW), XW);
    if (BITS && r.percent(20)) { /* BITS are exact but for one bit behind them, or none */
        int shift = 2 * (int)r.below((unsigned)(XW / 2 - BITS) + 1);
        u128 root = r.mixed(BITS) | (u128)1 << (BITS - 1);
        return (root * root << shift) + (shift ? (u128)1 << r.below((unsigned)shift) : 0);
    }
    switch (r.below(5)) {
    case 0:
    case 1: { /* next to a square of any size: the last digit decides */
        u128 root = r.percent(50) ? r.log_bits(XW / 2) : r.mixed(XW / 2);
        return bench::low(root * root + r.below(3) - 1, XW);
    }
    case 2: { /* next to the middle of two squares: the greatest remainders */
        u128 root = r.mixed(XW / 2);
        return bench::low(root * root + 2 * root + r.below(3) - 1, XW);
    }
    case 3:
        return r.log_bits(XW);
    default:
        return r.mixed(XW);
    }
}

/* Clocks with digits: to the last one, or BITS behind the first 1. */
uint64_t rounds(u128 x) {
    int inexact, all = (XW / 2 + STEP - 1) / STEP;
    int length = sph_bit_length(sph_isqrt(x, &inexact));
    int digits = BITS && length > BITS ? all * STEP - length + BITS : all * STEP;
    return (uint64_t)((digits + STEP - 1) / STEP);
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_isqrt> b("tb_isqrt", argc, argv, 200000);
    Vrt_isqrt &t = b.dut;
    hard::Source source(
        b.seed, [](const sph_profile &p) { return 2 * (p.w + p.wd) == XW; },
        [](const hard::Case &c) { return c.disc && !(c.disc >> XW); });
    source.limit(b);
    hard::Case hard, hard_inside;
    u128 x = 0, inside = 0;
    bool offered = false;
    unsigned gaps = 0, stalls = 0;
    long sent = 0, taken = 0;
    uint64_t due = 0; /* cycle of the result */
    t.in_valid_i = t.out_ready_i = 0;
    b.reset();
    while (b.more()) {
        if (b.cycle % 4096 == 0) {
            gaps = (unsigned)b.random.below(3) * 30;
            stalls = (unsigned)b.random.below(3) * 40;
        }
        if (!offered && (offered = !b.random.percent(gaps))) {
            x = source.next(hard) ? hard.disc : radicand(b.random, sent++);
        }
        t.in_valid_i = offered;
        b.set(t.in_x_i, XW, (bench::i128)x);
        t.out_ready_i = !b.random.percent(stalls);
        b.settle();
        if (t.out_valid_o) { /* compared in every clock in which it waits */
            int inexact;
            uint64_t root = sph_isqrt_bits(inside, BITS, &inexact);
            if (b.vectors == taken) b.fail("a result that nobody asked for");
            if (b.cycle < due) b.fail("too early");
            if (BITS ? t.out_shift_o > XW / 2 - BITS : t.out_shift_o)
                b.fail("out_shift_o: longer than the bits that are left out");
            b.expect("out_root_o", (bench::i128)b.get(t.out_root_o) << t.out_shift_o,
                     (bench::i128)root, XW / 2);
            b.expect("out_inexact_o", t.out_inexact_o, inexact, 1);
            if (b.bad()) hard_inside.show(), b.show("in_x_i", (bench::i128)inside, XW);
            if (t.out_ready_i) b.done();
        }
        if (!t.out_valid_o && b.vectors < taken && b.cycle >= due) b.fail("too late");
        if (offered && t.in_ready_o) {
            inside = x;
            due = b.cycle + 1 + rounds(x);
            hard_inside = hard;
            offered = false;
            taken++;
        }
        b.tick();
    }
    source.report(b);
    return b.finish();
}
