/* tb_candidates.cpp - rt_candidates: leaf children of visits, in order and none twice
 * SPDX-License-Identifier: Apache-2.0
 *
 * A slot has one visit under way at most. A naive queue says what must come next, two clocks after
 * its visit and no clock later; the consumer is ready at random. A vector is a candidate.
 */
#include <deque>

#include "Vrt_candidates.h"
#include "bench.h"
#include "bundles.h"

namespace {

struct Candidate {
    int slot, child;
    uint32_t line;
    bool last;      /* of its visit */
    uint64_t given; /* clock of the visit */
};

class Candidates : public bench::Bench<Vrt_candidates> {
  public:
    Candidates(int argc, char **argv) : Bench("tb_candidates", argc, argv, 20000) {}

    void clock(bool start) {
        if (cycle % 256 == 0) {
            pace = random.percent(40) ? 100 : (unsigned)random.between(3, 60);
            reading = random.percent(40) ? 100 : (unsigned)random.between(3, 60);
        }
        give_visit(start);
        dut.out_ready_i = random.percent(reading);
        settle();
        check();
        tick();
    }

    bool all_idle() const { return wanted.empty(); }

  private:
    std::deque<Candidate> wanted;
    bool under_way[SLOTS] = {};
    unsigned pace = 100, reading = 100;

    void give_visit(bool start) {
        int at = (int)random.below(SLOTS);
        bool go = start && !under_way[at] && random.percent(pace);
        bench::put(dut.visit_i, RT_VISIT_VALID, go);
        unsigned leaf = 1 + (unsigned)random.below(15);
        uint32_t line = (uint32_t)random.bits(SPH_LINE_BITS);
        bench::put(dut.visit_i, RT_VISIT_SLOT, at);
        bench::put(dut.visit_i, RT_VISIT_LEAF, leaf);
        bench::put(dut.visit_i, RT_VISIT_LINE, line);
        if (!go) return;
        under_way[at] = true;
        for (int child = 0; child < 4; child++)
            if (leaf >> child & 1) wanted.push_back({at, child, line, leaf >> child == 1, cycle});
    }

    void check() {
        bool due = !wanted.empty() && wanted.front().given + 2 <= cycle;
        if (dut.out_valid_o != due) return fail("a candidate of no visit, or none that is due");
        if (!due) return;
        const Candidate c = wanted.front();
        expect("out_slot_o", dut.out_slot_o, c.slot, SLOTW);
        expect("out_child_o", dut.out_child_o, c.child, 2);
        expect("out_line_o", dut.out_line_o, c.line, SPH_LINE_BITS);
        if (!dut.out_ready_i && !bad()) return;
        wanted.pop_front();
        if (c.last) under_way[c.slot] = false;
        done();
    }
};

} // namespace

int main(int argc, char **argv) {
    Candidates b(argc, argv);
    b.reset();
    bench::phases(b, 100, 3000, 20000, "a candidate got lost");
    return b.finish();
}
