/* tb_counters.cpp - rt_counters against plain sums
 * SPDX-License-Identifier: Apache-2.0
 */
#include <algorithm>

#include "Vrt_counters.h"
#include "bench.h"
#include "machine/layout.h"

namespace {

constexpr int COUNTERS = PLACES < SPH_COUNTERS ? PLACES : SPH_COUNTERS, READ = 32;
constexpr int COMPLETE = PLACES + 3; /* clocks to wait */

/* What a run of clocks adds. */
enum { NONE, ALL_MOST, ONE_EACH, ONE_COUNTER, LAST_CLOCK, AT_RANDOM, HOWS };

struct Run {
    int how, clocks;
    bool clear; /* before the run; otherwise the totals go on */
};

const Run corners[] = {
    {NONE, 20, true},                           /* nothing: all totals are 0 */
    {ALL_MOST, 100, true},                      /* largest sums in every counter */
    {ALL_MOST, 100, false},                     /* totals go on */
    {ONE_EACH, 16, true},                       /* no counter takes another's events */
    {ONE_COUNTER, 50, true},                    /* one alone */
    {LAST_CLOCK, 33, true},                     /* the very last clock counts */
    {LAST_CLOCK, 1, false},                     /* one clock only */
    {ALL_MOST, 10000, true},                    /* carries past 16 bits */
    {ALL_MOST, 9001, false},                    /* other bits of them */
    {AT_RANDOM, 9001, false},  {NONE, 1, true}, /* and clears all of it */
    {ALL_MOST, 4300000, true}, /* carries past 28 bits: only in a run of all vectors */
    {AT_RANDOM, 70000, false}, /* and other bits of those */
    {NONE, 1, true},
};

unsigned events(bench::Random &random, int how, int counter, int left, int only) {
    switch (how) {
    case ALL_MOST:
        return MOST;
    case ONE_EACH:
        return left % COUNTERS == counter ? (unsigned)(counter % MOST + 1) : 0;
    case ONE_COUNTER:
        return counter == only ? (unsigned)random.below(MOST + 1) : 0;
    case LAST_CLOCK:
        return left == 1 ? (unsigned)(MOST - counter % MOST) : 0;
    case AT_RANDOM:
        return random.percent(30) ? (unsigned)random.mixed(6) & MOST : 0;
    default:
        return 0;
    }
}

/* The clocks of a run. */
void count(bench::Bench<Vrt_counters> &b, const Run &r, int only, uint64_t *sums) {
    auto *words = reinterpret_cast<uint32_t *>(&b.dut.add_i);
    for (int left = r.clocks; left > 0; left--) {
        if (r.how != ALL_MOST || left == r.clocks) std::fill(words, words + PLACES / 4, 0);
        for (int c = 0; c < COUNTERS; c++) {
            unsigned n = r.how == ALL_MOST ? MOST : events(b.random, r.how, c, left, only);
            sums[c] += n;
            if (r.how != ALL_MOST || left == r.clocks) words[c / 4] |= n << c % 4 * 8;
        }
        b.tick();
    }
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_counters> b("tb_counters", argc, argv, 5000);
    uint64_t sums[READ] = {}; /* what is no counter stays 0 */
    auto *words = reinterpret_cast<uint32_t *>(&b.dut.add_i);
    auto none = [&] { std::fill(words, words + PLACES / 4, 0); };
    auto idle = [&](int clocks) {
        none();
        for (int i = 0; i < clocks; i++) {
            b.set(b.dut.addr_i, 5, (int)b.random.below(READ));
            b.tick();
        }
    };
    b.dut.clear_i = 0;
    idle(0);
    b.reset(); /* starts the totals anew as clear_i does */
    for (size_t number = 0; b.more(); number++) {
        Run r = {(int)b.random.below(HOWS), (int)b.random.between(1, 60), b.random.percent(40)};
        if (number < sizeof corners / sizeof *corners) r = corners[number];
        if (r.clocks > 10000 && !b.all_vectors) r.clocks = 100;
        int only = (int)b.random.below(COUNTERS);
        if (r.clear) { /* at any turn; also while a sum is not in its total yet; or by rst */
            std::generate(words, words + PLACES / 4, [&] { return (uint32_t)b.random.next(); });
            const bool reset = b.random.percent(50);
            (reset ? b.dut.rst : b.dut.clear_i) = 1;
            for (uint64_t clocks = reset ? 1 + b.random.below(3) : 1; clocks; clocks--)
                b.tick();
            b.dut.rst = b.dut.clear_i = 0;
            for (uint64_t &sum : sums)
                sum = 0;
        }
        count(b, r, only, sums);
        /* sometimes the next run begins before the totals are complete */
        if (number >= sizeof corners / sizeof *corners && b.random.percent(20)) {
            b.done();
            continue;
        }
        idle(COMPLETE - 1);
        int first = (int)b.random.below(READ);
        for (int i = 0; i <= READ; i++) { /* data_o is of the address one clock before */
            b.set(b.dut.addr_i, 5, (first + i) % READ);
            b.tick();
            int c = (first + i) % READ;
            b.expect("data_o", (bench::i128)b.get(b.dut.data_o), (bench::i128)sums[c], 48);
            if (b.bad()) {
                b.show("addr_i", c, 5);
                b.show("kind of run", r.how, 4);
                b.show("clocks", r.clocks, 16);
            }
        }
        b.done();
    }
    return b.finish();
}
