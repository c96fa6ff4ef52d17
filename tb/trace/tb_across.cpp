/* tb_across.cpp - rt_across, or with ONE rt_across_one, against sph_across()
 * SPDX-License-Identifier: Apache-2.0
 *
 * Unit vectors of corner and of random directions, one or two clocks apart or more.
 */
#include <cstdlib>
#include <deque>

#include "bench.h"

#ifdef ONE
#include "Vrt_across_one.h"
using Dut = Vrt_across_one;
#else
#include "Vrt_across.h"
using Dut = Vrt_across;
#endif

extern "C" {
#include "machine/layout.h"
#include "math/arith.h"
#include "trace/setup.h"
}

namespace {

constexpr int BITS = 26; /* of a direction */
#ifdef ONE
constexpr uint64_t PACE = 1, LATENCY = 11;
#else
constexpr uint64_t PACE = 2, LATENCY = 15; /* or 14, by the phase */
#endif

struct Vector {
    int32_t u[3];
    int tag;
    uint64_t since;
};

class Across : public bench::Bench<Dut> {
  public:
    Across(int argc, char **argv) : Bench("tb_across", argc, argv, 200000) {}

    void clock() {
        bool go = cycle >= next && random.percent(90);
        Vector v = {{}, (int)random.below(256), cycle};
        if (go) {
            take(v.u);
            sent.push_back(v);
            next = cycle + PACE + (random.percent(60) ? 0 : random.below(5));
        }
        dut.in_valid_i = go;
        dut.in_tag_i = (unsigned char)v.tag;
        struct sph_across a = sph_across(v.u);
        int least = 3 - a.axis_a - a.axis_b, turned[] = {a.axis_a, a.axis_b, least};
        for (int i = 0; i < 3; i++)
            bench::put(dut.in_u_i, 18 * i, 18, v.u[turned[i]]);
        dut.in_mag_i = (unsigned short)std::abs(v.u[least]);
        dut.in_least_i = (unsigned char)least;
        tick();
        bool due = !sent.empty() && cycle - sent.front().since > LATENCY;
        if (dut.out_valid_o)
            check();
        else if (due)
            fail("axes that did not come");
    }

  private:
    std::deque<Vector> sent;
    uint64_t next = 0;
    unsigned corner = 0;

    void take(int32_t u[3]) {
        int64_t d[3];
        if (corner < 27 * 64) { /* components of 0, 1 or the greatest, and near ties */
            unsigned n = corner++, k = n % 27, e = n / 27;
            int64_t most = ((int64_t)1 << (BITS - 1)) - 1 - (int64_t)(e % 8) * 100;
            for (int i = 0; i < 3; i++, k /= 3)
                d[i] = k % 3 == 0 ? (int64_t)(e >> 3) % 3 - 1 : (k % 3 == 1 ? most : -most) + i;
        } else {
            int bits = random.percent(70) ? BITS : (int)random.between(2, BITS);
            for (int64_t &x : d)
                x = random.percent(5) ? 0 : random.smixed(bits);
        }
        uint64_t vv = (uint64_t)(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        struct sph_unit unit = sph_unit(d, vv, BITS);
        for (int i = 0; i < 3; i++)
            u[i] = unit.u[i];
    }

    void check() {
        if (sent.empty()) return fail("axes that nobody asked for");
        Vector v = sent.front();
        sent.pop_front();
        struct sph_across a = sph_across(v.u);
        expect("out_tag_o", dut.out_tag_o, v.tag, 8);
        expect("out_least_o", dut.out_least_o, 3 - a.axis_a - a.axis_b, 2);
        expect("out_p_a_o", sget(dut.out_p_a_o, 18), a.p_a, 18);
        expect("out_p_b_o", sget(dut.out_p_b_o, 18), a.p_b, 18);
        for (int i = 0; i < 3; i++)
            expect("out_q_o", bench::sign(bench::get(dut.out_q_o, 18 * i, 18), 18), a.q[i], 18);
        if (bad())
            for (int32_t x : v.u)
                show("in_u_i", x, 18);
        done();
    }
};

} // namespace

int main(int argc, char **argv) {
    Across b(argc, argv);
    b.dut.in_valid_i = 0;
    b.reset();
    while (b.more())
        b.clock();
    return b.finish();
}
