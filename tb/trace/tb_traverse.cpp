/* tb_traverse.cpp - rt_traverse against sph_visit()
 * SPDX-License-Identifier: Apache-2.0
 *
 * Memory is full of random nodes, sound and broken; some lines answer with an error. Rays of all
 * slots visit node after node, which the bench picks at will, each visit with a depth limit of its
 * own. A vector is a visit. The bench follows the queues of tokens, so that it knows in which clock
 * each event and each fault must be seen; all outcomes must have been tried at the end.
 */
#include <deque>

#include "trace/visit_rays.h"

namespace {

constexpr uint64_t LATENCY = 12; /* clocks from a node that leaves the cache to found_o */
constexpr uint64_t ISSUE = 4;

struct Due { /* a visit whose node has left the cache */
    int slot;
    uint64_t at;
};

class Traverse : public VisitRays {
  public:
    Traverse(int argc, char **argv) : VisitRays(argc, argv) {}

    void phase() {
        VisitRays::phase();
        clock(false);
        dut.flush_i = 0;
    }

    /* go_on: rays start, and most of them visit another node. */
    void clock(bool go_on) {
        int asked = depth_slot;
        bench::set(dut.depth_i, FW + 1,
                   asked < 0 ? (int32_t)random.bits(FW + 1) : slots[asked].depth);
        put_axes();
        int told = launch(go_on), held = release(told), next = send(go_on), read = ask(told);
        memory.before();
        if (reading >= 0) expect("visits_o", dut.visits_o, slots[reading].pixel, 24);
        reading = read;
        check_events();
        take_node();
        for (; !arrivals.empty() && arrivals.front().at <= cycle; arrivals.pop_front())
            arrivals.front().tokens->push_back(arrivals.front().slot);
        if (bench::get(dut.event_o, RT_TRACE_EVENT_ISSUED)) issue();
        check_found();
        if (next >= 0) arrive(next_queue, next);
        if (held >= 0) arrive(shadow_queue, held, START);
        if (told >= 0 && slots[told].ray.kind != SPH_SHADOW) arrive(new_queue, told, START);
        tick();
    }

    void compare() {
        expect("MISS", (bench::i128)misses, (bench::i128)memory.requests, 64);
        if (bad()) done();
        if (all_vectors && !more() && !outcomes.all(FIRST || SHADOW))
            fail("not every outcome was tried");
    }

  private:
    /* The choice among the queues is told ISSUE clocks after its token could be chosen first. */
    struct Arrival {
        std::deque<int> *tokens;
        int slot;
        uint64_t at;
    };
    std::deque<int> next_queue, shadow_queue, new_queue;
    std::deque<Arrival> arrivals;
    void arrive(std::deque<int> &tokens, int slot, uint64_t waits = 0) {
        auto at = arrivals.end();
        while (at != arrivals.begin() && (at - 1)->at > cycle + ISSUE + waits)
            --at;
        arrivals.insert(at, {&tokens, slot, cycle + ISSUE + waits});
    }
    std::deque<Due> due;
    int depth_slot = -1;
    struct {
        bool visit, limit, line, error;
    } now = {}, then = {};                  /* what this clock must show, and the next */
    uint32_t tests[3] = {}, broken[3] = {}; /* in this clock, in the next two */
    uint64_t misses = 0;
    Outcomes outcomes;

    /* Events and faults of this clock. */
    void check_events() {
        now = then;
        then = {};
        uint32_t faults = (uint32_t)(now.line || broken[0]) << SPH_ERROR_BAD_NODE |
                          (uint32_t)now.limit << SPH_ERROR_VISIT_LIMIT |
                          (uint32_t)now.error << SPH_ERROR_BUS_ERROR;
        expect("VISIT", (bench::i128)bench::get(dut.event_o, RT_TRACE_EVENT_VISIT), now.visit, 1);
        expect("TESTS", (bench::i128)bench::get(dut.event_o, RT_TRACE_EVENT_TESTS), tests[0], 3);
        expect("fault_o", dut.fault_o, faults, 4);
        misses += bench::get(dut.event_o, RT_TRACE_EVENT_MISS) != 0;
        for (int i = 0; i < 2; i++)
            tests[i] = tests[i + 1], broken[i] = broken[i + 1];
        tests[2] = broken[2] = 0;
        if (bad()) done();
    }

    /* A token goes to the cache: those of rays under way first, then shadow rays. */
    void issue() {
        std::deque<int> &tokens = !next_queue.empty()     ? next_queue
                                  : !shadow_queue.empty() ? shadow_queue
                                                          : new_queue;
        if (tokens.empty()) return fail("a token of nobody");
        Slot &s = slots[tokens.front()];
        tokens.pop_front();
        s.state = Slot::ISSUED;
        s.visits = s.fresh ? 0 : s.visits;
        s.pixel = s.starts ? 0 : s.pixel;
        bool no_line = s.line >= nodes.lines();
        bool no_more = s.visits == (uint32_t)world.m.regs[SPH_REG_VISIT_LIMIT];
        s.kill = no_line || no_more;
        s.visits += !s.kill;
        s.pixel += !s.kill;
        then.visit = !s.kill;
        then.limit = no_more && !no_line;
        then.line = no_line;
        outcomes.issue(s, no_line, (uint32_t)world.m.regs[SPH_REG_VISIT_LIMIT]);
    }

    /* A node leaves the cache; its depth limit is told in the next clock. */
    void take_node() {
        depth_slot = -1;
        if (!dut.depth_read_o) return;
        depth_slot = dut.depth_slot_o;
        Slot &s = slots[depth_slot];
        if (s.state != Slot::ISSUED) return fail("a node that nobody asked for");
        s.depth = random.percent(70) ? sph_depth_limit(&world.p) : (int32_t)random.mixed(FW + 1);
        bool refused = s.kill;
        then.error = memory.spoilt[refused ? 0 : world::World::here(s.line)];
        s.kill |= then.error;
        outcomes.add(refused ? SPOILT_REFUSED : SPOILT, then.error);
        due.push_back({depth_slot, cycle + LATENCY});
        struct sph_found found;
        if (s.kill) return;
        bool sound = sph_visit(&world.m, &s.ray, nullptr, s.line, s.depth, &found);
        outcomes.node(found, sound, nodes.end(s.line, found.line), nodes.lines());
        tests[2] = sound ? found.tests : 0;
        broken[2] = s.kill = !sound;
    }

    void check_found() {
        auto found = [&](int lsb, int bits) {
            return (bench::i128)bench::get(dut.found_o, lsb, bits);
        };
        bool valid = !due.empty() && due.front().at == cycle;
        expect("found VALID", found(RT_FOUND_VALID), valid, 1);
        if (!valid) {
            expect("visit VALID", (bench::i128)bench::get(dut.visit_o, RT_VISIT_VALID), 0, 1);
            if (bad()) done();
            return;
        }
        Slot &s = slots[due.front().slot];
        expect("found SLOT", found(RT_FOUND_SLOT), due.front().slot, SLOTW);
        expect("FRESH", found(RT_FOUND_FRESH), s.fresh, 1);
        expect("KILL", found(RT_FOUND_KILL), s.kill, 1);
        struct sph_found f = {};
        if (!s.kill) sph_visit(&world.m, &s.ray, nullptr, s.line, s.depth, &f);
        if (!s.kill) expect("BASE", found(RT_FOUND_BASE), f.inner.base, SPH_LINE_BITS);
        expect("COUNT", found(RT_FOUND_COUNT), f.inner.count, 3);
        for (int i = 0; i < f.inner.count; i++) {
            bench::u128 entry = (bench::u128)found(RT_FOUND_LIST) >> 18 * i;
            expect("LIST, child", (bench::i128)(entry & 3), f.inner.list[i].child, 2);
            expect("LIST, near", bench::sign(entry >> 2, 16), f.inner.list[i].near, 16);
        }
        check_leaves(due.front().slot, f);
        if (bad()) show_visit(s);
        if (!s.kill) outcomes.found(s.ray, f);
        due.pop_front();
        s.state = Slot::FOUND;
        done();
    }

    void check_leaves(int slot, const struct sph_found &f) {
        auto visit = [&](int lsb, int bits) {
            return (bench::i128)bench::get(dut.visit_o, lsb, bits);
        };
        expect("visit VALID", visit(RT_VISIT_VALID), f.leaves != 0, 1);
        if (!f.leaves) return;
        expect("visit SLOT", visit(RT_VISIT_SLOT), slot, SLOTW);
        expect("LEAF", visit(RT_VISIT_LEAF), f.leaves, 4);
        expect("LINE", visit(RT_VISIT_LINE), f.line, SPH_LINE_BITS);
    }
};

} // namespace

int main(int argc, char **argv) {
    Traverse b(argc, argv);
    b.reset();
    bench::phases(b, 50, 2000, 20000, "a visit got lost");
    return b.finish();
}
