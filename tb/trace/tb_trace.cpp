/* tb_trace.cpp - rt_trace against sph_traverse(), or with ACCEL against sph_bih_walk()
 * SPDX-License-Identifier: Apache-2.0
 *
 * Every slot follows one pixel after another: its primary ray, again or not, then shadow and
 * reflected rays from anywhere. The bench stands in for rt_leaf_unit: results of leaf children come
 * late and in any order. A vector is a ray that is done. Between phases the limit of visits changes
 * and events are compared with the model's counters.
 * Compiled with -O0, for it has few vectors.
 */
#include "Vrt_trace.h"
#include "engine/world.h"

#ifndef SHADOW
#define SHADOW 1
#endif
#ifndef FIRST
#define FIRST 1
#endif
#ifndef FARS
#define FARS 1
#endif

namespace {

struct Slot {
    enum { IDLE, HELD, RUNS } state = IDLE; /* HELD: a shadow ray whose token has not started */
    struct sph_ray ray = {};
    struct sph_hit hit = {};
    uint32_t visits = 0; /* of the pixel */
    bool begun = false;  /* the slot has a pixel */
};

struct Result {
    int slot;
    struct sph_hit hit;
};

class Trace : public bench::Bench<Vrt_trace> {
  public:
    Trace(int argc, char **argv)
        : Bench("tb_trace", argc, argv, 20000), world(FIRST), memory(*this, world),
          limit(world.m.regs[SPH_REG_VISIT_LIMIT]) {}

    /* All slots are idle: other registers, caches forgotten. */
    void phase() {
        world.m.regs[SPH_REG_VISIT_LIMIT] = random.percent(70) ? limit : (int32_t)random.below(6);
        world.put_regs(dut.regs_i);
        pace = random.percent(50) ? 100 : (unsigned)random.between(2, 60);
        testing = random.percent(50) ? 100 : (unsigned)random.between(5, 60);
        dut.flush_i = random.percent(50);
        counters = {};
        errors = faults = 0;
        visits = tests = 0;
        clock(false);
        dut.flush_i = 0;
    }

    void clock(bool start) {
        launch(start);
        answer();
        int ask = done_slot; /* whose visits are read */
        dut.visits_read_i = ask >= 0;
        dut.visits_slot_i = (uint8_t)(ask >= 0 ? ask : 0);
        memory.before();
        if (bench::get(dut.visit_o, RT_VISIT_VALID)) take_visit();
        if (read_slot >= 0) {
            expect("visits_o", dut.visits_o, slots[read_slot].visits, 24);
            finish_ray(read_slot);
        }
        read_slot = ask;
        if (ask >= 0) check_done(ask);
        done_slot = dut.done_valid_o ? (int)dut.done_slot_o : -1;
        if (done_slot >= 0 && slots[done_slot].state != Slot::RUNS) fail("no such ray");
        visits += bench::get(dut.event_o, RT_TRACE_EVENT_VISIT) != 0;
        tests += (uint64_t)bench::get(dut.event_o, RT_TRACE_EVENT_TESTS);
        faults |= dut.fault_o;
        tick();
    }

    bool all_idle() const {
        for (const Slot &s : slots)
            if (s.state != Slot::IDLE) return false;
        return true;
    }

    void compare() {
        for (int i = 0; i < 4; i++)
            clock(false);
        expect("VISIT", (bench::i128)visits, (bench::i128)counters.count[SPH_COUNT_NODE_VISITS]);
        expect("TESTS", (bench::i128)tests, (bench::i128)counters.count[SPH_COUNT_CHILD_TESTS]);
        expect("fault_o", faults, errors, 4);
        done();
    }

  private:
    world::World world;
    world::Memory<Vrt_trace> memory;
    const int32_t limit;
    Slot slots[SLOTS];
    std::vector<Result> results;
    struct sph_counters counters = {};
    uint32_t errors = 0, faults = 0;
    uint64_t visits = 0, tests = 0;
    unsigned pace = 100, testing = 100; /* percent of clocks with a new ray, with a result */
    int done_slot = -1, read_slot = -1;

    void launch(bool start) {
        int at = (int)random.below(SLOTS);
        Slot &s = slots[at];
        bool go = start && s.state == Slot::IDLE && random.percent(pace);
        bench::put(dut.ray_i, RT_RAY_VALID, go);
        dut.ray_again_i = 0;
        if (go) {
            bool again = s.begun && random.percent(10);
            bool primary = !s.begun || again || random.percent(30);
            int kind = primary                        ? SPH_PRIMARY
                       : SHADOW && random.percent(50) ? SPH_SHADOW
                                                      : SPH_REFLECTED;
            s.begun = true;
            s.ray = world.ray(random, kind);
            s.ray.first = FIRST && primary && !again && world.on(SPH_EFFECT_FIRST);
            if (primary && !again) s.visits = 0;
            s.hit =
                sph_traverse(&world.m, &s.ray, SPH_TRAVERSE_TREE, &counters, &s.visits, &errors);
            s.state = kind == SPH_SHADOW ? Slot::HELD : Slot::RUNS;
            world::put_ray(dut.ray_i, at, s.ray);
            world::put_filter(dut.filter_i, s.ray);
            dut.ray_again_i = again;
        }
        int held = (int)random.below(SLOTS); /* a shadow ray starts clocks after it is told */
        dut.shadow_go_i = held != at && slots[held].state == Slot::HELD;
        dut.shadow_slot_i = (uint8_t)held;
        if (dut.shadow_go_i) slots[held].state = Slot::RUNS;
    }

    void answer() {
        bool now = !results.empty() && random.percent(testing);
        bench::put(dut.result_i, RT_RESULT_VALID, now);
        if (!now) return;
        size_t n = (size_t)random.below(results.size());
        const Result r = results[n];
        results.erase(results.begin() + (long)n);
        bench::put(dut.result_i, RT_RESULT_SLOT, r.slot);
        bench::put(dut.result_i, RT_RESULT_HIT, r.hit.key != 0);
        bench::put(dut.result_i, RT_RESULT_FAR, r.hit.far);
        bench::put(dut.result_i, RT_RESULT_ID, r.hit.id);
        bench::put(dut.result_i, RT_RESULT_KEY, (bench::i128)(r.hit.key ? r.hit.key : 1));
    }

    void take_visit() {
        int slot = (int)bench::get(dut.visit_o, RT_VISIT_SLOT);
        unsigned leaf = (unsigned)bench::get(dut.visit_o, RT_VISIT_LEAF);
        uint32_t line = (uint32_t)bench::get(dut.visit_o, RT_VISIT_LINE), bad = 0;
        struct sph_counters unused = {};
        if (!leaf || slots[slot].state != Slot::RUNS) return fail("a visit of nothing");
        for (uint32_t j = 0; j < 4; j++)
            if (leaf >> j & 1)
                results.push_back({slot, world.leaf(slots[slot].ray, line, j, &unused, &bad)});
    }

    void check_done(int at) {
        const Slot &s = slots[at];
        auto field = [&](const char *what, int lsb, int bits, uint64_t expected) {
            expect(what, (bench::i128)bench::get(dut.done_o, lsb, bits), (bench::i128)expected,
                   bits);
        };
        field("FOUND", RT_DONE_FOUND, s.hit.key != 0);
        field("SHADOW", RT_DONE_SHADOW, s.ray.kind == SPH_SHADOW);
        field("PRIMARY", RT_DONE_PRIMARY, s.ray.kind == SPH_PRIMARY);
        field("FIRST", RT_DONE_FIRST, (uint64_t)s.ray.first);
        if (!s.hit.key) return;
        field("KEY", RT_DONE_KEY, s.hit.key);
        if (s.ray.kind == SPH_SHADOW) return; /* any occluder will do */
        field("ID", RT_DONE_ID, s.hit.id);
        if (FARS) field("FAR", RT_DONE_FAR, (uint64_t)s.hit.far);
    }

    void finish_ray(int at) {
        Slot &s = slots[at];
        if (bad()) {
            show("slot", at, SLOTW);
            show("kind", s.ray.kind, 2);
            for (int i = 0; i < 3; i++)
                show("org", s.ray.org[i], W), show("dir", s.ray.dir[i], WD);
            show("skip", s.ray.skip.id, 24);
            show("limit of visits", world.m.regs[SPH_REG_VISIT_LIMIT], 24);
        }
        s.state = Slot::IDLE;
        done();
    }
};

} // namespace

int main(int argc, char **argv) {
    Trace b(argc, argv);
    b.reset();
    for (int i = 0; i < 2 * SLOTS; i++)
        b.clock(false);
    while (b.more()) {
        b.phase();
        for (uint64_t i = b.random.between(100, 3000); i && b.more(); i--)
            b.clock(true);
        uint64_t since = b.cycle;
        while (!b.all_idle() && b.cycle - since < 200000)
            b.clock(false);
        if (!b.all_idle()) {
            b.fail("a ray got lost");
            break;
        }
        b.compare();
    }
    return b.finish();
}
