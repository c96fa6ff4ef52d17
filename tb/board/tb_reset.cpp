/* tb_reset.cpp - rt_reset: it lasts until 16 clocks after what asks for it was seen to be gone
 * SPDX-License-Identifier: Apache-2.0
 *
 * It starts in reset. What asks comes for a clock or more, with pauses that are shorter and longer
 * than the reset. A vector is a clock.
 */
#include "Vrt_reset.h"
#include "bench.h"
#include "stimulus.h"

namespace {

struct Top : Vrt_reset {
    unsigned char rst = 0;
};

} // namespace

int main(int argc, char **argv) {
    constexpr uint64_t SYNC = 2, LASTS = 16; /* clocks */
    bench::Bench<Top> b("tb_reset", argc, argv, 20000);
    b.dut.hold_i = 0;
    b.settle();
#ifndef NETLIST /* where registers with faults have no start value */
    b.expect("rst_o at power-up", b.dut.rst_o, 1);
#endif
    bench::Stimulus driven;
    bench::Points &holds = driven.values("asked for", {"a clock", "2 clocks", "3 clocks", "more"});
    bench::Points &pauses =
        driven.values("a pause", {"a clock", "as long as the reset but one", "as long", "longer"});
    uint64_t change = LASTS + SYNC, last = 0; /* clocks: the next change, when it was asked last */
    for (; b.more(); b.done()) {
        if (b.cycle == change) {
            b.dut.hold_i = !b.dut.hold_i;
            const int64_t lasts = b.random.between(1, b.random.percent(50) ? 3 : 40);
            if (b.dut.hold_i)
                holds.value(lasts < 4 ? lasts - 1 : 3);
            else
                pauses.value(lasts == 1                    ? 0
                             : lasts == (int64_t)LASTS - 1 ? 1
                             : lasts == (int64_t)LASTS     ? 2
                             : lasts > (int64_t)LASTS      ? 3
                                                           : -1);
            change += (uint64_t)lasts;
        }
        b.tick();
        if (b.dut.hold_i) last = b.cycle;
#ifndef NETLIST
        if (b.cycle < LASTS) b.expect("rst_o behind power-up", b.dut.rst_o, 1);
#endif
        if (last) {
            const uint64_t since = b.cycle - last; /* more, and less, may have been asked before */
            if (since >= SYNC) b.expect("rst_o", b.dut.rst_o, since < SYNC + LASTS);
        }
    }
    if (b.all_vectors && !b.mismatches && !driven.whole()) b.fail("the list of stimulus");
    return b.finish();
}
