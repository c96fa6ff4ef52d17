/* leaf_visits.h - rt_leaf_unit or rt_leaf_units, caches, tests and roots, against sph_leaf_visit()
 * SPDX-License-Identifier: Apache-2.0
 *
 * Every slot gets a ray, then visits of some leaf children in any line of memory, at all addresses;
 * the next visit comes when all results of the last are there, as rt_trace wants it. Records are
 * fetched in between. A vector is a result; they come in any order, so one is looked for among
 * those that its slot still waits for. In some phases the memory of one unit has nothing but
 * errors. Who includes this has named the module `Top`; with one of all units it may be
 * rt_leaf_unit.
 */
#ifndef TB_LEAF_VISITS_H
#define TB_LEAF_VISITS_H

#include <set>

#include "engine/parts.h"
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

class LeafVisits : public bench::Bench<Top> {
  public:
    LeafVisits(const char *name, int argc, char **argv, long results)
        : Bench(name, argc, argv, results), world(0), memory(*this, world) {
        for (uint32_t at = 0; at < world.m.lines; at += 7) /* of no kind, with FACETS */
            sph_field_set(world.m.mem + (size_t)at * SPH_LINE_WORDS, SPH_FACET_KIND_LSB,
                          SPH_FACET_KIND_BITS, 3);
        world.repeat();
        memory.wanted = [this](uint32_t line) { return lines.count(line) != 0; };
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
        memory.spoilt_for = phases++ % 4 == 1 ? (int)(phases / 4 % LEAF_UNITS) : -1;
        dut.flush_i = 1;
        clock(false);
        dut.flush_i = 0;
        lines.clear();
        seen[0] = seen[1] = seen[2] = 0;
        counters = {};
        errors = faults = 0;
    }

    void clock(bool start) {
        int told[SETUPS];
        parts::no_ray(dut.ray_i);
        for (int unit = 0; unit < SETUPS; unit++)
            told[unit] = give_ray(unit, start);
        for (int pipe = 0; pipe < PIPES; pipe++)
            give_visit(pipe, start, told[pipe >> (parts::pipes.top() - parts::setups.top())]);
        for (int unit = 0; unit < SHADES; unit++)
            give_fetch(unit, start);
        memory.before();
        for (int unit = 0; unit < LEAF_UNITS; unit++) {
            seen[0] += of_event(unit, RT_PRIM_EVENT_LEAF);
            seen[1] += of_event(unit, RT_PRIM_EVENT_FACET);
            seen[2] += of_event(unit, RT_PRIM_EVENT_ROOT);
            misses += of_event(unit, RT_EXACT_EVENT_MISS);
            if (of_result(unit, RT_RESULT_VALID)) take_result(unit);
        }
        faults |= dut.fault_o;
        bool fetched[SHADES];
        for (int unit = 0; unit < SHADES; unit++) {
            bool record = parts::shades.get(dut.record_o, unit, RT_RECORD_BITS, RT_RECORD_VALID);
            if (record) take_record(unit);
            fetched[unit] = fetches(unit) && dut.fetch_ready_o >> unit & 1;
        }
        tick();
        for (int unit = 0; unit < SHADES; unit++)
            if (fetched[unit]) put_fetch(unit, RT_FETCH_VALID, 0);
    }

    bool all_idle() const {
        for (const Slot &s : slots)
            if (!s.wanted.empty() || s.fetch >= 0) return false;
        for (int unit = 0; unit < SHADES; unit++)
            if (fetches(unit)) return false;
        return true;
    }

    void compare() {
        for (int i = 0; i < 40; i++)
            clock(false);
        expect("MISS", (bench::i128)misses, (bench::i128)memory.requests);
        if (memory.spoilt_for < 0) compare_tests();
        expect("fault_o", faults, errors, 4);
        done();
    }

  private:
    world::World world;
    world::Memory<Top, LEAF_UNITS> memory;
    Slot slots[SLOTS];
    struct sph_counters counters = {};
    uint32_t errors = 0, faults = 0;
    uint64_t seen[3] = {}, misses = 0;
    unsigned phases = 0;
    std::set<uint32_t> lines; /* of visits and fetches of this phase */
    unsigned pace = 100;      /* percent of clocks with new work */

    void compare_tests() {
        expect("LEAF", (bench::i128)seen[0], (bench::i128)counters.count[SPH_COUNT_LEAF_TESTS]);
        expect("FACET", (bench::i128)seen[1], (bench::i128)counters.count[SPH_COUNT_FACET_TESTS]);
        expect("ROOT", (bench::i128)seen[2], (bench::i128)counters.count[SPH_COUNT_ROOTS]);
    }
    uint64_t of_event(int unit, int lsb, int bits) {
        return (uint64_t)bench::get(dut.event_o, RT_EXACT_EVENT_BITS * unit + lsb, bits);
    }
    uint64_t of_result(int unit, int lsb, int bits) {
        return (uint64_t)parts::leaf_units.get(dut.result_o, unit, RT_RESULT_BITS, lsb, bits);
    }
    bool fetches(int unit) const {
        return parts::shades.get(dut.fetch_i, unit, RT_FETCH_BITS, RT_FETCH_VALID) != 0;
    }
    void put_fetch(int unit, int lsb, int bits, int64_t value) {
        parts::shades.put(dut.fetch_i, unit, RT_FETCH_BITS, lsb, bits, value);
    }

    int give_ray(int unit, bool start) {
        int at = parts::any_slot(random, parts::setups, unit);
        Slot &s = slots[at];
        bool go = start && s.wanted.empty() && (!s.begun || random.percent(30));
        if (!go) return -1;
        int kind = SHADOW && random.percent(40) ? SPH_SHADOW
                   : random.percent(50)         ? SPH_PRIMARY
                                                : SPH_REFLECTED;
        s.ray = world.ray(random, kind);
        if (!INSIDE) s.ray.skip.inside = 0;
        s.begun = true;
        parts::put_ray(dut.ray_i, at, s.ray);
        parts::put_in_ray(dut.ray_i, at, RT_RAY_VALID, true);
        bench::put(dut.lift_i, 3 * (NG + 2) * unit, 3 * (NG + 2),
                   (bench::i128)world::pack(s.ray.lift, NG + 2));
        return at;
    }

    /* What a leaf child must give; one that memory has not is a miss. */
    struct sph_hit test(int at, uint32_t line, uint32_t child) {
        if (parts::leaf_units.of(at) != memory.spoilt_for)
            return world.leaf(slots[at].ray, line, child, &counters, &errors);
        errors |= 1u << SPH_ERROR_BUS_ERROR;
        return {0, SPH_ID_NONE, 0};
    }

    void give_visit(int pipe, bool start, int told) {
        const parts::Units &u = parts::pipes;
        int at = (pipe << u.own()) + (int)random.below(1u << u.own());
        auto put = [&](int lsb, int bits, int64_t value) {
            u.put(dut.visit_i, pipe, RT_VISIT_BITS, lsb, bits, value);
        };
        Slot &s = slots[at];
        bool go = start && at != told && s.begun && s.wanted.empty() && random.percent(pace);
        put(RT_VISIT_VALID, go);
        if (!go) return;
        unsigned leaf = 1 + (unsigned)random.below(15);
        uint32_t line = world.part(random) + (uint32_t)random.below(world.scene_lines - 3);
        for (uint32_t j = 0; j < 4; j++)
            lines.insert(line + j);
        for (uint32_t j = 0; j < 4; j++)
            if (leaf >> j & 1) s.wanted.push_back(test(at, line, j));
        u.put_slot(dut.visit_i, pipe, RT_VISIT_BITS, RT_VISIT_SLOT, at);
        put(RT_VISIT_LEAF, leaf);
        put(RT_VISIT_LINE, line);
    }

    void give_fetch(int unit, bool start) {
        const parts::Units &u = parts::shades;
        int at = (unit << u.own()) + (int)random.below(1u << u.own());
        if (memory.spoilt_for >= 0) return;
        if (fetches(unit) || !start || slots[at].fetch >= 0 || !random.percent(10)) return;
        slots[at].fetch = (int64_t)(world.part(random) + random.below(world.scene_lines));
        lines.insert((uint32_t)slots[at].fetch);
        put_fetch(unit, RT_FETCH_VALID, 1);
        u.put_slot(dut.fetch_i, unit, RT_FETCH_BITS, RT_FETCH_SLOT, at);
        put_fetch(unit, RT_FETCH_LINE, slots[at].fetch);
    }

    /* A result, with its whole slot, as results.h wants it. */
    void take_result(int unit) {
        uint32_t whole[(RT_RESULT_BITS + 31) / 32] = {};
        for (int i = 0; i < RT_RESULT_BITS - parts::leaf_units.top(); i++)
            bench::put(whole, i, 1, (bench::i128)of_result(unit, i, 1));
        bench::put(whole, RT_RESULT_SLOT,
                   parts::leaf_units.slot(dut.result_o, unit, RT_RESULT_BITS, RT_RESULT_SLOT));
        world::take_result(*this, slots, whole);
    }

    void take_record(int unit) {
        const parts::Units &u = parts::shades;
        int at = u.slot(dut.record_o, unit, RT_RECORD_BITS, RT_RECORD_SLOT);
        Slot &s = slots[at];
        if (s.fetch < 0) return fail("a record that nobody asked for");
        for (int i = 0; i < 8; i++)
            expect("DATA",
                   (bench::i128)u.get(dut.record_o, unit, RT_RECORD_BITS,
                                      world::first_bit(RT_RECORD_DATA) + 32 * i, 32),
                   world.line((uint32_t)s.fetch)[i], 32);
        s.fetch = -1;
        if (bad()) done();
    }
};

/* The bench: its exit status. */
int run(LeafVisits &b) {
    b.reset();
    for (int i = 0; i < 2 * SLOTS; i++)
        b.clock(false);
    bench::phases(b, 100, 3000, 20000, "a result or a record got lost");
    return b.finish();
}

} // namespace

#endif
