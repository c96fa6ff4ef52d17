/* tb_bih.cpp - rt_bih against sph_bih_walk()
 * SPDX-License-Identifier: Apache-2.0
 *
 * Rays of all slots go through the trees of bih_memory.h. The bench stands in for rt_leaf_unit and
 * rt_closest_hit with the model's functions: records are tested late and in any order. A vector is
 * a ray that is done; events and faults of a phase are counted. All outcomes must have been tried
 * at the end.
 */
#include "Vrt_bih.h"
#include "Vrt_bih___024root.h"
#include "trace/bih_memory.h"

extern "C" {
#include "trace/bih.h"
#include "trace/bih_walk.h"
}

#ifndef SHADOW
#define SHADOW 1
#endif

namespace {

constexpr int MANY = 1100; /* visits: more than a ray down the chain needs */

struct Chunk { /* records under test */
    int slot;
    struct sph_hit best;
};

class Bih : public bench::Bench<Vrt_bih> {
  public:
    Bih(int argc, char **argv)
        : Bench("tb_bih", argc, argv, 40000), world(0), trees(world), memory(*this, world) {
        memory.spoilt.resize(world::Repeated::ALIKE);
        memory.wanted = [this](uint32_t line) { return trees.there(line); };
        dut.flush_i = dut.shadow_go_i = dut.tested_valid_i = dut.visits_read_i = 0;
        bench::put(dut.ray_i, RT_RAY_VALID, 0);
    }

    /* All slots are idle: another tree, other registers; the cache forgets. */
    void phase() {
        trees.fill(random, memory.spoilt);
        int32_t limit = trees.tree == SCENE_TREE ? world.m.regs[SPH_REG_VISIT_LIMIT] : MANY;
        if (random.percent(30)) limit = (int32_t)random.below(random.percent(30) ? 2 : 20);
        world.m.regs[SPH_REG_VISIT_LIMIT] = trees.model.regs[SPH_REG_VISIT_LIMIT] = limit;
        world.put_regs(dut.regs_i);
        pace = random.percent(50) ? 100 : (unsigned)random.between(2, 60);
        testing = random.percent(50) ? 100 : (unsigned)random.between(5, 60);
        dut.flush_i = 1;
        clock(false);
        dut.flush_i = 0;
        for (int i = 0; i < 3; i++) /* registers are looked at ahead */
            clock(false);
    }

    void clock(bool start) {
        if (asked >= 0) answer(slots[asked]);
        int told = launch(start);
        release(told);
        test();
        int read = dut.done_valid_o ? dut.done_slot_o : -1;
        dut.visits_read_i = read >= 0;
        dut.visits_slot_i = (uint8_t)(read >= 0 ? read : 0);
        memory.before();
        if (told >= 0) expect("ray_limit_o", dut.ray_limit_o, slots[told].bih.limit, SPH_BIH_T);
        if (bench::get(dut.visit_o, RT_VISIT_VALID)) take_visit();
        if (reading >= 0) check_ray(slots[reading]);
        reading = read;
        asked = dut.limit_read_o ? dut.limit_slot_o : -1;
        count_events();
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
        expect("ISSUED", (bench::i128)issued,
               (bench::i128)(counters.count[SPH_COUNT_NODE_VISITS] +
                             outcomes.errors[SPH_ERROR_VISIT_LIMIT]));
        expect("MISS", (bench::i128)misses, (bench::i128)memory.requests);
        static const char *const names[] = {"BAD_NODE", "STACK_OVERFLOW", "VISIT_LIMIT",
                                            "BUS_ERROR"};
        for (int i = 0; i < 4; i++)
            expect(names[i], (bench::i128)faults[i], (bench::i128)outcomes.errors[i]);
        if (bad()) {
            show_phase();
            done();
        }
        if (all_vectors && !more() && !outcomes.all(SHADOW)) fail("not every outcome was tried");
    }

  private:
    world::World world;
    BihMemory trees;
    world::Memory<Vrt_bih> memory;
    Slot slots[SLOTS];
    std::vector<Chunk> chunks;
    struct sph_counters counters = {};
    uint64_t visits = 0, tests = 0, issued = 0, misses = 0;
    uint64_t faults[4] = {};
    Outcomes outcomes;
    int asked = -1, reading = -1;
    unsigned pace = 100, testing = 100;

    /* A ray for an idle slot, and what the model makes of it; its number, or -1. */
    int launch(bool start) {
        int at = (int)random.below(SLOTS);
        Slot &s = slots[at];
        bool go = start && s.state == Slot::IDLE && random.percent(pace);
        bench::put(dut.ray_i, RT_RAY_VALID, go);
        dut.pixel_i = random.percent(50);
        if (!go) return -1;
        int kind = !s.begun || random.percent(30) ? SPH_PRIMARY
                   : SHADOW && random.percent(50) ? SPH_SHADOW
                                                  : SPH_REFLECTED;
        if (!s.begun) dut.pixel_i = 1;
        if (kind != SPH_SHADOW && dut.pixel_i) {
            s.pixel = 0;
        } else if (random.percent(20)) { /* as many as no bench makes */
            auto &word = dut.rootp->rt_bih__DOT__u_visits__DOT__g_luts__DOT__mem[at];
            s.pixel = (uint32_t)random.below(0xfff000);
            word = (word & ~(uint64_t)0xffffff) | s.pixel;
        }
        s.begun = true;
        s.ray = world.ray(random, kind);
        sph_bih_setup(&world.p, &s.ray, &s.bih);
        s.hit = {0, SPH_ID_NONE, 0, 0};
        s.work = s.ours = {};
        uint32_t found = 0;
        s.wanted = sph_bih_walk(&trees.model, &s.ray, &s.work, &s.pixel, &found, nullptr);
        for (int i = 0; i < SPH_COUNTERS; i++)
            counters.count[i] += s.work.count[i];
        outcomes.ray(s, found, trees, memory.spoilt[0]);
        s.state = kind == SPH_SHADOW ? Slot::HELD : Slot::RUNS;
        world::put_ray(dut.ray_i, at, s.ray);
        return at;
    }

    /* A shadow ray that was told before starts. */
    void release(int told) {
        int at = (int)random.below(SLOTS);
        dut.shadow_go_i = at != told && slots[at].state == Slot::HELD;
        dut.shadow_slot_i = (uint8_t)at;
        if (dut.shadow_go_i) slots[at].state = Slot::RUNS;
    }

    /* What rt_closest_hit would say of the slot that was asked for in the clock before. */
    void answer(const Slot &s) {
        dut.hit_i = s.hit.key != 0;
        dut.ends_i = s.ray.kind == SPH_SHADOW;
        dut.limit_i = s.hit.key ? sph_bih_time(&s.bih, s.hit.key) : s.bih.limit;
    }

    void take_visit() {
        int slot = (int)bench::get(dut.visit_o, RT_VISIT_SLOT);
        unsigned leaf = (unsigned)bench::get(dut.visit_o, RT_VISIT_LEAF);
        uint32_t line = (uint32_t)bench::get(dut.visit_o, RT_VISIT_LINE), errors_of_records = 0;
        Slot &s = slots[slot];
        expect("count_o", dut.count_o, __builtin_popcount(leaf), 3);
        if (!leaf || s.state != Slot::RUNS) return fail("records of nobody");
        Chunk chunk = {slot, {0, SPH_ID_NONE, 0}};
        for (uint32_t j = 0; j < 4; j++) {
            if (!(leaf >> j & 1)) continue;
            if (line + (sph_whole(&world.m) ? j : j / 2) >=
                (uint32_t)world.m.regs[SPH_REG_MEM_LINES])
                return fail("records behind the end of memory");
            struct sph_hit h = world.leaf(s.ray, line, j, &s.ours, &errors_of_records);
            if (h.key && (!chunk.best.key || h.key < chunk.best.key ||
                          (h.key == chunk.best.key && h.id < chunk.best.id)))
                chunk.best = h;
        }
        chunks.push_back(chunk);
    }

    /* The records of a chunk have been tested. */
    void test() {
        dut.tested_valid_i = !chunks.empty() && random.percent(testing);
        if (!dut.tested_valid_i) return;
        size_t n = (size_t)random.below(chunks.size());
        const Chunk c = chunks[n];
        chunks.erase(chunks.begin() + (long)n);
        dut.tested_slot_i = (uint8_t)c.slot;
        struct sph_hit &best = slots[c.slot].hit;
        if (c.best.key &&
            (!best.key || c.best.key < best.key || (c.best.key == best.key && c.best.id < best.id)))
            best = c.best;
    }

    void check_ray(Slot &s) {
        if (s.state != Slot::RUNS) return fail("no such ray");
        expect("visits_o", dut.visits_o, s.pixel, 24);
        expect("hit", s.hit.key != 0, s.wanted.key != 0, 1);
        if (s.ray.kind != SPH_SHADOW) { /* any occluder will do */
            expect("key", (bench::i128)s.hit.key, (bench::i128)s.wanted.key, W + WD + 2);
            expect("id", s.hit.id, s.wanted.id, 24);
        }
        for (int i : {SPH_COUNT_LEAF_TESTS, SPH_COUNT_FACET_TESTS})
            expect("records", (bench::i128)s.ours.count[i], (bench::i128)s.work.count[i], 32);
        if (bad()) {
            show_phase();
            show("kind", s.ray.kind, 2);
            for (int i = 0; i < 3; i++)
                show("org", s.ray.org[i], W), show("dir", s.ray.dir[i], WD);
        }
        s.state = Slot::IDLE;
        done();
    }

    void show_phase() const {
        show("tree", trees.tree, 2);
        show("trouble", trees.trouble, 2);
        show("limit of visits", world.m.regs[SPH_REG_VISIT_LIMIT], 24);
    }

    void count_events() {
        visits += bench::get(dut.event_o, RT_TRACE_EVENT_VISIT) != 0;
        tests += (uint64_t)bench::get(dut.event_o, RT_TRACE_EVENT_TESTS);
        issued += bench::get(dut.event_o, RT_TRACE_EVENT_ISSUED) != 0;
        misses += bench::get(dut.event_o, RT_TRACE_EVENT_MISS) != 0;
        outcomes.add(BUBBLE, bench::get(dut.event_o, RT_TRACE_EVENT_BUBBLE) != 0);
        for (int i = 0; i < 4; i++)
            faults[i] += dut.fault_o >> i & 1;
    }
};

} // namespace

int main(int argc, char **argv) {
    Bih b(argc, argv);
    b.reset();
    bench::phases(b, 50, 2000, 200000, "a ray got lost");
    return b.finish();
}
