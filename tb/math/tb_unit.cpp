/* tb_unit.cpp - rt_unit, or rt_unit_four, against sph_unit()
 * SPDX-License-Identifier: Apache-2.0
 *
 * The cases of tests/hard come first.
 */
#include <deque>
#include "bench.h"
#include "hard.h"
#ifdef FOUR
#include "Vrt_unit_four.h"
using Unit = Vrt_unit_four;
#else
#include "Vrt_unit.h"
using Unit = Vrt_unit;
#define FOUR 0
#endif
extern "C" {
#include "math/arith.h"
}

namespace {

struct Vector {
    int64_t v[3];
    unsigned tag;
    hard::Vector hard{};
};

constexpr uint64_t LATENCY = FOUR ? 23 : BITS <= 17 ? 14 : 18, INTERVAL = FOUR ? 4 : 2;
constexpr int64_t MIN = -((int64_t)1 << (BITS - 1)), MAX = -MIN - 1;

Vector vector(bench::Random &r, const std::vector<hard::Vector> &cases, long n) {
    Vector s;
    s.tag = (unsigned)r.bits(TAG);
    if (n < (long)cases.size()) {
        s.hard = cases[(size_t)n];
        memcpy(s.v, s.hard.c.v, sizeof s.v);
        return s;
    }
    n -= (long)cases.size();
    if (n < 27 * 5) { /* zero, ones and ends in every place: v = 0, |v| = 1, the greatest v.v */
        const int64_t sets[5][3] = {
            {0, 1, -1}, {0, MAX, MIN}, {MIN, MAX, 1}, {1, MIN, -1}, {MIN, MIN + 1, 0}};
        for (int i = 0, m = (int)(n % 27); i < 3; i++, m /= 3)
            s.v[i] = sets[n / 27][m % 3];
    } else if (n <
               27 * 5 + 6 * BITS) { /* along an axis: a component of 65536 at most, both signs */
        long m = n - 27 * 5;
        for (int i = 0; i < 3; i++)
            s.v[i] = 0;
        int64_t x = (int64_t)1 << (m / 6 < BITS - 1 ? m / 6 : BITS - 2);
        s.v[m % 3] = m % 6 < 3 ? x : -x;
    } else {
        int bits = (int)r.below(BITS) + 1; /* every shift h */
        switch (r.below(4)) {
        case 0: /* the table's arguments evenly: whole range of vv in one shift */
            for (int64_t &x : s.v)
                x = r.between(MIN, MAX);
            break;
        case 1: /* normalised as the machine's directions are */
            for (int64_t &x : s.v)
                x = r.sbits(BITS - 1);
            s.v[r.below(3)] = r.percent(50) ? MAX - r.sbits(BITS - 2) / 2 : MIN / 2;
            break;
        case 2:
            for (int64_t &x : s.v)
                x = r.log_sbits(bits);
            break;
        default:
            for (int64_t &x : s.v)
                x = r.smixed(BITS);
        }
        for (int64_t &x : s.v)
            x = x < MIN ? MIN : x > MAX ? MAX : x;
    }
    return s;
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Unit> b("tb_unit", argc, argv, 300000);
    Unit &t = b.dut;
    hard::Cases cases(b.seed, HARD_UNITS, [](const sph_profile &p) { return p.wd == BITS; });
    const std::vector<hard::Vector> first(cases.begin(), cases.end());
    cases.limit(b);
    std::deque<std::pair<Vector, uint64_t>> sent; /* and the cycle in which it is due */
    Vector v = vector(b.random, first, 0);
    bool offered = false;
    unsigned gaps = 0;
    long count = 1;
    t.in_valid_i = 0;
    b.reset();
    uint64_t ready = b.cycle;
    while (b.more()) {
        if (b.cycle % 4096 == 0) gaps = (unsigned)b.random.below(3) * 30;
        if (!offered) offered = !b.random.percent(gaps);
        t.in_valid_i = offered;
        b.set(t.in_tag_i, TAG, v.tag);
        b.set(t.in_x_i, BITS, v.v[0]);
        b.set(t.in_y_i, BITS, v.v[1]);
        b.set(t.in_z_i, BITS, v.v[2]);
        b.settle();
        if (t.in_ready_o) ready = b.cycle;
        if (b.cycle - ready >= INTERVAL) b.fail("in_ready_o is low for too long");
        if (offered && t.in_ready_o) {
            sent.emplace_back(v, b.cycle + LATENCY);
            v = vector(b.random, first, count++);
            offered = false;
        }
        b.tick();
        if (!t.out_valid_o) continue;
        if (sent.empty()) {
            b.fail("a result that nobody asked for");
            break;
        }
        Vector s = sent.front().first;
        b.expect("latency", (bench::i128)b.cycle, (bench::i128)sent.front().second);
        sent.pop_front();
        uint64_t vv = (uint64_t)(s.v[0] * s.v[0] + s.v[1] * s.v[1] + s.v[2] * s.v[2]);
        struct sph_unit u = sph_unit(s.v, vv, BITS);
        b.expect("out_tag_o", (bench::i128)b.get(t.out_tag_o), s.tag, TAG);
        b.expect("out_vv_o", (bench::i128)b.get(t.out_vv_o), (bench::i128)vv, 2 * BITS);
        b.expect("out_h_o", t.out_h_o, u.h, 6);
        b.expect("out_y_o", t.out_y_o, u.y, 17);
        b.expect("out_u_x_o", b.sget(t.out_u_x_o, 18), u.u[0], 18);
        b.expect("out_u_y_o", b.sget(t.out_u_y_o, 18), u.u[1], 18);
        b.expect("out_u_z_o", b.sget(t.out_u_z_o, 18), u.u[2], 18);
        if (b.bad()) {
            s.hard.show();
            b.show("in_x_i", s.v[0], BITS);
            b.show("in_y_i", s.v[1], BITS);
            b.show("in_z_i", s.v[2], BITS);
        }
        b.done();
    }
    return b.finish();
}
