/* tb_fifo.cpp - rt_fifo against std::deque
 * SPDX-License-Identifier: Apache-2.0
 *
 * tb_fifo [seed] [cycles per phase]
 *
 * Producer and consumer come with different odds in each phase, so that the queue is mostly empty,
 * mostly full, or wraps at every fill; it is never pushed into while it is full (that stops the
 * simulation, by design). Checked in every cycle: order and value of the words, ready exactly when
 * there is room, valid exactly when there is a word, one cycle after the push into an empty queue.
 * A reset in each state empties it.
 */
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <type_traits>
#include "Vrt_fifo.h"
#include "bench.h"
#include "stimulus.h"
extern "C" {
#include "tests/number.h"
}

/* As the queue under test was built (-G); the defaults are those of rt_fifo. */
#ifndef WIDTH
#define WIDTH 8
#endif
#ifndef DEPTH
#define DEPTH 16
#endif

namespace {

static_assert(WIDTH <= 64, "the bench compares words of at most 64 bits");
using Word = std::remove_reference_t<decltype(Vrt_fifo::in_data_i)>;
constexpr uint64_t MASK = WIDTH < 64 ? (1ull << (WIDTH % 64)) - 1 : ~0ull;

struct Phase {
    const char *name;
    int push; /* percent of cycles with a word, when there is room */
    int pop;  /* percent of cycles that take one */
};

struct Bench {
    bench::Random random;
    Vrt_fifo top;
    std::deque<uint64_t> model;
    bench::Stimulus driven;
    bench::Points &states = driven.values(
        "handshake", {"empty, and asked", "full, and asked", "full, and not asked",
                      "one place left, pushed", "pushed and popped", "popped alone of full"});
    bench::Points &resets = driven.values("reset", {"while empty", "while in use", "while full"});

    explicit Bench(uint64_t seed) : random(seed << 32) { reset(); }

    void reset() {
        top.rst = 1;
        top.in_valid_i = 0;
        top.out_ready_i = 0;
        clock();
        clock();
        top.rst = 0;
        model.clear();
    }

    void note(bool room, bool push) {
        const bool word = !model.empty(), asked = top.out_ready_i;
        if (!word && asked) states.value(0);
        if (!room) states.value(asked ? 1 : 2);
        if (push && model.size() == DEPTH - 1) states.value(3);
        if (push && word && asked) states.value(4);
        if (!room && asked) states.value(5);
    }

    void clock() {
        top.clk = 1;
        top.eval();
        top.clk = 0;
        top.eval();
    }

    bool run(const Phase &phase, uint64_t cycles, uint64_t seed);
};

bool Bench::run(const Phase &phase, uint64_t cycles, uint64_t seed) {
    uint64_t words = 0;
    uint64_t full = 0;
    uint64_t empty = 0;
    bool good = true;
    for (uint64_t c = 0; c < cycles && good; c++) {
        bool room = model.size() < DEPTH;
        bool push = room && random.percent(phase.push);
        uint64_t word = random.next() & MASK;
        top.in_valid_i = push;
        top.in_data_i = static_cast<Word>(word);
        top.out_ready_i = random.percent(phase.pop);
        top.eval();
        good = top.in_ready_o == room && top.out_valid_o == !model.empty() &&
               (model.empty() || top.out_data_o == model.front());
        if (!good)
            printf("# cycle %llu of %s: %zu words, ready %d valid %d data %llx\n",
                   static_cast<unsigned long long>(c), phase.name, model.size(), top.in_ready_o,
                   top.out_valid_o, static_cast<unsigned long long>(top.out_data_o));
        note(room, push);
        full += !room;
        empty += model.empty();
        if (!model.empty() && top.out_ready_i) model.pop_front();
        if (push) {
            model.push_back(word);
            words++;
        }
        clock();
        if (Verilated::gotFinish()) good = false;
        if (random.below(200)) continue;
        resets.value(model.empty() ? 0 : model.size() < DEPTH ? 1 : 2);
        reset();
    }
    printf("%sok tb_fifo %s seed %llu: %s, %llu words\n", good ? "" : "not ", PROFILE,
           static_cast<unsigned long long>(seed), phase.name,
           static_cast<unsigned long long>(words));
    printf("# full in %llu cycles, empty in %llu of %llu\n", static_cast<unsigned long long>(full),
           static_cast<unsigned long long>(empty), static_cast<unsigned long long>(cycles));
    return good;
}

} // namespace

int main(int argc, char **argv) {
    const uint64_t seed = test_number(argc > 1 ? argv[1] : nullptr, "argument 1", 1);
    const uint64_t n = test_number(argc > 2 ? argv[2] : nullptr, "argument 2", 20000);
    Bench bench(seed);
    const Phase phases[] = {
        {"mostly empty", 30, 90},      {"mostly full", 90, 30}, {"one in, one out", 100, 100},
        {"fills to the brim", 100, 0}, {"runs dry", 0, 100},    {"wraps", 60, 60},
    };
    bool good = true;
    for (const Phase &phase : phases)
        good = good && bench.run(phase, n, seed);
    return good && (argc > 2 || bench.driven.whole()) ? 0 : 1;
}
