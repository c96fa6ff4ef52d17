/* tb_closest_hit.cpp - rt_closest_hit against the rules of keep() and sph_ray_depth(), or with KEYS
 * of sph_bih_time() SPDX-License-Identifier: Apache-2.0
 *
 * Every slot lives through rays of some visits; results of all slots arrive interleaved. Between
 * visits the three read ports ask for any slot. A vector is a token or an answer. What is not
 * elaborated gets inputs all the same. First come the corners, then the pairs of hits of
 * tests/hard: both orders of arrival with both orders of ids. A reset in each state of a slot
 * leaves nothing behind.
 */
#include <algorithm>
#include <vector>

#include "Vrt_closest_hit.h"
#include "bench.h"
#include "hard.h"
#include "stimulus.h"

extern "C" {
#include "trace/bih.h"
#include "core/ray.h"
#include "trace/setup.h"
}

#ifndef KEYS
#define KEYS 0
#endif

namespace {

constexpr uint64_t LATENCY = 4;
constexpr uint64_t KMAX = ((uint64_t)1 << (W + WD + 1)) - 1; /* no key of a hit is longer */
constexpr uint64_t STEP = (uint64_t)1 << (W + WD - 15);      /* 1 of the key's top 17 bits */
constexpr int32_t LIMIT = (2 << FW) - 1;
constexpr uint32_t IDS = 0xffffff;
const struct sph_profile profile = {PROFILE, W, WD, 0, 0, FW, 0};

struct Result {
    uint64_t key;
    uint32_t id;
    int far, hit;
};

struct Ray {
    uint32_t scale; /* u1.15 */
    int shift;      /* -1: depth cannot be bounded */
    int32_t depth;
    int results; /* of its first visit, in this order; 0: random */
    Result result[4];
    hard::Case hard{};
};

const Ray corners[] = {
    {32768, 16, 100, 1, {{1, 0, 0, 1}}},                       /* smallest key */
    {32768, 16, LIMIT, 1, {{KMAX, IDS, 1, 1}}},                /* largest key and id */
    {131071, 0, 5, 1, {{KMAX, 1, 0, 1}}},                      /* largest product: limit */
    {0, 0, LIMIT, 1, {{KMAX, 1, 0, 1}}},                       /* depth 1 */
    {1, 0, LIMIT, 1, {{STEP * (LIMIT - 2) - 1, 1, 0, 1}}},     /* limit - 1: just below */
    {1, 0, 0, 1, {{STEP * (LIMIT - 2), 1, 0, 1}}},             /* reaches the limit */
    {1, 0, 0, 1, {{STEP * (LIMIT - 1), 1, 0, 1}}},             /* one above the limit */
    {1, 0, 0, 2, {{STEP, 1, 0, 1}, {STEP - 1, 2, 0, 1}}},      /* top bits 1, then 0 */
    {32768, -1, 7, 1, {{1, 1, 0, 1}}},                         /* no bound: the limit */
    {32768, 62, 7, 1, {{KMAX, 1, 0, 1}}},                      /* everything shifted out */
    {32768, 16, 7, 1, {{0, 0, 1, 0}}},                         /* miss: first depth stays */
    {32768, 16, 7, 2, {{9, 9, 1, 1}, {1, 1, 0, 0}}},           /* miss cannot win */
    {32768, 16, 7, 2, {{9, 5, 0, 1}, {9, 4, 1, 1}}},           /* tie: smaller id wins */
    {32768, 16, 7, 2, {{9, 4, 1, 1}, {9, 5, 0, 1}}},           /* tie, other order */
    {32768, 16, 7, 2, {{9, 0, 0, 1}, {8, IDS, 1, 1}}},         /* key goes before id */
    {32768, 16, 7, 2, {{KMAX, 0, 0, 1}, {KMAX - 1, 0, 0, 1}}}, /* one apart at the top */
    {32768, 16, 7, 4, {{4, 1, 0, 1}, {3, 1, 0, 1}, {2, 1, 0, 1}, {1, 1, 1, 1}}}, /* all win */
    {32768, 16, 7, 4, {{1, 1, 1, 1}, {2, 1, 0, 1}, {3, 1, 0, 1}, {4, 1, 0, 1}}}, /* first wins */
    {32768, 16, 7, 4, {{0, 1, 0, 0}, {0, 2, 0, 0}, {0, 3, 0, 0}, {0, 4, 0, 0}}}, /* four misses */
};

/* A pair of hits as one visit, four times. */
void add_pair(std::vector<Ray> &directed, const hard::Case &one, const hard::Case &other) {
    for (int order = 0; order < 4; order++) {
        const hard::Case &first = order & 1 ? other : one, &second = order & 1 ? one : other;
        bool lower = order >> 1; /* the first has the lower id */
        Ray ray{};
        ray.scale = one.ray.depth_scale;
        ray.shift = one.ray.depth_shift < 0 ? -1 : one.ray.depth_shift;
        ray.depth = one.ray.depth_max;
        ray.results = 2;
        ray.result[0] = {first.key, lower ? 4u : 5u, first.result.far, 1};
        ray.result[1] = {second.key, lower ? 5u : 4u, second.result.far, 1};
        ray.hard = one;
        directed.push_back(ray);
    }
}

struct Slot {
    enum { IDLE, READY, VISIT, DRAIN } state;
    Ray ray;
    int primary, shadow, first_hit, found, fars, want, sent;
    bool first;  /* no visit yet */
    bool unseen; /* directed, and its hit has not been asked for */
    Result best;
};

int32_t depth(const Slot &s) {
    struct sph_ray ray = {};
    ray.depth_scale = s.ray.scale;
    ray.depth_shift = s.ray.shift;
    struct sph_bih_ray bih = {};
    bih.t_shift = W + WD + 1 > FW ? W + WD + 1 - FW : 0;
    if (KEYS && s.found) return (int32_t)sph_bih_time(&bih, s.best.key);
    return s.found ? sph_ray_depth(&profile, &ray, s.best.key) : SHADOW ? s.ray.depth : LIMIT;
}

Ray random_ray(bench::Random &random) {
    Ray r{};
    r.scale = (uint32_t)(random.percent(20) ? random.mixed(17) : random.between(37000, 65540));
    r.shift = random.percent(80) ? (int)random.below(31 - FW) : (int)random.between(-1, 62);
    r.depth = (int32_t)random.mixed(FW + 1);
    return r;
}

Result random_result(bench::Random &random, const Slot &s) {
    Result r{};
    r.hit = random.percent(70);
    r.far = random.percent(40);
    r.id = (uint32_t)(random.percent(50) ? random.below(4) : random.mixed(24));
    r.key = (uint64_t)(random.percent(50) ? random.log_bits(W + WD + 1) : random.bits(W + WD + 1));
    if (s.found && random.percent(50)) { /* a tie, or close to one */
        r.key = s.best.key + random.below(3) - 1;
        if (random.percent(50)) r.id = s.best.id + (uint32_t)random.below(3) - 1;
        r.id &= IDS;
    }
    if (r.hit && (!r.key || r.key > KMAX)) r.key = 1;
    return r;
}

/* A read port: which slot was asked. */
struct Port {
    bool valid;
    int slot;
};

/* The unit, its slots, and what is on the way. */
class Run {
  public:
    Run(int argc, char **argv) : b("tb_closest_hit", argc, argv, 1200000) {
        if (!hard::alone()) directed.assign(std::begin(corners), std::end(corners));
        hard::Source source(
            b.seed,
            [](const sph_profile &p) { return p.w == W && p.wd == WD && (KEYS || p.fw == FW); },
            [](const hard::Case &) { return true; });
        for (Ray &ray : directed)
            for (Result &r : ray.result)
                r.key = std::min(r.key, KMAX); /* those at the limit of a depth, with KEYS */
        for (hard::Case one, other; source.next_pair(one, other);)
            add_pair(directed, one, other);
        source.report(b);
        if (hard::alone() && directed.empty()) b.fail("the case has no vector for this bench");
        b.dut.want_valid_i = b.dut.new_valid_i = b.dut.in_valid_i = 0;
        b.dut.filter_valid_i = b.dut.next_valid_i = b.dut.done_valid_i = 0;
        b.reset();
        for (int i = 0; i < SLOTS; i++) /* it clears its memories */
            b.tick();
    }

    bool clock() { /* false at the end */
        if (!b.more() || (hard::alone() && seen == directed.size())) return false;
        ask();
        give_result();
        note();
        begin_ray(begin_visit());
        met.clock(b.dut.in_valid_i |
                  (!tokens.empty() && tokens.front().second + LATENCY == b.cycle + 1) << 1 |
                  b.dut.new_valid_i << 2 | b.dut.want_valid_i << 3 |
                  (ports[0].valid && ports[1].valid && ports[2].valid) << 4);
        if (b.dut.want_valid_i) counts.value(b.dut.want_count_i - 1);
        b.tick();
        for (int i = 0; i < 3; i++)
            if (ports[i].valid) answer(i);
        token();
        if (seen == directed.size() && !b.random.below(2000)) reset();
        return true;
    }

    int finish() {
        if (b.all_vectors && seen < directed.size()) b.fail("not all directed rays were driven");
        if (b.all_vectors && !hard::alone() && !driven.whole())
            b.fail("less was driven than its list says");
        return b.finish();
    }

  private:
    bench::Bench<Vrt_closest_hit> b;
    Slot slots[SLOTS] = {};
    std::queue<std::pair<int, uint64_t>> tokens; /* slot, cycle of the last result */
    std::vector<Ray> directed;
    size_t corner = 0, seen = 0;
    Port ports[3];
    Slot asked[3]; /* as the slots were when they were asked for */
    bench::Stimulus driven;
    bench::Points &apart = driven.values("clocks between results of a slot", {"1", "2", "3"});
    bench::Points &met =
        driven.together("a clock", {"a result", "a token", "a new ray", "a visit", "three reads"});
    bench::Points &counts = driven.values("results of a visit", {"1", "2", "3", "4"});
    bench::Points &resets = driven.values(
        "reset", {"with a slot idle", "ready", "in a visit", "with results under way"});
    int before[3] = {-1, -1, -1}; /* slots of results, 1, 2, 3 clocks ago */

    void note() {
        const bool result = b.dut.in_valid_i;
        for (int i = 0; result && i < 3; i++)
            if (before[i] == b.dut.in_slot_i) {
                apart.value(i);
                break;
            }
        before[2] = before[1];
        before[1] = before[0];
        before[0] = result ? b.dut.in_slot_i : -1;
    }

    void reset() {
        for (const Slot &s : slots)
            resets.value(s.state);
        b.dut.want_valid_i = b.dut.new_valid_i = b.dut.in_valid_i = 0;
        b.dut.filter_valid_i = b.dut.next_valid_i = b.dut.done_valid_i = 0;
        b.reset();
        for (int i = 0; i < SLOTS; i++)
            b.tick();
        tokens = {};
        for (Slot &s : slots)
            s = Slot{};
        for (int &slot : before)
            slot = -1;
    }

    int any() { return (int)b.random.below(SLOTS); }

    void show(const Slot &s, int slot) {
        if (!b.bad()) return;
        if (s.unseen) s.ray.hard.show();
        b.show("slot", slot, SLOTW);
        b.show("scale", s.ray.scale, 17);
        b.show("shift", s.ray.shift, 6);
        b.show("first depth", s.ray.depth, FW + 1);
        b.show("found", s.found, 1);
        b.show("best key", (bench::i128)s.best.key, W + WD + 2);
        b.show("best id", s.best.id, 24);
    }

    /* Reads, between the visits of their slot. */
    void ask() {
        for (Port &p : ports) {
            p.slot = any();
            const Slot &s = slots[p.slot];
            p.valid = (s.state == Slot::READY || (s.state == Slot::VISIT && !s.sent)) &&
                      b.random.percent(80);
        }
        b.dut.filter_valid_i = ports[0].valid, b.dut.filter_slot_i = (uint8_t)ports[0].slot;
        b.dut.next_valid_i = ports[1].valid, b.dut.next_slot_i = (uint8_t)ports[1].slot;
        b.dut.done_valid_i = ports[2].valid, b.dut.done_slot_i = (uint8_t)ports[2].slot;
        for (int i = 0; i < 3; i++)
            asked[i] = slots[ports[i].slot];
    }

    void give_result() {
        int at = any();
        Slot *s = &slots[at];
        bool read = false;
        for (Port &p : ports)
            read = read || (p.valid && p.slot == at);
        Result r = random_result(b.random, *s);
        b.dut.in_valid_i = s->state == Slot::VISIT && !read;
        if (b.dut.in_valid_i && s->first && s->ray.results) r = s->ray.result[s->sent];
        b.dut.in_slot_i = (uint8_t)at;
        b.dut.in_hit_i = (uint8_t)r.hit;
        b.dut.in_far_i = (uint8_t)r.far;
        b.set(b.dut.in_id_i, 24, r.id);
        b.set(b.dut.in_key_i, W + WD + 2, (bench::i128)r.key);
        if (!b.dut.in_valid_i) return;
        s->fars += r.hit && r.far;
        if (r.hit &&
            (!s->found || r.key < s->best.key || (r.key == s->best.key && r.id < s->best.id))) {
            s->best = r;
            s->found = 1;
        }
        if (++s->sent == s->want) {
            s->state = Slot::DRAIN;
            tokens.push({at, b.cycle});
        }
    }

    /* One visit begins, or a ray ends; the slot. */
    int begin_visit() {
        int at = any();
        Slot *s = &slots[at];
        bool more = s->first || (!s->unseen && !hard::alone());
        b.dut.want_valid_i = s->state == Slot::READY && more && b.random.percent(80);
        int want = s->first && s->ray.results ? s->ray.results : (int)b.random.between(1, 4);
        b.dut.want_slot_i = (uint8_t)at;
        b.dut.want_count_i = (uint8_t)want;
        if (b.dut.want_valid_i) {
            s->state = Slot::VISIT;
            s->want = want;
            s->sent = 0;
        } else if (s->state == Slot::READY && !s->unseen) {
            s->state = Slot::IDLE;
        }
        return at;
    }

    /* One new ray, of another slot than one. */
    void begin_ray(int other) {
        int fresh = any();
        Slot *s = &slots[fresh];
        Ray ray = random_ray(b.random);
        bool left = corner < directed.size();
        b.dut.new_valid_i = s->state == Slot::IDLE && fresh != other && (left || !hard::alone());
        bool given = b.dut.new_valid_i && left;
        if (given) ray = directed[corner++];
        b.dut.new_slot_i = (uint8_t)fresh;
        b.dut.new_primary_i = (uint8_t)b.random.below(2);
        b.dut.new_shadow_i = (uint8_t)b.random.below(2);
        b.dut.new_first_i = (uint8_t)b.random.below(2);
        b.set(b.dut.new_scale_i, 17, ray.scale);
        b.set(b.dut.new_shift_i, 6, ray.shift);
        b.set(b.dut.new_depth_i, FW + 1, ray.depth);
        if (!b.dut.new_valid_i) return;
        *s = Slot{};
        s->state = Slot::READY;
        s->first = true;
        s->unseen = given;
        s->ray = ray;
        s->primary = b.dut.new_primary_i;
        s->shadow = SHADOW && b.dut.new_shadow_i;
        s->first_hit = FIRST && b.dut.new_first_i;
    }

    /* What read port i says of its slot. */
    void answer(int i) {
        const Slot &e = asked[i];
        if (i == 0) b.expect("filter_depth_o", b.get(b.dut.filter_depth_o), depth(e), FW + 1);
        if (i == 1) {
            b.expect("next_depth_o", b.get(b.dut.next_depth_o), depth(e), FW + 1);
            b.expect("next_found_o", b.dut.next_found_o, e.found, 1);
            b.expect("next_ends_o", b.dut.next_ends_o, e.shadow || e.first_hit, 1);
        }
        if (i == 2) {
            b.expect("done_found_o", b.dut.done_found_o, e.found, 1);
            b.expect("done_shadow_o", b.dut.done_shadow_o, e.shadow, 1);
            b.expect("done_primary_o", b.dut.done_primary_o, e.primary, 1);
            b.expect("done_first_o", b.dut.done_first_o, e.first_hit, 1);
        }
        if (i == 2 && e.found) {
            b.expect("done_far_o", b.dut.done_far_o, INSIDE && e.best.far, 1);
            b.expect("done_fars_o", b.dut.done_fars_o, INSIDE && FIRST ? std::min(e.fars, 2) : 0,
                     2);
            b.expect("done_id_o", b.get(b.dut.done_id_o), e.best.id, 24);
            b.expect("done_key_o", b.get(b.dut.done_key_o), (bench::i128)e.best.key, W + WD + 2);
        }
        show(e, ports[i].slot);
        b.done();
        if (i == 2 && !e.first && e.unseen) {
            slots[ports[i].slot].unseen = false;
            seen++;
        }
    }

    /* The token of a visit whose last result came LATENCY clocks ago, and no other. */
    void token() {
        bool due = !tokens.empty() && tokens.front().second + LATENCY == b.cycle;
        b.expect("out_valid_o", b.dut.out_valid_o, due, 1);
        if (due) {
            int at = tokens.front().first;
            tokens.pop();
            if (b.dut.out_valid_o) b.expect("out_slot_o", b.dut.out_slot_o, at, SLOTW);
            show(slots[at], at);
            slots[at].state = Slot::READY;
            slots[at].first = false;
            b.done();
        } else if (b.bad()) {
            b.done(); /* a token that nothing asked for */
        }
    }
};

} // namespace

int main(int argc, char **argv) {
    Run run(argc, argv);
    while (run.clock())
        ;
    return run.finish();
}
