/* tb_prim.cpp - rt_prim, with the units of all kinds inside it, against sph_leaf_visit()
 * SPDX-License-Identifier: Apache-2.0
 *
 * Every slot gets a ray, then records: lines or halves of lines of a machine's memory, leaf records
 * or not, some of them of no kind, some with an error, some clear to rays towards a light. Some
 * rays are as long as they can be, and meet spheres around all that there is. A vector is a result;
 * a slot has up to four tests under way, whose results come in any order. Now and then all of them
 * are of one sphere and a ray that hits it, so that the queue of roots is full: later on there is
 * as much room for them. The default run has to meet every kind with every outcome.
 */
#include "Vrt_prim.h"
#include "engine/results.h"

#ifndef SHADOW
#define SHADOW 1
#endif
#ifndef INSIDE
#define INSIDE 1
#endif
#ifndef FACETS
#define FACETS 0
#endif
#ifndef CLEAR
#define CLEAR 0
#endif

namespace {

enum { NO_KIND = SPH_KINDS, BAD, CLASSES }; /* of a record, above its kind */

struct Slot {
    struct sph_ray ray = {};
    bool begun = false, longest = false; /* longest: as a ray can be */
    std::vector<struct sph_hit> wanted;  /* results that have not come */
};

class Prim : public bench::Bench<Vrt_prim> {
  public:
    Prim(int argc, char **argv) : Bench("tb_prim", argc, argv, 50000), world(0) {
        bool whole = FACETS; /* of no kind: 3 and what no kind has, or any bits */
        for (uint32_t at = 0; at < world.m.lines && whole; at += 7) {
            uint32_t *line = world.m.mem + (size_t)at * SPH_LINE_WORDS;
            sph_field_set(line, SPH_FACET_KIND_LSB, SPH_FACET_KIND_BITS, 3);
            if (at % 2) sph_field_set(line, SPH_FACET_MORE_LSB, SPH_FACET_MORE_BITS, 0);
        }
        dut.in_valid_i = 0;
    }

    /* Nothing is under way: INSIDE, FACETS and CLEAR on or off. */
    void phase() {
        int32_t &effects = world.m.regs[SPH_REG_EFFECTS];
        effects &= ~(1 << SPH_EFFECT_INSIDE | 1 << SPH_EFFECT_FACETS | 1 << SPH_EFFECT_CLEAR);
        if (INSIDE && random.percent(70)) effects |= 1 << SPH_EFFECT_INSIDE;
        if (FACETS && random.percent(80)) effects |= 1 << SPH_EFFECT_FACETS;
        if (CLEAR && random.percent(80)) effects |= 1 << SPH_EFFECT_CLEAR;
        dut.effects_i = (uint32_t)effects;
        for (Slot &s : slots)
            s.begun = false; /* rays carry what the model knows of INSIDE */
        pace = random.percent(50) ? 100 : (unsigned)random.between(2, 60);
        burst = random.percent(30), lucky = false;
        if (++phases_of_room == 50) {
            if (most < ROOM) fail("the tests under way at once became fewer");
            phases_of_room = most = 0;
        }
        for (long &n : seen)
            n = 0;
        counters = {};
    }

    void clock(bool start) {
        if (!dut.in_valid_i && start && random.percent(pace)) offer();
        settle();
        bool taken = dut.in_valid_i && dut.in_ready_o;
        expect("bad_o", dut.bad_o, taken && offered == NO_KIND, 1);
        if (bad()) done();
        if (taken) take();
        most = std::max(most, under_way());
        seen[0] += bench::get(dut.event_o, RT_PRIM_EVENT_LEAF) != 0;
        seen[1] += bench::get(dut.event_o, RT_PRIM_EVENT_FACET) != 0;
        seen[2] += bench::get(dut.event_o, RT_PRIM_EVENT_ROOT) != 0;
        seen[3] += bench::get(dut.event_o, RT_PRIM_EVENT_DIVIDE) != 0;
        if (bench::get(dut.result_o, RT_RESULT_VALID))
            world::take_result(*this, slots, dut.result_o);
        tick();
        if (taken) dut.in_valid_i = 0;
    }

    int under_way() const {
        size_t n = 0;
        for (const Slot &s : slots)
            n += s.wanted.size();
        return (int)n;
    }

    bool all_idle() const {
        for (const Slot &s : slots)
            if (!s.wanted.empty()) return false;
        return !dut.in_valid_i;
    }

    void compare() {
        const int names[4] = {SPH_COUNT_LEAF_TESTS, SPH_COUNT_FACET_TESTS, SPH_COUNT_ROOTS,
                              SPH_COUNT_DIVISIONS};
        for (int i = 0; i < 40; i++)
            clock(false);
        for (int i = 0; i < 4; i++)
            expect("events: leaf, facet, root, divide", seen[i],
                   (bench::i128)counters.count[names[i]]);
        done();
    }

    /* Every kind, and each outcome that it can have. */
    void came() {
        if (CLEAR && all_vectors && !passed) fail("no ray passed a clear primitive");
        for (int c = 0; c < CLASSES && all_vectors; c++)
            for (int hit = 0; hit < 2; hit++) {
                bool can =
                    c == SPH_SPHERE || (FACETS && (c < NO_KIND || !hit)) || (c == BAD && !hit);
                if (can && !met[c][hit]) fail("a kind and outcome that never came");
            }
    }

  private:
    world::World world;
    Slot slots[SLOTS];
    struct sph_counters counters = {};
    long seen[4] = {}, met[CLASSES][2] = {}, passed = 0; /* passed: what is clear, by light */
    enum { ROOM = 12 }; /* tests: in so many phases there are so many at once */
    int most = 0, phases_of_room = 0;
    unsigned pace = 100; /* percent of clocks with a new test */
    uint32_t record[SPH_LINE_WORDS] = {};
    int at = 0, offered = 0;           /* slot and class of the test that is offered */
    bool burst = false, lucky = false; /* a hit is repeated; there is one */
    struct sph_ray hit_ray = {};
    uint32_t hit_record[SPH_LINE_WORDS] = {};

    void offer() {
        at = (int)random.below(SLOTS);
        Slot &s = slots[at];
        if (s.wanted.size() >= 4) return;
        if (s.wanted.empty() && (!s.begun || burst || random.percent(30))) {
            int kind = SHADOW && random.percent(40) ? SPH_SHADOW
                       : random.percent(50)         ? SPH_PRIMARY
                                                    : SPH_REFLECTED;
            s.ray = burst && lucky ? hit_ray : world.ray(random, kind);
            if (!INSIDE) s.ray.skip.inside = 0;
            s.longest = !(burst && lucky) && random.percent(20);
            if (s.longest) lengthen(s.ray);
            s.begun = true;
        }
        int whole = sph_whole(&world.m);
        const uint32_t *words = world.line((uint32_t)random.below(world.m.lines));
        if (!whole && random.percent(50)) words += SPH_LEAF_STRIDE / 32;
        for (int i = 0; i < SPH_LINE_WORDS; i++) /* above half a line: what must not matter */
            record[i] = whole || i < SPH_LEAF_STRIDE / 32 ? words[i] : (uint32_t)random.next();
        if (burst && lucky) std::copy(std::begin(hit_record), std::end(hit_record), record);
        uint32_t kind = sph_record_kind(whole, record);
        if (!kind && !(burst && lucky) && random.percent(s.longest ? 60 : 5)) enlarge();
        bool clear = random.percent(30); /* what a core without CLEAR passes over */
        sph_field_set(record, SPH_LEAF_CLEAR_LSB, !kind, clear);
        if (whole && kind) sph_field_set(record, SPH_FACET_CLEAR_LSB, 1, clear);
        bool error = random.percent(5);
        offered = error ? BAD : kind < SPH_KINDS ? (int)kind : NO_KIND;
        put(s.ray, error);
        dut.in_valid_i = 1;
    }

    void lengthen(struct sph_ray &ray) {
        const int64_t longest = ((int64_t)1 << (WD - 1)) - 1;
        for (int64_t &d : ray.dir) {
            int64_t far = longest - (int64_t)random.bits(WD / 2);
            d = random.percent(50) ? far : -far;
        }
        sph_ray_setup(&world.p, &ray);
    }
    void enlarge() {
        for (int i = 0; i < 3; i++)
            sph_field_set(record, SPH_LEAF_CTR_X_LSB + SPH_LEAF_CTR_X_BITS * i, SPH_LEAF_CTR_X_BITS,
                          (uint32_t)random.sbits(W));
        const uint32_t largest = ((uint32_t)1 << W) - 1;
        sph_field_set(record, SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS,
                      largest - (uint32_t)random.log_bits(W));
    }

    void put(const struct sph_ray &ray, bool error) {
        auto &port = dut.test_i;
        bench::put(port, RT_TEST_SLOT, at);
        bench::put(port, RT_TEST_SHADOW, ray.kind == SPH_SHADOW);
        bench::put(port, RT_TEST_INSIDE, ray.skip.inside);
        bench::put(port, RT_TEST_ERROR, error);
        bench::put(port, RT_TEST_ORG, (bench::i128)world::pack(ray.org, W));
        bench::put(port, RT_TEST_DIR, (bench::i128)world::pack(ray.dir, WD));
        bench::put(port, RT_TEST_A, (bench::i128)ray.a);
        bench::put(port, RT_TEST_SKIP, ray.skip.id);
        bench::put(port, RT_TEST_LIFT, (bench::i128)world::pack(ray.lift, NG + 2));
        for (int i = 0; i < SPH_LINE_WORDS; i++)
            bench::put(port, world::first_bit(RT_TEST_RECORD) + 32 * i, 32, record[i]);
    }

    void take() {
        Slot &s = slots[at];
        uint32_t errors = 0;
        struct sph_ray_query query = sph_ray_query_of(&world.m, &s.ray, &counters, &errors);
        if (offered == BAD)
            counters.count[SPH_COUNT_LEAF_TESTS]++;
        else
            sph_leaf_visit(&query, record);
        struct sph_counters aside = {};
        struct sph_ray_query full = sph_ray_query_of(&world.m, &s.ray, &aside, &errors);
        full.passes = 0;
        if (query.passes && offered < NO_KIND) sph_leaf_visit(&full, record);
        passed += full.best.key && !query.best.key;
        s.wanted.push_back(query.best);
        met[offered][query.best.key != 0]++;
        if (lucky || offered != SPH_SPHERE || query.best.key <= 1) return;
        lucky = true, hit_ray = s.ray; /* with a root */
        std::copy(std::begin(record), std::end(record), hit_record);
    }
};

} // namespace

int main(int argc, char **argv) {
    Prim b(argc, argv);
    b.reset();
    bench::phases(b, 100, 3000, 20000, "a result got lost");
    b.came();
    return b.finish();
}
