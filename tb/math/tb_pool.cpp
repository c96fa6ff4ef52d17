/* tb_pool.cpp - rt_pool: the lowest unit that is ready takes, those that are done give in turn
 * SPDX-License-Identifier: Apache-2.0
 *
 * Units take any time, and what they find waits for whoever reads it, who is slow at times. A unit
 * that is done is passed over by each other one at most once. A vector is a result.
 */
#include "Vrt_pool.h"
#include "bench.h"

namespace {

struct Unit {
    uint64_t work = 0; /* clocks that are left */
    bool busy = false;
    unsigned tag = 0, result = 0, passed = 0; /* passed: others gave while it was done */
    bool done() const { return busy && !work; }
};

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_pool> b("tb_pool", argc, argv, 20000);
    Vrt_pool &t = b.dut;
    Unit units[UNITS];
    int last = UNITS - 1; /* gave last */
    t.in_valid_i = t.ready_i = t.done_i = t.out_ready_i = 0;
    b.reset();
    while (b.more()) {
        const bool slow = b.cycle >> 8 & 1;
        int takes = -1, gives = -1;
        t.ready_i = t.done_i = 0;
        for (int u = UNITS - 1; u >= 0; u--) {
            Unit &unit = units[u];
            unit.work -= unit.work > 0;
            bench::put(t.ready_i, u, 1, !unit.busy);
            bench::put(t.done_i, u, 1, unit.done());
            bench::put(t.results_i, RW * u, RW, unit.result = (unsigned)b.random.bits(RW));
            if (!unit.busy) takes = u;
        }
        for (int i = UNITS; i > 0; i--)
            if (units[(last + i) % UNITS].done()) gives = (last + i) % UNITS;
        t.in_valid_i = b.random.percent(70);
        t.in_tag_i = (uint8_t)b.random.bits(TAG);
        t.out_ready_i = b.random.percent(slow ? 15 : 90);
        b.settle();
        b.expect("in_ready_o", t.in_ready_o, takes >= 0, 1);
        b.expect("take_o", t.take_o, takes >= 0 && t.in_valid_i ? 1 << takes : 0, UNITS);
        b.expect("out_valid_o", t.out_valid_o, gives >= 0, 1);
        const bool given = gives >= 0 && t.out_ready_i;
        b.expect("give_o", t.give_o, given ? 1 << gives : 0, UNITS);
        if (given) {
            b.expect("out_tag_o", t.out_tag_o, units[gives].tag, TAG);
            b.expect("out_result_o", t.out_result_o, units[gives].result, RW);
            for (int u = 0; u < UNITS; u++)
                if (u != gives && units[u].done() && ++units[u].passed >= UNITS)
                    b.fail("a unit is passed over");
            units[gives].busy = false;
            units[last = gives].passed = 0;
            b.done();
        }
        if (t.in_valid_i && takes >= 0) {
            units[takes].busy = true;
            units[takes].tag = t.in_tag_i;
            units[takes].work = 1 + b.random.below(slow ? 4 : 20);
        }
        b.tick();
    }
    return b.finish();
}
