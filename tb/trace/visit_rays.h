/* visit_rays.h - the rays of tb_traverse: which nodes they visit, and when
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef TB_TRACE_VISIT_RAYS_H
#define TB_TRACE_VISIT_RAYS_H

#include <deque>
#include <utility>

#include "Vrt_traverse.h"
#include "Vrt_traverse___024root.h"
#include "bench.h"
#include "trace/random_nodes.h"

/* ---- what a visit of tb_traverse may lead to, and how often it did ---- */

extern "C" {
#include "trace/traverse.h"
}

namespace {

enum Outcome {
    NOTHING,   /* no child is met */
    ONE_INNER, /* 1 .. 4 inner children */
    FOUR_INNER = ONE_INNER + 3,
    LEAVES,         /* leaf children alone */
    BOTH,           /* inner and leaf children */
    TIES,           /* two inner children at the same depth */
    IN_ORDER,       /* two or more, in the order of the node */
    LAST_LINE,      /* the children end with memory */
    BEHIND,         /* they end one line behind it */
    FIVE,           /* more than four children */
    NO_LINE,        /* the node lies behind the end of memory */
    NO_ROOT,        /* and it is the first of its ray */
    LIMIT,          /* one visit more than the limit */
    AT_LIMIT,       /* the last visit that the limit lets through */
    NO_VISIT,       /* the limit is 0 */
    SPOILT,         /* an error of memory */
    SPOILT_REFUSED, /* an error of line 0, which a visit that is refused reads */
    OUTCOMES
};

struct Slot {
    enum { IDLE, HELD, QUEUED, ISSUED, FOUND } state = IDLE;
    struct sph_ray ray = {};
    uint32_t line = 0, visits = 0, pixel = 0; /* node to visit; visits of the ray, of the pixel */
    bool fresh = false, starts = false;       /* first visit of the ray, of the pixel */
    bool begun = false;                       /* the slot has a pixel */
    bool kill = false;                        /* the visit leads to nothing */
    int32_t depth = 0;                        /* limit of the visit */
};

class Outcomes {
  public:
    void add(Outcome outcome, bool seen) { count[outcome] += seen; }

    /* A token goes to the cache, or is refused. */
    void issue(const Slot &s, bool no_line, uint32_t limit) {
        add(no_line ? s.fresh ? NO_ROOT : NO_LINE : s.fresh ? NO_VISIT : LIMIT, s.kill);
        add(AT_LIMIT, !s.kill && s.visits == limit);
    }

    /* A node is there; its children end before line `end`, memory before line `lines`. */
    void node(const struct sph_found &f, bool sound, uint32_t end, uint32_t lines) {
        add(LAST_LINE, sound && end == lines);
        add(FIVE, !sound && f.tests > 4 && end <= lines);
        add(BEHIND, !sound && f.tests <= 4 && end == lines + 1);
    }

    /* A visit that was sound is over. */
    void found(const struct sph_ray &ray, const struct sph_found &f) {
        int n = f.inner.count;
        add(NOTHING, !n && !f.leaves);
        add(LEAVES, !n && f.leaves);
        add(BOTH, n && f.leaves);
        if (!n) return;
        add((Outcome)(ONE_INNER + n - 1), true);
        add(IN_ORDER, sph_ray_any(&ray) && n > 1);
        for (int i = 1; i < n && !sph_ray_any(&ray); i++)
            add(TIES, f.inner.list[i].near == f.inner.list[i - 1].near);
    }

    /* Whether each was seen; any: there are rays that any hit ends. */
    bool all(bool any) const {
        bool each = true;
        for (int i = 0; i < OUTCOMES; i++)
            if (!count[i] && (any || i != IN_ORDER)) {
                printf("# outcome %d of visit_rays.h was not seen\n", i);
                each = false;
            }
        return each;
    }

  private:
    uint64_t count[OUTCOMES] = {};
};

} // namespace

#ifndef SHADOW
#define SHADOW 1
#endif
#ifndef FIRST
#define FIRST 1
#endif
#ifndef FACETS
#define FACETS 0
#endif

namespace {

constexpr int32_t WIDE = 0x800000; /* a limit that no ray reaches; its lowest bits are 0 */

/* Drives the inputs of rt_traverse; those of memory are world::Memory's. */
class VisitRays : public bench::Bench<Vrt_traverse> {
  public:
    VisitRays(int argc, char **argv)
        : Bench("tb_traverse", argc, argv, 100000), world(FIRST), nodes(world, random),
          memory(*this, world), limit(world.m.regs[SPH_REG_VISIT_LIMIT]) {
        dut.visits_read_i = dut.next_valid_i = dut.shadow_go_i = dut.flush_i = 0;
        bench::put(dut.ray_i, RT_RAY_VALID, 0);
        memory.spoilt.resize(world::Repeated::ALIKE);
        memory.wanted =
            [this](uint32_t line) { /* a visit that is refused asks for line 0 */
                                    return !line ||
                                           std::any_of(slots, slots + SLOTS, [line](const Slot &s) {
                                               return s.state == Slot::ISSUED && s.line == line;
                                           });
            };
    }

    /* All slots are idle: other registers; another memory, and the cache forgets it. */
    void phase() {
        int32_t *r = world.m.regs;
        dut.flush_i = !cycle || random.percent(50);
        if (dut.flush_i) {
            r[SPH_REG_EFFECTS] = FACETS && random.percent(50) ? 1 << SPH_EFFECT_FACETS : 0;
            nodes.fill(memory.spoilt);
        }
        r[SPH_REG_ROOT] = (int32_t)(random.percent(10) ? nodes.lines() : nodes.some_line());
        r[SPH_REG_VISIT_LIMIT] = random.percent(40)   ? limit
                                 : random.percent(20) ? WIDE
                                 : random.percent(20) ? 0
                                                      : (int32_t)random.below(12);
        world.put_regs(dut.regs_i);
        pace = random.percent(50) ? 100 : (unsigned)random.between(2, 60);
    }

    bool all_idle() const {
        for (const Slot &s : slots)
            if (s.state != Slot::IDLE) return false;
        return true;
    }

    /* Axes across rays, when they are due. */
    void put_axes() {
        bench::put(dut.across_i, RT_ACROSS_VALID, 0);
        if (axes.empty() || axes.front().second > cycle) return;
        int at = axes.front().first;
        axes.pop_front();
        world::put_across(dut.across_i, at, slots[at].ray.across);
    }

  protected:
    static constexpr uint64_t BEHIND = 12; /* clocks from a ray to its axes, at most */
    static constexpr uint64_t START = 5;   /* clocks that its first token waits for them */
    world::World world;
    RandomNodes nodes;
    world::Memory<Vrt_traverse> memory;
    Slot slots[SLOTS];
    int reading = -1; /* whose visits are at visits_o */

    /* A ray for an idle slot; its number, or -1. */
    int launch(bool go_on) {
        int at = (int)random.below(SLOTS);
        Slot &s = slots[at];
        bool go = go_on && s.state == Slot::IDLE && at != reading && random.percent(pace);
        bench::put(dut.ray_i, RT_RAY_VALID, go);
        dut.first_i = random.percent(50);
        dut.pixel_i = random.percent(50);
        if (!go) return -1;
        int kind = !s.begun || random.percent(30) ? SPH_PRIMARY
                   : SHADOW && random.percent(50) ? SPH_SHADOW
                                                  : SPH_REFLECTED;
        if (!s.begun) dut.pixel_i = 1;
        s.starts = kind != SPH_SHADOW && dut.pixel_i;
        if (!s.starts && random.percent(20)) visited(at, (uint32_t)random.below(0xfff000));
        s.ray = world.ray(random, kind);
        s.ray.first = FIRST && dut.first_i;
        s.fresh = s.begun = true;
        s.line = (uint32_t)world.m.regs[SPH_REG_ROOT];
        s.state = kind == SPH_SHADOW ? Slot::HELD : Slot::QUEUED;
        world::put_ray(dut.ray_i, at, s.ray);
        world::put_filter(dut.filter_i, s.ray);
        axes.push_back({at, cycle + BEHIND});
        return at;
    }

    /* A shadow ray that was told before starts; its slot, or -1. */
    int release(int told) {
        int at = (int)random.below(SLOTS);
        dut.shadow_go_i = at != told && slots[at].state == Slot::HELD;
        dut.shadow_slot_i = (uint8_t)at;
        if (!dut.shadow_go_i) return -1;
        slots[at].state = Slot::QUEUED;
        return at;
    }

    /* A ray goes on, or is done; its slot if it goes on, or -1. */
    int send(bool go_on) {
        int at = (int)random.below(SLOTS);
        Slot &s = slots[at];
        dut.next_valid_i = 0;
        if (s.state != Slot::FOUND || at == reading) return -1;
        s.state = Slot::IDLE;
        if (s.kill || !random.percent(go_on ? 90 : 50)) return -1;
        s.state = Slot::QUEUED;
        s.fresh = s.starts = false;
        s.line = nodes.some_line();
        dut.next_valid_i = 1;
        dut.next_slot_i = (uint8_t)at;
        dut.next_line_i = s.line;
        return at;
    }

    /* The slot whose visits are read, one that waits for nothing, or -1. */
    int ask(int told) {
        int at = (int)random.below(SLOTS);
        const Slot &s = slots[at];
        dut.visits_read_i = s.begun && at != told && reading < 0 &&
                            (s.state == Slot::IDLE || s.state == Slot::FOUND);
        dut.visits_slot_i = (uint8_t)at;
        return dut.visits_read_i ? at : -1;
    }

    void show_visit(const Slot &s) const {
        show("line", s.line, SPH_LINE_BITS);
        show("visits of the ray", s.visits, 24);
        show("first", s.ray.first, 1);
        show("depth", s.depth, FW + 1);
        for (int i = 0; i < 3; i++)
            show("org", s.ray.org[i], W), show("dir", s.ray.dir[i], WD);
    }

  private:
    /* As many visits of a slot's pixel as no bench makes. */
    void visited(int slot, uint32_t visits) {
        auto &word = dut.rootp->rt_traverse__DOT__u_visits__DOT__g_free__DOT__mem[slot];
        word = (word & ~(uint64_t)0xffffff) | visits;
        slots[slot].pixel = visits;
    }
    const int32_t limit;
    unsigned pace = 100;
    std::deque<std::pair<int, uint64_t>> axes; /* slot, clock */
};

} // namespace

#endif
