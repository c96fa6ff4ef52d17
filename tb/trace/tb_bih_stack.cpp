/* tb_bih_stack.cpp - rt_bih_stack against the rules of sph_bih_walk()
 * SPDX-License-Identifier: Apache-2.0
 *
 * Every slot walks an imagined tree: after each node that is issued the bench makes up what stands
 * there, where the planes cut the ray, what its leaf records find. Tokens of all slots arrive
 * interleaved. A vector is a decision: one of node, leaf records, once more, done.
 * LOOSE records of no node come first; WHOLE: a leaf record has a line. A token that stays away is
 * lost. Leaves of rays that end with a hit are of any size, and slot 0 has one long leaf to its
 * end.
 */
#include <vector>
#include "Vrt_bih_stack.h"
#include "bench.h"
extern "C" {
#include "machine/layout.h"
#include "trace/bih.h"
}

namespace {

enum Kind { INNER, FIT, LEAVE, KILL, START, AGAIN, TESTED, IDLE };
constexpr uint32_t NONE = SPH_BIH_NO_BOUND, ROOT = 0x12345, BASE = 0x2fedcb;
constexpr uint32_t LONG = (1 << 14) + 300; /* records of a leaf; four a pass */
constexpr uint64_t PATIENCE = 4000;        /* clocks until a token is back */

struct Entry {
    uint32_t place;
    sph_interval span;
};

struct Slot {
    Kind kind = IDLE;   /* of the token that is due */
    uint64_t since = 0; /* clock in which it was sent */
    bool sent = false, loose = false, ends = false, hit = false;
    uint32_t limit = NONE, child = 0, first = 0, count = 0; /* of the node */
    sph_interval box = {0, NONE}, span = {0, NONE};
    std::vector<Entry> stack;
    bool endless = false;                         /* its first node is a long leaf */
    bool back = false, near = false, far = false; /* of the pass */
    uint32_t upper = 0, lower = 0;
};

struct Outcome {
    bool valid = false, go = false, leaf = false, again = false, over = false;
    int slot = 0, count = 0, mask = 0;
    uint32_t place = 0, line = 0;
};

bool fits(const Slot &s, const sph_interval &span) {
    return span.lo <= span.hi && span.lo <= s.limit;
}

void visit(Slot &s, Outcome &o, uint32_t place, const sph_interval &span) {
    o.go = true;
    o.place = place;
    s.span = span;
}

void pop(Slot &s, Outcome &o) {
    if (s.stack.empty()) return;
    Entry top = s.stack.back();
    s.stack.pop_back();
    o.again = top.span.lo > s.limit;
    if (!o.again) visit(s, o, top.place, top.span);
}

void root(Slot &s, Outcome &o) {
    if (fits(s, s.box)) visit(s, o, ROOT << 1, s.box);
}

void leaf(Slot &s, Outcome &o) {
    uint32_t odd = WHOLE ? 0 : s.first & 1, n = s.count < 4 - odd ? s.count : 4 - odd;
    o.leaf = true;
    o.count = (int)n;
    o.mask = (int)(((1u << n) - 1) << odd);
    o.line = BASE + (WHOLE ? s.first : s.first / 2);
    s.first += 4 - odd;
    s.count -= n;
}

/* What the token of s leads to. */
Outcome decide(Slot &s) {
    Outcome o;
    o.valid = true;
    sph_interval near = s.span, far = s.span, both = s.span;
    if (s.upper < near.hi) near.hi = s.upper;
    if (s.lower > far.lo) far.lo = s.lower;
    both = {far.lo, near.hi};
    bool near_met = s.near && fits(s, near), far_met = s.far && fits(s, far);
    bool both_met = s.near && s.far && fits(s, both);
    if (s.kind == KILL || (s.ends && s.hit)) return o;
    switch (s.kind) {
    case INNER:
        if (near_met && far_met) {
            o.over = s.stack.size() == DEPTH;
            if (o.over) return o;
            s.stack.push_back({s.child << 1 | !s.back, far});
        }
        if (near_met)
            visit(s, o, s.child << 1 | s.back, near);
        else if (far_met)
            visit(s, o, s.child << 1 | !s.back, far);
        else
            pop(s, o);
        break;
    case FIT:
        if (both_met)
            visit(s, o, s.child << 1, both);
        else
            pop(s, o);
        break;
    case START:
        s.first = 0;
        s.count = LOOSE;
        if (LOOSE)
            leaf(s, o);
        else
            root(s, o);
        break;
    case AGAIN:
        pop(s, o);
        break;
    default: /* LEAVE, TESTED */
        if (s.count) {
            leaf(s, o);
        } else if (s.loose) {
            root(s, o);
            s.loose = false;
        } else {
            pop(s, o);
        }
    }
    return o;
}

uint32_t bound(bench::Random &random) {
    return (uint32_t)(random.percent(50) ? random.below(64) * (NONE / 63) : random.mixed(22));
}

using Bench = bench::Bench<Vrt_bih_stack>;

bool lengthy = false; /* there was the long leaf */

void give_node(Bench &b, const Outcome &now, Slot &seen) {
    if (now.valid && now.go) {
        unsigned what = (unsigned)b.random.below(100);
        seen.kind = what < 60 ? INNER : what < 75 ? FIT : what < 98 ? LEAVE : KILL;
        seen.child = (uint32_t)b.random.bits(26);
        seen.first = (uint32_t)b.random.bits(20);
        seen.count = (uint32_t)(seen.ends ? b.random.log_bits(24) : b.random.below(12));
        if (seen.endless) {
            seen.kind = LEAVE;
            seen.count = LONG;
            seen.endless = false;
            lengthy = true;
        }
        b.dut.node_valid_i = 1;
        b.dut.node_slot_i = (uint8_t)now.slot;
        bench::i128 node = seen.kind == LEAVE ? (bench::i128)seen.count << 24 | seen.first
                                              : (bench::i128)seen.child;
        b.set(b.dut.node_i, 48, node);
    } else if (now.valid) {
        seen.kind = now.leaf ? TESTED : now.again ? AGAIN : IDLE;
    }
}

void send(Bench &b, Slot &s, int at) {
    s.sent = true;
    s.since = b.cycle;
    if (s.kind == TESTED) {
        b.dut.tested_valid_i = 1;
        b.dut.tested_slot_i = (uint8_t)at;
        if (b.random.percent(25)) {
            s.hit = true;
            uint32_t limit = bound(b.random);
            if (limit < s.limit) s.limit = limit;
        }
    } else {
        b.dut.pass_valid_i = 1;
        b.dut.pass_slot_i = (uint8_t)at;
        b.dut.pass_kind_i = (uint8_t)s.kind;
        bool easy = b.random.percent(60); /* meets what it can */
        s.back = b.random.percent(50);
        s.near = easy || b.random.percent(70);
        s.far = easy || b.random.percent(70);
        s.upper = easy ? NONE : bound(b.random);
        s.lower = easy ? 0 : bound(b.random);
    }
}

/* A ray begins: its interval of the global box is there before its token. */
void begin(Bench &b, Slot &s, int at) {
    s = Slot{};
    s.loose = LOOSE != 0;
    s.kind = START;
    s.box = {b.random.percent(50) ? 0 : bound(b.random),
             b.random.percent(50) ? NONE : bound(b.random)};
    s.endless = at == 0 && !lengthy;
    s.ends = !s.endless && b.random.percent(30);
    s.limit = b.random.percent(50) ? NONE : bound(b.random);
    b.dut.box_valid_i = 1;
    b.dut.box_slot_i = (uint8_t)at;
    b.set(b.dut.box_span_i, 44, (bench::i128)((uint64_t)s.box.hi << 22 | s.box.lo));
}

void answer(Bench &b, const Slot &t) {
    b.dut.limit_i = t.limit;
    b.dut.hit_i = t.hit;
    b.dut.ends_i = t.ends;
    b.dut.step_back_i = t.back;
    b.dut.step_near_i = t.near;
    b.dut.step_far_i = t.far;
    b.dut.step_upper_i = t.upper;
    b.dut.step_lower_i = t.lower;
}

void compare(Bench &b, const Outcome &now) {
    b.expect("issue_valid_o", b.dut.issue_valid_o, now.valid && now.go);
    b.expect("leaf_valid_o", b.dut.leaf_valid_o, now.valid && now.leaf);
    b.expect("bubble_o", b.dut.bubble_o, now.valid && now.again);
    b.expect("overflow_o", b.dut.overflow_o, now.valid && now.over);
    b.expect("done_valid_o", b.dut.done_valid_o, now.valid && !now.go && !now.leaf && !now.again);
    if (now.valid) b.expect("slot", b.dut.done_slot_o, now.slot);
    if (now.valid && now.go) b.expect("issue_place_o", b.dut.issue_place_o, now.place);
    if (now.valid && now.leaf) {
        b.expect("leaf_mask_o", b.dut.leaf_mask_o, now.mask);
        b.expect("leaf_count_o", b.dut.leaf_count_o, now.count);
        b.expect("leaf_line_o", b.dut.leaf_line_o, now.line);
    }
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_bih_stack> b("tb_bih_stack", argc, argv, 200000);
    std::vector<Slot> slots(SLOTS);
    /* of the token in stage 1, of that in stage 2, of that whose results are at the outputs */
    Outcome next, after, now;
    long overflows = 0, bubbles = 0;
    b.dut.facets_on_i = WHOLE;
    b.dut.root_i = ROOT;
    b.dut.leaf_base_i = BASE;
    b.dut.n_loose_i = LOOSE;
    b.dut.pass_valid_i = b.dut.tested_valid_i = b.dut.node_valid_i = b.dut.box_valid_i = 0;
    b.reset();
    while (b.more()) {
        b.dut.pass_valid_i = b.dut.tested_valid_i = b.dut.node_valid_i = b.dut.box_valid_i = 0;
        /* the node of the slot whose outcome is at the outputs */
        Slot &seen = slots[(size_t)now.slot];
        give_node(b, now, seen);
        if (now.valid) {
            seen.sent = seen.kind == AGAIN; /* that goes round by itself */
            seen.since = b.cycle;
        }
        now.valid = false;
        /* one token in */
        int at = (int)b.random.below(SLOTS);
        Slot &s = slots[(size_t)at];
        bool written = b.dut.node_valid_i && b.dut.node_slot_i == at; /* the pass comes later */
        if (!s.sent && !written && s.kind == IDLE) {
            begin(b, s, at);
            written = true;
        }
        if (!s.sent && !written && b.random.percent(80)) {
            send(b, s, at);
        }
        if (s.sent && b.cycle - s.since > PATIENCE) b.fail("a token is lost");
        b.settle();
        bool read = b.dut.read_o;
        int slot = b.dut.slot_o;
        b.tick();
        now = after;
        after = next;
        compare(b, now);
        overflows += now.valid && now.over;
        bubbles += now.valid && now.again;
        if (now.valid || b.bad()) b.done();
        /* the token that was read: answered now, decided in the clock after the next */
        next.valid = false;
        if (read) {
            Slot &t = slots[(size_t)slot];
            answer(b, t);
            next = decide(t);
            next.slot = slot;
        }
    }
    if (b.all_vectors && (!overflows || !bubbles)) b.fail("no stack was full, or nothing dropped");
    return b.finish();
}
