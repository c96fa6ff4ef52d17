/* tb_leaf_unit.cpp - rt_leaf_unit, leaf cache, tests and roots, against sph_leaf_visit()
 * SPDX-License-Identifier: Apache-2.0
 *
 * Every slot gets a ray, then visits of some leaf children in any line of memory; the next visit
 * comes when all results of the last are there, as rt_trace wants it. Records are fetched in
 * between. A vector is a result; they come in any order, so one is looked for among those that its
 * slot still waits for.
 * Compiled with -O0, for it has few vectors.
 */
#include "Vrt_leaf_unit.h"
#include "engine/results.h"

#ifndef SHADOW
#define SHADOW 1
#endif
#ifndef INSIDE
#define INSIDE 1
#endif

namespace {

struct Slot {
    struct sph_ray ray = {};
    bool begun = false;
    std::vector<struct sph_hit> wanted; /* results that have not come */
    int64_t fetch = -1;                 /* line of the record that is under way */
};

class LeafUnit : public bench::Bench<Vrt_leaf_unit> {
  public:
    LeafUnit(int argc, char **argv)
        : Bench("tb_leaf_unit", argc, argv, 50000), world(0), memory(*this, world) {
        for (uint32_t at = 0; at < world.m.lines; at += 7) /* of no kind, with FACETS */
            sph_field_set(world.m.mem + (size_t)at * SPH_LINE_WORDS, SPH_FACET_KIND_LSB,
                          SPH_FACET_KIND_BITS, 3);
    }

    /* Nothing is under way: INSIDE on or off. */
    void phase() {
        bool inside = random.percent(70);
        world.m.regs[SPH_REG_EFFECTS] &= ~(1 << SPH_EFFECT_INSIDE);
        if (inside) world.m.regs[SPH_REG_EFFECTS] |= 1 << SPH_EFFECT_INSIDE;
        world.put_regs(dut.regs_i);
        for (Slot &s : slots)
            s.begun = false; /* rays carry what the model knows of INSIDE */
        pace = random.percent(50) ? 100 : (unsigned)random.between(2, 60);
        reading = random.percent(50) ? 100 : (unsigned)random.between(5, 60);
        dut.flush_i = 1;
        clock(false);
        dut.flush_i = 0;
        seen[0] = seen[1] = seen[2] = 0;
        counters = {};
        errors = faults = 0;
    }

    void clock(bool start) {
        int told = give_ray(start);
        give_visit(start, told);
        give_fetch(start);
        dut.record_ready_i = random.percent(reading);
        memory.before();
        seen[0] += bench::get(dut.event_o, RT_PRIM_EVENT_LEAF) != 0;
        seen[1] += bench::get(dut.event_o, RT_PRIM_EVENT_FACET) != 0;
        seen[2] += bench::get(dut.event_o, RT_PRIM_EVENT_ROOT) != 0;
        faults |= dut.fault_o;
        if (bench::get(dut.result_o, RT_RESULT_VALID))
            world::take_result(*this, slots, dut.result_o);
        if (bench::get(dut.record_o, RT_RECORD_VALID) && dut.record_ready_i) take_record();
        bool fetched = bench::get(dut.fetch_i, RT_FETCH_VALID) && dut.fetch_ready_o;
        tick();
        if (fetched) bench::put(dut.fetch_i, RT_FETCH_VALID, 0);
    }

    bool all_idle() const {
        for (const Slot &s : slots)
            if (!s.wanted.empty() || s.fetch >= 0) return false;
        return !bench::get(dut.fetch_i, RT_FETCH_VALID);
    }

    void compare() {
        for (int i = 0; i < 40; i++)
            clock(false);
        expect("LEAF", (bench::i128)seen[0], (bench::i128)counters.count[SPH_COUNT_LEAF_TESTS]);
        expect("FACET", (bench::i128)seen[1], (bench::i128)counters.count[SPH_COUNT_FACET_TESTS]);
        expect("ROOT", (bench::i128)seen[2], (bench::i128)counters.count[SPH_COUNT_ROOTS]);
        expect("fault_o", faults, errors, 4);
        done();
    }

  private:
    world::World world;
    world::Memory<Vrt_leaf_unit> memory;
    Slot slots[SLOTS];
    struct sph_counters counters = {};
    uint32_t errors = 0, faults = 0;
    uint64_t seen[3] = {};
    unsigned pace = 100, reading = 100; /* percent of clocks with new work, with record_ready_i */

    int give_ray(bool start) {
        int at = (int)random.below(SLOTS);
        Slot &s = slots[at];
        bool go = start && s.wanted.empty() && (!s.begun || random.percent(30));
        bench::put(dut.ray_i, RT_RAY_VALID, go);
        if (!go) return -1;
        int kind = SHADOW && random.percent(40) ? SPH_SHADOW
                   : random.percent(50)         ? SPH_PRIMARY
                                                : SPH_REFLECTED;
        s.ray = world.ray(random, kind);
        if (!INSIDE) s.ray.skip.inside = 0;
        s.begun = true;
        world::put_ray(dut.ray_i, at, s.ray);
        set(dut.lift_i, 3 * (NG + 2), (bench::i128)world::pack(s.ray.lift, NG + 2));
        return at;
    }

    void give_visit(bool start, int told) {
        int at = (int)random.below(SLOTS);
        Slot &s = slots[at];
        bool go = start && at != told && s.begun && s.wanted.empty() && random.percent(pace);
        bench::put(dut.visit_i, RT_VISIT_VALID, go);
        if (!go) return;
        unsigned leaf = 1 + (unsigned)random.below(15);
        uint32_t line = (uint32_t)random.below(world.m.lines - 3);
        for (uint32_t j = 0; j < 4; j++)
            if (leaf >> j & 1) s.wanted.push_back(world.leaf(s.ray, line, j, &counters, &errors));
        bench::put(dut.visit_i, RT_VISIT_SLOT, at);
        bench::put(dut.visit_i, RT_VISIT_LEAF, leaf);
        bench::put(dut.visit_i, RT_VISIT_LINE, line);
    }

    void give_fetch(bool start) {
        int at = (int)random.below(SLOTS);
        if (bench::get(dut.fetch_i, RT_FETCH_VALID) || !start || slots[at].fetch >= 0 ||
            !random.percent(10))
            return;
        slots[at].fetch = (int64_t)random.below(world.m.lines);
        bench::put(dut.fetch_i, RT_FETCH_VALID, 1);
        bench::put(dut.fetch_i, RT_FETCH_SLOT, at);
        bench::put(dut.fetch_i, RT_FETCH_LINE, slots[at].fetch);
    }

    void take_record() {
        int at = (int)bench::get(dut.record_o, RT_RECORD_SLOT);
        Slot &s = slots[at];
        if (s.fetch < 0) return fail("a record that nobody asked for");
        for (int i = 0; i < 8; i++)
            expect("DATA",
                   (bench::i128)bench::get(dut.record_o, world::first_bit(RT_RECORD_DATA) + 32 * i,
                                           32),
                   world.line((uint32_t)s.fetch)[i], 32);
        s.fetch = -1;
        if (bad()) done();
    }
};

} // namespace

int main(int argc, char **argv) {
    LeafUnit b(argc, argv);
    b.reset();
    for (int i = 0; i < 2 * SLOTS; i++)
        b.clock(false);
    while (b.more()) {
        b.phase();
        for (uint64_t i = b.random.between(100, 3000); i && b.more(); i--)
            b.clock(true);
        uint64_t since = b.cycle;
        while (!b.all_idle() && b.cycle - since < 20000)
            b.clock(false);
        if (!b.all_idle()) {
            b.fail("a result or a record got lost");
            break;
        }
        b.compare();
    }
    return b.finish();
}
