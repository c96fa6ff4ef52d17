/* tb_divide.cpp - rt_divide against a division of whole words
 * SPDX-License-Identifier: Apache-2.0
 *
 * Operands come at once, or later. Results come in their order, after a fixed time.
 */
#include <deque>

#include "Vrt_divide.h"
#include "bench.h"

namespace {

using bench::u128;
constexpr int N = BW > 17 ? (BW + 16) / 17 : 2;
constexpr uint64_t LATENCY = 8 * N + 5;

struct Operands {
    u128 a = 0, b = 0, d = 1;
    unsigned tag = 0;
    uint64_t done = 0; /* clock of out_valid_o */
};

u128 word(bench::Random &r, int bits) {
    if (bits <= 64) return (u128)(r.percent(50) ? r.log_bits(bits) : r.mixed(bits));
    if (r.percent(30)) return word(r, (int)r.below(63) + 1);
    return (word(r, bits - 64) << 64 | r.next()) >> r.below(bits);
}

/* x = a * b below d * 2^BW, of any lengths; or exact, or by one off that. */
Operands operands(bench::Random &r, long n) {
    Operands o;
    if (n < DW * BW) { /* powers of two, and all ones below them, of every length */
        o.d = (u128)1 << n % DW, o.b = (u128)1 << n / DW, o.a = 1;
        if (n & 1) o.d += o.d - 1, o.b += o.b - 1;
        return o;
    }
    o.d = word(r, DW);
    if (!o.d) o.d = 1;
    o.b = word(r, BW);
    if (!o.b) o.b = 1;
    switch (r.below(4)) {
    case 0: /* exact, or one off: the quotient is a multiple of b */
        if (o.d < (u128)1 << (AW - 1)) {
            u128 most = ((u128)1 << AW) / o.d, times = ((u128)1 << BW) / o.b;
            u128 q = word(r, BW) % (most < times ? most : times);
            o.a = q * o.d + r.below(3) - 1;
            break;
        }
        [[fallthrough]];
    case 1: /* near the greatest quotient */
        o.b = ((u128)1 << BW) - 1 - r.below(3);
        o.a = o.d - (r.percent(50) ? 0 : r.below(2));
        break;
    default:
        o.a = word(r, AW);
    }
    o.a = bench::low(o.a, AW);
    u128 most = ((o.d << BW) - 1) / o.b;
    if (o.a > most) o.a %= most + 1;
    return o;
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_divide> b("tb_divide", argc, argv, 200000);
    Vrt_divide &t = b.dut;
    std::deque<Operands> sent;
    long n = 0;
    t.in_valid_i = 0;
    b.reset();
    while (b.more()) {
        Operands o;
        bool valid = b.random.percent(80);
        if (valid) {
            o = operands(b.random, n);
            o.tag = (unsigned)b.random.below(1u << TAG);
            b.set(t.in_a_i, AW, (bench::i128)o.a);
            b.set(t.in_b_i, BW, (bench::i128)o.b);
            b.set(t.in_d_i, DW, (bench::i128)o.d);
            t.in_tag_i = o.tag;
        }
        t.in_valid_i = valid;
        b.settle();
        if (valid && t.in_ready_o) {
            o.done = b.cycle + LATENCY;
            sent.push_back(o);
            n++;
        }
        bool due = !sent.empty() && sent.front().done == b.cycle;
        b.expect("out_valid_o", t.out_valid_o, due, 1);
        if (due) {
            const Operands &e = sent.front();
            u128 x = e.a * e.b;
            b.expect("out_key_o", b.get(t.out_key_o), (bench::i128)((x + e.d - 1) / e.d), BW + 1);
            b.expect("out_tag_o", t.out_tag_o, e.tag, TAG);
            if (b.bad()) {
                b.show("a_i", (bench::i128)e.a, AW);
                b.show("b_i", (bench::i128)e.b, BW);
                b.show("d_i", (bench::i128)e.d, DW);
            }
            b.done();
            sent.pop_front();
        }
        b.tick();
    }
    return b.finish();
}
