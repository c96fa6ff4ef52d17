/* traced_rays.h - rt_trace or rt_pipes against sph_traverse(), or with ACCEL sph_bih_walk()
 * SPDX-License-Identifier: Apache-2.0
 *
 * Every slot follows one pixel after another: its primary ray, again or not, then shadow and
 * reflected rays from anywhere. The bench stands in for rt_leaf_unit: results of leaf children come
 * late and in any order, with several leaf units from each its own. A vector is a ray that is done.
 * Between phases the limit of visits changes, the tree moves to other addresses and events are
 * compared with the model's counters; in some of them a pipe's memory has nothing but errors. Who
 * includes this has named the module `Top`; with one pipe it may be rt_trace.
 */
#ifndef TB_TRACED_RAYS_H
#define TB_TRACED_RAYS_H

#include "engine/parts.h"
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

class Trace : public bench::Bench<Top> {
  public:
    Trace(const char *name, int argc, char **argv, long rays)
        : Bench(name, argc, argv, rays), world(FIRST), memory(*this, world),
          limit(world.m.regs[SPH_REG_VISIT_LIMIT]) {
        world.repeat();
        memory.wanted = [this](uint32_t line) { return world.there(line); };
    }

    /* All slots are idle: other registers, caches forgotten. */
    void phase() {
        world.m.regs[SPH_REG_VISIT_LIMIT] = random.percent(70) ? limit : (int32_t)random.below(6);
        const int turn = phases++ % 2 ? phases / 2 - 1 : PIPES; /* each pipe's, between others */
        dut.flush_i = turn < PIPES || random.percent(50);
        memory.spoilt_for = -1;
        if (dut.flush_i && ACCEL != 1 && (turn < PIPES || random.percent(20)))
            memory.spoilt_for = turn < PIPES ? turn : (int)random.below(PIPES);
        if (dut.flush_i) world.move(world.part(random));
        world.put_regs(dut.regs_i);
        pace = random.percent(50) ? 100 : (unsigned)random.between(2, 60);
        testing = random.percent(50) ? 100 : (unsigned)random.between(5, 60);
        counters = {};
        errors = faults = 0;
        visits = tests = 0;
        clock(false);
        dut.flush_i = 0;
    }

    void clock(bool start) {
        launch(start);
        axes.put(dut.across_i, cycle);
        answer();
        int ask = done_slot; /* whose visits are read */
        dut.visits_read_i = ask >= 0;
        dut.visits_slot_i = (uint8_t)(ask >= 0 ? ask : 0);
        memory.before();
        for (int p = 0; p < PIPES; p++)
            if (of_visit(p, RT_VISIT_VALID)) take_visit(p);
        if (read_slot >= 0) {
            expect("visits_o", dut.visits_o, slots[read_slot].visits, 24);
            finish_ray(read_slot);
        }
        read_slot = ask;
        if (ask >= 0) check_done(ask);
        done_slot = dut.done_valid_o ? (int)dut.done_slot_o : -1;
        if (done_slot >= 0 && slots[done_slot].state != Slot::RUNS) fail("no such ray");
        for (int p = 0; p < PIPES; p++) {
            visits += of_event(p, RT_TRACE_EVENT_VISIT);
            tests += of_event(p, RT_TRACE_EVENT_TESTS);
        }
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
    world::Memory<Top, PIPES> memory;
    const int32_t limit;
    static constexpr uint64_t BEHIND = 12; /* clocks from a ray to its axes, at most */
    parts::Axes axes;
    Slot slots[SLOTS];
    std::vector<Result> results[LEAF_UNITS];
    struct sph_counters counters = {};
    uint32_t errors = 0, faults = 0;
    uint64_t visits = 0, tests = 0;
    unsigned pace = 100, testing = 100; /* percent of clocks with a new ray, with a result */
    int done_slot = -1, read_slot = -1;
    int phases = 0;

    uint64_t of_visit(int pipe, int lsb, int bits) {
        return (uint64_t)parts::pipes.get(dut.visit_o, pipe, RT_VISIT_BITS, lsb, bits);
    }
    uint64_t of_event(int pipe, int lsb, int bits) {
        return (uint64_t)bench::get(dut.event_o, RT_TRACE_EVENT_BITS * pipe + lsb, bits);
    }

    void launch(bool start) {
        for (int unit = 0; unit < SHADES; unit++) /* a shadow ray starts clocks after it is told */
            start_shadow(unit);
        parts::no_ray(dut.ray_i);
        dut.ray_again_i = 0;
        for (int unit = 0; unit < SETUPS; unit++)
            launch(unit, start);
    }

    void launch(int unit, bool start) {
        int at = parts::any_slot(random, parts::setups, unit);
        Slot &s = slots[at];
        bool go = start && s.state == Slot::IDLE && random.percent(pace);
        if (go) {
            bool again = SETUPS == 1 && s.begun && random.percent(10);
            bool primary = !s.begun || again || random.percent(30);
            int kind = primary                        ? SPH_PRIMARY
                       : SHADOW && random.percent(50) ? SPH_SHADOW
                                                      : SPH_REFLECTED;
            s.begun = true;
            s.ray = world.ray(random, kind);
            if (kind == SPH_REFLECTED && random.percent(10)) flatten(s.ray);
            s.ray.first = FIRST && primary && !again && world.on(SPH_EFFECT_FIRST);
            if (primary && !again) s.visits = 0;
            if (parts::pipes.of(at) == memory.spoilt_for)
                fall(s);
            else
                s.hit = sph_traverse(&world.m, &s.ray, SPH_TRAVERSE_TREE, &counters, &s.visits,
                                     &errors);
            s.state = kind == SPH_SHADOW ? Slot::HELD : Slot::RUNS;
            parts::put_ray(dut.ray_i, at, s.ray);
            parts::put_in_ray(dut.ray_i, at, RT_RAY_VALID, true);
            parts::put_filter(dut.filter_i, at, s.ray);
            axes.send(at, s.ray, cycle + BEHIND);
            dut.ray_again_i = again; /* with one set-up unit */
        }
    }

    /* A ray that hardly moves along an axis, or not at all. */
    void flatten(struct sph_ray &ray) {
        int axis = (int)random.below(3);
        ray.dir[axis] = random.between(-1, 1);
        if (!ray.dir[0] && !ray.dir[1] && !ray.dir[2]) ray.dir[axis] = 1;
        sph_ray_setup(&world.p, &ray);
    }

    /* Of a ray whose first visit ends with an error of memory; one that is refused reads too. */
    void fall(Slot &s) {
        bool refused = !world.m.regs[SPH_REG_VISIT_LIMIT];
        s.hit = {0, SPH_ID_NONE, 0, 0};
        s.visits += !refused;
        counters.count[SPH_COUNT_NODE_VISITS] += !refused;
        errors |= 1u << SPH_ERROR_BUS_ERROR | (uint32_t)refused << SPH_ERROR_VISIT_LIMIT;
    }

    void start_shadow(int unit) {
        const parts::Units &u = parts::shades;
        int held = (unit << u.own()) + (int)random.below(1u << u.own());
        bool go = slots[held].state == Slot::HELD;
        bench::put(dut.shadow_go_i, unit, 1, go);
        bench::put(dut.shadow_slot_i, unit * u.own(), u.own(), held);
        if (go) slots[held].state = Slot::RUNS;
    }

    void answer() {
        for (int unit = 0; unit < LEAF_UNITS; unit++)
            answer(unit);
    }

    void answer(int unit) {
        auto put = [&](int lsb, int bits, bench::i128 value) {
            parts::leaf_units.put(dut.result_i, unit, RT_RESULT_BITS, lsb, bits, value);
        };
        std::vector<Result> &waits = results[unit];
        bool now = !waits.empty() && random.percent(testing);
        put(RT_RESULT_VALID, now);
        if (!now) return;
        size_t n = (size_t)random.below(waits.size());
        const Result r = waits[n];
        waits.erase(waits.begin() + (long)n);
        parts::leaf_units.put_slot(dut.result_i, unit, RT_RESULT_BITS, RT_RESULT_SLOT, r.slot);
        put(RT_RESULT_HIT, r.hit.key != 0);
        put(RT_RESULT_FAR, r.hit.far);
        put(RT_RESULT_ID, r.hit.id);
        put(RT_RESULT_KEY, (bench::i128)(r.hit.key ? r.hit.key : 1));
    }

    void take_visit(int pipe) {
        int slot = parts::pipes.slot(dut.visit_o, pipe, RT_VISIT_BITS, RT_VISIT_SLOT);
        unsigned leaf = (unsigned)of_visit(pipe, RT_VISIT_LEAF);
        uint32_t line = (uint32_t)of_visit(pipe, RT_VISIT_LINE), bad = 0;
        struct sph_counters unused = {};
        if (!leaf || slots[slot].state != Slot::RUNS) return fail("a visit of nothing");
        if (!world.there(line)) return fail("a visit in another part of memory");
        for (uint32_t j = 0; j < 4; j++)
            if (leaf >> j & 1)
                results[parts::leaf_units.of(slot)].push_back(
                    {slot, world.leaf(slots[slot].ray, line, j, &unused, &bad)});
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
        if (FARS && FIRST) field("FARS", RT_DONE_FARS, (uint64_t)s.hit.fars);
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

/* The bench: its exit status. */
int run(Trace &b) {
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

} // namespace

#endif
