/* tb_isqrt.cpp - rt_isqrt against sph_isqrt_bits()
 * SPDX-License-Identifier: Apache-2.0
 *
 * The roots of the hits of tests/hard come first.
 */
#include <deque>

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

/* A radicand that was taken, and the clock of its root. */
struct Sent {
    u128 x;
    unsigned tag;
    uint64_t due;
    hard::Case hard;
};

void compare(bench::Bench<Vrt_isqrt> &b, const Sent &sent) {
    const Vrt_isqrt &t = b.dut;
    int inexact;
    uint64_t root = sph_isqrt_bits(sent.x, BITS, &inexact);
    if (BITS ? t.out_shift_o > XW / 2 - BITS : t.out_shift_o)
        b.fail("out_shift_o: longer than the bits that are left out");
    b.expect("out_root_o", (bench::i128)b.get(t.out_root_o) << t.out_shift_o, (bench::i128)root,
             XW / 2);
    b.expect("out_inexact_o", t.out_inexact_o, inexact, 1);
    b.expect("out_tag_o", t.out_tag_o, sent.tag, TAG);
    if (b.bad()) sent.hard.show(), b.show("in_x_i", (bench::i128)sent.x, XW);
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_isqrt> b("tb_isqrt", argc, argv, 200000);
    Vrt_isqrt &t = b.dut;
    constexpr int ROUNDS = (XW / 2 + STEP - 1) / STEP, INTERVAL = ROUNDS / STAGES + 1;
    hard::Source source(
        b.seed, [](const sph_profile &p) { return 2 * (p.w + p.wd) == XW; },
        [](const hard::Case &c) { return c.disc && !(c.disc >> XW); });
    source.limit(b);
    std::deque<Sent> under_way;
    Sent offer{};
    bool offered = false;
    unsigned gaps = 0;
    long sent = 0;
    uint64_t free = 0; /* the clock from which a radicand is taken */
    t.in_valid_i = 0;
    b.reset();
    while (b.more()) {
        if (b.cycle % 4096 == 0) gaps = (unsigned)b.random.below(3) * 30;
        if (!offered && (offered = !b.random.percent(gaps))) {
            offer.x = source.next(offer.hard) ? offer.hard.disc : radicand(b.random, sent++);
            offer.tag = b.random.below(1U << TAG);
        }
        t.in_valid_i = offered;
        t.in_tag_i = static_cast<uint8_t>(offer.tag);
        b.set(t.in_x_i, XW, (bench::i128)offer.x);
        b.settle();
        if (t.in_ready_o != (b.cycle >= free)) b.fail("in_ready_o: not each INTERVAL clocks");
        bool due = !under_way.empty() && b.cycle == under_way.front().due;
        if (t.out_valid_o != due) b.fail("out_valid_o: not ROUNDS + 1 clocks behind its radicand");
        if (due) {
            compare(b, under_way.front());
            under_way.pop_front();
            b.done();
        }
        if (offered && t.in_ready_o) {
            offer.due = b.cycle + ROUNDS + 1;
            free = b.cycle + INTERVAL;
            under_way.push_back(offer);
            offered = false;
        }
        b.tick();
    }
    source.report(b);
    return b.finish();
}
