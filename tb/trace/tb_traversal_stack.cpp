/* tb_traversal_stack.cpp - rt_traversal_stack against the end of the loop in sph_traverse()
 * SPDX-License-Identifier: Apache-2.0
 *
 * Every slot walks an imagined tree: after each node that is issued the bench makes up what its
 * visit found and a depth limit that never rises. Tokens of all slots arrive interleaved. A vector
 * is a token; it leads to one issue or one done, 2 cycles later plus 2 for each pruned group.
 */
#include "Vrt_traversal_stack.h"
#include "bench.h"

namespace {

constexpr uint64_t LATENCY = 4; /* clocks of a pass */
constexpr int STACK = 16;
constexpr int32_t LIMIT = (2 << FW) - 1, NEAR_MIN = -32768, NEAR_MAX = 32767;

struct Group {
    uint32_t base;
    int count;
    int32_t near[4];
    int child[4];
};

/* How a ray's visits look; the first rays take the kinds in turn. */
enum Kind {
    OVERFLOWS,    /* two children each time: 16 pushes fit, the 17th ends the ray */
    JUST_FITS,    /* 16 pushes, then nothing more: the whole stack is walked */
    ALL_PRUNED,   /* 16 pushes, then a limit below all: done without a pass for each */
    SOME_PRUNED,  /* 16 pushes of unlike depth, then a limit that leaves a few deep in the stack */
    ONE_LEFT,     /* 16 pushes, then a limit that leaves only the one pushed first */
    AT_THE_LIMIT, /* near equal to the limit is kept, one more is not */
    EXTREMES,     /* least and largest near, largest limit */
    ZERO_LIMIT,   /* only what reaches the origin or lies behind is kept */
    KILLED,       /* an error ends the ray whatever was found */
    ENDS_WITH_IT, /* a shadow ray or a first-hit ray that has a hit ends */
    HIT_GOES_ON,  /* the same hit of another ray does not end it */
    IN_ORDER,     /* a first-hit ray: every depth is the smallest number, nothing is pruned */
    RANDOM,
    KINDS
};

struct Slot {
    enum { FREE, FOUND, WAITS } state;
    bool fresh;
    Kind kind;
    int visit;
    /* the ray */
    int32_t depth;
    int hit, ends, kill;
    Group found, now, stack[STACK];
    int sp;
    /* what its token must lead to */
    bool issue, overflow;
    uint32_t line;
    uint64_t due;
};

/* Sets what comes out of the token of s, and the slot's new stack. */
void step(Slot &s, uint64_t cycle) {
    int bubbles = 0;
    s.issue = s.overflow = false;
    s.due = cycle + LATENCY;
    if (s.fresh) s.now.count = s.sp = 0;
    s.fresh = false;
    if (s.kill || (ENDS && s.ends && s.hit)) return;
    if (s.found.count && s.found.near[0] <= s.depth) {
        if (s.now.count) {
            if (s.sp == STACK) {
                s.overflow = true;
                return;
            }
            s.stack[s.sp++] = s.now;
        }
        s.now = s.found;
    }
    bool popped = false;
    while (!s.now.count || s.now.near[0] > s.depth) {
        if (!s.sp) return;
        bubbles += popped;
        popped = true;
        s.now = s.stack[--s.sp];
    }
    s.issue = true;
    s.line = s.now.base + (uint32_t)s.now.child[0];
    s.due += LATENCY * (uint64_t)bubbles;
    s.now.count--;
    for (int i = 0; i < s.now.count; i++) {
        s.now.near[i] = s.now.near[i + 1];
        s.now.child[i] = s.now.child[i + 1];
    }
}

/* Makes up what the next visit of s finds. */
void visit(Slot &s, bench::Random &random) {
    int v = s.visit++;
    int32_t range = LIMIT, first = 0;
    if (!v) {
        s.depth = s.kind == RANDOM ? (int32_t)random.mixed(FW + 1) : LIMIT;
        s.hit = s.kill = 0;
        s.ends = s.kind == ENDS_WITH_IT || s.kind == IN_ORDER ||
                 (s.kind == RANDOM && random.percent(30));
    }
    Group &g = s.found;
    g.base = (uint32_t)random.mixed(26);
    if (g.base > (1u << 26) - 4) g.base -= 4;
    g.count = v < STACK + 1 ? 2 : 0;
    switch (s.kind) {
    case OVERFLOWS:
        g.count = 2 + (int)random.below(3);
        break;
    case ALL_PRUNED:
        first = 10;
        if (v > STACK) s.depth = 9;
        break;
    case SOME_PRUNED:
        if (v > STACK) s.depth = LIMIT >> (2 + v - STACK) % FW;
        break;
    case ONE_LEFT:
        first = v ? 10 : range = 2;
        if (v > STACK) s.depth = 9;
        break;
    case AT_THE_LIMIT:
        s.depth = v ? s.depth - (int32_t)random.below(2) : LIMIT;
        g.count = v < 20 ? 1 + v % 4 : 0;
        first = s.depth - 1, range = 3;
        break;
    case EXTREMES:
        g.count = v < 8 ? 4 : 0;
        break;
    case ZERO_LIMIT:
        s.depth = 0;
        first = -2, range = 4;
        break;
    case KILLED:
        s.kill = v == 3;
        break;
    case ENDS_WITH_IT:
    case HIT_GOES_ON:
        s.hit = v >= 3;
        break;
    case IN_ORDER:
        g.count = v < 12 ? (int)random.below(5) : 0;
        s.depth = 0;
        first = NEAR_MIN, range = 1;
        s.hit = random.percent(10);
        break;
    case RANDOM:
        g.count = random.percent(v < 40 ? 70 : 30) ? (int)random.below(5) : 0;
        s.kill = random.percent(1);
        s.hit = s.hit || random.percent(5);
        if (random.percent(20)) s.depth = (int32_t)random.below((uint64_t)s.depth + 1);
        first = random.percent(70) ? 0 : NEAR_MIN;
        range = random.percent(50) ? s.depth + 2 : LIMIT;
        break;
    default:
        break;
    }
    for (int i = 0; i < 4; i++) { /* sorted near ones, each child once */
        int32_t near = first + (int32_t)random.below((uint64_t)range);
        if (near > NEAR_MAX) near = NEAR_MAX;
        if (s.kind == EXTREMES) near = random.percent(50) ? NEAR_MIN : NEAR_MAX;
        int at = i;
        for (; at > 0 && i < g.count && near < g.near[at - 1]; at--)
            g.near[at] = g.near[at - 1];
        g.near[at] = near;
        at = (int)random.below((uint64_t)i + 1);
        g.child[i] = g.child[at];
        g.child[at] = i;
    }
}

bench::i128 pack(const Group &g) {
    bench::u128 list = 0;
    for (int i = 3; i >= 0; i--)
        list = list << 18 | bench::low((bench::u128)g.near[i], 16) << 2 | (unsigned)g.child[i];
    return (bench::i128)list;
}

using Bench = bench::Bench<Vrt_traversal_stack>;

/* Chooses what a visit finds; kinds of rays come in turn first. */
void begin(Bench &b, Slot &slot, int &kinds) {
    Slot *s = &slot;
    if (!s->issue || s->visit > 80) s->fresh = true;
    if (s->fresh) {
        s->kind = kinds < RANDOM         ? (Kind)kinds++
                  : b.random.percent(30) ? (Kind)b.random.below(KINDS)
                                         : RANDOM;
        s->visit = 0;
    }
    visit(*s, b.random);
}

void drive(Bench &b, const Slot &slot, int at, bool write) {
    const Slot *s = &slot;
    b.dut.found_valid_i = write;
    b.dut.found_slot_i = (uint8_t)at;
    b.set(b.dut.found_base_i, 26, s->found.base);
    b.dut.found_count_i = (uint8_t)s->found.count;
    b.set(b.dut.found_list_i, 72, pack(s->found));
    b.dut.found_fresh_i = s->fresh;
    b.dut.found_kill_i = (uint8_t)s->kill;
}

void compare(Bench &b, const Slot &e, int at) {
    b.expect("issue_valid_o", b.dut.issue_valid_o, e.issue, 1);
    b.expect("overflow_o", b.dut.overflow_o, e.overflow, 1);
    if (e.issue) b.expect("issue_line_o", b.get(b.dut.issue_line_o), e.line, 26);
    b.expect("cycle", b.cycle, e.due, 64);
    if (b.bad()) {
        b.show("slot", at, SLOTW);
        b.show("kind", e.kind, 8);
        b.show("visit of the ray", e.visit, 16);
        b.show("depth_i", e.depth, FW + 1);
        b.show("hit_i", e.hit, 1);
        b.show("ends_i", e.ends, 1);
        b.show("found_kill_i", e.kill, 1);
        b.show("found_count_i", e.found.count, 3);
        b.show("found_list_i", pack(e.found), 72);
        b.show("stack before", e.sp, 8);
    }
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_traversal_stack> b("tb_traversal_stack", argc, argv);
    Slot slots[SLOTS] = {};
    int kinds = 0, token = 0, overflows = 0, bubbles = 0;
    for (Slot &s : slots)
        s.fresh = true, s.issue = true;
    b.dut.found_valid_i = b.dut.in_valid_i = 0;
    b.reset();
    while (b.more()) {
        /* what a visit found */
        int at = (int)b.random.below(SLOTS);
        Slot *s = &slots[at];
        bool write = s->state == Slot::FREE && b.random.percent(80);
        if (write) {
            begin(b, *s, kinds);
        }
        drive(b, *s, at, write);
        /* a token */
        if (!b.dut.in_valid_i) {
            token = (int)b.random.below(SLOTS);
            b.dut.in_slot_i = (uint8_t)token;
            b.dut.in_valid_i = slots[token].state == Slot::FOUND;
        }
        b.settle();
        bool taken = b.dut.in_valid_i && b.dut.in_ready_o;
        if (taken) {
            slots[token].state = Slot::WAITS;
            step(slots[token], b.cycle);
        }
        if (write) s->state = Slot::FOUND;
        bool read = b.dut.read_o;
        const Slot &asked = slots[b.dut.slot_o];

        b.tick();
        if (taken) b.dut.in_valid_i = 0;
        b.set(b.dut.depth_i, FW + 1, read ? asked.depth : (int32_t)b.random.bits(FW + 1));
        b.dut.hit_i = (uint8_t)(read ? asked.hit : (int)b.random.below(2));
        b.dut.ends_i = (uint8_t)(read ? asked.ends : (int)b.random.below(2));
        b.settle();
        bubbles += b.dut.bubble_o;
        if (!b.dut.issue_valid_o && !b.dut.done_valid_o) {
            if (b.dut.overflow_o) b.fail("overflow_o without done_valid_o");
            continue;
        }
        if (b.dut.issue_valid_o && b.dut.done_valid_o) b.fail("issue and done at once");
        at = b.dut.issue_valid_o ? b.dut.issue_slot_o : b.dut.done_slot_o;
        Slot &e = slots[at];
        if (e.state != Slot::WAITS) {
            b.fail("a slot without a token");
            continue;
        }
        compare(b, e, at);
        overflows += e.overflow;
        e.state = Slot::FREE;
        b.done();
    }
    if (b.vectors > 50000 && (!overflows || !bubbles)) b.fail("no overflow or no bubble was tried");
    return b.finish();
}
