/* tb_rr_arbiter.cpp - rt_rr_arbiter against a search that begins behind the one served last
 * SPDX-License-Identifier: Apache-2.0
 *
 * tb_rr_arbiter [seed] [clocks per phase]
 *
 * Who asks and whether it is served come with different odds in each phase. Checked in every clock:
 * who is in turn and its number. Checked of everybody who asks until he is served: others are
 * served at most N-1 times before him.
 */
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include "Vrt_rr_arbiter.h"
#include "bench.h"
extern "C" {
#include "tests/number.h"
}

/* As the block under test was built (-G); the default is that of rt_rr_arbiter. */
#ifndef N
#define N 4
#endif

namespace {

struct Phase {
    const char *name;
    int asks;   /* percent of clocks in which each of them asks */
    int served; /* percent of these in which the one in turn is served */
};

struct Bench {
    bench::Random random;
    Vrt_rr_arbiter top;
    int last = -1;      /* served last; -1: nobody since reset */
    int passed[N] = {}; /* others served while this one asked */

    explicit Bench(uint64_t seed) : random(seed << 32) {}

    void clock() {
        top.clk = 1;
        top.eval();
        top.clk = 0;
        top.eval();
    }

    void reset() {
        top.rst = 1;
        top.asks_i = (1 << N) - 1;
        top.served_i = 1;
        clock();
        top.rst = 0;
        last = -1;
        std::fill(std::begin(passed), std::end(passed), 0);
    }

    int in_turn(unsigned asks) const {
        for (int i = 1; i <= N; i++)
            if (asks >> (last + i) % N & 1) return (last + i) % N;
        return -1;
    }

    bool waits(unsigned asks, int served);
    bool step(const Phase &phase);
};

/* False when one that still asks was passed over by all others and one of them once more. */
bool Bench::waits(unsigned asks, int served) {
    bool good = true;
    for (int i = 0; i < N; i++) {
        if (!(asks >> i & 1) || i == served)
            passed[i] = 0;
        else if (served >= 0)
            good = ++passed[i] < N && good;
    }
    return good;
}

bool Bench::step(const Phase &phase) {
    unsigned asks = 0;
    for (int i = 0; i < N; i++)
        asks |= random.percent(phase.asks) << i;
    const int turn = in_turn(asks);
    const bool served = turn >= 0 && random.percent(phase.served);
    top.asks_i = asks;
    top.served_i = served;
    top.eval();
    const unsigned expect = turn < 0 ? 0 : 1u << turn;
    const bool good = top.turn_o == expect && top.index_o == (turn < 0 ? 0 : turn) &&
                      waits(asks, served ? turn : -1);
    if (!good)
        printf("# asks %x, served last %d: turn %x number %d, not %d\n", asks, last, top.turn_o,
               top.index_o, turn);
    clock();
    if (served) last = turn;
    return good;
}

} // namespace

int main(int argc, char **argv) {
    const uint64_t seed = test_number(argc > 1 ? argv[1] : nullptr, "argument 1", 1);
    const uint64_t n = test_number(argc > 2 ? argv[2] : nullptr, "argument 2", 5000);
    Bench bench(seed);
    const Phase phases[] = {{"all ask", 100, 100},
                            {"few ask", 20, 90},
                            {"seldom served", 70, 20},
                            {"now and then", 50, 50}};
    bool good = true;
    for (const Phase &phase : phases) {
        bench.reset();
        for (uint64_t c = 0; c < n && good; c++)
            good = bench.step(phase);
        printf("%sok tb_rr_arbiter %s seed %llu: %s, %llu clocks\n", good ? "" : "not ", PROFILE,
               static_cast<unsigned long long>(seed), phase.name,
               static_cast<unsigned long long>(n));
    }
    return good ? 0 : 1;
}
