/* tb_clocks.cpp - rt_clocks: ratios of its clocks, and resets that wait for the PLL and the button
 * SPDX-License-Identifier: Apache-2.0
 *
 * tb/board/EHXPLLL.v takes both edges of the oscillator, and holds after LOCKS of them. The button
 * comes at any time. A vector is a press.
 */
#include "Vrt_clocks.h"
#include "bench.h"
#include "stimulus.h"

namespace {

struct Top : Vrt_clocks {
    unsigned char rst = 0;
};

/* One of the clocks: edges of the oscillator between its rises, and its reset. */
struct Clock {
    const char *name;
    uint64_t period, rose = 0, rises = 0;
    bool was = false;
    uint64_t counted = 0; /* its rises since the reset may end */

    bool look(bool now, uint64_t at, bench::Bench<Top> &b) {
        const bool rise = now && !was;
        was = now;
        if (!rise) return false;
        if (rises++) b.expect(name, (bench::i128)(at - rose), (bench::i128)period);
        rose = at;
        counted++;
        return true;
    }
    void reset(bool is, bench::Bench<Top> &b) {
        if (counted < 16) b.expect("the reset lasts", is, 1);
        if (counted > 20) b.expect("the reset ends", is, 0);
    }
};

} // namespace

int main(int argc, char **argv) {
    constexpr uint64_t LOCKS = 1000; /* edges */
    bench::Bench<Top> b("tb_clocks", argc, argv, 40);
    Top &dut = b.dut;
    Clock core = {"edges of clk", 50}, bits = {"edges of clk5", 10}, mem = {"mem_clk", 2 * MEM_DIV};
    bench::Stimulus driven;
    bench::Points &presses = driven.values(
        "the button comes", {"while clk is high", "while it is low", "in the reset", "behind it"});
    uint64_t press = 3 * LOCKS, release = press; /* edges */
    dut.restart_i = 0;
    for (uint64_t at = 1; b.more(); at++, b.cycle = 0) {
        if (at == press) {
            dut.restart_i = 1;
            presses.value(dut.clk ? 0 : 1);
            presses.value(dut.rst_o ? 2 : 3);
            release = at + 50 * (uint64_t)b.random.between(3, 9) + b.random.below(50);
        } else if (at == release) {
            dut.restart_i = 0;
            core.counted = mem.counted = 0;
            press = at + 50 * (uint64_t)b.random.between(1, 60) + b.random.below(50);
            b.done();
        }
        dut.clk_25mhz = at & 1;
        dut.eval();
        if (at <= LOCKS) core.counted = mem.counted = 0;
        const bool with = bits.look(dut.clk5, at, b);
        if (core.look(dut.clk, at, b)) b.expect("clk5 rises with clk", with, 1);
        mem.look(dut.mem_clk, at, b);
        if (dut.restart_i && at <= press + 3 * core.period) continue; /* not heard of yet */
        if (dut.restart_i) core.counted = mem.counted = 0;
        core.reset(dut.rst_o, b);
        mem.reset(dut.mem_rst_o, b);
    }
    if (b.all_vectors && !b.mismatches && !driven.whole()) b.fail("the list of stimulus");
    return b.finish();
}
